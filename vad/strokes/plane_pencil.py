"""The pencil of the plane: vertices are images of points, the Coriolis rule has an inset."""

from __future__ import annotations

from vad.kinematics.linkage import Slide
from vad.strokes.captions import Captions
from vad.strokes.chains import StepVector
from vad.strokes.pencil import Pencil, Tip
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sentences import Sentence
from vad.strokes.sheet import Arrow, CoriolisInset, Stroke, StrokePart
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
        """Draw the pole, where all fixed points are, unless a crossing is to find it.

        Where nothing moves it is the whole polygon.
        """
        members = self.scene.members
        if self.resting:
            self.begin(self.say.still(), (*members.links, *members.slides))
        elif self.from_pole:
            self.begin(self.say.pole(self.fixed))

    def known(
        self, part: Part[StepVector], tip: Tip, name: str, at: complex | None = None
    ) -> Stroke:
        """Draw a known part; the first Coriolis part has its rule in the inset."""
        stroke = super().known(part, tip, name, at)
        step = part.of.step
        if part.name == "coriolis" and isinstance(step, Slide) and self.inset is None:
            self.inset = self._rule(part, step, stroke.name)
        return stroke

    def label_from_pole(self, point: str, link: str) -> str:
        """Return the letters of a point's vector from the pole: from the link's own pivot, if any.

        Fixed points all lie there.
        """
        return self.letter(self.scene.members.pivot(link)) + self.letter(point)

    def absolute(
        self, point: str, link: str, image: bool = False, said: Sentence | None = None
    ) -> Stroke:
        """Ink the vector from the pole to a vertex; it is left out where it is zero."""
        letter, at = self.letter(point), self.image(point)
        label = self.label_from_pole(point, link)
        arrow = Arrow(0j, at, label.removesuffix(letter), letter)
        said = said or self.say.absolute(label, point, abs(at))
        part = StrokePart(point, "image" if image else "absolute")
        stroke = Stroke("result", label, arrow, said, link, "absolute", image, part=part)
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
