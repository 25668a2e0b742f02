"""A shaft from its end and from the side."""

from vad.strokes.diagram import Diagram

DIAGRAM = Diagram.of_balancing("shaft", "Shaft", 2.2, "views")
