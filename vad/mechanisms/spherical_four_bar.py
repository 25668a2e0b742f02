"""The spherical four-bar: four turning joints whose axes meet in a point."""

from dataclasses import dataclass

from vad.kinematics.space.linkages import DualAngle, FourAxes
from vad.mechanisms.mechanism import Dimension, MechanismInSpace, arc

_APART = "at 0° and 180° both axes are one"


@dataclass(frozen=True)
class SphericalFourBar(MechanismInSpace):
    """Crank AB turns the rocker DC through the coupler BC, all on a sphere of radius 1.

    Open: C lies to the left of the arc from B to D, seen from outside.  Angles are those of the
    plane, counted on the sphere: the crank's at A from the arc AD to AB, the rocker's at D from AD
    prolonged to DC.  Coupler and rocker turn against each other at C, coupler and crank at B.
    """

    name = "spherical-four-bar"
    title = "Spherical four-bar"
    script = "vad.strokes.scripts.spherical_four_bar"
    letters = "ABCDI"
    links = {"crank": "AB", "coupler": "BC", "rocker": "DC"}
    joints = {"B": "coupler against crank", "C": "coupler against rocker"}

    ground: Dimension = arc(90.0, "arc AD between the fixed axes", _APART)
    crank: Dimension = arc(40.0, "arc AB", _APART)
    coupler: Dimension = arc(80.0, "arc BC", _APART)
    rocker: Dimension = arc(70.0, "arc DC", _APART)

    def linkage(self) -> FourAxes:
        """AB + BC = AD + DC, in arcs."""
        return FourAxes(
            DualAngle(self.ground),
            DualAngle(self.crank),
            DualAngle(self.coupler),
            DualAngle(self.rocker),
        )
