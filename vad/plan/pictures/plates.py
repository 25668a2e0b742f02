"""Links of three points or more: plates of a mechanism, and their tinted images in a polygon.

In come a panel's plates and triangles, out go areas beneath the strokes.
"""

from __future__ import annotations

from collections.abc import Sequence

from vad.plan.growth import Fading, Growth
from vad.plan.items import Level
from vad.plan.marks import Mark, area
from vad.plan.roles import PLATE_EDGE
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Plate


def plate(corners: Sequence[complex], row: int | None, growth: Growth | None = None) -> list[Mark]:
    """Return a plate: its outline, and a tint through which what lies beneath is seen."""
    return [area(corners, role, row, growth) for role in ("plate", "plate edge")]


def add_plate(sketch: Sketch, index: int, shape: Plate) -> None:
    """Add the plate of a link."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    row, corners = setting.row(stroke.link), [sketch.scale(corner) for corner in shape.corners]
    light = area(corners, "plate edge light", row)
    sketch.add(
        stroke,
        Level.GLOW,
        setting.during(index),
        [area(corners, "plate edge light", row, Fading())],
        setting.over(index),
    )
    sketch.add(stroke, Level.CARRIER, setting.during(index), plate(corners, row, Fading()))
    sketch.obstacles.line([*corners, corners[0]], PLATE_EDGE / 2)
    sketch.lights.setdefault(stroke.link or "", []).append(light)


def add_triangles(sketch: Sketch) -> None:
    """Add the images of links, each from the stroke on that finds its last corner."""
    setting = sketch.setting
    for triangle in setting.panel.triangles:
        index = setting.panel.number(triangle.stroke)
        corners = [sketch.scale(corner) for corner in triangle.corners]
        tint = area(corners, "plate", setting.row(triangle.link))
        stroke = setting.panel.strokes[index]
        sketch.add(stroke, Level.GROUND, setting.after(index), [tint])
