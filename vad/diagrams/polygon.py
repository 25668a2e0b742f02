"""The velocity and the acceleration polygon: the solver's loop equations, drawn.

In each chain of a loop the known components are laid tip to tail, then a line is drawn in the
direction of the unknown one; the two lines cross, and the pieces up to the crossing are inked
and measured.
"""

from __future__ import annotations

from dataclasses import replace

from vad.diagrams.captions import Captions
from vad.diagrams.equations import Side, equation
from vad.diagrams.parts import NOTHING, Chain, Part
from vad.diagrams.scene import Scene, image_letter
from vad.diagrams.strokes import (
    Arrow,
    Component,
    CoriolisInset,
    Dot,
    Equation,
    Line,
    Panel,
    PanelName,
    Stroke,
    Term,
)
from vad.kinematics.linkage import Bar, Scalar, Slide, Step, angle_of, scalar_of

SUBSCRIPT_N = "ₙ"


def polygon(scene: Scene, order: int) -> Panel:
    """Return the velocity (order 1) or acceleration (order 2) panel of a pose."""
    return _Polygon(scene, order).panel()


class _Tip:
    """Where the drawing of one chain has got to."""

    def __init__(self, name: str, at: complex) -> None:
        self.name = name
        self.at = at


class _Polygon:
    def __init__(self, scene: Scene, order: int) -> None:
        self.scene = scene
        self.order = order
        self.say = Captions(scene, order)
        self.strokes: list[Stroke] = []
        self.vertices: dict[str, complex] = {}
        self.equations: list[Equation] = []
        self.inset: CoriolisInset | None = None
        linkage = scene.motion.solver.linkage
        self.loops = [
            [Chain(scene, chain, unknowns, order) for chain in (loop.first, loop.second)]
            for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
        ]
        longest = max(chain.longest for chains in self.loops for chain in chains)
        self.nothing = NOTHING * longest

    # --- the whole ----------------------------------------------------------------------------

    def panel(self) -> Panel:
        linkage = self.scene.motion.solver.linkage
        fixed = self.scene.motion.solver.fixed
        known: set[Scalar] = {self.scene.driver}
        if self.nothing == 0.0:
            return self._still()
        if all(chain.start in fixed for chains in self.loops for chain in chains):
            self._pole()
        for number, chains in enumerate(self.loops):
            sides = self._loop(chains)
            known.update(linkage.unknowns[number])
            self.equations.append(equation(linkage.loops[number], *sides))
            self._images(known)
        return self._framed()

    def _framed(self) -> Panel:
        name: PanelName = "velocity" if self.order == 1 else "acceleration"
        unit = self.scene.rate_unit(self.order)
        return Panel(name, unit, tuple(self.strokes), tuple(self.equations), self.inset)

    def _still(self) -> Panel:
        """Return the panel of a mechanism that stands still: the pole alone."""
        motion = self.scene.motion
        label = ",".join(self._letter(letter) for letter in motion.solver.fixed)
        rows = (*motion.links, *motion.slides)
        self._add(Stroke("pole", label, Dot(0j), self.say.still(), reveals=rows))
        return self._framed()

    def _add(self, stroke: Stroke) -> int:
        self.strokes.append(stroke)
        return len(self.strokes) - 1

    def _letter(self, letter: str) -> str:
        return image_letter(letter, self.order)

    def _at(self, letter: str) -> complex:
        """Return the true velocity or acceleration of a point: its place in the polygon."""
        motion = self.scene.motion
        found = motion.routes.rate(letter, motion.pose, self.scene.orders(self.order))
        return self.scene.outward(found)

    def _pole(self) -> None:
        letters = [self._letter(letter) for letter in self.scene.motion.solver.fixed]
        for letter in letters:
            self.vertices[letter] = 0j
        self._add(Stroke("pole", ",".join(letters), Dot(0j), self.say.pole(letters)))

    def _share_pole(self, letter: str) -> None:
        """Write a point that does not move, though it could, beside the pole's letters."""
        if self.strokes and self.strokes[0].kind == "pole":
            pole = self.strokes[0]
            self.strokes[0] = replace(pole, label=f"{pole.label},{letter}")

    # --- one loop -----------------------------------------------------------------------------

    def _loop(self, chains: list[Chain]) -> tuple[Side, Side]:
        sides = (Side(), Side())
        tips = [self._begin(chain) for chain in chains]
        both = list(zip(chains, tips, sides, strict=True))
        for chain, tip, side in both:
            self._skip(chain, tip, side)
        # What the driver dictates comes first, then chain after chain.
        for chain, tip, side in both:
            self._lay(chain, tip, side, [p for p in chain.known if self._dictated(p)])
        for chain, tip, side in both:
            self._lay(chain, tip, side, [p for p in chain.known if not self._dictated(p)])
            self._line(chain, tip)
        self._cross(both)
        return sides

    def _dictated(self, part: Part) -> bool:
        """Tell whether the driver alone gives a part; Coriolis needs a link that is found."""
        return self.scene.drives(part.step) and part.name != "coriolis"

    def _begin(self, chain: Chain) -> _Tip:
        name = self._letter(chain.start)
        if name not in self.vertices:
            self.vertices[name] = self._at(chain.start)
        return _Tip(name, self.vertices[name])

    def _skip(self, chain: Chain, tip: _Tip, side: Side) -> None:
        """Walk over steps whose head is on the board already."""
        for step in chain.steps:
            name = self._letter(step.ends[1])
            if name not in self.vertices or not chain.wholly_known(step) or step.reverse:
                return
            label = tip.name + name
            drawn = next((i for i, s in enumerate(self.strokes) if s.label == label), None)
            side.add(step, Term(label, _owner(step), drawn))
            chain.known = [part for part in chain.known if part.step is not step]
            tip.name, tip.at = name, self.vertices[name]

    def _lay(self, chain: Chain, tip: _Tip, side: Side, parts: list[Part]) -> None:
        """Draw known parts tip to tail."""
        steps = list(dict.fromkeys(part.step for part in parts))
        drawn = [part for part in parts if abs(part.vector) > self.nothing]
        begun: dict[Step, str] = {}
        for number, part in enumerate(drawn):
            step = part.step
            begun.setdefault(step, tip.name)
            last = all(other.step is not step for other in drawn[number + 1 :])
            name = self._end_name(chain, part, last)
            lettered = last and chain.wholly_known(step) and not _on_link(step)
            self._arrow("known", part, tip, name, self._at(step.ends[1]) if lettered else None)
            side.add(step, Term(self.strokes[-1].label, _owner(step), len(self.strokes) - 1))
            if lettered and begun[step] != self.strokes[-1].shape.tail:  # type: ignore[union-attr]
                self._whole(step, begun[step], name)
        for step in steps:
            name = self._letter(step.ends[1])
            point = step.ends[1] in self.scene.motion.points
            if point and chain.wholly_known(step) and name not in self.vertices:  # it stands still
                self.vertices[name] = tip.at
                self._share_pole(name)
                tip.name = name

    def _end_name(self, chain: Chain, part: Part, last: bool) -> str:
        step = part.step
        if part.name == "coriolis":
            return "z"
        if last and chain.wholly_known(step):
            return self._letter(step.ends[1])
        letter = step.ends[1].lower()
        if part.name == "sliding":
            return self._letter(letter)
        if chain.wholly_known(step):
            return self._letter(letter) + SUBSCRIPT_N
        assert isinstance(step, Bar)
        if scalar_of(step) != self.scene.driver and self.scene.driver.name == step.length:
            letter = step.ends[0].lower()
        name = letter + SUBSCRIPT_N
        return name if name not in self.vertices else f"{letter}″{SUBSCRIPT_N}"

    def _arrow(
        self, kind: str, part: Part, tip: _Tip, name: str, at: complex | None = None
    ) -> None:
        """Draw one part from the tip of its chain, or towards it, and move the tip."""
        new = tip.at + (-part.vector if part.reverse else part.vector) if at is None else at
        ends = (new, tip.at, name, tip.name) if part.reverse else (tip.at, new, tip.name, name)
        arrow = Arrow(*ends)
        label = arrow.tail + arrow.head
        component: Component = part.name  # type: ignore[assignment]
        if isinstance(part.step, Slide) and self.scene.is_guide(part.step):
            component = "absolute"
        caption = self.say.known(label, part)
        index = self._add(Stroke("known", label, arrow, caption, _owner(part.step), component))
        self.vertices[name] = new
        if part.name == "coriolis" and isinstance(part.step, Slide):
            self.inset = self._rule(part, part.step, index)
        tip.name, tip.at = name, new

    def _rule(self, part: Part, slide: Slide, index: int) -> CoriolisInset:
        line = self.scene.heading(self.scene.motion.solver.line(slide, self.scene.motion.pose))
        forward = self.scene.speed(slide.name, 1) > 0
        omega = self.scene.rate(str(slide.along), 1)
        return CoriolisInset(
            link=str(slide.along),
            slide=slide.name,
            slot=line,
            sliding=line if forward else -line,
            coriolis=part.vector / abs(part.vector),
            sense=1 if omega > 0 else -1,
            stroke=index,
        )

    def _whole(self, step: Step, tail: str, head: str) -> None:
        start, end = self.vertices[tail], self.vertices[head]
        still = step.ends[0] in self.scene.motion.solver.fixed
        component: Component = "absolute" if still else "relative"
        caption = self.say.whole(tail + head, end - start, step, still)
        arrow = Arrow(start, end, tail, head)
        self._add(Stroke("result", tail + head, arrow, caption, _owner(step), component))

    def _line(self, chain: Chain, tip: _Tip) -> None:
        part = chain.unknown
        assert part is not None
        crossing = self._at(chain.end)
        towards = crossing - tip.at
        away = (part.direction.conjugate() * towards).real < 0
        direction = -part.direction if away else part.direction
        square = self.scene.letters(part.step) if isinstance(part.step, Bar) else None
        if isinstance(part.step, Bar):
            label = f"⟂ {square}"
        else:
            label = self.scene.line_label(part.step)
        caption = self.say.line(part, tip.name, self._letter(chain.end))
        line = Line(tip.at, direction, crossing, square)
        self._add(Stroke("construction", label, line, caption, _owner(part.step)))

    # --- the crossing and what it shows -------------------------------------------------------

    def _cross(self, both: list[tuple[Chain, _Tip, Side]]) -> None:
        chain = both[0][0]
        name, at = self._letter(chain.end), self._at(chain.end)
        self.vertices[name] = at
        pole = chain.end in self.scene.motion.solver.fixed
        unknown = [(c.unknown, tip, side) for c, tip, side in both if c.unknown is not None]
        missing = tuple(_owner(p.step) for p, *_ in unknown if abs(p.vector) <= self.nothing)
        caption = self.say.crossing(name, pole)
        self._add(Stroke("intersection", name, Dot(at), caption, reveals=missing))
        # Forward parts first: the lever's point is reached before the block slides on from it.
        unknown.sort(key=lambda found: found[0].reverse)
        composite = [self._is_composite(found[0], found[2]) for found in unknown]
        for (part, tip, side), several in zip(unknown, composite, strict=True):
            if several:
                self._result(part, tip, side, name, at)
        for (part, tip, side), several in zip(unknown, composite, strict=True):
            if not several:
                self._result(part, tip, side, name, at)
            elif isinstance(part.step, Bar) and part.step.length != self.scene.driver.name:
                tail = self._letter(part.step.ends[0])
                self._whole(part.step, tail, name)

    def _is_composite(self, part: Part, side: Side) -> bool:
        return side.has(part.step) and abs(part.vector) > self.nothing

    def _result(self, part: Part, tip: _Tip, side: Side, name: str, at: complex) -> None:
        step = part.step
        if abs(part.vector) <= self.nothing:
            return
        ends = (at, tip.at, name, tip.name) if part.reverse else (tip.at, at, tip.name, name)
        arrow = Arrow(*ends)
        label = arrow.tail + arrow.head
        component: Component = part.name  # type: ignore[assignment]
        if self.scene.is_guide(step):
            component = "absolute"
        caption = self.say.measured(label, part)
        owner = _owner(step)
        stroke = Stroke("result", label, arrow, caption, owner, component, reveals=(owner,))
        index = self._add(stroke)
        side.add(step, Term(label, owner, index))

    def _images(self, known: set[Scalar]) -> None:
        """Find further points of the links that are known by now, by proportion."""
        solver = self.scene.motion.solver
        for bar in solver.linkage.images:
            name, tail = self._letter(bar.ends[1]), self._letter(bar.ends[0])
            if name in self.vertices or angle_of(bar.link) not in known:
                continue
            at = self._at(bar.ends[1])
            self.vertices[name] = at
            start = tail if bar.ends[0] in solver.fixed else self._letter(solver.linkage.pivot)
            if abs(at) > self.nothing:
                caption = self.say.image(bar, start + name, abs(at))
                arrow = Arrow(0j, at, start, name)
                self._add(
                    Stroke("result", start + name, arrow, caption, bar.link, "absolute", image=True)
                )


def _on_link(step: Step) -> bool:
    """Tell whether a step slides on a turning link: its end is a stage, no point of the link."""
    return isinstance(step, Slide) and isinstance(step.along, str)


def _owner(step: Step) -> str:
    """Return the row of the results table whose ink a step takes."""
    return step.link if isinstance(step, Bar) else step.name

