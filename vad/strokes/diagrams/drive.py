"""The driven body alone: the forces on it, and what must drive it."""

from vad.strokes.diagram import Diagram, in_plane
from vad.strokes.drive import drive_cells, drive_drawing

DIAGRAM = Diagram(
    "drive",
    "Drive",
    4,
    "skeleton",
    lambda scene: scene.unit,
    drive_drawing,
    drive_cells,
    usual=False,
    applies=in_plane,
)
