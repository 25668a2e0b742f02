"""The board under the hand: while a dimension changes, what was chosen before stands."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

import pytest

import vad
from vad.gui.answers import board_of
from vad.plan.labels.named import Ways
from vad.plan.labels.obstacles import PIXEL
from vad.plan.labels.placing import distance
from vad.plan.labels.vertices import vertices_by_letter
from vad.plan.live_board import LiveBoard, LivePose
from vad.plan.marks import Bow, Outline, Polygon, Polyline
from vad.plan.pictures.skeleton import Skeleton
from vad.plan.reach import corners
from vad.strokes.sheet import Sheet

PANELS = ("position", "velocity", "acceleration")


def board_of_all(name: str, **parameters: float) -> LiveBoard:
    return board_of(vad.MECHANISMS[name](**parameters), PANELS, "en")


def sheet_of(name: str, **parameters: float) -> Sheet:
    return vad.draw(vad.solve(vad.MECHANISMS[name](**parameters)))


def shapes(pose: LivePose, role: str) -> list[Outline]:
    """Return the shapes of a role in the mechanism's panel."""
    found = [mark for item in pose.plan.items if item.region == "position" for mark in item.marks]
    return [mark.shape for mark in found if mark.role == role]


def arrow(pose: LivePose) -> tuple[float, float, float]:
    """Return radius, start and sweep of the ω arrow."""
    (bow,) = shapes(pose, "sense")
    assert isinstance(bow, Bow)
    return bow.radius, bow.start, bow.sweep


def feet(pose: LivePose) -> list[float]:
    """Return in degrees where each pivot's base lies from its apex."""
    found = []
    for shape in shapes(pose, "pivot"):
        assert isinstance(shape, Polygon)
        apex, one, other = shape.rings[0]
        found.append(round(math.degrees(cmath.phase((one + other) / 2 - apex)), 6))
    return found


@pytest.mark.parametrize(
    ("name", "changed"),
    [
        ("slider-crank", {"crank": 40.0}),
        ("four-bar", {"crank": 25.0}),
        ("crank-slotted-lever", {"crank": 60.0}),
        ("whitworth", {"crank": 70.0}),
    ],
)
def test_what_is_chosen_stands_while_a_dimension_changes(name, changed):
    board, own = board_of_all(name), board_of_all(name, **changed)
    before, other = board.pose(sheet_of(name), {}, {}), sheet_of(name, **changed)
    after = board.resized(other, before.scales).pose(other, before.scales, before.ways)
    assert after.scales["position"] == before.scales["position"]
    assert arrow(after) == arrow(before)
    assert arrow(after) != arrow(own.pose(other, {}, {}))  # or nothing would be kept
    assert feet(after) == feet(before)


def test_the_arrow_of_views_stands_while_a_dimension_changes():
    board = board_of_all("spherical-four-bar")
    before = board.pose(sheet_of("spherical-four-bar"), {}, {})
    other = sheet_of("spherical-four-bar", ground=92.7)
    after = board.resized(other, before.scales).pose(other, before.scales, before.ways)
    assert arrow(after) == arrow(before)


def test_what_is_chosen_stands_though_its_own_pose_was_never_asked_for():
    sheet, changed = sheet_of("four-bar"), sheet_of("four-bar", crank=44.0)
    seen = board_of_all("four-bar").pose(sheet, {}, {})
    board_of.cache_clear()
    fresh = board_of_all("four-bar").resized(changed, seen.scales)
    pose = fresh.pose(changed, seen.scales, seen.ways)
    assert feet(pose) == feet(seen)
    assert arrow(pose) == arrow(seen)


def test_feet_and_rails_of_before_stand_whatever_is_in_their_way():
    board, changed = board_of_all("slider-crank"), sheet_of("slider-crank", crank=45.0)
    before = board.pictures["position"]
    assert isinstance(before, Skeleton)
    before.feet["A.fixed"] = 1 + 0j  # where nobody would choose it
    long = max(abs(end - start) for start, end, _ in before.travels)
    after = board.resized(changed, {}).pictures["position"]
    assert isinstance(after, Skeleton)
    assert after.feet["A.fixed"] == 1 + 0j
    short = max(abs(end - start) for start, end, _ in after.travels)
    assert short * before.scale.factor >= 0.999 * long * after.scale.factor
    board_of.cache_clear()


def test_a_mechanism_that_outgrows_its_panel_gets_another_scale():
    board = board_of_all("four-bar")
    scales, found = board.pose(sheet_of("four-bar"), {}, {}).scales, []
    room = board.page.panels["position"].drawing
    for size in (*(1.03**step for step in range(16)), 1.0, 0.2):
        lengths = {"ground": 100.0, "crank": 40.0, "coupler": 120.0, "rocker": 80.0}
        sheet = sheet_of("four-bar", **{name: size * each for name, each in lengths.items()})
        scales = board.resized(sheet, scales).pose(sheet, scales, {}).scales
        assert all(room.holds(scales["position"](z)) for z in corners(sheet.panel("position")))
        found.append(scales["position"].factor)
    assert len(set(found[:-2])) <= 4  # while it grows by half
    assert found[-1] > found[0] > found[-3] == found[-2]


def test_a_guide_that_turns_keeps_its_side_of_the_rail():
    board, sides = board_of_all("double-slider"), set()
    before = board.pose(sheet_of("double-slider"), {}, {})
    for angle in (90.0, 70.0, 110.0):
        sheet, way = sheet_of("double-slider", guide_b=angle), cmath.rect(1.0, math.radians(angle))
        pose = board.resized(sheet, before.scales).pose(sheet, before.scales, before.ways)
        (rail,) = (each for each in pieces(pose, "rail") if abs(across(each, way)) < 1e-9)
        ticks = pieces(pose, "hatching")
        sides |= {across(t, way) > 0.0 for t in ticks if abs(across((rail[0], t[0]), way)) < 1e-9}
    assert len(sides) == 1


def pieces(pose: LivePose, role: str) -> list[tuple[complex, complex]]:
    """Return the straight lines of a role."""
    found = [shape for shape in shapes(pose, role) if isinstance(shape, Polyline)]
    return [(piece[0], piece[-1]) for shape in found for piece in shape.pieces]


def across(piece: tuple[complex, complex], way: complex) -> float:
    """Return how far a line leads to the left of a direction."""
    return ((piece[1] - piece[0]) * way.conjugate()).imag


@pytest.mark.parametrize(
    "given",
    [
        {"ground": 1.2e-148, "crank": 5e-149, "lever": 250.0},
        {"ground": 120.0, "crank": 50.0, "lever": 2.5e150},
    ],
)
def test_the_name_of_a_vector_without_a_length_on_the_page_stands_above_it(given):
    pose = board_of_all("crank-slotted-lever", **given).pose(
        sheet_of("crank-slotted-lever", **given), {}, {}
    )
    assert 0.0 < pose.ways["acceleration"]["2ωv"] < 180.0


def test_a_letter_is_nearest_to_its_own_dot_while_the_crank_turns() -> None:
    board, lettered = board_of_all("slider-crank"), 0
    ways: Mapping[str, Ways] = {}
    for degrees in range(0, 360, 10):
        sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=degrees + 0.3))
        seen = board.pose(sheet, {}, ways)
        ways = seen.ways
        for half in sheet.panels:
            sketch = seen.plan.sketches[half.name]
            boxes = {tag.text: tag.box for tag in sketch.tags}
            dots = vertices_by_letter(half, sketch.scale)
            for own in dots:
                box = boxes[own.label]
                off = [distance(box, dot.at) for dot in dots if abs(dot.at - own.at) > 3 * PIXEL]
                assert distance(box, own.at) < min(off) + 0.3 * PIXEL
                lettered += 1
    assert lettered == 360
