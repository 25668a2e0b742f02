"""The sheet in words, for readers who cannot see it.

In comes a sheet, out goes plain text for PNG metadata and for ``<title>`` and ``<desc>`` of SVG.
"""

from __future__ import annotations

from vad.diagrams.strokes import Row, Sheet
from vad.rendering.numbers import number, plain, with_unit
from vad.rendering.words import words


def title(sheet: Sheet) -> str:
    """Return the sheet's title with its parameters."""
    parameters = ", ".join(
        f"{name} {with_unit(plain(value), unit)}" for name, value, unit in sheet.parameters
    )
    return f"{sheet.title}: {parameters}" if parameters else sheet.title


def describe(sheet: Sheet) -> str:
    """Return what the panels show, step by step, and what was measured."""
    names = words(sheet.language)
    lines = [
        f"{names.panels[panel.name]}: " + " ".join(_ended(s.caption) for s in panel.strokes)
        for panel in sheet.panels
    ]
    lines.append(f"{names.results}: " + "; ".join(_row(row, sheet) for row in sheet.rows) + ".")
    return "\n".join(lines)


def _ended(caption: str) -> str:
    return caption if caption.endswith((".", "!", "?")) else caption + "."


def _row(row: Row, sheet: Sheet) -> str:
    given = words(sheet.language).given
    cells = [cell for panel in sheet.panels for cell in row.cells.get(panel.name, ())]
    values = [
        f"{cell.symbol} = {with_unit(number(cell), cell.unit)}"
        + (f" ({given})" if cell.given else "")
        for cell in cells
    ]
    return f"{row.title} {row.letters} " + ", ".join(values)
