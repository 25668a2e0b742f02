"""The polygon of couples of a shaft."""

from vad.strokes.diagram import Diagram

DIAGRAM = Diagram.of_balancing("couple", "Couples", 2.4, "vectors")
