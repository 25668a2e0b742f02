"""The Whitworth quick return, with its optional ram."""

from dataclasses import KW_ONLY, dataclass

from vad.kinematics.elementary import sine
from vad.kinematics.linkage import Linkage
from vad.mechanisms.crank_slotted_lever import quick_return
from vad.mechanisms.mechanism import Dimension, Mechanism, OptionalDimension, angle, length


@dataclass(frozen=True)
class Whitworth(Mechanism):
    """Crank AB turns the slotted lever DQ all the way round through a block at B.

    The lever's arm DC points away from Q.  With a rod CE it pushes a ram E along y = ram_height,
    the level of D unless given; open: the ram is to the right of C.
    """

    name = "whitworth"
    title = "Whitworth quick return"
    letters = "ABDQCE"
    links = {"crank": "AB", "lever": "DQ", "rod": "CE"}
    slides = {"block": "B", "ram": "E"}

    ground: Dimension = length(40.0, "distance AD of the pivots")
    crank: Dimension = length(90.0, "length of AB")
    arm: Dimension = length(60.0, "length of DC")
    rod: OptionalDimension = length(None, "length of CE, with a ram")
    ram_height: OptionalDimension = length(None, "height of the ram's line above A", signed=True)
    _: KW_ONLY
    ground_angle: Dimension = angle(-90.0, "direction of AD")

    def linkage(self) -> Linkage:
        """Return the loops; the tip C lies on the side away from Q."""
        height = self.ram_height
        level = self.rod is not None and height is None
        if level:
            height = self.ground * sine(self.ground_angle)
        ground = (self.ground, self.ground_angle)
        return quick_return(self.crank, -self.arm, ground, self.rod, height, level)
