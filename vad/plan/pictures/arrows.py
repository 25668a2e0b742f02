"""The vectors of a polygon in their place on the page.

In come a panel's strokes and its scale, out go vectors that know their weight, their lane, what of
them is to be seen, and what labels must keep clear of.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from vad.plan.geometry import direction_of
from vad.plan.growth import Trimming
from vad.plan.items import FOREVER, Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.vertices import COINCIDENT
from vad.plan.marks import Mark, line
from vad.plan.pictures.lanes import ALONE, Lane, Pen, lanes
from vad.plan.pictures.straight import head_of, vector
from vad.plan.roles import ROLES
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arrow, Panel, Stroke


@dataclass(frozen=True, slots=True)
class PlacedVector:
    """A vector on the page.

    Attributes
    ----------
    start, end
        Its vertices.
    seen
        Where what is to be seen of it starts; None where it lies under another one.
    whole
        True beside its own parts or for an image vector: drawn lighter.
    row
        Whose ink it takes.
    lane
        Where it runs beside vectors on the same line.
    """

    start: complex
    end: complex
    seen: complex | None
    whole: bool
    row: int | None
    lane: Lane = ALONE

    @property
    def role(self) -> str:
        """The role of its shaft."""
        return "whole" if self.whole else "vector"

    def marks(self) -> list[Mark]:
        """Return what is to be seen of it."""
        if self.seen is None:
            return []
        return vector(self.seen, self.end, self.row, self.role, self.whole, self.lane)

    def light(self) -> Mark:
        """Return the light beneath it while it is drawn."""
        return line(self._shaft(), f"{self.role} light", self.row, Trimming())

    def block(self, obstacles: Obstacles, since: int) -> None:
        """Add shaft and head to what labels keep clear of."""
        span = since, FOREVER
        obstacles.line(self._shaft(), ROLES[self.role].width / 2, span)
        tip, left, _, right = head_of(self.start, self.end, self.whole, self.lane)
        obstacles.line([tip, left, right, tip], 0.5 * PIXEL, span)

    def _shaft(self) -> list[complex]:
        return [self.start + self.lane.aside, self.end + self.lane.aside]


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


def place_vectors(sketch: Sketch) -> dict[int, PlacedVector]:
    """Return all vectors of a panel by the numbers of their strokes.

    Those that lie on one line stand side by side.
    """
    panel, scale = sketch.setting.panel, sketch.scale
    placed: dict[int, PlacedVector] = {}
    for index, stroke in enumerate(panel.strokes):
        if isinstance(stroke.shape, Arrow):
            start, end = scale(stroke.shape.start), scale(stroke.shape.end)
            seen, whole = visible_start(panel, index, scale), is_whole(stroke, panel)
            row = sketch.setting.row(stroke.link)
            placed[index] = PlacedVector(start, end, seen, whole, row)
    pens = {
        index: Pen(vector.seen, vector.end, ROLES[vector.role].width)
        for index, vector in placed.items()
        if vector.seen is not None
    }
    for index, lane in lanes(pens).items():
        placed[index] = replace(placed[index], lane=lane)
    return placed


def vector_of(sketch: Sketch, index: int) -> PlacedVector:
    """Return the vector of one stroke, which must be an arrow."""
    return place_vectors(sketch)[index]


def add_vector(sketch: Sketch, index: int, placed: PlacedVector) -> None:
    """Add one vector and the light beneath it."""
    setting = sketch.setting
    stroke, during = setting.panel.strokes[index], setting.during(index)
    sketch.add(stroke, Level.STROKE, during, [placed.light()], setting.over(index))
    sketch.add(stroke, Level.STROKE, during, placed.marks())
    placed.block(sketch.obstacles, during)


def visible_start(panel: Panel, index: int, scale: Scale) -> complex | None:
    """Return where a vector leaves what is drawn already: its start, or farther along it.

    An image vector goes on from the end of the vector that it prolongs.  None where another
    vector of its link joins the same two vertices, so that nothing of this one would show.
    """
    stroke = panel.strokes[index]
    arrow = stroke.shape
    assert isinstance(arrow, Arrow)
    start, end = scale(arrow.start), scale(arrow.end)
    seen = start
    for other in panel.strokes[:index]:
        shape = other.shape
        if not isinstance(shape, Arrow) or other.link != stroke.link:
            continue
        tail, head = scale(shape.start), scale(shape.end)
        if abs(tail - start) < COINCIDENT and abs(head - end) < COINCIDENT:
            return None
        same_way = abs(direction_of(tail, head) - direction_of(start, end)) < 1e-6
        if abs(tail - start) < 1e-9 and same_way and abs(head - start) < abs(end - start):
            seen = max(seen, head, key=lambda spot: abs(spot - start))
    return seen
