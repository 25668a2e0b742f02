"""Vector equations, which a polygon draws: two chains of vectors that end at one vertex.

In the plane they are the loops of a linkage, in space those of bodies that turn.  The code that
draws them does not need to know which: every vector and every component has its own letters.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Generic, TypeVar

from vad.strokes.sheet import Component, StrokePart, Term

if TYPE_CHECKING:
    from vad.kinematics.linkage import Step

#: Vectors shorter than this share of the longest one of a panel are zero.
NOTHING = 1e-12


@dataclass(frozen=True, eq=False)
class Vector:
    """One vector, from the vertex ``tail`` to the vertex ``head``.

    Attributes
    ----------
    name
        The first part of the names of its strokes: ``BC``.
    owner
        The row of the results table whose ink it takes.
    reverse
        Whether its chain runs through it from head to tail.
    arrives
        Whether its head is a vertex of the polygon, if all its components are known.
    lettered
        Whether its head keeps its letter if the vector is zero, at the pole, too.
    whole
        The component that the sum of its parts is, if that sum is inked, too; else None.
    measured
        Whether the results table has the quantity that is found by it.
    """

    name: str
    tail: str
    head: str
    owner: str
    reverse: bool = False
    arrives: bool = True
    lettered: bool = True
    whole: Component | None = None
    measured: bool = True

    @property
    def reveals(self) -> tuple[str, ...]:
        """The rows of the results that it measures."""
        return (self.owner,) if self.measured else ()

    @property
    def end(self) -> str:
        """The vertex at which its chain leaves it."""
        return self.tail if self.reverse else self.head


V = TypeVar("V", bound=Vector)


@dataclass(eq=False, slots=True)  # a frozen one takes several times as long to make
class Part(Generic[V]):
    """One component of a vector.

    Attributes
    ----------
    of
        The vector.
    name
        Which component it is; the name of its stroke ends so.
    vector
        Its value in the unit of the polygon, in the sense of the vector.
    direction
        A unit vector along it.
    unknown
        Whether the crossing has to find its length.
    component
        The component that its stroke has in the data.
    stage
        The vertex at which it ends, where that is not the vector's own head: cₙ.
    dictated
        Whether it is drawn before all others, because the driver alone gives it, or the polygon
        above.
    label, square_to
        The label of its construction line, and the letters that the line is perpendicular to.
    symbol
        The label of its vector; if empty, the letters of its ends.
    called
        The name of its stroke, if that is not made of the vector and the component.
    """

    of: V
    name: Component
    vector: complex
    direction: complex
    unknown: bool
    component: Component
    stage: str
    dictated: bool = False
    label: str = ""
    square_to: str | None = None
    symbol: str = ""
    called: str = ""

    @property
    def drawn(self) -> StrokePart:
        """The part that its stroke draws: ``AB.normal``."""
        return StrokePart("", self.called) if self.called else StrokePart(self.of.name, self.name)

    @property
    def reverse(self) -> bool:
        """Whether its chain runs through it from head to tail."""
        return self.of.reverse


@dataclass(eq=False, slots=True)
class Chain(Generic[V]):
    """One side of an equation, from the vertex ``start`` to the vertex ``end``.

    ``parts`` are those of its vectors in the order in which they are laid tip to tail; ``unknown``
    is the one that the crossing finds, if any.
    """

    start: str
    end: str
    vectors: tuple[V, ...]
    parts: tuple[Part[V], ...]
    unknown: Part[V] | None = field(init=False)

    def __post_init__(self) -> None:
        self.unknown = next((part for part in self.parts if part.unknown), None)

    @property
    def known(self) -> list[Part[V]]:
        """The parts that are laid before the crossing."""
        return [part for part in self.parts if not part.unknown]

    @property
    def longest(self) -> float:
        """The length of its longest part."""
        return max((abs(part.vector) for part in self.parts), default=0.0)

    def wholly_known(self, vector: V) -> bool:
        """Tell whether every component of a vector is known beforehand."""
        return self.unknown is None or self.unknown.of is not vector


@dataclass(eq=False, slots=True)
class VectorEquation(Generic[V]):
    """Two chains that end at the same vertex, the image of ``point``.

    ``folded`` is true if it holds in another plane, which is rotated into the paper.
    """

    first: Chain[V]
    second: Chain[V]
    point: str
    folded: bool = False

    @property
    def chains(self) -> tuple[Chain[V], Chain[V]]:
        """Both chains, in the order in which they are drawn."""
        return self.first, self.second

    @property
    def end(self) -> str:
        """The vertex at which both end."""
        return self.first.end

    @property
    def longest(self) -> float:
        """The length of the longest part."""
        return max(chain.longest for chain in self.chains)


@dataclass
class Side:
    """The vectors of one chain in the order in which they were drawn.

    ``start`` is the one from the pole to the vertex from which it begins, if that is another.
    """

    start: Term | None = None
    entries: list[tuple[Step | Vector, Term]] = field(default_factory=list)

    def add(self, step: Step | Vector, term: Term) -> None:
        """Append one vector of a step."""
        self.entries.append((step, term))

    def has(self, step: Step | Vector) -> bool:
        """Tell whether a vector of ``step`` has been drawn."""
        return any(other is step for other, _ in self.entries)

    def forward(self) -> list[Term]:
        """Return the vectors that run with the chain."""
        begun = [self.start] if self.start else []
        return begun + [term for step, term in self.entries if not step.reverse]

    def backward(self) -> list[Term]:
        """Return the vectors that run against it, so that each begins where the last ended."""
        return [term for step, term in reversed(self.entries) if step.reverse]
