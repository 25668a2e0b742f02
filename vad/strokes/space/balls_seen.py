"""From where the ball-jointed four-bar is seen: along both axes, and in a view of its own.

The two views along the axes stand one above the other, for both have the common normal across the
page.  In the third view, to the right, BC and the path of C are both in true length.
"""

from __future__ import annotations

import cmath
import math
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from vad.kinematics.motion import solve
from vad.kinematics.reach import closing_range
from vad.kinematics.space.balls import BallSolver
from vad.kinematics.space.numbers import Vector3, added, cross, difference, dot, scaled, unit
from vad.strokes.space.body_rates import place

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.mechanisms.mechanism import Mechanism

#: The direction of BC in the third view.
TILT = cmath.exp(1j * math.radians(115.0))
#: What is left free between the views, of the larger of their sizes.
GAP = 0.14
#: Poses of a turn by which the views are laid out.
SAMPLES = 181
#: How much longer BC may be in the third view than it, of the height of the other two.
TALLEST = 0.6


class Layout(NamedTuple):
    """Where the views stand, the same in every pose of a mechanism.

    Attributes
    ----------
    drop
        How far the view along A's axis stands below that along D's.
    place
        Where B is in the third view, which is drawn ``share`` times as large.
    swing
        From where to where the rocker turns, in degrees.
    """

    drop: float
    place: complex
    share: float
    swing: tuple[float, float]


class Seen:
    """A motion of one pose or of many, as it is seen.

    Attributes
    ----------
    d, y
        The rocker's axis, and the direction across it that points up in the view along it.
    at
        Where the points are, by their letters.
    """

    def __init__(self, motion: Motion[Any, Any, Any]) -> None:
        solver = motion.solver
        assert isinstance(solver, BallSolver)
        self.motion = motion
        self.d, self.y = solver.closure.d, solver.closure.y
        self.at = {letter: place(motion, letter) for letter in "ABCD"}

    def front(self, vector: Vector3) -> Any:
        """Return a vector as it is seen along D's axis, from its end."""
        return vector[0] + 1j * dot(vector, self.y)

    def top(self, vector: Vector3) -> Any:
        """Return a vector as it is seen along A's axis, from its end."""
        return vector[0] + 1j * vector[1]

    def third(self, vector: Vector3) -> Any:
        """Return a vector as the third view sees it."""
        return TILT * (dot(vector, self.along) + 1j * dot(vector, self._across))

    def depth(self, vector: Vector3) -> Any:
        """Return how far a vector leads out of the paper of the third view."""
        return dot(vector, self.outward)

    @cached_property
    def along(self) -> Vector3:
        """The unit vector from B to C."""
        return unit(difference(self.at["C"], self.at["B"]))

    @cached_property
    def path(self) -> Vector3:
        """The unit vector along C's path, as the rocker turns counter-clockwise."""
        return unit(cross(self.d, difference(self.at["C"], self.at["D"])))

    @cached_property
    def outward(self) -> Vector3:
        """The unit vector out of the paper of the third view, to the side of D's axis."""
        across = cross(self.along, self.path)
        flat = 1.0 * (dot(across, across) < 1e-24)  # BC lies along the path
        upright = difference(self.d, scaled(dot(self.along, self.d), self.along))
        across = added(scaled(1.0 - flat, across), scaled(flat, upright))
        return unit(scaled(1.0 - 2.0 * (dot(across, self.d) < 0.0), across))

    @cached_property
    def _across(self) -> Vector3:
        return cross(self.outward, self.along)


@lru_cache(maxsize=64)
def layout(mechanism: Mechanism) -> Layout:
    """Return where the views of a mechanism stand: they have room in every pose."""
    ranges = [np.linspace(low, high, SAMPLES) for low, high in closing_range(mechanism)]
    motion = solve(mechanism, angle=np.concatenate(ranges))
    seen = Seen(motion)
    closed = motion.assembled
    front = np.concatenate([seen.front(each)[closed] for each in seen.at.values()])
    top = np.concatenate([seen.top(each)[closed] for each in seen.at.values()])
    right = max(front.real.max(), top.real.max())
    size = max(np.ptp(front.real), np.ptp(top.imag))
    drop = top.imag.max() - front.imag.min() + GAP * size
    height = front.imag.max() - (top.imag.min() - drop)
    coupler = mechanism.parameters()["coupler"]
    share = _round_share(TALLEST * height / coupler)
    reach = share * coupler
    middle = 0.5 * (front.imag.max() + top.imag.min() - drop) - 0.5 * reach * TILT.imag
    place = right + 2.2 * GAP * size - reach * TILT.real
    turned = np.unwrap(motion.link("rocker").angle[closed], period=360.0)
    swing = float(turned.min()), float(min(turned.max(), turned.min() + 360.0))
    return Layout(float(drop), complex(place, middle), share, swing)


def _round_share(most: float) -> float:
    """Return 1, or the half, fifth, tenth … that is not above ``most``."""
    power = 10.0 ** math.floor(math.log10(most))
    return min(1.0, next(each * power for each in (5.0, 2.0, 1.0) if each * power <= most))
