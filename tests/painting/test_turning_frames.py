"""Turns: frames equal full redraws, nothing rescales, and nothing leaves its panel."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

import vad
from vad.cli.run import run
from vad.lecture.moment import Moment
from vad.painting.film import EMPTY, Frame, filmed, frames, redraw
from vad.painting.shapes import outline
from vad.plan.turn_board import TurnBoard
from vad.style import load_style

pytestmark = pytest.mark.exhaustive

SIZE = (640, 360)


# One of each kind: a lever, guides, bars alone, a strut, and a slot that moves; vectors are alike.
KINDS = {
    "crank-slotted-lever": None,
    "double-slider": "position",
    "four-bar": "position",
    "gate-actuator": "position",
    "scotch-yoke": "position",
}


PAPER = load_style("paper")


@pytest.fixture(scope="module", params=KINDS)
def board(request) -> TurnBoard:
    mechanism, panels = vad.MECHANISMS[request.param](), KINDS[request.param]
    return TurnBoard(vad.turn(mechanism, fps=1, size=SIZE, panels=panels))


def turning(board: TurnBoard) -> Iterator[Frame]:
    return frames(board, ((Moment(n), 1) for n in range(board.turn.frames)), PAPER)


def test_every_frame_equals_one_painted_from_nothing(board: TurnBoard):
    turn, before = board.turn, None
    for number, frame in enumerate(turning(board)):
        assert np.array_equal(frame.pixels, redraw(board, Moment(number), PAPER)), number
        assert frame.repeats == 1
        if before is None:
            assert frame.changed == (0, 0, *SIZE)
        else:
            differs = (before != frame.pixels).any(axis=2)
            rows, columns = np.flatnonzero(differs.any(1)), np.flatnonzero(differs.any(0))
            tight = (columns[0], rows[0], columns[-1] + 1, rows[-1] + 1) if len(rows) else EMPTY
            assert frame.changed == tight
        before = frame.pixels.copy()
    assert number + 1 == turn.frames


def test_a_board_laid_out_again_finds_the_same_places():
    turn = vad.turn(vad.ScotchYoke(), fps=1, size=(480, 360), style="chalk", panels="velocity")
    chalk = load_style("chalk")
    for number, frame in enumerate(filmed(turn)):
        if number == 5:
            again = TurnBoard(turn)
            assert np.array_equal(frame.pixels, redraw(again, Moment(number), chalk))


def test_nothing_leaves_its_panel(board: TurnBoard):
    for step in range(6):
        phase = step / 6
        sheet = board.turn.at(phase)
        for index, (name, panel) in enumerate(board.panels.items()):
            room = board.page.panels[name].drawing
            for item in panel.items(sheet.panels[index], phase):
                for mark in item.marks:
                    vertices, _ = outline(mark.shape)
                    (left, _), (right, top) = vertices.min(axis=0), vertices.max(axis=0)
                    assert left > room.left - 0.05
                    assert right < room.right + 0.05
                    assert top < room.top + 0.03


def test_vectors_that_are_rarely_large_leave_the_panel():
    """A parallelogram folds: its rates run away there, and must not shrink all the rest."""
    parallelogram = vad.FourBar(ground=100, crank=40, coupler=100, rocker=40)
    turn = vad.turn(parallelogram, fps=2, size=SIZE, panels="acceleration")
    assert sum(1 for _ in filmed(turn)) == turn.frames


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--still", "3", "-o", "x.png"], "--still does not go with --turn"),
        (["--subtitles", "-o", "x.mp4"], "--subtitles does not go with --turn"),
        (["-o", "x.srt"], "a turn cannot be saved as 'x.srt'"),
    ],
)
def test_options_that_do_not_go_together(words: list[str], said: str, capsys):
    assert run(["animate", "four-bar", "--turn", *words])
    assert said in capsys.readouterr().err


@pytest.mark.parametrize(
    "path", ["turn.mp4", "turn.gif", "turn/", "turn.png", "turn.svg", "turn.pdf"]
)
def test_a_turn_is_saved(tmp_path, path: str):
    vad.save(
        vad.turn(vad.ScotchYoke(), fps=2, size=(320, 240), panels="velocity"), f"{tmp_path}/{path}"
    )
    found = tmp_path / path
    assert len(list(found.iterdir())) == 16 if found.is_dir() else found.stat().st_size > 1000
