"""The lettered points of a panel, and their labels.

In come strokes and a scale, out go vertices (coincident ones share a dot and a label) and,
once they are placed, the items of their labels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from vad.plan.carriers import reached
from vad.plan.geometry import direction_of
from vad.plan.items import FOREVER, Level
from vad.plan.labels.placing import outward, place
from vad.plan.lettering.glyphs import ink_size, typeset
from vad.plan.lettering.runs import Runs, symbols
from vad.plan.marks import Lettering, Mark, line
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arrow, Dot, Line, Panel

LETTER = 0.040
COINCIDENT = 0.012


@dataclass
class Vertex:
    """A point with its letters; ``since`` holds the number of the stroke that brings each."""

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
    points = reached(panel)
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Dot):
            points.append(stroke.shape.at)
        elif isinstance(stroke.shape, Arrow):
            points += [stroke.shape.start, stroke.shape.end]
        elif isinstance(stroke.shape, Line):
            points += [stroke.shape.through, stroke.shape.until]
    return points


def find_vertices(panel: Panel, scale: Scale) -> list[Vertex]:
    """Return the vertices of ``panel`` in the order in which they appear."""
    found: list[Vertex] = []

    def vertex(letters: str, z: complex, since: int) -> Vertex:
        at = scale(z)
        near = [v for v in found if abs(v.at - at) < COINCIDENT]
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
            spot = vertex(stroke.label, shape.at, index)
            spot.fixed = spot.fixed or stroke.kind == "fixed"
        elif isinstance(shape, Arrow):
            tail = vertex(shape.tail, shape.start, index)
            head = vertex(shape.head, shape.end, index)
            way = direction_of(scale(shape.start), scale(shape.end))
            tail.ways.append(way)
            head.ways.append(-way)
    for spot in found:
        # A shared dot lies amid its points, so that it covers the ends of all their strokes.
        apart = list(dict.fromkeys(spot.points))
        spot.at = sum(apart, 0j) / len(apart)
    return [spot for spot in found if spot.letters]


def text_at(
    runs: Runs, whole: Runs, centre: complex, size: float, role: str, row: int | None = None
) -> Mark:
    """Return text so placed that the ink box of ``whole`` is centred at ``centre``."""
    shape = typeset(whole)
    middle = complex(shape.left + shape.right, shape.bottom + shape.top) / 2
    return Mark(Lettering(runs, centre - middle * size, size), role, row)


def label_vertices(
    sketch: Sketch, vertices: Sequence[Vertex], radius: float, near: Sequence[float]
) -> None:
    """Place the labels of all vertices, each once for all strokes."""
    setting = sketch.setting
    strokes = setting.panel.strokes
    for vertex in vertices:
        whole = symbols(vertex.label)
        wide, high = ink_size(whole, LETTER)
        rivals = [other.at for other in vertices if other is not vertex]
        first = outward(vertex.ways)
        placed = place(sketch.obstacles, vertex.at, first, wide, high, radius, near, rivals)
        sketch.tags.append(Tag(vertex.label, placed.box))
        if placed.leader:
            index = vertex.since[0]
            leader = line(placed.leader, "leader")
            sketch.add(strokes[index], Level.LABEL, setting.after(index), [leader])
        for count, index in enumerate(vertex.since, start=1):
            later = [since for since in vertex.since[count:] if since > index]
            if count < len(vertex.since) and vertex.since[count] == index:
                continue
            runs = symbols(", ".join(vertex.letters[:count]))
            sketch.add(
                strokes[index],
                Level.LABEL,
                setting.after(index),
                [text_at(runs, whole, placed.centre, LETTER, "letter")],
                setting.after(min(later)) if later else FOREVER,
            )
