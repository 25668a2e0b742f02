"""The polygons of primary forces and couples of an engine."""

from vad.strokes.diagram import Diagram

DIAGRAM = Diagram.of_balancing("primary", "Primary forces", 2.6, "vectors")
