"""The position diagram: the mechanism itself, constructed."""

from vad.strokes.diagram import Diagram
from vad.strokes.order import POSITION

DIAGRAM = Diagram.of_order(POSITION, rank=0, picture="skeleton")
