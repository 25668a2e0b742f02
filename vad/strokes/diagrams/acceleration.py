"""The acceleration polygon."""

from vad.strokes.diagram import Diagram
from vad.strokes.order import ACCELERATION

DIAGRAM = Diagram.of_order(ACCELERATION, rank=2, picture="vectors")
