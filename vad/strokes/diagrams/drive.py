"""The driven link alone: the forces on it, and the torque that must turn it."""

from vad.strokes.diagram import Diagram
from vad.strokes.drive import drive_cells, drive_drawing, turns_on_the_frame

DIAGRAM = Diagram(
    "drive",
    "Torque",
    4,
    "skeleton",
    lambda scene: scene.unit,
    drive_drawing,
    drive_cells,
    usual=False,
    applies=turns_on_the_frame,
)
