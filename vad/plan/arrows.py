"""The vectors of a polygon in their place on the page.

In come a panel's strokes and its scale, out go vectors that know their weight, what of them is
to be seen, and what labels must keep clear of.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.plan import vectors
from vad.plan.art import FOREVER, Growth, Level, Look, PanelArt
from vad.plan.labels import Obstacles
from vad.plan.marks import Mark
from vad.plan.scale import Scale
from vad.plan.vertices import visible_start
from vad.strokes.sheet import Arrow, Panel, Stroke


@dataclass(frozen=True, slots=True)
class Vector:
    """A vector in pixels.

    Attributes
    ----------
    start, end
        Its vertices.
    seen
        Where what is to be seen of it starts; None where it lies under another one.
    whole
        True beside its own parts or for an image vector: drawn lighter.
    """

    look: Look
    link: str | None
    start: complex
    end: complex
    seen: complex | None
    whole: bool

    @property
    def width(self) -> float:
        """The width of its shaft, before the style's weight."""
        return (vectors.WHOLE if self.whole else vectors.VECTOR) * self.look.unit

    def marks(self, grown: float = 1.0) -> list[Mark]:
        """Return the vector, as far as it is drawn."""
        if self.seen is None:
            return []
        line, ink = self.look.line(self.link), self.look.ink(self.link)
        look = self.look
        return vectors.vector(
            look.style, line, ink, self.seen, self.end, look.unit, self.whole, grown
        )

    def growing(self, grown: float) -> list[Mark]:
        """Return the vector being drawn, with the light beneath it."""
        foot = self.start if self.seen is None else self.seen
        tip = foot + grown * (self.end - foot)
        light = vectors.underlay(self.look.ink(self.link), self.width, self.start, tip)
        return [light, *self.marks(grown)]

    def block(self, obstacles: Obstacles, index: int) -> None:
        """Add shaft and head to what labels keep clear of, from stroke ``index`` on."""
        span = index, FOREVER
        weight = self.look.line(self.link).weight
        obstacles.line([self.start, self.end], self.width * weight / 2, span)
        unit, way = self.look.unit, vectors.direction_of(self.start, self.end)
        head = vectors.head_length(abs(self.end - self.start), unit, self.whole)
        tip = self.end - vectors.TIP_GAP * unit * way
        base, half = tip - head * way, 1j * vectors.HEAD_HALF_WIDTH * head * way
        obstacles.line([tip, base + half, base - half, tip], 0.5, span)


def is_whole(stroke: Stroke, panel: Panel) -> bool:
    """Tell whether a vector stands beside its parts, or is found by the image."""
    if stroke.image or stroke.component == "relative":
        return True
    whole = stroke.shape
    if stroke.component != "absolute" or not isinstance(whole, Arrow):
        return False
    parts = [
        other.shape
        for other in panel.strokes
        if other.link == stroke.link
        and other.component in ("normal", "tangential")
        and isinstance(other.shape, Arrow)
    ]
    return any(part.tail == whole.tail for part in parts) and any(
        part.head == whole.head for part in parts
    )


def vector_of(panel: Panel, index: int, scale: Scale, look: Look) -> Vector:
    """Return the vector of one stroke, which must be an arrow."""
    stroke = panel.strokes[index]
    assert isinstance(stroke.shape, Arrow)
    return Vector(
        look,
        stroke.link,
        scale(stroke.shape.start),
        scale(stroke.shape.end),
        visible_start(panel, index, scale, look.unit),
        is_whole(stroke, panel),
    )


def add_vector(art: PanelArt, panel: Panel, index: int, look: Look) -> None:
    """Add one vector to a panel's art and obstacles."""
    vector = vector_of(panel, index, art.scale, look)
    art.add(Level.STROKE, index + 1, vector.marks())
    vector.block(art.obstacles, index)


def vector_growth(art: PanelArt, panel: Panel, index: int, look: Look) -> Growth:
    """Return how one vector is drawn."""
    return Growth(Level.STROKE, vector_of(panel, index, art.scale, look).growing)
