"""Which steps lead from a fixed point to every other point of a linkage."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Slide, Step, angle_of
from vad.kinematics.numbers import Number
from vad.kinematics.state import Pose, Rates

Hop = tuple[int, Step]
Route = tuple[str, tuple[Hop, ...]]
# What it costs to begin at a fixed point, and to take a step.
Costs = tuple[dict[str, float], Callable[[Step], float]]


class Routes:
    """The shortest way from a fixed point to each letter, and the motion summed along it.

    Attributes
    ----------
    letters
        Every letter that can be reached.
    """

    def __init__(self, frame: ReferenceFrame) -> None:
        self._frame = frame
        self._places = _shortest(frame, *_place_costs(frame))
        self._motions = _shortest(frame, *_motion_costs(frame))
        self.letters = frozenset(self._places)

    def guide(self, letter: str) -> Slide | None:
        """Return the line of the frame on which a point slides, if nothing else leads to it."""
        hops = self._places[letter][1]
        step = hops[0][1] if len(hops) == 1 else None
        return step if isinstance(step, Slide) and isinstance(step.along, float) else None

    def pin(self, letter: str) -> tuple[str, Bar] | None:
        """Return a fixed point and a bar of the driven crank, if a point is always at its head."""
        start, hops = self._places[letter]
        way, crank = hops[0] if hops else (0, None)
        if not isinstance(crank, Bar) or angle_of(crank.link) != self._frame.linkage.driver:
            return None
        exact = start == self._frame.linkage.pivot or start in self._frame.linkage.fixed
        blocks = all(isinstance(s, Slide) and isinstance(s.along, str) for _, s in hops[1:])
        forward = isinstance(crank.length, float) and way == 1
        return (start, crank) if exact and forward and blocks else None

    def position(self, letter: str, pose: Pose) -> Number:
        """Return the position of a point in the solver's unit and frame."""
        start, hops = self._places[letter]
        total: Number = self._frame.fixed[start]
        for way, step in hops:
            if isinstance(step, Slide):
                total = total + way * self._frame.shift(step)
            total = total + way * self._frame.displacement(step, pose)
        return total

    def rate(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Number:
        """Return the velocity (one order in ``rates``) or acceleration (two) of a point."""
        total: Number = 0j
        for way, step in self._motions[letter][1]:
            for _, direction, amount in self._frame.components(step, pose, rates):
                total = total + (way * cast(Number, amount)) * direction
        return total


def _place_costs(frame: ReferenceFrame) -> Costs:
    """Cost lengths, for a short way rounds least, and links by the loops before they are found."""
    pairs = enumerate(frame.linkage.unknowns)
    before = {scalar: number for number, pair in pairs for scalar in pair}

    def cost(step: Step) -> float:
        if isinstance(step, Slide):
            return 1.0 if isinstance(step.along, str) else 1e-9
        # A lever's point under its block is where the pin is.
        size = 3.0 if isinstance(step.length, str) else abs(frame.size(step))
        return size + 10.0 * before.get(angle_of(step.link), 0)

    return {letter: abs(place) for letter, place in frame.fixed.items()}, cost


def _motion_costs(frame: ReferenceFrame) -> Costs:
    """Cost steps; guides of the frame round least."""

    def cost(step: Step) -> float:
        return 0.5 if isinstance(step, Slide) and isinstance(step.along, float) else 1.0

    return dict.fromkeys(frame.fixed, 0.0), cost


def _shortest(
    frame: ReferenceFrame, costs: dict[str, float], cost: Callable[[Step], float]
) -> dict[str, Route]:
    """Return the cheapest route to each letter, from letters with the given costs."""
    routes: dict[str, Route] = {letter: (letter, ()) for letter in frame.fixed}
    while True:
        candidates = [
            (costs[tail] + cost(step), head, tail, (way, step))
            for step in frame.steps
            for way, tail, head in (
                (1, step.tail, step.head),
                (-1, step.head, step.tail),
            )
            if tail in routes and head not in routes
        ]
        if not candidates:
            return routes
        total, head, tail, hop = min(candidates, key=lambda candidate: candidate[0])
        start, hops = routes[tail]
        routes[head], costs[head] = (start, (*hops, hop)), total
