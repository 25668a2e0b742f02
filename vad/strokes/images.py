"""Further points of a link in a polygon: found by its image, which is similar to the link.

A point in line with two known ones divides the image in the link's ratio.  One beside them is the
third corner of a triangle: its sides are perpendicular to the link's in the velocity polygon, and
stand at the link's own angles in the acceleration polygon.
"""

from __future__ import annotations

import cmath
import math

from vad.kinematics.linkage import Bar
from vad.strokes.arithmetic import Figure, product
from vad.strokes.order import ORDERS
from vad.strokes.plane_pencil import PlanePencil
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sentences import Noun, Sentence, Unit
from vad.strokes.sheet import Dot, ImageTriangle, Line, Stroke, StrokePart


class Images:
    """The images that are drawn in one polygon of an order."""

    def __init__(self, scene: Scene, order: int, pencil: PlanePencil) -> None:
        self._scene = scene
        self._order = order
        self._pencil = pencil
        self.triangles: list[ImageTriangle] = []

    def find(self, bar: Bar, whole: bool = True) -> None:
        """Find the head of a bar, whose link is known; with its vector from the pole if ``whole``.

        A point in line always has that vector, of which its caption speaks.
        """
        base = self._scene.members.base(bar.link)
        if self._scene.in_line(bar.link, bar.head):
            self._divide(bar, base)
            return
        self._construct(bar, base)
        if whole:
            self._pencil.absolute(bar.head, bar.link, image=True)

    def _divide(self, bar: Bar, base: Bar) -> None:
        """Find a point in line by proportion."""
        pencil = self._pencil
        at = pencil.image(bar.head)
        said = None
        if pencil.shows(at):
            known, own = (abs(pencil.image(b.head) - pencil.image(b.tail)) for b in (base, bar))
            label = pencil.label_from_pole(bar.head, bar.link)
            said = pencil.say.image(bar, base, label, (known, own, abs(at)))
        pencil.vertices[pencil.letter(bar.head)] = at
        pencil.absolute(bar.head, bar.link, image=True, said=said)

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
        said = self._similar(bar, base) if turns else self._alike(bar, letters)
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
            said = scene.say(
                "image line",
                point=pencil.letter(near),
                corner=corner,
                angle=scene.measured(self._angle(near, far, bar.head), "°"),
                side=pencil.letter(near) + pencil.letter(far),
                meeting=pencil.letter(bar.head),
            )
        away = until - through
        line = Line(through, away / abs(away) if turns else 1.0, until, square)
        own = StrokePart(side, "line")
        stroke = Stroke("construction", label, line, said, bar.link, part=own)
        if turns:
            pencil.add(stroke)
        else:
            pencil.leave_out(stroke)

    def _angle(self, near: str, far: str, third: str) -> float:
        """Return the angle at a corner of the link, in degrees, counter-clockwise positive."""
        corner, one, other = map(self._scene.at, (near, far, third))
        return math.degrees(cmath.phase((other - corner) / (one - corner)))

    def _similar(self, bar: Bar, base: Bar) -> Sentence:
        """Say that the image is similar to the link, and how long its next side is."""
        scene, pencil = self._scene, self._pencil
        side = base.tail + bar.head
        unit = scene.rate_unit(self._order)
        spans = [abs(scene.at(head) - scene.at(base.tail)) for head in (bar.head, base.head)]
        size = scene.measured(spans[0], unit)
        length = scene.measured(spans[1], unit, power=-1)
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
        """Say that all points of the link move alike."""
        phrase = f"image alike {ORDERS[self._order].panel}"
        return self._scene.say(phrase, letter=letters[2], point=letters[0], link=Noun(bar.link))
