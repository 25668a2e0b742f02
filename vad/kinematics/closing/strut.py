"""A strut whose length is driven: its triangle and the angles in it, from lengths alone."""

from __future__ import annotations

from vad.kinematics.closing.closures import Triangle
from vad.kinematics.numbers import Number, nonzero


class Strut:
    """A driven length r and a bar q over a fixed gap: the triangle and the angle against r.

    Heron's factors lose nothing where the two sides that may be long are subtracted first.
    """

    def __init__(self, gap: complex, q: float) -> None:
        self.gap = gap
        self.q = q
        self.length = abs(gap)
        self._short_bar = self.length > 2.0 * q
        self.short_gap = q > 2.0 * self.length
        self._power = (q - self.length) * (q + self.length)

    def triangle(self, r: Number) -> Triangle:
        """Return the triangle."""
        f, q = self.length, self.q
        if self._short_bar:
            e = r - f
            factors = (q + e), (q - e), (f - q) + r
        elif self.short_gap:
            e = r - q
            factors = (q - f) + r, (f - e), (f + e)
        else:
            e = q - f
            factors = (r + e), (q + f) - r, (r - e)
        side, near, far = factors
        return Triangle(self.gap, f * f, side * (r + (q + f)), near * far, r, q)

    def projections(self, r: Number) -> tuple[Number, Number]:
        """Return the projections of q and of the gap on r."""
        f, q, twice = self.length, self.q, nonzero(2.0 * r)
        if self._short_bar:
            at_arm = (q * q + (r - f) * (r + f)) / twice
            return at_arm, r - at_arm
        return (r * r + self._power) / twice, ((r - q) * (r + q) + f * f) / twice
