"""The polygons of secondary forces and couples of an engine."""

from vad.strokes.diagram import Diagram

DIAGRAM = Diagram.of_balancing("secondary", "Secondary forces", 2.8, "vectors")
