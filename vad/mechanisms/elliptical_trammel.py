"""The elliptical trammel: a link whose ends slide along two axes."""

from dataclasses import dataclass

from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.mechanisms.mechanism import Dimension, Mechanism, length


@dataclass(frozen=True)
class EllipticalTrammel(Mechanism):
    """The link AB is turned; A slides along the x axis, B along the y axis.

    The tracer P lies at `tracer` from A towards B, beyond B or behind A too, and draws an ellipse.
    """

    name = "elliptical-trammel"
    title = "Elliptical trammel"
    letters = "OABP"
    links = {"link": "AB"}
    slides = {"slider_a": "A", "slider_b": "B"}

    link: Dimension = length(200.0, "length of AB")
    tracer: Dimension = length(80.0, "distance of P from A towards B", signed=True)

    def linkage(self) -> Linkage:
        """OA + AB = OB; the polygon begins at a, and the pole o is where its lines cross."""
        loop = Loop(
            first=(-Slide("OA", "slider_a", 0.0),),
            second=(Bar("AB", "link", self.link), -Slide("OB", "slider_b", 90.0)),
        )
        tracer = Bar("AP", "link", self.tracer)
        return Linkage(angle_of("link"), (loop,), images=(tracer,), pivot="O")
