"""Forces that are drawn once with traced numbers are those of every other pose, too."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import vad
from tests.strokes.test_traced_sheet import numbers, poses
from vad.errors import VadError
from vad.files.examples import example_path
from vad.lecture.poles import hand_poles
from vad.statics.burden import Burden
from vad.strokes.draw import chosen, parted, scene_of, sheet_of, with_forces
from vad.strokes.sheet import Arrow, Sheet
from vad.strokes.traced_sheet import traced_sheet
from vad.words import Language


def example(name: str) -> Any:
    return vad.load(example_path(name))()


INERTIA = {"mass": 2.0, "inertia": 0.01}
MACHINES: dict[str, tuple[Any, Burden]] = {
    "four-bar": (vad.FourBar(), Burden(({"at": "C", "on": "rocker", "force": 80, "angle": 150},))),
    "slider-crank": (
        vad.SliderCrank(),
        Burden(({"at": "C", "force": 800, "angle": 180},), {"slider": 0.5, "rod": INERTIA}),
    ),
    "shaper": (
        vad.CrankSlottedLever(rod=100, ram_height=180),
        Burden(({"at": "E", "force": 500, "angle": 180},), {"lever": INERTIA}, 9.81),
    ),
    "whitworth": (vad.Whitworth(), Burden(({"on": "lever", "couple": 6.0},))),
    "gate": (vad.GateActuator(), Burden(({"at": "B", "on": "arm", "force": 90, "angle": 250},))),
    "toggle-press": (
        example("toggle-press"),
        Burden(({"at": "D", "force": 1000, "angle": 180},), {"rod": INERTIA}),
    ),
    "watt-1": (
        example("watt-1"),
        Burden(({"at": "G", "on": "link", "force": 50, "angle": 20},), {"arm": INERTIA}),
    ),
}
#: What is drawn in every pose; the parts of a vector are not, nor are tools.
PANELS = ("force", "drive")
WHOLE = ("whole", "load", "action", "bar")
CLOSE = 1e-9


def drawn(sheet: Sheet) -> dict[Any, float]:
    """Return the numbers of force polygons, of the driven body alone, and of the table."""
    names = {
        (panel.name, stroke.name)
        for panel in sheet.panels
        for stroke in (*panel.strokes, *panel.zeros)
        if panel.name in PANELS and isinstance(stroke.shape, Arrow) and stroke.part.which in WHOLE
    }
    return {key: x for key, x in numbers(sheet) if key[:2] in names or key[0] == "row"}


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("name", MACHINES)
def test_forces_of_one_pose_drawn_with_traced_numbers_are_those_of_every_pose(name: str):
    machine, burden = MACHINES[name]
    first, *others = poses(machine, 1)
    poles = hand_poles(machine, burden)
    traced = traced_sheet(machine, first, burden=burden, held=poles.traced)
    found = drawn(traced.sheet)
    program = traced.program(found.values())
    given = [np.array([pose[key] for pose in others]) for key in first]
    table = dict(zip(found, program.many(given, len(others)), strict=True))
    seen = 0
    for number, pose in enumerate(others):
        try:
            motion, forces = parted(with_forces(vad.solve(machine, **pose), burden))
            scene = scene_of(motion, Language("en"), forces, **poles.traced(pose))
            wanted = drawn(sheet_of(scene, chosen(None, motion, forces)))
        except VadError:
            continue
        largest: dict[Any, float] = {}
        for key, value in wanted.items():
            kind = key[0] if key[0] in PANELS else key[2:3]
            largest[kind] = max(largest.get(kind, 1.0), abs(value))
        for key, value in wanted.items():
            if key not in table:
                continue
            seen += 1
            kind = key[0] if key[0] in PANELS else key[2:3]
            assert abs(table[key][number] - value) <= CLOSE * largest[kind], (key, pose)
    assert seen > 10 * len(others)


@pytest.mark.parametrize("name", ["four-bar", "gate"])
def test_under_a_hand_an_arrow_on_the_driven_body_is_as_long_as_its_force_is_large(name: str):
    machine, burden = MACHINES[name]
    poles, found = hand_poles(machine, burden), []
    place = next(iter(machine.inputs))
    for share in (0.9, 1.0, 1.05):
        motion = vad.solve(machine, **{place: share * machine.inputs[place]})
        _, forces = parted(with_forces(motion, burden))
        held = poles.traced(dict(motion.inputs))
        scene = scene_of(motion, Language("en"), forces, **held)
        strokes = sheet_of(scene, ("drive",)).panel("drive").strokes
        arrow = next(s.shape for s in strokes if s.component == "action" and s.label[0] == "F")
        on = [each for each in scene.force_names.on_driver if abs(each.force) > 0.0]
        found.append(abs(arrow.end - arrow.start) / abs(on[0].force))
    assert found == pytest.approx([found[0]] * 3, rel=1e-9)
