"""Klein's construction: the velocity and the acceleration of a slider-crank on its drawing."""

from vad.strokes.diagram import Diagram, is_slider_crank
from vad.strokes.klein import klein_cells, klein_drawing, klein_tracks

DIAGRAM = Diagram(
    "klein",
    "Klein’s construction",
    0.4,
    "skeleton",
    lambda scene: scene.unit,
    klein_drawing,
    klein_cells,
    klein_tracks,
    usual=False,
    applies=is_slider_crank,
    by_hand=False,  # it holds for an even speed alone
)
