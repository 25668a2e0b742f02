"""The hand that draws a polygon of bodies: known vectors, lines, crossings, measured vectors.

In come vertices and captions, out go strokes; what vanishes in a pose is kept among the zeros.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from vad.strokes.diagram import Drawing
from vad.strokes.figures import Figure, Unit
from vad.strokes.pencil import POLE
from vad.strokes.sheet import Arrow, Component, Dot, Equation, Kind, Line, Stroke, Term
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace

#: A vertex: its letter, and where it is.
Spot = tuple[str, complex]


class Hand:
    """The strokes of one polygon so far.

    Parameters
    ----------
    scene
        The pose.
    order
        1 for velocities, 2 for accelerations.
    longest
        The length of the longest vector; nothing turns where it is 0.
    unit
        That of its vectors where they are not turnings.
    """

    def __init__(self, scene: SceneInSpace, order: int, longest: float, unit: str = "") -> None:
        self.scene = scene
        self._unit = unit or ("rad/s", "rad/s²")[order - 1]
        self._nothing = NOTHING * longest
        self.resting = longest == 0.0
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []

    def drawing(self, *equations: tuple[tuple[str, ...], tuple[str, ...]]) -> Drawing:
        """Return what is drawn; sides of equations are the names of vectors."""
        drawn = {stroke.name: stroke for stroke in self.strokes}

        def terms(names: tuple[str, ...]) -> tuple[Term, ...]:
            found = [drawn[name] for name in names if name in drawn]
            none = Term("0", None, None)
            return tuple(Term(s.label, s.link, s.name) for s in found) or (none,)

        written = () if self.resting else equations
        sums = tuple(Equation(terms(left), terms(right)) for left, right in written)
        return Drawing(tuple(self.strokes), tuple(self.zeros), sums)

    def shows(self, vector: complex) -> bool:
        """Tell whether a vector is long enough to be drawn."""
        return not self.resting and abs(vector) > self._nothing

    def pole(self, spots: tuple[Spot, ...], phrase: str) -> None:
        """Draw the pole with the letters of all that is known to be there."""
        if self.resting:
            rows, caption = tuple(self.scene.headings), self.scene.say("still")
        else:
            rows, caption = (), self.scene.say(phrase)
        letters = [letter for letter, at in spots if not self.shows(at)]
        pole = Stroke("pole", ",".join(letters), Dot(0j), caption, reveals=rows, name=POLE)
        self.strokes.append(pole)

    def vector(
        self,
        name: str,
        kind: Kind,
        label: str,
        ends: tuple[Spot, Spot],
        link: str,
        caption: str,
        component: Component = "absolute",
        reveals: tuple[str, ...] = (),
        several: bool = True,
    ) -> None:
        """Draw a vector between two vertices; that of no more than one part is left out."""
        (tail, start), (head, end) = ends
        shown = self.shows(end - start)
        arrow = Arrow(start, end if shown else start, tail, head)
        stroke = Stroke(kind, label, arrow, caption, link, component, reveals=reveals, name=name)
        if shown and several:
            self.strokes.append(stroke)
        else:
            self.zeros.append(_bare(stroke))

    def measure(
        self,
        name: str,
        label: str,
        ends: tuple[Spot, Spot],
        link: str,
        value: float,
        component: Component = "absolute",
        reveals: tuple[str, ...] = (),
        several: bool = True,
    ) -> None:
        """Ink what the crossing has found, and measure it."""
        figure = Figure(float(value), self._unit)
        parts = {"label": ends[0][0] + ends[1][0], "symbol": label, "value": figure}
        caption = self.scene.say("turning measured", unit=Unit(self._unit), **parts)
        self.vector(name, "result", label, ends, link, caption, component, reveals, several)

    def line(
        self,
        name: str,
        line: str,
        through: Spot,
        way: complex,
        until: complex,
        link: str,
        caption: str,
    ) -> None:
        """Draw a construction line through a vertex, parallel to a ``line``."""
        along = (until - through[1]).real * way.real + (until - through[1]).imag * way.imag
        shape = Line(through[1], -way if along < 0.0 else way, until)
        label = self.scene.say("parallel", line=line)
        self._add(Stroke("construction", label, shape, caption, link, name=name))

    def cross(self, name: str, spot: Spot, zeros: Mapping[str, float]) -> None:
        """Mark where two lines cross; of ``zeros``, by row, those that vanish are seen there."""
        letter, at = spot
        caption = self.scene.say("crossing", letter=letter)
        seen = tuple(row for row, value in zeros.items() if not self.shows(complex(value)))
        self._add(Stroke("intersection", letter, Dot(at), caption, reveals=seen, name=name))

    def _add(self, stroke: Stroke) -> None:
        """Add a stroke; nothing is constructed where nothing turns."""
        if self.resting:
            self.zeros.append(_bare(stroke))
        else:
            self.strokes.append(stroke)


def _bare(stroke: Stroke) -> Stroke:
    return Stroke(
        stroke.kind, stroke.label, stroke.shape, "", stroke.link, stroke.component, name=stroke.name
    )
