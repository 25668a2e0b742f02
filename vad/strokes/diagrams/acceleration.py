"""The acceleration polygon."""

from vad.strokes.diagram import ACCELERATION, Diagram

DIAGRAM = Diagram.of_order(ACCELERATION, rank=2, picture="vectors")
