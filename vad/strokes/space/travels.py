"""What travels in a film of a mechanism in space, and what a view may show of it.

A vector turns by 90° only where that is true: in a view along the axis about which it is turned.

- ω₂ and α₂ lie along their axis, which the plane of the frame shows in true direction.  A copy of
  the axis lifts off, is stretched, and lands; it does not turn.
- ω₄₂τ̇ is ω₄₂ turned by 90° in the plane of the frame, and ω₄₂τ̇₃ in that of the coupler, which has
  been turned into the paper; a′x′ is the velocity aa₄ turned in the plane of the frame.  The
  velocities ay and dz, and d′z′, are ω₄₂, ω₄ and α₄ times a lever along AD, at right angles to the
  paper: in this view they are turned by 90°, too.  All leave the polygon that they come from.
- Between balls, the polygon is drawn in the view in which BC has its true length.  There BT is the
  crank turned by 90°: the velocity of B lies along it, and normal components along their bars.

The sum x′y′ of two products comes from no single vector: a pencil draws it.
"""

from __future__ import annotations

from collections.abc import Iterator

from vad.kinematics.symbol import is_symbolic
from vad.strokes.diagram import ACCELERATION, VELOCITY
from vad.strokes.sheet import BELOW, Arrow, Curve, Panel, Sheet, Stroke
from vad.strokes.travel import Travel, TravelKind

#: The axis of the crank in true direction, by the names of strokes of the views, the best first.
AXES = ("star.A", "2.shaft", "A.shaft")
#: What is turned by 90°: the panel and the names of a vector, and where it comes from: a vector, or
#: the sum of two, by the names that those which are drawn may have.
TURNED = (
    (ACCELERATION.panel, ("24.normal", "34.normal"), VELOCITY.panel, ("24.relative", "24")),
    (VELOCITY.panel + BELOW, ("ay",), VELOCITY.panel, ("24",)),
    (VELOCITY.panel + BELOW, ("dz",), VELOCITY.panel, ("14",)),
    (ACCELERATION.panel + BELOW, ("ax",), VELOCITY.panel + BELOW, ("ay", "ya4")),
    (ACCELERATION.panel + BELOW, ("dz",), ACCELERATION.panel, ("14",)),
)
#: Of bars between balls: the lines in their own view along which known components lie, by the
#: letters of the bar.  A normal component points back along its bar.
BARS = {"AB": "AB.third", "BC": "BC.third", "DC": "DC.third"}
TANGENT = {"AB": "BT.third"}
#: Directions that differ by less are alike.
ALIKE = 1e-6


def travels_in_space(sheet: Sheet, views: Panel | None) -> Iterator[tuple[str, Travel]]:
    """Yield all travels by the full names of the strokes that draw what travels.

    Parameters
    ----------
    sheet
        The sheet with its polygons.
    views
        The panel with the views; None if it is not on the sheet.
    """
    halves = {half.name: half for half in sheet.halves}
    for name in (VELOCITY.panel, ACCELERATION.panel):
        panel = halves.get(name)
        if panel and views:
            yield from _along_axis(panel, views)
            yield from _of_bars(panel, views)
    for name, strokes, source, ends in TURNED:
        if name in halves and source in halves:
            yield from _turned(halves[name], strokes, halves[source], ends)


def _along_axis(panel: Panel, views: Panel) -> Iterator[tuple[str, Travel]]:
    """Yield the rate of the crank, which lies along its axis."""
    axis = _curve(views, AXES)
    for stroke, _ in _arrows(panel, ("12.absolute", "12")):
        if axis is not None:
            yield from _along(panel, stroke, views.name, *axis)


def _turned(
    panel: Panel, names: tuple[str, ...], source: Panel, ends: tuple[str, ...]
) -> Iterator[tuple[str, Travel]]:
    """Yield the vectors that are the sum of others, turned by 90° in the paper."""
    origins = list(_arrows(source, ends))
    if not origins:
        return
    tail, head = origins[0][1].start, origins[-1][1].end
    for stroke, _ in _arrows(panel, names):
        yield _named(panel, stroke, "turned", source.name, (tail, head))


def _of_bars(panel: Panel, views: Panel) -> Iterator[tuple[str, Travel]]:
    """Yield the known components of bars between balls, along lines of the view of the polygon."""
    drawn = {stroke.name: stroke.shape for stroke in views.strokes}
    for stroke in panel.strokes:
        if stroke.kind != "known":
            continue
        if stroke.component == "normal":
            bar = drawn.get(BARS.get(stroke.part.of, ""))
            if isinstance(bar, Arrow):
                yield _named(panel, stroke, "normal", views.name, (bar.end, bar.start))
        elif stroke.component == "tangential":
            line = drawn.get(TANGENT.get(stroke.part.of, ""))
            if isinstance(line, Curve):
                yield from _along(panel, stroke, views.name, line.points[1], line.points[0])


def _along(
    panel: Panel, stroke: Stroke, source: str, tail: complex, head: complex
) -> Iterator[tuple[str, Travel]]:
    """Yield a vector that lies along a line; it points either way."""
    shape = stroke.shape
    assert isinstance(shape, Arrow)
    along = (shape.end - shape.start) / (head - tail)
    if is_symbolic(along):
        return
    if along.real < 0.0:
        tail, head = head, tail
    if abs(along.imag) < ALIKE * abs(along):
        yield _named(panel, stroke, "axial", source, (tail, head))


def _named(
    panel: Panel, stroke: Stroke, kind: TravelKind, source: str, ends: tuple[complex, complex]
) -> tuple[str, Travel]:
    shape = stroke.shape
    assert isinstance(shape, Arrow)
    return panel.full(stroke.name), Travel(kind, source, *ends, shape.start, shape.end)


def _arrows(panel: Panel, names: tuple[str, ...]) -> Iterator[tuple[Stroke, Arrow]]:
    """Yield the vectors that have some names, with their shapes, in drawing order."""
    for stroke in panel.strokes:
        if stroke.name in names and isinstance(stroke.shape, Arrow):
            yield stroke, stroke.shape


def _curve(views: Panel, names: tuple[str, ...]) -> tuple[complex, complex] | None:
    """Return the ends of the first straight line among those that have some names."""
    curves = {s.name: s.shape for s in views.strokes if isinstance(s.shape, Curve)}
    return next(((curves[n].points[0], curves[n].points[-1]) for n in names if n in curves), None)
