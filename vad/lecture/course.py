"""How the driver moves while a turn is shown: once round, or to and fro where it cannot go round.

In comes one pose, out goes a `Course`: the driver's place and rates at any phase of the turn.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from vad.errors import AssemblyError
from vad.kinematics.motion import Motion
from vad.kinematics.reach import change_points, closing_range

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

#: How far a swing keeps away from the dead centre at either end, as a share of its range.
KEPT = 0.03
#: The given place counts as no nearer to an end of the swing than this (a sine).
LEAST = 0.3


@dataclass(frozen=True, slots=True)
class Course:
    """The motion of the driver over one turn; the phase runs from 0 to 1.

    ``names`` are those of its place and rates ("angle", "omega", "alpha"), ``given`` the values
    at phase 0.  ``swing`` is None for a full turn; otherwise the driver swings harmonically, and
    it holds the middle, the amplitude, the angle of the swing at phase 0 (radians) and its speed
    (rad/s).  Such a swing slows down towards the dead centres, so that no rate runs away there.
    """

    names: tuple[str, ...]
    given: tuple[float, ...]
    swing: tuple[float, float, float, float] | None = None

    def inputs(self, phase: float) -> dict[str, float]:
        """Return the inputs of `vad.solve` at a phase.

        Examples
        --------
        >>> Course(("angle", "omega", "alpha"), (60.0, -10.0, 0.0)).inputs(0.25)
        {'angle': 330.0, 'omega': -10.0, 'alpha': 0.0}
        """
        if self.swing is None:
            place, rate, second = self.given
            turned = (place + math.copysign(360.0, rate) * phase) % 360.0
            return dict(zip(self.names, (turned, rate, second), strict=True))
        middle, half, start, speed = self.swing
        angle = start + math.tau * phase
        # Rates of an angle count in radians.
        size = math.radians(half) if self.names[0] == "angle" else half
        return dict(
            zip(
                self.names,
                (
                    middle + half * math.cos(angle),
                    -size * speed * math.sin(angle),
                    -size * speed**2 * math.cos(angle),
                ),
                strict=True,
            )
        )

    @property
    def opening(self) -> float:
        """The phase at which the driver passes 0°, or the lower end of its swing."""
        if self.swing is not None:
            return (math.pi - self.swing[2]) / math.tau % 1.0
        place, rate, _ = self.given
        return math.copysign(1.0, -rate) * place / 360.0 % 1.0

    @property
    def ends(self) -> tuple[float, float]:
        """The driver's place at the opening and half a cycle later: the ends of a swing."""
        if self.swing is not None:
            middle, half = self.swing[:2]
            return middle - half, middle + half
        return (0.0, 180.0) if math.copysign(1.0, self.given[1]) > 0 else (360.0, 180.0)


def course(motion: Motion) -> Course:
    """Return the course that begins with one pose and runs through all that can follow it.

    Where the links do not close at that pose, it begins at the nearest one at which they do.

    Raises
    ------
    vad.errors.AssemblyError
        If the links close nowhere.
    """
    names = tuple(motion.mechanism.inputs)
    given = tuple(float(motion.inputs[name]) for name in names)
    turns = names[0] == "angle"
    ranges = closing_range(motion.mechanism)
    if not ranges:
        raise AssemblyError("with these lengths the links close nowhere")
    if turns and ranges == [(0.0, 360.0)]:
        return Course(names, given)
    place = given[0] % 360.0 if turns else given[0]
    around = [place, place - 360.0] if turns else [place]

    def distance(ends: tuple[float, float]) -> float:
        return min(max(ends[0] - x, x - ends[1]) for x in around)

    low, high = min(_parted(motion.mechanism, ranges), key=distance)
    middle, half = (low + high) / 2, (0.5 - KEPT) * (high - low)
    here = min(around, key=lambda x: abs(x - middle))
    start = math.acos(min(max((here - middle) / half, -1.0), 1.0))
    rate = given[1] / (math.radians(half) if turns else half)
    # The driver passes the given place at the given rate, and so in its sense.
    speed = abs(rate) / max(math.sin(start), LEAST)
    return Course(names, given, (middle, half, -start if rate > 0 else start, speed))


def _parted(
    mechanism: Mechanism, ranges: Sequence[tuple[float, float]]
) -> list[tuple[float, float]]:
    """Return the ranges parted at change points: a swing keeps away from them as from its ends."""
    places = [point.place for point in change_points(mechanism)]
    parted: list[tuple[float, float]] = []
    for low, high in ranges:
        inside = {x for place in places for x in (place, place - 360.0) if low < x < high}
        parted += pairwise([low, *sorted(inside), high])
    return parted
