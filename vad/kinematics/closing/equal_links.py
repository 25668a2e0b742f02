"""Links of equal length: the poses in which they copy the crank and the ground.

In a parallelogram the coupler stays parallel to the ground and the rocker to the crank.  In a kite,
and where the rod of a slider-crank is as long as its crank, C can stand still at A.  What stands
has no rates at all, so no sum may round them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from vad.kinematics.closing.closures import GroundedCrank
from vad.kinematics.linkage import Bar
from vad.kinematics.numbers import Number, select, select_vector, turned
from vad.kinematics.state import GROUND, Pose, Rates

# The link that is copied, and +1.0 along it or -1.0 against it.
Copy = tuple[str, float]


class EqualLinks:
    """What is unknown in a loop, where it is a copy of what is known.

    Parameters
    ----------
    crank
        The crank's pin.
    turns
        How the pin lies in the axes of the driven link, and the loop's own x axis in those of the
        ground, by the names of both.
    copies
        For each unknown bar what it copies.
    slide
        The slide that stands still, if one is unknown.
    applies
        Whether a pose is of this kind, by its pin's unit vector.
    """

    def __init__(
        self,
        crank: GroundedCrank,
        turns: Mapping[str, complex],
        copies: Mapping[Bar, Copy],
        slide: str | None,
        applies: Callable[[Number], Number],
    ) -> None:
        self._crank = crank
        (self._driver,) = turns.keys() - {GROUND}
        self._copies = {
            bar.link: (source, sense * turns[source]) for bar, (source, sense) in copies.items()
        }
        self._slide = slide
        self._applies = applies

    def _here(self, pose: Pose) -> Number:
        return self._applies(self._crank.pin(pose.unit[self._driver]))

    def place(self, pose: Pose) -> None:
        """Write what stands, and what turns with the crank, into the closed ``pose``."""
        here = self._here(pose)
        for link, (source, turn) in self._copies.items():
            copy = turned(pose.unit[source], turn)
            pose.unit[link] = select_vector(here, copy, pose.unit[link])
            pose.leaning.pop(link, None)
        if self._slide:
            pose.length[self._slide] = select(here, 0.0, pose.length[self._slide])

    def move(self, pose: Pose, rates: Rates) -> None:
        """Write their rates into ``rates``."""
        here = self._here(pose)
        for link, (source, _) in self._copies.items():
            rate = 0.0 if source == GROUND else rates.turning[source]
            rates.turning[link] = select(here, rate, rates.turning[link])
        if self._slide:
            rates.sliding[self._slide] = select(here, 0.0, rates.sliding[self._slide])


def equal_bars(
    crank: GroundedCrank, turns: Mapping[str, complex], side: float, sizes: Mapping[Bar, float]
) -> EqualLinks | None:
    """Return the copies of two bars r and q over the gap c + t·u, if there are any.

    There r·z - q·w = c + t·u, and one of z and w may be ±u, the other the ground's direction.
    """
    (driver,) = turns.keys() - {GROUND}
    (first, r), (second, q) = sizes.items()
    c, t = crank.c.real, crank.t
    along_ground, along_crank = _sign(c), _sign(t)
    kite = {first: (driver, along_crank), second: (GROUND, -along_ground)}
    parallel = {first: (GROUND, along_ground), second: (driver, -along_crank)}
    if (r, q) == (abs(t), abs(c)):
        sense = side * along_ground * along_crank
        copies = kite
    elif (r, q) == (abs(c), abs(t)):
        sense = -side * along_ground * along_crank
        copies = parallel
    else:
        return None
    return EqualLinks(crank, turns, copies, None, lambda u: sense * u.imag > 0.0)


def equal_rod(
    crank: GroundedCrank, turns: Mapping[str, complex], side: float, rod: Bar, r: float, slide: str
) -> EqualLinks | None:
    """Return the copy of a rod as long as the crank, on a line through the crank's pivot.

    There the rod folds back onto the crank.
    """
    (driver,) = turns.keys() - {GROUND}
    if crank.c != 0.0 or r != abs(crank.t):
        return None
    sense = _sign(crank.t)
    copies = {rod: (driver, sense)}
    return EqualLinks(crank, turns, copies, slide, lambda u: side * sense * u.real > 0.0)


def _sign(value: float) -> float:
    return 1.0 if value > 0.0 else -1.0
