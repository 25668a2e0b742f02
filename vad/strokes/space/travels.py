"""What travels in a film of a mechanism in space, and what a view may show of it.

A vector turns by 90° only where that is true: in a view along the axis about which it is turned.

- ω₂ and α₂ lie along their axis, which the plane of the frame shows in true direction.  A copy of
  the axis lifts off, is stretched, and lands; it does not turn.
- ω₄₂τ̇ is ω₄₂ turned by 90° in the plane of the frame, and ω₄₂τ̇₃ in that of the coupler, which has
  been turned into the paper.  The velocities ay and dz, and d′z′, are ω₄₂, ω₄ and α₄ times a lever
  along AD, at right angles to the paper: in this view they are turned by 90°, too.  All leave the
  polygon that they come from.
- The velocity of B is the crank turned by 90°, in the view along the axis of the crank.  Then it
  changes from this view to that of its polygon: it is seen from another side as it flies, which
  turns and shortens it.  So do normal components of the crank and the rocker.  A normal component
  of BC leaves the view in which BC has its true length.

The sum a′y′ of three products comes from no single vector: a pencil draws it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from vad.kinematics.symbol import is_symbolic
from vad.strokes.diagram import ACCELERATION, VELOCITY
from vad.strokes.sheet import BELOW, Arrow, Curve, Panel, Sheet, Stroke
from vad.strokes.travel import Travel, TravelKind

#: The axis of the crank in true direction, by the names of strokes of the views, the best first.
AXES = ("star.A", "2.shaft", "A.shaft")
#: What is turned by 90°: the panel and the names of a vector, and where it comes from.
TURNED = (
    (ACCELERATION.panel, ("24.normal", "34.normal"), VELOCITY.panel, ("24.relative", "24")),
    (VELOCITY.panel + BELOW, ("ay",), VELOCITY.panel, ("24",)),
    (VELOCITY.panel + BELOW, ("dz",), VELOCITY.panel, ("14",)),
    (ACCELERATION.panel + BELOW, ("dz",), ACCELERATION.panel, ("14",)),
)
#: Of bars between balls: the row of the results, and the stroke of the view in which a vector turns
#: about the bar's own axis, which is seen as a point.
BARS = {"AB": ("crank", "AB.bar"), "DC": ("rocker", "DC.front")}
#: The stroke that draws BC in true length.
COUPLER = "BC.third"
#: A vector that is seen so many times as long in its own view is not shown there.
LONGEST = 4.0
#: Directions that differ by less are alike.
ALIKE = 1e-6


class _Rates(NamedTuple):
    """The rates of a row of the results; None where they are not on the sheet."""

    omega: float | None
    alpha: float | None


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
            yield from _of_bars(panel, views, sheet)
    for name, strokes, source, ends in TURNED:
        if name in halves and source in halves:
            yield from _turned(halves[name], strokes, halves[source], ends)


def _along_axis(panel: Panel, views: Panel) -> Iterator[tuple[str, Travel]]:
    """Yield the rate of the crank, which lies along its axis."""
    axis = _curve(views, AXES)
    stroke = _drawn(panel, ("12.absolute", "12"))
    if axis is None or stroke is None:
        return
    (tail, head), shape = axis, stroke.shape
    assert isinstance(shape, Arrow)
    along = (shape.end - shape.start) / (head - tail)
    if is_symbolic(along):
        return
    if along.real < 0.0:
        tail, head = head, tail
    if abs(along.imag) < ALIKE * abs(along):
        yield _named(panel, stroke, "axial", views.name, (tail, head))


def _turned(
    panel: Panel, names: tuple[str, ...], source: Panel, ends: tuple[str, ...]
) -> Iterator[tuple[str, Travel]]:
    """Yield the vectors that are another one, turned by 90° in the paper."""
    origin = _drawn(source, ends)
    if origin is None:
        return
    assert isinstance(origin.shape, Arrow)
    tail, head = origin.shape.start, origin.shape.end
    for name in names:
        stroke = _drawn(panel, (name,))
        if stroke is not None:
            yield _named(panel, stroke, "turned", source.name, (tail, head))


def _of_bars(panel: Panel, views: Panel, sheet: Sheet) -> Iterator[tuple[str, Travel]]:
    """Yield the known components of bars between balls."""
    bars = {stroke.name: stroke.shape for stroke in views.strokes}
    for stroke in panel.strokes:
        of, kind = stroke.part.of, stroke.component
        if stroke.kind != "known" or (kind != "tangential" and kind != "normal"):
            continue
        row, name = BARS.get(of, ("", COUPLER if of == "BC" else ""))
        bar = bars.get(name)
        if not isinstance(bar, Arrow):
            continue
        ends = (bar.start, bar.end) if kind == "tangential" else (bar.end, bar.start)
        if not row:  # its own view is that of the polygon
            yield _named(panel, stroke, kind, views.name, ends)
            continue
        rates, way = _rates(sheet, row), bar.end - bar.start
        rate = rates.omega if panel.name == VELOCITY.panel else rates.alpha
        if kind == "normal" and rates.omega is not None:
            yield _named(panel, stroke, kind, views.name, ends, -(rates.omega**2) * way)
        elif kind == "tangential" and rate is not None:
            yield _named(panel, stroke, kind, views.name, ends, 1j * rate * way)


def _named(
    panel: Panel,
    stroke: Stroke,
    kind: TravelKind,
    source: str,
    ends: tuple[complex, complex],
    seen: complex | None = None,
) -> tuple[str, Travel]:
    shape = stroke.shape
    assert isinstance(shape, Arrow)
    return panel.full(stroke.name), Travel(kind, source, *ends, shape.start, shape.end, seen)


def may_be_shown(travel: Travel) -> bool:
    """Tell whether a vector is not too long in the view that it leaves."""
    return abs(travel.oblique) <= LONGEST


def _drawn(panel: Panel, names: tuple[str, ...]) -> Stroke | None:
    """Return the vector that has one of some names."""
    for stroke in panel.strokes:
        if stroke.name in names and isinstance(stroke.shape, Arrow):
            return stroke
    return None


def _curve(views: Panel, names: tuple[str, ...]) -> tuple[complex, complex] | None:
    """Return the ends of the first straight line among those that have some names."""
    curves = {s.name: s.shape for s in views.strokes if isinstance(s.shape, Curve)}
    return next(((curves[n].points[0], curves[n].points[-1]) for n in names if n in curves), None)


def _rates(sheet: Sheet, key: str) -> _Rates:
    cells = {
        cell.quantity: cell.value
        for row in sheet.rows
        if row.key == key
        for name in (VELOCITY.panel, ACCELERATION.panel)
        for cell in row.cells.get(name, ())
    }
    return _Rates(cells.get("ω"), cells.get("α"))
