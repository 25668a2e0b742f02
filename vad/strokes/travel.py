"""A travel: what a vector comes from, and where it lands."""

from __future__ import annotations

import cmath
import math
from typing import Literal, NamedTuple

#: What a vector is to what it comes from: a link that is turned, or that points back; the link of a
#: point that the image finds, which is turned; v or another vector that is turned; an axis along
#: which it lies.  An area is the image of a link.
TravelKind = Literal["tangential", "normal", "point", "coriolis", "turned", "axial", "image"]


class Travel(NamedTuple):
    """From where a vector comes, or the image of a link.

    Attributes
    ----------
    kind
        What it is to its source.
    source
        The name of the panel that it leaves.
    tail, head
        Where its tail and its head are there, before it is turned: the ends of a link, vector or
        axis.
    start, end
        Its tail and its head in its own panel.
    by
        The row of the link on which a block slides, and whose ω turns its velocity to a Coriolis
        acceleration; None for other vectors, and in a cylinder, which is a link itself.
    """

    kind: TravelKind
    source: str
    tail: complex
    head: complex
    start: complex
    end: complex
    by: str | None = None

    @property
    def turn(self) -> float:
        """By how many degrees it turns in the panel that it leaves, counter-clockwise positive."""
        return math.degrees(cmath.phase((self.end - self.start) / (self.head - self.tail)))
