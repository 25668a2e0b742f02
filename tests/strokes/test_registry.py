"""Diagrams are found by themselves: a further one is one further file."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import vad
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.language import Language, languages

PACKAGE = Path(vad.__file__).parent

#: A velocity polygon turned by 90°, as old books draw it: parallel to the links, not across them.
TURNED = '''
"""The velocity polygon turned by 90°: its vectors are parallel to the links."""

from dataclasses import replace

from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.polygon import polygon
from vad.strokes.scene import Scene
from vad.strokes.sheet import Arrow, Dot


def pose(scene: Scene) -> Drawing:
    """Return the vectors of the velocity polygon, turned."""
    strokes = []
    for stroke in polygon(scene, order=1).strokes:
        match stroke.shape:
            case Arrow(start, end, tail, head):
                strokes.append(replace(stroke, shape=Arrow(1j * start, 1j * end, tail, head)))
            case Dot(at):
                strokes.append(replace(stroke, shape=Dot(1j * at)))
    return Drawing(tuple(strokes))


DIAGRAM = Diagram(
    "turned-velocity", "Turned velocity", 1.5, "vectors", lambda s: s.rate_unit(1), pose
)
'''

TRIAL = """
import json, sys, vad
from vad.cli.run import run

motion = vad.solve(vad.FourBar())
sheet = vad.draw(motion, language="de")
lesson = vad.animate(sheet)
turn = vad.turn(motion, panels=("turned-velocity", "velocity"))
ends = [panel.strokes[-1].shape.end for panel in sheet.panels[1:3]]
assert ends[1] == 1j * ends[0]
assert vad.still(lesson, "turned-velocity:2").drawn.panels[-1].name == "turned-velocity"
assert run(["draw", "four-bar", "--panels", "turned-velocity", "-o", "one.json"]) == 0
print(json.dumps({
    "panels": [panel.name for panel in sheet.panels],
    "titles": [panel.title for panel in sheet.panels],
    "lesson": list(dict.fromkeys(step.panel.name for step in lesson.steps)),
    "turn": [panel.name for panel in turn.at(0.3).panels],
    "json": list(json.load(open("one.json"))["panels"]),
}))
"""


def test_every_file_is_a_diagram_in_the_order_of_its_rank() -> None:
    files = {path.stem for path in (PACKAGE / "strokes" / "diagrams").glob("[!_]*.py")}
    assert {name.replace("-", "_") for name in DIAGRAMS} == files
    ranks = [diagram.rank for diagram in DIAGRAMS.values()]
    assert ranks == sorted(set(ranks))
    usual = [name for name, diagram in DIAGRAMS.items() if diagram.usual]
    assert usual == ["position", "velocity", "acceleration"]


def test_a_panel_says_what_it_is() -> None:
    sheet = vad.draw(vad.solve(vad.GateActuator()))
    said = [(panel.name, panel.title, panel.unit, panel.picture) for panel in sheet.panels]
    assert said == [
        ("position", "Position", "ft", "skeleton"),
        ("velocity", "Velocity", "ft/s", "vectors"),
        ("acceleration", "Acceleration", "ft/s²", "vectors"),
    ]


@pytest.mark.parametrize("code", languages())
def test_titles_are_in_the_language_of_the_sheet(code: str) -> None:
    sheet = vad.draw(vad.solve(vad.FourBar()), language=code)
    titles = [panel.title for panel in sheet.panels]
    assert titles == [Language(code).name(diagram.title) for diagram in DIAGRAMS.values()]
    assert code == "en" or "Velocity" not in titles


def test_a_further_diagram_is_one_further_file(tmp_path: Path) -> None:
    shutil.copytree(PACKAGE, tmp_path / "vad", ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "vad" / "strokes" / "diagrams" / "turned.py").write_text(TURNED, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", TRIAL],
        cwd=tmp_path,
        capture_output=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONUTF8": "1"},
    )
    said = json.loads(done.stdout)
    names = ["position", "velocity", "turned-velocity", "acceleration"]
    assert said["panels"] == said["lesson"] == names
    assert said["titles"] == ["Lage", "Geschwindigkeit", "Turned velocity", "Beschleunigung"]
    assert said["turn"] == ["velocity", "turned-velocity"]
    assert said["json"] == ["turned-velocity"]
