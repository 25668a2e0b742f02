"""The painter's alphabet: a `Mark` is one path with its pen and fill, in pixels.

In come points as complex numbers (pixels, y up, origin at the lower left corner of the frame),
out go vertices and codes as matplotlib's renderers take them; matplotlib itself is not needed.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
Codes = NDArray[np.uint8]

MOVE, LINE, CURVE, CLOSE = 1, 2, 4, 79  # the codes of matplotlib.path.Path


@dataclass(frozen=True, slots=True)
class Pen:
    """The line along a path; ``width`` and ``dash`` are in pixels."""

    ink: str
    width: float
    dash: tuple[float, ...] = ()
    cap: Literal["butt", "round"] = "butt"
    join: Literal["miter", "round"] = "miter"


@dataclass(frozen=True, slots=True, eq=False)
class Letter:
    """One letter of a line of text: its outline and advance, and where it stands, all in ems.

    ``face`` and ``text`` say which letter it is, ``size`` is less than 1 for a small one.
    """

    face: str
    text: str
    vertices: Points
    codes: Codes
    advance: float
    at: complex
    size: float


@dataclass(frozen=True, slots=True, eq=False)
class Setting:
    """What a path of letters says: the letters, where their line starts, and an em in pixels."""

    letters: tuple[Letter, ...]
    at: complex
    size: float


@dataclass(frozen=True, slots=True, eq=False)
class Mark:
    """One path: stroked with ``pen``, filled with the colour ``fill``, or both.

    ``text`` is there where the path is text, for files that know letters.
    """

    vertices: Points
    codes: Codes
    pen: Pen | None = None
    fill: str | None = None
    alpha: float = 1.0
    text: Setting | None = None

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Left, bottom, right and top of all that the mark can touch."""
        pad = 2.0 + (self.pen.width if self.pen else 0.0)
        left, bottom = self.vertices.min(axis=0)
        right, top = self.vertices.max(axis=0)
        return left - pad, bottom - pad, right + pad, top + pad

    def moved(self, by: complex) -> Mark:
        """Return the mark shifted."""
        shifted: Points = self.vertices + np.array([by.real, by.imag])
        text = replace(self.text, at=self.text.at + by) if self.text else None
        return replace(self, vertices=shifted, text=text)


def _points(points: Sequence[complex]) -> Points:
    return np.array(points, dtype=np.complex128).view(np.float64).reshape(-1, 2)


def polyline(points: Sequence[complex], pen: Pen, alpha: float = 1.0) -> Mark:
    """Return an open line through ``points``."""
    codes = np.full(len(points), LINE, dtype=np.uint8)
    codes[0] = MOVE
    return Mark(_points(points), codes, pen, None, alpha)


def segments(pairs: Iterable[tuple[complex, complex]], pen: Pen, alpha: float = 1.0) -> Mark:
    """Return separate straight lines as one mark."""
    ends = [end for pair in pairs for end in pair]
    codes = np.tile(np.array([MOVE, LINE], dtype=np.uint8), len(ends) // 2)
    return Mark(_points(ends), codes, pen, None, alpha)


def polygon(
    points: Sequence[complex],
    fill: str | None = None,
    pen: Pen | None = None,
    alpha: float = 1.0,
    hole: Sequence[complex] = (),
) -> Mark:
    """Return a closed shape, with a hole where one is given (wound the other way)."""
    vertices: list[complex] = []
    codes: list[int] = []
    for ring in (points, hole):
        if ring:
            vertices += [*ring, ring[0]]
            codes += [MOVE, *[LINE] * (len(ring) - 1), CLOSE]
    return Mark(_points(vertices), np.array(codes, dtype=np.uint8), pen, fill, alpha)


def arc_points(centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    """Return the Bézier points of an arc, degrees; accurate to 1e-4 of the radius."""
    pieces = max(1, math.ceil(abs(sweep) / 45.0))
    step = math.radians(sweep) / pieces
    pull = 4.0 / 3.0 * math.tan(step / 4.0)
    points: list[complex] = []
    spoke = cmath.rect(radius, math.radians(start))
    points.append(centre + spoke)
    for _ in range(pieces):
        ahead = spoke * cmath.exp(1j * step)
        points += [centre + spoke * (1 + 1j * pull), centre + ahead * (1 - 1j * pull)]
        points.append(centre + ahead)
        spoke = ahead
    return points


def arc(
    centre: complex, radius: float, start: float, sweep: float, pen: Pen, alpha: float = 1.0
) -> Mark:
    """Return an open circular arc, degrees."""
    points = arc_points(centre, radius, start, sweep)
    codes = np.full(len(points), CURVE, dtype=np.uint8)
    codes[0] = MOVE
    return Mark(_points(points), codes, pen, None, alpha)


def disc(
    centre: complex, radius: float, fill: str, pen: Pen | None = None, alpha: float = 1.0
) -> Mark:
    """Return a filled circle."""
    points = arc_points(centre, radius, 0.0, 360.0)
    codes = np.full(len(points) + 1, CURVE, dtype=np.uint8)
    codes[0], codes[-1] = MOVE, CLOSE
    return Mark(_points([*points, points[0]]), codes, pen, fill, alpha)
