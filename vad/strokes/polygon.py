"""The velocity and the acceleration polygon: the solver's loop equations, drawn.

In each chain of a loop the known components are laid tip to tail, then a line is drawn in the
direction of the unknown one; the two lines cross, and the pieces up to the crossing are inked
and measured.

Further points of a link are found by its image, which is similar to the link.  A point in line with
two known ones divides the image in the link's ratio.  A point beside their line is the third corner
of a triangle: its sides are perpendicular to the link's in the velocity polygon, and stand at the
link's own angles in the acceleration polygon.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.numbers import bearing
from vad.strokes.arithmetic import Figure, product
from vad.strokes.captions import Captions
from vad.strokes.diagram import ORDERS, Drawing
from vad.strokes.loops import StepVector, chain_of, equation, equations_of
from vad.strokes.player import Pencil, Player, Tip, Trace
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sentences import Noun, Sentence, Unit
from vad.strokes.sheet import (
    Arrow,
    CoriolisInset,
    Dot,
    Equation,
    ImageTriangle,
    Line,
    Stroke,
    StrokePart,
    Term,
)
from vad.strokes.vector_equations import Part


class PlanePencil(Pencil[StepVector]):
    """Strokes and vertices of the velocity (order 1) or acceleration (order 2) polygon."""

    def __init__(self, scene: Scene, order: int, longest: float, from_pole: bool) -> None:
        self.scene = scene
        self.order = order
        self.say = Captions(scene, order)
        #: The point of each vertex.
        self._points = {self.letter(point): point for point in scene.motion.plane.routes.letters}
        fixed = [self.letter(point) for point in scene.members.fixed]
        super().__init__(self.say, self._place, longest, fixed, from_pole)

    def letter(self, point: str) -> str:
        """Return the letter of a point's image."""
        return image_letter(point, self.order)

    def point(self, vertex: str) -> str:
        """Return the point whose image a vertex is."""
        return self._points[vertex]

    def _place(self, vertex: str) -> complex:
        return self.image(self._points[vertex])

    def image(self, point: str) -> complex:
        """Return the true velocity or acceleration of a point: the place of its image."""
        return self.scene.image(point, self.order)

    def pole(self) -> None:
        """Draw the pole, where all fixed points are, unless a crossing finds it later.

        If nothing moves, the pole is the whole polygon.
        """
        members = self.scene.members
        if self.resting:
            self.begin(self.say.still(), (*members.links, *members.slides))
        elif self.from_pole:
            self.begin(self.say.pole(self.fixed))

    def known(
        self, part: Part[StepVector], tip: Tip, name: str, at: complex | None = None
    ) -> Stroke:
        """Draw a known component; the inset shows the rule of the first Coriolis component."""
        stroke = super().known(part, tip, name, at)
        step = part.of.step
        if part.name == "coriolis" and isinstance(step, Slide) and self.inset is None:
            self.inset = self._rule(part, step, stroke.name)
        return stroke

    def label_from_pole(self, point: str, link: str) -> str:
        """Return the letters of the vector from the pole to the image of a point.

        All fixed points lie at the pole; the first letter is that of the link's own pivot, if it
        has one.
        """
        return self.letter(self.scene.members.pivot(link)) + self.letter(point)

    def absolute(
        self,
        point: str,
        link: str,
        image: bool = False,
        said: Sentence | None = None,
        pivot: str = "",
    ) -> Stroke:
        """Ink the vector from the pole to a vertex; it is left out where it is zero.

        Its first letter is that of the ``pivot``, or the one of `label_from_pole`.
        """
        letter, at = self.letter(point), self.image(point)
        label = self.letter(pivot) + letter if pivot else self.label_from_pole(point, link)
        arrow = Arrow(0j, at, label.removesuffix(letter), letter)
        said = said or self.say.absolute(label, point, abs(at))
        part = StrokePart(point, "image" if image else "absolute")
        stroke = Stroke("result", label, arrow, said, link, "absolute", image, part=part)
        if self.shows(at):
            return self.add(stroke)
        self.leave_out(stroke)
        return stroke

    def leads_to(self, letter: str) -> Stroke | None:
        """Return the stroke from the pole to a vertex, if one is drawn.

        A vector with one part alone is drawn as that part, and its sum is left out.
        """
        for stroke in (*self.strokes, *self.zeros):
            match stroke.shape:
                case Arrow(start=0j, head=head) if head == letter:
                    return stroke if stroke in self.strokes else self._part_of(stroke)
        return None

    def _part_of(self, whole: Stroke) -> Stroke | None:
        """Return the one part of a vector that is drawn; its sum is left out."""
        vector = whole.part.of if whole.part else ""
        parts = (stroke for stroke in self.strokes if stroke.part and stroke.part.of == vector)
        return next((stroke for stroke in parts if isinstance(stroke.shape, Arrow)), None)

    def _rule(self, part: Part[StepVector], slide: Slide, stroke: str) -> CoriolisInset:
        """Return the directions that the Coriolis inset shows."""
        line = self.scene.heading(self.scene.members.frame.line(slide, self.scene.pose))
        forward = self.scene.speed(slide.name, 1) > 0
        return CoriolisInset(
            link=str(slide.along),
            slide=slide.name,
            slot=line,
            sliding=line if forward else -line,
            coriolis=part.vector / abs(part.vector),
            sense=1 if self.scene.rate(str(slide.along), 1) > 0 else -1,
            stroke=stroke,
        )


class Images:
    """Finds further points of links by their images, and draws them in a polygon."""

    def __init__(self, scene: Scene, order: int, pencil: PlanePencil) -> None:
        self._scene = scene
        self._order = order
        self._pencil = pencil
        self.triangles: list[ImageTriangle] = []

    def find(self, bar: Bar, whole: bool = True) -> None:
        """Find the image of the head of a bar whose link is known.

        With ``whole`` its vector from the pole is inked, too.  That vector is always inked for a
        point in line, because the caption names it.
        """
        base = self._scene.members.base(bar.link)
        if self._scene.in_line(bar.link, bar.head):
            self._divide(bar, base)
            return
        self._construct(bar, base)
        if whole:
            self._pencil.absolute(bar.head, bar.link, image=True)

    def _divide(self, bar: Bar, base: Bar) -> None:
        """Find a point in line by proportion; on a link that does not turn it moves as all do."""
        pencil = self._pencil
        at = pencil.image(bar.head)
        known, own = (pencil.image(b.head) - pencil.image(b.tail) for b in (base, bar))
        said = None
        if pencil.shows(at) and pencil.shows(known):
            label = pencil.label_from_pole(bar.head, bar.link)
            said = pencil.say.image(bar, base, label, (abs(known), abs(own), abs(at)))
        elif pencil.shows(at):
            said = self._alike(bar, [pencil.letter(p) for p in (bar.tail, bar.head)])
        pencil.vertices[pencil.letter(bar.head)] = at
        if bar.tail not in self._scene.members.fixed:
            self._prolong(bar, base, said)
        pencil.absolute(bar.head, bar.link, image=True, said=said)

    def _prolong(self, bar: Bar, base: Bar, said: Sentence | None) -> None:
        """Draw a line on to the image of a point that lies beyond both known ones."""
        pencil, at = self._pencil, self._scene.at
        reach, known = (abs(at(each.head) - at(each.tail)) for each in (bar, base))
        start, end = pencil.image(bar.tail), pencil.image(bar.head)
        label = pencil.letter(bar.tail) + pencil.letter(bar.head)
        shown = pencil.shows(end - start)
        line = Line(start, (end - start) / abs(end - start) if shown else 1.0, end)
        part = StrokePart(bar.ends, "line")
        stroke = Stroke("construction", label, line, said or "", bar.link, part=part)
        if shown and said and (reach > known or self._scene.against(bar)):
            pencil.add(stroke)
        else:
            pencil.leave_out(stroke)

    # --- beside the line ----------------------------------------------------------------------

    def _construct(self, bar: Bar, base: Bar) -> None:
        """Find a point beside the line, where lines from two known corners cross."""
        pencil = self._pencil
        corners = base.tail, base.head, bar.head
        letters = [pencil.letter(corner) for corner in corners]
        places = [pencil.image(corner) for corner in corners]
        turns = pencil.shows(places[1] - places[0])
        for near, far in ((0, 1), (1, 0)):
            self._line(corners[near], corners[far], bar, turns)
        pencil.vertices[letters[2]] = places[2]
        said = self._similar(bar, base) if turns else self._alike(bar, letters[::2])
        part = StrokePart(bar.head, "crossing")
        pencil.add(Stroke("intersection", letters[2], Dot(places[2]), said, part=part))
        if turns and not pencil.resting:
            self.triangles.append(ImageTriangle(bar.link, corners, tuple(places), part.name))

    def _line(self, near: str, far: str, bar: Bar, turns: bool) -> None:
        """Draw the line from the image of a corner on which the point lies."""
        scene, pencil = self._scene, self._pencil
        through, until = pencil.image(near), pencil.image(bar.head)
        side, corner = near + bar.head, far + near + bar.head
        if self._order == 1:
            label, square, said = f"⟂ {side}", side, pencil.say.across(near, bar.head)
        else:
            label, square = f"∠ {corner}", None
            angle = self._angle(near, far, bar.head)
            said = scene.say(
                "image line",
                point=pencil.letter(near),
                corner=corner,
                angle=scene.measured(abs(angle), "°"),
                sense=pencil.say.sense(angle),
                link=Noun(bar.link),
                side=pencil.letter(near) + pencil.letter(far),
                meeting=pencil.letter(bar.head),
            )
        away = until - through
        shown = turns and pencil.shows(away)
        line = Line(through, away / abs(away) if shown else 1.0, until, square)
        own = StrokePart(side, "line")
        stroke = Stroke("construction", label, line, said, bar.link, part=own)
        if shown:
            pencil.add(stroke)
        else:
            pencil.leave_out(stroke)

    def _angle(self, near: str, far: str, third: str) -> float:
        """Return the angle at a corner of the link, in degrees, counter-clockwise positive."""
        corner, one, other = map(self._scene.at, (near, far, third))
        return bearing((other - corner) / (one - corner))

    def _similar(self, bar: Bar, base: Bar) -> Sentence:
        """Say that the image is similar to the link, and how long its next side is."""
        scene, pencil = self._scene, self._pencil
        side = base.tail + bar.head
        unit = scene.rate_unit(self._order)
        spans = [abs(scene.at(head) - scene.at(base.tail)) for head in (bar.head, base.head)]
        size = scene.measured(spans[0], scene.unit)
        length = scene.measured(spans[1], scene.unit, power=-1)
        tail = pencil.image(base.tail)
        own, known = (Figure(abs(pencil.image(p) - tail), unit) for p in (bar.head, base.head))

        def image(*points: str) -> str:
            return "".join(image_letter(point, self._order) for point in points)

        return scene.say(
            "image similar",
            product("own", "known", "size", "length"),
            letter=image(bar.head),
            image=scene.say(f"image {ORDERS[self._order].panel}"),
            link=Noun(bar.link),
            triangle=image(base.tail, base.head, bar.head),
            corners=base.ends + bar.head,
            part=image(base.tail, bar.head),
            whole=image(base.tail, base.head),
            bar=side,
            base=base.ends,
            known=known,
            size=size,
            length=length,
            own=own,
            unit=Unit(unit),
        )

    def _alike(self, bar: Bar, letters: list[str]) -> Sentence:
        """Say that all points of the link move alike: the second letter falls on the first one."""
        phrase, (point, letter) = f"image alike {ORDERS[self._order].panel}", letters
        return self._scene.say(phrase, letter=letter, point=point, link=Noun(bar.link))


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
    """The polygon of a linkage, loop after loop.

    A chain may begin with vectors that are drawn already, or with a point found by an image.
    """

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
        self._output()
        return () if self.pencil.resting else tuple(equations)

    def _output(self) -> None:
        """Ink the velocity or acceleration of the output point, if two moving bars have found it.

        Its vector begins with the letter of the pivot from which its loop starts.
        """
        point = self.scene.motion.mechanism.output_point
        letter = self.pencil.letter(point) if point else ""
        if letter not in self.pencil.vertices or self.pencil.leads_to(letter):
            return
        for loop in self.linkage.loops:
            last, start = loop.second[-1], loop.second[0].start
            if isinstance(last, Bar) and last.end == point and start in self.scene.members.fixed:
                self.pencil.absolute(point, last.link, pivot=start)

    def set_out(self, traces: Sequence[Trace[StepVector]]) -> None:
        """Begin after those vectors of the chains that are drawn already."""
        for trace in traces:
            self._walk(trace)
        if traces[0].tip.name != traces[1].tip.name:
            for trace in traces:
                self._start(trace)

    def _walk(self, trace: Trace[StepVector]) -> None:
        """Pass the steps whose end points are drawn already, or are found by an image."""
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
        """Begin the written equation with the vector from the pole; ink it if it is not drawn."""
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
