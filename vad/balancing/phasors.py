"""Direct and reverse cranks: the inertia forces of an engine as two vectors that turn.

The primary force of a piston is the sum of two vectors of half its size.  One turns with the crank,
the other with a crank that is its mirror image in the line of stroke and turns the other way.  The
secondary force is such a sum, too; its cranks turn twice as fast.  So all forces of one kind add up
to two vectors, and the end of their sum runs on an ellipse.

Source: R. S. Khurmi and J. K. Gupta, Theory of Machines, chapter 22, "direct and reverse cranks".
"""

from __future__ import annotations

import cmath
import math
from operator import mul
from typing import Any, NamedTuple

from vad.balancing.closing import NOTHING
from vad.kinematics.numbers import Number, is_array, positive, times


class Phasors(NamedTuple):
    """Two vectors that turn ``order`` times as fast as the crank, one with it, one against it.

    Attributes
    ----------
    order
        1 for primary, 2 for secondary forces.
    direct, reverse
        The vectors where the crank is at 0°; zero where only rounding is left.
    scale
        The sum of the sizes of all vectors of which they are sums.  What is very much smaller is
        rounding.
    """

    order: int
    direct: complex
    reverse: complex
    scale: float

    def at(self, crank: Number) -> Any:
        """Return the sum of both, for the crank's unit vector, or for an array of them."""
        product = mul if is_array(crank) else times
        turned = product(crank, crank) if self.order == 2 else crank
        return product(self.direct, turned) + product(self.reverse, turned.conjugate())

    @property
    def sizes(self) -> tuple[float, float]:
        """The sizes of both."""
        return abs(self.direct), abs(self.reverse)

    @property
    def largest(self) -> float:
        """The largest size of the sum over a turn."""
        return sum(self.sizes)

    @property
    def least(self) -> float:
        """The least size of the sum over a turn."""
        one, other = self.sizes
        apart = abs(one - other)
        return apart if apart > NOTHING * self.scale else 0.0

    @property
    def angles(self) -> tuple[float, ...]:
        """The crank's angles, in degrees, at which it is largest; none where it never changes."""
        return self._angles(0.0)

    @property
    def least_angles(self) -> tuple[float, ...]:
        """The crank's angles at which it is least; none where it never changes."""
        return self._angles(180.0)

    def _angles(self, aside: float) -> tuple[float, ...]:
        """Return where both stand at an angle to each other."""
        if 0.0 in self.sizes:
            return ()
        between = math.degrees(cmath.phase(self.reverse) - cmath.phase(self.direct)) + aside
        count = 2 * self.order
        found = ((between / count + 360.0 / count * each) % 360.0 for each in range(count))
        return tuple(sorted(positive(_rounded(each)) for each in found))


def _rounded(degrees: float) -> float:
    """Return an angle without the rounding of its last digits."""
    near = float(round(degrees, 6))
    return near if abs(near - degrees) < 1e-12 else degrees
