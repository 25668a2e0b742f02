"""Letters of stills: each is read, and seen to be that of its point or line."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

import vad
from tests.plan.overlaps import planned
from tests.plan.seen_letters import Fault, faults
from tests.plan.test_overlaps import RAMS, turn
from vad.files.examples import example_names, example_path
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import Placed, Wish, assigned, place
from vad.plan.lens import BAND, Lens
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.pictures.vectors import place_vectors

PAGE = Rect(0.0, 0.0, 1.0, 1.0)
#: What is left in crowded panels, by the number of letters in one still at most.
LEFT = {
    "between two": 5,
    "leader passes another": 6,
    "leader ends at another": 1,
    "long leader": 6,
    "nearer to another line": 2,
    "on a leader": 1,
}
#: In these the arrowhead of a rate touches the value of an angle, or a letter, in some poses.
TOUCHED = {
    *("beam-engine", "jansen-leg", "leg-from-coordinates", "peaucellier", "shaper"),
    *("stephenson-1", "watt-1", "watt-2", "whitworth-ram"),
}


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("step", range(12))
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_letters_are_read_and_name_their_own_points(name: str, step: int):
    mechanism = (vad.MECHANISMS.get(name) or vad.load(example_path(name)))(**RAMS.get(name, {}))
    for sheet in turn(mechanism, steps=12, some=[step]):
        found = list(faults(planned(sheet)))
        for kind in {fault.kind for fault in found}:
            these = [fault for fault in found if fault.kind == kind]
            least = 1 if kind == "on a stroke" and name in TOUCHED else 0
            assert len(these) <= LEFT.get(kind, least), these


def misplaced(board: Plan, text: str, at: complex) -> list[Fault]:
    """Return the faults of a board on which a letter of its velocity polygon stands elsewhere."""
    items = []
    for each in board.items:
        item = each
        if item.region == "velocity" and item.until == FOREVER:
            marks = []
            for mark in item.marks:
                shape = mark.shape
                if isinstance(shape, Lettering) and plain(shape.runs) == text:
                    shape = replace(shape, at=at)
                marks.append(replace(mark, shape=shape))
            item = replace(each, marks=tuple(marks))
        items.append(item)
    return list(faults(replace(board, items=tuple(items))))


def test_the_measure_sees_a_letter_in_a_wrong_place():
    board = planned(vad.draw(vad.solve(vad.FourBar(), angle=60)))
    assert not list(faults(board))
    sketch = board.sketches["velocity"]
    spots = {vertex.label: vertex.at for vertex in sketch.vertices}
    pole, b, c = spots["a, d"], spots["b"], spots["c"]
    room = board.regions["velocity"]

    def kinds(at: complex) -> set[str]:
        return {fault.kind for fault in misplaced(board, "b", at)}

    assert "on a stroke" in kinds((pole + b) / 2)
    assert "nearer to another" in kinds(c + 0.02)
    assert "far without leader" in kinds(b + 0.1 * (b - pole) / abs(b - pole) + 0.02j)
    assert "off its panel" in kinds(complex(room.right - 0.005, b.imag))
    [other] = [tag.box for tag in sketch.tags if tag.text == "c"]
    assert "on another" in kinds(complex(other.left, other.bottom))


def test_a_letter_takes_the_place_of_another_that_can_stand_elsewhere():
    """The first one would take what the others need: each has two places, and there are three."""
    first, second, third = (Placed(complex(at, 0.5), 0.02, 0.02) for at in (0.2, 0.5, 0.8))
    near = {0: [first, second], 1: [first, third], 2: [first, third]}
    assert assigned(near) == {0: second, 1: third, 2: first}


def test_a_letter_between_two_dots_gets_a_leader():
    """Only below both dots is there a place near by, and there it might name either."""
    page = Obstacles(PAGE)
    at, rival = 0.5 + 0.5j, 0.53 + 0.5j
    page.box(Rect(0.35, 0.515, 0.65, 0.53))
    page.box(Rect(0.35, 0.47, 0.49, 0.53))
    wish = Wish(at, -1j, 0.02, 0.02, near=(0.024, 0.034), rivals=[rival])
    placed = place(page, wish)
    assert placed.leader
    start, end = placed.leader
    assert abs(start - at) < abs(start - rival)
    across = ((rival - end) / (at - end)).imag * abs(at - end)
    along = ((rival - end) / (at - end)).real
    assert abs(across) > 9.0 * PIXEL or along > 1.0


def test_a_leader_passes_no_other_dot():
    """Straight out there is a dot: it leads past it on either side, though that is longer."""
    page = Obstacles(PAGE)
    at, rival = 0.5 + 0.5j, 0.5 + 0.56j
    page.disc(rival, 0.008)
    wish = Wish(at, 1j, 0.02, 0.02, near=(), rivals=[rival])
    start, end = place(page, wish).leader or (0j, 1j)
    way = (end - start) / abs(end - start)
    off = (rival - start) / way
    assert abs(off - min(max(off.real, 0.0), abs(end - start))) >= 9.0 * PIXEL


def test_a_leader_meets_no_label_while_another_place_is_left():
    """A wall of words stands before all places near by but a few."""
    page = Obstacles(PAGE)
    for low in range(20, 80, 2):
        page.box(Rect(0.56, low / 100, 0.60, low / 100 + 0.02))
        page.box(Rect(0.40, low / 100, 0.44, low / 100 + 0.02))
    page.box(Rect(0.40, 0.56, 0.60, 0.60))
    placed = place(page, Wish(0.5 + 0.52j, 1j, 0.10, 0.02, near=()))
    assert placed.leader and not placed.forced
    assert placed.centre.imag < 0.56


def test_boxes_cover_a_lens_and_little_else():
    lens = Lens(0j, 0.02, 2.0, 0.5 + 0.5j, 0.1)
    reach, slabs = 0.1 + BAND, lens.slabs
    for turn_ in range(360):
        z = lens.at + reach * complex(math.cos(math.radians(turn_)), math.sin(math.radians(turn_)))
        inner = lens.at + (z - lens.at) * (1.0 - 1e-9)
        assert any(slab.holds(inner) for slab in slabs)
    area = sum(slab.width * slab.height for slab in slabs)
    assert area < 1.14 * math.pi * reach**2


def test_names_of_vectors_on_one_line_stand_on_the_sides_of_their_lanes():
    """Where the cross of Hooke's joint stands in the plane, two vectors lie side by side."""
    board = planned(vad.draw(vad.solve(vad.HookeJoint(), angle=90)))
    sketch = board.sketches["velocity"]
    boxes = {tag.text: tag.box for tag in sketch.tags}
    sides = {}
    for index, vector in place_vectors(sketch).items():
        name = sketch.setting.panel.strokes[index].label
        if vector.lane.aside and name in boxes:
            off = boxes[name].centre - (vector.start + vector.end) / 2
            sides[name] = (off * vector.lane.aside.conjugate()).real > 0.0
    assert len(sides) == 2
    assert all(sides.values())


@pytest.mark.parametrize("angle", range(0, 360, 40))
def test_the_names_of_an_inset_touch_no_arrow(angle: int):
    board = planned(vad.draw(vad.solve(vad.CrankSlottedLever(), angle=angle + 10)))
    assert not [fault for fault in faults(board) if fault.kind == "on a stroke"]
