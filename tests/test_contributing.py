"""What CONTRIBUTING shows as a whole file is one: the program finds it and works with it."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from textwrap import dedent

import pytest

ROOT = Path(__file__).parents[1]
TRIAL = """
import vad
from vad.cli.run import run

motion = vad.solve(vad.SineYoke(crank=40), angle=30)
usual = vad.solve(vad.ScotchYoke(crank=40), angle=30)
assert motion.point("C").acceleration == usual.point("C").acceleration
sheet = vad.draw(motion)
assert [panel.name for panel in sheet.panels][-2:] == ["acceleration", "one-load"]
vad.save(vad.animate(sheet), "page.html")
assert run(["draw", "sine-yoke", "--panels", "one-load", "-o", "load.svg"]) == 0
"""


@pytest.fixture(scope="module")
def files() -> dict[str, str]:
    """Return the indented blocks that begin with a docstring, by the class or constant in them."""
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    blocks = re.findall(r'^    """(?:.*\n(?:(?=    )|\n(?=\n*    )))*.*\n', text, re.MULTILINE)
    found = {re.search(r"class (\w+)|(DIAGRAM) =", each)[0]: dedent(each) for each in blocks}
    assert list(found) == ["class ScotchYoke", "DIAGRAM ="]
    return found


def test_a_mechanism_and_a_diagram_that_are_copied_from_it(files: dict[str, str], tmp_path: Path):
    shutil.copytree(ROOT / "vad", tmp_path / "vad")
    mechanism = files["class ScotchYoke"]
    mechanism = mechanism.replace("ScotchYoke", "SineYoke").replace("scotch-yoke", "sine-yoke")
    (tmp_path / "vad" / "mechanisms" / "sine_yoke.py").write_text(mechanism, "utf-8")
    diagram = tmp_path / "vad" / "strokes" / "diagrams" / "one_load.py"
    diagram.write_text(files["DIAGRAM ="], "utf-8")
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", TRIAL],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr
