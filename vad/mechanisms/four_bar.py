"""The four-bar linkage: two pivots, three moving bars."""

from dataclasses import KW_ONLY, dataclass

from vad.errors import InputError
from vad.kinematics.linkage import Bar, Linkage, Loop, angle_of
from vad.mechanisms.mechanism import Dimension, Mechanism, angle, length, way


@dataclass(frozen=True)
class FourBar(Mechanism):
    """Crank AB turns the rocker DC through the coupler BC.

    Open: C lies to the left of the line from B to D.  Parallel: opposite links are equal, and stay
    parallel through the change points, where the others become an antiparallelogram.
    """

    name = "four-bar"
    title = "Four-bar"
    letters = "ABCD"
    links = {"crank": "AB", "coupler": "BC", "rocker": "DC"}

    ground: Dimension = length(100.0, "distance AD of the pivots")
    crank: Dimension = length(40.0, "length of AB")
    coupler: Dimension = length(120.0, "length of BC")
    rocker: Dimension = length(80.0, "length of DC")
    _: KW_ONLY
    ground_angle: Dimension = angle(0.0, "direction of AD")

    assembly: str = way("open", "crossed", "parallel")

    def linkage(self) -> Linkage:
        """AB + BC = AD + DC."""
        parallel = self.assembly == "parallel"
        if parallel and (self.ground, self.crank) != (self.coupler, self.rocker):
            raise InputError(
                "assembly: parallel needs the coupler as long as the ground and the rocker as the "
                "crank",
                hint=f"try coupler {self.ground:g} and rocker {self.crank:g}",
            )
        loop = Loop(
            first=(Bar("AB", "crank", self.crank), Bar("BC", "coupler", self.coupler)),
            second=(Bar("DC", "rocker", self.rocker),),
            parallel=parallel,
        )
        ground = ("D", self.ground, self.ground_angle)
        return Linkage(angle_of("crank"), (loop,), ground=ground)
