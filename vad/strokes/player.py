"""The player of vector equations: known parts tip to tail, two lines, their crossing, results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Generic

from vad.strokes.equations import Side
from vad.strokes.pencil import Pencil, Tip
from vad.strokes.sheet import Stroke, Term
from vad.strokes.vector_equations import Chain, Part, V, VectorEquation


@dataclass
class Trace(Generic[V]):
    """One chain as it is being drawn: how far it has got, and what it has yet to lay.

    ``walked`` is its last vector that was on the board already.
    """

    chain: Chain[V]
    tip: Tip
    known: list[Part[V]]
    walked: V | None = None
    side: Side = field(default_factory=Side)


class Player(Generic[V]):
    """What draws equation after equation.

    ``begins`` are the numbers of the strokes with which they begin.
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
        # What the driver dictates comes first, then chain after chain.
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
        """Do what comes after the parts that the driver dictates."""

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
        """Come to the end of a vector that is wholly known; so many of its parts are ``seen``."""
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
