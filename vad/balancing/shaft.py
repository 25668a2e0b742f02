"""The masses of a shaft that turn with it, and those that balance them.

A mass m at the radius r pulls the shaft outwards with m·r·ω², and bends it about a plane at the
distance l with m·r·l·ω².  A shaft is balanced where the vectors m·r, and the vectors m·r·l about
any one plane, close two polygons.  Two numbers of the masses may be unknown in one plane, four in
several: they are found from the couples about the plane of an unknown mass, then from the forces.

Sources: R. S. Khurmi and J. K. Gupta, Theory of Machines, chapter 21; S. S. Rattan, Theory of
Machines, chapter 14.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import NamedTuple

from vad.balancing.closing import NOTHING, Side, along, closed, unit
from vad.errors import InputError, UsageError
from vad.kinematics.numbers import degrees_of, ray

#: The numbers of a mass in the order in which they are named.
NUMBERS = ("mass", "radius", "angle", "plane")


@dataclass(frozen=True, slots=True)
class Mass:
    """A mass on a shaft; a number that is None is unknown.

    Attributes
    ----------
    name
        Its name, as that of a point: A, B2.
    mass
        In kg; negative for material that is to be taken away.
    radius
        The distance of its centre from the axis.
    angle
        In degrees, counter-clockwise, from the line of reference of the shaft.
    plane
        Where it is along the shaft.
    """

    name: str
    mass: float | None = None
    radius: float | None = None
    angle: float | None = None
    plane: float | None = None

    @property
    def size(self) -> float | None:
        """The product m·r; None where a factor is unknown."""
        return None if self.mass is None or self.radius is None else self.mass * self.radius

    @property
    def way(self) -> complex | None:
        """Its direction as a unit vector; None where its angle is unknown."""
        way: complex | None = None if self.angle is None else ray(self.angle)
        return way

    @property
    def vector(self) -> complex:
        """The vector m·r of a mass that is known."""
        size, way = self.size, self.way
        assert size is not None and way is not None
        return size * way

    def arm(self, reference: float) -> float | None:
        """Return the distance of its plane from a plane of reference; None if it is unknown."""
        return None if self.plane is None else self.plane - reference

    def numbers(self) -> dict[str, float]:
        """Return those of its numbers that are known, by name."""
        known = ((name, getattr(self, name)) for name in NUMBERS)
        return {name: value for name, value in known if value is not None}


class Laid(NamedTuple):
    """A vector of a polygon: whose it is, its value, and what the polygon finds of it.

    ``unknowns`` are "size", "way", both or none, in this order.
    """

    name: str
    vector: complex
    unknowns: tuple[str, ...]


class Polygon(NamedTuple):
    """A polygon of couples or of forces, in the order in which it is drawn.

    ``reference`` is the name of the mass about whose plane the couples are, empty for forces.
    ``other`` holds the vectors of the sides that close it in the other way, where there is one.
    """

    vectors: tuple[Laid, ...]
    reference: str = ""
    other: tuple[complex, ...] = ()

    @property
    def known(self) -> list[Laid]:
        """The vectors that are known before."""
        return [each for each in self.vectors if not each.unknowns]

    @property
    def found(self) -> list[Laid]:
        """The vectors of which something is found."""
        return [each for each in self.vectors if each.unknowns]

    @property
    def rest(self) -> complex:
        """The sum of all vectors: what is left unbalanced; zero if it is only rounding."""
        total = sum((each.vector for each in self.vectors), 0j)
        longest = max((abs(each.vector) for each in self.vectors), default=0.0)
        return 0j if abs(total) <= NOTHING * longest else total


@dataclass(frozen=True, slots=True)
class Balanced:
    """An answer: all masses, and the polygons by which they were found.

    ``couple`` is None for masses in one plane.
    """

    masses: tuple[Mass, ...]
    couple: Polygon | None
    force: Polygon

    @property
    def rests(self) -> bool:
        """Whether no force and no couple is left."""
        return not self.force.rest and not (self.couple and self.couple.rest)


def balanced(masses: Sequence[Mass], length_unit: str, alone: bool = False) -> list[Balanced]:
    """Return the answers that balance a shaft: one, or those that mirror each other.

    Parameters
    ----------
    masses
        In the order in which they are drawn.
    length_unit
        For errors.
    alone
        Whether masses of which nothing is unknown are taken as they are, balanced or not.

    Raises
    ------
    vad.errors.InputError
        Where not exactly two numbers are unknown in one plane, or four in several; where the
        couples leave more than two of them; where lines are parallel or sides do not reach.

    Examples
    --------
    >>> one, = balanced([Mass("A", 2, 30, 0), Mass("X", radius=40)], "mm")
    >>> one.masses[1].mass, one.masses[1].angle
    (1.5, 180.0)
    """
    unit = f"kg·{length_unit}"
    planes = {each.plane for each in masses}
    whole = [each for each in masses if None not in (each.mass, each.radius, each.angle)]
    unknown = unknowns(masses)
    if len(planes) == 1:
        if unknown or not alone:
            _check_count(unknown, 2, masses, length_unit)
        return list(_in_one_plane(masses, unit)) if unknown else [_as_they_are(masses)]
    if not unknown and (alone or _as_they_are(masses).rests) and len(whole) == len(masses):
        return [_as_they_are(masses)]
    _check_count(unknown, 4, masses, length_unit)
    reference = _reference(masses, unknown, length_unit)
    return list(_in_several(masses, reference, unit))


def unknowns(masses: Sequence[Mass]) -> list[tuple[str, str]]:
    """Return what is unknown, as names of masses and of their numbers."""
    several = any(each.plane is not None for each in masses)
    names = NUMBERS if several else NUMBERS[:3]
    return [(each.name, what) for each in masses for what in names if getattr(each, what) is None]


def in_words(unknown: Sequence[tuple[str, str]]) -> str:
    """Say what is unknown: "X's mass, X's angle"."""
    return ", ".join(f"{name}'s {what}" for name, what in unknown)


def _check_count(
    unknown: Sequence[tuple[str, str]], wanted: int, masses: Sequence[Mass], length_unit: str
) -> None:
    """Refuse masses of which too much or too little is unknown."""
    both = [each.name for each in masses if each.mass is None and each.radius is None]
    if both:
        raise InputError(
            f"{both[0]}: mass and radius are both left out, and only their product can be found",
            f"give its radius, as in {both[0]} = {{ radius = 100 }}",
        )
    count = len(unknown)
    if count == wanted:
        return
    if not count and _as_they_are(masses).rests:
        return
    listed = f" ({in_words(unknown)})" if unknown else ""
    hint = {
        2: "in one plane leave out two numbers, such as the mass and the angle of X",
        4: "in several planes leave out four numbers, such as mass and angle of X and of Y",
    }[wanted]
    if not count:
        hint += "; or give bearings and a speed for the forces on them"
    elif wanted == 2 and count == 4:
        hint = "say in which planes they are, as in plane = 300"
    elif wanted == 4 and count == 2:
        hint = "leave out all planes to balance the forces alone"
    raise InputError(
        f"{count} {'unknown' if count == 1 else 'unknowns'}{listed}, not {wanted}", hint
    )


def _as_they_are(masses: Sequence[Mass]) -> Balanced:
    """Return masses of which all is known with their polygons, balanced or not."""
    force = Polygon(tuple(Laid(each.name, each.vector, ()) for each in masses))
    if len({each.plane for each in masses}) == 1 or any(each.plane is None for each in masses):
        return Balanced(tuple(masses), None, force)
    first = masses[0]
    assert first.plane is not None
    laid = (
        Laid(each.name, each.vector * (each.arm(first.plane) or 0.0), ())
        for each in masses
        if each.plane != first.plane
    )
    return Balanced(tuple(masses), Polygon(tuple(laid), first.name), force)


def _in_one_plane(masses: Sequence[Mass], unit: str) -> Iterator[Balanced]:
    """Yield the answers for masses in one plane: the forces alone."""
    sides = [Side(each.name, each.size, each.way) for each in masses]
    for force, found in _polygons(sides, unit):
        yield Balanced(
            tuple(_with(each, found[each.name]) if each.name in found else each for each in masses),
            None,
            force,
        )


def _polygons(
    sides: Sequence[Side], unit: str, reference: str = ""
) -> Iterator[tuple[Polygon, dict[str, complex]]]:
    """Yield a closed polygon for each answer, and the vectors that are found."""
    known = [each for each in sides if not each.unknowns]
    open_sides = [each for each in sides if each.unknowns]
    laid = [Laid(each.name, each.size * each.way, ()) for each in known]  # type: ignore[operator]
    total = sum((each.vector for each in laid), 0j)
    answers = closed(total, open_sides, unit) if open_sides else [()]
    for number, answer in enumerate(answers):
        ends = [
            Laid(side.name, vector, _what(side))
            for side, vector in zip(open_sides, answer, strict=True)
        ]
        other = answers[1 - number] if len(answers) == 2 else ()
        found = {each.name: each.vector for each in ends}
        yield Polygon((*laid, *ends), reference, other), found


def _what(side: Side) -> tuple[str, ...]:
    return tuple(name for name, value in (("size", side.size), ("way", side.way)) if value is None)


def _with(mass: Mass, vector: complex, plane: float | None = None) -> Mass:
    """Return a mass that was found from its vector m·r."""
    size = abs(vector)
    if mass.angle is None:
        mass = replace(mass, angle=degrees_of(vector) + 0.0)
    else:
        way = mass.way
        assert way is not None
        size = along(vector, way)
    if mass.mass is None:
        assert mass.radius is not None
        mass = replace(mass, mass=size / mass.radius + 0.0)
    elif mass.radius is None:
        mass = replace(mass, radius=size / mass.mass + 0.0)
    return mass if plane is None else replace(mass, plane=plane)


# --- several planes -------------------------------------------------------------------------------


def _reference(
    masses: Sequence[Mass], unknown: Sequence[tuple[str, str]], length_unit: str
) -> Mass:
    """Return the mass about whose plane the couples leave two unknowns.

    Raises
    ------
    vad.errors.InputError
        If there is none.
    """
    loose = list(dict.fromkeys(name for name, _ in unknown))
    tried = []
    for mass in sorted(masses, key=lambda each: each.name not in loose):
        if mass.plane is None:
            continue
        left = [each for side in _couples(masses, mass.plane) for each in _named(side)]
        if len(left) == 2:
            return mass
        tried.append((mass, left))
    same = [each for each in masses if each.name in loose]
    if len(same) == 2 and same[0].plane == same[1].plane:
        one, other = same
        raise InputError(
            f"{one.name} and {other.name} are in one plane, at {one.plane:g} {length_unit}: no "
            "couple can be balanced there",
            f"give {other.name} another plane",
        )
    mass, left = tried[0]
    raise InputError(
        f"the couples about the plane of {mass.name} leave {len(left)} unknowns "
        f"({in_words(left) or 'none'}), not 2",
        "leave out two numbers of one mass, such as its mass and its angle",
    )


def _named(side: Side) -> list[tuple[str, str]]:
    words = {"size": "couple", "way": "angle"}
    return [(side.name, words[what]) for what in _what(side)]


def _couples(masses: Sequence[Mass], reference: float) -> list[Side]:
    """Return the sides of the polygon of couples about a plane, without those in the plane."""
    sides = []
    for each in masses:
        arm = each.arm(reference)
        if arm == 0.0:
            continue
        size = None if each.size is None or arm is None else each.size * arm
        sides.append(Side(each.name, size, each.way))
    return sides


def _in_several(masses: Sequence[Mass], reference: Mass, unit_of_size: str) -> Iterator[Balanced]:
    """Yield the answers for masses in several planes: the couples first, then the forces."""
    level = reference.plane
    assert level is not None
    couples = _couples(masses, level)
    square = f"{unit_of_size}²"
    for couple, found in _polygons(couples, square, reference.name):
        for sides in _forces(masses, found, level):
            for force, vectors in _polygons(sides, unit_of_size):
                known = {each.name: each.vector for each in force.vectors} | vectors
                yield Balanced(
                    tuple(_found(each, known, found, level) for each in masses), couple, force
                )


def _forces(
    masses: Sequence[Mass], couples: Mapping[str, complex], level: float
) -> Iterator[list[Side]]:
    """Yield the sides of the polygon of forces after the couples are known.

    What the couples have found comes after what was known before.  A mass of known m·r whose plane
    and angle were found from one couple may stand at either side of the plane: both are yielded.
    """
    either: list[str] = []
    sides: dict[str, list[Side]] = {}
    for each in masses:
        couple, arm, way, size = couples.get(each.name), each.arm(level), each.way, each.size
        if couple is None:
            sides[each.name] = [Side(each.name, size, way)]
        elif arm is not None:
            vector = couple / arm
            sides[each.name] = [Side(each.name, abs(vector), unit(vector) if vector else 1 + 0j)]
        else:
            if way is None:
                if abs(couple) == 0.0:
                    raise InputError(
                        f"{each.name}: the couples of the other masses are balanced, so that its "
                        "angle is not determined",
                        f"give its angle, as in {each.name} = {{ angle = 0 }}",
                    )
                way = unit(couple)
                if size is not None:
                    either.append(each.name)
            sides[each.name] = [Side(each.name, size, way)]
    order = [each.name for each in masses if each.name not in couples]
    order += [each.name for each in masses if each.name in couples]
    known = [name for name in order if not sides[name][0].unknowns]
    rest = [name for name in order if sides[name][0].unknowns]
    first = [sides[name][0] for name in (*known, *rest)]
    yield first
    for name in either:
        yield [
            side._replace(way=-side.way) if side.name == name and side.way else side
            for side in first
        ]


def _found(
    mass: Mass, forces: Mapping[str, complex], couples: Mapping[str, complex], level: float
) -> Mass:
    """Return a mass with all its numbers, from its vectors in both polygons."""
    vector = forces[mass.name]
    if mass.name in couples and mass.plane is None:
        if not vector:
            raise UsageError(f"{mass.name}: its mass comes out as zero, so that it has no plane")
        arm = along(couples[mass.name], unit(vector)) / abs(vector)
        return _with(mass, vector, level + arm)
    return _with(mass, vector) if None in (mass.mass, mass.radius, mass.angle) else mass


def masses_of(given: Mapping[str, Mapping[str, float]]) -> list[Mass]:
    """Return masses from numbers by name."""
    return [Mass(name, **numbers) for name, numbers in given.items()]


def answer(answers: Sequence[Balanced], choice: int) -> Balanced:
    """Return one of the answers.

    Raises
    ------
    vad.errors.UsageError
        If there are not so many.
    """
    found = next(islice(answers, choice, None), None)
    if found is None:
        count = "one answer" if len(answers) == 1 else f"{len(answers)} answers"
        raise UsageError(f"choice: there is no answer {choice}: {count}, from 0 on", "try choice 0")
    return found
