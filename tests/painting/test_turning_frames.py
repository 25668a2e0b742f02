"""Turns: frames equal full redraws; nothing rescales, nothing jumps, no number wobbles."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
import pytest

import vad
from vad.cli.run import run
from vad.lecture.moment import Moment
from vad.painting.film import frames, redraw
from vad.painting.filming import filmed
from vad.painting.outlines import outline
from vad.painting.picture import EMPTY, Frame
from vad.plan.lettering.glyphs import typeset
from vad.plan.turning.fixed_width import Figures
from vad.plan.turning.turn_board import TurnBoard
from vad.strokes.sheet import Cell
from vad.style import load_style

SIZE = (640, 360)


# One of each kind: a lever, guides, bars alone, a strut, and a slot that moves.
KINDS = ["crank-slotted-lever", "double-slider", "four-bar", "gate-actuator", "scotch-yoke"]


PAPER = load_style("paper")


@pytest.fixture(scope="module", params=KINDS)
def board(request) -> TurnBoard:
    mechanism = vad.MECHANISMS[request.param]()
    return TurnBoard(vad.turn(mechanism, fps=2, size=SIZE), PAPER.key)


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
    turn = vad.turn(vad.ScotchYoke(), fps=1, size=(480, 360), style="chalk")
    chalk = load_style("chalk")
    for number, frame in enumerate(filmed(turn)):
        if number == 5:
            again = TurnBoard(turn, chalk.key)
            assert np.array_equal(frame.pixels, redraw(again, Moment(number), chalk))


def test_labels_glide_and_the_last_frame_meets_the_first(board: TurnBoard):
    turn = board.turn
    for index, panel in enumerate(board.panels.values()):
        track = []
        for step in range(101):  # a fifth of the turn, at full rate, and over the seam
            phase = 0.9 + step / 500
            boxes = panel.labels(turn.at(phase).panels[index], phase)
            track.append({name.text: box.centre for name, box in boxes})
        for before, now in pairwise(track):
            for text in before.keys() & now.keys():
                assert abs(before[text] - now[text]) < 0.09, text


@pytest.mark.parametrize(
    ("mechanism", "angle", "kept"),
    [(vad.SliderCrank(), 90.0, "cₙ"), (vad.CrankSlottedLever(), 90.0, "z")],
)
def test_a_label_stays_where_its_vector_vanishes_for_an_instant(mechanism, angle, kept: str):
    turn = vad.turn(vad.solve(mechanism, angle=angle), fps=2, size=SIZE, panels="acceleration")
    (panel,) = TurnBoard(turn, PAPER.key).panels.values()
    for phase in (0.0, 0.002, 0.998):
        written = ", ".join(name.text for name, _ in panel.labels(turn.at(phase).panels[0], phase))
        assert kept in written.split(", ")
        assert "b′ₙ" not in written.split(", ")  # α is zero all through


def test_labels_seldom_meet_strokes_or_each_other(board: TurnBoard):
    turn, met, count = board.turn, 0, 0
    for index, panel in enumerate(board.panels.values()):
        for step in range(24):
            phase = step / 24
            pose = turn.at(phase).panels[index]
            strokes = panel.obstacles(pose, turn.course.share(phase))
            for _, box in panel.labels(pose, phase):
                count += 1
                met += not strokes.free([box.centre], box.width, box.height, 0.0)[0]
                strokes.box(box)
    assert met <= 0.09 * count


def test_nothing_leaves_its_panel(board: TurnBoard):
    for step in range(6):
        phase = step / 6
        sheet = board.turn.at(phase)
        for index, (name, panel) in enumerate(board.panels.items()):
            room = board.page.panels[name].drawing
            for item in panel.items(sheet.panels[index], phase, 1.0):
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


def test_numbers_are_always_as_wide():
    cells = [Cell("v", value, "mm/s") for value in (-371.94, 0.0, -0.004, 9.9996, 1250.0)]
    cells += [Cell("α", value, "rad/s²") for value in (2.5e7, -1e3)]
    cells += [Cell("θ", value, "°") for value in (359.98, 7.0, 120.04)]
    figures = Figures(cells)
    shown = ["".join(run.text for run in figures(cell) if run.shown) for cell in cells]
    assert shown[:5] == ["−372", "0", "0", "10", "1250"]
    assert shown[5:7] == ["2.500×107", "0.000×107"]  # 7 is raised
    assert shown[7:] == ["0.0", "7.0", "120.0"]
    for unit in ("mm/s", "rad/s²", "°"):
        assert len({round(typeset(figures(c)).advance, 9) for c in cells if c.unit == unit}) == 1


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


@pytest.mark.parametrize("path", ["turn.mp4", "turn.gif", "turn/"])
def test_a_turn_is_saved(tmp_path, path: str):
    vad.save(
        vad.turn(vad.ScotchYoke(), fps=2, size=(320, 240), panels="velocity"), f"{tmp_path}/{path}"
    )
    found = tmp_path / path
    assert len(list(found.iterdir())) == 16 if found.is_dir() else found.stat().st_size > 1000
