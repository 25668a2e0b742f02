"""An engine from the end of its shaft and from the side."""

from vad.strokes.diagram import Diagram

DIAGRAM = Diagram.of_balancing("engine", "Engine", 2.3, "views")
