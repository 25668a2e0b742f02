"""The task of a problem sheet in words: what is given, what is to be drawn and to be found."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from vad import gate
from vad.strokes.given import Pieces, given, owned, phrased, tabled
from vad.strokes.sheet import Cell, Sheet
from vad.words import Language, TextPiece

#: The most letters of a task of one's own; a page may have room for fewer.
LONGEST = 400


def checked(name: str, text: object) -> str:
    """Return a task of one's own without spaces about it.

    Raises
    ------
    vad.errors.InputError
        For one that is no line of text, is empty, or is too long for any page.
    """
    return gate.filled(name, text, LONGEST)


def task(sheet: Sheet, blank: Collection[str], more: Sequence[Pieces] = ()) -> tuple[Pieces, ...]:
    """Return the task in words, the longest form first.

    The longest one begins with the values that are given, and with ``more`` dimensions, for which
    the title has no room.  The next ones leave out the values that stand in the table, too, and
    refer to the drawing for such dimensions.  The last one leaves out what is to be found.
    """
    language = Language(sheet.language)
    panels = [panel for panel in sheet.panels if panel.name in blank]
    cells = [
        cell
        for row in sheet.rows
        for panel in panels
        for cell in owned(row, row.cells.get(panel.name, ()))
    ]
    named = [_panel(language, panel.name, panel.title) for panel in panels]
    drawn = _listed(language, [(TextPiece(each),) for each in named])
    found = list(dict.fromkeys(_symbol(cell) for cell in cells if not cell.given))
    short = phrased(language, "task draw", panels=drawn)
    asked = _listed(language, found)
    middle = phrased(language, "task", panels=drawn, found=asked) if found else short
    listed, every = tabled(sheet), list(dict.fromkeys(given(sheet)))
    parts: list[list[Pieces]] = [[middle], [short]]
    if more:
        measured = phrased(language, "task measure")
        parts = [[measured, middle], [measured, short], *parts]
        further = phrased(language, "task more", given=_listed(language, more))
        parts.insert(0, [further, middle])
    first, untabled = parts[0], [each for each in every if each not in listed]
    if untabled:
        values = phrased(language, "task given", given=_listed(language, untabled))
        parts = [[values, *each] for each in parts]
    if listed:
        values = phrased(language, "task given", given=_listed(language, every))
        parts.insert(0, [values, *first])
    return tuple(map(_joined, parts))


def _joined(parts: Sequence[Pieces]) -> Pieces:
    """Return sentences with spaces between them."""
    found = list(parts[0])
    for part in parts[1:]:
        found += [TextPiece(" "), *part]
    return tuple(found)


def _panel(language: Language, name: str, title: str) -> str:
    """Return what a student draws in a panel; its title where no phrase names it."""
    phrase = f"task {name}"
    try:
        return language.say(phrase)
    except KeyError:
        return title


def _symbol(cell: Cell) -> Pieces:
    return (TextPiece(cell.symbol, "symbol"),)


def _listed(language: Language, items: Sequence[Pieces]) -> Pieces:
    """Return items with commas between them, and a word before the last."""
    first: list[TextPiece] = []
    for item in items[:-1]:
        first += [TextPiece(", ")] if first else []
        first += item
    return phrased(language, "and", first=tuple(first), last=items[-1]) if first else items[-1]
