"""The loads of a mechanism, as arrows at their points."""

from __future__ import annotations

from vad.plan.anchors import Anchor
from vad.plan.items import Level
from vad.plan.pictures.vectors import PlacedVector
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arrow


def add_load(sketch: Sketch, index: int) -> None:
    """Add one load to the picture of a mechanism."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    assert isinstance(stroke.shape, Arrow)
    start, end = sketch.scale(stroke.shape.start), sketch.scale(stroke.shape.end)
    seen = start, Anchor.of(stroke.name, "start")
    placed = PlacedVector(stroke.name, start, end, seen, False, setting.row(stroke.link))
    during = setting.during(index)
    if not sketch.finished:
        sketch.add(stroke, Level.BLOCK, during, [placed.light()], setting.over(index))
    sketch.add(stroke, Level.BLOCK, during, placed.marks(sketch.solved, not sketch.finished))
    placed.block(sketch.obstacles, during)
