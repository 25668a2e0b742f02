"""The head of a panel: title and scale bar share a line, and neither covers the other."""

from __future__ import annotations

import pytest

import vad
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.lettering.glyphs import width
from vad.plan.scale import SHORTEST_BAR
from vad.words import languages

GAP = 0.015


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
