"""What travels in a film: vectors from a link or from the velocity polygon, and found ω and α.

A component that is known is a link, or a velocity, that is turned, and stretched to the polygon's
scale: ab is the crank AB turned by 90° in the sense of ω.  A vector that the image finds is a link,
too, and the area of an image is that of a link.  Which vector comes from where follows from the
strokes alone.  An ω or α that a polygon finds goes back to its link.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from vad.errors import InputError
from vad.kinematics.linkage import points_of
from vad.kinematics.symbol import is_symbolic
from vad.strokes.diagram import ACCELERATION, VELOCITY, Order
from vad.strokes.reveals import measurer
from vad.strokes.scene import point_of
from vad.strokes.sheet import Arrow, Cell, Dot, Panel, Plate, Row, Sheet, Stroke, StrokePart
from vad.strokes.space.travels import travels_in_space
from vad.strokes.travel import Travel, TravelKind


def travels(sheet: Sheet) -> dict[str, Travel]:
    """Return all travels by the full names of the strokes that draw what travels.

    There is none of what comes from a panel that is not on the sheet.  Those of a mechanism in
    space are those of `vad.strokes.space.travels`.
    """
    pictures = {panel.picture: panel for panel in sheet.panels}
    mechanism = pictures.get("skeleton")
    polygons = {half.name: half for half in sheet.halves if half.picture == "vectors"}
    velocities = polygons.get(VELOCITY.panel)
    found: dict[str, Travel] = {}
    for name in (VELOCITY.panel, ACCELERATION.panel):
        panel = polygons.get(name)
        if panel and mechanism:
            found.update(_from_links(panel, mechanism))
        if panel and velocities:
            found.update(_coriolis(panel, velocities, mechanism))
    if mechanism is None:
        found.update(travels_in_space(sheet, pictures.get("views")))
    return {name: travel for name, travel in found.items() if _can(travel)}


def found_rates(sheet: Sheet) -> frozenset[str]:
    """Return the full names of the strokes that find ω or α of a link of the mechanism."""
    if not any(panel.picture == "skeleton" for panel in sheet.panels):
        return frozenset()
    found = set()
    for order in (VELOCITY, ACCELERATION):
        for panel in (half for half in sheet.halves if half.name == order.panel):
            for row in sheet.rows:
                cell = turning(row, order)
                by = measurer(sheet, panel, row) if cell and not cell.given else None
                if by:
                    found.add(by[0].full(by[1].name))
    return frozenset(found)


def turning(row: Row, order: Order) -> Cell | None:
    """Return the cell of a row that states its ω, or its α; None for what slides."""
    cells = row.cells.get(order.panel, ())
    return cells[0] if cells and cells[0].unit == order.unit else None


def _can(travel: Travel) -> bool:
    """Tell whether both vectors have a length."""
    ends = travel.head - travel.tail, travel.end - travel.start
    return not any(is_symbolic(each) or abs(each) == 0.0 for each in ends)


def _from_links(panel: Panel, mechanism: Panel) -> Iterator[tuple[str, Travel]]:
    places = _places(mechanism)
    for stroke in panel.strokes:
        shape, kind = stroke.shape, _kind(stroke, mechanism)
        if kind is None or not isinstance(shape, Arrow):
            continue
        letters = (shape.tail, shape.head) if kind == "point" else _ends(stroke)
        tail, head = (places.get(point_of(letter)) for letter in letters)
        if tail is not None and head is not None:
            source = (head, tail) if kind == "normal" else (tail, head)
            yield (
                panel.full(stroke.name),
                Travel(kind, mechanism.name, *source, shape.start, shape.end),
            )
    for triangle in panel.triangles:
        tail, head = (places.get(letter) for letter in triangle.points[:2])
        if tail is not None and head is not None:
            start, end = triangle.corners[:2]
            yield (
                panel.full(triangle.stroke),
                Travel("image", mechanism.name, tail, head, start, end),
            )


def _kind(stroke: Stroke, mechanism: Panel) -> TravelKind | None:
    """Return what a vector is to its link; None if a pencil draws it."""
    if stroke.kind == "known" and stroke.component in ("tangential", "normal"):
        return stroke.component
    if not stroke.image or not isinstance(stroke.shape, Arrow):
        return None
    struts = (s.link for s in mechanism.strokes if isinstance(s.shape, Arrow) and s.shape.cylinder)
    if stroke.link in struts:  # its rod slides in its cylinder: it is no rigid body
        return None
    on_link = mechanism.body(stroke.link).points
    letters = stroke.shape.tail, stroke.shape.head
    return "point" if all(point_of(letter) in on_link for letter in letters) else None


def _ends(stroke: Stroke) -> tuple[str, str]:
    try:
        return points_of(stroke.part.of)
    except InputError:  # a sheet that somebody has written
        return "", ""


def _coriolis(
    panel: Panel, velocities: Panel, mechanism: Panel | None
) -> Iterator[tuple[str, Travel]]:
    sliding = {s.part.of: s.shape for s in velocities.strokes if s.part.which == "sliding"}
    for stroke in panel.strokes:
        source, shape = sliding.get(stroke.part.of), stroke.shape
        if (
            stroke.component == "coriolis"
            and isinstance(shape, Arrow)
            and isinstance(source, Arrow)
        ):
            ends = source.start, source.end, shape.start, shape.end
            by = _carrier(mechanism, stroke.part.of) if mechanism else None
            yield panel.full(stroke.name), Travel("coriolis", velocities.name, *ends, by=by)


def _carrier(mechanism: Panel, step: str) -> str | None:
    """Return the row of the body on which a block slides, which has a step's letters."""
    block = StrokePart(step, "block").name
    rows = (body.row for body in mechanism.bodies for ride in body.carries if ride.block == block)
    return next(rows, None)


def _places(mechanism: Panel) -> Mapping[str, complex]:
    """Return the places of points of a mechanism, by their letters."""
    places: dict[str, complex] = {}
    for stroke in mechanism.strokes:
        match stroke.shape:
            case Arrow(start, end, tail, head):
                places |= {tail: start, head: end}
            case Dot(at):
                places |= dict.fromkeys(stroke.label.split(","), at)
            case Plate(corners, letters):
                places |= dict(zip(letters, corners, strict=False))
    return places
