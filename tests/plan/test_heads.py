"""The head of a panel: title and scale bar share a line, and neither covers the other."""

from __future__ import annotations

from pathlib import Path

import pytest

import vad
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.lettering.glyphs import width
from vad.plan.marks import Lettering
from vad.plan.page.heads import LEAST_SCALE, TITLE
from vad.plan.scale import SCALE_SIZE, SHORTEST_BAR
from vad.words import languages

GAP = 0.015


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("omega", [10.0, 1000.0])
@pytest.mark.parametrize("size", [(1280, 720), (1080, 720), (1024, 768), (600, 800)])
@pytest.mark.parametrize("code", languages())
def test_a_scale_bar_leaves_the_title_alone_and_can_be_measured_by(code, size, omega):
    sheet = vad.draw(vad.solve(vad.SliderCrank(), omega=omega), language=code)
    board = plan(sheet, screen(size), 0.058)
    for item in board.shown(board.finished):
        bars = [m.shape for m in item.marks if m.role == "scale bar"]
        for title in (m.shape for m in item.marks if m.role == "words" and bars):
            (start, end) = bars[0].pieces[0]
            right = title.at.real + width(title.runs, title.size)
            assert start.real >= right + GAP, (item.region, start.real - right)
            assert abs(end - start) >= SHORTEST_BAR, (item.region, abs(end - start))


def test_title_and_scale_become_smaller_alike():
    motion = vad.solve(vad.CrankSlottedLever(rod=100, ram_height=180))
    board = plan(vad.draw(motion, language="de"), screen((1000, 720)), 0.058)
    tight = 0
    for item in board.shown(board.finished):
        marks = [mark for mark in item.marks if isinstance(mark.shape, Lettering)]
        sizes = {mark.role: mark.shape.size for mark in marks}
        if item.region.endswith(" head") and sizes.keys() == {"words", "notes"}:
            tight += sizes["words"] < TITLE - 1e-9
            if sizes["notes"] > LEAST_SCALE:
                assert sizes["words"] / TITLE == pytest.approx(
                    sizes["notes"] / SCALE_SIZE, rel=0.02
                )
    assert tight


def test_the_heading_above_two_polygons_side_by_side_takes_their_whole_panel():
    path = Path(vad.__file__).parent / "examples" / "balancing" / "four-in-line.toml"
    board = plan(vad.draw(vad.solve(vad.load(path)(), angle=25.0)), screen((1280, 720)), 0.058)
    heads = [item for item in board.shown(board.finished) if item.region.endswith(" head")]
    titles = [m.shape for item in heads for m in item.marks if m.role == "words"]
    bars = [m.shape for item in heads[1:] for m in item.marks if m.role == "scale bar"]
    assert {title.size for title in titles} == {TITLE}
    for title, bar in zip(titles[1:], bars[::2], strict=True):
        assert bar.pieces[0][0].real >= title.at.real + width(title.runs, TITLE) + GAP
