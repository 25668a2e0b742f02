"""What stands beside the large panel of a scene: the equation in work, and the rows of its loop.

The strokes of a panel are told in parts: a part for each of its loops, or for each of its
equations.  Of a part its equation is shown, and the rows of the results that its strokes concern.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from types import MappingProxyType

from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Item, Level, Span
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Fading, Lettering, Mark, line
from vad.plan.page.changing import measuring
from vad.plan.page.heads import REMARK_SIZE, Piece, pieces, type_width
from vad.plan.page.quarter import NAME_GAP, Entries, figures, lettered
from vad.plan.scene_layout import WORK
from vad.plan.sketch import Sketch
from vad.strokes.diagram import ACCELERATION, VELOCITY
from vad.strokes.sentences import pieces_of
from vad.strokes.sheet import Cell, Equation, Panel, Row, Sheet
from vad.written import with_unit

EQUATION = 0.038
LEAST_EQUATION = 0.030
SIZE = 0.0285
#: From one line to the next, in type sizes; from the words to a rule.
EQUATION_PITCH, ROW_PITCH, REMARK_PITCH, GAP = 1.32, 1.5, 1.35, 0.034
#: The most rows of the results.
MOST = 5
BETWEEN = 0.022  # name, cells
TIGHT = 0.76  # of the type, for which two cells stand side by side
SHORT_KEY = 0.7  # of the key's length
#: At the end of a rate's flight its number comes in its row: shares of the flight, and of ink.
ARRIVING = ((0.9, 0.0), (1.0, 1.0))
#: Meanwhile the number in whose place it comes goes.
LEAVING = ((0.8, 1.0), (0.9, 0.0))
#: What is given comes and goes so when it is used: shares of its stroke.
USED, LEFT = ((0.1, 0.0), (0.2, 1.0)), ((0.0, 1.0), (0.1, 0.0))
#: The panel whose results another one needs.
NEEDS = {ACCELERATION.panel: VELOCITY.panel}


@dataclass(frozen=True, slots=True)
class Part:
    """Strokes of a half of a panel that are told of one loop, from ``first`` to before ``end``."""

    half: Panel
    first: int
    end: int
    equations: tuple[Equation, ...]

    def rows(self, sheet: Sheet) -> list[Row]:
        """Return the rows that they concern; what they measure comes first, if there are many."""
        strokes = self.half.strokes[self.first : self.end]
        measured = {name for stroke in strokes for name in stroke.reveals}
        used = measured | {stroke.link for stroke in strokes}
        rows = [row for row in sheet.rows if row.key in used]
        kept = sorted(rows, key=lambda row: row.key not in measured)[:MOST]
        return [row for row in rows if row in kept]


def parts(panel: Panel) -> list[Part]:
    """Return the parts of a panel, in the order in which they are told."""
    found = []
    for half in panel.halves:
        ends = [_last(half, each) + 1 for each in half.equations]
        begins = {0, *half.loops[1:]}
        for number in ends[:-1]:
            # The rest of a loop belongs to its equation.
            after = min((each for each in half.loops if each >= number), default=number)
            begins.add(after if len(half.loops) >= len(ends) else number)
        cuts = [*sorted(each for each in begins if each < len(half.strokes)), len(half.strokes)]
        for first, end in pairwise(cuts):
            own = tuple(
                each
                for each, last in zip(half.equations, ends, strict=True)
                if first < last <= end or (last == 0 and first == 0)
            )
            found.append(Part(half, first, end, own))
    return found


def _last(half: Panel, equation: Equation) -> int:
    """Return the number of the last stroke that draws a term; −1 if none does."""
    names = {term.stroke for term in (*equation.left, *equation.right)} - {None}
    return max((half.find(name) or 0 for name in names if name), default=-1)


def in_work(
    sheet: Sheet,
    panel: Panel,
    sketches: Mapping[str, Sketch],
    room: Rect,
    key: float,
    flies: bool = False,
    turns: Mapping[str, float] = MappingProxyType({}),
) -> Iterator[Item]:
    """Yield what stands in ``room`` while a panel is drawn, each part until the next is begun.

    Where what is found ``flies`` to its link, it stands in its row when it is there.  ``turns`` are
    the rates whose senses stand behind their numbers, as in the whole table.
    """
    told = parts(panel)
    begun = [0, *(sketches[each.half.name].setting.during(each.first) for each in told[1:])]
    for part, span in zip(told, zip(begun, [*begun[1:], FOREVER], strict=True), strict=True):
        words = _Words(sheet, panel, sketches, room, SHORT_KEY * key, part, span, flies, turns)
        # What was measured before the rows came to stand here is not new in them.
        yield from (item for item in words.items() if item.since < item.until)


@dataclass(frozen=True, slots=True)
class _Words:
    """The words of one part, which show for a ``span`` of beats."""

    sheet: Sheet
    panel: Panel
    sketches: Mapping[str, Sketch]
    room: Rect
    key: float
    part: Part
    span: Span
    flies: bool
    turns: Mapping[str, float]

    def items(self) -> Iterator[Item]:
        """Yield them from the top down, all of them smaller where they would not fit.

        The sense in which rates are positive is left out there; the whole sheet says it, too.
        """
        remark, equation, rows = self._remark(), self._equation(), self._rows()
        size = min(EQUATION, self.room.width / max(map(type_width, equation), default=1.0))
        high = [
            *(REMARK_PITCH * REMARK_SIZE for _ in remark),
            *(EQUATION_PITCH * size for _ in equation),
            *(ROW_PITCH * SIZE for _ in rows.lines),
            2 * GAP,
        ]
        share = min(1.0, self.room.height / sum(high))
        says_sense = sum(high) + ROW_PITCH * SIZE <= self.room.height
        y = self.room.top
        if remark or equation:
            yield self._rule(y)
        for runs in remark:
            y -= REMARK_PITCH * REMARK_SIZE * share
            at = complex(self.room.left, y)
            yield self.item(Mark(Lettering(runs, at, REMARK_SIZE * share), "notes"))
        for each in equation:
            y -= EQUATION_PITCH * size * share
            yield from self._terms(each, complex(self.room.left, y), size * share)
        if rows.lines:
            y -= GAP * share * bool(remark or equation)
            yield self._rule(y)
            yield from rows.items(y, share, says_sense)

    def item(self, *marks: Mark, since: int = 0, until: int = FOREVER, name: str = "") -> Item:
        """Return what shows between two beats, while the part is told."""
        first, last = self.span
        return Item(name, WORK, Level.LABEL, marks, max(since, first), min(until, last))

    def _rule(self, y: float) -> Item:
        ends = complex(self.room.left, y), complex(self.room.left + self.room.width, y)
        return self.item(line(ends, "hairline"))

    def _remark(self) -> list[Runs]:
        said = self.panel.remark
        return list(wrap(pieces_of(said), REMARK_SIZE, self.room.width)) if said else []

    def _equation(self) -> list[list[Piece]]:
        """Return the lines of the equations: a long one goes on with its equals sign."""
        found: list[list[Piece]] = []
        for equation in self.part.equations:
            own = pieces(equation, self.part.half.name)
            if type_width(own) * EQUATION <= self.room.width:
                found.append(own)
                continue
            left = pieces(Equation(equation.left, ()), self.part.half.name)
            for side in (left, own[len(left) :]):
                found += self._wrapped(side)
        return found

    def _wrapped(self, side: Sequence[Piece]) -> Iterator[list[Piece]]:
        """Yield a side of an equation in lines, each of which begins with its sign."""
        now: list[Piece] = []
        for number, piece in enumerate(side):
            ahead = side[number : number + 2] if piece.term is None else [piece]
            if now and type_width([*now, *ahead]) * LEAST_EQUATION > self.room.width:
                yield now
                now = []
            now.append(piece)
        if now:
            yield now

    def _terms(self, line: Sequence[Piece], at: complex, size: float) -> Iterator[Item]:
        setting = self.sketches[self.part.half.name].setting
        for number, piece in enumerate(line):
            at += piece.space * size if number else 0.0
            text, term = Lettering(piece.runs, at, size), piece.term
            row = setting.row(term.link) if term else None
            at += width(piece.runs, size)
            if term is None or term.stroke is None:
                yield self.item(Mark(text, "term", row))
                continue
            inked = setting.after(setting.panel.number(term.stroke))
            name = setting.panel.full(term.stroke)
            yield self.item(Mark(text, "pending term", row), until=inked, name=name)
            yield self.item(Mark(text, "term", row), since=inked, name=name)

    def _rows(self) -> _Rows:
        entries = Entries(self.sheet, self.key, figures(self.sheet), False, self.turns)
        return _Rows(self, entries)


@dataclass(frozen=True, slots=True)
class _Cell:
    """A cell of a row, with the stroke that measures it and the beat from which it shows."""

    cell: Cell
    text: Runs
    bold: Runs
    name: str
    since: int


class _Rows:
    """The rows of a part: names on the left, and their cells beside them.

    What the panel needs of another one stands in a column before its own cells.  If there is no
    room for two columns, it stands in their place, until they are measured, or used if they are
    given.
    """

    def __init__(self, words: _Words, entries: Entries) -> None:
        self._words, self._entries = words, entries
        panel, rows = words.panel.name, words.part.rows(words.sheet)
        needed = NEEDS.get(panel, "")
        self._shown = [(row, [self._cells(row, needed), self._cells(row, panel)]) for row in rows]
        inner, before = words.room.width, words.key + NAME_GAP + BETWEEN
        columns = [
            max((width(c.bold, SIZE) for _, both in self._shown for c in both[side]), default=0.0)
            for side in (0, 1)
        ]
        pair, either = sum(columns) + BETWEEN * all(columns), max(columns)
        names = max((width(entries.heading(row), SIZE) for row in rows), default=0.0)
        letters = max((width(symbols(row.letters), SIZE) for row in rows), default=0.0)
        ways = [(name, cells) for cells in (pair, either) for name in (names, letters)]
        known = {row.letters for row in rows}
        if len(known) < len(rows) or "" in known:  # letters alone would name none of them
            ways = [(names, pair), (names, either)]
        fits = (way for way in ways if (before + sum(way)) * TIGHT <= inner)
        name, cells = next(fits, ways[-1])
        self._named, self._together = name == names, cells == pair
        self._tab = before + name
        self._second = columns[0] + BETWEEN if columns[0] and self._together else 0.0
        self.type = min(1.0, inner / (self._tab + cells))
        self.lines = [row for row, both in self._shown for _ in range(max(1, *map(len, both)))]

    def _cells(self, row: Row, name: str) -> list[_Cell]:
        words, found = self._words, []
        if not any(panel.name == name for panel in words.sheet.panels):
            return []
        for half, cells in words.sheet.panel(name).measures(row):
            stroke, since = measuring(words.sketches, half, row, cells) if cells else ("", 0)
            for cell in cells:
                number = self._entries.figures(cell)
                unit = roman(with_unit("", self._entries.unit(cell)))
                text = symbols(f"{cell.symbol} = ") + number + unit + self._entries.turn(cell)
                heavy = self._entries.dressed(cell, True, text)
                found.append(_Cell(cell, text, heavy, stroke, since))
        return found

    def _later(self, row: Row, cells: Sequence[_Cell]) -> list[_Cell]:
        """Return the cells of a row; those that are given show when their component is drawn."""
        part, setting = self._words.part, self._words.sketches[self._words.part.half.name].setting
        drawn = (
            setting.during(number)
            for number, stroke in enumerate(part.half.strokes)
            if stroke.kind == "known" and stroke.link == row.key
            if stroke.component in ("tangential", "sliding")
        )
        used = next(drawn, FOREVER)
        return [each if each.name else replace(each, since=used) for each in cells]

    def items(self, top: float, share: float, says_sense: bool) -> Iterator[Item]:
        """Yield the rows below a height, by a share smaller in all, and the positive sense."""
        words, size, pitch = self._words, SIZE * min(share, self.type), ROW_PITCH * SIZE * share
        shrink, naming = size / SIZE, None if self._named else lettered
        y = top - pitch
        for row, (needed, measured) in self._shown:
            own = self._later(row, measured) if needed and not self._together else measured
            at = complex(words.room.left, y)
            key = words.key * shrink
            yield words.item(*self._entries.name(row, at, key, size, shrink, naming))
            first = at + self._tab * shrink
            until = FOREVER if self._together else min((c.since for c in own), default=FOREVER)
            follows = next((each.name for each in own if each.since == until), "")
            for number, cell in enumerate(needed):
                place = first - 1j * number * pitch
                yield from self._shows(cell, place, size, until)
                if words.flies and until < FOREVER:
                    text, role = Lettering(cell.text, place, size), self._entries.role(cell.cell)
                    mark = Mark(text, role, growth=Fading(LEAVING if follows else LEFT))
                    yield words.item(mark, since=until, until=until + 1, name=follows)
            for number, cell in enumerate(own):
                place = first + self._second * shrink - 1j * number * pitch
                yield from self._shows(cell, place, size)
            y -= pitch * max(1, len(needed), len(own))
        right = words.room.left + words.room.width
        if says_sense:
            cells = (each.cell for _, both in self._shown for own in both for each in own)
            yield from map(words.item, self._entries.sense(cells, complex(right, y), share))

    def _shows(self, each: _Cell, at: complex, size: float, until: int = FOREVER) -> Iterator[Item]:
        """Yield a cell, in bold while its stroke has just measured it."""
        words, role, since = self._words, self._entries.role(each.cell), each.since
        if each.name or (since and words.flies):
            growth = Fading(ARRIVING if each.name else USED) if words.flies else None
            text = each.bold if each.name else each.text
            new = Mark(Lettering(text, at, size), role, growth=growth)
            yield words.item(new, since=since, until=min(since + 1, until), name=each.name)
            since += 1
        mark = Mark(Lettering(each.text, at, size), role)
        yield words.item(mark, since=since, until=until, name=each.name)
