"""The results in one quarter of a page: one row per link or slide, which is the legend too.

The rows of a sheet become entries in columns, whose heads have the units.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from vad.plan.geometry import Rect
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, bold, roman, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.strokes.sheet import Cell, Row, Sheet
from vad.words import Language
from vad.written import MINUS, THIN_SPACE, with_unit

HEAD_SIZE = 0.031
FIRST_GAP = 0.0535
ROW_PITCH = 0.050
GROUP_GAP = 0.0755
COLUMN_PITCH = 0.146
COLUMN_GAP = 0.022
LEAST_SQUEEZE = 0.85  # of the type
LEAST_TYPE = 0.021
FIRST_HEAD = 0.042  # from the top
SHORT_KEY = 0.7  # of the key's length, where columns need room
SIZE = 0.0335
NAME_GAP = 0.0125
KEY_RISE = 0.0068
GIVEN_SIZE = 0.028
#: The units of ω and α.
TURNING = ("rad/s", "rad/s²")
DROP = 0.006  # of a line to write on, below the baseline
LEAST_NUMBER = 2.0  # the room of a number behind its symbol, in type sizes: four digits

#: Round arrows behind the numbers of rates.
ANTICLOCKWISE = "\N{ANTICLOCKWISE OPEN CIRCLE ARROW}"
CLOCKWISE = "\N{CLOCKWISE OPEN CIRCLE ARROW}"

_WHOLE = re.compile(rf"[{MINUS}\d{THIN_SPACE}]*")

#: Sets a cell's number in type.
Figures = Callable[[Cell], Runs]
#: Tells the name of a row.
Naming = Callable[[Row], Runs]


@dataclass(frozen=True, slots=True)
class _Fit:
    """How the columns share the width.

    ``type`` is a factor on all sizes, ``key`` is the key's length, ``rights`` are where the
    numbers end; ``naming`` tells the names of rows: without numbers, or by letters alone, where
    there is no room.
    """

    type: float
    key: float
    rights: list[float]
    naming: Naming


class Quarter:
    """The table of a page with its panels in a grid, or ``rows`` of it.

    Parameters
    ----------
    entries
        What stands in it.
    area
        Where it stands.
    names
        The panels, in the order of its columns.
    rows
        The rows that it has.
    squeeze
        The most of its full height that it takes.
    """

    def __init__(
        self,
        entries: Entries,
        area: Rect,
        names: list[str],
        rows: Sequence[Row],
        squeeze: float = 1.0,
    ) -> None:
        self._entries, self._area, self._names, self._rows = entries, area, names, rows
        self._groups = _grouped(rows, self._names)
        gaps = [_depth(group, names) for group in self._groups]
        self._squeeze = min(squeeze, self._area.height / need(rows, names))
        self._fit = self._fitted(max(self._squeeze, LEAST_SQUEEZE))
        self._heads: list[float] = []
        self._baselines: list[float] = []
        y = self._area.top - FIRST_HEAD * self._squeeze
        for group, gap in zip(self._groups, gaps, strict=True):
            self._heads.append(y)
            first = y - FIRST_GAP * self._squeeze
            y = first - (gap * ROW_PITCH + GROUP_GAP) * self._squeeze
            for row in group:
                self._baselines.append(first)
                first -= (1 + _extras(row, self._names)) * ROW_PITCH * self._squeeze

    @property
    def right(self) -> float:
        """Where its last column ends."""
        return self._fit.rights[-1]

    @property
    def head(self) -> float:
        """The baseline of its first heads."""
        return self._heads[0]

    def frame(self, legend: bool = True) -> list[Mark]:
        """Return the heads with their rules, keys and names, and above these what grey means.

        That stands there only if there is room.
        """
        area, fit = self._area, self._fit
        marks = self._legend() if legend else []
        for group, head in zip(self._groups, self._heads, strict=True):
            for name, right in zip(self._names, fit.rights, strict=True):
                at, size = complex(self._head_end(group, name, right), head), HEAD_SIZE * fit.type
                marks.append(_right(self._quantities(group, name), at, size, "notes"))
            y = head - 0.0135 * self._squeeze
            marks.append(line([complex(area.left, y), complex(fit.rights[-1], y)], "hairline"))
        for row, baseline in zip(self._rows, self._baselines, strict=True):
            at, size = complex(area.left, baseline), SIZE * fit.type
            marks += self._entries.name(row, at, fit.key, size, fit.type, fit.naming)
        return [mark for mark in marks if not isinstance(mark.shape, Lettering) or mark.shape.runs]

    def cells(self, index: int, row: Row, panel: str, new: bool) -> list[Entry]:
        """Return the numbers of a row in a panel's column, one below the other."""
        right, size = self._fit.rights[self._names.index(panel)], SIZE * self._fit.type
        found: list[Entry] = []
        for depth, cell in enumerate(row.cells.get(panel, ())):
            baseline = self._baselines[index] - depth * ROW_PITCH * self._squeeze
            dressed, role = self._entries.dressed, self._entries.role(cell)
            value = dressed(cell, new, self._written(cell, row, panel))
            end = right
            if not depth:  # numbers stand with their decimal points one below the other
                end -= self._tail(panel, self._group(row)) * self._fit.type - after_point(
                    value, size
                )
            number = _right(value, complex(end, baseline), size, role)
            left, symbol = self._left(panel), []
            if depth:
                sign = dressed(cell, new, _sign(cell))
                most = right - self._left(panel) - width(sign, size)
                left = right - max(width(value, size), min(LEAST_NUMBER * size, most))
                symbol.append(_right(sign, complex(left, baseline), size, role))
            found.append(Entry(tuple(symbol), number, left, right))
        return found

    def _head_end(self, group: list[Row], name: str, right: float) -> float:
        """Return where the head of a column ends, which is at ``right``.

        Its middle is above that of the column's numbers, of which round arrows are no part.
        """
        kind, tail = self._fit.type, self._tail(name, group)
        numbers = self._numbers(name, group, turns=False)
        bare = max((after_point(runs, SIZE) for runs in numbers), default=tail)
        middle = right - (tail - bare + (self._whole(name, group) + bare) / 2) * kind
        wide = width(self._quantities(group, name), HEAD_SIZE * kind)
        return max(min(middle + wide / 2, right), self._left(name) + wide)

    def _legend(self) -> list[Mark]:
        group, name = self._groups[0], self._names[0]
        wide = width(self._quantities(group, name), HEAD_SIZE * self._fit.type)
        end = self._head_end(group, name, self._fit.rights[0])
        room = end - wide - COLUMN_GAP - self._area.left
        own = self._entries.legend_width
        return self._entries.legend(self._area.left + own + 1j * self.head) if own <= room else []

    def _left(self, name: str) -> float:
        """Return where the column of a panel begins."""
        number, fit = self._names.index(name), self._fit
        if number:
            return fit.rights[number - 1] + COLUMN_GAP * fit.type
        return fit.rights[0] - self._widest(name) * fit.type

    def _fitted(self, most: float) -> _Fit:
        """Return columns that never touch, for all numbers, and that are no wider than needed.

        Where they need room, first the columns draw together, then the key is cut short, then
        all type shrinks alike; where that is not enough, the numbers of bodies go from the names,
        and then their words.
        """
        area, rows = self._area, self._rows
        key = full = self._entries.key
        wide = [self._widest(name) + COLUMN_GAP for name in self._names]
        under = self._under_names() - wide[0] + COLUMN_GAP - NAME_GAP - SHORT_KEY * full
        namings = (self._entries.heading, _called, lettered)
        for naming in namings:
            name = max([under, *(width(naming(row), SIZE) for row in rows)])
            content = NAME_GAP + name + sum(wide)
            key = min(key, max(SHORT_KEY * full, area.width - content * most))
            kind = min(most, (area.width - key) / content)
            if kind >= LEAST_TYPE / SIZE:
                break
        pitches = [share * kind for share in wide]
        named = key + (NAME_GAP + name) * kind
        spare = area.width - named - sum(pitches)
        wanted = [max(0.0, COLUMN_PITCH - pitch) for pitch in pitches[1:]]
        share = min(1.0, spare / sum(wanted)) if sum(wanted) else 0.0
        natural = named + sum(max(COLUMN_PITCH, pitch) for pitch in pitches)
        rights = [area.left + min(area.width, natural)]
        for pitch, more in zip(reversed(pitches[1:]), reversed(wanted), strict=True):
            rights.insert(0, rights[0] - pitch - share * more)
        return _Fit(kind, key, rights, naming)

    def _widest(self, name: str) -> float:
        """Return the width of a column's heads and numbers, bold or not, at type 1."""
        heads = [self._quantities(group, name) for group in self._groups]
        further = (face for runs in self._beside(name) for face in (runs, bold(runs)))
        return max(
            *(self._whole(name, group) + self._tail(name, group) for group in self._groups),
            *(width(runs, SIZE) for runs in further),
            *(width(runs, HEAD_SIZE) for runs in heads),
        )

    def _whole(self, name: str, group: list[Row]) -> float:
        """Return the width before the decimal points of a column of a group, at type 1."""
        numbers = self._numbers(name, group)
        return max((width(runs, SIZE) - after_point(runs, SIZE) for runs in numbers), default=0.0)

    def _tail(self, name: str, group: list[Row]) -> float:
        """Return the width behind the decimal points of a column of a group, at type 1."""
        return max((after_point(runs, SIZE) for runs in self._numbers(name, group)), default=0.0)

    def _numbers(self, name: str, group: list[Row], turns: bool = True) -> list[Runs]:
        """Return the first numbers of the rows of a group in a column, bold or not.

        Without ``turns`` they have no round arrows.
        """
        rows = [row for row in group if row.cells.get(name)]
        numbers = [self._written(row.cells[name][0], row, name, turns) for row in rows]
        return [face for runs in numbers for face in (runs, bold(runs))]

    def _group(self, row: Row) -> list[Row]:
        """Return the rows that share a head with a row."""
        return next(group for group in self._groups if row in group)

    def _under_names(self) -> float:
        """Return the width of the further cells of the first column, which begin below names."""
        name = self._names[0]
        further = [
            _sign(cell) + self._written(cell, row, name)
            for row in self._rows
            for cell in row.cells.get(name, ())[1:]
        ]
        return max((width(runs, SIZE) for runs in further), default=0.0)

    def _beside(self, name: str) -> list[Runs]:
        """Return the further cells of a column that have one beside them in the column before."""
        place = self._names.index(name)
        found: list[Runs] = []
        for row in self._rows:
            cells = row.cells.get(name, ())
            before = row.cells.get(self._names[place - 1], ()) if place else ()
            pairs = list(zip(cells, before, strict=False))[1:]
            found += [_sign(cell) + self._written(cell, row, name) for cell, _ in pairs]
        return found

    def _written(self, cell: Cell, row: Row, name: str, turns: bool = True) -> Runs:
        """Return the number of a cell, with its unit where the head has another one."""
        runs, unit = self._entries.figures(cell), self._entries.unit(cell)
        if unit != self._unit(self._group(row), name):
            runs += roman(with_unit("", unit))
        return runs + self._entries.turn(cell) if turns else runs

    def _unit(self, group: list[Row], name: str) -> str:
        """Return the unit in the head of a column: that of what is found, if anything is."""
        cells = [row.cells[name][0] for row in group if row.cells.get(name)]
        found = next((cell for cell in cells if not cell.given), cells[0] if cells else None)
        return self._entries.unit(found) if found else ""

    def _quantities(self, group: list[Row], name: str) -> Runs:
        """Return the head of a column: its quantities and their unit, nothing where it is empty."""
        cells = [row.cells[name][0] for row in group if row.cells.get(name)]
        if not cells:
            return ()
        quantities = list(dict.fromkeys(cell.quantity for cell in cells))
        return symbols(" / ".join(quantities)) + roman(", " + self._unit(group, name))


def _called(row: Row) -> Runs:
    """Return the name of a row in words, with its letters."""
    return roman(row.title + " ") + symbols(row.letters)


def lettered(row: Row) -> Runs:
    """Return the letters of a row."""
    return symbols(row.letters)


def _sign(cell: Cell) -> Runs:
    """Return the symbol before a further cell."""
    return symbols(cell.symbol) + roman(" = ")


def _right(runs: Runs, at: complex, size: float, role: str) -> Mark:
    """Return text that ends at ``at``."""
    return Mark(Lettering(runs, at - width(runs, size), size), role)


def need(rows: Sequence[Row], names: list[str]) -> float:
    """Return the height of rows in full."""
    groups = _grouped(rows, names)
    total = sum(FIRST_GAP + _depth(group, names) * ROW_PITCH for group in groups)
    return FIRST_HEAD + total + (len(groups) - 1) * GROUP_GAP + 0.012


def _depth(group: list[Row], names: list[str]) -> int:
    """Return how many lines a group takes below its first."""
    return len(group) + sum(_extras(row, names) for row in group) - 1


def _grouped(rows: Sequence[Row], names: list[str]) -> list[list[Row]]:
    """Return neighbouring rows that share a head: no column of theirs has two units."""
    groups: list[list[Row]] = []
    units: dict[str, str] = {}
    for row in rows:
        own = {name: row.cells[name][0].unit for name in names if row.cells.get(name)}
        if groups and all(units.get(name, unit) == unit for name, unit in own.items()):
            groups[-1].append(row)
        else:
            groups.append([row])
            units = {}
        units |= own
    return groups


def _extras(row: Row, names: list[str]) -> int:
    """Return how many lines a row takes below its first, which it has without a cell, too."""
    return max(
        (len(row.cells.get(name, ())) - 1 for name in names if row.cells.get(name)), default=0
    )


def figures(sheet: Sheet) -> Figures:
    """Return what sets the numbers of a sheet in type."""
    return lambda cell: roman(sheet.notation.cell(cell.value, cell.unit, cell.given)[0])


def after_point(runs: Runs, size: float) -> float:
    """Return the width of what stands behind the whole part of a number, its decimal point too."""
    whole = replace(runs[0], text=_WHOLE.match(runs[0].text)[0])  # type: ignore[index]
    return width(runs, size) - width((whole,), size)


def turn_sign(turns: Mapping[str, float], cell: Cell) -> str:
    """Return a round arrow that stands behind the number of a rate; nothing if none is to."""
    sign = turns.get(cell.symbol, 0.0)
    return f"\N{NO-BREAK SPACE}{ANTICLOCKWISE if sign > 0.0 else CLOCKWISE}" if sign else ""


def without_turn(runs: Runs) -> Runs:
    """Return the runs of a number without the round arrow behind it."""
    turns = bool(runs) and runs[-1].text.endswith((ANTICLOCKWISE, CLOCKWISE))
    return runs[:-1] if turns else runs


@dataclass(frozen=True, slots=True)
class Entry:
    """A cell on the page: its symbol, its number, and the room in which that may be written."""

    symbol: tuple[Mark, ...]
    number: Mark
    left: float
    right: float

    @property
    def marks(self) -> list[Mark]:
        """The symbol and the number."""
        return [*self.symbol, self.number]

    @property
    def blank(self) -> list[Mark]:
        """The symbol, and a line to write the number on."""
        assert isinstance(self.number.shape, Lettering)
        y = 1j * (self.number.shape.at.imag - DROP)
        return [*self.symbol, line([self.left + y, self.right + y], "writing line")]


@dataclass(frozen=True, slots=True)
class Entries:
    """The rows of a sheet, the length of a key, and what sets a number in type.

    ``numbers`` says whether the number of a link stands behind its name, not in every symbol.
    ``turns`` are the signs of the rates whose senses stand behind their numbers, by their symbols.
    """

    sheet: Sheet
    key: float
    figures: Figures
    numbers: bool
    turns: Mapping[str, float] = field(default_factory=dict)

    def name(
        self,
        row: Row,
        at: complex,
        key: float,
        size: float,
        shrink: float = 1.0,
        naming: Naming | None = None,
    ) -> list[Mark]:
        """Return the key line of a row and its name, which is its heading unless told."""
        number = next(i for i, other in enumerate(self.sheet.rows) if other.key == row.key)
        start = at + KEY_RISE * shrink * 1j
        name = (naming or self.heading)(row)
        ink = [line([start, start + key], "key", number)] if row.inked else []
        return [
            *ink,
            Mark(Lettering(name, at + key + NAME_GAP * shrink, size), "words"),
        ]

    def heading(self, row: Row) -> Runs:
        """Return the name of a row with its letters."""
        cells = next(filter(None, row.cells.values()), ())
        number = cells[0].body if cells and self.numbers else ""
        behind = roman(f" ({number})") if number not in ("", row.letters) else ()
        return _called(row) + behind

    def legend(self, end: complex) -> list[Mark]:
        """Return the legend that says what grey means: a given value; it ends at ``end``."""
        at = end - self.legend_width
        return [Mark(Lettering(runs, at, GIVEN_SIZE), "notes") for runs in self._grey()]

    def sense(self, cells: Iterable[Cell], end: complex, share: float = 1.0) -> list[Mark]:
        """Return what says in which sense rates are positive, if cells have any; it ends there."""
        if not any(cell.unit in TURNING for cell in cells):
            return []
        said = Language(self.sheet.language).say("legend sense")
        runs = roman(f"{ANTICLOCKWISE}\N{NO-BREAK SPACE}{said}")
        size = GIVEN_SIZE * share
        return [Mark(Lettering(runs, end - width(runs, size), size), "notes")]

    @property
    def legend_width(self) -> float:
        """The width of the legend of grey, 0 where there is none."""
        return sum(width(runs, GIVEN_SIZE) for runs in self._grey())

    def _grey(self) -> Iterator[Runs]:
        """Yield what says that grey values are given, if any are."""
        cells = (cell for row in self.sheet.rows for each in row.cells.values() for cell in each)
        if any(cell.given for cell in cells):
            yield roman(Language(self.sheet.language).say("legend"))

    def role(self, cell: Cell) -> Literal["notes", "words"]:
        """Return the role of a cell's type: given values are grey."""
        return "notes" if cell.given else "words"

    def turn(self, cell: Cell) -> Runs:
        """Return the sense of a rate that has no arrow on its link."""
        return roman(turn_sign(self.turns, cell))

    def unit(self, cell: Cell) -> str:
        """Return the unit in which a cell's number is written."""
        return self.sheet.notation.cell_unit(cell.value, cell.unit, cell.given)[1]

    def dressed(self, cell: Cell, new: bool, runs: Runs) -> Runs:
        """Return the runs of a cell, bold where it is new."""
        return bold(runs) if new and not cell.given else runs
