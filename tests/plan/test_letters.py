"""Letters of stills: each is read, and seen to be that of its point or line."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest

import vad
from tests.plan.overlaps import planned
from tests.plan.seen_letters import Fault, faults
from tests.plan.sheets import slider_crank
from tests.plan.test_overlaps import still
from vad.files.examples import example_names
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.labels.choices import PLACED
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import Placed, Wish, _led, assigned, distance, near_places, place
from vad.plan.lens import BAND, Lens
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.pictures.polygon import name_of
from vad.plan.pictures.vectors import place_vectors
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.strokes.sheet import Arrow, Stroke

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


@pytest.mark.exhaustive(192, of="stills")
@pytest.mark.parametrize("step", range(12))
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_letters_are_read_and_name_their_own_points(name: str, step: int):
    for sheet in still(name, step):
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


def away(point: complex, ends: tuple[complex, complex]) -> float:
    """Return how far a point is from a straight line between two others."""
    start, end = ends
    off = (point - start) / ((end - start) / abs(end - start))
    return abs(off - min(max(off.real, 0.0), abs(end - start)))


@pytest.mark.parametrize("crossed", [False, True])
@pytest.mark.parametrize("turned", [False, True])
def test_a_letter_between_two_dots_gets_a_leader(turned: bool, crossed: bool):
    """The one place near by is a little nearer to its own dot, too far to tell whose it is."""
    page = Obstacles(PAGE)
    at, rival = (0.53 + 0.5j, 0.5 + 0.5j) if turned else (0.5 + 0.5j, 0.53 + 0.5j)
    page.box(Rect(0.35, 0.515, 0.65, 0.53))
    page.box(Rect(0.35, 0.44, 0.47, 0.53))
    page.box(Rect(0.56, 0.44, 0.65, 0.53))
    if crossed:  # all other places are beyond a stroke
        page.line((0.447j, 1.0 + 0.447j), PIXEL)
    wish = Wish(at, -1j, 0.02, 0.02, near=(0.024,), rivals=[rival])
    near = near_places(page, wish)
    assert near
    assert all(distance(each.box, rival) < 1.4 * distance(each.box, at) for each in near)
    placed = place(page, wish)
    assert placed.leader
    start, end = placed.leader
    assert abs(start - at) < abs(start - rival)
    assert abs(end - start) < 70.0 * PIXEL
    assert away(rival, placed.leader) > 9.0 * PIXEL


@pytest.mark.parametrize("aside", [-7.5, -4.0, 0.0, 4.0, 7.5])
def test_a_leader_passes_no_other_dot(aside: float):
    """Straight out there is a dot, on the way or beside it: it leads past, though that is longer.

    Boxes leave only the places beyond that dot.
    """
    page = Obstacles(Rect(0.35, 0.49, 0.65, 0.80))
    at, rival = 0.5 + 0.5j, 0.5 + aside * PIXEL + 0.545j
    page.box(Rect(0.35, 0.49, 0.475, 0.56))
    page.box(Rect(0.525, 0.49, 0.65, 0.56))
    page.disc(rival, 0.006)
    placed = place(page, Wish(at, 1j, 0.02, 0.02, near=(), rivals=[rival]))
    assert placed.leader
    assert away(rival, placed.leader) >= 8.9 * PIXEL


@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize("off", [-0.008, 0.0, 0.004])
def test_a_leader_is_not_read_as_a_minus_sign(side: float, off: float):
    """Beside a text it ends at a corner, not at the height of its middle."""
    wish = Wish(0.5 + 0.5j, 1.0 + 0j, 0.08, 0.024)
    placed = _led(wish, wish.at + side * 0.12 + 1j * off, 0.0)
    assert placed.leader
    start, end = placed.leader
    assert distance(placed.box, end) < 0.006
    assert abs(end.imag - placed.centre.imag) > 0.8 * wish.high / 2
    assert abs((end - start).imag) > 0.1 * abs(end - start)


@pytest.mark.exhaustive(96, of="stills")
@pytest.mark.parametrize("step", range(12))
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_no_leader_is_read_as_a_minus_sign(name: str, step: int):
    for sheet in still(name, step):
        for sketch in planned(sheet).sketches.values():
            marks = [mark for item in sketch.items for mark in item.marks if mark.role == "leader"]
            for ends in (mark.shape.pieces[0] for mark in marks):
                if abs((ends[0] - ends[-1]).imag) > 0.1 * abs(ends[0] - ends[-1]):
                    continue
                for tag in sketch.tags:
                    end = min(ends, key=lambda z: distance(tag.box, z))
                    beside = distance(tag.box, end) < 0.008
                    level = abs(end.imag - tag.box.centre.imag) < 0.3 * tag.box.height
                    assert not (beside and level), tag.text


def test_the_centre_of_a_hooke_joint_has_its_letter():
    for angle in range(0, 360, 90):
        sketch = planned(vad.draw(vad.solve(vad.HookeJoint(), angle=angle))).sketches["position"]
        assert "O" in {tag.text for tag in sketch.tags}


def test_a_leader_runs_away_from_a_dot_close_to_its_own():
    """It cannot keep clear of that one, but need not lead through it."""
    page = Obstacles(Rect(0.35, 0.49, 0.65, 0.80))
    at, rival = 0.5 + 0.5j, 0.5 + 0.507j
    placed = place(page, Wish(at, 1j, 0.02, 0.02, near=(), rivals=[rival]))
    assert placed.leader
    assert away(rival, placed.leader) >= 0.99 * abs(rival - at)


def test_a_leader_meets_no_label_while_another_place_is_left():
    """A low word stands before the places near by, and a stroke before all places."""
    page = Obstacles(Rect(0.35, 0.49, 0.65, 0.80))
    at, word = 0.5 + 0.5j, Rect(0.47, 0.535, 0.53, 0.54)
    page.box(Rect(0.35, 0.49, 0.42, 0.57))
    page.box(Rect(0.58, 0.49, 0.65, 0.57))
    page.box(word)
    page.line((0.35 + 0.525j, 0.65 + 0.525j), PIXEL)
    placed = place(page, Wish(at, 1j, 0.02, 0.02, near=()))
    assert placed.leader and not placed.forced
    assert word.clipped(*placed.leader) is None


def named(start: complex, end: complex, *others: tuple[complex, complex]) -> tuple[str, Rect]:
    """Return the name that a Coriolis vector has among other lines, and where it stands."""
    sheet = slider_crank()
    stroke = Stroke("known", "zb′", Arrow(start, end, "z", "b′"), "", "slider", "coriolis")
    panel = replace(sheet.panel("acceleration"), strokes=(stroke,))
    sketch = Sketch(Setting(sheet, panel, PAGE, {}), Scale(0j, 1.0), Obstacles(PAGE))
    for line in (start, end), *others:
        sketch.obstacles.line(line, PIXEL)
    PLACED.vector(sketch, 0, name_of(stroke))
    [tag] = sketch.tags
    return tag.text, tag.box


@pytest.mark.parametrize("degrees", range(0, 360, 45))
def test_the_name_of_a_vector_stands_beside_its_middle(degrees: int):
    way = cmath.rect(1.0, math.radians(degrees))
    middle = 0.5 + 0.5j
    name, box = named(middle - 0.2 * way, middle + 0.2 * way)
    assert name == "2ωv"
    off = (box.centre - middle) / way
    assert abs(off.real) <= (box.width + box.height) / 2  # the box lies aside of its middle
    assert distance(box, middle) < 20.0 * PIXEL


@pytest.mark.parametrize("above", [False, True])
def test_the_name_of_a_line_keeps_off_another_line(above: bool):
    """On one side there is a place between both lines, on the other side no other line."""
    side = 1 if above else -1
    start, end = 0.3 + 0.5j, 0.7 + 0.5j
    other = start + 0.048j * side, end + 0.048j * side
    _, box = named(start, end, other)
    at = box.centre.real
    own, near = distance(box, at + 0.5j), distance(box, at + 0.5j + 0.048j * side)
    assert own < 12.0 * PIXEL
    assert near > 2.0 * own


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


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("angle", range(0, 360, 40))
def test_the_names_of_an_inset_touch_no_arrow(angle: int):
    board = planned(vad.draw(vad.solve(vad.CrankSlottedLever(), angle=angle + 10)))
    assert not [fault for fault in faults(board) if fault.kind == "on a stroke"]
