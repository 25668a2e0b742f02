"""The velocity and the acceleration polygon: the solver's loop equations, drawn.

In each chain of a loop the known components are laid tip to tail, then a line is drawn in the
direction of the unknown one; the two lines cross, and the pieces up to the crossing are inked
and measured.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from vad.kinematics.linkage import Bar, Scalar, Slide, Step, angle_of
from vad.strokes.chains import NOTHING, Chain, Part
from vad.strokes.equations import Side, equation
from vad.strokes.pencil import Pencil, Tip, owner
from vad.strokes.scene import Scene
from vad.strokes.sheet import PANELS, Equation, Panel, Term

SUBSCRIPT_N = "ₙ"


def polygon(scene: Scene, order: int) -> Panel:
    """Return the velocity (order 1) or acceleration (order 2) panel of a pose."""
    drawing = _Polygon(scene, order)
    equations = drawing.draw()
    pencil = drawing.pencil
    return Panel(
        PANELS[order], scene.rate_unit(order), tuple(pencil.strokes), equations, pencil.inset
    )


@dataclass
class _Trace:
    """One chain as it is being drawn."""

    chain: Chain
    tip: Tip
    side: Side = field(default_factory=Side)


class _Polygon:
    def __init__(self, scene: Scene, order: int) -> None:
        self.scene = scene
        self.pencil = Pencil(scene, order)
        self.linkage = scene.motion.linkage
        self.loops = [
            [Chain(scene, chain, unknowns, order) for chain in (loop.first, loop.second)]
            for loop, unknowns in zip(self.linkage.loops, self.linkage.unknowns, strict=True)
        ]
        longest = max(chain.longest for chains in self.loops for chain in chains)
        self.nothing = NOTHING * longest

    def draw(self) -> tuple[Equation, ...]:
        """Draw loop after loop and return their equations."""
        if self.nothing == 0.0:
            self.pencil.rest()
            return ()
        fixed = self.scene.motion.frame.fixed
        if all(chain.start in fixed for chains in self.loops for chain in chains):
            self.pencil.pole()
        equations = []
        known = {self.scene.driver}
        for loop, unknowns, chains in zip(
            self.linkage.loops, self.linkage.unknowns, self.loops, strict=True
        ):
            first, second = self._loop(chains)
            equations.append(equation(loop, first.side, second.side))
            known.update(unknowns)
            self._images(known)
        return tuple(equations)

    def _loop(self, chains: list[Chain]) -> list[_Trace]:
        traces = [_Trace(chain, self._begin(chain)) for chain in chains]
        for trace in traces:
            self._walk(trace)
        # What the driver dictates comes first, then chain after chain.
        for trace in traces:
            self._lay(trace, [part for part in trace.chain.known if self._dictated(part)])
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
        """Walk over the steps whose head is on the board already."""
        vertices = self.pencil.vertices
        for step in trace.chain.steps:
            name = self.pencil.letter(step.ends[1])
            if name not in vertices or step.reverse or not trace.chain.wholly_known(step):
                return
            label = trace.tip.name + name
            drawn = self.pencil.joining(trace.tip.name, name)
            trace.side.add(step, Term(label, owner(step), drawn))
            trace.chain.known = [part for part in trace.chain.known if part.step is not step]
            trace.tip = Tip(name, vertices[name])

    # --- known parts --------------------------------------------------------------------------

    def _lay(self, trace: _Trace, parts: list[Part]) -> None:
        """Draw known parts tip to tail."""
        pencil, chain, tip = self.pencil, trace.chain, trace.tip
        drawn = [part for part in parts if abs(part.vector) > self.nothing]
        begun: dict[Step, str] = {}
        for number, part in enumerate(drawn):
            step = part.step
            tail = begun.setdefault(step, tip.name)
            last = all(later.step is not step for later in drawn[number + 1 :])
            ends = last and chain.wholly_known(step) and not _on_link(step)
            several = tip.name != tail
            name = self._end_name(chain, part, last)
            stroke = pencil.known(part, tip, name, pencil.place(step.ends[1]) if ends else None)
            trace.side.add(step, Term(stroke.label, owner(step), stroke.name))
            if ends and several:
                pencil.whole(step, tail, name)
        for step in dict.fromkeys(part.step for part in parts):
            name = pencil.letter(step.ends[1])
            point = step.ends[1] in self.scene.motion.points
            if point and chain.wholly_known(step) and name not in pencil.vertices:
                pencil.vertices[name] = tip.at  # it could move, but stands still
                pencil.share_pole(name)
                tip.name = name

    def _end_name(self, chain: Chain, part: Part, last: bool) -> str:
        """Name the vertex at the end of a known part: b′, b′ₙ, cₙ, c″ₙ, s′ or z."""
        step, letter = part.step, part.step.ends[1].lower()
        if part.name == "coriolis":
            return "z"
        if part.name == "sliding" or (last and chain.wholly_known(step)):
            return self.pencil.letter(letter)
        if chain.wholly_known(step):
            return self.pencil.letter(letter) + SUBSCRIPT_N
        if isinstance(step, Bar) and step.length == self.scene.driver.name:
            letter = step.ends[0].lower()  # the strut's part before it turns
        name = letter + SUBSCRIPT_N
        return name if name not in self.pencil.vertices else f"{letter}″{SUBSCRIPT_N}"

    # --- the crossing and what it shows -------------------------------------------------------

    def _cross(self, traces: list[_Trace]) -> None:
        found = [(t.chain.unknown, t) for t in traces if t.chain.unknown is not None]
        nothing = [part for part, _ in found if abs(part.vector) <= self.nothing]
        end = traces[0].chain.end
        self.pencil.crossing(end, tuple(owner(part.step) for part in nothing))
        # Forward parts first: the lever's point is reached before the block slides on from it.
        found = [(part, trace) for part, trace in found if part not in nothing]
        found.sort(key=lambda pair: pair[0].reverse)
        composite = [trace.side.has(part.step) for part, trace in found]
        for (part, trace), several in zip(found, composite, strict=True):
            if several:
                self._result(part, trace, end)
        for (part, trace), several in zip(found, composite, strict=True):
            if not several:
                self._result(part, trace, end)
            elif isinstance(part.step, Bar) and part.step.length != self.scene.driver.name:
                tail = self.pencil.letter(part.step.ends[0])
                self.pencil.whole(part.step, tail, self.pencil.letter(end))

    def _result(self, part: Part, trace: _Trace, end: str) -> None:
        stroke = self.pencil.result(part, trace.tip, end)
        trace.side.add(part.step, Term(stroke.label, owner(part.step), stroke.name))

    def _images(self, known: set[Scalar]) -> None:
        """Find the further points of the links that are known by now."""
        for bar in self.linkage.images:
            drawn = self.pencil.letter(bar.ends[1]) in self.pencil.vertices
            if angle_of(bar.link) in known and not drawn:
                still = bar.ends[0] in self.scene.motion.frame.fixed
                start = bar.ends[0] if still else self.linkage.pivot
                self.pencil.image(bar, self.pencil.letter(start), self.nothing)


def _on_link(step: Step) -> bool:
    """Tell whether a step slides on a turning link: its end is a stage, no point of the link."""
    return isinstance(step, Slide) and isinstance(step.along, str)
