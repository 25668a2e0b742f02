"""The two loops that the quick-return mechanisms share: a slotted lever, and its ram."""

from vad.errors import InputError
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of

_HINT = "as in --rod 100 --ram-height 180"


def quick_return(
    crank: float,
    tip: float,
    ground: tuple[float, float],
    rod: float | None,
    ram_height: float | None,
    level: bool = False,
) -> Linkage:
    """Return a crank AB whose block B slides on a lever from D, with a ram E if there is a rod.

    AB = AD + DQ + QB, where Q is the lever's point under the block, and DC + CE = DE.  C lies at
    ``tip`` from D, against Q where that is negative; ``ground`` is the distance and direction
    of AD.  ``level`` says that the ram's line passes through D, but for the rounding of its height.
    """
    lever = Loop(
        first=(Bar("AB", "crank", crank), -Slide("QB", "block", along="lever")),
        second=(Bar("DQ", "lever", "block"),),
    )
    arm = Bar("DC", "lever", tip)
    loops: tuple[Loop, ...] = (lever,)
    if rod is not None and ram_height is not None:
        ram = Slide("DE", "ram", 0.0, origin=1j * ram_height, through_tail=level)
        loops = (lever, Loop(first=(arm, Bar("CE", "rod", rod)), second=(ram,)))
    elif rod is not None:
        raise InputError("ram_height: is missing; a ram needs a rod and a ram_height", _HINT)
    elif ram_height is not None:
        raise InputError("rod: is missing; a ram needs a rod and a ram_height", _HINT)
    return Linkage(angle_of("crank"), loops, images=(arm,), ground=("D", *ground))
