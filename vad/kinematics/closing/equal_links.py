"""Links of equal length: the assembly in which they copy the crank and the ground.

In a parallelogram the coupler stays parallel to the ground and the rocker to the crank.  In a kite,
and where the rod of a slider-crank is as long as its crank, C can stand still at A.  What stands
has no rates at all, so no sum may round them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from vad.kinematics.closing.closures import GroundedCrank
from vad.kinematics.numbers import Number, dot, select, select_vector
from vad.kinematics.state import GROUND, Pose, Rates

# The link that is copied, and +1.0 along it or -1.0 against it.
Copy = tuple[str, float]


class EqualLinks:
    """What is unknown in a loop, where it is a copy of what is known.

    Parameters
    ----------
    driver
        The name of the driven crank.
    copies
        For each unknown link what it copies.
    slide
        The slide that stands still, if one is unknown.
    applies
        Whether a pose is of this kind, by its crank's unit vector.
    """

    def __init__(
        self,
        driver: str,
        copies: Mapping[str, Copy],
        slide: str | None,
        applies: Callable[[Number], Number],
    ) -> None:
        self._driver = driver
        self._copies = copies
        self._slide = slide
        self._applies = applies

    def place(self, pose: Pose) -> None:
        """Write what stands, and what turns with the crank, into the closed ``pose``."""
        here = self._applies(pose.unit[self._driver])
        for link, (source, sense) in self._copies.items():
            pose.unit[link] = select_vector(here, sense * pose.unit[source], pose.unit[link])
            pose.leaning.pop(link, None)
        if self._slide:
            pose.length[self._slide] = select(here, 0.0, pose.length[self._slide])

    def move(self, pose: Pose, rates: Rates) -> None:
        """Write their rates into ``rates``."""
        here = self._applies(pose.unit[self._driver])
        for link, (source, _) in self._copies.items():
            rate = 0.0 if source == GROUND else rates.turning[source]
            rates.turning[link] = select(here, rate, rates.turning[link])
        if self._slide:
            rates.sliding[self._slide] = select(here, 0.0, rates.sliding[self._slide])


def equal_bars(
    driver: str, side: float, crank: GroundedCrank, sizes: Mapping[str, float]
) -> EqualLinks | None:
    """Return the copies of two bars r and q over the gap c + t·u, if there are any.

    There r·z - q·w = c + t·u, and one of z and w may be ±u, the other the ground's direction.
    """
    (first, r), (second, q) = sizes.items()
    c, t = crank.c.real, crank.t
    along_ground, along_crank = _sign(c), _sign(t)
    kite = {first: (driver, along_crank), second: (GROUND, -along_ground)}
    parallel = {first: (GROUND, along_ground), second: (driver, -along_crank)}
    if (r, q) == (abs(t), abs(c)):
        turned = side * along_ground * along_crank
        copies = kite
    elif (r, q) == (abs(c), abs(t)):
        turned = -side * along_ground * along_crank
        copies = parallel
    else:
        return None
    return EqualLinks(driver, copies, None, lambda u: turned * u.imag > 0.0)


def parallelogram(
    driver: str, crank: GroundedCrank, sizes: Mapping[str, float]
) -> EqualLinks | None:
    """Return the copies of a parallelogram that stays one through its change points."""
    (first, r), (second, q) = sizes.items()
    c, t = crank.c.real, crank.t
    if (r, q) != (abs(c), abs(t)):
        return None
    copies = {first: (GROUND, _sign(c)), second: (driver, -_sign(t))}
    return EqualLinks(driver, copies, None, lambda u: u.imag == u.imag)


def equal_rod(
    driver: str, side: float, crank: GroundedCrank, rod: tuple[str, float], g: complex, slide: str
) -> EqualLinks | None:
    """Return the copy of a rod as long as the crank, on a line along g through the crank's pivot.

    There the rod folds back onto the crank.
    """
    link, r = rod
    if crank.c != 0.0 or r != abs(crank.t):
        return None
    sense = _sign(crank.t)
    return EqualLinks(
        driver, {link: (driver, sense)}, slide, lambda u: side * sense * dot(g, u) > 0.0
    )


def _sign(value: float) -> float:
    return 1.0 if value > 0.0 else -1.0
