"""Where the views of a mechanism in space stand, so that they have room in every pose."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from vad.kinematics.motion import solve
from vad.kinematics.reach import closing_range
from vad.strokes.space.scene import SceneInSpace, Script
from vad.words import Language

#: The gap between views, as a share of the larger one.
GAP = 0.14


class Corners(NamedTuple):
    """The lower left and the upper right corner of all that a view shows."""

    low: complex
    high: complex

    @property
    def size(self) -> complex:
        """The width and the height."""
        return self.high - self.low


class Layout(NamedTuple):
    """Where a lower view stands below an upper one, and a third view aside of it.

    The lower view stands by ``drop`` below the upper one.  The third one is moved by ``aside``
    along its lines of projection.
    """

    drop: float
    aside: float


def over_a_turn(mechanism: Any, poses: int) -> Script:
    """Return the script of so many poses, in equal steps of a turn.

    If the mechanism closes in none of them, they are those of `over_its_range`.
    """
    angles = np.linspace(0.0, 360.0, poses, endpoint=False)
    motion: Any = solve(mechanism, angle=angles)
    if not motion.assembled.any():  # it swings between two of these angles
        return over_its_range(mechanism, poses)
    return _script(motion)


def over_its_range(mechanism: Any, poses: int) -> Script:
    """Return the script of so many poses of every interval in which a mechanism closes."""
    ranges = [np.linspace(low, high, poses) for low, high in closing_range(mechanism)]
    return _script(solve(mechanism, angle=np.concatenate(ranges)))


def corners(places: Iterable[Any]) -> Corners:
    """Return the corners of the projections of points in many poses.

    Poses in which a point has no place are left out: those that do not close, and dead centres.
    """
    spots = _seen(places)
    return Corners(
        complex(spots.real.min(), spots.imag.min()), complex(spots.real.max(), spots.imag.max())
    )


def beside(upper: Iterable[Any], lower: Iterable[Any], third: Iterable[Any], way: Any) -> Layout:
    """Return where a lower view and a third one stand, so that no two are on each other.

    Parameters
    ----------
    upper, lower, third
        The projections of the points of each view in the same poses, before they are moved apart.
    way
        The direction of the lines from the upper view to the third one, as unit vectors.
    """
    spots = _seen((*(first := list(upper)), *(second := list(lower)), *third, way))
    above, below, laid = np.split(spots[:-1], [len(first), len(first) + len(second)])
    ways = spots[-1]
    high, low = corners(above), corners(below)
    gap = GAP * max(high.size.real, low.size.imag)
    along, beyond = (np.real(each * ways.conj()) for each in (above, laid))
    before = float((along.min(axis=0) - beyond.max(axis=0)).min()) - gap
    after = float((along.max(axis=0) - beyond.min(axis=0)).max()) + gap
    aside = before if -before < after else after
    moved = laid + aside * ways
    left = moved.real.max(axis=0) + gap < below.real.min(axis=0)
    right = moved.real.min(axis=0) - gap > below.real.max(axis=0)
    over = moved.imag.min(axis=0)[~(left | right)]
    floor = min(high.low.imag, float(over.min(initial=np.inf)))
    return Layout(low.high.imag - floor + gap, aside)


def _seen(places: Iterable[Any]) -> Any:
    """Return the places of points, a row each, in the poses in which all have one."""
    spots = np.array(np.broadcast_arrays(*places), dtype=complex)
    return spots[:, np.isfinite(spots).all(axis=0)]


def _script(motion: Any) -> Script:
    return SceneInSpace(motion, Language("en")).script
