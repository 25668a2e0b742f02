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
from vad.kinematics.space.ball_solver import BallSolver

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
    """

    def __init__(self, motion: Motion[Any, Any, Any]) -> None:
        solver = motion.solver
        assert isinstance(solver, BallSolver)
        self.motion = motion
        self.d, self.y = np.array(solver.closure.d), np.array(solver.closure.y)

    def at(self, letter: str) -> Any:
        """Return where a point is."""
        return self.motion.point(letter).position

    def front(self, vector: Any) -> Any:
        """Return a vector as it is seen along D's axis, from its end."""
        return vector[..., 0] + 1j * (vector @ self.y)

    def top(self, vector: Any) -> Any:
        """Return a vector as it is seen along A's axis, from its end."""
        return vector[..., 0] + 1j * vector[..., 1]

    def third(self, vector: Any) -> Any:
        """Return a vector as the third view sees it."""
        return TILT * (self.depth(vector, self.along) + 1j * self.depth(vector, self._across))

    def depth(self, vector: Any, axis: Any = None) -> Any:
        """Return how far a vector leads out of the paper of the third view, or along an axis."""
        return np.sum(vector * (self.outward if axis is None else axis), axis=-1)

    @cached_property
    def along(self) -> Any:
        """The unit vector from B to C."""
        return _unit(self.at("C") - self.at("B"))

    @cached_property
    def path(self) -> Any:
        """The unit vector along C's path, as the rocker turns counter-clockwise."""
        return _unit(np.cross(self.d, self.at("C") - self.at("D")))

    @cached_property
    def outward(self) -> Any:
        """The unit vector out of the paper of the third view, to the side of D's axis."""
        across = np.cross(self.along, self.path)
        flat = np.linalg.norm(across, axis=-1, keepdims=True) < 1e-12  # BC lies along the path
        across = np.where(flat, self.d - self.along * (self.along @ self.d)[..., None], across)
        side = np.sign(across @ self.d)[..., None]
        return _unit(np.where(side < 0.0, -across, across))

    @cached_property
    def _across(self) -> Any:
        return np.cross(self.outward, self.along)


def _unit(vector: Any) -> Any:
    return vector / np.linalg.norm(vector, axis=-1, keepdims=True)


@lru_cache(maxsize=64)
def layout(mechanism: Mechanism) -> Layout:
    """Return where the views of a mechanism stand: they have room in every pose."""
    ranges = [np.linspace(low, high, SAMPLES) for low, high in closing_range(mechanism)]
    motion = solve(mechanism, angle=np.concatenate(ranges))
    seen = Seen(motion)
    closed = motion.assembled
    points = {letter: seen.at(letter)[closed] for letter in "ABCD"}
    front = np.concatenate([seen.front(each) for each in points.values()])
    top = np.concatenate([seen.top(each) for each in points.values()])
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
