"""The frame of mechanisms in space, whose points are vectors x, y, z."""

from __future__ import annotations

from dataclasses import dataclass

from vad.kinematics.space.linkages import SpaceLinkage
from vad.mechanisms.mechanism import Mechanism


@dataclass(frozen=True)
class MechanismInSpace(Mechanism, listed=False):
    """A mechanism that leaves the plane.

    The frame has its origin at A, z along A's axis and x along the common normal from A to D.
    """

    def linkage(self) -> SpaceLinkage:
        """Return what its axes or balls keep."""
        raise TypeError(f"{type(self).__name__} declares no linkage")
