"""Results on the two-by-two page: whatever the numbers, no column touches another."""

from __future__ import annotations

from itertools import combinations

import pytest

import vad
from vad.plan.board import Board
from vad.strokes.sheet import Sheet

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
    board = Board(fourbar(scale, language), SIZE, style)
    for state in ("new", "measured"):
        marks = [m for m in board.table.marks(lambda *_, s=state: s) if m.text]
        boxes = [(*m.vertices.min(axis=0), *m.vertices.max(axis=0)) for m in marks]
        for a, b in combinations(boxes, 2):
            gap = 0.01 * SIZE[1] if abs(a[1] - b[1]) < 12 else 0.0
            apart = a[2] + gap < b[0] or b[2] + gap < a[0] or a[3] < b[1] or b[3] < a[1]
            assert apart, (a, b)
        assert min(m.text.size for m in marks) > 0.018 * SIZE[1]
        assert min(box[0] for box in boxes) >= board.page.left
