"""Further points of a link in the position diagram: on its line, or as corners of a plate."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

from vad.kinematics.linkage import Bar, Loop, Scalar, angle_of
from vad.strokes.arithmetic import Figure
from vad.strokes.inking import Ink
from vad.strokes.scene import Scene
from vad.strokes.sentences import Noun, SentencePart, Unit
from vad.strokes.sheet import Arc, Dot

#: A compass arc shows this much on either side of the point that it is after, in degrees.
COMPASS = 14.0


class FurtherPoints:
    """What draws the points of links that no loop finds; ``found`` are those on the board."""

    def __init__(self, scene: Scene, ink: Ink, found: set[str]) -> None:
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
        else:  # the link has nothing else that does not slide
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
            self.arc(Bar(centre + point, link, span), centre, point, size)
        parts: dict[str, SentencePart] = {"letter": point, "corners": base.ends + point}
        at = Dot(self.scene.at(point))
        self.ink.draw(point, "found", "intersection", point, at, "third point", parts)
        self.found.add(point)

    def arc(self, bar: Bar, centre: str, end: str, size: Figure, phrase: str = "compass") -> None:
        """Draw a compass arc about one end of a bar through the other."""
        at, point = self.scene.at(centre), self.scene.at(end)
        angle = math.degrees(cmath.phase(point - at))
        arc = Arc(at, size.value, angle - COMPASS, 2 * COMPASS, through=point)
        letters = self.scene.members.letters(bar)
        parts: dict[str, SentencePart] = {"head": end, "tail": centre, "bar": letters, "size": size}
        parts |= {"link": Noun(bar.link), "unit": Unit(self.scene.unit)}
        self.ink.draw(
            bar.ends, "compass", "construction", letters, arc, phrase, parts, link=bar.link
        )
