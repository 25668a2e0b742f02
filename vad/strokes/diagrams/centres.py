"""Instantaneous centres upon the mechanism, with the circle of its bodies."""

from vad.strokes.centres import centres_cells, centres_drawing, centres_tracks
from vad.strokes.diagram import Diagram, in_plane

DIAGRAM = Diagram(
    "centres",
    "Instantaneous centres",
    0.3,
    "skeleton",
    lambda scene: scene.unit,
    centres_drawing,
    centres_cells,
    centres_tracks,
    usual=False,
    applies=in_plane,
    by_hand=False,  # what lies beyond the panel in one pose is shown in another
)
