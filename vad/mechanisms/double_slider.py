"""The double slider: a link between two guides, driven by one of its sliders."""

from dataclasses import dataclass

from vad.errors import InputError
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, length_of, parallel
from vad.mechanisms.mechanism import Dimension, DrivenBySlide, angle, length


@dataclass(frozen=True)
class DoubleSlider(DrivenBySlide):
    """Slider A is pushed along its guide and moves B along its own through the link AB.

    Both guides pass through O.  Open: B at the greater distance along its guide.
    """

    name = "double-slider"
    title = "Double slider"
    letters = "OAB"
    links = {"link": "AB"}
    slides = {"slider_a": "A", "slider_b": "B"}
    inputs = {"position": 500.0, "velocity": 2000.0, "acceleration": 1000.0}

    link: Dimension = length(1000.0, "length of AB")
    guide_a: Dimension = angle(0.0, "direction of A's guide")
    guide_b: Dimension = angle(90.0, "direction of B's guide")

    def linkage(self) -> Linkage:
        """OA + AB = OB."""
        if parallel(self.guide_a, self.guide_b):
            raise InputError(
                f"guide_b: must differ from guide_a, got {self.guide_b:g}, which is the same line",
                hint=f"try {self.guide_b + 90.0:g}",
            )
        loop = Loop(
            first=(Slide("OA", "slider_a", self.guide_a), Bar("AB", "link", self.link)),
            second=(Slide("OB", "slider_b", self.guide_b),),
        )
        return Linkage(length_of("slider_a"), (loop,), pivot="O")
