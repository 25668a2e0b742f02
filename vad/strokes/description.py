"""The sheet in words, for readers who cannot see it.

It is plain text for the metadata of PNG, and for ``<title>`` and ``<desc>`` of SVG.
"""

from __future__ import annotations

from vad.strokes.sheet import TWIST, Row, Sheet
from vad.words import Language


def title(sheet: Sheet) -> str:
    """Return the sheet's title and its subtitle with its parameters."""
    listed = ", ".join(parameters(sheet))
    colon = Language(sheet.language).say("colon")
    titles = " · ".join(filter(None, (sheet.title, sheet.subtitle)))
    return f"{titles}{colon}{listed}" if listed else titles


def parameters(sheet: Sheet) -> list[str]:
    """Return the parameters as the title has them: "crank 60 mm"; a twist with its length."""
    found: list[str] = []
    for name, value, unit in sheet.parameters:
        item = f"{name} {sheet.notation.quantity(value, unit if value else '', given=True)}"
        if name == TWIST and found:
            found[-1] += f" {item}"
        else:
            found.append(item)
    return found


def describe(sheet: Sheet) -> str:
    """Return what the panels show, step by step, and what was measured."""
    say = Language(sheet.language).say
    lines = [
        panel.title
        + say("colon")
        + " ".join(s.caption for half in panel.halves for s in half.strokes)
        for panel in sheet.panels
    ]
    rows = "; ".join(_row(row, sheet) for row in sheet.rows)
    lines.append(f"{say('results')}{say('colon')}{rows}.")
    return "\n".join(lines)


def _row(row: Row, sheet: Sheet) -> str:
    note = Language(sheet.language).say("given")
    cells = [cell for panel in sheet.panels for cell in row.cells.get(panel.name, ())]
    values = [
        f"{cell.symbol} = {sheet.notation.quantity(cell.value, cell.unit, cell.given)}"
        + (f" ({note})" if cell.given else "")
        for cell in cells
    ]
    return f"{row.title} {row.letters} " + ", ".join(values)
