"""The Scotch yoke: a crank pin in a slot that can only move sideways."""

from dataclasses import dataclass

from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.mechanisms.mechanism import Dimension, Mechanism, length


@dataclass(frozen=True)
class ScotchYoke(Mechanism):
    """Crank AB moves the yoke through a block at B that slides in its vertical slot.

    C is the yoke's point on the x axis, below or above B.
    """

    name = "scotch-yoke"
    title = "Scotch yoke"
    letters = "ABC"
    links = {"crank": "AB"}
    slides = {"yoke": "C", "block": "B"}

    crank: Dimension = length(50.0, "length of AB")

    def linkage(self) -> Linkage:
        """AB = AC + CB."""
        loop = Loop(
            first=(Bar("AB", "crank", self.crank), -Slide("CB", "block", 90.0)),
            second=(Slide("AC", "yoke", 0.0),),
        )
        return Linkage(angle_of("crank"), (loop,))
