"""The change of the tractive force of a locomotive, and its swaying couple."""

from vad.strokes.diagram import Diagram

DIAGRAM = Diagram.of_balancing("traction", "Tractive force", 3.2, "vectors")
