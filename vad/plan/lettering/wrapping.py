"""Captions in lines: in come words and the room for them, out go lines of runs."""

from __future__ import annotations

import re
from collections.abc import Callable

from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs

# A number keeps its unit, and a sign what follows it.
_WORD = r"(?<![=×+⟂∥])(?:(?<![0-9⁰¹²³⁴⁵⁶⁷⁸⁹]) | (?!(?:mm|cm|km|m|in|ft|yd|rad)\b))"
#: Where lines may break, the best first: at last inside an equation, before a sign.
_BREAKS = (r"(?<=[:;]) ", r"(?<=[,:;]) ", rf"{_WORD}(?![=×+])", _WORD)


_TIE = "\N{NO-BREAK SPACE}"


def tied(text: str) -> str:
    """Return ``text`` with no-break spaces where it must not part.

    Examples
    --------
    >>> tied("60 mm, ⟂ AB").replace(_TIE, "~")
    '60~mm, ⟂~AB'
    """
    return " ".join(part.replace(" ", _TIE) for part in re.split(_WORD, text))


def wrap(text: str, setter: Callable[[str], Runs], size: float, room: float) -> list[Runs]:
    """Break ``text`` into as few lines as fit ``room``, evenly filled.

    They break at a colon or comma if they can, never between a number and its unit, and inside
    an equation only if it is longer than a line.
    """
    if width(setter(text), size) <= room:
        return [setter(text)]
    fewest = len(_lines(text, _WORD, setter, size, room))
    for breaks in _BREAKS:
        lines = _lines(text, breaks, setter, size, room)
        if len(lines) == fewest and all(width(setter(line), size) <= room for line in lines):
            break
    return [setter(line) for line in lines]


def _lines(
    text: str, breaks: str, setter: Callable[[str], Runs], size: float, room: float
) -> list[str]:
    """Return ``text`` in as few lines as it takes when it parts only at ``breaks``."""
    parts = re.split(breaks, text)
    widths = [width(setter(part), size) for part in parts]
    space = 0.25 * size
    total = sum(widths) + space * (len(parts) - 1)
    fewest = len(_filled(parts, widths, space, room))
    goals = [min(room, filled * total / fewest) for filled in (1.12, 1.2, 1.3, 1.4)]
    for goal in (*goals, room):
        lines = _filled(parts, widths, space, goal)
        if len(lines) == fewest:
            break
    return [" ".join(line) for line in lines]


def _filled(words: list[str], widths: list[float], space: float, goal: float) -> list[list[str]]:
    """Return the words in lines, each as long as ``goal`` allows."""
    lines: list[list[str]] = [[]]
    used = 0.0
    for word, wide in zip(words, widths, strict=True):
        if lines[-1] and used + space + wide > goal:
            lines.append([])
            used = 0.0
        used += wide + (space if lines[-1] else 0.0)
        lines[-1].append(word)
    return lines
