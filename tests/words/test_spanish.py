"""A language in ten phrases: one file here, or a module of another package.

Its code is no language's, so that Spanish may be added to the program.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import vad
from tests.packages import ROOT, install
from tests.page.lessons import bundle_of

SPANISH = '''
"""Lo que dice el profesor."""

PHRASES = {
    "results": "Resultados",
    "crossing": "{letter} está donde se cortan las dos rectas.",
    "fixed": "{letter} es un pivote fijo.",
    "driven bar": "{link:El} {bar} = {size} {unit} forma un ángulo de {angle}° con el eje *x*.",
    "pole velocity": "El polo: los puntos fijos no tienen velocidad, así que {letters} están aquí.",
    "and": "{first} y {last}",
    "velocity of": "la velocidad de {head}",
    "parallel": "∥ {line}",
    "hooke shafts": "Los ejes 2 y 4 se cortan en *O* a {angle}°.",
    "hooke along": "vista según el eje 2",
}
NAMES = {"Four-bar": "Cuadrilátero articulado", "Velocity": "Velocidad", "crank": "manivela"}
GENDERS = {"crank": "f"}
ARTICLES = {"f": {"el": "la {}"}}
POINT = ","
PLAYER = {"play": "Reproducir"}
'''

TRIAL = """
import json, vad
from vad.cli.run import run

PANEL = "--panels", "velocity"
assert run(["draw", "four-bar", "--language", "xx", "-o", "plane.json"]) == 0
assert run(["draw", "hooke-joint", "--language", "xx", "-o", "space.json"]) == 0
assert run(["draw", "hooke-joint", "--language", "xx", "-o", "space.svg"]) == 0
assert run(["animate", "scotch-yoke", "--language", "xx", "-o", "page.html"]) == 0
assert run(["draw", "scotch-yoke", "--turn", *PANEL, "--language", "xx", "-o", "turn.svg"]) == 0
english = vad.sheet_from_json("plane.json", language="en")
spanish = vad.sheet_from_json("plane.json")
assert english == vad.draw(vad.solve(vad.FourBar()))
print(json.dumps([s.caption for panel in spanish.panels for s in panel.strokes]))
"""


def tried(home: Path, path: list[Path]) -> list[str]:
    """Draw in the plane, in space and a page, in a process that knows Spanish."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", TRIAL],
        capture_output=True,
        text=True,
        cwd=home,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, path))},
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    captions: list[str] = json.loads(done.stdout)
    return captions


@pytest.fixture(params=["a file in vad/words", "a package of its own"])
def captions(request: pytest.FixtureRequest, tmp_path: Path) -> list[str]:
    if request.param == "a file in vad/words":
        package = tmp_path / "vad"
        shutil.copytree(Path(vad.__file__).parent, package)
        (package / "words" / "xx.py").write_text(SPANISH, "utf-8")
        return tried(tmp_path, [tmp_path])
    install(tmp_path, "vad_spanish", {"xx": SPANISH}, "[vad.languages]\nxx = vad_spanish.xx\n")
    return tried(tmp_path, [ROOT, tmp_path])


def test_ten_phrases_are_a_language(captions: list[str], tmp_path: Path) -> None:
    """What they do not say is said in English, whole sentences of it."""
    assert "A es un pivote fijo." in captions
    assert "La manivela AB = 40 mm forma un ángulo de 60° con el eje x." in captions
    assert "c está donde se cortan las dos rectas." in captions
    assert "El polo: los puntos fijos no tienen velocidad, así que a y d están aquí." in captions
    assert "Angles are measured counter-clockwise from x." in captions
    space = json.loads((tmp_path / "space.json").read_text("utf-8"))
    views = space["panels"]["position"]
    assert "Los ejes 2 y 4 se cortan en O a 30°." in [each["caption"] for each in views["strokes"]]
    assert [note["text"] for note in views["notes"]] == [
        "vista según el eje 2",
        "plane of the shafts",
    ]
    plane = json.loads((tmp_path / "plane.json").read_text("utf-8"))
    assert plane["title"] == "Cuadrilátero articulado" and plane["notation"]["point"] == ","
    assert [panel["title"] for panel in plane["panels"].values()] == [
        "Position",
        "Velocidad",
        "Acceleration",
    ]
    page = (tmp_path / "page.html").read_text("utf-8")
    parts = "".join(bundle_of(page)[4])
    assert 'lang="xx"' in page and "Reproducir" in parts and "Full screen" in parts
    assert "Resultados" in page
