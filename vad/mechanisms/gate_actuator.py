"""The gate actuator: an arm that is turned by a strut of changing length."""

import math
from dataclasses import KW_ONLY, dataclass

from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, length_of
from vad.mechanisms.mechanism import Dimension, DrivenBySlide, angle, length, unit


@dataclass(frozen=True)
class GateActuator(DrivenBySlide):
    """The actuator DB grows and turns the gate's arm AB about A.

    The defaults are the power gate of a lecture on planar kinematics, in feet.  Open: B lies to
    the left of the line from D to A.
    """

    name = "gate-actuator"
    title = "Gate actuator"
    letters = "ABD"
    links = {"arm": "AB", "actuator": "DB"}
    slides = {"actuator": "B"}
    inputs = {"position": 3.8, "velocity": 1.0 / 17.0, "acceleration": 0.0}

    ground: Dimension = length(math.hypot(0.416, 0.546), "distance AD of the pivots")
    arm: Dimension = length(math.hypot(3.875, 0.3), "length of AB")
    _: KW_ONLY
    ground_angle: Dimension = angle(math.degrees(math.atan2(0.546, -0.416)), "direction of AD")
    length_unit: str = unit("ft")

    def linkage(self) -> Linkage:
        """DS + SB = DA + AB, with S the end that the stroke moves, before the actuator turns."""
        loop = Loop(
            first=(
                Slide("DS", "actuator", along="actuator"),
                Bar("SB", "actuator", "actuator"),
            ),
            second=(Bar("AB", "arm", self.arm),),
        )
        ground = ("D", self.ground, self.ground_angle)
        return Linkage(length_of("actuator"), (loop,), ground=ground)
