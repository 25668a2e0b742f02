"""Which steps lead from a fixed point to every other point of a linkage."""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Slide, Step, angle_of, scalar_of
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

    def pin(self, letter: str) -> Bar | None:
        """Return a bar of the driven crank, if a point is always at its head."""
        start, hops = self._places[letter]
        way, crank = hops[0] if hops else (0, None)
        if not isinstance(crank, Bar) or angle_of(crank.link) != self._frame.linkage.driver:
            return None
        blocks = all(isinstance(s, Slide) and isinstance(s.along, str) for _, s in hops[1:])
        forward = isinstance(crank.length, float) and way == 1
        return crank if start in self._frame.places and forward and blocks else None

    def start(self, letter: str) -> str:
        """Return the fixed point at which the way to a point begins."""
        return self._places[letter][0]

    def position(self, letter: str, pose: Pose) -> Number:
        """Return where a point is from its `start`, in the solver's unit and frame."""
        total: Number = 0j
        for way, step in self._places[letter][1]:
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
    """Cost lengths, for a short way rounds least."""

    def cost(step: Step) -> float:
        if isinstance(step, Slide):
            return 1.0 if isinstance(step.along, str) else 1e-9
        # A lever's point under its block is where the pin is.
        return 3.0 if isinstance(step.length, str) else abs(frame.size(step))

    return {letter: abs(place) for letter, place in frame.fixed.items()}, cost


def _motion_costs(frame: ReferenceFrame) -> Costs:
    """Cost steps; guides of the frame round least."""

    def cost(step: Step) -> float:
        return 0.5 if isinstance(step, Slide) and isinstance(step.along, float) else 1.0

    return dict.fromkeys(frame.fixed, 0.0), cost


def _shortest(
    frame: ReferenceFrame, start: dict[str, float], cost: Callable[[Step], float]
) -> dict[str, Route]:
    """Return the best route to each letter, from letters with the given costs.

    That is one over what is found early, for a later loop may be near a dead centre; and of those
    the point's own guide, then the cheapest.
    """
    found = {
        # Of two lines that cross, each length has an error of its own.
        scalar: number + all(each.kind == "length" for each in pair)
        for number, pair in enumerate(frame.linkage.unknowns)
        for scalar in pair
    }
    routes: dict[str, Route] = {letter: (letter, ()) for letter in frame.fixed}
    costs = {letter: (0, start[letter]) for letter in frame.fixed}
    while True:
        candidates = []
        for step in frame.steps:
            for way, tail, head in ((1, step.tail, step.head), (-1, step.head, step.tail)):
                if tail in routes and head not in routes:
                    rank, so_far = costs[tail]
                    total = max(rank, found.get(scalar_of(step), 0)), so_far + cost(step)
                    guide = tail in frame.fixed and isinstance(step, Slide)
                    key = (total[0], 0.0) if guide else total
                    candidates.append((key, total, head, tail, (way, step)))
        if not candidates:
            return routes
        _, total, head, tail, hop = min(candidates, key=lambda candidate: candidate[0])
        begin, hops = routes[tail]
        routes[head], costs[head] = (begin, (*hops, hop)), total
