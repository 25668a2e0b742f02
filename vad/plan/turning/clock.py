"""The clock of a quick return, and the limits of a driver that swings: a line above the mechanism.

In come a cycle and the course of the driver, out go marks.
"""

from __future__ import annotations

from vad.lecture.cycle import Course, Cycle
from vad.plan.geometry import Rect
from vad.plan.lettering.glyphs import fitted, width
from vad.plan.lettering.runs import Runs, roman
from vad.plan.marks import Lettering, Mark
from vad.strokes.notation import Notation
from vad.strokes.sheet import Sheet
from vad.words import Language
from vad.written import typeset, with_unit

SIZE, LEAST = 0.030, 0.020
SPACE = 0.9  # between its parts, in type sizes
BASELINE = 0.032  # below the panel's upper edge
HEIGHT = 0.042  # of the line


class Clock:
    """What is said above the mechanism: the ways of a quick return, or the ends of a swing.

    Attributes
    ----------
    height
        What it takes of the panel, 0 where there is nothing to be said.
    """

    def __init__(self, cycle: Cycle, course: Course, sheet: Sheet, room: Rect) -> None:
        self._back = cycle.back
        say = Language(sheet.language).say
        if cycle.back:
            part = cycle.back[1] - cycle.back[0]
            words = [
                f"{say('forward')} {_degrees(1.0 - part)}",
                f"{say('return')} {_degrees(part)}",
                f"{say('ratio')} {typeset(f'{cycle.ratio:.2f}', sheet.notation.point)}",
            ]
        elif course.swing:
            phrase = "swings" if sheet.driver.turns else "slides"
            row = next(row for row in sheet.rows if row.key == cycle.driver)
            unit, notation = cycle.place.unit, sheet.notation
            low, high = (written_end(end, unit, notation) for end in course.ends)
            words = [say(phrase, part=f"{row.title} {row.letters}", low=low, high=high)]
        else:
            words = []
        self.height = HEIGHT if words else 0.0
        self._texts = _set(words, room)

    def marks(self, share: float | None = None) -> list[Mark]:
        """Return the line; the way that is run through at a share of the cycle is dark."""
        if self._back is None or share is None:
            return [Mark(text, "notes") for text in self._texts]
        returns = (share - self._back[0]) % 1.0 < self._back[1] - self._back[0]
        roles = ("notes", "words", "notes") if returns else ("words", "notes", "notes")
        return [Mark(text, role) for text, role in zip(self._texts, roles, strict=True)]


def _set(words: list[str], room: Rect) -> list[Lettering]:
    """Return the words on one line, in a type that fits."""
    parts: list[Runs] = [roman(text) for text in words]
    gaps = SPACE * SIZE * max(len(parts) - 1, 0)
    size = fitted(tuple(run for part in parts for run in part), SIZE, LEAST, room.width - gaps)
    found, left = [], room.left
    for part in parts:
        found.append(Lettering(part, complex(left, room.top - BASELINE), size))
        left += width(part, size) + SPACE * size
    return found


def _degrees(share: float) -> str:
    return with_unit(typeset(f"{360.0 * share:.0f}"), "°")


def written_end(value: float, unit: str, notation: Notation) -> str:
    """Write where a driver turns back."""
    if unit == "°":
        return notation.quantity(value, unit)
    return notation.quantity(float(f"{value:.4g}"), unit, given=True)
