"""The velocity and the acceleration polygon: the solver's loop equations, drawn.

In each chain of a loop the known components are laid tip to tail, then a line is drawn in the
direction of the unknown one; the two lines cross, and the pieces up to the crossing are inked
and measured.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.kinematics.linkage import Bar
from vad.strokes.chains import StepVector, chain_of, equations_of
from vad.strokes.diagram import Drawing
from vad.strokes.equations import equation
from vad.strokes.images import Images
from vad.strokes.pencil import Tip
from vad.strokes.plane_pencil import PlanePencil
from vad.strokes.player import Player, Trace
from vad.strokes.scene import Scene
from vad.strokes.sheet import Equation, Term


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
        coincident=pencil.coincident,
    )


class _Polygon(Player[StepVector]):
    """The loops of a linkage: a chain may begin with what is on the board, or in an image."""

    pencil: PlanePencil

    def __init__(self, scene: Scene, order: int) -> None:
        self.scene = scene
        self.order = order
        self.linkage = scene.members.linkage
        self.equations = equations_of(scene, order)
        longest = max(each.longest for each in self.equations)
        begin = self.linkage.loops[0].first[0].start, self.linkage.loops[0].second[0].start
        from_pole = all(point in scene.members.fixed for point in begin)
        super().__init__(PlanePencil(scene, order, longest, from_pole))
        self.images = Images(scene, order, self.pencil)

    def draw(self) -> tuple[Equation, ...]:
        """Draw loop after loop and return their equations; there are none where nothing moves."""
        self.pencil.pole()
        equations = []
        for loop, vectors in zip(self.linkage.loops, self.equations, strict=True):
            first, second = self.play(vectors)
            equations.append(equation(loop, first.side, second.side))
        for bar in self.linkage.images:
            if self.pencil.letter(bar.head) not in self.pencil.vertices:
                self.images.find(bar)
        return () if self.pencil.resting else tuple(equations)

    def set_out(self, traces: Sequence[Trace[StepVector]]) -> None:
        """Begin where the board already has the first vectors of the chains."""
        for trace in traces:
            self._walk(trace)
        if traces[0].tip.name != traces[1].tip.name:
            for trace in traces:
                self._start(trace)

    def _walk(self, trace: Trace[StepVector]) -> None:
        """Walk over the steps whose ends are on the board, or found there by an image."""
        vertices = self.pencil.vertices
        for vector in trace.chain.vectors:
            step, name = vector.step, vector.end
            if not trace.chain.wholly_known(vector):
                return
            if name not in vertices:
                if not isinstance(step, Bar) or self.scene.members.drives(step):
                    return
                self.images.find(replace(step, ends=step.start + step.end))
            trace.known = [part for part in trace.known if part.of is not vector]
            trace.tip, trace.walked = Tip(name, vertices[name]), vector

    def _start(self, trace: Trace[StepVector]) -> None:
        """Write the vector from the pole to where a chain begins, which is inked if need be."""
        name, pencil = trace.tip.name, self.pencil
        if not pencil.shows(trace.tip.at):
            return  # at the pole
        stroke = pencil.leads_to(name)
        if stroke is None and trace.walked:
            stroke = pencil.absolute(pencil.point(name), trace.walked.owner)
        assert stroke is not None
        trace.side.start = Term(stroke.label, stroke.link, stroke.name)

    def after_driver(self) -> None:
        """Draw, in the first loop, the points of the driven link that later loops begin with."""
        if len(self.begins) > 1:
            return
        steps = (step for loop in self.linkage.loops[1:] for _, step in loop.steps())
        vertices = self.pencil.vertices
        for step in steps:
            if not isinstance(step, Bar) or not self.scene.members.drives(step):
                continue
            tail, head = self.pencil.letter(step.tail), self.pencil.letter(step.head)
            if tail in vertices and head not in vertices:
                chain = chain_of(self.scene, replace(step, reverse=False), self.order)
                self.lay(self.begin(chain), chain.known)
