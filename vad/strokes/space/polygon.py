"""Polygons of mechanisms in space: vector equations that a script states, played as in the plane.

Three unknown lengths lie along known directions, x u + y v + z w = E.  In the projection along one
of them, two lines cross.  If there are two triangles with a common side, the plane of the second
one is rotated about it into the paper.  A vector has its own sentences, so that one class of
captions serves all mechanisms.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

from vad.strokes.arithmetic import Figure
from vad.strokes.captions import PolygonCaptions
from vad.strokes.diagram import Drawing, Order
from vad.strokes.player import Pencil, Player
from vad.strokes.sentences import Sentence, Unit
from vad.strokes.sheet import Equation, Line, Stroke, Term
from vad.strokes.vector_equations import Chain, Part, Vector, VectorEquation

if TYPE_CHECKING:
    from vad.strokes.space.scene import SceneInSpace


@dataclass(frozen=True, eq=False, kw_only=True)
class SpaceVector(Vector):
    """A vector with its captions.

    Attributes
    ----------
    says
        Functions that make its sentences from the letters of the drawing: by the name of a known
        component, and "line", "result" and "whole".
    zero
        The symbol of the quantity that is zero if the crossing finds no length; empty if no caption
        says so.
    """

    says: Mapping[str, Callable[..., Sentence]] = field(default_factory=dict)
    zero: str = ""


class Stated(NamedTuple):
    """An equation, and the names of the strokes on the left and right of its sum."""

    equation: VectorEquation[SpaceVector]
    left: Sequence[str]
    right: Sequence[str]


def stated(equation: VectorEquation[SpaceVector]) -> Stated:
    """Return an equation whose sum is that of its own vectors."""
    return Stated(
        equation, *([part.drawn.name for part in chain.parts] for chain in equation.chains)
    )


class SpaceCaptions(PolygonCaptions[SpaceVector]):
    """The captions of a polygon in space; ``fixed`` are the vertices at its pole."""

    def __init__(self, scene: SceneInSpace, order: Order, unit: str, fixed: Sequence[str]) -> None:
        super().__init__(scene, order.number, unit)
        self.fixed = fixed

    def known(self, label: str, part: Part[SpaceVector]) -> Sentence:
        """Calculate a component that is known before the lines cross."""
        return part.of.says[part.name](label=label)

    def line(self, part: Part[SpaceVector], point: str, meeting: str) -> Sentence:
        """Say why the next vertex must lie on a construction line: the first half of a sentence."""
        return part.of.says["line"](point=self.place(point, point in self.fixed))

    def measures(self, part: Part[SpaceVector]) -> str:
        """Return the symbol of the quantity that is zero if a component is."""
        return part.of.zero

    def is_zero(self, part: Part[SpaceVector]) -> bool:
        """Tell whether a caption says that it is zero."""
        return bool(part.of.zero)

    def measured(self, label: str, part: Part[SpaceVector]) -> Sentence:
        """Measure a result off the polygon."""
        return part.of.says["result"](label=label)

    def whole(self, label: str, size: float, vector: SpaceVector) -> Sentence:
        """State the length of a whole vector, whose components are drawn already."""
        ends = {"label": label, "tail": vector.tail, "head": vector.head}
        return vector.says["whole"](value=Figure(size, self.unit), unit=Unit(self.unit), **ends)


def chain(*parts: Part[SpaceVector]) -> Chain[SpaceVector]:
    """Return the chain of parts that are laid tip to tail."""
    vectors = tuple(dict.fromkeys(part.of for part in parts))
    first = vectors[0]
    return Chain(first.head if first.reverse else first.tail, vectors[-1].end, vectors, parts)


def polygon(
    scene: SceneInSpace,
    order: Order,
    stated: Sequence[Stated],
    places: Mapping[str, complex],
    fixed: Sequence[str],
    pole: Sentence,
    unit: str,
    *,
    at_rest: Sequence[str] = (),
    fold: Stroke | None = None,
    remark: str = "",
) -> Drawing:
    """Return the polygon of some equations.

    Parameters
    ----------
    scene, order
        The pose, and which derivative is drawn of it.
    stated
        The equations in drawing order.
    places
        Where the vertices are.
    fixed
        The vertices at the pole.
    pole
        The caption of the pole.
    unit
        The unit of the polygon.
    at_rest
        The vertices at the pole where nothing moves, if they are others.
    fold
        The stroke that rotates the plane of the second equation into the paper.
    remark
        The text under the polygon.
    """
    longest = max(each.equation.longest for each in stated)
    words = SpaceCaptions(scene, order, unit, fixed)
    resting = longest == 0.0
    at_pole = list(at_rest if resting and at_rest else fixed)
    pencil: Pencil[SpaceVector] = Pencil(words, places.__getitem__, longest, at_pole)
    rows = tuple(scene.script.rows) if resting else ()
    pencil.begin(words.still() if resting else pole, rows)
    player = Player(pencil)
    for each in stated:
        if each.equation.folded and fold:
            pencil.add(fold)
        player.play(each.equation)
    strokes = _told_at_once(scene, pencil.strokes)
    drawn = {stroke.name: stroke for stroke in strokes}

    def terms(names: Sequence[str]) -> tuple[Term, ...]:
        found = [drawn[name] for name in names if name in drawn]
        return tuple(Term(s.label, s.link, s.name) for s in found) or (Term("0", None, None),)

    return Drawing(
        strokes,
        tuple(pencil.zeros),
        () if resting else tuple(Equation(terms(s.left), terms(s.right)) for s in stated),
        loops=tuple(player.begins),
        remark=remark,
        unit=unit,
        coincident=pencil.coincident,
    )


def _told_at_once(scene: SceneInSpace, strokes: Sequence[Stroke]) -> tuple[Stroke, ...]:
    """Return the strokes with one sentence for construction lines and the crossing after them."""
    told, lines = list(strokes), []
    for number, stroke in enumerate(strokes):
        if isinstance(stroke.shape, Line):
            lines.append(stroke)
            told[number] = replace(stroke, said=scene.say("line alone", one=stroke.said))
            continue
        if stroke.kind == "intersection" and lines:
            parts = {"one": lines[0].said, "other": lines[-1].said, "crossing": stroke.said}
            phrase = "lines and crossing" if len(lines) == 2 else "line and crossing"
            match stroke.said:
                case Sentence(phrase="crossing") if len(lines) == 2:
                    phrase, parts["crossing"] = "lines that cross", stroke.label
            said, first = scene.say(phrase, **parts), number - len(lines)
            told[first : number + 1] = (replace(x, said=said) for x in (*lines, stroke))
        lines = []
    return tuple(told)
