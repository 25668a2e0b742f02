"""In which order the strokes of a sheet are told."""

from __future__ import annotations

from typing import NamedTuple

from vad.strokes.sheet import Panel, Sheet

#: The panel after which inertia forces are told.
BEFORE_INERTIA = "acceleration"


class Told(NamedTuple):
    """A stroke as it is told.

    Attributes
    ----------
    half, number
        Its panel and its number there, from 0.
    chapter
        The panel with which it is told.
    """

    half: Panel
    number: int
    chapter: str


def telling(sheet: Sheet) -> tuple[Told, ...]:
    """Return all strokes in the order in which they are told.

    That is panel after panel; inertia forces, which stand on the mechanism, follow from the
    accelerations, and are told after them.
    """
    found: list[Told] = []
    later: list[Told] = []
    waits = any(panel.name == BEFORE_INERTIA for panel in sheet.panels)
    for panel in sheet.panels:
        for half in panel.halves:
            begun = half.find(half.resumes) if waits else None
            early = len(half.strokes) if begun is None else begun
            found += [Told(half, number, panel.name) for number in range(early)]
            rest = range(early, len(half.strokes))
            later += [Told(half, number, BEFORE_INERTIA) for number in rest]
        if panel.name == BEFORE_INERTIA:
            found += later
            later = []
    return (*found, *later)
