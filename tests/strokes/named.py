"""What stands in a panel under a name, for the tests of what is drawn."""

from __future__ import annotations

from vad.strokes.sheet import Arrow, Dot, Panel, Stroke


def stroke(panel: Panel, name: str) -> Stroke:
    """Return a stroke, drawn or not."""
    return next(s for s in (*panel.strokes, *panel.zeros) if s.name == name)


def vector(panel: Panel, name: str) -> complex:
    """Return the vector that a stroke draws."""
    shape = stroke(panel, name).shape
    assert isinstance(shape, Arrow)
    return shape.end - shape.start


def dot(panel: Panel, name: str) -> complex:
    """Return where a stroke marks a point."""
    shape = stroke(panel, name).shape
    assert isinstance(shape, Dot)
    return shape.at
