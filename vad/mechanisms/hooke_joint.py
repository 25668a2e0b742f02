"""Hooke's joint, which joins two shafts that meet under an angle."""

from dataclasses import dataclass

from vad.kinematics.space.linkages import CrossedShafts
from vad.mechanisms.mechanism import Dimension, MechanismInSpace, arc


@dataclass(frozen=True)
class HookeJoint(MechanismInSpace):
    """The driving shaft turns the driven one through a cross.

    The driving shaft's angle is that of its pin P from the plane of the shafts; the driven one's
    starts with it.  P and Q, the pins of both yokes, are on a sphere of radius 1 about O.
    """

    name = "hooke-joint"
    title = "Hooke’s joint"
    script = "vad.strokes.scripts.hooke_joint"
    letters = "PQO"
    links = {"driving": "2", "cross": "3", "driven": "4"}
    joints = {"P": "cross against driving", "Q": "cross against driven"}

    shaft_angle: Dimension = arc(30.0, "angle between the shafts", "at 90° it locks", -90.0, 90.0)

    def linkage(self) -> CrossedShafts:
        """Both shafts, and the cross between them."""
        return CrossedShafts(self.shaft_angle)
