"""The player of vector equations, and the pencil with which it draws.

Known components are laid tip to tail.  Two lines are drawn in the directions of the unknown
components, and cross.  The unknown components, which end at the crossing, are inked and measured.
The pencil keeps the strokes so far and the place of every vertex.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Generic, Protocol

from vad.kinematics.numbers import facing
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
    Term,
)
from vad.strokes.vector_equations import NOTHING, Chain, Part, Side, V, VectorEquation


class PencilCaptions(Protocol[V]):
    """The captions that a pencil asks for; ``say`` makes a sentence of a phrase and its parts."""

    say: Callable[..., Sentence]

    def known(self, label: str, part: Part[V]) -> Sentence:
        """Calculate a component that is known before the lines cross."""

    def line(self, part: Part[V], point: str, meeting: str) -> Sentence:
        """Say why the next vertex must lie on a construction line."""

    def without(self, part: Part[V], said: Sentence) -> Sentence:
        """Say before what is said of a line that a known component before it is zero."""
        return said

    def crossing(self, letter: str, pole: bool, zeros: list[tuple[Part[V], str]]) -> Sentence:
        """Say what lies where the two lines cross, and which results are zero there."""

    def measured(self, label: str, part: Part[V]) -> Sentence:
        """Measure a result off the polygon."""

    def whole(self, label: str, size: float, vector: V) -> Sentence | str:
        """State the length of a whole vector, whose components are drawn already."""


#: A vector shorter than this share of the longest one is not seen, even in a lens.
UNSEEN = 2e-4


class Tip:
    """The vertex at which the drawing of a chain stands, and its coordinates.

    ``name`` is the letter of the vertex as it is drawn.  ``full`` is the letter that it would have
    if no vector of the chain were zero.
    """

    def __init__(self, name: str, at: complex) -> None:
        self.name = self.full = name
        self.at = at


class Pencil(Generic[V]):
    """Strokes and vertices of the polygon of an order.

    Parameters
    ----------
    words
        Their captions.
    place
        The function from a vertex to its true coordinates.
    longest
        The length of the longest part; 0 where nothing moves.
    fixed
        The vertices at the pole.
    from_pole
        Whether the polygon begins at the pole, and does not find it by a crossing.
    """

    def __init__(
        self,
        words: PencilCaptions[V],
        place: Callable[[str], complex],
        longest: float,
        fixed: list[str],
        from_pole: bool = True,
    ) -> None:
        self.words = words
        self.place = place
        self.resting = longest == 0.0
        self.fixed = fixed
        self._nothing, self._unseen = NOTHING * longest, UNSEEN * longest
        self.from_pole = from_pole
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []
        self.vertices: dict[str, complex] = dict.fromkeys(fixed, 0j) if from_pole else {}
        self.inset: CoriolisInset | None = None
        #: The known components of length zero.
        self._gone: list[Part[V]] = []

    def shows(self, vector: complex) -> bool:
        """Tell whether a vector is long enough to be drawn."""
        return not self.resting and abs(vector) > self._nothing

    def add(self, stroke: Stroke) -> Stroke:
        """Append a stroke and return it.  A polygon at rest has no stroke but the pole.

        The caption of a vector that nobody will see says so.
        """
        if self.resting:
            self.leave_out(stroke)
            return stroke
        match stroke.shape:
            case Arrow(start, end) if stroke.said and abs(end - start) < self._unseen:
                stroke = replace(stroke, said=self.words.say("too small", said=stroke.said))
        self.strokes.append(stroke)
        return stroke

    def begin(self, said: Sentence, rows: tuple[str, ...] = ()) -> None:
        """Draw the pole, where all fixed vertices are; ``rows`` are the results that it shows."""
        pole = Stroke("pole", ",".join(self.fixed), Dot(0j), said, reveals=rows, part=POLE)
        self.strokes.append(pole)

    def share_pole(self, letter: str) -> None:
        """Add the letter of a point that stands still in this pose to the letters at the pole."""
        if self.from_pole and not self.resting:
            pole = self.strokes[0]
            self.strokes[0] = replace(pole, label=f"{pole.label},{letter}")

    def known(self, part: Part[V], tip: Tip, name: str, at: complex | None = None) -> Stroke:
        """Draw a known part at the tip of its chain, and move the tip to its other end."""
        new = tip.at + (-part.vector if part.reverse else part.vector) if at is None else at
        arrow = _arrow(part, tip.name, tip.at, name, new)
        said = self.words.known(arrow.tail + arrow.head, part)
        stroke = _stroke("known", part, arrow, said)
        self.vertices[name] = new
        tip.name, tip.at = name, new
        return self.add(stroke)

    def vanish(self, kind: Kind, part: Part[V], tip: Tip, name: str) -> None:
        """Record a component of length zero, which is not drawn, with the letters it would have."""
        arrow = _arrow(part, tip.full, tip.at, name, tip.at)
        self.leave_out(_stroke(kind, part, arrow))
        if kind == "known":
            self._gone.append(part)

    def line(self, part: Part[V], tip: Tip, end: str) -> None:
        """Draw the construction line of an unknown part, past the crossing at ``end``."""
        crossing = self.place(end)
        direction = facing(part.direction, crossing - tip.at)
        said = self.words.line(part, tip.name, end)
        for gone in (each for each in self._gone if each.of is part.of):
            said = self.words.without(gone, said)
        line = Line(tip.at, direction, crossing, part.square_to)
        own = StrokePart(part.of.name, "line")
        self.add(Stroke("construction", part.label, line, said, part.of.owner, part=own))

    def crossing(self, end: str, point: str, zeros: list[tuple[Part[V], str]]) -> None:
        """Mark the image of a point where two lines cross.

        ``zeros`` are the components that are zero in this pose, each with its vertex.
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
        """Ink the sum of a vector's parts; leave it out if not ``several`` of them are drawn."""
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
            match stroke.shape:  # a whole vector may be left out because it has but one part
                case Arrow(start, end, tail, head) if tail != head and not self.shows(end - start):
                    found.append(Coincidence((tail, head), "zero"))
        return tuple(dict.fromkeys(found))

    def leave_out(self, stroke: Stroke) -> None:
        """Record a stroke that is not drawn in this pose."""
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


@dataclass
class Trace(Generic[V]):
    """A chain that is being drawn: its tip, and the known parts that are not laid yet.

    ``walked`` is the last of its vectors that were drawn before.
    """

    chain: Chain[V]
    tip: Tip
    known: list[Part[V]]
    walked: V | None = None
    side: Side = field(default_factory=Side)


class Player(Generic[V]):
    """Draws one equation after the other.

    ``begins`` holds the number of the first stroke of each equation.
    """

    def __init__(self, pencil: Pencil[V]) -> None:
        self.pencil = pencil
        self.begins: list[int] = []
        #: The letters of known parts' ends, drawn or not.
        self._letters: set[str] = set()

    def play(self, equation: VectorEquation[V]) -> list[Trace[V]]:
        """Draw one equation and return its chains with all that was drawn of them."""
        self.begins.append(len(self.pencil.strokes))
        traces = [self.begin(chain) for chain in equation.chains]
        self.set_out(traces)
        # What the driver gives comes first, then chain after chain.
        for trace in traces:
            self.lay(trace, [part for part in trace.known if part.dictated])
        self.after_driver()
        for trace in traces:
            self.lay(trace, [part for part in trace.known if not part.dictated])
            if trace.chain.unknown is not None:
                self.pencil.line(trace.chain.unknown, trace.tip, equation.end)
        self._cross(traces, equation)
        return traces

    def begin(self, chain: Chain[V]) -> Trace[V]:
        """Return a chain of which nothing is drawn yet."""
        at = self.pencil.vertices.setdefault(chain.start, self.pencil.place(chain.start))
        return Trace(chain, Tip(chain.start, at), chain.known)

    def set_out(self, traces: Sequence[Trace[V]]) -> None:
        """Do what comes before an equation's first stroke."""

    def after_driver(self) -> None:
        """Do what comes after the components that the driver gives."""

    # --- known parts --------------------------------------------------------------------------

    def lay(self, trace: Trace[V], parts: list[Part[V]]) -> None:
        """Draw known parts tip to tail."""
        pencil, tip = self.pencil, trace.tip
        seen = [part for part in parts if pencil.shows(part.vector)]
        for part in parts:
            vector, last = part.of, _last(part, parts)
            arrives = trace.chain.wholly_known(vector) and vector.arrives
            full = self._end_name(part, arrives and last)
            if part in seen:
                ends = arrives and _last(part, seen)
                exact = pencil.place(vector.head) if ends else None
                stroke = pencil.known(part, tip, self._end_name(part, ends), exact)
                trace.side.add(vector, _term(stroke))
            else:
                pencil.vanish("known", part, tip, full)
            tip.full = full
            self._letters.add(full)
            if last and arrives:
                self._arrive(vector, tip, sum(other.of is vector for other in seen))

    def _arrive(self, vector: V, tip: Tip, seen: int) -> None:
        """Finish a vector that is wholly known; ``seen`` is how many of its parts are drawn."""
        if not seen and vector.lettered:
            self.pencil.vertices[vector.head] = tip.at
            if tip.at == 0j:  # it could move, but stands still
                self.pencil.share_pole(vector.head)
            tip.name = vector.head
        if vector.whole:
            self.pencil.whole(vector, seen > 1)

    def _end_name(self, part: Part[V], arrived: bool) -> str:
        """Name the vertex at the end of a known part: b′, b′ₙ, cₙ, c″ₙ, s′ or z."""
        if arrived:
            return part.of.head
        letter, n, _ = part.stage.partition("ₙ")
        return part.stage if not n or part.stage not in self._letters else f"{letter}″{n}"

    # --- the crossing and what it shows -------------------------------------------------------

    def _cross(self, traces: Sequence[Trace[V]], equation: VectorEquation[V]) -> None:
        end = equation.end
        found = [(t.chain.unknown, t) for t in traces if t.chain.unknown is not None]
        seen = [(part, trace) for part, trace in found if self.pencil.shows(part.vector)]
        zero = [(part, trace) for part, trace in found if (part, trace) not in seen]
        self.pencil.crossing(end, equation.point, [(p, trace.tip.name) for p, trace in zero])
        # Forward parts first: the lever's point is reached before the block slides on from it.
        seen.sort(key=lambda pair: pair[0].reverse)
        sums = [part for part, trace in seen if trace.side.has(part.of)]
        for part, trace in seen:
            if part in sums:
                self._result(part, trace, end)
        for part, trace in seen:
            if part not in sums:
                self._result(part, trace, end)
            elif part.of.whole:
                self.pencil.whole(part.of, several=True)
        for part, trace in zero:
            self.pencil.vanish("result", part, trace.tip, end)
        for part, _ in found:
            if part not in sums and part.of.whole:
                self.pencil.whole(part.of, several=False)

    def _result(self, part: Part[V], trace: Trace[V], end: str) -> None:
        trace.side.add(part.of, _term(self.pencil.result(part, trace.tip, end)))


def _last(part: Part[V], parts: list[Part[V]]) -> bool:
    """Tell whether a part is the last of its vector among ``parts``."""
    return [other for other in parts if other.of is part.of][-1] is part


def _term(stroke: Stroke) -> Term:
    return Term(stroke.label, stroke.link, stroke.name)
