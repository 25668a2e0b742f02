"""The pencil that draws a polygon: it keeps the strokes so far and where every vertex is."""

from __future__ import annotations

from dataclasses import replace

from vad.kinematics.linkage import Bar, Slide, Step, scalar_of
from vad.strokes.captions import Captions
from vad.strokes.chains import Part
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sheet import Arrow, Component, CoriolisInset, Dot, Kind, Line, Stroke

#: The name of the point from which a polygon begins, or where a first crossing finds it.
POLE = "pole"


class Tip:
    """Where the drawing of one chain has got to: the vertex and its coordinates.

    ``name`` is the vertex's letter as it is drawn, ``full`` what it would be if no vector of the
    chain had vanished.
    """

    def __init__(self, name: str, at: complex) -> None:
        self.name = self.full = name
        self.at = at


class Pencil:
    """Strokes and vertices of the velocity (order 1) or acceleration (order 2) polygon.

    Parameters
    ----------
    scene
        The pose.
    order
        The order of the polygon.
    nothing
        The length up to which a vector is zero; 0 where nothing moves.
    from_pole
        Whether the polygon begins at the pole, and does not find it by a crossing.
    """

    def __init__(self, scene: Scene, order: int, nothing: float, from_pole: bool) -> None:
        self.scene = scene
        self.order = order
        self.resting = nothing == 0.0
        self._nothing = nothing
        self._from_pole = from_pole
        self.say = Captions(scene, order)
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []
        self.vertices: dict[str, complex] = {}
        self.inset: CoriolisInset | None = None

    def letter(self, letter: str) -> str:
        """Return the letter of a point's image."""
        return image_letter(letter, self.order)

    def place(self, letter: str) -> complex:
        """Return the true velocity or acceleration of a point: its place in the polygon."""
        motion = self.scene.motion
        orders = self.scene.orders(self.order)
        return self.scene.outward(motion.plane.routes.rate(letter, motion.pose, orders))

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

    def pole(self) -> None:
        """Draw the pole, where all fixed points are, unless a crossing is to find it.

        Where nothing moves it is the whole polygon.
        """
        motion = self.scene.motion
        letters = [self.letter(letter) for letter in motion.frame.fixed]
        if self._from_pole:
            self.vertices.update(dict.fromkeys(letters, 0j))
        if self.resting:
            caption, rows = self.say.still(), (*motion.links, *motion.slides)
        elif self._from_pole:
            caption, rows = self.say.pole(letters), ()
        else:
            return
        pole = Stroke("pole", ",".join(letters), Dot(0j), caption, reveals=rows, name=POLE)
        self.strokes.append(pole)

    def share_pole(self, letter: str) -> None:
        """Write a point that does not move, though it could, beside the pole's letters."""
        if self._from_pole and not self.resting:
            pole = self.strokes[0]
            self.strokes[0] = replace(pole, label=f"{pole.label},{letter}")

    def known(self, part: Part, tip: Tip, name: str, at: complex | None = None) -> Stroke:
        """Draw a known part from the tip of its chain, or towards it, and move the tip."""
        new = tip.at + (-part.vector if part.reverse else part.vector) if at is None else at
        arrow = _arrow(part, tip.name, tip.at, name, new)
        label = arrow.tail + arrow.head
        caption = self.say.known(label, part)
        row, component = owner(part.step), self._component(part)
        stroke = Stroke("known", label, arrow, caption, row, component, name=part.stroke_name)
        if part.name == "coriolis" and isinstance(part.step, Slide) and self.inset is None:
            self.inset = self._rule(part, part.step, stroke.name)
        self.vertices[name] = new
        tip.name, tip.at = name, new
        return self.add(stroke)

    def vanish(self, kind: Kind, part: Part, tip: Tip, name: str) -> None:
        """Keep a part of length zero, with the letters that it would have."""
        arrow = _arrow(part, tip.full, tip.at, name, tip.at)
        row, component = owner(part.step), self._component(part)
        label = arrow.tail + arrow.head
        self.leave_out(Stroke(kind, label, arrow, "", row, component, name=part.stroke_name))

    def line(self, part: Part, tip: Tip, end: str) -> None:
        """Draw the construction line of an unknown part, past the crossing at ``end``."""
        crossing = self.place(end)
        away = (part.direction.conjugate() * (crossing - tip.at)).real < 0
        direction = -part.direction if away else part.direction
        if isinstance(part.step, Bar):
            square: str | None = self.scene.letters(part.step)
            label = f"⟂ {square}"
        else:
            square = None
            label = self.scene.say("parallel", line=self.scene.line(part.step))
        caption = self.say.line(part, tip.name, self.letter(end))
        line = Line(tip.at, direction, crossing, square)
        name = f"{part.step.ends}.line"
        self.add(Stroke("construction", label, line, caption, owner(part.step), name=name))

    def crossing(self, end: str, zeros: list[tuple[Part, str]]) -> None:
        """Mark the point where two lines cross; ``zeros`` vanish there, each at its vertex."""
        letter, at = self.letter(end), self.place(end)
        self.vertices[letter] = at
        fixed = end in self.scene.motion.frame.fixed
        name = POLE if fixed and not self._from_pole else f"{end}.crossing"
        if self.resting and name == POLE:
            return  # it is drawn already
        caption = self.say.crossing(letter, fixed, zeros)
        reveals = tuple(owner(part.step) for part, _ in zeros)
        self.add(Stroke("intersection", letter, Dot(at), caption, reveals=reveals, name=name))

    def result(self, part: Part, tip: Tip, end: str) -> Stroke:
        """Ink the part that the crossing has found."""
        letter = self.letter(end)
        arrow = _arrow(part, tip.name, tip.at, letter, self.vertices[letter])
        label = arrow.tail + arrow.head
        row, caption = owner(part.step), self.say.measured(label, part)
        component, name = self._component(part), part.stroke_name
        return self.add(
            Stroke("result", label, arrow, caption, row, component, reveals=(row,), name=name)
        )

    def whole(self, step: Bar, several: bool) -> None:
        """Ink the sum of a step's parts; without ``several`` to be seen, it is left out."""
        tail, head = self.letter(step.tail), self.letter(step.head)
        start, end = self.place(step.tail), self.place(step.head)
        still = step.tail in self.scene.motion.frame.fixed
        component: Component = "absolute" if still else "relative"
        arrow, name = Arrow(start, end, tail, head), f"{step.ends}.whole"
        stroke = Stroke("result", tail + head, arrow, "", owner(step), component, name=name)
        if several:
            caption = self.say.whole(tail + head, end - start, step)
            self.add(replace(stroke, caption=caption))
        else:
            self.leave_out(stroke)

    def from_pole(self, point: str, link: str) -> str:
        """Return the letters of a point's vector from the pole: from the link's own pivot, if any.

        Fixed points all lie there.
        """
        return self.letter(self.scene.pivot(link)) + self.letter(point)

    def absolute(self, point: str, link: str, image: bool = False, caption: str = "") -> Stroke:
        """Ink the vector from the pole to a vertex; it is left out where it is zero."""
        letter, at = self.letter(point), self.place(point)
        label = self.from_pole(point, link)
        arrow = Arrow(0j, at, label.removesuffix(letter), letter)
        caption = caption or self.say.absolute(label, point, abs(at))
        name = f"{point}.image" if image else f"{point}.absolute"
        stroke = Stroke("result", label, arrow, caption, link, "absolute", image, name=name)
        if self.shows(at):
            return self.add(stroke)
        self.leave_out(stroke)
        return stroke

    def leads_to(self, letter: str) -> Stroke | None:
        """Return what is drawn from the pole to a vertex, or would be if it were not zero."""
        for stroke in (*self.strokes, *self.zeros):
            match stroke.shape:
                case Arrow(start=0j, head=head) if head == letter:
                    return stroke
        return None

    def leave_out(self, stroke: Stroke) -> None:
        """Keep what is not drawn in this pose."""
        self.zeros.append(replace(stroke, caption="", reveals=()))

    def _component(self, part: Part) -> Component:
        """Name a part; what slides on the frame moves absolutely."""
        return "absolute" if self.scene.is_guide(part.step) else part.name

    def _rule(self, part: Part, slide: Slide, stroke: str) -> CoriolisInset:
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
            stroke=stroke,
        )


def owner(step: Step) -> str:
    """Return the row of the results table whose ink a step takes."""
    return scalar_of(step).name


def _arrow(part: Part, tip: str, tip_at: complex, name: str, at: complex) -> Arrow:
    """Return the arrow between the tip of a chain and ``name``, which runs with its step."""
    return Arrow(at, tip_at, name, tip) if part.reverse else Arrow(tip_at, at, tip, name)
