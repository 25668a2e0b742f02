"""Where the views of a mechanism in space stand, so that they have room in every pose."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from vad.kinematics.motion import solve
from vad.kinematics.reach import closing_range
from vad.strokes.space.scene import SceneInSpace, Script
from vad.strokes.space.view import round_share
from vad.words import Language

#: The largest length of a bar in its own view, as a share of the height of the other two views; the
#: gap between views.
TALLEST, GAP = 0.6, 0.14


class Corners(NamedTuple):
    """The lower left and the upper right corner of all that a view shows."""

    low: complex
    high: complex

    @property
    def size(self) -> complex:
        """The width and the height."""
        return self.high - self.low


class Layout(NamedTuple):
    """Where a lower view and a third one stand beside an upper view.

    The lower view stands by ``drop`` below the upper one.  A bar begins at ``place`` in the third
    view, which is drawn ``share`` times as large.
    """

    drop: float
    place: complex
    share: float


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
    spots = np.array(np.broadcast_arrays(*places))
    seen = spots[:, np.isfinite(spots).all(axis=0)]
    return Corners(
        complex(seen.real.min(), seen.imag.min()), complex(seen.real.max(), seen.imag.max())
    )


def beside(upper: Corners, lower: Corners, third: Corners, length: float) -> Layout:
    """Return where a lower view and, to the right of both, the view of a bar stand.

    Parameters
    ----------
    upper, lower
        The corners of both views, before the lower one is moved down.
    third
        The corners of the view of the bar, which begins at zero.
    length
        The length of the bar.
    """
    right = max(upper.high.real, lower.high.real)
    size = max(upper.size.real, lower.size.imag)
    drop = lower.high.imag - upper.low.imag + GAP * size
    low, high = lower.low.imag - drop, upper.high.imag
    share = round_share(TALLEST * (high - low) / length)
    left = right + 2.2 * GAP * size
    middle = 0.5 * (high + low) - 0.5 * share * (third.low + third.high).imag
    return Layout(drop, complex(left - share * third.low.real, middle), share)


def _script(motion: Any) -> Script:
    return SceneInSpace(motion, Language("en")).script
