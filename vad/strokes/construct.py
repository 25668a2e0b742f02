"""The mechanism as compasses and set square construct it: the strokes of the position diagram.

Further points of a link are drawn on its line, or as corners of a plate.
"""

from __future__ import annotations

from dataclasses import replace

from vad.kinematics.linkage import Bar, Loop, Scalar, Slide, angle_of, points_of, scalar_of
from vad.kinematics.numbers import bearing, dot, facing
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing
from vad.strokes.force_loads import loads_at_points
from vad.strokes.inking import PositionPencil
from vad.strokes.loops import position_equation
from vad.strokes.scene import Scene
from vad.strokes.sentences import Listed, Noun, SentencePart, Unit
from vad.strokes.sheet import Arc, Dot, Guide, Line

#: A compass arc reaches so many degrees to either side of the point that it finds.
COMPASS = 14.0
#: Of the radius of an arc: crossings nearer than this are one.
ONE_CROSSING = 0.02


class FurtherPoints:
    """Draws the points of links that no loop finds; ``found`` holds the points that are drawn."""

    def __init__(self, scene: Scene, ink: PositionPencil, found: set[str]) -> None:
        self.scene = scene
        self.ink = ink
        self.found = found

    def reach(self, loop: Loop, known: set[Scalar]) -> None:
        """Draw the points of known links with which the chains of a loop begin."""
        for chain in (loop.first, loop.second):
            for step in chain:
                if step.end in self.found:
                    continue
                if not isinstance(step, Bar) or angle_of(step.link) not in known:
                    break
                if isinstance(step.length, float):
                    self.draw(replace(step, ends=step.start + step.end, reverse=False))

    def draw(self, bar: Bar) -> None:
        """Draw a further point of a link, at the head of a bar: on its line, or as a plate."""
        if bar.head in self.found:
            return
        if self.scene.in_line(bar.link, bar.head):
            self._tip(bar)
            return
        base = self.scene.members.base(bar.link)
        beside = []
        for point in self.scene.members.points_on(bar.link):
            if not self.scene.in_line(bar.link, point):
                beside.append(point)
            elif point not in self.found:
                self._tip(Bar(base.tail + point, bar.link, self.scene.span(base.tail, point)))
        for point in beside:
            self._third(bar.link, point)
        if len(self.scene.members.points_on(bar.link)) > 2:
            self.ink.plate(bar.link)
        else:  # all other points of the link slide on it
            self._tip(bar)

    def _tip(self, bar: Bar) -> None:
        """Draw a point on the line of its link."""
        self.found.add(bar.head)
        self.ink.bar(bar, "result", "tip against" if self.scene.against(bar) else "tip", image=True)

    def _third(self, link: str, point: str) -> None:
        """Find the third corner of a triangle by two arcs."""
        base = self.scene.members.base(link)
        for centre in (base.tail, base.head):
            span = self.scene.span(centre, point)
            size = self.scene.measured(span, self.scene.unit)
            (vertex,) = {base.tail, base.head} - {centre}
            corner = self._given_corner(centre, vertex, point)
            self.arc(Bar(centre + point, link, span), centre, point, size, corner=corner)
        one, other, third = corners = base.tail, base.head, point
        start = self.scene.at(one)
        turn = (self.scene.at(other) - start).conjugate() * (self.scene.at(third) - start)
        sense = self.scene.say("counter-clockwise" if turn.imag > 0 else "clockwise")
        parts: dict[str, SentencePart] = {"letter": point, "sense": sense}
        parts["corners"] = Listed(corners, ", ")
        at = Dot(self.scene.at(point))
        self.ink.draw(point, "found", "intersection", point, at, "third point", parts)
        self.found.add(point)

    def _given_corner(self, one: str, vertex: str, other: str) -> str:
        """Return the letters of the corner at ``vertex`` if its angle is given, else nothing."""
        mechanism = self.scene.motion.mechanism
        given = {name.rpartition("_")[2] for name in mechanism.parameters()}
        for point, (link, _, *turn) in mechanism.points.items():
            if turn and link in mechanism.links:
                tail, head = points_of(mechanism.links[link])
                given.add(head + tail + point)
        corners = one + vertex + other, other + vertex + one
        return next((corner for corner in corners if corner in given), "")

    def arc(
        self,
        bar: Bar,
        centre: str,
        end: str,
        size: Figure,
        phrase: str = "compass",
        corner: str = "",
    ) -> None:
        """Draw a compass arc about one end of a bar through the other.

        Its radius follows from the angle of the ``corner`` opposite, if that is given.
        """
        at, point = self.scene.at(centre), self.scene.at(end)
        angle = bearing(point - at)
        arc = Arc(at, size.value, angle - COMPASS, 2 * COMPASS, through=point)
        letters = self.scene.members.letters(bar)
        parts: dict[str, SentencePart] = {"head": end, "tail": centre, "bar": letters, "size": size}
        parts |= {"link": Noun(bar.link), "unit": Unit(self.scene.unit), "corner": corner}
        phrase += " corner" if corner else ""
        self.ink.draw(
            bar.ends, "compass", "construction", letters, arc, phrase, parts, link=bar.link
        )


def construct(scene: Scene) -> Drawing:
    """Return the construction of a pose."""
    return _Construction(scene).drawing()


class _Construction:
    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.motion = scene.motion
        self.members = scene.members
        self.frame, self.linkage = self.members.frame, self.members.linkage
        self.ink = PositionPencil(scene)
        self.found: set[str] = set(self.frame.fixed)
        self.further = FurtherPoints(scene, self.ink, self.found)

    def drawing(self) -> Drawing:
        self._frame()
        self._driver()
        known = {self.scene.driver}
        equations, begins = [], []
        for loop, unknowns in zip(self.linkage.loops, self.linkage.unknowns, strict=True):
            begins.append(len(self.ink.strokes))
            self.further.reach(loop, known)
            self._construct(loop, unknowns)
            self._ink(loop, unknowns)
            known.update(unknowns)
            equations.append(position_equation(self.scene, loop, self.ink.strokes))
        for bar in self.linkage.images:
            self.further.draw(bar)
        loads, zeros, resumes = loads_at_points(self.scene)
        return Drawing(
            (*self.ink.strokes, *loads),
            tuple(zeros),
            equations=tuple(equations),
            loops=tuple(begins),
            bodies=self.ink.bodies,
            coincident=self.ink.coincident,
            resumes=resumes,
        )

    # --- what is given ------------------------------------------------------------------------

    def _frame(self) -> None:
        """Draw the fixed pivots and the guides of the frame."""
        bars = {
            end
            for step in self.frame.steps
            if isinstance(step, Bar) or isinstance(step.along, str)
            for end in (step.tail, step.head)
        }
        ends = {end for pair in self.motion.mechanism.links.values() for end in points_of(pair)}
        for letter in self.members.points:
            if letter in self.frame.fixed:
                pivot = letter in bars | ends
                kind, phrase = ("fixed", "fixed") if pivot else ("pole", self._point(letter))
                parts: dict[str, SentencePart] = {"letter": letter}
                self.ink.join(None, letter)
                self.ink.draw(
                    letter, "fixed", kind, letter, Dot(self.scene.at(letter)), phrase, parts
                )
        for slide in self.members.guides:
            self._guide(slide)

    def _point(self, letter: str) -> str:
        """Return the phrase for a fixed point that is no pivot."""
        lines = {slide.along for slide in self.members.guides if slide.tail == letter}
        return "guides cross" if len(lines) > 1 else "fixed point"

    def _guide(self, slide: Slide) -> None:
        line = self.scene.heading(self.frame.line(slide, self.scene.pose))
        origin = self.scene.at(slide.tail) + self.scene.outward(self.frame.shift(slide))
        guide = Guide(origin, line, self._away(slide.head, line))
        head, tail = slide.head, slide.tail
        known = tail in self.members.points
        label, phrase = ("", "guide") if known else (tail, "guide point")
        parts: dict[str, SentencePart] = {"head": head, "tail": tail}
        self.ink.draw(slide.ends, "guide", "guide", label, guide, phrase, parts, link=slide.name)

    def _away(self, letter: str, line: complex) -> complex:
        """Return the unit vector across a guide, on the side away from the rod."""
        normal = -1j * line
        if normal.imag > 0 or (normal.imag == 0 and normal.real < 0):
            normal = -normal
        for step in self.frame.steps:
            if isinstance(step, Bar) and letter in (step.tail, step.head):
                other = step.head if letter == step.tail else step.tail
                height = (normal.conjugate() * (self.scene.at(other) - self.scene.at(letter))).real
                if abs(height) > 1e-9 * self.scene.size(step):
                    return normal if height < 0 else -normal
        return normal

    def _driver(self) -> None:
        """Draw what the driver gives: a bar at its angle, or a block at its position."""
        driver = self.scene.driver
        for step in self.frame.steps:
            if scalar_of(step) != driver:
                continue
            if isinstance(step, Bar):
                self.ink.bar(step, "known", "driven bar")
                tail, head = self.scene.at(step.tail), self.scene.at(step.head)
                sweep = self.motion.link(step.link).angle
                arc = Arc(tail, abs(head - tail), 0.0, sweep)
                angle = Figure(sweep, "°", given=True)
                label = self.scene.write("degrees", angle=angle)
                said: dict[str, SentencePart] = {"link": Noun(step.link)}
                self.ink.draw(
                    step.ends, "angle", "angle", label, arc, "angle", said, link=step.link
                )
                self.found.update((step.tail, step.head))
                self._driver_points(step.link)
            elif isinstance(step.along, float):
                self.ink.block(step, "known", "driven slide")
                self.found.add(step.head)
            return

    def _driver_points(self, link: str) -> None:
        """Draw the further points of the driven link that later loops begin with."""
        for loop in self.linkage.loops[1:]:
            for _, step in loop.steps():
                if isinstance(step, Bar) and step.link == link:
                    self.further.draw(replace(step, reverse=False))

    # --- what is found ------------------------------------------------------------------------

    def _construct(self, loop: Loop, unknowns: tuple[Scalar, ...]) -> None:
        """Draw the arcs and lines that fix the point at which both chains end."""
        end = loop.first[-1].end
        if end in self.found:
            return
        phrase: tuple[str, dict[str, SentencePart]] = ("found", {"letter": end})
        centres: list[str] = []
        steps = (*loop.first, *loop.second)
        for step in steps:
            if isinstance(step, Bar) and scalar_of(step) in unknowns:
                blocks = [s for s in steps if isinstance(s, Slide) and s.name == step.length]
                if any(scalar_of(block) in unknowns for block in blocks):
                    phrase = self._lever_line(step, end, blocks[0])
                else:
                    centres.append(self._compass(step, end))
            elif isinstance(step, Slide) and self._is_slot(step, unknowns):
                self._link_slot_line(step, end)
                phrase = ("on link slot", {"letter": end})
            elif isinstance(step, Slide) and isinstance(step.along, float):
                if not self.members.is_guide(step):
                    self._slot_line(step)
                    phrase = ("on slot", {"letter": end})
                elif phrase[0] == "found" and centres:
                    phrase = ("on guide", {"letter": end})
        if len(centres) > 1:
            phrase = ("arcs cross", {"letter": end, "which": self._which(end, *centres)})
        self.ink.draw(end, "found", "intersection", end, Dot(self.scene.at(end)), *phrase)
        self.found.add(end)
        for step in steps:
            if isinstance(step, Slide) and self._is_slot(step, unknowns):
                self._under(step)

    def _under(self, slide: Slide) -> None:
        """Write the letter of the point of a known link that lies under a block."""
        if slide.tail not in self.found and slide.tail in self.members.points:
            self.found.add(slide.tail)
            at = Dot(self.scene.at(slide.tail))
            link = Noun(str(slide.along))
            parts: dict[str, SentencePart] = {"letter": slide.tail, "link": link, "pin": slide.head}
            self.ink.draw(slide.tail, "found", "intersection", slide.tail, at, "on lever", parts)

    def _is_slot(self, slide: Slide, unknowns: tuple[Scalar, ...]) -> bool:
        """Tell whether a block slides on a turning link whose angle is already known."""
        known = isinstance(slide.along, str) and angle_of(slide.along) not in unknowns
        return known and slide.head in self.members.points

    def _which(self, end: str, one: str, other: str) -> SentencePart:
        """Say which of the two crossings of arcs about points is meant: the upper one, say."""
        at, start, way = (self.scene.at(each) for each in (end, one, other))
        way -= start
        off = 2j * ((at - start) / way).imag * way  # from the other crossing to this one
        if abs(off) < ONE_CROSSING * abs(at - start):
            return Listed((), "")
        aside = "right" if off.real > 0 else "left"
        above = "up" if off.imag > 0 else "down"
        return self.scene.say(f"crossing {aside if abs(off.real) > abs(off.imag) else above}")

    def _compass(self, bar: Bar, end: str) -> str:
        """Draw the arc about the known end of a bar on which its other end lies; return that."""
        tail, head = self.members.ends(bar)
        phrase = "compass strut" if self.members.is_strut(bar) else "compass"
        centre = tail if end == head else head
        self.further.arc(bar, centre, end, self.scene.length(bar), phrase)
        return centre

    def _lever_line(self, bar: Bar, end: str, slide: Slide) -> tuple[str, dict[str, SentencePart]]:
        """Draw the line of a lever through the block on it."""
        pin = slide.head if end == slide.tail else slide.tail
        if bar.offset.imag:
            self._link_slot_line(slide, pin)
        else:
            start, at = self.scene.at(bar.tail), self.scene.at(end)
            line = self.scene.heading(self.frame.heading(bar, self.scene.pose))
            shape = Line(start, facing(line, at - start), at)  # the block may be behind the pivot
            parts: dict[str, SentencePart] = {"link": Noun(bar.link), "tail": bar.tail, "pin": pin}
            label = bar.tail + pin
            self.ink.draw(
                bar.ends, "line", "construction", label, shape, "lever line", parts, link=bar.link
            )
        return "on lever", {"letter": end, "link": Noun(bar.link), "pin": pin}

    def _slot_line(self, slide: Slide) -> None:
        """Draw the line of a slot through the block in it."""
        head, tail = slide.head, slide.tail
        towards = self.scene.at(tail) - self.scene.at(head)
        line = self.scene.heading(self.frame.line(slide, self.scene.pose))
        shape = Line(self.scene.at(head), facing(line, towards), self.scene.at(tail))
        owner = Noun(self.ink.owner(slide))
        parts: dict[str, SentencePart] = {"head": tail, "pin": head, "link": owner}
        label = self.scene.write("parallel", line=self.scene.line(slide))
        self.ink.draw(
            slide.ends, "line", "construction", label, shape, "slot line", parts, link=slide.name
        )

    def _link_slot_line(self, slide: Slide, end: str) -> None:
        """Draw the line of the slot in a known link.

        It begins at the foot of the perpendicular from the first point of the link.
        """
        line = self.scene.heading(self.frame.line(slide, self.scene.pose))
        at, start = self.scene.at(end), self.scene.at(self.ink.carrier(slide).tail)
        foot = at - dot(line, at - start) * line
        shape = Line(foot, facing(line, at - foot), at)
        label = self.scene.write("parallel", line=self.scene.line(slide))
        parts: dict[str, SentencePart] = {"head": end, "link": Noun(str(slide.along))}
        self.ink.draw(
            slide.ends, "line", "construction", label, shape, "in slot", parts, link=slide.name
        )

    def _ink(self, loop: Loop, unknowns: tuple[Scalar, ...]) -> None:
        for step in (*loop.first, *loop.second):
            if scalar_of(step) in unknowns and isinstance(step, Bar):
                self._ink_bar(step)
        for step in (*loop.first, *loop.second):
            if scalar_of(step) in unknowns and isinstance(step, Slide):
                if step.head not in self.members.points or step.name in self.members.links:
                    continue  # a strut has no block
                if not self.members.is_guide(step) and self.ink.has_slot(step):
                    self.ink.slot(step)
                self.ink.block(step, "result", "block")

    def _ink_bar(self, bar: Bar) -> None:
        """Ink the bar of a link that is found.

        Where the slot lies beside the line of the link, the bar joins the link's own ends.
        """
        if bar.offset.imag:
            tail, head = points_of(self.motion.mechanism.links[bar.link])
            bar = Bar(tail + head, bar.link, self.scene.span(tail, head))
            self.found.update((tail, head))
        self.ink.bar(bar, "result", "bar backward" if self.scene.backward(bar) else "bar")
