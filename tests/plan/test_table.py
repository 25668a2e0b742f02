"""Results on the two-by-two page: whatever the numbers, no column touches another."""

from __future__ import annotations

from itertools import combinations

import pytest

import vad
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Lettering
from vad.strokes.sheet import Sheet
from vad.style import load_style

pytestmark = pytest.mark.exhaustive

SIZE = (1024, 768)


def fourbar(scale: float, language: str) -> Sheet:
    mechanism = vad.FourBar(
        ground=scale, crank=0.4123 * scale, coupler=1.2 * scale, rocker=0.8 * scale
    )
    motion = vad.solve(mechanism, angle=250, omega=scale, alpha=-2e-4 * scale)
    return vad.draw(motion, language=language)


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("style", ["paper", "print"])
@pytest.mark.parametrize("scale", [1e-3, 1e-9, 1e3, 1e9, 1.0])
def test_columns_never_touch(scale: float, style: str, language: str):
    board = plan(fourbar(scale, language), screen(SIZE), load_style(style).key, lesson=True)
    for beat in range(board.finished + 1):
        texts = [
            mark.shape
            for item in board.shown(beat)
            if item.region == "results"
            for mark in item.marks
            if isinstance(mark.shape, Lettering)
        ]
        boxes = [ink_box(text) for text in texts]
        for a, b in combinations(boxes, 2):
            gap = 0.01 if abs(a[1] - b[1]) < 0.016 else 0.0
            apart = a[2] + gap < b[0] or b[2] + gap < a[0] or a[3] < b[1] or b[3] < a[1]
            assert apart, (a, b)
        assert min(text.size for text in texts) > 0.018
        assert min(box[0] for box in boxes) >= board.page.left - 1e-9


def ink_box(text: Lettering) -> tuple[float, float, float, float]:
    shape, size, x, y = typeset(text.runs), text.size, text.at.real, text.at.imag
    return (
        x + size * shape.left,
        y + size * shape.bottom,
        x + size * shape.right,
        y + size * shape.top,
    )
