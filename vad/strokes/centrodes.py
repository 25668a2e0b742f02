"""Centrodes: the two curves on which a body rolls on another one, as far as a drawing shows them.

A centre runs through infinity where two lines become parallel on its way.  So a curve is cut where
it leaves the frame of the drawing, and goes on where it comes back.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.errors import UsageError, quoted
from vad.kinematics.bodies import FRAME
from vad.kinematics.centres import Centres, centres
from vad.kinematics.kennedy import Pair, kennedy_of
from vad.kinematics.motion import Motion, solve
from vad.kinematics.reach import closing_range
from vad.strokes.sheet import Curve

if TYPE_CHECKING:
    from vad.kinematics.kennedy import Kennedy
    from vad.mechanisms.mechanism import Mechanism

#: The panel that shows them.
PANEL = "centres"
#: In how many poses the centre is found: one for each degree of a turn.
SAMPLES = 361


def pair_of(motion: Motion[Any, Any, Any], words: str, panels: Sequence[str] = (PANEL,)) -> Pair:
    """Return the body that rolls, and that on which it rolls.

    Parameters
    ----------
    motion
        The motion of a mechanism.
    words
        A body, which rolls on the frame, or two, as in "rocker on crank".
    panels
        The panels that are drawn: one of them has to show centres.

    Raises
    ------
    vad.errors.UsageError
        For an unknown body, for two bodies that a pin joins or that turn alike, and without the
        panel that shows centres.

    Examples
    --------
    >>> import vad
    >>> pair_of(vad.solve(vad.FourBar()), "rocker on crank")
    ('rocker', 'crank')
    """
    if PANEL not in panels:
        raise UsageError("centrode: no panel shows centres", "as in --panels centres")
    kennedy = kennedy_of(motion.plane)
    fitting = _rolling(kennedy)
    known = f"known: {', '.join(fitting)}" if fitting else "all its bodies turn about pins"
    read = (
        re.fullmatch(r"\s*(\S+?)(?:\s+on\s+(\S+))?\s*", words) if isinstance(words, str) else None
    )
    if read is None:
        raise UsageError(
            f"centrode: {quoted(words)} is no body", "as in coupler, or rocker on crank"
        )
    one, other = (name.replace("-", "_") for name in (read[1], read[2] or FRAME))
    for name in (one, other):
        if name not in kennedy.names:
            raise UsageError(f"centrode: unknown body {quoted(name)}", known)
    pair = kennedy.pair(one, other) if one != other else (one, other)
    if one == other or pair in kennedy.pins:
        at = f"the pin {kennedy.pins[pair]} alone" if one != other else "no centre"
        raise UsageError(f"centrode: {one} and {other} have {at}, and no curves", known)
    if pair not in kennedy.found or kennedy.always_far(one, other):
        raise UsageError(f"centrode: the centre of {one} and {other} is always far away", known)
    return one, other


def centrode_of(
    motion: Motion[Any, Any, Any], words: str | None, panels: Sequence[str]
) -> str | None:
    """Return the body whose centrodes a turn shows: the first one that rolls if none is named.

    It is None where no panel shows centres, and where every body turns about a pin.

    Raises
    ------
    vad.errors.UsageError
        As for `pair_of`.
    """
    if words is not None:
        pair_of(motion, words, panels)
        return words
    return next(iter(_rolling(kennedy_of(motion.plane))), None) if PANEL in panels else None


def _rolling(kennedy: Kennedy) -> list[str]:
    """Return the bodies that roll on the frame."""
    pairs = ((FRAME, name) for name in kennedy.names)
    return [pair[1] for pair in pairs if pair in kennedy.found and not kennedy.always_far(*pair)]


class Centrodes:
    """Both curves in one pose, within a frame that is the same in all poses.

    Parameters
    ----------
    motion
        The pose.
    pair
        The body that rolls, and that on which it rolls.

    Attributes
    ----------
    extent
        The lower left and the upper right corner of the mechanism in all poses.
    """

    def __init__(self, motion: Motion[Any, Any, Any], pair: Pair) -> None:
        driven = next(iter(motion.mechanism.inputs))
        here = float(motion.inputs[driven])
        turns = [here + 360.0 * turn for turn in (-1, 0, 1)] if driven == "angle" else [here]

        def away(ends: tuple[float, float]) -> float:
            return min(max(ends[0] - place, place - ends[1]) for place in turns)

        ends = min(closing_range(motion.mechanism), key=away)
        many, self.extent = _whole(motion.mechanism, driven, *ends)
        self._fixed, self._moving = many.centrodes(*pair, motion)

    def curves(self, low: complex, high: complex) -> tuple[Curve, Curve]:
        """Return the fixed and the moving centrode between two corners of a frame."""
        return _cut(self._fixed, low, high), _cut(self._moving, low, high)


@lru_cache(maxsize=16)
def _whole(
    mechanism: Mechanism, driven: str, low: float, high: float
) -> tuple[Centres[Any, Any, Any], tuple[complex, complex]]:
    """Return the centres of all poses between two places of the driver, and the corners of all."""
    inputs: Any = {driven: np.linspace(low, high, SAMPLES)}
    many: Any = solve(mechanism, **inputs)
    reached = [np.atleast_1d(many.point(point).position) for point in many.points]
    xs, ys = (np.concatenate([getattr(z, part) for z in reached]) for part in ("real", "imag"))
    low_end, high_end = (complex(each(xs), each(ys)) for each in (np.nanmin, np.nanmax))
    return centres(many), (low_end, high_end)


def _cut(way: Any, low: complex, high: complex) -> Curve:
    """Return the pieces of a way that lie between two corners.

    Between two places that lie outside on opposite sides the way leads through infinity.
    """
    starts, ends = way[:-1], way[1:]
    steps = ends - starts
    first, last = np.zeros(steps.shape), np.ones(steps.shape)
    with np.errstate(all="ignore"):
        for ahead, here, least, most in (
            (steps.real, starts.real, low.real, high.real),
            (steps.imag, starts.imag, low.imag, high.imag),
        ):
            bounds = np.array([(least - here) / ahead, (most - here) / ahead])
            level = ahead == 0.0
            inside = (here >= least) & (here <= most)
            enters = np.where(level, np.where(inside, 0.0, np.inf), bounds.min(axis=0))
            leaves = np.where(level, np.where(inside, 1.0, -np.inf), bounds.max(axis=0))
            first, last = np.maximum(first, enters), np.minimum(last, leaves)
    middle = (low + high) / 2
    outside = (first > 0.0) & (last < 1.0)
    opposite = ((starts - middle) * np.conj(ends - middle)).real < 0.0
    seen = np.isfinite(steps) & (first < last) & ~(outside & opposite)
    points: list[complex] = []
    breaks: list[int] = []
    joined = False
    for number in range(len(steps)):
        if not seen[number]:
            joined = False
            continue
        begin, end = (complex(starts[number] + by[number] * steps[number]) for by in (first, last))
        if not joined or first[number] > 0.0:
            if points:
                breaks.append(len(points))
            points.append(begin)
        points.append(end)
        joined = bool(last[number] == 1.0)
    return Curve(tuple(points), breaks=tuple(breaks))
