"""The hammer blows of the wheels of a locomotive."""

from vad.strokes.diagram import Diagram

DIAGRAM = Diagram.of_balancing("hammer", "Hammer blow", 3.4, "vectors")
