"""The answer of a lesson in words: what must drive the mechanism, or how its output moves.

It is told from the sheet alone: "At 60° the slider C moves to the left at 639.5 mm/s and gains
speed."  "At 60° point H has *v* = 139.0 mm/s at 183.2° and *a* = 302.8 mm/s² at 153.5° from *x*."
"At 120° the torque *T* = 18.69 N·m, clockwise, must act on the crank AB."
"""

from __future__ import annotations

from vad.kinematics.numbers import bearing, ray
from vad.lecture.balanced import answer_of_balancing
from vad.lecture.followed import place_of
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import ACCELERATION, VELOCITY
from vad.strokes.scene import image_letter
from vad.strokes.sentences import Noun, Sentence, SentencePart, Text, Unit, Voice
from vad.strokes.sheet import Arrow, Cell, Curve, Row, Sheet, Stroke

#: The panels in whose rows the rates stand, the first that there is.
_RATES = (VELOCITY.panel, "turned", "centres")
#: The panel of the driven body alone, and the vector of the force on it.
DRIVE, SLIDING = "drive", "drive.action"
#: The title of the row in which the length of a driven cylinder stands.
CYLINDER = Noun("length", generic="")
#: A rate below this share of the largest one counts as zero.
_REST = 1e-9


def answer(sheet: Sheet) -> Sentence | None:
    """Return what drives a mechanism with loads, how another one moves, or what balances a shaft.

    None for a sheet without velocities, on which nothing was to be found.
    """
    return _drive(sheet) or _of_point(sheet) or _motion(sheet)


def _drive(sheet: Sheet) -> Sentence | None:
    """Return the torque or the force of the drive, with its sense; None where none is drawn."""
    rows = [row for row in sheet.rows if row.key == sheet.driver.row and row.cells.get(DRIVE)]
    if not rows:
        return None
    row, cell = rows[0], rows[0].cells[DRIVE][0]
    parts: dict[str, SentencePart] = {
        "place": _place(sheet),
        "name": _name(row, slides=not sheet.driver.turns),
        "of": row.letters,
        "symbol": cell.symbol,
        "value": Figure(abs(cell.value), cell.unit),
        "unit": Unit(cell.unit),
    }
    if not cell.value:
        return _said(sheet, "answer undriven", parts)
    if sheet.driver.turns:
        return _said(sheet, "answer torque", parts | {"way": _said(sheet, _sense(cell.value))})
    if isinstance(row.title, Text) and row.title.said == CYLINDER:
        return _said(sheet, "answer pushes" if cell.value > 0.0 else "answer pulls", parts)
    force = next(each.shape for each in sheet.panel(DRIVE).strokes if each.name == SLIDING)
    assert isinstance(force, Arrow)
    way = _direction(force.end - force.start)
    return _said(sheet, "answer force", parts | {"way": _said(sheet, way)})


def _of_point(sheet: Sheet) -> Sentence | None:
    """Return how the output point moves; None where the mechanism names none, or it rests."""
    found = {panel.name: panel for panel in sheet.panels}
    rates: list[SentencePart] = []
    for order, symbol in ((VELOCITY, "v"), (ACCELERATION, "a")):
        panel = found.get(order.panel)
        rate = place_of(panel.strokes, image_letter(sheet.output, order.number)) if panel else None
        if panel is None or not sheet.output or not rate:
            break
        parts: dict[str, SentencePart] = {
            "symbol": f"{symbol}_{sheet.output}",
            "rate": Figure(abs(rate), panel.unit),
            "unit": Unit(panel.unit),
            "way": Figure(bearing(rate) % 360.0, "°"),
        }
        rates.append(_said(sheet, "answer point rate", parts))
    if not rates:
        return None
    both = {"first": rates[0], "last": rates[-1]}
    told = rates[0] if len(rates) == 1 else _said(sheet, "and", both)
    return _said(sheet, "answer point", {"place": _place(sheet), "of": sheet.output, "rates": told})


def _motion(sheet: Sheet) -> Sentence | None:
    """Return how the output moves, or what balances a shaft."""
    row = _output(sheet)
    if row is None:
        return _of_klein(sheet) or answer_of_balancing(sheet)
    (rate, *_), growth = row.cells[_panel(row)], row.cells.get(ACCELERATION.panel, ())
    parts: dict[str, SentencePart] = {
        "place": _place(sheet),
        "name": _name(row, slides=row.cells[_panel(row)][0].unit != "rad/s"),
        "of": row.letters,
        "symbol": rate.symbol,
        "rate": Figure(rate.value, rate.unit),
        "unit": Unit(rate.unit),
        "trend": _said(sheet, _trend(sheet, rate, growth)),
    }
    way = _way(sheet, row)
    if abs(rate.value) <= _REST * _largest(sheet, rate.unit):
        shifts = _shift(sheet, row)
        return _said(sheet, "answer shifts" if shifts else "answer rests", parts | shifts)
    if not way:
        return _said(sheet, "answer measures", parts)
    parts |= {"way": _said(sheet, way), "rate": Figure(abs(rate.value), rate.unit)}
    return _said(sheet, "answer turns" if rate.unit == "rad/s" else "answer moves", parts)


def _shift(sheet: Sheet, row: Row) -> dict[str, SentencePart]:
    """Return how fast a link moves that does not turn, and which way; nothing if it stands still.

    All its points move alike: as the last one whose velocity is drawn from the pole.
    """
    panel = next((panel for panel in sheet.panels if panel.name == VELOCITY.panel), None)
    for stroke in reversed(panel.strokes if panel else ()):
        if stroke.link == row.key and stroke.component == "absolute":
            assert panel is not None and isinstance(stroke.shape, Arrow)
            velocity = stroke.shape.end - stroke.shape.start
            rate = Figure(abs(velocity), panel.unit)
            way = _said(sheet, _direction(velocity))
            return {"way": way, "rate": rate, "unit": Unit(panel.unit)}
    return {}


def _of_klein(sheet: Sheet) -> Sentence | None:
    """Return how the slider moves by Klein's figure alone, whose sides stand for its rates."""
    panel = next((panel for panel in sheet.panels if panel.name == "klein"), None)
    strokes = panel.strokes if panel else ()
    found = [each for each in strokes if each.kind == "result" and isinstance(each.shape, Curve)]
    sides = [each for each in found if each.link == found[-1].link and _value(each)]
    if panel is None or len(sides) != 2:
        return None
    row = next(row for row in sheet.rows if row.key == sides[0].link)
    senses = {each.panel: each.degrees for each in panel.turned}
    velocity, acceleration = (
        (each.shape.points[-1] - each.shape.points[0]) * ray(senses[order.panel])
        for each, order in zip(sides, (VELOCITY, ACCELERATION), strict=True)
        if isinstance(each.shape, Curve)
    )
    gains = (velocity * acceleration.conjugate()).real > 0.0
    rate = _value(sides[0])
    assert rate is not None
    parts: dict[str, SentencePart] = {
        "place": _place(sheet),
        "name": Noun(row.key, generic="slider"),
        "of": row.letters,
        "way": _said(sheet, _direction(velocity)),
        "rate": rate,
        "unit": Unit(rate.unit),
        "trend": _said(sheet, "answer gains" if gains else "answer loses"),
    }
    return _said(sheet, "answer moves", parts)


def _value(stroke: Stroke) -> Figure | None:
    """Return the rate that is calculated with a stroke; None where there is none."""
    found = stroke.said.parts.get("value") if isinstance(stroke.said, Sentence) else None
    return found if isinstance(found, Figure) else None


def _said(sheet: Sheet, phrase: str, parts: dict[str, SentencePart] | None = None) -> Sentence:
    return Sentence(phrase, parts or {}, voice=Voice(sheet.language, sheet.notation, sheet.names))


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
    turning = [row for row in rows if row.cells[_panel(row)][0].unit == "rad/s"]
    return next(iter((guided or turning or rows)[-1:]), None)


def _panel(row: Row) -> str:
    """Return the panel that measures the rate of a row; empty where there is none."""
    return next((name for name in _RATES if row.cells.get(name)), "")


def _moves(row: Row) -> bool:
    cells = row.cells.get(_panel(row), ())
    return bool(cells) and not cells[0].given


def _name(row: Row, slides: bool) -> Noun:
    """Return the name of a link, or of what slides, as its title has it."""
    said = row.title.said if isinstance(row.title, Text) else None
    name = said.name if isinstance(said, Noun) else row.key
    return Noun(name, generic="slider" if slides else "link")


def _place(sheet: Sheet) -> SentencePart:
    """Return where the driver stands: 60°, or x = 500 mm."""
    cells = (
        cell
        for row in sheet.rows
        if row.key == sheet.driver.row
        for name in ("position", "klein")
        for cell in row.cells.get(name, ())
        if cell.given and cell.symbol != row.letters
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
    name = _panel(row)
    rate = row.cells[name][0]
    if any(panel.picture == "views" for panel in sheet.panels):
        return ""
    if rate.unit == "rad/s":
        return _sense(rate.value)
    panel = sheet.panel(name)
    back = ray(next((e.degrees for e in panel.turned if e.panel == VELOCITY.panel), 0.0))
    for stroke in panel.strokes:
        if row.key in stroke.reveals and isinstance(stroke.shape, Arrow):
            way = (stroke.shape.end - stroke.shape.start) * back
            return _direction(way)
    return ""


def _sense(turning: float) -> str:
    """Return the phrase for the sense in which something turns."""
    return "counter-clockwise" if turning > 0.0 else "clockwise"


def _direction(way: complex) -> str:
    """Return the phrase for a direction on the paper."""
    if abs(way.real) >= abs(way.imag):
        return "right" if way.real > 0.0 else "left"
    return "up" if way.imag > 0.0 else "down"


def _trend(sheet: Sheet, rate: Cell, growth: tuple[Cell, ...]) -> str:
    """Return the phrase that says whether the output gains or loses speed."""
    if not growth or abs(growth[0].value) <= _REST * _largest(sheet, growth[0].unit):
        return "answer steady"
    return "answer gains" if (growth[0].value > 0.0) == (rate.value > 0.0) else "answer loses"


def _largest(sheet: Sheet, unit: str) -> float:
    cells = (cell for row in sheet.rows for cells in row.cells.values() for cell in cells)
    return max((abs(cell.value) for cell in cells if cell.unit == unit), default=0.0)
