"""The pencil that draws a polygon: it keeps the strokes so far and where every vertex is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Generic, Protocol

from vad.strokes.sentences import Sentence
from vad.strokes.sheet import (
    POLE,
    Arrow,
    Coincidence,
    CoriolisInset,
    Dot,
    Kind,
    Line,
    Stroke,
    StrokePart,
)
from vad.strokes.vector_equations import NOTHING, Part, V


class Words(Protocol[V]):
    """What is said of the strokes of a polygon."""

    def known(self, label: str, part: Part[V]) -> Sentence:
        """Work out a component that is known before the crossing."""

    def line(self, part: Part[V], point: str, meeting: str) -> Sentence:
        """Say why the next vertex must lie on a construction line."""

    def crossing(self, letter: str, pole: bool, zeros: list[tuple[Part[V], str]]) -> Sentence:
        """Say what lies where the two lines cross, and which results are zero there."""

    def measured(self, label: str, part: Part[V]) -> Sentence:
        """Measure a result off the polygon."""

    def whole(self, label: str, size: float, vector: V) -> Sentence | str:
        """Measure a whole vector beside its parts."""


class Tip:
    """Where the drawing of one chain has got to: the vertex and its coordinates.

    ``name`` is the vertex's letter as it is drawn, ``full`` what it would be if no vector of the
    chain had vanished.
    """

    def __init__(self, name: str, at: complex) -> None:
        self.name = self.full = name
        self.at = at


class Pencil(Generic[V]):
    """Strokes and vertices of the polygon of an order.

    Parameters
    ----------
    words
        What is said of them.
    place
        From a vertex to where it truly is.
    longest
        The length of the longest part; 0 where nothing moves.
    fixed
        The vertices at the pole.
    from_pole
        Whether the polygon begins at the pole, and does not find it by a crossing.
    """

    def __init__(
        self,
        words: Words[V],
        place: Callable[[str], complex],
        longest: float,
        fixed: list[str],
        from_pole: bool = True,
    ) -> None:
        self.words = words
        self.place = place
        self.resting = longest == 0.0
        self.fixed = fixed
        self._nothing = NOTHING * longest
        self.from_pole = from_pole
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []
        self.vertices: dict[str, complex] = dict.fromkeys(fixed, 0j) if from_pole else {}
        self.inset: CoriolisInset | None = None

    def shows(self, vector: complex) -> bool:
        """Tell whether a vector is long enough to be drawn."""
        return not self.resting and abs(vector) > self._nothing

    def add(self, stroke: Stroke) -> Stroke:
        """Append a stroke and return it; a polygon at rest is not drawn but for its pole."""
        if self.resting:
            self.leave_out(stroke)
        else:
            self.strokes.append(stroke)
        return stroke

    def begin(self, said: Sentence, rows: tuple[str, ...] = ()) -> None:
        """Draw the pole, where all fixed vertices are; ``rows`` are measured there already."""
        pole = Stroke("pole", ",".join(self.fixed), Dot(0j), said, reveals=rows, part=POLE)
        self.strokes.append(pole)

    def share_pole(self, letter: str) -> None:
        """Write a point that does not move, though it could, beside the pole's letters."""
        if self.from_pole and not self.resting:
            pole = self.strokes[0]
            self.strokes[0] = replace(pole, label=f"{pole.label},{letter}")

    def known(self, part: Part[V], tip: Tip, name: str, at: complex | None = None) -> Stroke:
        """Draw a known part from the tip of its chain, or towards it, and move the tip."""
        new = tip.at + (-part.vector if part.reverse else part.vector) if at is None else at
        arrow = _arrow(part, tip.name, tip.at, name, new)
        said = self.words.known(arrow.tail + arrow.head, part)
        stroke = _stroke("known", part, arrow, said)
        self.vertices[name] = new
        tip.name, tip.at = name, new
        return self.add(stroke)

    def vanish(self, kind: Kind, part: Part[V], tip: Tip, name: str) -> None:
        """Keep a part of length zero, with the letters that it would have."""
        arrow = _arrow(part, tip.full, tip.at, name, tip.at)
        self.leave_out(_stroke(kind, part, arrow))

    def line(self, part: Part[V], tip: Tip, end: str) -> None:
        """Draw the construction line of an unknown part, past the crossing at ``end``."""
        crossing = self.place(end)
        away = (part.direction.conjugate() * (crossing - tip.at)).real < 0
        direction = -part.direction if away else part.direction
        said = self.words.line(part, tip.name, end)
        line = Line(tip.at, direction, crossing, part.square_to)
        own = StrokePart(part.of.name, "line")
        self.add(Stroke("construction", part.label, line, said, part.of.owner, part=own))

    def crossing(self, end: str, point: str, zeros: list[tuple[Part[V], str]]) -> None:
        """Mark the image of a point where two lines cross.

        ``zeros`` vanish there, each at its vertex.
        """
        at = self.place(end)
        self.vertices[end] = at
        fixed = end in self.fixed
        part = POLE if fixed and not self.from_pole else StrokePart(point, "crossing")
        if self.resting and part == POLE:
            return  # it is drawn already
        said = self.words.crossing(end, fixed, zeros)
        reveals = tuple(row for zero, _ in zeros for row in zero.of.reveals)
        self.add(Stroke("intersection", end, Dot(at), said, reveals=reveals, part=part))

    def result(self, part: Part[V], tip: Tip, end: str) -> Stroke:
        """Ink the part that the crossing has found."""
        arrow = _arrow(part, tip.name, tip.at, end, self.vertices[end])
        said = self.words.measured(arrow.tail + arrow.head, part)
        return self.add(_stroke("result", part, arrow, said, part.of.reveals))

    def whole(self, vector: V, several: bool) -> None:
        """Ink the sum of a vector's parts; without ``several`` to be seen, it is left out."""
        tail, head = vector.tail, vector.head
        start, end = self.place(tail), self.place(head)
        label, arrow = tail + head, Arrow(start, end, tail, head)
        said = self.words.whole(label, abs(end - start), vector) if several else ""
        row, part = vector.owner, StrokePart(vector.name, "whole")
        stroke = Stroke("result", label, arrow, said, row, vector.whole, part=part)
        if several:
            self.add(stroke)
        else:
            self.leave_out(stroke)

    @property
    def coincident(self) -> tuple[Coincidence, ...]:
        """The vertices that have one place: those at the pole, and the ends of zero vectors."""
        found = [Coincidence(tuple(self.fixed), "fixed")] if len(self.fixed) > 1 else []
        for stroke in self.zeros:
            match stroke.shape:
                case Arrow(tail=tail, head=head) if tail != head and stroke.kind != "construction":
                    found.append(Coincidence((tail, head), "zero"))
        return tuple(dict.fromkeys(found))

    def leave_out(self, stroke: Stroke) -> None:
        """Keep what is not drawn in this pose."""
        spoken = stroke.said or stroke.reveals
        self.zeros.append(replace(stroke, said="", reveals=()) if spoken else stroke)


def _arrow(part: Part[V], tip: str, tip_at: complex, name: str, at: complex) -> Arrow:
    """Return the arrow between the tip of a chain and ``name``, which runs with its step."""
    return Arrow(at, tip_at, name, tip) if part.reverse else Arrow(tip_at, at, tip, name)


def _stroke(
    kind: Kind,
    part: Part[V],
    arrow: Arrow,
    said: Sentence | str = "",
    reveals: tuple[str, ...] = (),
) -> Stroke:
    """Return the stroke of a part."""
    label = part.symbol or arrow.tail + arrow.head
    row, own = part.of.owner, part.drawn
    return Stroke(kind, label, arrow, said, row, part.component, reveals=reveals, part=own)
