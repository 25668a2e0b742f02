"""A parallelogram that stays one: each unknown bar copies the known vector opposite it."""

from __future__ import annotations

from vad.errors import InputError
from vad.kinematics.closing.loop import LoopSolver
from vad.kinematics.linkage import Bar, Step
from vad.kinematics.numbers import Number, cross, turned
from vad.kinematics.state import GROUND, Pose, Rates

# Opposite sides whose lengths differ by a larger part are not equal.
_ALIKE = 1e-12


class ParallelLoop(LoopSolver):
    """Two unknown bars, each as long as the known vector of the other chain, and parallel to it.

    It runs through its change points: nothing is divided there, and the rates are copies.
    """

    two_ways = True

    step: Bar
    other: Bar

    def prepare(self) -> None:
        """Find what each bar copies: a link, and how the bar lies in that link's axes."""
        self.check_ends()
        if len(self.known) != (1 if self.offset else 2):
            raise InputError("parallel: a parallelogram has two known sides and two unknown ones")
        opposite = {self.step: (self.loop.second, 1.0), self.other: (self.loop.first, -1.0)}
        self._copies = {bar: self._copied(bar, *chain) for bar, chain in opposite.items()}

    def _copied(self, bar: Bar, chain: tuple[Step, ...], ground: float) -> tuple[str, complex]:
        known = [step for _, step in self.known if step in chain]
        if not known and self.offset:
            link, vector = GROUND, ground * self.offset
        elif len(known) == 1 and isinstance(known[0], Bar):
            link, size = known[0].link, self.frame.size(known[0])
            along = self.frame.found_along.get(link, 1.0 + 0j)
            vector = (-size if known[0].reverse else size) * known[0].turn * along.conjugate()
        else:
            raise InputError(f"parallel: {bar.ends} has no bar opposite")
        length, size = abs(vector), self.frame.size(bar)
        if not abs(length - size) <= _ALIKE * length:
            raise InputError(
                f"parallel: {bar.ends} and the side opposite it differ by "
                f"{abs(length - size) * self.frame.scale:.4g}",
                hint="a parallelogram has equal opposite sides",
            )
        return link, vector / length

    def close(self, pose: Pose) -> None:
        """Lay each bar along what it copies."""
        for bar, (source, turn) in self._copies.items():
            pose.unit[bar.link] = turned(pose.unit[source], turn)
        pose.sine.append(cross(pose.unit[self.step.link], pose.unit[self.other.link]))

    def move(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Copy the rates, at the change points too."""
        for bar, (source, _) in self._copies.items():
            turning = rates[-1].turning
            turning[bar.link] = 0.0 if source == GROUND else turning[source]
