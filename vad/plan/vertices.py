"""The lettered points of a panel, and their labels.

In come strokes and a scale, out go vertices (coincident ones share a dot and a label) and,
once they are placed, the marks of their labels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from vad.plan.art import Level, Look, PanelArt, Tag
from vad.plan.labels import Obstacles, outward, place
from vad.plan.marks import Mark, Pen, polyline
from vad.plan.scale import Scale
from vad.plan.text import Runs, outline, symbols, write
from vad.plan.vectors import direction_of
from vad.strokes.sheet import Arrow, Dot, Panel

LABEL = 0.040
HALO = 0.009
COINCIDENT = 0.012
LEADER_WIDTH = 0.0018


@dataclass
class Vertex:
    """A point with its letters; ``since`` holds the number of strokes at which each appears."""

    at: complex
    letters: list[str] = field(default_factory=list)
    since: list[int] = field(default_factory=list)
    ways: list[complex] = field(default_factory=list)
    fixed: bool = False
    points: list[complex] = field(default_factory=list)

    @property
    def label(self) -> str:
        """The letters, as they are written at last."""
        return ", ".join(self.letters)


def corners(panel: Panel) -> list[complex]:
    """Return the points of a panel that have to be on the page, in its own unit."""
    points: list[complex] = []
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Dot):
            points.append(stroke.shape.at)
        elif isinstance(stroke.shape, Arrow):
            points += [stroke.shape.start, stroke.shape.end]
    return points


def find_vertices(panel: Panel, scale: Scale, unit: float) -> list[Vertex]:
    """Return the vertices of ``panel`` in the order in which they appear."""
    found: list[Vertex] = []

    def vertex(letters: str, z: complex, since: int) -> Vertex:
        at = scale(z)
        near = [v for v in found if abs(v.at - at) < COINCIDENT * unit]
        if near:
            spot = min(near, key=lambda v: abs(v.at - at))
        else:
            spot = Vertex(at)
            found.append(spot)
        spot.points.append(at)
        for letter in letters.split(","):
            if letter.strip() and letter.strip() not in spot.letters:
                spot.letters.append(letter.strip())
                spot.since.append(since)
        return spot

    for index, stroke in enumerate(panel.strokes):
        shape = stroke.shape
        if isinstance(shape, Dot):
            spot = vertex(stroke.label, shape.at, index + 1)
            spot.fixed = spot.fixed or stroke.kind == "fixed"
        elif isinstance(shape, Arrow):
            tail = vertex(shape.tail, shape.start, index + 1)
            head = vertex(shape.head, shape.end, index + 1)
            way = direction_of(scale(shape.start), scale(shape.end))
            tail.ways.append(way)
            head.ways.append(-way)
    for spot in found:
        # A shared dot lies amid its points, so that it covers the ends of all their strokes.
        apart = list(dict.fromkeys(spot.points))
        spot.at = sum(apart, 0j) / len(apart)
    return [spot for spot in found if spot.letters]


def visible_start(panel: Panel, index: int, scale: Scale, unit: float) -> complex | None:
    """Return where a vector leaves what is drawn already: its start, or farther along it.

    An image vector goes on from the end of the vector that it prolongs.  None where another
    vector joins the same two vertices, so that nothing of this one would show.
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
        near = COINCIDENT * unit
        if abs(tail - start) < near and abs(head - end) < near:
            return None
        same_way = abs(direction_of(tail, head) - direction_of(start, end)) < 1e-6
        if abs(tail - start) < 1e-6 and same_way and abs(seen - start) < abs(head - start):
            seen = head
    return seen if abs(seen - start) < abs(end - start) else None


def text_box(runs: Runs, size: float) -> tuple[float, float]:
    """Return the width and height of the ink of a line of text."""
    shape = outline(runs)
    return (shape.right - shape.left) * size, (shape.top - shape.bottom) * size


def text_at(
    runs: Runs, whole: Runs, centre: complex, size: float, ink: str, halo: Pen | None
) -> list[Mark]:
    """Return text so placed that the ink box of ``whole`` is centred at ``centre``."""
    shape = outline(whole)
    middle = complex(shape.left + shape.right, shape.bottom + shape.top) / 2
    return write(runs, centre - middle * size, size, ink, halo=halo)


def halo(look: Look) -> Pen:
    """Return the background pen beneath labels."""
    return Pen(look.style.background, HALO * look.unit, (), "round", "round")


def label_vertices(
    art: PanelArt,
    vertices: Sequence[Vertex],
    obstacles: Obstacles,
    look: Look,
    radius: float,
    near: Sequence[float],
) -> None:
    """Place the labels of all vertices, each once for all strokes, and add them to ``art``."""
    unit, size = look.unit, LABEL * look.unit
    for vertex in vertices:
        whole = symbols(vertex.label)
        wide, high = text_box(whole, size)
        rivals = [other.at for other in vertices if other is not vertex]
        first = outward(vertex.ways)
        placed = place(obstacles, vertex.at, first, wide, high, unit, radius, near, rivals)
        art.tags.append(Tag(vertex.label, placed.box))
        if placed.leader:
            pen = Pen(look.style.grey, LEADER_WIDTH * unit)
            art.add(Level.LABEL, vertex.since[0], [polyline(placed.leader, pen)])
        for count, since in enumerate(vertex.since, start=1):
            until = min([s for s in vertex.since[count:] if s > since], default=None)
            if count < len(vertex.since) and vertex.since[count] == since:
                continue
            runs = symbols(", ".join(vertex.letters[:count]))
            marks = text_at(runs, whole, placed.centre, size, look.style.text, halo(look))
            if until is None:
                art.add(Level.LABEL, since, marks)
            else:
                art.add(Level.LABEL, since, marks, until)
