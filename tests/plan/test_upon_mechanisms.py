"""Labels of centres, of Klein's construction and of turned velocities: nothing lies on another."""

from __future__ import annotations

import itertools

import pytest

import vad
from tests.plan.overlaps import KEY, overlaps, planned
from tests.plan.test_table import ink_box
from tests.statics.machines import MACHINES
from tests.statics.test_equilibrium import pose
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.items import Level, in_painting_order
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.problem_sheet import blank_panels, problem
from vad.strokes.diagrams import DIAGRAMS

WIDE, NARROW = (1280, 720), (1024, 768)
SHARES = 0.31, 0.62


def sheets(name, panels):
    """Yield two poses of a machine with panels, none if they do not apply."""
    machine = MACHINES[name]()
    rate = list(machine.inputs)[1]
    for share in SHARES:
        motion = pose(machine, share)
        if all(DIAGRAMS[panel].applies(motion) for panel in panels):
            place = dict(itertools.islice(motion.inputs.items(), 1))
            given = {rate: machine.inputs[rate] or 1.0}
            yield vad.draw(vad.solve(machine, **place, **given), panels)


@pytest.mark.exhaustive(192)
@pytest.mark.parametrize("panel", ["centres", "klein", "turned"])
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_no_label_lies_on_anything(name, panel):
    for sheet in sheets(name, (panel,)):
        for size, lesson in itertools.product((WIDE, NARROW), (False, True)):
            assert overlaps(sheet, size, lesson) == []


@pytest.mark.exhaustive(64)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_neither_does_one_beside_velocities(name):
    for panels in (("centres", "velocity"), ("klein", "velocity", "acceleration")):
        for sheet in sheets(name, panels):
            assert overlaps(sheet, WIDE) == []
            assert overlaps(sheet, NARROW) == []


@pytest.mark.exhaustive(32)
@pytest.mark.parametrize("name", sorted(MACHINES))
def test_no_two_rows_of_the_results_lie_on_one_another(name):
    both = [*sheets(name, ("centres",)), *sheets(name, ("klein",))]
    for sheet, size in itertools.product(both, (WIDE, NARROW)):
        board = planned(sheet, size)
        texts = [
            mark.shape
            for item in board.shown(board.finished)
            if item.region == "results"
            for mark in item.marks
            if isinstance(mark.shape, Lettering)
        ]
        for one, other in itertools.combinations(map(ink_box, texts), 2):
            aside = one[2] < other[0] or other[2] < one[0]
            assert aside or one[3] < other[1] or other[3] < one[1]


def test_a_problem_keeps_the_letters_of_the_mechanism():
    sheet = vad.draw(vad.solve(vad.SliderCrank()), "turned")
    key = planned(sheet)
    shown = problem(key, blank_panels(sheet, "turned"), KEY)
    letters = [
        plain(mark.shape.runs)
        for item in shown.items
        if item.region == "turned" and item.level == Level.LABEL
        for mark in item.marks
        if isinstance(mark.shape, Lettering)
    ]
    assert {"B", "C", "D"} <= set(letters)
    assert not {"b", "c", "B, b"} & set(letters)


def test_a_load_along_a_bar_is_painted_above_it() -> None:
    load = {"name": "P", "at": "C", "force": 500.0, "angle": 0.0}
    sheet = vad.draw(vad.forces(vad.solve(vad.SliderCrank(), angle=0.0), [load]))
    board = plan(sheet, screen(WIDE), 0.058)
    shown = [item for item in board.shown(board.finished) if item.region == "position"]
    order = [item.stroke for item in in_painting_order(shown, ["position"])]
    assert order.index("position:P.load") > order.index("position:BC.bar")
