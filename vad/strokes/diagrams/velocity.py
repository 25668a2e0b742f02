"""The velocity polygon."""

from vad.strokes.diagram import VELOCITY, Diagram

DIAGRAM = Diagram.of_order(VELOCITY, rank=1, picture="vectors")
