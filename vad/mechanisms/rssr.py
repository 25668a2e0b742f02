"""The ball-jointed four-bar RSSR: two turning joints, and a coupler between two balls."""

import math
from dataclasses import KW_ONLY, dataclass

from vad.kinematics.space.linkages import BallJointed
from vad.mechanisms.mechanism import Dimension, MechanismInSpace, angle, length


@dataclass(frozen=True)
class RSSR(MechanismInSpace):
    """Crank AB turns the rocker DC about another axis, through the coupler BC between balls.

    Open: C lies to the left of B′D, with B′ below B in the plane of C's circle, seen against D's
    axis.  Both angles are counted from the common normal of the axes.  The coupler's rates leave
    out its idle spin about BC.
    """

    name = "rssr"
    title = "Spatial four-bar with ball joints"
    script = "vad.strokes.scripts.rssr"
    letters = "ABCD"
    links = {"crank": "AB", "coupler": "BC", "rocker": "DC"}

    ground: Dimension = length(0.0, "common normal of both axes", signed=True)
    crank: Dimension = length(200.0, "length of AB")
    coupler: Dimension = length(math.sqrt(750.0**2 + 850.0**2 + 450.0**2), "length of BC")
    rocker: Dimension = length(math.hypot(350.0, 650.0), "length of DC")
    _: KW_ONLY
    ground_twist: Dimension = angle(90.0, "angle of D's axis from A's, about the common normal")
    crank_offset: Dimension = length(
        400.0, "from the common normal to A, along A's axis", signed=True
    )
    rocker_offset: Dimension = length(
        850.0, "from the common normal to D, along D's axis", signed=True
    )

    def linkage(self) -> BallJointed:
        """AB + BC = AD + DC."""
        return BallJointed(
            self.ground,
            self.ground_twist,
            self.crank_offset,
            self.rocker_offset,
            self.crank,
            self.coupler,
            self.rocker,
        )
