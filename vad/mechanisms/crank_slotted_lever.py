"""The crank and slotted lever, the quick return of the shaper, with its optional ram."""

from dataclasses import KW_ONLY, dataclass

from vad.errors import InputError
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.mechanisms.mechanism import Dimension, Mechanism, OptionalDimension, angle, length

_HINT = "as in --rod 100 --ram-height 180"


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

    ground: Dimension = length(120.0, "distance AD of the pivots")
    crank: Dimension = length(50.0, "length of AB")
    lever: Dimension = length(250.0, "length of DC")
    rod: OptionalDimension = length(None, "length of CE, with a ram")
    ram_height: OptionalDimension = length(None, "height of the ram's line above A", signed=True)
    _: KW_ONLY
    ground_angle: Dimension = angle(-90.0, "direction of AD")

    def linkage(self) -> Linkage:
        """Return the loops; the tip C lies on the side of Q."""
        ground = (self.ground, self.ground_angle)
        return quick_return(self.crank, self.lever, ground, self.rod, self.ram_height)


def quick_return(
    crank: float,
    tip: float,
    ground: tuple[float, float],
    rod: float | None,
    ram_height: float | None,
    level: bool = False,
) -> Linkage:
    """Return the two loops of a quick return: of its slotted lever, and of its ram.

    Crank AB moves a block B that slides on the lever from D.  Q is the lever's point under the
    block: AB = AD + DQ + QB.  With a rod there is a ram E: DC + CE = DE.

    Parameters
    ----------
    crank, rod
        The lengths AB and CE; no rod means no ram.
    tip
        The distance of C from D; where it is negative, C lies on the side away from Q.
    ground
        The distance and the direction of AD.
    ram_height
        The height of the ram's line above A.
    level
        Whether the ram's line passes exactly through D, however its height is rounded.
    """
    lever = Loop(
        first=(Bar("AB", "crank", crank), -Slide("QB", "block", along="lever")),
        second=(Bar("DQ", "lever", "block"),),
    )
    arm = Bar("DC", "lever", tip)
    loops: tuple[Loop, ...] = (lever,)
    if rod is not None and ram_height is not None:
        ram = Slide("DE", "ram", 0.0, origin=ram_height * 1j, through_tail=level)
        loops = (lever, Loop(first=(arm, Bar("CE", "rod", rod)), second=(ram,)))
    elif rod is not None:
        raise InputError("ram_height: is missing; a ram needs a rod and a ram_height", _HINT)
    elif ram_height is not None:
        raise InputError("rod: is missing; a ram needs a rod and a ram_height", _HINT)
    return Linkage(angle_of("crank"), loops, images=(arm,), ground=("D", *ground))
