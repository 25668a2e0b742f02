"""The slider-crank, in line or offset."""

from dataclasses import dataclass

from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.mechanisms.mechanism import Dimension, Mechanism, length


@dataclass(frozen=True)
class SliderCrank(Mechanism):
    """Crank AB pushes the slider C along y = offset through the rod BC.

    Open: the slider is to the right of the crank pin.
    """

    name = "slider-crank"
    title = "Slider–crank"
    letters = "ABC"
    links = {"crank": "AB", "rod": "BC"}
    slides = {"slider": "C"}

    crank: Dimension = length(60.0, "length of AB")
    rod: Dimension = length(140.0, "length of BC")
    offset: Dimension = length(0.0, "height of the guide above A", signed=True)

    def linkage(self) -> Linkage:
        """AB + BC = AD + DC, with D the guide's point next to A."""
        loop = Loop(
            first=(Bar("AB", "crank", self.crank), Bar("BC", "rod", self.rod)),
            second=(Slide("DC", "slider", 0.0, origin=self.offset * 1j),),
        )
        return Linkage(angle_of("crank"), (loop,))
