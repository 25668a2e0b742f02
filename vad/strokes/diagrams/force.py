"""The force polygons of the dyads."""

from vad.strokes.diagram import Diagram
from vad.strokes.force_tracks import force_tracks
from vad.strokes.forces import force_cells, force_polygons

DIAGRAM = Diagram.of_balancing(
    "force", "Forces", 3, "vectors", ("N", force_polygons, force_cells, force_tracks)
)
