"""Sheets of paper on which a student measures with a ruler: in comes a name, out goes a `Paper`.

A pixel of the board is then a point of the paper, and a centimetre stands for a round number of
each panel's unit.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.errors import unknown

_POINTS_PER_INCH = 72.0
CENTIMETRE = _POINTS_PER_INCH / 2.54
#: What sizes are fractions of: labels have 12 points, vectors a width of 0.6 mm.
UNIT = 300.0
#: Printers leave the edge white: the board's own margin begins this far from it.
EDGE = 0.5 * CENTIMETRE

_MILLIMETRES = {"A4": (297.0, 210.0), "A3": (420.0, 297.0), "letter": (279.4, 215.9)}


@dataclass(frozen=True, slots=True)
class Paper:
    """A sheet of paper that lies on its long side; ``size`` is width and height in points."""

    name: str
    size: tuple[float, float]

    @property
    def board(self) -> tuple[float, float]:
        """Width and height of the board within its edge."""
        return self.size[0] - 2.0 * EDGE, self.size[1] - 2.0 * EDGE


def paper_names() -> list[str]:
    """Return the names of the sizes of paper."""
    return list(_MILLIMETRES)


def load_paper(name: str) -> Paper:
    """Return the paper called ``name``.

    Raises
    ------
    vad.errors.UsageError
        If there is none of that name.

    Examples
    --------
    >>> [round(side, 2) for side in load_paper("A4").size]
    [841.89, 595.28]
    """
    if name not in _MILLIMETRES:
        raise unknown("paper", name, _MILLIMETRES)
    width, height = _MILLIMETRES[name]
    return Paper(name, (width * CENTIMETRE / 10.0, height * CENTIMETRE / 10.0))
