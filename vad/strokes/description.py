"""The sheet in words, for readers who cannot see it.

It is plain text for the metadata of PNG, and for ``<title>`` and ``<desc>`` of SVG.
"""

from __future__ import annotations

import re

from vad.strokes.sheet import TWIST, Row, Sheet
from vad.words import Language, TextPiece, text_of
from vad.written import LOW, with_unit

_POINT = re.compile(r"[A-Z]\d*")
#: Points, one or more, a coordinate of one, or the ratio of two lines, as a whole word.
_POINTS = re.compile(r"(?<!\S)(?:[A-Z]\d*)+(?:[xy]|/(?:[A-Z]\d*)+)?(?!\S)")


def title(sheet: Sheet) -> str:
    """Return the sheet's title and its subtitle with its parameters."""
    listed = ", ".join(map(text_of, parameters(sheet)))
    colon = Language(sheet.language).say("colon")
    titles = " · ".join(filter(None, (sheet.title, sheet.subtitle)))
    return f"{titles}{colon}{listed}" if listed else titles


def parameters(sheet: Sheet) -> list[tuple[TextPiece, ...]]:
    """Return the parameters as the title has them: "crank 60 mm"; a twist with its length.

    Points are symbols, as everywhere: ``AB``, ``O₄y``; the angle of a corner has its sign, ∠BAC.
    """
    found: list[tuple[TextPiece, ...]] = []
    for name, value, unit in sheet.parameters:
        number = sheet.notation.quantity(value, unit if value else "", given=True)
        item = (*_name(name, unit), TextPiece(f" {number}"))
        if name == TWIST and found:
            found[-1] += (TextPiece(" "), *item)
        else:
            found.append(item)
    return found


def _name(name: str, unit: str) -> tuple[TextPiece, ...]:
    """Return the name of a parameter, in which letters of points are symbols."""
    points = _POINTS.search(name)
    if not points:
        return (TextPiece(name),)
    letters, before, rest = points[0], name[: points.start()], name[points.end() :]
    corner = unit == "°" and letters == name and len(_POINT.findall(letters)) == 3
    before = "∠" if corner else before
    symbol = TextPiece(letters.translate(LOW), "symbol")
    return tuple(each for each in (TextPiece(before), symbol, TextPiece(rest)) if each.text)


def describe(sheet: Sheet) -> str:
    """Return what the panels show, step by step, and what was measured."""
    say = Language(sheet.language).say
    lines = [
        panel.title
        + say("colon")
        + " ".join(s.caption for half in panel.halves for s in half.strokes)
        for panel in sheet.panels
    ]
    rows = say("answer next").join(_row(row, sheet) for row in sheet.rows)
    lines.append(f"{say('results')}{say('colon')}{rows}.")
    return "\n".join(lines)


def _row(row: Row, sheet: Sheet) -> str:
    note = Language(sheet.language).say("given")
    cells = [cell for panel in sheet.panels for cell in row.cells.get(panel.name, ())]
    values = [
        f"{cell.symbol} = {with_unit(*sheet.notation.cell(cell.value, cell.unit, cell.given))}"
        + (f" ({note})" if cell.given else "")
        for cell in cells
    ]
    return f"{row.title} {row.letters} " + ", ".join(values)
