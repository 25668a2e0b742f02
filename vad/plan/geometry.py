"""Plane geometry on the page: y up, in page units."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

from vad.kinematics.symbol import is_symbolic

SHORTEST = 1e-9  # less than this is no length


@dataclass(frozen=True, slots=True)
class Rect:
    """A rectangle, y up."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """Right less left."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Top less bottom."""
        return self.top - self.bottom

    @property
    def centre(self) -> complex:
        """The middle."""
        return complex((self.left + self.right) / 2, (self.bottom + self.top) / 2)

    def moved(self, by: complex) -> Rect:
        """Return the rectangle shifted."""
        return Rect(
            self.left + by.real, self.bottom + by.imag, self.right + by.real, self.top + by.imag
        )

    def mapped(self, factor: float, shift: complex) -> Rect:
        """Return the rectangle with every point z at ``factor * z + shift``."""
        scaled = Rect(
            factor * self.left, factor * self.bottom, factor * self.right, factor * self.top
        )
        return scaled.moved(shift)

    def inside(self, by: float) -> Rect:
        """Return the rectangle less a margin."""
        return Rect(self.left + by, self.bottom + by, self.right - by, self.top - by)

    def holds(self, point: complex, slack: float = 0.0) -> bool:
        """Tell whether ``point`` lies inside, or outside by at most ``slack``."""
        return (
            self.left - slack <= point.real <= self.right + slack
            and self.bottom - slack <= point.imag <= self.top + slack
        )

    def stretch(self, at: complex, way: complex, inset: float = 0.0) -> tuple[float, float]:
        """Return how far a line through ``at`` may run back and forth inside.

        ``inset`` is kept from the lower and the upper edge.
        """
        low, high = -math.inf, math.inf
        for ahead, least, most, here in (
            (way.real, self.left, self.right, at.real),
            (way.imag, self.bottom + inset, self.top - inset, at.imag),
        ):
            if abs(ahead) > 1e-9:
                one, two = (least - here) / ahead, (most - here) / ahead
                low, high = max(low, min(one, two)), min(high, max(one, two))
        return low, high

    def clipped(self, start: complex, end: complex) -> tuple[complex, complex] | None:
        """Return the part of a straight stroke that lies inside, None if there is none."""
        first, last, span = 0.0, 1.0, end - start
        for way, low, high, at in (
            (span.real, self.left, self.right, start.real),
            (span.imag, self.bottom, self.top, start.imag),
        ):
            if abs(way) < 1e-9:
                if not low <= at <= high:
                    return None
                continue
            one, two = sorted(((low - at) / way, (high - at) / way))
            first, last = max(first, one), min(last, two)
        return (start + first * span, start + last * span) if first < last else None


def direction_of(start: complex, end: complex) -> complex:
    """Return the unit vector from ``start`` to ``end``, 0 where they coincide."""
    way = end - start
    if abs(way) <= SHORTEST:
        return 0j
    if is_symbolic(way):
        return way / abs(way)
    return cmath.rect(1.0, cmath.phase(way))


def normal_of(start: complex, end: complex) -> complex:
    """Return the unit vector across the line from ``start`` to ``end``, up where they coincide."""
    return 1j * (direction_of(start, end) or 1.0)


def bar_corners(start: complex, end: complex, wide: float) -> list[complex]:
    """Return the corners of a straight part from ``start`` to ``end``, ``wide`` across."""
    half = wide / 2 * 1j * direction_of(end, start)
    return [start + half, end + half, end - half, start - half]
