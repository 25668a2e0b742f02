"""The spatial four-bar RCCC: one turning joint, three that turn and slide."""

from dataclasses import KW_ONLY, dataclass

from vad.kinematics.space.linkages import DualAngle, FourAxes
from vad.mechanisms.mechanism import Dimension, MechanismInSpace, arc, length

_PARALLEL = "parallel axes make a four-bar in the plane"


@dataclass(frozen=True)
class SpatialFourBar(MechanismInSpace):
    """Crank AB turns the rocker DC through the coupler BC; B, C and D also slide.

    Its axes turn as those of the spherical four-bar with the twists for arcs, whatever its lengths,
    and open means the same.  B and C are the crank's and the coupler's foot on their axes, D is the
    ground's.  The slides lead from the crank's to the coupler's foot at B, from the rocker's to the
    coupler's at C, from the ground's to the rocker's at D.
    """

    name = "spatial-four-bar"
    title = "Spatial four-bar"
    script = "vad.strokes.scripts.spatial_four_bar"
    letters = "ABCD"
    links = {"crank": "AB", "coupler": "BC", "rocker": "DC"}
    joints = {"B": "coupler against crank", "C": "coupler against rocker"}
    slides = {"slide_b": "B", "slide_c": "C", "slide_d": "D"}

    ground: Dimension = length(100.0, "distance of the axes at A and D", signed=True)
    crank: Dimension = length(40.0, "distance of the axes at A and B", signed=True)
    coupler: Dimension = length(80.0, "distance of the axes at B and C", signed=True)
    rocker: Dimension = length(60.0, "distance of the axes at D and C", signed=True)
    _: KW_ONLY
    ground_twist: Dimension = arc(60.0, "angle between the axes at A and D", _PARALLEL)
    crank_twist: Dimension = arc(30.0, "angle between the axes at A and B", _PARALLEL)
    coupler_twist: Dimension = arc(55.0, "angle between the axes at B and C", _PARALLEL)
    rocker_twist: Dimension = arc(45.0, "angle between the axes at D and C", _PARALLEL)

    def linkage(self) -> FourAxes:
        """AB + s_B + BC = AD + s_D + DC + s_C."""
        return FourAxes(
            DualAngle(self.ground_twist, self.ground),
            DualAngle(self.crank_twist, self.crank),
            DualAngle(self.coupler_twist, self.coupler),
            DualAngle(self.rocker_twist, self.rocker),
            slides=True,
        )
