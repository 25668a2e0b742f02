"""What a mechanism is made of: bars and slides that close in loops.

A loop is two chains of vectors that end at the same point, with exactly two unknown scalars
between them.  Omission declares the unknown: a bar turns by an unknown angle unless its link is
driven or found in an earlier loop; a slide has an unknown length unless it is driven.

A linkage that would be solved wrongly is refused when it is made, with the number of the loop.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

from vad import gate
from vad.errors import InputError, quoted
from vad.kinematics.symbol import Symbol, as_complex, as_float

# Lines at a smaller angle than this (in degrees) count as parallel: where they cross is so far away
# that squares of the distance leave the range of double precision.
_LEAST_ANGLE = 1e-30
# The name of a point: a letter, or a letter and a number.
_POINT = r"[^\W\d_][0-9]*"


class _Run:
    """What bars and slides have in common: the two points between which they run."""

    __slots__ = ()

    ends: str
    reverse: bool

    @property
    def tail(self) -> str:
        """The point at which the vector begins."""
        return points_of(self.ends)[0]

    @property
    def head(self) -> str:
        """The point at which the vector ends."""
        return points_of(self.ends)[1]

    @property
    def start(self) -> str:
        """The point at which a loop enters it: its head if it is reversed."""
        return self.head if self.reverse else self.tail

    @property
    def end(self) -> str:
        """The point at which a loop leaves it."""
        return self.tail if self.reverse else self.head


@dataclass(frozen=True, slots=True)
class Bar(_Run):
    """A vector that turns with its link: (length + offset) · turn · u; u is the link's direction.

    Attributes
    ----------
    ends
        The points at its tail and its head, each a letter or a letter and a number: ``"BC"``,
        ``"O2A"``.
    link
        The link that it belongs to and whose angle it has.
    length
        Its length, or the name of the slide whose length it has.  A negative length points
        against the link.
    reverse
        Whether the loop runs through it from head to tail; written ``-Bar(…)``.
    turn
        Its direction in the axes of its link, as a unit vector.  It differs from 1 for the further
        sides of a link with three points or more.
    offset
        What is added to the length of a slide, as ahead + i·aside, where the slot runs beside the
        tail or is not measured from there.  Only for a bar that has the length of a slide.
    """

    ends: str
    link: str
    length: float | str
    reverse: bool = False
    turn: complex = 1.0 + 0j
    offset: complex = 0j

    def __post_init__(self) -> None:
        points_of(self.ends)
        gate.line(f"link of {self.ends}", self.link)
        object.__setattr__(self, "length", _number(f"length of {self.ends}", self.length))
        if isinstance(self.length, float) and self.length:
            check_length(f"length of {self.ends}", abs(self.length))
        check_place(f"offset of {self.ends}", self.offset)
        object.__setattr__(self, "turn", _unit(f"turn of {self.ends}", self.turn))
        if self.offset and not isinstance(self.length, str):
            raise InputError(
                f"offset of {self.ends}: goes with the length of a slide",
                hint="a bar of one length has a turn",
            )

    @property
    def against(self) -> bool:
        """Whether it points against its link."""
        return isinstance(self.length, float) and self.length < 0.0

    def __neg__(self) -> Bar:
        return replace(self, reverse=not self.reverse)


@dataclass(frozen=True, slots=True)
class Slide(_Run):
    """A vector that changes its length along a line.

    Attributes
    ----------
    ends
        The points at its tail and its head: ``"DC"``.
    name
        The slide whose length it has.
    along
        The direction of the line in degrees, or the name of the turning link on which it slides.
        On a link, the link's bar has the length itself; the slide adds the sliding and the Coriolis
        component.
    origin
        The zero of a fixed line, as x + iy in the user's axes.
    through_tail
        Whether a fixed line passes exactly through its tail, however `origin` is rounded.
    reverse
        Whether the loop runs through it from head to tail; written ``-Slide(…)``.
    turn
        On a link, the direction of the line in the link's axes: that of the bar that carries it.
    """

    ends: str
    name: str
    along: float | str
    origin: complex = 0j
    reverse: bool = False
    through_tail: bool = False
    turn: complex = 1.0 + 0j

    def __post_init__(self) -> None:
        points_of(self.ends)
        gate.line(f"name of {self.ends}", self.name)
        object.__setattr__(self, "along", _number(f"direction of {self.ends}", self.along))
        object.__setattr__(self, "turn", _unit(f"turn of {self.ends}", self.turn))
        check_place(f"origin of {self.ends}", self.origin)

    def __neg__(self) -> Slide:
        return replace(self, reverse=not self.reverse)


Step = Bar | Slide
# A step, and +1 or -1: whether it is taken from tail to head, or counted negative.
SignedStep = tuple[int, Step]


def points_of(ends: str) -> tuple[str, str]:
    """Return the two points that a vector is named by.

    Examples
    --------
    >>> points_of("BC"), points_of("O2A")
    (('B', 'C'), ('O2', 'A'))
    """
    pair = _points_of(ends) if isinstance(ends, str) else None
    if pair is None:
        hint = "such as 'BC', or 'O2A' from O2 to A"
        raise InputError(f"ends: must be two points, got {quoted(ends)}", hint)
    return pair


@lru_cache(maxsize=4096)
def _points_of(ends: str) -> tuple[str, str] | None:
    pair = re.fullmatch(rf"({_POINT})({_POINT})", ends)
    return (pair[1], pair[2]) if pair else None


def _number(what: str, value: float | str) -> float | str:
    """Return a number as a float, and a name as it is."""
    if isinstance(value, str):
        return gate.line(what, value)
    if isinstance(value, Symbol):
        return value
    try:
        return gate.number(what, value)
    except InputError:
        wanted = "must be a finite number or a name"
        raise InputError(f"{what}: {wanted}, got {quoted(value)}") from None


def check_length(what: str, length: float) -> None:
    """Refuse a length whose products would leave the range of double precision."""
    wrong = gate.wrong_dimension(length, signed=False)
    if wrong:
        raise InputError(f"{what}: {wrong}")


def check_place(what: str, place: complex) -> None:
    """Refuse a place that is not finite, or farther away than any length."""
    if not _is_finite(place):
        raise InputError(f"{what}: must be at a finite place, got {quoted(place)}")
    farthest = max(abs(float(place.real)), abs(float(place.imag)))
    if farthest > gate.LONGEST:
        raise InputError(f"{what}: must be within ±{gate.LONGEST:g}, got {farthest:g}")


def _unit(what: str, value: complex) -> complex:
    """Return a unit vector as a complex number."""
    if not _is_finite(value) or not abs(math.hypot(value.real, value.imag) - 1.0) < 1e-9:
        raise InputError(f"{what}: must be a unit vector, got {quoted(value)}")
    return as_complex(value)


def _is_finite(value: object) -> bool:
    """Tell whether a value is a finite plane vector; a whole number may be too large for one."""
    try:
        return isinstance(value, complex | float | int) and cmath.isfinite(value)
    except OverflowError:
        return False


class Scalar(NamedTuple):
    """One scalar of the motion: the angle of a link or the length of a slide."""

    kind: str
    name: str

    def __str__(self) -> str:
        return f"the {self.kind} of {self.name}"


@lru_cache(maxsize=256)
def angle_of(link: str) -> Scalar:
    """Name the angle of a link."""
    return Scalar("angle", link)


@lru_cache(maxsize=256)
def length_of(slide: str) -> Scalar:
    """Name the length of a slide."""
    return Scalar("length", slide)


def scalar_of(step: Step) -> Scalar:
    """Name the scalar that moves the head of a bar or slide against its tail."""
    return angle_of(step.link) if isinstance(step, Bar) else length_of(step.name)


def scalars_of(step: Step) -> set[Scalar]:
    """Name all angles and lengths that make a bar or slide.

    Examples
    --------
    >>> sorted(map(str, scalars_of(Slide("QB", "block", "lever"))))
    ['the angle of lever', 'the length of block']
    """
    if isinstance(step, Bar):
        others = {length_of(step.length)} if isinstance(step.length, str) else set[Scalar]()
    else:
        others = {angle_of(step.along)} if isinstance(step.along, str) else set[Scalar]()
    return {scalar_of(step)} | others


@dataclass(frozen=True, slots=True)
class Loop:
    """Two chains that end at the same point.

    Attributes
    ----------
    first, second
        The chains, each from a fixed point, or both from the same point.
    side
        Which of two places the common end point takes, +1.0 or -1.0.  For two unknown angles,
        +1.0 means that it lies to the left of the line from the known end of ``first`` to that of
        ``second``; for an angle and a length, +1.0 means the greater length.  In the crossed
        assembly of a mechanism every loop takes its other place.
    parallel
        Whether its four bars are a parallelogram that stays one through its change points: then
        each chain has one known vector, as long as the unknown bar of the other.
    """

    first: tuple[Step, ...]
    second: tuple[Step, ...]
    side: float = 1.0
    parallel: bool = False

    def steps(self) -> Iterator[tuple[int, Step]]:
        """Yield every step with its sign in ``second - first``, reversal included."""
        for side, chain in ((-1, self.first), (1, self.second)):
            for step in chain:
                yield (-side if step.reverse else side), step


class Rod(NamedTuple):
    """The rod of a cylinder.

    Attributes
    ----------
    name
        Its name as a body.
    point
        Its outer end.
    turn
        The direction from there to the barrel, in the axes of the link.
    """

    name: str
    point: str
    turn: complex


@dataclass(frozen=True, slots=True)
class Linkage:
    """A mechanism for the solver and for the polygons: loops, a driver and fixed points.

    Attributes
    ----------
    driver
        The angle that is turned or the length that is pushed.
    loops
        In the order in which they are solved and drawn.
    images
        Bars to further points of links, which are found by the lengths and turns of these bars.
    pivot
        The name of a fixed point, preferably the one about which the driver turns.
    ground
        A second fixed point: its name, distance and direction in degrees.
    fixed
        Any further fixed points: where each is, as x + iy in the user's axes.
    place
        Where the pivot is, in the user's axes.
    rods
        The names of the rods of cylinders: by the name of a link that has the length of its own
        slide, and that is the name of its barrel.  The rod of a link that is left out is called
        ``<link>_rod``.
    """

    driver: Scalar
    loops: tuple[Loop, ...]
    images: tuple[Bar, ...] = ()
    pivot: str = "A"
    ground: tuple[str, float, float] | None = None
    fixed: Mapping[str, complex] = field(default_factory=dict, hash=False)
    place: complex = 0j
    rods: Mapping[str, str] = field(default_factory=dict, hash=False)
    unknowns: tuple[tuple[Scalar, ...], ...] = field(init=False, default=())

    def __post_init__(self) -> None:
        known = {self.driver}
        found = []
        for number, loop in enumerate(self.loops, start=1):
            scalars = dict.fromkeys(scalar_of(step) for _, step in loop.steps())
            fresh = tuple(scalar for scalar in scalars if scalar not in known)
            if len(fresh) != 2:
                raise InputError(
                    f"loop {number} has {len(fresh)} unknowns "
                    f"({', '.join(map(str, fresh)) or 'none'}), not two",
                    hint="each loop leaves exactly two angles or lengths to be found",
                )
            known.update(fresh)
            found.append(fresh)
        object.__setattr__(self, "unknowns", tuple(found))
        from vad.kinematics.checks import check  # it needs these classes

        check(self)

    @property
    def cylinders(self) -> dict[str, Rod]:
        """The rods of links that have the length of their own slide, by the name of the link."""
        steps = [step for loop in self.loops for _, step in loop.steps()]
        bars = [step for step in steps if isinstance(step, Bar)]
        found = {}
        for slide in steps:
            if isinstance(slide, Slide) and slide.along == slide.name:
                ends = (bar for bar in bars if (bar.length, bar.tail) == (slide.name, slide.head))
                point = next((bar.head for bar in ends), slide.head)
                name = self.rods.get(slide.name, f"{slide.name}_rod")
                found[slide.name] = Rod(name, point, -slide.turn)
        return found

    @property
    def frame(self) -> float:
        """The direction of the x axis in which it is solved, in degrees.

        It is that of the ground link.  Without a ground link, and if a slide is driven on a guide,
        it is that of another guide: then the angle between both is not a rounded difference.
        """
        if self.ground:
            return self.ground[2]
        steps = [step for loop in self.loops for _, step in loop.steps()]
        guides = [s for s in steps if isinstance(s, Slide) and isinstance(s.along, float)]
        others = [as_float(guide.along) for guide in guides if length_of(guide.name) != self.driver]
        return others[0] if len(others) < len(guides) and others else 0.0


def crossing(
    loop: Loop, unknowns: tuple[Scalar, ...], driver: Scalar
) -> Iterator[tuple[tuple[str, float], ...]]:
    """Yield the names and directions of each two guides of a loop that must not be parallel.

    The slides on both are unknown, or one of them is driven and nothing else moves.
    """
    steps = [step for _, step in loop.steps()]
    slides = [(step.name, step.along) for step in steps if isinstance(step, Slide)]
    guides = [(name, along) for name, along in slides if isinstance(along, float)]
    alone = {scalar_of(step) for step in steps} == {driver, *unknowns}
    for pair in combinations(guides, 2):
        both = {length_of(name) for name, _ in pair}
        if both == set(unknowns) or (alone and driver in both):
            yield pair


def parallel(one: float, other: float) -> bool:
    """Tell whether two directions in degrees are parallel.

    Examples
    --------
    >>> parallel(-360.0, 180.0), parallel(0.0, 1e-20)
    (True, False)
    >>> parallel(89.99999999999999, -90.0)
    False
    """
    between = math.remainder(one, 180.0), -math.remainder(other, 180.0)
    # `math.fsum` rounds once, so that no small angle is lost beside half a turn.
    return any(abs(math.fsum((*between, k))) < _LEAST_ANGLE for k in (-180.0, 0.0, 180.0))
