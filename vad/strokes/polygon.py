"""The velocity and the acceleration polygon: the solver's loop equations, drawn.

In each chain of a loop the known components are laid tip to tail, then a line is drawn in the
direction of the unknown one; the two lines cross, and the pieces up to the crossing are inked
and measured.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TypeGuard

from vad.kinematics.linkage import Bar, Slide, Step
from vad.strokes.chains import NOTHING, Chain, Part
from vad.strokes.diagram import Drawing
from vad.strokes.equations import Side, equation
from vad.strokes.images import Images
from vad.strokes.pencil import Pencil, Tip, owner
from vad.strokes.scene import Scene, point_of
from vad.strokes.sheet import Equation, Term

SUBSCRIPT_N = "ₙ"


def polygon(scene: Scene, order: int) -> Drawing:
    """Return the velocity (order 1) or acceleration (order 2) polygon of a pose."""
    drawing = _Polygon(scene, order)
    equations = drawing.draw()
    pencil = drawing.pencil
    triangles = tuple(drawing.images.triangles)
    return Drawing(
        tuple(pencil.strokes),
        tuple(pencil.zeros),
        equations,
        pencil.inset,
        triangles,
        tuple(drawing.begins),
    )


@dataclass
class _Trace:
    """One chain as it is being drawn; ``walked`` is its last step that was on the board already."""

    chain: Chain
    tip: Tip
    walked: Step | None = None
    side: Side = field(default_factory=Side)


class _Polygon:
    def __init__(self, scene: Scene, order: int) -> None:
        self.scene = scene
        self.order = order
        self.linkage = scene.motion.linkage
        self.loops = [
            [Chain(scene, chain, unknowns, order) for chain in (loop.first, loop.second)]
            for loop, unknowns in zip(self.linkage.loops, self.linkage.unknowns, strict=True)
        ]
        chains = [chain for pair in self.loops for chain in pair]
        nothing = NOTHING * max(chain.longest for chain in chains)
        from_pole = all(chain.start in scene.motion.frame.fixed for chain in self.loops[0])
        self.pencil = Pencil(scene, order, nothing, from_pole)
        self.images = Images(scene, order, self.pencil)
        #: The letters of known parts' ends, drawn or not.
        self.letters: set[str] = set()
        #: The numbers of the strokes with which the loops begin.
        self.begins: list[int] = []

    def draw(self) -> tuple[Equation, ...]:
        """Draw loop after loop and return their equations; there are none where nothing moves."""
        self.pencil.pole()
        equations = []
        for loop, chains in zip(self.linkage.loops, self.loops, strict=True):
            self.begins.append(len(self.pencil.strokes))
            first, second = self._loop(chains)
            equations.append(equation(loop, first.side, second.side))
        for bar in self.linkage.images:
            if self.pencil.letter(bar.head) not in self.pencil.vertices:
                self.images.find(bar)
        return () if self.pencil.resting else tuple(equations)

    def _loop(self, chains: list[Chain]) -> list[_Trace]:
        traces = [_Trace(chain, self._begin(chain)) for chain in chains]
        for trace in traces:
            self._walk(trace)
        if traces[0].tip.name != traces[1].tip.name:
            for trace in traces:
                self._start(trace)
        # What the driver dictates comes first, then chain after chain.
        for trace in traces:
            self._lay(trace, [part for part in trace.chain.known if self._dictated(part)])
        if chains is self.loops[0]:
            self._lay_driver()
        for trace in traces:
            self._lay(trace, [part for part in trace.chain.known if not self._dictated(part)])
            if trace.chain.unknown is not None:
                self.pencil.line(trace.chain.unknown, trace.tip, trace.chain.end)
        self._cross(traces)
        return traces

    def _dictated(self, part: Part) -> bool:
        """Tell whether the driver alone gives a part; Coriolis needs a link that is found."""
        return self.scene.drives(part.step) and part.name != "coriolis"

    def _begin(self, chain: Chain) -> Tip:
        name = self.pencil.letter(chain.start)
        at = self.pencil.vertices.setdefault(name, self.pencil.place(chain.start))
        return Tip(name, at)

    def _walk(self, trace: _Trace) -> None:
        """Walk over the steps whose ends are on the board, or found there by an image."""
        vertices = self.pencil.vertices
        for step in trace.chain.steps:
            name = self.pencil.letter(step.end)
            if not trace.chain.wholly_known(step):
                return
            if name not in vertices:
                if not isinstance(step, Bar) or self.scene.drives(step):
                    return
                self.images.find(replace(step, ends=step.start + step.end))
            trace.chain.known = [part for part in trace.chain.known if part.step is not step]
            trace.tip, trace.walked = Tip(name, vertices[name]), step

    def _start(self, trace: _Trace) -> None:
        """Write the vector from the pole to where a chain begins, which is inked if need be."""
        name, pencil = trace.tip.name, self.pencil
        if not pencil.shows(trace.tip.at):
            return  # at the pole
        stroke = pencil.leads_to(name)
        if stroke is None and trace.walked:
            stroke = pencil.absolute(point_of(name), owner(trace.walked))
        assert stroke is not None
        trace.side.start = Term(stroke.label, stroke.link, stroke.name)

    def _lay_driver(self) -> None:
        """Draw the further points of the driven link that later loops begin with."""
        steps = (step for loop in self.linkage.loops[1:] for _, step in loop.steps())
        vertices = self.pencil.vertices
        for step in steps:
            if not isinstance(step, Bar) or not self.scene.drives(step):
                continue
            tail, head = self.pencil.letter(step.tail), self.pencil.letter(step.head)
            if tail in vertices and head not in vertices:
                chain = Chain(self.scene, (replace(step, reverse=False),), (), self.order)
                self._lay(_Trace(chain, Tip(tail, vertices[tail])), chain.known)

    # --- known parts --------------------------------------------------------------------------

    def _lay(self, trace: _Trace, parts: list[Part]) -> None:
        """Draw known parts tip to tail."""
        pencil, chain, tip = self.pencil, trace.chain, trace.tip
        seen = [part for part in parts if pencil.shows(part.vector)]
        for part in parts:
            step, last = part.step, _last(part, parts)
            arrives = chain.wholly_known(step) and not _on_link(step)
            full = self._end_name(chain, part, last)
            if part in seen:
                ends = _last(part, seen)
                name = self._end_name(chain, part, ends)
                exact = pencil.place(step.head) if ends and arrives else None
                stroke = pencil.known(part, tip, name, exact)
                trace.side.add(step, Term(stroke.label, owner(step), stroke.name))
            else:
                pencil.vanish("known", part, tip, full)
            tip.full = full
            self.letters.add(full)
            if last and arrives:
                self._arrive(step, tip, sum(other.step is step for other in seen))

    def _arrive(self, step: Step, tip: Tip, seen: int) -> None:
        """Come to the end of a step that is wholly known; so many of its parts are ``seen``."""
        name = self.pencil.letter(step.head)
        if not seen and step.head in self.scene.motion.points:
            self.pencil.vertices[name] = tip.at  # it could move, but stands still
            self.pencil.share_pole(name)
            tip.name = name
        if self._has_whole(step):
            self.pencil.whole(step, seen > 1)

    def _has_whole(self, step: Step) -> TypeGuard[Bar]:
        """Tell whether a step's vector is measured beside its parts: a bar's, but no strut's."""
        strut = isinstance(step, Bar) and step.length == self.scene.driver.name
        return self.order > 1 and isinstance(step, Bar) and not strut

    def _end_name(self, chain: Chain, part: Part, last: bool) -> str:
        """Name the vertex at the end of a known part: b′, b′ₙ, cₙ, c″ₙ, s′ or z."""
        step, letter = part.step, part.step.head.lower()
        if part.name == "coriolis":
            return "z"
        if part.name == "sliding" or (last and chain.wholly_known(step)):
            return self.pencil.letter(letter)
        if chain.wholly_known(step):
            return self.pencil.letter(letter) + SUBSCRIPT_N
        if isinstance(step, Bar) and step.length == self.scene.driver.name:
            letter = step.tail.lower()  # the strut's part before it turns
        name = letter + SUBSCRIPT_N
        return name if name not in self.letters else f"{letter}″{SUBSCRIPT_N}"

    # --- the crossing and what it shows -------------------------------------------------------

    def _cross(self, traces: list[_Trace]) -> None:
        found = [(t.chain.unknown, t) for t in traces if t.chain.unknown is not None]
        seen = [(part, trace) for part, trace in found if self.pencil.shows(part.vector)]
        zero = [(part, trace) for part, trace in found if (part, trace) not in seen]
        end = traces[0].chain.end
        self.pencil.crossing(end, [(part, trace.tip.name) for part, trace in zero])
        # Forward parts first: the lever's point is reached before the block slides on from it.
        seen.sort(key=lambda pair: pair[0].reverse)
        sums = [part for part, trace in seen if trace.side.has(part.step)]
        for part, trace in seen:
            if part in sums:
                self._result(part, trace, end)
        for part, trace in seen:
            if part not in sums:
                self._result(part, trace, end)
            elif self._has_whole(part.step):
                self.pencil.whole(part.step, several=True)
        for part, trace in zero:
            self.pencil.vanish("result", part, trace.tip, self.pencil.letter(end))
        for part, _ in found:
            if part not in sums and self._has_whole(part.step):
                self.pencil.whole(part.step, several=False)

    def _result(self, part: Part, trace: _Trace, end: str) -> None:
        stroke = self.pencil.result(part, trace.tip, end)
        trace.side.add(part.step, Term(stroke.label, owner(part.step), stroke.name))


def _last(part: Part, parts: list[Part]) -> bool:
    """Tell whether a part is the last of its step among ``parts``."""
    return [other for other in parts if other.step is part.step][-1] is part


def _on_link(step: Step) -> bool:
    """Tell whether a step slides on a turning link: its end is a stage, no point of the link."""
    return isinstance(step, Slide) and isinstance(step.along, str)
