"""The lens of a turn: when it is there, where it stands, what it shows, and its letters."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import vad
from tests.plan.turns import LEG, LEVER, board_of, numbered
from vad.files.examples import example_path
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.lens import BAND
from vad.plan.marks import Disc
from vad.plan.turn_board import TurnBoard
from vad.plan.turn_lens import FADE, INSIDE, LONG_SPAN, SMALL, TurnLens, _spans
from vad.plan.turn_panel import TurnPanel

CASES = {"lever": LEVER, "leg": LEG}
PHASES = [number / 60 for number in range(60)]


def board(name: str) -> TurnBoard:
    return board_of(CASES[name])


def lensed(name: str) -> tuple[TurnPanel, TurnLens]:
    panel = board(name).panels["acceleration"]
    assert panel.lens is not None
    return panel, panel.lens


def seen(items: list[Item]) -> list[Any]:
    return [mark for item in items if item.level == Level.LENS for mark in item.marks]


def reaches(panel: TurnPanel, lens: TurnLens) -> Any:
    """Return how far the farthest point is from the middle of what the lens shows."""
    ways = [way for spot, way in panel.hodographs.tracks.items() if spot.lettered]
    return np.abs(np.array(ways) - lens.lens.place).max(axis=0)


def at(panel: TurnPanel, name: str, phase: float) -> float:
    far = reaches(panel, lensed(name)[1])
    share = (phase - board(name).turn.opening) % 1.0
    return float(np.interp(share, np.linspace(0.0, 1.0, len(far)), far))


@pytest.mark.parametrize("name", CASES)
def test_a_lens_comes_when_all_points_have_room_in_it(name: str):
    panel, lens = lensed(name)
    fade = FADE / board(name).turn.duration
    limit = (lens.lens.radius - INSIDE) / lens.lens.factor
    for phase in PHASES:
        ink = lens.spans.ink(phase)
        about = [at(panel, name, phase + shift) for shift in np.linspace(-fade, 1.1 * fade, 19)]
        if max(about) <= limit - PIXEL:
            assert ink >= 0.9
    for first, _ in lens.spans.ends:
        assert at(panel, name, first) <= limit + PIXEL


@pytest.mark.exhaustive
@pytest.mark.parametrize(
    "case",
    [
        "jansen-leg",
        "drag-link",
        "spatial-four-bar",
        "crank-slotted-lever",
        "shaper",
        "watt-1",
        "trunnion",
    ],
)
def test_no_dot_is_beyond_the_rim_while_a_lens_is_there(case: str):
    made = vad.MECHANISMS.get(case) or vad.load(example_path(case))
    shown = board_of(LEG if case == "jansen-leg" else made())
    lenses = [(name, panel, panel.lens) for name, panel in shown.panels.items() if panel.lens]
    frames = 0
    for frame in range(0, 240, 5):
        phase = frame / 240
        for name, panel, lens in lenses:
            if not lens.spans.ink(phase):
                continue
            frames += 1
            pose = panel.picture.pose(shown.turn.at(phase).panel(name))
            marks = [mark for item in pose.items for mark in item.marks if mark.role == "dot"]
            dots = [mark.shape for mark in marks if isinstance(mark.shape, Disc)]
            away = [abs(lens.lens(dot.centre) - lens.lens.at) for dot in dots]
            assert max(away) <= lens.lens.radius - panel.picture.radius + PIXEL, (name, frame)
    assert frames > 8 * len(lenses) > 0


@pytest.mark.parametrize("name", CASES)
def test_it_comes_within_its_time_and_stands_still(name: str):
    panel, lens = lensed(name)
    turn = board(name).turn
    places = set()
    for phase in np.linspace(0.0, 1.0, 40, endpoint=False).tolist():
        shown = seen(panel.items(turn.at(phase).panel("acceleration"), phase))
        rims = [mark.shape for mark in shown if mark.role == "lens rim"]
        assert bool(rims) == bool(lens.spans.ink(phase))
        places.update((shape.centre, shape.radius) for shape in rims)
        letters = [mark for mark in shown if mark.role in ("letter", "tag")]
        assert bool(letters) <= lens.spans.shows(phase)
        assert all(mark.alpha == 1.0 for mark in letters)
    assert places == {(lens.lens.at, lens.lens.radius)}
    first = lens.spans.ends[0][0]
    assert lens.spans.ink(first) == 0.0
    assert lens.spans.ink(first + FADE / turn.duration) == pytest.approx(1.0)


@pytest.mark.parametrize("name", CASES)
def test_each_point_has_its_letter_in_the_lens_or_beside_the_polygon(name: str):
    panel, lens = lensed(name)
    turn = board(name).turn
    inside = 0
    for phase in PHASES:
        pose = turn.at(phase).panel("acceleration")
        within = {label.text for label, _ in lens.labels.at(pose, phase)}
        beside = {label.text for label, _ in panel.labels.at(pose, phase)}
        assert not within & beside
        inside += len(within)
        for label, placed in lens.labels.at(pose, phase):
            corners = placed.wide + 1j * placed.high, placed.wide - 1j * placed.high
            for corner in (*corners, *(-z for z in corners)):
                assert abs(placed.centre + corner / 2 - lens.lens.at) < lens.lens.radius, label.text
    assert inside > 40


@pytest.mark.parametrize("name", CASES)
def test_it_covers_nothing_that_moves_while_it_is_there(name: str):
    panel, lens = lensed(name)
    circle = lens.lens
    assert abs(circle.at - circle.place) > circle.radius + circle.ring + BAND
    assert panel.room.holds(circle.at + circle.radius, 0.02)
    assert panel.room.holds(circle.at - 1j * circle.radius)
    assert not lens.spot.words.box(lens.spot.middle).clipped(*circle.leader)
    for phase in PHASES:
        if lens.spans.ink(phase) == 1.0:
            for way in panel.hodographs.tracks:
                spot = panel.hodographs.at(way, phase - board(name).turn.opening)
                assert abs(spot - circle.at) > circle.radius + BAND


def test_what_it_shows_is_the_polygon_enlarged():
    panel, lens = lensed("lever")
    phase = next(phase for phase in PHASES if lens.spans.ink(phase) == 1.0)
    shown = seen(panel.items(board("lever").turn.at(phase).panel("acceleration"), phase))
    dots = [m.shape.centre for m in shown if m.role == "dot" and isinstance(m.shape, Disc)]
    for spot in panel.hodographs.tracks:
        at = lens.lens(panel.hodographs.at(spot, phase - board("lever").turn.opening))
        assert min(abs(at - dot) for dot in dots) < PIXEL, spot


def test_a_polygon_that_is_large_most_of_the_time_has_none():
    shown = board_of(vad.SliderCrank())
    assert {panel.lens for panel in shown.panels.values()} == {None}


def test_it_comes_twice_in_a_turn_if_it_stays_long():
    """The velocities of the spatial four-bar are small twice."""
    shown = board_of(vad.SpatialFourBar())
    lens = shown.panels["velocity.below"].lens
    assert lens is not None
    assert len(lens.spans.ends) == 2
    assert all(last - first >= LONG_SPAN for first, last in lens.spans.ends)


def test_it_comes_again_where_it_stays_long_both_times():
    reach = np.full(721, 0.1)
    reach[:200] = reach[300:560] = 0.01
    assert len(_spans(reach, 0.02, 0.03, 0.0, 0.0375).ends) == 2
    reach[340:560] = 0.1  # now it would be gone soon after it came
    ((begin, end),) = _spans(reach, 0.02, 0.03, 0.0, 0.0375).ends
    assert end - begin == pytest.approx(200 / 720 - 0.0375, abs=2 / 720)


def test_a_still_with_numbers_has_none():
    still = numbered(LEVER)
    assert still.panels["acceleration"].lens is None


def test_small_is_what_it_is_called():
    panel, _ = lensed("lever")
    ways = [way for spot, way in panel.hodographs.tracks.items() if spot.lettered]
    pole = next(way[0] for way in ways if not np.ptp(way))
    lengths = np.abs(np.array(ways) - pole).max(axis=0)
    assert (lengths < SMALL).mean() > 0.25
