"""Polygons as every test of them sees them: how large they are, and where their lines cross."""

from __future__ import annotations

from vad.strokes.sheet import Arrow, Dot, Line, Panel


def size(panel: Panel) -> float:
    """Return the length of the longest vector of a polygon."""
    arrows = (s.shape for s in panel.strokes if isinstance(s.shape, Arrow))
    return max((abs(arrow.end - arrow.start) for arrow in arrows), default=0.0)


def crossings_lie_on_lines(panel: Panel) -> list[Line]:
    """Assert that every crossing lies on the two lines before it; return those left over."""
    lines: list[Line] = []
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Line):
            lines.append(stroke.shape)
            assert abs(abs(stroke.shape.direction) - 1) < 1e-12
        elif stroke.kind == "intersection" and isinstance(stroke.shape, Dot):
            assert len(lines) == 2
            for line in lines:
                off = line.direction.conjugate() * (stroke.shape.at - line.through)
                assert abs(off.imag) <= 1e-9 * size(panel)
                assert line.until == stroke.shape.at
            lines = []
    return lines
