"""What the drawings of shafts, engines and locomotives have in common."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from vad.kinematics.numbers import degrees_of, times
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sentences import Unit
from vad.strokes.sheet import Cell

if TYPE_CHECKING:
    from vad.strokes.balancing.scene import BalancingScene

#: The row of the resultant in a pose.
RESULTANT = "F"


class Drawings:
    """The drawings of what is balanced.

    Attributes
    ----------
    scene
        The pose, or many of them.
    rows
        The title and the letters of each row of the results.
    """

    def __init__(self, scene: BalancingScene, rows: Mapping[str, tuple[str, str]]) -> None:
        self.scene, self.rows = scene, dict(rows)

    def unit(self, panel: str) -> str:
        """Return the unit of a diagram."""
        raise NotImplementedError

    def drawing(self, panel: str) -> Drawing:
        """Return a diagram."""
        raise NotImplementedError

    def cells(self, panel: str, key: str) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row."""
        raise NotImplementedError

    def tracks(self, panel: str) -> Mapping[Spot, Any]:
        """Return where the points of a diagram are that move in a turn."""
        return {}

    def curve_row(self, panel: str) -> str:
        """Return the row whose quantity is drawn over a turn below a diagram."""
        return RESULTANT

    def turned(self, vector: complex) -> Any:
        """Return a vector that turns with the shaft, in the pose or in each of the poses."""
        crank = self.scene.crank
        return vector * crank if self.scene.motion.many else times(vector, crank)


def figures(vector: complex, unit: str) -> dict[str, Any]:
    """Return the size and the direction of a vector for a sentence."""
    angle = degrees_of(vector) if vector else 0.0
    return {
        "value": Figure(abs(vector), unit),
        "unit": Unit(unit),
        "angle": Figure(angle, "°"),
    }
