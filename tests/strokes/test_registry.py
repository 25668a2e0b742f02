"""Diagrams are found by themselves: a further one is one further file."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import vad
from vad.strokes.diagrams import DIAGRAMS
from vad.words import Language, languages

PACKAGE = Path(vad.__file__).parent

#: A velocity polygon turned by 90°, as old books draw it: parallel to the links, not across them.
TURNED = '''
"""The velocity polygon turned by 90°: its vectors are parallel to the links."""

from dataclasses import replace

from vad.strokes.diagram import Diagram, Drawing, in_plane
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
    "turned-velocity",
    "Turned velocity",
    1.5,
    "vectors",
    lambda s: s.rate_unit(1),
    pose,
    applies=in_plane,
)
'''

#: A panel in the plane and in space, with a row of its own in the table.
FORCE = '''
"""A load and what carries it, which does not apply to the Scotch yoke."""

from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.sheet import POLE, Arrow, Cell, Dot, Stroke, StrokePart


def pose(scene):
    strokes = (
        Stroke("pole", "o", Dot(0j), "We choose a pole.", part=POLE),
        Stroke(
            "known",
            "F",
            Arrow(0j, 80 - 20j, "o", "l"),
            "The load.",
            scene.output,
            "load",
            reveals=(scene.output,),
            part=StrokePart("ol", "load"),
        ),
    )
    return Drawing(strokes)


def cells(scene, key, slides):
    return (Cell("F", 82.46, "N"),) if key == scene.output else ()


DIAGRAM = Diagram(
    "force",
    "Forces",
    3,
    "vectors",
    lambda scene: "N",
    pose,
    cells,
    applies=lambda motion: motion.mechanism.name != "scotch-yoke",
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


FOUR = """
import json, sys, vad
from vad.cli.run import run
from vad.gui.answers import pose
from vad.gui.messages import PoseQuestion

panels, pages, turns = {}, *(words.split(",") for words in sys.argv[1:])
for name in ("four-bar", "scotch-yoke", "rssr"):
    mechanism = vad.MECHANISMS[name]()
    sheet = vad.draw(vad.solve(mechanism))
    panels[name] = [panel.name for panel in sheet.panels]
    vad.save(sheet, name + ".json")
    assert vad.sheet_from_json(name + ".json") == sheet
    vad.save(sheet, name + ".svg")
    if name in pages:
        vad.save(vad.animate(sheet), name + ".html")
    if name in turns:
        vad.save(vad.turn(mechanism), name + "-turn.svg")
    drawn = pose(PoseQuestion.of(mechanism, {}))["panels"]
    assert [each[0] for each in drawn] == panels[name]
    assert run(["sweep", name, "--steps", "5", "-o", name + ".csv"]) == 0
assert run(["list"]) == 0 and run(["draw", "--help"]) == 0
assert run(["draw", "scotch-yoke", "--panels", "force", "-o", "none.svg"]) == 2
print(json.dumps(panels))
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
    usual = [diagram for diagram in DIAGRAMS.values() if diagram.usual]
    assert titles == [Language(code).name(diagram.title) for diagram in usual]
    assert code == "en" or "Velocity" not in titles


def tried(folder: Path, name: str, file: str, trial: str, *words: str) -> tuple[Any, str]:
    """Return what a trial says of the program with one file more, and its errors."""
    shutil.copytree(PACKAGE, folder / "vad")  # with what is compiled, which takes seconds
    (folder / "vad" / "strokes" / "diagrams" / name).write_text(file, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", trial, *words],
        cwd=folder,
        capture_output=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(folder), "PYTHONUTF8": "1"},
    )
    return json.loads(done.stdout.splitlines()[-1]), done.stderr.decode()


def test_a_further_diagram_is_one_further_file(tmp_path: Path) -> None:
    said, _ = tried(tmp_path, "turned.py", TURNED, TRIAL)
    names = ["position", "velocity", "turned-velocity", "acceleration"]
    assert said["panels"] == said["lesson"] == names
    assert said["titles"] == ["Lage", "Geschwindigkeit", "Turned velocity", "Beschleunigung"]
    assert said["turn"] == ["velocity", "turned-velocity"]
    assert said["json"] == ["turned-velocity"]


def test_a_kind_of_picture_that_no_painter_knows() -> None:
    with pytest.raises(
        vad.UsageError, match="diagram 'force': unknown picture 'mechanism'"
    ) as error:
        replace(DIAGRAMS["velocity"], name="force", picture="mechanism")
    assert error.value.hint == "known: skeleton, vectors, views"


def test_a_diagram_is_drawn_where_it_applies_in_the_plane_and_in_space(
    tmp_path: Path, exhaustive: bool
) -> None:
    """Usually there is a turn in the plane and a page in space."""
    pages, turns = ("four-bar,rssr",) * 2 if exhaustive else ("rssr", "four-bar")
    said, errors = tried(tmp_path, "force.py", FORCE, FOUR, pages, turns)
    usual = ["position", "velocity", "acceleration"]
    drawn = [*usual, "force"]
    assert said == {"four-bar": drawn, "scotch-yoke": usual, "rssr": drawn}
    message, hint = errors.strip().splitlines()[-2:]
    assert message == "error: panel 'force' does not apply to scotch-yoke"
    assert (
        hint
        == "hint: known for scotch-yoke: position, centres, turned, velocity, acceleration, drive"
    )
