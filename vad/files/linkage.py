"""From a description and its numbers to loops: the shapes of links, and a `Linkage`.

A shape says where the points of a link are in the axes of the link: the first point of its base is
at 0, the second on the positive x axis.  Every dyad is a loop of two chains that meet in its point.
A chain is the shortest way from a fixed point, without the steps that both chains begin with.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

from vad import gate
from vad.errors import InputError
from vad.files.description import (
    Apex,
    Aside,
    Beyond,
    Cartesian,
    Description,
    Expression,
    FrameLine,
    GuideEntry,
    LinkEntry,
    LinkLine,
    Polar,
    SliderLine,
    Values,
)
from vad.files.structure import Dyad
from vad.files.tables import Source
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, Step, angle_of, length_of
from vad.kinematics.numbers import bearing, direction, fold, sqrt, vector

Steps = tuple[Step, ...]
#: Names of the points of links under their blocks, unless the file uses them.
UNDER = "QUVWXYZ"
#: Names of the inner ends of driven cylinders, which appear in no result.
STROKES = "STPRNML"


def names_under(description: Description) -> dict[str, str]:
    """Return the names of the points of links under their blocks, by the name of the slide."""
    given = {guide.slide: guide.under for guide in description.guides.values() if guide.under}
    names = _free(UNDER, (*description.points, *given.values()))
    passive = [
        link.name
        for link in description.links.values()
        if link.cylinder and link.name != description.driver.name
    ]
    slots = [g.slide for g in description.guides.values() if isinstance(g.line, LinkLine)]
    return {slide: given.get(slide) or next(names) for slide in (*passive, *slots)}


def _free(letters: str, taken: Sequence[str]) -> Iterator[str]:
    """Yield names that no point has: letters first, then letters with a number."""
    numbers = ("", *map(str, range(1, 1 + len(taken))))
    return (
        letter + number for number in numbers for letter in letters if letter + number not in taken
    )


def linkage_of(
    description: Description,
    dyads: Sequence[Dyad],
    values: Values,
    sides: Mapping[str, float],
    parallel: frozenset[str] = frozenset(),
) -> Linkage:
    """Return the loops of a mechanism, one for each dyad.

    Parameters
    ----------
    description, dyads
        The mechanism, and its dyads or the first of them.
    values
        Its parameters, in its unit of length and in degrees.
    sides
        The side of each dyad, +1.0 or -1.0, by its point; +1.0 if left out.
    parallel
        The points of dyads that are parallelograms and stay so.

    Raises
    ------
    vad.errors.InputError
        For numbers of which no link can be made.
    """
    return _Linking(description, values).linkage(dyads, sides, parallel)


class _Linking:
    """The chains of steps that lead to the points that are known so far."""

    def __init__(self, description: Description, values: Values) -> None:
        self.description = description
        self.values = values
        self.fixed = fixed_points(description, values)
        self.shapes = {
            link.name: places_on(link, description, values) for link in description.links.values()
        }
        self.under = names_under(description)
        self.chains: dict[str, Steps] = dict.fromkeys(self.fixed, ())
        self.pivot = self._pivot()
        driver = description.driver
        link = description.links.get(driver.name)
        if link and driver.kind == "angle" and self._held(link):
            self._learn(link)
        for guide in description.guides.values():
            if guide.slide == driver.name and isinstance(guide.line, FrameLine):
                self.chains[guide.point] = (self._slide(guide),)

    def linkage(
        self, dyads: Sequence[Dyad], sides: Mapping[str, float], parallel: frozenset[str]
    ) -> Linkage:
        """Return the loops of dyads, with bars to the points that no loop reaches."""
        driver = self.description.driver
        loops = []
        for dyad in dyads:
            first, second = _without_beginning(*self._chains_of(dyad))
            side = sides.get(dyad.point, 1.0) if dyad.reversible else 1.0
            loops.append(Loop(first, second, side, dyad.point in parallel))
            for link in dyad.links:
                self._learn(link)
        ground = self._ground()
        here = {self.pivot, ground[0]} if ground else {self.pivot}
        return Linkage(
            angle_of(driver.name) if driver.kind == "angle" else length_of(driver.name),
            tuple(loops),
            images=tuple(self._images(loops)),
            pivot=self.pivot,
            ground=ground,
            fixed={point: self.fixed[point] for point in self.fixed if point not in here},
            place=self.fixed[self.pivot],
            rods={each.name: each.rod for each in self.description.links.values() if each.rod},
        )

    def _pivot(self) -> str:
        """Return the fixed point of the driven link, or else the first."""
        link = self.description.links.get(self.description.driver.name)
        here = [point for point in link.points if point in self.fixed] if link else []
        return here[0] if here else next(iter(self.fixed))

    def _ground(self) -> tuple[str, float, float] | None:
        """Return the fixed point that is given by its distance and direction from the pivot."""
        for point, place in self.description.fixed.items():
            if isinstance(place, Polar) and place.start == self.pivot:
                return point, place.length(self.values), place.angle(self.values)
        return None

    def _held(self, link: LinkEntry) -> str | None:
        """Return the known point of a link to which the shortest chain leads."""
        known = [point for point in link.points if point in self.chains]
        return min(known, key=lambda point: len(self.chains[point]), default=None)

    def _learn(self, link: LinkEntry) -> None:
        """Add the chains to the points of a link that is located."""
        held = self._held(link)
        if held is None or link.cylinder:
            return
        for point in link.points:
            if point not in self.chains or len(self.chains[held]) + 1 < len(self.chains[point]):
                self.chains[point] = (*self.chains[held], self._bar(link, held, point))

    def _bar(self, link: LinkEntry, tail: str, head: str) -> Bar:
        """Return the vector from one point of a link to another."""
        vector = self.shapes[link.name][head] - self.shapes[link.name][tail]
        size = _apart(vector, link.name, tail, head)
        return Bar(tail + head, link.name, size, turn=vector / size)

    def _slide(self, guide: GuideEntry, tail: str | None = None) -> Slide:
        """Return the slide along a line that does not turn; it begins at ``tail`` if given."""
        line, point, values = guide.line, guide.point, self.values
        if isinstance(line, SliderLine):
            return Slide(line.through + point, guide.slide, fold(line.angle(values)))
        assert isinstance(line, FrameLine)
        if isinstance(line.way, str):
            along = self.fixed[line.way] - self.fixed[str(line.through)]
            _apart(along, point, str(line.through), line.way)
            angle = bearing(along)
        else:
            angle = fold(line.way(values))
        if isinstance(line.through, Cartesian):
            tail = tail or self.pivot
            zero = vector(line.through.x(values), line.through.y(values))
        else:
            tail, zero = tail or line.through, self.fixed[line.through]
        aside = line.offset(values) if line.offset else 0.0
        through_tail = tail == line.through and aside == 0.0
        origin = zero + aside * 1j * direction(fold(angle))
        return Slide(tail + point, guide.slide, angle, origin, through_tail=through_tail)

    def _slot(self, guide: GuideEntry, held: str | None = None) -> tuple[Bar, Slide]:
        """Return the bar of a slotted link to the point under its block, and the slide on it.

        The bar begins where the slide counts from, or at ``held``.
        """
        line = guide.line
        assert isinstance(line, LinkLine)
        at = self.shapes[line.link]
        zero, along = at[line.pair[0]], at[line.pair[1]] - at[line.pair[0]]
        turn = along / _apart(along, line.link, *line.pair)
        start = held or line.pair[0]
        offset = (zero - at[start]) * turn.conjugate()
        if line.offset:
            offset += line.offset(self.values) * 1j
        under = self.under[guide.slide]
        bar = Bar(start + under, line.link, guide.slide, turn=turn, offset=offset)
        return bar, Slide(under + guide.point, guide.slide, line.link, turn=turn)

    def _chains_of(self, dyad: Dyad) -> tuple[Steps, Steps]:
        """Return the two chains of a dyad, each from a fixed point."""
        guides, links = dyad.guides, dyad.links
        if dyad.kind == "RRR":
            first, second = (self._arm(link, dyad.point) for link in links)
            return first, second
        if dyad.kind == "RRP":
            (link,), (guide,) = links, guides
            arm = self._arm(link, dyad.point)
            if isinstance(guide.line, LinkLine):
                bar, slide = self._slot(guide)
                return arm, (*self.chains[bar.tail], bar, slide)
            slide = self._slide(guide)
            self.chains[dyad.point] = (*self.chains[slide.tail], slide)
            return arm, self.chains[dyad.point]
        if dyad.kind == "RPR":
            return self._slotted(links[0], guides[0] if guides else None)
        if dyad.kind == "PRP":
            # Both chains begin at the first point that slides, and the polygon with it.
            one, other = (self._slide(guide, self.pivot) for guide in guides)
            self.chains |= {one.head: (one,), other.head: (other,)}
            return (-one,), (self._bar(links[0], one.head, other.head), -other)
        carrier, block = (self._slide(guide) for guide in guides)
        self.chains[dyad.point] = (*self.chains[carrier.tail], carrier)
        return (*self.chains[guides[1].point], -block), self.chains[dyad.point]

    def _arm(self, link: LinkEntry, point: str) -> Steps:
        """Return the chain over an unknown link to the point in which it meets another."""
        held = self._held(link)
        assert held is not None
        if link.cylinder:
            tail, head = link.base
            turn = 1.0 + 0j
            if held == head:
                tail, head, turn = head, tail, -turn
            end = next(_free(STROKES, (*self.description.points, *self.under.values())))
            stroke = Slide(tail + end, link.name, along=link.name, turn=turn)
            return (*self.chains[held], stroke, Bar(end + head, link.name, link.name, turn=turn))
        return (*self.chains[held], self._bar(link, held, point))

    def _slotted(self, link: LinkEntry, guide: GuideEntry | None) -> tuple[Steps, Steps]:
        """Return the chains of a link that is found by the pin in its slot, or of a cylinder."""
        if guide is None:
            tail, pin = link.base
            under = self.under[link.name]
            bar = Bar(tail + under, link.name, link.name)
            slide = Slide(under + pin, link.name, along=link.name)
        else:
            pin = guide.point
            bar, slide = self._slot(guide, self._held(link))
        to_pin, to_slot = (*self.chains[pin], -slide), (*self.chains[bar.tail], bar)
        return (to_pin, to_slot) if pin not in self.fixed else (to_slot, to_pin)

    def _images(self, loops: Sequence[Loop]) -> Iterator[Bar]:
        """Yield bars to the points of links that no loop reaches."""
        steps = [step for loop in loops for _, step in loop.steps()]
        bars = [step for step in steps if isinstance(step, Bar)]
        reached = {point for step in steps for point in (step.tail, step.head)} | set(self.fixed)
        for link in self.description.links.values():
            ends = [p for bar in bars if bar.link == link.name for p in (bar.tail, bar.head)]
            starts = [point for point in ends if point in link.points]
            if not starts or link.cylinder:
                continue
            for point in link.points:
                if point not in reached:
                    reached.add(point)
                    yield self._bar(link, starts[0], point)


def _apart(vector: complex, name: str, tail: str, head: str) -> float:
    """Return the distance of two points; refuse points that are nearer than any two may be."""
    size = abs(vector)
    if size < gate.SHORTEST:
        raise InputError(f"{name}: {tail} and {head} are at the same place")
    return size


def _without_beginning(first: Steps, second: Steps) -> tuple[Steps, Steps]:
    """Return two chains without the steps that both begin with."""
    # Each round drops a step; the chains differ at their ends.
    while first[0] == second[0]:
        first, second = first[1:], second[1:]
    return first, second


def check_numbers(source: Source, description: Description, values: Values) -> None:
    """Check with the numbers of the file that every place and every shape exists.

    Raises
    ------
    vad.errors.InputError
        With its line, for an expression without a value, or a triangle that does not close.
    """
    found: list[tuple[str, str, Callable[[], object]]] = [
        (table, key, partial(_evaluated, thing, values))
        for table, things in (("fixed", description.fixed), ("pose", description.pose))
        for key, thing in things.items()
    ]
    found += [
        ("guides", key, partial(_evaluated, guide.line, values))
        for key, guide in description.guides.items()
    ]
    found += [
        ("links", name, partial(places_on, link, description, values))
        for name, link in description.links.items()
    ]
    for table, key, find in found:
        try:
            find()
        except InputError as error:
            name = "" if str(error).startswith(f"{key}: ") else f"{key}: "
            raise source.error(table, key, f"{name}{error}", error.hint) from None


def _evaluated(thing: object, values: Values) -> None:
    """Evaluate all expressions of a place or a line."""
    for part in vars(thing).values():
        if isinstance(part, Expression):
            part(values)
        elif isinstance(part, Cartesian):
            _evaluated(part, values)


def fixed_points(description: Description, values: Values) -> dict[str, complex]:
    """Return the places of the fixed points."""
    places: dict[str, complex] = {}
    for point, place in description.fixed.items():
        if isinstance(place, Polar):
            turn = direction(fold(place.angle(values)))
            places[point] = places[place.start] + place.length(values) * turn
        else:
            places[point] = vector(place.x(values), place.y(values))
    return places


def posed_points(description: Description, values: Values) -> dict[str, complex]:
    """Return the places of all points that the pose gives, fixed ones with them."""
    pose = {p: vector(at.x(values), at.y(values)) for p, at in description.pose.items()}
    return pose | fixed_points(description, values)


def places_on(link: LinkEntry, description: Description, values: Values) -> dict[str, complex]:
    """Return where the points of a link are in its own axes; a cylinder has its tail alone.

    Raises
    ------
    vad.errors.InputError
        For a triangle that does not close, or points that coincide.
    """
    tail, head = link.base
    if link.cylinder:
        return {tail: 0j}
    if link.length is None:
        pose = posed_points(description, values)
        axis = pose[head] - pose[tail]
        along = axis / _apart(axis, link.name, tail, head)
        return {p: (pose[p] - pose[tail]) * along.conjugate() for p in link.points} | {
            head: vector(abs(axis), 0.0)
        }
    places = {tail: 0j, head: vector(_positive(link, link.length, values), 0.0)}
    for point, rule in link.rules.items():
        if isinstance(rule, Beyond):
            along = rule.sense * _positive(link, rule.length, values)
            places[point] = places[rule.start] + vector(along, 0.0)
        elif isinstance(rule, Aside):
            line = places[rule.other] - places[rule.start]
            turn = direction(fold(rule.sense * rule.angle(values)))
            places[point] = (
                places[rule.start]
                + _positive(link, rule.length, values)
                * (line / _apart(line, link.name, rule.start, rule.other))
                * turn
            )
        elif isinstance(rule, Apex):
            places[point] = _apex(link, point, rule, places, values)
    return places


def _positive(link: LinkEntry, length: Expression, values: Values) -> float:
    """Return a length; an expression that is not positive is refused."""
    value = length(values)
    wrong = gate.wrong_dimension(value, signed=False)
    if wrong:
        raise InputError(f"{link.name}: {length.text} {wrong}")
    return value


def _apex(
    link: LinkEntry, point: str, rule: Apex, places: dict[str, complex], values: Values
) -> complex:
    """Return the third corner of a triangle, whose height comes from Heron's formula."""
    base = places[rule.second] - places[rule.first]
    a, b, c = (
        *(_positive(link, each, values) for each in (rule.from_first, rule.from_second)),
        _apart(base, link.name, rule.first, rule.second),
    )
    factors = (a + b + c), (a + b - c), (c + a - b), (c - a + b)
    if any(factor < 0.0 for factor in factors):
        sides = " and ".join((f"{c:g}, {a:g}", f"{b:g}"))
        corners = f"{rule.first}{rule.second}{point}"
        longest = max(a, b, c)
        raise InputError(
            f"{link.name}: the triangle {corners} with sides {sides} does not close",
            hint=f"the longest side must be less than {a + b + c - longest:g}",
        )
    height = sqrt(math.prod(factors)) / (2.0 * c)
    along = ((a - b) * (a + b) + c * c) / (2.0 * c)
    corner: complex = vector(along, rule.side * height)
    return places[rule.first] + corner * (base / c)
