"""The results as a table: one row per link or slide, with the line that is its key.

In come the sheet and the sketches of its panels, out goes HTML.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice, pairwise, repeat

from vad.page.ink import Inker, when
from vad.page.wording import Words
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.marks import line
from vad.plan.page.changing import measuring
from vad.plan.page.columns import CLEAR, EQUALS, VALUES, Columns, alike
from vad.plan.page.entries import SIZE
from vad.plan.page.table import table as laid_out
from vad.strokes.sheet import Cell, Panel, Row
from vad.words import Language
from vad.written import with_unit

PADDING = 0.25 * SIZE  # behind a symbol


def table(plan: Plan, key: float, inker: Inker, words: Words) -> str:
    """Return the results of a sheet; ``key`` is the length of the line before a row's name."""
    sheet, say = plan.sheet, Language(plan.sheet.language).say
    values = values_of(plan, key)
    heads = "".join(f'<th scope="col">{words.of(roman(p.title))}</th>' for p in sheet.panels)
    rows = "".join(
        f'<tr role="row"><th scope="row" role="rowheader">{_key(number, key, inker)}'
        f"{words.of(roman(row.title + ' ') + symbols(row.letters))}</th>"
        + "".join(measured_cells(plan, panel, row, words, values) for panel in sheet.panels)
        + "</tr>"
        for number, row in enumerate(sheet.rows)
    )
    lefts = [place.drawing.left for place in plan.page.panels.values()]
    ends = [lefts[0], lefts[0] + values, *lefts[1:], plan.page.right]
    widths = [end - start for start, end in pairwise(ends)]
    columns = "".join(f'<col style="width:{100 * each / sum(widths):.2f}%">' for each in widths)
    legend = words.of(roman(say("legend"))) if _has_given(sheet.rows) else ""
    return (
        f'<table role="table"><caption class="unseen">{words.of(roman(say("results")))}</caption>'
        f'<colgroup>{columns}</colgroup><thead class="unseen"><tr><td></td>{heads}</tr></thead>'
        f'<tbody role="rowgroup">{rows}</tbody></table><p class="legend">{legend}</p>'
    )


def _key(number: int, key: float, inker: Inker) -> str:
    """Return the line of a row in its ink, on a view of its own."""
    mark = line([complex(0.0, 0.5), complex(key, 0.5)], "key", number)
    view = inker.view(Rect(0.0, 0.48, key, 0.52))
    return f'<svg class="key" viewBox="{view}" aria-hidden="true">{inker.mark(mark)}</svg>'


def values_of(plan: Plan, key: float) -> float:
    """Return how far behind the margin the first cells begin."""
    laid = laid_out(plan.sheet, plan.page, key)
    return laid.values if isinstance(laid, Columns) else VALUES


def measured_cells(plan: Plan, panel: Panel, row: Row, words: Words, values: float) -> str:
    """Return what a panel measures of a row, as one cell of the table.

    Where it has not the room, it leaves out units that the column has above, then it shrinks.
    """
    cells = row.cells.get(panel.name, ())
    room = plan.page.panels[panel.name].drawing.width
    room -= values if panel is plan.sheet.panels[0] else 0.0
    readings = [_reading(plan, cell) for cell in cells]
    need = _need(cells, readings)
    if need > room and alike(cells, panel.name, plan.sheet.rows):
        readings = [_reading(plan, cell, bare=True) for cell in cells]
        need = _need(cells, readings)
    small = f' style="font-size:{100 * room / need:.0f}%"' if need > room else ""
    written = map(_cell, cells, readings, repeat(words))
    halves = []
    for half, measured in panel.measures(row):
        _, since = measuring(plan.sketches[half.name].setting, row, measured)
        own = "".join(islice(written, len(measured)))
        halves.append(f"<div{when([(since, FOREVER)])}{small}>{own}</div>")
    whole = "".join(halves)
    return f'<td role="cell">{whole if len(halves) == 1 else f"<div>{whole}</div>"}</td>'


def _need(cells: Sequence[Cell], readings: Sequence[Runs]) -> float:
    """Return the width of cells side by side, as the style sheet sets them."""
    signs = [width(symbols(cell.symbol), SIZE) + PADDING for cell in cells]
    wide = sum(
        width(reading, SIZE) + max(EQUALS, sign)
        for reading, sign in zip(readings, signs, strict=True)
    )
    return wide + CLEAR * (len(cells) - 1)


def _cell(cell: Cell, reading: Runs, words: Words) -> str:
    symbol, value = words.of(symbols(cell.symbol)), words.of(reading, heavy=not cell.given)
    given = " given" if cell.given else ""
    return f'<span class="cell{given}"><span class="symbol">{symbol}</span>{value}</span>'


def _reading(plan: Plan, cell: Cell, bare: bool = False) -> Runs:
    notation = plan.sheet.notation
    number = notation.number(cell.value, cell.unit, cell.given)
    unit = "" if bare else notation.unit(cell.unit)
    return roman("= " + with_unit(number, unit).replace(" ", "\u00a0"))


def _has_given(rows: tuple[Row, ...]) -> bool:
    return any(c.given for row in rows for cells in row.cells.values() for c in cells)
