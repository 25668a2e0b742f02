"""Vectors of a turn that are too long for their panel: they are broken at its edge."""

from __future__ import annotations

from collections.abc import Sequence

import vad
from vad.files.examples import example_path
from vad.plan.items import Item
from vad.plan.marks import Lettering, Mark, Polygon, Polyline
from vad.plan.pictures.polygon import principal
from vad.plan.reach import corners
from vad.plan.turn_board import TurnBoard
from vad.statics.burden import burden_of

FRAMES = range(0, 240, 5)


def marks(items: Sequence[Item], *roles: str) -> list[Mark]:
    return [mark for item in items for mark in item.marks if mark.role in roles]


def lines(items: Sequence[Item], *roles: str) -> list[tuple[complex, ...]]:
    shapes = [mark.shape for mark in marks(items, *roles)]
    return [tuple(p) for shape in shapes if isinstance(shape, Polyline) for p in shape.pieces]


def inked(items: Sequence[Item]) -> list[complex]:
    heads = [m.shape for m in marks(items, "head") if isinstance(m.shape, Polygon)]
    found = [z for head in heads for ring in head.rings for z in ring]
    return found + [z for line in lines(items, "vector", "whole", "break") for z in line]


def said(items: Sequence[Item]) -> bool:
    shapes = [m.shape for m in marks(items, "notes") if isinstance(m.shape, Lettering)]
    written = ["".join(run.text for run in shape.runs) for shape in shapes]
    return "Broken vectors are longer than drawn." in written


def test_an_acceleration_up_to_a_few_times_the_usual_one_stays_whole() -> None:
    """That of the double slider is three times as large near the ends of its swing."""
    board = TurnBoard(vad.turn(vad.DoubleSlider(), panels="acceleration"))
    for frame in FRAMES:
        shown = [item for item in board.shown(frame) if item.region == "acceleration"]
        assert not marks(shown, "break")
        assert not said(shown)
        assert all(board.panels["acceleration"].room.holds(z) for z in inked(shown))


def test_a_longer_vector_is_broken_at_the_edge_and_that_is_said() -> None:
    turn = vad.turn(vad.load(example_path("excavator-bucket"))(), panels="acceleration")
    board, found = TurnBoard(turn), 0
    panel = board.panels["acceleration"]
    for frame in FRAMES:
        shown = [item for item in board.shown(frame) if item.region == "acceleration"]
        pose = principal(turn.pose(frame).panel("acceleration"))
        beyond = [z for z in corners(pose) if not panel.room.holds(panel.scale(z))]
        assert all(panel.room.holds(z, 1e-9) for z in inked(shown))
        assert bool(marks(shown, "break")) == said(shown) == bool(beyond)
        found += bool(beyond)
        strokes = [(one + other) / 2 for one, other in lines(shown, "break")]
        shafts = lines(shown, "vector", "whole")
        for first, second in zip(strokes[::2], strokes[1::2], strict=True):
            assert 0.005 < abs(second - first) < 0.02
            for at in (first, second):
                assert min(abs(end - at) for shaft in shafts for end in shaft) < 1e-6
            assert min(_away((first + second) / 2, *shaft) for shaft in shafts) > 0.003
    assert 5 < found < 15


def test_forces_which_are_small_most_of_the_time_are_broken_sooner() -> None:
    """Their polygons have no lens."""
    motion = vad.solve(vad.load(example_path("excavator-bucket"))())
    loaded = vad.forces(motion, *burden_of(load=("P = 12 kN @ 90 at T",)))
    board = TurnBoard(vad.turn(loaded, panels="force"))
    broken = [frame for frame in FRAMES if marks(board.shown(frame), "break")]
    assert 0 < len(broken) < len(FRAMES) / 3
    assert [frame for frame in FRAMES if said(board.shown(frame))] == broken


def _away(at: complex, start: complex, end: complex) -> float:
    way = end - start
    share = min(max(((at - start) * way.conjugate()).real / abs(way) ** 2, 0.0), 1.0)
    return abs(at - start - share * way)
