"""The velocity polygon."""

from vad.strokes.diagram import Diagram
from vad.strokes.order import VELOCITY

DIAGRAM = Diagram.of_order(VELOCITY, rank=1, picture="vectors")
