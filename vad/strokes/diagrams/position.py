"""The position diagram: the mechanism itself, constructed."""

from vad.strokes.diagram import POSITION, Diagram

DIAGRAM = Diagram.of_order(POSITION, rank=0, picture="skeleton")
