"""Bars of links, in full: a lever as far as its block gets, an actuator with its cylinder.

In come the strokes of a position panel and its scale, out go marks and obstacles.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from vad.plan.carriers import block_on, ends_of_travel
from vad.plan.geometry import direction_of
from vad.plan.growth import Fading, Trimming
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.marks import Mark, area, line
from vad.plan.pictures import machine
from vad.plan.pictures.lanes import Pen
from vad.plan.roles import BAR, BLOCK_RIM
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arrow, Block, Shape

NARROW = 0.6  # of a bar's width, on a longer bar


@dataclass(frozen=True, slots=True)
class PlacedBar:
    """A bar on the page.

    Attributes
    ----------
    start, end
        Between which it is drawn.
    seen
        Where what is to be seen of it starts; None where it lies under another bar of its link.
    cylinder
        The corners of a strut's cylinder; none for every other bar.
    width
        Its share of a bar's width: less where it lies on another one, whose edges are to be seen.
    row
        Whose ink it takes.
    """

    start: complex
    end: complex
    seen: complex | None
    cylinder: list[complex]
    width: float
    row: int | None

    def marks(self) -> list[Mark]:
        """Return what is to be seen of it."""
        if self.seen is None:
            return []
        role = "piston rod" if self.cylinder else "bar"
        shaft = line([self.seen, self.end], role, self.row, Trimming())
        marks = [replace(shaft, width=self.width)]
        if self.cylinder:
            marks.append(area(self.cylinder, "block", self.row, Fading()))
        return marks

    def light(self, growth: Trimming | None = None) -> Mark:
        """Return the light beneath it."""
        return line([self.start, self.end], "bar light", self.row, growth)

    def block(self, obstacles: Obstacles) -> None:
        """Add it to what labels keep clear of."""
        obstacles.line([self.start, self.end], BAR / 2)
        if self.cylinder:
            obstacles.line([*self.cylinder, self.cylinder[0]], BLOCK_RIM / 2)


def bar_of(sketch: Sketch, index: int, size: float) -> PlacedBar:
    """Return the bar of one stroke, which must be an arrow."""
    stroke, scale = sketch.setting.panel.strokes[index], sketch.scale
    start, end = _ends(sketch, index, size)
    shape, cylinder = stroke.shape, []
    if isinstance(shape, Arrow) and shape.cylinder:
        foot = start + shape.cylinder * scale.factor * direction_of(start, end)
        cylinder = machine.bar_corners(start, foot, machine.CYLINDER * size)
    row = sketch.setting.row(stroke.link)
    width = NARROW if _lies_on_another(sketch, index, size) else 1.0
    return PlacedBar(start, end, _seen(sketch, index, size), cylinder, width, row)


def slit_of(sketch: Sketch, index: int, size: float) -> Mark | None:
    """Return the slit of a lever, as long as the way of the block in it; None for other bars."""
    lever = sketch.setting.panel.strokes[index]
    block = block_on(sketch.setting.panel, lever)
    if block is None:
        return None
    pivot, end = _ends(sketch, index, size)
    way, (back, _) = _way_on(lever.shape, block)
    half, back = machine.LEVER_BLOCK[0] / 2 * size, sketch.scale(back)
    nearest = 2.0 * machine.JOINT_REACH * size
    first = max(((back - pivot) * way.conjugate()).real - half, nearest)
    corners = machine.bar_corners(pivot + first * way, end + BAR / 2 * way, machine.SLIT)
    return area(corners, "slit", sketch.setting.row(lever.link), Fading())


def _ends(sketch: Sketch, index: int, size: float) -> tuple[complex, complex]:
    """Return the ends of a bar; a lever ends with its slit, half a block past its block's way."""
    panel, scale = sketch.setting.panel, sketch.scale
    stroke = panel.strokes[index]
    assert isinstance(stroke.shape, Arrow)
    start, end, block = scale(stroke.shape.start), scale(stroke.shape.end), block_on(panel, stroke)
    if block:
        past = machine.LEVER_BLOCK[0] / 2 * size - BAR / 2  # its cap is under the slit
        way, (_, ahead) = _way_on(stroke.shape, block)
        end = scale(ahead) + past * way
    return start, end


def _way_on(lever: Shape, block: Block) -> tuple[complex, tuple[complex, complex]]:
    """Return the way from a lever's pivot to the block on it, and the ends of the block's travel.

    That is the way of the slide, or against it where the block is behind the pivot.
    """
    assert isinstance(lever, Arrow)
    back, ahead = ends_of_travel(block)
    if ((lever.end - lever.start) * block.direction.conjugate()).real < 0:
        return -block.direction, (ahead, back)
    return block.direction, (back, ahead)


def _lies_on_another(sketch: Sketch, index: int, size: float) -> bool:
    """Tell whether a bar lies on a longer one of another link."""
    strokes = sketch.setting.panel.strokes
    ends = _ends(sketch, index, size)
    here = Pen(*ends, BAR)
    for number, other in enumerate(strokes):
        if isinstance(other.shape, Arrow) and other.link != strokes[index].link:
            start, end = _ends(sketch, number, size)
            if abs(end - start) > abs(ends[1] - ends[0]) and here.covers(Pen(start, end, BAR)):
                return True
    return False


def _seen(sketch: Sketch, index: int, size: float) -> complex | None:
    """Return where a bar leaves those of its link that are drawn already."""
    strokes = sketch.setting.panel.strokes
    start, end = _ends(sketch, index, size)
    seen = start
    for earlier, other in enumerate(strokes[:index]):
        if isinstance(other.shape, Arrow) and other.link == strokes[index].link:
            tail, head = _ends(sketch, earlier, size)
            same_way = abs(direction_of(tail, head) - direction_of(start, end)) < 1e-6
            if abs(tail - start) < PIXEL and same_way:
                seen = max(seen, head, key=lambda spot: abs(spot - start))
    return seen if abs(seen - start) < abs(end - start) - PIXEL else None
