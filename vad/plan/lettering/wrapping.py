"""Captions in lines: in come words and the room for them, out go lines of runs."""

from __future__ import annotations

import re
from collections.abc import Callable

from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs

# Words part at a space, unless it stands between a number and its unit.
_BREAK = re.compile(r"(?<![0-9⁰¹²³⁴⁵⁶⁷⁸⁹]) | (?!(?:mm|cm|km|m|in|ft|yd|rad)\b)")


def wrap(text: str, setter: Callable[[str], Runs], size: float, room: float) -> list[Runs]:
    """Break ``text`` between words into as few lines as fit ``room``, evenly filled.

    A number stays with its unit.
    """
    words = _BREAK.split(text)
    widths = [width(setter(word), size) for word in words]
    space = 0.25 * size
    total = sum(widths) + space * (len(words) - 1)
    if total <= room:
        return [setter(text)]
    fewest = len(_filled(words, widths, space, room))
    goals = [min(room, filled * total / fewest) for filled in (1.12, 1.2, 1.3, 1.4)]
    for goal in (*goals, room):
        lines = _filled(words, widths, space, goal)
        if len(lines) == fewest:
            break
    return [setter(" ".join(line)) for line in lines]


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
