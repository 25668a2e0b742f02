"""Sheets from older files, which did not state their facts: what drives them, and their bodies.

The missing facts are derived from the strokes.  This is the only place where the meaning of a
stroke is guessed from its letters.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from vad.strokes.sheet import (
    Arrow,
    Block,
    Body,
    Coincidence,
    Dot,
    Driver,
    Guide,
    Panel,
    Plate,
    Ride,
    Row,
    Sheet,
    Stroke,
    driver_of,
)
from vad.strokes.vector_equations import NOTHING

#: How the symbols of angles and of their rates begin.
_TURNING = ("θ", "ω", "α")
#: A bar ends beneath its block where they are so near, as a share of its length.
_CLOSE = 1e-9


def with_facts(sheet: Sheet) -> Sheet:
    """Return a sheet with its driver, the bodies of its mechanism and what coincides."""
    panels = tuple(_with_facts(panel) for panel in sheet.panels)
    lower = {panel.name: panel.below.unit for panel in panels if panel.below}
    rows = tuple(_with_halves(row, lower) for row in sheet.rows)
    return replace(sheet, panels=panels, rows=rows, driver=_driver(rows, panels))


def _with_halves(row: Row, lower: Mapping[str, str]) -> Row:
    """Return a row in which cells with the unit of the lower polygon count as measured there."""
    cells = {
        name: tuple(replace(cell, below=cell.unit == lower.get(name)) for cell in found)
        for name, found in row.cells.items()
    }
    return replace(row, cells=cells)


def _driver(rows: Sequence[Row], panels: Sequence[Panel]) -> Driver:
    """Return the driver, whose cells are given."""
    for row in rows:
        given = [cell for cells in row.cells.values() for cell in cells if cell.given]
        if given:
            return driver_of(row.key, given[0].symbol.startswith(_TURNING), rows, panels)
    return Driver()


def _with_facts(panel: Panel) -> Panel:
    below = panel.below and _with_facts(panel.below)
    bodies = tuple(_bodies(panel)) if panel.picture == "skeleton" else ()
    return replace(panel, bodies=bodies, coincident=tuple(_coincident(panel)), below=below)


def _bodies(panel: Panel) -> Iterator[Body]:
    """Yield the bodies that are drawn, the frame first."""
    points: dict[str | None, list[str]] = {None: []}
    rides: dict[str | None, list[Ride]] = {}
    for stroke in panel.strokes:
        match stroke.shape:
            case Arrow(tail=tail, head=head):
                points.setdefault(stroke.link, []).extend((tail, head))
            case Plate(letters=letters):
                points.setdefault(stroke.link, []).extend(letters)
            case Block():
                points.setdefault(stroke.link, []).append(stroke.label)
                on, ride = _ride(panel, stroke, stroke.shape)
                rides.setdefault(on, []).append(ride)
            case _ if stroke.kind == "fixed" or stroke.part.which == "fixed":
                points[None].append(stroke.label)
    for row, letters_of in points.items():
        yield Body(row, tuple(dict.fromkeys(letters_of)), tuple(rides.get(row, ())))


def _ride(panel: Panel, stroke: Stroke, block: Block) -> tuple[str | None, Ride]:
    """Return on which body a block slides, and along what."""
    for other in panel.strokes:
        if isinstance(other.shape, Guide) and other.part.of == stroke.part.of:
            slot = other.shape.side is None
            return other.link if slot else None, Ride(stroke.name, other.name, slot)
    bar = _bar_under(panel, block)
    return block.on, Ride(stroke.name, bar.name if bar else None)


def _bar_under(panel: Panel, block: Block) -> Stroke | None:
    """Return the bar that ends beneath a block."""
    for other in panel.strokes:
        bar = other.shape
        if not isinstance(bar, Arrow) or other.link != block.on:
            continue
        if abs(block.at - bar.end) <= _CLOSE * abs(bar.end - bar.start):
            return other
    return None


def _coincident(panel: Panel) -> Iterator[Coincidence]:
    """Yield what lies under a pin, what stands still, and the ends of vectors without length."""
    if panel.picture == "skeleton":
        for stroke in panel.strokes:
            if isinstance(stroke.shape, Block) and stroke.shape.on:
                under = _under(panel, stroke.shape) - {stroke.label}
                yield from (Coincidence((stroke.label, letter), "under") for letter in under)
    elif panel.picture == "vectors" and panel.strokes:
        drawn = (stroke.shape for stroke in panel.strokes)
        lengths = (abs(each.end - each.start) for each in drawn if isinstance(each, Arrow))
        nothing = NOTHING * max(lengths, default=0.0)
        shapes = (stroke.shape for stroke in panel.zeros)
        arrows = [shape for shape in shapes if isinstance(shape, Arrow)]
        zero = [(each.tail, each.head) for each in arrows if abs(each.end - each.start) <= nothing]
        pole, at_rest = panel.strokes[0], len(panel.strokes) == 1
        came = set() if at_rest else {head for _, head in zero}
        fixed = tuple(letter for letter in pole.label.split(",") if letter not in came)
        if pole.kind == "pole" and len(fixed) > 1:
            yield Coincidence(fixed, "fixed")
        for pair in dict.fromkeys(zero):
            if pair[0] != pair[1]:
                yield Coincidence(pair, "zero")


def _under(panel: Panel, block: Block) -> set[str]:
    """Return the letters of the points that lie under the pin of a block."""
    bar = _bar_under(panel, block)
    found = {bar.shape.head} if bar and isinstance(bar.shape, Arrow) else set()
    dots = [(s.label, s.shape.at) for s in panel.strokes if isinstance(s.shape, Dot)]
    near = _CLOSE * max((abs(at) for _, at in dots), default=0.0)
    return found | {letter for letter, at in dots if abs(at - block.at) <= near}
