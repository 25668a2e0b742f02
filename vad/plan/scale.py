"""Scales: how a panel's coordinates become places on the page, how they are chosen, and stated.

A still fills its panel (`fill`).  A turn has one scale for all poses, chosen for those that are
usual (`mechanism_scale`, `polygon_scale`, `views_scale`).  While the driver is turned by hand, a
picture keeps its scale as long as it fits its panel and is not too small (`calm_scale`).  A bar
with its value states a scale; on paper, what a centimetre stands for does.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from vad.lecture.poles import usual_limit
from vad.plan.geometry import Rect
from vad.plan.lettering.glyphs import ink_size, width
from vad.plan.lettering.runs import Runs, roman
from vad.plan.marks import Bow, Lettering, Mark, line, lines
from vad.plan.reach import corners
from vad.strokes.notation import Notation
from vad.strokes.sheet import Arc, Guide, Panel

if TYPE_CHECKING:
    from vad.plan.sketch import Setting

SIDE_PADDING = 0.075
TOP_PADDING = 0.055
BOTTOM_PADDING = 0.060
BOTTOM_PADDING_POSITION = 0.090
SCALE_SIZE = 0.030
LONGEST_BAR = 0.12
SHORTEST_BAR = 0.03
#: So many lengths of 1, 2 and 5 times a power of ten lie between these two, at most.
_MOST_BARS = 4
SCALE_GAP = 0.0125  # from the bar to its value
SCALE_RISE = 0.0098  # of the bar above the baseline
SCALE_TICK = 0.008
_CENTIMETRES = {"mm": 0.1, "cm": 1.0, "m": 100.0}
SLACK = 0.020  # labels glide, and so a polygon needs less room around it than in a still
#: In views letters seldom stand beyond what reaches farthest: the room for them is smaller by this.
VIEWS_SLACK = 0.025
#: The room that a dimension and its words take of a panel, beside a guide.
DIMENSION = 0.050
#: Of its panel, a mechanism fills at least this, and a polygon, in which more letters stand.  Where
#: a new scale is found, it leaves that to spare.
LEAST, LEAST_POLYGON, SPARE = 0.22, 0.60, 0.20
#: How many times as large as three in four poses those accelerations of a turn are that leave their
#: room.
PEAK = 3.5
_DEEP = 0.1  # by that share of its height a mechanism reaches below a guide
_LEVEL = 0.9  # the height of the unit vector across a guide that is about level
_ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class Scale:
    """From panel coordinates to the page: ``origin + factor * z``.

    A panel with a single point has no scale to state: it is ``bare``.
    """

    origin: complex
    factor: float
    bare: bool = False

    def __call__(self, z: complex) -> complex:
        """Return where on the page is the panel's point ``z``."""
        return self.origin + self.factor * z

    def smaller(self, share: float, about: complex) -> Scale:
        """Return a scale that is a ``share`` of this one, and keeps a point of the page."""
        return replace(
            self, origin=about + share * (self.origin - about), factor=share * self.factor
        )


def fill(
    points: Iterable[complex],
    drawing: Rect,
    position: bool,
    centimetre: float | None = None,
    factor: float | None = None,
) -> Scale:
    """Return the scale at which ``points`` fill the drawing less its padding, centred.

    Where the length of a ``centimetre`` is given, it stands for a round number; a ``factor`` that
    is given is kept.
    """
    inner = padded(drawing, position)
    all_points = list(points) or [0j]
    xs = [p.real for p in all_points]
    ys = [p.imag for p in all_points]
    wide, high = max(xs) - min(xs), max(ys) - min(ys)
    if not wide and not high:
        return Scale(inner.centre, 1.0, bare=True)
    if factor is None:
        factor = min(
            inner.width / wide if wide else math.inf, inner.height / high if high else math.inf
        )
        if centimetre:
            factor = centimetre / round_up(centimetre / factor)
    middle = complex(min(xs) + wide / 2, min(ys) + high / 2)
    return Scale(inner.centre - factor * middle, factor)


def padded(drawing: Rect, position: bool) -> Rect:
    """Return the drawing less its padding, which takes no more than half of a small one."""
    bottom = BOTTOM_PADDING_POSITION if position else BOTTOM_PADDING
    across = min(1.0, drawing.width / (4 * SIDE_PADDING))
    upright = min(1.0, drawing.height / (2 * (bottom + TOP_PADDING)))
    return Rect(
        drawing.left + across * SIDE_PADDING,
        drawing.bottom + upright * bottom,
        drawing.right - across * SIDE_PADDING,
        drawing.top - upright * TOP_PADDING,
    )


def round_up(value: float) -> float:
    """Return the smallest 1, 2, 2.5 or 5 × 10ⁿ that is not less than ``value``.

    Examples
    --------
    >>> round_up(2.1), round_up(20.0), round_up(0.03), round_up(700.0)
    (2.5, 20.0, 0.05, 1000.0)
    """
    power = math.floor(math.log10(value))
    steps = (float(f"{step}e{power}") for step in (1, 2, 2.5, 5, 10))
    return next(step for step in steps if step >= value * (1 - 1e-9))


def scale_bar(factor: float, longest: float) -> float:
    """Return the largest 1, 2 or 5 × 10ⁿ whose bar is no longer than ``longest``.

    Examples
    --------
    >>> scale_bar(factor=1.7 / 720, longest=0.12)
    50.0
    """
    most = longest / factor * (1 + 1e-9)
    power = 10.0 ** math.floor(math.log10(most))
    for step in (5.0, 2.0):
        if step * power <= most:
            return step * power
    return power


def stated(
    panel: Panel, scale: Scale, room: float, centimetre: float | None, notation: Notation
) -> tuple[float, Runs]:
    """Return the length of the scale bar and what it says; on paper it is a centimetre."""
    if centimetre:
        return centimetre, _on_paper(panel, centimetre / scale.factor, notation)
    return bar(panel, scale, room, notation)


def bar(panel: Panel, scale: Scale, room: float, notation: Notation) -> tuple[float, Runs]:
    """Return the length of the scale bar and what it says: the longest that fits the ``room``.

    Where none of a length that can be measured fits, the shortest one.
    """
    value = scale_bar(scale.factor, LONGEST_BAR)
    for _ in range(_MOST_BARS):
        runs = roman(notation.quantity(value, panel.unit, given=True))
        length = value * scale.factor
        shorter = scale_bar(scale.factor, 0.9 * length)
        fits = width(runs, SCALE_SIZE) + SCALE_GAP + length <= room
        if fits or shorter * scale.factor < SHORTEST_BAR:
            break
        value = shorter
    return length, runs


def bar_marks(length: float, runs: Runs, start: complex, size: float = SCALE_SIZE) -> list[Mark]:
    """Return a scale bar that begins at ``start`` on the baseline, and its value behind it."""
    first, last = start.real, start.real + length
    y = start.imag + SCALE_RISE
    ticks = [(complex(x, y - SCALE_TICK), complex(x, y + SCALE_TICK)) for x in (first, last)]
    return [
        Mark(Lettering(runs, start + length + SCALE_GAP, size), "notes"),
        line([complex(first, y), complex(last, y)], "scale bar"),
        lines(ticks, "scale bar"),
    ]


def bar_box(length: float, runs: Runs, start: complex) -> Rect:
    """Return the box that the marks of a scale bar fill."""
    _, high = ink_size(runs, SCALE_SIZE)
    right = start.real + length + SCALE_GAP + width(runs, SCALE_SIZE)
    return Rect(
        start.real, start.imag - SCALE_TICK, right, start.imag + max(high, SCALE_RISE + SCALE_TICK)
    )


def _on_paper(panel: Panel, value: float, notation: Notation) -> Runs:
    """Return what a centimetre of paper stands for, and the ratio where both are metric lengths."""
    text = f"1 cm = {notation.quantity(value, panel.unit, given=True)}"
    ratio = value * _CENTIMETRES.get(panel.unit, 0.0)
    if ratio:
        sides = (notation.number(max(1.0, side), given=True) for side in (1.0 / ratio, ratio))
        text += f"   ({' : '.join(sides)})"
    return roman(text)


def mechanism_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale at which a mechanism fills its panel in all poses, with its dimensions."""
    points = [point for pose in poses for point in corners(pose)]
    room = _beside_guides(poses[0], points, setting.room)
    return fill(points, room, True, setting.centimetre)


def polygon_scale(
    polygons: Sequence[Sequence[complex]],
    room: Rect,
    centimetre: float | None,
    most: float,
) -> Scale:
    """Return the scale at which polygons fill a room; a few very large ones may leave it.

    ``polygons`` are the corners of each of them.  Very large is what is more than ``most`` times as
    large as three in four.
    """
    sizes = [max(map(abs, points), default=0.0) for points in polygons]
    limit = usual_limit(sizes, most)
    kept = zip(polygons, sizes, strict=True)
    points = [point for points, size in kept if size <= limit for point in points]
    return fill(points, room.inside(-SLACK), False, centimetre)


def views_scale(setting: Setting, poses: Sequence[Panel]) -> Scale:
    """Return the scale at which the views fill their panel in all poses; they state none."""
    points = [point for pose in poses for point in reach(pose)]
    room = setting.room.inside(-VIEWS_SLACK)
    scale = fill(points, room, position=False, centimetre=setting.centimetre)
    return replace(scale, bare=True)


def reach(panel: Panel) -> list[complex]:
    """Return the points of the views that have to be on the page."""
    arcs = [stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Arc)]
    bows = (Bow(arc.centre, arc.radius, arc.start, arc.sweep) for arc in arcs)
    return corners(panel) + [point for bow in bows for point in bow.line()]


def _beside_guides(panel: Panel, points: Sequence[complex], room: Rect) -> Rect:
    """Return the room of a mechanism that leaves some for a dimension along a level guide."""
    guides = [s.shape for s in panel.strokes if isinstance(s.shape, Guide) and s.shape.side]
    above = any(guide.side and guide.side.imag > _LEVEL for guide in guides)
    lowest, highest = min(z.imag for z in points), max(z.imag for z in points)
    high = [g.through.imag for g in guides if g.side and g.side.imag < -_LEVEL]
    below = any(height - lowest > _DEEP * (highest - lowest) for height in high)
    bottom, top = room.bottom + 0.7 * DIMENSION * below, room.top - DIMENSION * above
    return Rect(room.left, bottom, room.right, top)


def calm_scale(panel: Panel, room: Rect, before: Scale | None) -> Scale:
    """Return the scale of the pose before, unless polygon or mechanism has outgrown it."""
    points, position = corners(panel), panel.picture == "skeleton"
    fitting = fill(points, room, position)
    if before is None:
        return fitting
    if fitting.bare:
        return before
    inner = padded(room, position)
    fits = all(inner.holds(before(point), _ROUNDING) for point in points)
    lost = before.factor < (LEAST if position else LEAST_POLYGON) * fitting.factor
    if fits and not lost:
        return before
    spared = fitting.factor / (1.0 + SPARE)
    return fill(points, room, position, factor=spared if lost else min(spared, before.factor))
