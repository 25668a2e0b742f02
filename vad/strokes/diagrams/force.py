"""The force polygons of the dyads."""

from vad.strokes.diagram import Diagram, in_plane
from vad.strokes.force_tracks import force_tracks
from vad.strokes.forces import force_cells, force_polygons

DIAGRAM = Diagram(
    "force",
    "Forces",
    3,
    "vectors",
    lambda scene: "N",
    force_polygons,
    force_cells,
    force_tracks,
    usual=False,
    applies=in_plane,
)
