"""Which steps lead from a fixed point to every other point of a linkage."""

from __future__ import annotations

from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.linkage import Step as LoopStep
from vad.kinematics.numbers import Number
from vad.kinematics.solver import Pose, Rates, Solver

Hop = tuple[int, LoopStep]


def _rank(step: LoopStep) -> int:
    """Prefer fixed guides, then bars, then slides on a link: the fewest roundings first."""
    if isinstance(step, Bar):
        return 1
    return 2 if isinstance(step.along, str) else 0


class Routes:
    """The shortest way from a fixed point to each letter, and the motion summed along it."""

    def __init__(self, solver: Solver) -> None:
        self._solver = solver
        self.start = {letter: letter for letter in solver.fixed}
        self.hops: dict[str, tuple[Hop, ...]] = {letter: () for letter in solver.fixed}
        while found := self._next():
            letter, tail, hop = found
            self.start[letter] = self.start[tail]
            self.hops[letter] = (*self.hops[tail], hop)

    def _next(self) -> tuple[str, str, Hop] | None:
        """Return a letter not reached yet, the letter before it and the hop between them."""
        candidates = []
        for step in self._solver.steps:
            for way, (tail, head) in ((1, step.ends), (-1, reversed(step.ends))):
                if tail in self.hops and head not in self.hops:
                    hops = len(self.hops[tail])
                    candidates.append(((hops, _rank(step)), head, tail, (way, step)))
        if not candidates:
            return None
        _, head, tail, hop = min(candidates, key=lambda candidate: candidate[0])
        return head, tail, hop

    def position(self, letter: str, pose: Pose) -> Number:
        """Return the position of a point in the solver's unit and frame."""
        total: Number = self._solver.fixed[self.start[letter]]
        for way, step in self.hops[letter]:
            if isinstance(step, Slide):
                total = total + way * self._solver.shift(step)
            total = total + way * self._solver.displacement(step, pose)
        return total

    def rate(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Number:
        """Return the velocity (one order in ``rates``) or acceleration (two) of a point."""
        total: Number = 0j
        for way, step in self.hops[letter]:
            for part in self._solver.components(step, pose, rates):
                total = total + (way * part.amount) * part.direction
        return total
