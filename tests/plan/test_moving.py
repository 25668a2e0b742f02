"""The moves of a lecture: a polygon moves as a whole, and keeps clear of what stands still."""

from __future__ import annotations

from functools import cache
from itertools import combinations

import pytest

import vad
from tests.plan.test_marks import points
from vad.files.examples import example_path
from vad.lecture.moment import Moment, done, smooth
from vad.lecture.scenes import scene_numbers
from vad.painting.posed import board_of
from vad.plan.board import seen
from vad.plan.geometry import Rect
from vad.plan.items import HEAD, Item, Level
from vad.plan.marks import Lettering
from vad.plan.moving import SOON
from vad.plan.stage import Stage
from vad.plan.ways import SLACK, Way, ways

#: What of a polygon and of a mechanism must not stay behind.
BODIES = ("vector", "whole", "bar", "dot", "joint")
#: Mechanisms whose polygons have lenses, and one with a scale bar at a lower polygon.
LENSED = ["peaucellier", "pantograph", "v-engine", "drag-link", "four-bar"]
BARRED = ["spatial-four-bar"]


@cache
def stage_of(name: str) -> Stage:
    kind = vad.MECHANISMS.get(name) or vad.load(example_path(name))
    board = board_of(vad.animate(vad.draw(vad.solve(kind()))))
    assert isinstance(board, Stage)
    return board


def beats(stage: Stage) -> list[int]:
    """Return at which beat the panels move on from each scene."""
    counts = scene_numbers(stage.sheet)
    return [*(done(counts.index(n)) for n in range(1, stage.count)), stage.finished]


def shown(stage: Stage, beat: int, scene: float) -> list[Item]:
    items = seen(stage, Moment(beat, scene=scene))
    return [item for item in items if not item.region.endswith(HEAD)]


def lenses(items: list[Item]) -> list[Item]:
    """Return the parts of lenses, and the scale bars that come with a stroke, with their values."""
    return [
        item
        for item in items
        if item.level == Level.LENS
        or (item.stroke and any(mark.role == "scale bar" for mark in item.marks))
    ]


@pytest.mark.parametrize("name", ["four-bar", "gate-actuator"])
def test_whole_polygons_move(name: str):
    """A vector that has flown to its polygon moves with those that were drawn there."""
    stage = stage_of(name)
    for number, beat in enumerate(beats(stage)):
        counts = []
        for scene in (number, number + 0.3, number + 0.7, number + 1):
            items = [i for i in shown(stage, beat, scene) if i.level != Level.LENS]
            marks = [mark for item in items for mark in item.marks]
            there = [mark for mark in marks if mark.role in BODIES and mark.at(1.0)]
            counts.append(sorted(mark.role for mark in there if mark.alpha == 1.0))
        assert counts[0]
        assert all(each == counts[0] for each in counts), number


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("name", LENSED + BARRED)
def test_lenses_and_scale_bars_stay_whole_and_are_gone_while_panels_move(name: str):
    """A lens is carried by its panel as one figure while it fades, and so is a scale bar."""
    stage, found = stage_of(name), 0
    for number, beat in enumerate(beats(stage)):
        for share in (0.3, 0.5, 0.7):
            assert not lenses(shown(stage, beat, number + smooth(share)))
        for share, end in ((0.2, 0), (0.8, 1)):
            moving = lenses(shown(stage, beat, number + smooth(share)))
            still = lenses(shown(stage, beat, number + end))
            assert len(moving) == len(still)
            found += len(still)
            for one, other in panels_of(still, moving):
                similar(one, other)
    assert found


def panels_of(still: list[Item], moving: list[Item]) -> list[tuple[list[Item], list[Item]]]:
    """Return the items of each panel, as they stand and as they move."""
    names = {item.region for item in still}
    both = list(zip(still, moving, strict=True))
    return [
        ([a for a, _ in both if a.region == name], [b for a, b in both if a.region == name])
        for name in names
    ]


def similar(one: list[Item], other: list[Item]) -> None:
    """Assert that items are others in another place and size, with less ink, and not turned."""
    first, second = ([mark for item in items for mark in item.marks] for items in (one, other))
    starts, ends = ([z for mark in marks for z in points(mark)] for marks in (first, second))
    far = max(range(len(starts)), key=lambda number: abs(starts[number] - starts[0]))
    factor = (ends[far] - ends[0]) / (starts[far] - starts[0])
    assert factor.imag == pytest.approx(0.0, abs=1e-9)
    assert ends == pytest.approx([ends[0] + factor * (z - starts[0]) for z in starts])
    assert all(0.0 < b.alpha < a.alpha for a, b in zip(first, second, strict=True))


@pytest.mark.parametrize("name", ["four-bar", "gate-actuator"])
def test_polygons_keep_apart_while_they_move(name: str):
    """The velocity polygon goes round the mechanism, and in the last move each goes its own way."""
    stage = stage_of(name)
    for number, shares in ((1, (0.2, 0.4, 0.6, 0.7)), (2, (0.3, 0.4, 0.5))):
        for share in shares:
            boxes = bodies(shown(stage, beats(stage)[number], number + share))
            assert len(boxes) == number + 1
            for (one, a), (other, b) in combinations(boxes.items(), 2):
                wide = min(a.right, b.right) - max(a.left, b.left)
                high = min(a.top, b.top) - max(a.bottom, b.bottom)
                assert min(wide, high) < 0.0, (number, share, one, other)


def bodies(items: list[Item]) -> dict[str, Rect]:
    """Return the boxes about mechanism and polygons."""
    found: dict[str, list[complex]] = {}
    for item in items:
        for mark in item.marks:
            if mark.role in BODIES and mark.at(1.0):
                found.setdefault(item.stroke.partition(":")[0], []).extend(points(mark))
    return {
        name: Rect(
            min(z.real for z in places),
            min(z.imag for z in places),
            max(z.real for z in places),
            max(z.imag for z in places),
        )
        for name, places in found.items()
    }


def test_a_panel_becomes_smaller_before_it_moves_and_moves_before_it_becomes_larger():
    large, small = Rect(0.0, 0.0, 0.4, 0.4), Rect(0.8, 0.2, 0.9, 0.3)
    for way, still in ((Way(large, small), 0.25), (Way(small, large), 0.75)):
        middle = way.box(0.5)
        assert middle.width < 0.2
        place = (middle.centre - way.start.centre) / (way.end.centre - way.start.centre)
        assert place == pytest.approx(still)
        assert way.box(0.0) == way.start
        assert way.box(1.0) == way.end


def test_what_is_in_one_layout_only_keeps_its_place_in_its_panel():
    way = Way(Rect(0.0, 0.0, 0.4, 0.4), Rect(0.8, 0.2, 0.9, 0.3), -0.1)
    for from_start, home, ends in ((True, way.start, 0.0), (False, way.end, 1.0)):
        assert way.carried(ends, from_start) == (pytest.approx(1.0), pytest.approx(0j))
        for share in (0.2, 0.7):
            factor, shift = way.carried(share, from_start)
            box, mapped = way.box(share), home.mapped(factor, shift)
            assert (box.left, box.bottom) == pytest.approx((mapped.left, mapped.bottom))
            assert (box.right, box.top) == pytest.approx((mapped.right, mapped.top))


def test_no_row_crosses_another_one_while_panels_move():
    """A term or a row stands where it does in one of the two scenes."""
    stage = stage_of("hooke-joint")
    for number, beat in enumerate(beats(stage)[:-1]):
        before, after = (texts(stage, beat, number + end) for end in (0, 1))
        for share in (0.9 * SOON, 1 - 0.9 * SOON):
            between = texts(stage, beat, number + share)
            assert between <= before | after
            assert between
        # While panels are on their way, there are no words that they might cross.
        assert texts(stage, beat, number + 0.5) <= before & after


def texts(stage: Stage, beat: int, scene: float) -> set[tuple[str, complex]]:
    """Return all words beside the large panel and below the thumbnails, and where they begin."""
    work = stage.layout(0).work
    marks = [mark for item in shown(stage, beat, scene) for mark in item.marks if mark.at(1.0)]
    shapes = [mark.shape for mark in marks if mark.role in ("words", "term", "notes", "pale term")]
    return {
        ("".join(run.text for run in each.runs), each.at)
        for each in shapes
        if isinstance(each, Lettering) and work.holds(each.at) and each.at.imag > work.bottom
    }


def test_panels_that_change_places_go_round_each_other_and_stay_above_the_texts():
    left, right = Rect(0.0, 0.3, 0.3, 0.6), Rect(0.8, 0.3, 1.1, 0.6)
    area = Rect(0.0, 0.0, 1.2, 0.9)
    found = ways({"one": (left, right), "other": (right, left)}, area)
    one, other = found["one"].box(0.5), found["other"].box(0.5)
    assert abs((one.centre - other.centre).imag) > 0.2
    for way in found.values():
        assert way.box(0.8).bottom > left.bottom - SLACK
