"""The velocity polygon upon the mechanism, turned by 90°."""

from vad.strokes.diagram import Diagram, turns_on_the_frame
from vad.strokes.turned import turned_cells, turned_drawing, turned_tracks

DIAGRAM = Diagram(
    "turned",
    "Turned velocities",
    0.5,
    "skeleton",
    lambda scene: scene.unit,
    turned_drawing,
    turned_cells,
    turned_tracks,
    usual=False,
    applies=turns_on_the_frame,
)
