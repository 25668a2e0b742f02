"""The crank and slotted lever, the quick return of the shaper, with its optional ram."""

from dataclasses import KW_ONLY, dataclass

from vad.kinematics.linkage import Linkage
from vad.mechanisms.mechanism import Mechanism, angle, length
from vad.mechanisms.quick_return import quick_return


@dataclass(frozen=True)
class CrankSlottedLever(Mechanism):
    """Crank AB swings the lever DC through a block at B that slides on it.

    Q is the lever's point under the block.  With a rod CE, the lever's tip C pushes a ram E along
    y = ram_height; open: the ram is to the right of C.
    """

    name = "crank-slotted-lever"
    title = "Crank and slotted lever"
    letters = "ABDQCE"
    links = {"crank": "AB", "lever": "DC", "rod": "CE"}
    slides = {"block": "B", "ram": "E"}

    ground: float = length(120.0, "distance AD of the pivots")
    crank: float = length(50.0, "length of AB")
    lever: float = length(250.0, "length of DC")
    rod: float | None = length(None, "length of CE, with a ram")
    ram_height: float | None = length(None, "height of the ram's line above A", signed=True)
    _: KW_ONLY
    ground_angle: float = angle(-90.0, "direction of AD")

    def linkage(self) -> Linkage:
        """Return the loops; the tip C lies on the side of Q."""
        ground = (self.ground, self.ground_angle)
        return quick_return(self.crank, self.lever, ground, self.rod, self.ram_height)
