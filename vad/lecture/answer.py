"""The answer of a lesson in words: how the output of the mechanism moves in this pose.

It is told from the sheet alone: "At 60° the slider C moves to the left at 639.5 mm/s and gains
speed."
"""

from __future__ import annotations

from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import ACCELERATION, VELOCITY
from vad.strokes.sentences import Noun, Sentence, SentencePart, Text, Unit, Voice
from vad.strokes.sheet import Arrow, Cell, Row, Sheet

#: A rate below this share of the largest one counts as zero.
_REST = 1e-9


def answer(sheet: Sheet) -> Sentence | None:
    """Return how the output of a mechanism moves; None for a sheet without its velocities."""
    row = _output(sheet)
    if row is None:
        return None
    (rate, *_), growth = row.cells[VELOCITY.panel], row.cells.get(ACCELERATION.panel, ())
    parts: dict[str, SentencePart] = {
        "place": _place(sheet),
        "name": _name(row),
        "of": row.letters,
        "symbol": rate.symbol,
        "rate": Figure(rate.value, rate.unit),
        "unit": Unit(rate.unit),
        "trend": _said(sheet, _trend(sheet, rate, growth)),
    }
    way = _way(sheet, row)
    if abs(rate.value) <= _REST * _largest(sheet, rate.unit):
        return _said(sheet, "answer rests", parts)
    if not way:
        return _said(sheet, "answer measures", parts)
    parts |= {"way": _said(sheet, way), "rate": Figure(abs(rate.value), rate.unit)}
    return _said(sheet, "answer turns" if rate.unit == "rad/s" else "answer moves", parts)


def _said(sheet: Sheet, phrase: str, parts: dict[str, SentencePart] | None = None) -> Sentence:
    return Sentence(phrase, parts or {}, voice=Voice(sheet.language, sheet.notation))


def _output(sheet: Sheet) -> Row | None:
    """Return the row of the output, as `Scene.output` has it: a slide of the frame, or the last."""
    driven = sheet.driver.row
    rows = [row for row in sheet.rows if row.key != driven and _moves(row)]
    carried = {
        stroke.link
        for panel in sheet.panels
        for ride in panel.body(None).carries
        for stroke in panel.strokes
        if stroke.name == ride.block
    }
    guided = [row for row in rows if row.key in carried]
    turning = [row for row in rows if row.cells[VELOCITY.panel][0].unit == "rad/s"]
    return next(iter((guided or turning or rows)[-1:]), None)


def _moves(row: Row) -> bool:
    cells = row.cells.get(VELOCITY.panel, ())
    return bool(cells) and not cells[0].given


def _name(row: Row) -> Noun:
    """Return the name of a link or slide, as its title has it."""
    said = row.title.said if isinstance(row.title, Text) else None
    slides = row.cells[VELOCITY.panel][0].unit != "rad/s"
    name = said.name if isinstance(said, Noun) else row.key
    return Noun(name, generic="slider" if slides else "link")


def _place(sheet: Sheet) -> SentencePart:
    """Return where the driver stands: 60°, or x = 500 mm."""
    cells = (
        cell
        for row in sheet.rows
        if row.key == sheet.driver.row
        for cell in row.cells.get("position", ())
        if cell.given
    )
    cell = next(cells, None)
    if cell is None:
        return _said(sheet, "answer here")
    parts: dict[str, SentencePart] = {
        "value": Figure(cell.value, cell.unit, given=True),
        "symbol": cell.symbol,
        "unit": Unit(cell.unit),
    }
    return _said(sheet, "answer at angle" if cell.unit == "°" else "answer at place", parts)


def _way(sheet: Sheet, row: Row) -> str:
    """Return the phrase for the way in which a row moves; empty where the paper does not show it.

    That is the sense in which a link turns, or the direction of the vector that measures a slide.
    """
    rate = row.cells[VELOCITY.panel][0]
    if any(panel.picture == "views" for panel in sheet.panels):
        return ""
    if rate.unit == "rad/s":
        return "counter-clockwise" if rate.value > 0.0 else "clockwise"
    for stroke in sheet.panel(VELOCITY.panel).strokes:
        if row.key in stroke.reveals and isinstance(stroke.shape, Arrow):
            way = stroke.shape.end - stroke.shape.start
            if abs(way.real) >= abs(way.imag):
                return "right" if way.real > 0.0 else "left"
            return "up" if way.imag > 0.0 else "down"
    return ""


def _trend(sheet: Sheet, rate: Cell, growth: tuple[Cell, ...]) -> str:
    """Return the phrase that says whether the output gains or loses speed."""
    if not growth or abs(growth[0].value) <= _REST * _largest(sheet, growth[0].unit):
        return "answer steady"
    return "answer gains" if (growth[0].value > 0.0) == (rate.value > 0.0) else "answer loses"


def _largest(sheet: Sheet, unit: str) -> float:
    cells = (cell for row in sheet.rows for cells in row.cells.values() for cell in cells)
    return max((abs(cell.value) for cell in cells if cell.unit == unit), default=0.0)
