"""Sentences in lines: the pieces of a sentence become lines of runs that fit its room."""

from __future__ import annotations

import re

from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, said
from vad.words import TextPiece, text_of

# A number keeps its unit, and a sign what follows it.
_WORD = r"(?<![=×+⟂∥])(?:(?<![0-9⁰¹²³⁴⁵⁶⁷⁸⁹]) | (?!(?:mm|cm|km|m|in|ft|yd|rad)\b))"
#: Where lines may break, the best first: between sentences, at last inside an equation, before a
#: sign, and if it can be before one of equality.
_BREAKS = (
    r"(?<=\.) ",
    r"(?<=[:;]) ",
    r"(?<=[,:;]) ",
    rf"{_WORD}(?![=×+])",
    rf"{_WORD}(?![×+])",
    _WORD,
)
_TIE = "\N{NO-BREAK SPACE}"

Pieces = tuple[TextPiece, ...]
#: Where a stretch of a sentence begins and ends, in letters.
Stretch = tuple[int, int]


def tied(pieces: Pieces) -> Pieces:
    """Return a sentence with no-break spaces where no line may break.

    Examples
    --------
    >>> text_of(tied((TextPiece("60 mm, ⟂ AB"),))).replace(_TIE, "~")
    '60~mm, ⟂~AB'
    """
    text = text_of(pieces)
    bound = text.replace(" ", _TIE)
    for found in re.finditer(_WORD, text):
        bound = f"{bound[: found.start()]} {bound[found.end() :]}"
    start, new = 0, []
    for piece in pieces:
        end = start + len(piece.text)
        new.append(piece._replace(text=bound[start:end]))
        start = end
    return tuple(new)


def wrap(pieces: Pieces, size: float, room: float) -> list[Runs]:
    """Break a sentence into as few lines as fit ``room``, evenly filled.

    They break at a colon or comma if they can, never between a number and its unit, and inside
    an equation only if it is longer than a line.
    """
    return [said(cut(pieces, line)) for line in stretches(pieces, size, room)]


def stretches(pieces: Pieces, size: float, room: float) -> list[Stretch]:
    """Return where the lines of a sentence begin and end, as `wrap` breaks it."""
    if width(said(pieces), size) <= room:
        return [(0, len(text_of(pieces)))]
    fewest = len(_lines(pieces, _WORD, size, room))
    for breaks in _BREAKS:
        lines = _lines(pieces, breaks, size, room)
        wide = (width(said(cut(pieces, line)), size) for line in lines)
        if len(lines) == fewest and all(each <= room for each in wide):
            break
    return lines


def _lines(pieces: Pieces, breaks: str, size: float, room: float) -> list[Stretch]:
    """Return a sentence in as few lines as possible, with line breaks only at ``breaks``."""
    parts = _parts(text_of(pieces), breaks)
    widths = [width(said(cut(pieces, part)), size) for part in parts]
    space = 0.25 * size
    total = sum(widths) + space * (len(parts) - 1)
    fewest = len(_filled(parts, widths, space, room))
    goals = [min(room, filled * total / fewest) for filled in (1.12, 1.2, 1.3, 1.4)]
    for goal in (*goals, room):
        lines = _filled(parts, widths, space, goal)
        if len(lines) == fewest:
            break
    return lines


def _parts(text: str, breaks: str) -> list[Stretch]:
    """Return the stretches of a text between its breaks."""
    found = list(re.finditer(breaks, text))
    starts = [0, *(each.end() for each in found)]
    ends = [*(each.start() for each in found), len(text)]
    return list(zip(starts, ends, strict=True))


def cut(pieces: Pieces, stretch: Stretch) -> Pieces:
    """Return a stretch of a sentence; nothing of it where it ends before it begins."""
    start, end = stretch
    found, at = [], 0
    for piece in pieces:
        text = piece.text[max(start - at, 0) : max(end - at, 0)]
        if text:
            found.append(piece._replace(text=text))
        at += len(piece.text)
    return tuple(found)


def _filled(parts: list[Stretch], widths: list[float], space: float, goal: float) -> list[Stretch]:
    """Return the parts joined to lines, each as long as ``goal`` allows."""
    lines: list[Stretch] = []
    used = 0.0
    for (start, end), wide in zip(parts, widths, strict=True):
        if lines and used + space + wide <= goal:
            used += space + wide
            lines[-1] = lines[-1][0], end
        else:
            lines.append((start, end))
            used = wide
    return lines
