"""The pencil that draws a polygon: it keeps the strokes so far and where every vertex is."""

from __future__ import annotations

from dataclasses import replace

from vad.kinematics.linkage import Bar, Slide, Step, scalar_of
from vad.strokes.captions import Captions
from vad.strokes.chains import Part
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sheet import Arrow, Component, CoriolisInset, Dot, Line, Stroke


class Tip:
    """Where the drawing of one chain has got to: the vertex and its coordinates."""

    def __init__(self, name: str, at: complex) -> None:
        self.name = name
        self.at = at


class Pencil:
    """Strokes and vertices of the velocity (order 1) or acceleration (order 2) polygon."""

    def __init__(self, scene: Scene, order: int) -> None:
        self.scene = scene
        self.order = order
        self.say = Captions(scene, order)
        self.strokes: list[Stroke] = []
        self.vertices: dict[str, complex] = {}
        self.inset: CoriolisInset | None = None

    def letter(self, letter: str) -> str:
        """Return the letter of a point's image."""
        return image_letter(letter, self.order)

    def place(self, letter: str) -> complex:
        """Return the true velocity or acceleration of a point: its place in the polygon."""
        motion = self.scene.motion
        orders = self.scene.orders(self.order)
        return self.scene.outward(motion.solver.routes.rate(letter, motion.pose, orders))

    def add(self, stroke: Stroke) -> int:
        """Append a stroke and return its number."""
        self.strokes.append(stroke)
        return len(self.strokes) - 1

    def pole(self) -> None:
        """Draw the pole, where all fixed points are."""
        letters = [self.letter(letter) for letter in self.scene.motion.frame.fixed]
        self.vertices.update(dict.fromkeys(letters, 0j))
        self.add(Stroke("pole", ",".join(letters), Dot(0j), self.say.pole(letters)))

    def share_pole(self, letter: str) -> None:
        """Write a point that does not move, though it could, beside the pole's letters."""
        if self.strokes and self.strokes[0].kind == "pole":
            pole = self.strokes[0]
            self.strokes[0] = replace(pole, label=f"{pole.label},{letter}")

    def rest(self) -> None:
        """Draw the polygon of a mechanism that stands still: the pole alone."""
        motion = self.scene.motion
        label = ",".join(self.letter(letter) for letter in motion.frame.fixed)
        rows = (*motion.links, *motion.slides)
        self.add(Stroke("pole", label, Dot(0j), self.say.still(), reveals=rows))

    def known(self, part: Part, tip: Tip, name: str, at: complex | None = None) -> int:
        """Draw a known part from the tip of its chain, or towards it, and move the tip."""
        new = tip.at + (-part.vector if part.reverse else part.vector) if at is None else at
        arrow = _arrow(part, tip, name, new)
        label = arrow.tail + arrow.head
        caption = self.say.known(label, part)
        component = self._component(part)
        index = self.add(Stroke("known", label, arrow, caption, owner(part.step), component))
        if part.name == "coriolis" and isinstance(part.step, Slide):
            self.inset = self._rule(part, part.step, index)
        self.vertices[name] = new
        tip.name, tip.at = name, new
        return index

    def line(self, part: Part, tip: Tip, end: str) -> None:
        """Draw the construction line of an unknown part, past the crossing at ``end``."""
        crossing = self.place(end)
        away = (part.direction.conjugate() * (crossing - tip.at)).real < 0
        direction = -part.direction if away else part.direction
        if isinstance(part.step, Bar):
            square: str | None = self.scene.letters(part.step)
            label = f"⟂ {square}"
        else:
            square, label = None, self.scene.line_label(part.step)
        caption = self.say.line(part, tip.name, self.letter(end))
        line = Line(tip.at, direction, crossing, square)
        self.add(Stroke("construction", label, line, caption, owner(part.step)))

    def crossing(self, end: str, reveals: tuple[str, ...]) -> None:
        """Mark the point where two lines cross; ``reveals`` are results that are zero."""
        name, at = self.letter(end), self.place(end)
        self.vertices[name] = at
        caption = self.say.crossing(name, end in self.scene.motion.frame.fixed)
        self.add(Stroke("intersection", name, Dot(at), caption, reveals=reveals))

    def result(self, part: Part, tip: Tip, end: str) -> int:
        """Ink the part that the crossing has found."""
        name = self.letter(end)
        arrow = _arrow(part, tip, name, self.vertices[name])
        label = arrow.tail + arrow.head
        row, caption = owner(part.step), self.say.measured(label, part)
        component = self._component(part)
        return self.add(Stroke("result", label, arrow, caption, row, component, reveals=(row,)))

    def whole(self, step: Step, tail: str, head: str) -> None:
        """Ink the sum of a step's parts."""
        start, end = self.vertices[tail], self.vertices[head]
        still = step.ends[0] in self.scene.motion.frame.fixed
        component: Component = "absolute" if still else "relative"
        caption = self.say.whole(tail + head, end - start, step, still)
        arrow = Arrow(start, end, tail, head)
        self.add(Stroke("result", tail + head, arrow, caption, owner(step), component))

    def image(self, bar: Bar, start: str, nothing: float) -> None:
        """Find a further point of a link by proportion, and ink its vector from the pole."""
        name, at = self.letter(bar.ends[1]), self.place(bar.ends[1])
        self.vertices[name] = at
        if abs(at) > nothing:
            caption = self.say.image(bar, start + name, abs(at))
            arrow = Arrow(0j, at, start, name)
            label = start + name
            self.add(Stroke("result", label, arrow, caption, bar.link, "absolute", image=True))

    def _component(self, part: Part) -> Component:
        """Name a part; what slides on the frame moves absolutely."""
        return "absolute" if self.scene.is_guide(part.step) else part.name

    def _rule(self, part: Part, slide: Slide, index: int) -> CoriolisInset:
        """Return the directions that the Coriolis inset shows."""
        motion = self.scene.motion
        line = self.scene.heading(motion.frame.line(slide, motion.pose))
        forward = self.scene.speed(slide.name, 1) > 0
        return CoriolisInset(
            link=str(slide.along),
            slide=slide.name,
            slot=line,
            sliding=line if forward else -line,
            coriolis=part.vector / abs(part.vector),
            sense=1 if self.scene.rate(str(slide.along), 1) > 0 else -1,
            stroke=index,
        )


def owner(step: Step) -> str:
    """Return the row of the results table whose ink a step takes."""
    return scalar_of(step).name


def _arrow(part: Part, tip: Tip, name: str, at: complex) -> Arrow:
    """Return the arrow between the tip of a chain and ``name``, which runs with its step."""
    if part.reverse:
        return Arrow(at, tip.at, name, tip.name)
    return Arrow(tip.at, at, tip.name, name)
