"""The force polygons: each dyad in equilibrium is a vector equation, and is drawn as such.

The forces on a dyad from outside, R₁ and R₂ in its two outer joints, hold what loads it.  Known
parts of them and the loads are laid tip to tail; the lines of the two other parts cross.  The last
dyad comes first: what it has found is a load, reversed, of the next one, whose polygon stands to
the right of it or below it, at the same scale.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vad.strokes.diagram import Drawing
from vad.strokes.force_captions import ForceCaptions
from vad.strokes.force_names import ForceNames
from vad.strokes.packing import Box, in_groups
from vad.strokes.player import Pencil, Player
from vad.strokes.sheet import LOADS, Arrow, Cell, Component, Dot, Equation, Stroke, StrokePart, Term
from vad.strokes.vector_equations import NOTHING, Chain, Part, Vector, VectorEquation

if TYPE_CHECKING:
    from vad.statics.dyads import DyadForces, Half, Load


@dataclass(frozen=True, eq=False, kw_only=True)
class Force(Vector):
    """A force of a polygon.

    Attributes
    ----------
    symbol
        Its name: F₂₃, P.
    dyad, half
        The dyad on which it acts, and its half; of a load, the half whose body bears it.
    load
        The load that it is; None for a force in an outer joint.
    """

    symbol: str
    dyad: DyadForces
    half: Half
    load: Load | None = None


class DyadEquation:
    """The equation of a dyad, and the places of its vertices, of which the first is at 0.

    Attributes
    ----------
    places
        The places by the names of vertices.
    pole
        The name of the vertex at which the loads begin: about it the force in the first outer joint
        turns while the mechanism moves.
    """

    def __init__(self, dyad: DyadForces, names: ForceNames) -> None:
        self.names, self.dyad = names, dyad
        self.prefix = f"{names.number}-{dyad.number}:"
        self.places: dict[str, complex] = {self.prefix + "0": 0j}
        self._tip = self.prefix + "0"
        self.equation = self._equation()

    def _equation(self) -> VectorEquation[Force]:
        one, two = self.dyad.first, self.dyad.second
        start, end = self._tip, self.prefix + "X"
        first, parts = [], []
        head = self._after(one.known)
        known = self._outer(one, start, head)
        first.append(known)
        parts.append(self._part(known, "tangential", one.known, head))
        self.pole = self._tip
        for half, loads in ((one, one.loads), (two, two.loads[::-1])):
            for load in loads:
                tail, head = self._tip, self._after(load.force)
                vector = self._load(half, load, tail, head)
                first.append(vector)
                parts.append(self._part(vector, "load", load.force, head))
        tail = self._tip
        stage = self._after(two.known)
        last = self._outer(two, tail, end, whole="force")
        first.append(last)
        parts.append(self._part(last, "tangential", two.known, stage))
        parts.append(self._part(last, "normal", two.unknown, end, two.direction))
        self.places[end] = self.places[start] - one.unknown
        back = self._outer(one, end, start, reverse=True)
        other = self._part(back, "normal", one.unknown, end, one.direction)
        self.whole = replace(known, tail=end, whole="force")
        return VectorEquation(
            Chain(start, end, tuple(first), tuple(parts)),
            Chain(start, end, (back,), (other,)),
            f"dyad{self.dyad.number + 1}{self.names.alone}",
        )

    def _after(self, vector: complex) -> str:
        """Return the vertex after a vector at the tip, and move the tip there."""
        name = f"{self.prefix}{len(self.places)}"
        self.places[name] = self.places[self._tip] + vector
        self._tip = name
        return name

    def _outer(
        self,
        half: Half,
        tail: str,
        head: str,
        reverse: bool = False,
        whole: Component | None = None,
    ) -> Force:
        joint = half.outer
        symbol = self.names.force(joint.one, joint.other)
        return Force(
            self.names.plain(joint.one, joint.other, joint.point),
            tail,
            head,
            self.names.row(joint.other),
            reverse,
            lettered=False,
            whole=whole,
            measured=not self.names.number,
            symbol=symbol,
            dyad=self.dyad,
            half=half,
        )

    def _load(self, half: Half, load: Load, tail: str, head: str) -> Force:
        handed = load.kind == "joint"
        return Force(
            self.names.plain(load.name, load.body, load.point)
            if handed
            else self.names.plain_load(load),
            tail,
            head,
            self.names.row(load.body) if handed else LOADS,
            lettered=False,
            measured=False,
            symbol=self.names.load(load),
            dyad=self.dyad,
            half=half,
            load=load,
        )

    def _part(
        self, of: Force, which: str, vector: complex, stage: str, line: complex | None = None
    ) -> Part[Force]:
        load, other = of.load, of.half.known if which == "normal" else of.half.unknown
        component: Component = "force"
        if load:
            component = "action" if load.kind == "joint" else "load"
        symbol = of.symbol
        if not load and abs(other) > NOTHING * abs(of.half.outer.force):
            symbol += "ₙ" if which == "normal" else "ₜ"
        size = abs(vector)
        direction = line if line is not None else vector / size if size else 1 + 0j
        known: Any = which
        return Part(
            of,
            known,
            vector,
            direction,
            line is not None,
            component,
            stage,
            label=self.names.line(of.half) if line is not None else "",
            symbol=symbol,
        )


class ForcePencil(Pencil[Force]):
    """The strokes of all force polygons; each polygon has a place of its own."""

    def __init__(self, words: ForceCaptions, places: Mapping[str, complex], longest: float) -> None:
        super().__init__(words, places.__getitem__, longest, [], from_pole=False)
        self.none = longest == 0.0

    def turn_to(self, equation: VectorEquation[Force]) -> None:
        """Begin another polygon; nothing of one without forces is drawn."""
        self.resting = self.none or equation.longest <= self._nothing


def bare(stroke: Stroke) -> Stroke:
    """Return a stroke without the letters of vertices, which forces do not have."""
    shape = stroke.shape
    if isinstance(shape, Arrow):
        whole = stroke.part.which == "whole"
        assert not whole or stroke.label
        return replace(stroke, shape=replace(shape, tail="", head=""))
    return replace(stroke, label="") if isinstance(shape, Dot) else stroke


class Polygons(Player[Force]):
    """The polygons of all dyads, of all loads together or of each alone.

    Parameters
    ----------
    scene
        The pose.
    parts
        The names of all forces, or those of each load alone, whose polygons stand together.
    """

    pencil: ForcePencil

    def __init__(self, scene: Any, parts: Sequence[ForceNames]) -> None:
        self.names = parts[0]
        self.lines = [[DyadEquation(each, names) for each in names.dyads] for names in parts]
        self.dyads = [each for line in self.lines for each in line]
        self.longest = max(each.equation.longest for each in self.dyads)
        self.captions = {names.number: ForceCaptions(scene, names) for names in parts}
        self.words = self.captions[self.names.number]
        super().__init__(ForcePencil(self.words, self._places, self.longest))

    @cached_property
    def _places(self) -> dict[str, complex]:
        """The places of all vertices: polygon after polygon, in lines that fill the panel.

        Those of one load stand together.  Over a turn, each polygon keeps its pole.
        """
        fixed = self.names.poles
        if fixed:
            return {
                name: place - each.places[each.pole] + fixed[each.dyad.number]
                for each in self.dyads
                for name, place in each.places.items()
            }
        lines = [[each.places for each in line] for line in self.lines]
        lines += [sums] if (sums := self.further()) else []
        seen = [[each for each in line if self._is_seen(each)] for line in lines]
        boxes = [[_box(each) for each in line] for line in seen if line]
        places = {name: place for line in lines for each in line for name, place in each.items()}
        moved = iter(in_groups(boxes))
        for each in (each for line in seen for each in line):
            shift = next(moved)
            places |= {name: place + shift for name, place in each.items()}
        return places

    def _is_seen(self, places: Mapping[str, complex]) -> bool:
        """Tell whether a polygon is more than a point."""
        low, high = _box(places)
        return abs(high - low) > NOTHING * self.longest

    def further(self) -> list[dict[str, complex]]:
        """Return the vertices of what stands below the polygons of dyads."""
        return []

    def last(self) -> None:
        """Draw what comes after the polygons of dyads."""

    def draw(self) -> Drawing:
        """Draw dyad after dyad; where none has a force, say so."""
        pencil = self.pencil
        equations = []
        for each in self.dyads:
            pencil.words = self.captions[each.names.number]
            pencil.turn_to(each.equation)
            self.play(each.equation)
            whole, half = each.whole, each.dyad.first
            several = pencil.shows(half.known) and pencil.shows(half.unknown)
            pencil.whole(whole, several)
            if not pencil.resting:
                equations.append(self._written(each))
        self.last()
        if not equations:
            said = self.words.nothing()
            pole = Stroke("pole", "", Dot(0j), said, reveals=self.rows, part=StrokePart("", "pole"))
            pencil.strokes.append(pole)
        return Drawing(
            tuple(bare(_named(stroke, self.symbols)) for stroke in pencil.strokes),
            tuple(bare(_named(stroke, self.symbols)) for stroke in pencil.zeros),
            tuple(equations),
            loops=tuple(self.begins) if equations else (),
        )

    @property
    def rows(self) -> tuple[str, ...]:
        """The rows of the results that have a force."""
        halves = (half for each in self.dyads for half in (each.dyad.first, each.dyad.second))
        return tuple(self.names.row(half.bodies[0]) for half in halves)

    @cached_property
    def symbols(self) -> dict[str, str]:
        """The symbols of whole forces by the names of their vectors."""
        vectors = (v for each in self.dyads for c in each.equation.chains for v in c.vectors)
        return {vector.name: vector.symbol for vector in vectors}

    def _written(self, each: DyadEquation) -> Equation:
        """Return the sum of all forces on a dyad, which is zero: what is known comes first."""
        drawn = {stroke.name for stroke in self.pencil.strokes}
        terms = []
        first, _ = each.equation.chains
        for vector in (*first.vectors[1:], first.vectors[0]):
            for which in ("whole", "load", "normal", "tangential"):
                name = f"{vector.name}.{which}"
                if name in drawn:
                    terms.append(Term(vector.symbol, vector.owner, name))
                    break
        return Equation(tuple(terms), (Term("0", None, None),))


def _box(places: Mapping[str, complex]) -> Box:
    """Return what a polygon takes."""
    across = [place.real for place in places.values()]
    up = [place.imag for place in places.values()]
    return complex(min(across), min(up)), complex(max(across), max(up))


def _named(stroke: Stroke, symbols: Mapping[str, str]) -> Stroke:
    """Return a whole force with its symbol."""
    whole = stroke.part.which == "whole"
    return replace(stroke, label=symbols[stroke.part.of]) if whole else stroke


def force_polygons(scene: Any) -> Drawing:
    """Return the force polygons of a pose, or of each load alone and the sums of all."""
    if scene.force_parts:
        from vad.strokes.superposition import superposed_polygons  # few drawings have it

        return superposed_polygons(scene)
    return Polygons(scene, [scene.force_names]).draw()


def force_cells(scene: Any, key: str, slides: bool) -> tuple[Cell, ...]:
    """Return the force in the outer joint of the body of a row; of the row of loads, these.

    A cylinder has two rows, of which that of its link has the force.
    """
    if slides and key in scene.members.links:
        return ()
    cells: tuple[Cell, ...] = scene.force_names.cells(key)
    return cells
