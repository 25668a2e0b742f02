"""What is drawn upon a finished mechanism: points, lines, circles and segments that stay."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from vad.kinematics.numbers import facing
from vad.strokes.construct import construct
from vad.strokes.diagram import Drawing
from vad.strokes.shapes import Turned
from vad.strokes.sheet import Arc, Curve, Dot, Line, Shape, Stroke, StrokePart
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.strokes.scene import Scene
    from vad.strokes.sentences import Sentence


class FigurePencil:
    """The strokes of a figure so far, after those of the mechanism, which is there already.

    Parameters
    ----------
    scene
        The pose.
    angle
        Whether the angle of the driven link is drawn.

    Attributes
    ----------
    size
        The largest distance of two points of the mechanism.
    strokes, zeros
        What is drawn, and what is not drawn in this pose.
    """

    def __init__(self, scene: Scene, angle: bool = True) -> None:
        self.scene = scene
        self._mechanism = construct(scene)
        gone = ("construction",) if angle else ("construction", "angle")
        # They are there from the beginning; the results are those that the figure finds.
        self.strokes = [
            replace(each, reveals=()) for each in self._mechanism.strokes if each.kind not in gone
        ]
        self.given = len(self.strokes)
        self.zeros: list[Stroke] = []
        places = [scene.at(point) for point in scene.members.points]
        self.size = max(abs(one - other) for one in places for other in places)

    def add(
        self,
        of: str,
        which: str,
        kind: str,
        label: str,
        shape: Shape,
        said: Sentence | str,
        link: str | None = None,
        reveals: Sequence[str] = (),
    ) -> None:
        """Add a stroke of the figure."""
        part = StrokePart(of, which)
        more = {"component": "figure", "reveals": tuple(reveals), "part": part}
        self.strokes.append(Stroke(kind, label, shape, said, link, **more))  # type: ignore[arg-type]

    def line(
        self,
        of: str,
        which: str,
        through: complex,
        until: complex,
        way: complex,
        said: Sentence,
        link: str | None = None,
    ) -> None:
        """Draw a line from one point past another one; ``way`` is its direction."""
        line = Line(through, facing(way, until - through), until)
        self.add(of, which, "construction", "", line, said, link)

    def point(self, letter: str, at: complex, said: Sentence, link: str | None = None) -> None:
        """Mark a point that is found."""
        self.add(letter, "found", "intersection", letter, Dot(at), said, link)

    def circle(
        self, of: str, centre: complex, radius: float, through: complex, said: Sentence
    ) -> None:
        """Draw a whole circle."""
        self.add(of, "circle", "construction", "", Arc(centre, radius, 0.0, 360.0, through), said)

    def segment(
        self,
        of: str,
        start: complex,
        end: complex,
        said: Sentence,
        link: str | None,
        reveals: Sequence[str] = (),
    ) -> None:
        """Ink a segment; one without a length shows its result all the same."""
        if abs(end - start) > NOTHING * self.size or reveals:
            self.add(of, "segment", "result", "", Curve((start, end)), said, link, reveals)
            return
        part = StrokePart(of, "segment")
        shape = Curve((start, end))
        self.zeros.append(Stroke("result", "", shape, "", link, "figure", part=part))

    def drawing(self, remark: str = "", turned: Sequence[Turned] = ()) -> Drawing:
        """Return the panel's content."""
        return replace(
            self._mechanism,
            strokes=tuple(self.strokes),
            zeros=tuple(self.zeros),
            equations=(),
            loops=(),
            remark=remark,
            given=self.given,
            turned=tuple(turned),
        )
