"""The page as a whole: its shape, and what a page unit is on screen or on paper.

Sizes are fractions of the page unit: the height of a page on a screen (less on a tall one), so that
pictures of 640 and of 2560 pixels look alike; on paper a fixed length.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.errors import one_of

_POINTS_PER_INCH = 72.0
_CENTIMETRE = _POINTS_PER_INCH / 2.54
#: The page unit on paper in points: labels have 12 points, vectors a width of 0.6 mm.
_PAPER_UNIT = 300.0
#: Printers leave the edge white: the board's own margin begins this far from it.
_PAPER_EDGE = 0.5 * _CENTIMETRE

#: Three panels stand side by side on a page of this shape: its width over its height.
NARROW = 1.5

_LANDSCAPE = {"A4": (297.0, 210.0), "A3": (420.0, 297.0), "letter": (279.4, 215.9)}
_MILLIMETRES = {
    **_LANDSCAPE,
    **{f"{name}-portrait": (width, height) for name, (height, width) in _LANDSCAPE.items()},
}


@dataclass(frozen=True, slots=True)
class Format:
    """The shape of a page.

    Attributes
    ----------
    width, height
        In page units, without the edge.
    unit
        Pixels of a screen, or points of paper, to a page unit.
    edge
        What stays white around it, in page units.
    centimetre
        Its length in page units on paper, where scales are round and stated; None on a screen.
    """

    width: float
    height: float
    unit: float
    edge: float = 0.0
    centimetre: float | None = None

    @property
    def narrow(self) -> bool:
        """Whether three panels have less room side by side than they need."""
        return self.width < NARROW * self.height

    @property
    def whole(self) -> float:
        """The unit of a page of this shape that is seen as a whole, in its own units."""
        return min(self.height, 0.75 * self.width)


def screen(size: tuple[float, float]) -> Format:
    """Return the format of a picture of so many pixels.

    Examples
    --------
    >>> screen((1280, 720)).unit, screen((640, 360)).width == screen((2560, 1440)).width
    (720.0, True)
    """
    unit = min(float(size[1]), 0.75 * size[0])
    return Format(size[0] / unit, size[1] / unit, unit)


def paper_names() -> list[str]:
    """Return the names of the sizes of paper, lying and upright.

    Examples
    --------
    >>> paper_names()
    ['A4', 'A3', 'letter', 'A4-portrait', 'A3-portrait', 'letter-portrait']
    """
    return list(_MILLIMETRES)


def paper(name: str) -> Format:
    """Return the format of a sheet of paper, which lies on its long side or stands upright.

    Raises
    ------
    vad.errors.UsageError
        If there is none of that name.

    Examples
    --------
    >>> a4 = paper("A4")
    >>> round((a4.width + 2 * a4.edge) * a4.unit, 2)
    841.89
    """
    sides = _MILLIMETRES[one_of("paper", name, _MILLIMETRES)]
    points = [side * _CENTIMETRE / 10.0 - 2.0 * _PAPER_EDGE for side in sides]
    width, height = (side / _PAPER_UNIT for side in points)
    return Format(width, height, _PAPER_UNIT, _PAPER_EDGE / _PAPER_UNIT, _CENTIMETRE / _PAPER_UNIT)
