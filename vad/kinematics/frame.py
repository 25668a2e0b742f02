"""A linkage made ready for solving: its unit of length, its axes, and the way to each point.

Lengths are in a power of two, directions are in the frame of the ground link.  What a bar or a
slide contributes to position, velocity and acceleration is written here and nowhere else: the
solver adds the contributions up, and the polygons draw them.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, TypeGuard

from vad.kinematics.linkage import Bar, Linkage, Slide, Step, angle_of, length_of, scalar_of
from vad.kinematics.numbers import (
    Number,
    across,
    difference,
    direction,
    dot,
    fold,
    over,
    sqrt,
    times,
    turned,
    vector,
)
from vad.kinematics.state import MotionComponent, Pose, Rates
from vad.kinematics.symbol import is_symbolic

if TYPE_CHECKING:
    from vad.kinematics.refined import Refinement


class ReferenceFrame:
    """The unit and the axes in which a linkage is solved.

    Attributes
    ----------
    linkage
        The linkage.
    angle, turn
        The direction of the ground link, which is the frame's x axis, in degrees and as a unit
        vector.
    scale
        The unit of lengths: a power of two, which changes no bit of a ratio.
    steps
        All bars and slides.
    fixed
        The fixed points by name: vectors from the pivot in this unit and these axes.
    places
        The fixed points that the user gave by coordinates, in the user's unit and axes.
    guides
        The directions of the guides on which bars end, by link, in the user's axes.
    found_along
        The turn of the bar by which each link is found.  The unit vector that a pose has of the
        link points along this bar, so that nothing is turned there and back.
    """

    def __init__(self, linkage: Linkage) -> None:
        self.linkage = linkage
        self.refined: Refinement | None = None
        self.scale = _power_of_two(linkage)
        self.angle = fold(linkage.frame)
        self.turn = direction(self.angle)
        self.guides: dict[str, float] = {}
        self.found_along = _found_along(linkage)
        steps = [step for loop in linkage.loops for _, step in loop.steps()]
        self.steps: tuple[Step, ...] = (*steps, *linkage.images)
        self.places = {linkage.pivot: linkage.place, **linkage.fixed}
        guides = [
            step for step in steps if isinstance(step, Slide) and isinstance(step.along, float)
        ]
        moving = {step.head for step in steps}
        for slide in guides:
            if slide.tail not in moving and not self._is_ground(slide.tail):
                self.places.setdefault(slide.tail, slide.origin)
        self.fixed = {linkage.pivot: 0j}
        if linkage.ground:
            self.fixed[linkage.ground[0]] = vector(linkage.ground[1] / self.scale, 0.0)
        for name in self.places:
            self.fixed.setdefault(name, self.between(linkage.pivot, name))
        self._lines = {
            slide.name: direction(difference(fold(slide.along), self.angle)) for slide in guides
        }

    def _is_ground(self, name: str) -> bool:
        return self.linkage.ground is not None and self.linkage.ground[0] == name

    def _inward(self, vector: complex) -> complex:
        found: complex = times(vector / self.scale, self.turn.conjugate())
        return found

    def between(self, tail: str, head: str) -> complex:
        """Return the vector from one fixed point to another; of given points it is rounded once."""
        if tail in self.places and head in self.places:
            return self._inward(self.places[head] - self.places[tail])
        return self.fixed[head] - self.fixed[tail]

    def rest_of_distance(self, tail: str, head: str) -> float:
        """Return what a double cannot hold of the distance of two given points; else zero."""
        if not {tail, head} <= self.places.keys():
            return 0.0
        one, other = self.places[tail], self.places[head]
        if is_symbolic(one) or is_symbolic(other) or one == other:
            return 0.0
        x, y = Fraction(other.real) - Fraction(one.real), Fraction(other.imag) - Fraction(one.imag)
        distance = Fraction(abs(self.between(tail, head))) * Fraction(self.scale)
        return float((x * x + y * y - distance**2) / (2 * distance) / Fraction(self.scale))

    def shift(self, slide: Slide) -> complex:
        """Return the vector from the tail of a slide to the zero of its line."""
        tail = slide.tail
        if isinstance(slide.along, str) or tail not in self.fixed:
            return 0j
        if tail in self.places:
            return self._inward(slide.origin - self.places[tail])
        return self._inward(slide.origin - self.linkage.place) - self.fixed[tail]

    def advance(self, slide: Slide) -> float:
        """Return the position of a slide's tail along the slide's own line."""
        return -dot(self.shift(slide), self._lines[slide.name])

    def size(self, bar: Bar, pose: Pose | None = None) -> Number:
        """Return the length of a bar in the solver's unit."""
        if not isinstance(bar.length, str):
            return bar.length / self.scale
        if pose is None:
            return math.nan
        ahead, aside = self.reach(bar, pose)
        return sqrt(ahead * ahead + aside * aside) if aside else ahead

    def reach(self, bar: Bar, pose: Pose) -> tuple[Number, float]:
        """Return how far a bar that carries a slide reaches along its line, and beside it."""
        offset, slide = bar.offset / self.scale, str(bar.length)
        if offset.real and slide in pose.parts_of_length:
            part, rest = pose.parts_of_length[slide]
            return (part + offset.real) + rest, offset.imag
        return pose.length[slide] + offset.real, offset.imag

    def unit(self, link: str, pose: Pose, turn: complex = 1.0 + 0j) -> Number:
        """Return the unit vector of a link, or that vector turned by ``turn``."""
        along = self.found_along.get(link, 1.0)
        return turned(pose.unit[link], 1.0 + 0j if turn == along else turn * along.conjugate())

    def heading(self, bar: Bar, pose: Pose) -> Number:
        """Return the unit vector from the tail of a bar to its head."""
        unit = self.unit(bar.link, pose, bar.turn)
        if not bar.offset.imag:
            return unit
        return times(unit, over(vector(*self.reach(bar, pose)), self.size(bar, pose)))

    def line(self, slide: Slide, pose: Pose | None) -> Number:
        """Return the unit vector of the line of a slide."""
        if isinstance(slide.along, str):
            return self.unit(slide.along, pose, slide.turn) if pose else math.nan
        return self._lines[slide.name]

    def displacement(self, step: Step, pose: Pose) -> Number:
        """Return the vector from tail to head; that of a slide begins at the zero of its line.

        That of a slide on a turning link is zero, because the link's bar has the length.
        """
        if isinstance(step, Bar):
            if self.refined and step.link in pose.parts_of_unit:
                return self.refined.displacement(step, pose).rounded
            unit = self.unit(step.link, pose, step.turn)
            if step.offset.imag:
                return times(unit, vector(*self.reach(step, pose)))
            return self.size(step, pose) * unit
        if isinstance(step.along, str):
            return 0.0
        return pose.length[step.name] * self._lines[step.name]

    def unknown_direction(self, step: Step, pose: Pose) -> Number:
        """Return the direction of an unknown component: across a bar, or along a slide."""
        return across(self.heading(step, pose)) if isinstance(step, Bar) else self.line(step, pose)

    def motion(
        self, steps: Iterable[tuple[int, Step]], pose: Pose, rates: tuple[Rates, ...]
    ) -> Number:
        """Return the sum of the known components of the motion of ``steps``, each with its sign."""
        total: Number = 0j
        for way, step in steps:
            if isinstance(step, Bar) and step.link in pose.parts_of_unit:
                vector, last = self.displacement(step, pose), rates[-1].turning.get(step.link)
                if len(rates) > 1:
                    omega = rates[0].turning[step.link]
                    total = total - (way * (omega * omega)) * vector
                if last is not None:
                    total = total + (way * last) * across(vector)
                continue
            for _, along, amount in self.components(step, pose, rates):
                if amount is not None:
                    total = total + (way * amount) * along
        return total

    def components(
        self, step: Step, pose: Pose, rates: tuple[Rates, ...]
    ) -> Iterator[MotionComponent]:
        """Yield the components of the velocity (one order in ``rates``) or acceleration (two).

        With u the unit vector and r the length, the derivatives of r·u are
        ṙ·u + ωr·iu and r̈·u - ω²r·u + αr·iu + 2ωṙ·iu.
        """
        last = rates[-1]
        if isinstance(step, Bar):
            unit, size = self.heading(step, pose), self.size(step, pose)
            if len(rates) > 1:
                omega = rates[0].turning[step.link]
                yield MotionComponent("normal", -unit, omega * omega * size)
            rate = last.turning.get(step.link)
            yield MotionComponent("tangential", across(unit), None if rate is None else rate * size)
            return
        line = self.line(step, pose)
        if len(rates) > 1 and isinstance(step.along, str):
            twist = 2.0 * rates[0].turning[step.along] * rates[0].sliding[step.name]
            yield MotionComponent("coriolis", across(line), twist)
        yield MotionComponent("sliding", line, last.sliding.get(step.name))


def _found_along(linkage: Linkage) -> dict[str, complex]:
    pairs = zip(linkage.loops, linkage.unknowns, strict=True)
    return {
        step.link: -step.turn if step.against else step.turn
        for loop, unknowns in pairs
        for _, step in loop.steps()
        if isinstance(step, Bar) and scalar_of(step) in unknowns
    }


def _power_of_two(linkage: Linkage) -> float:
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    sizes = [step.length for step in (*steps, *linkage.images) if isinstance(step, Bar)]
    sizes += [linkage.ground[1]] if linkage.ground else []
    sizes += [abs(point - linkage.place) for point in linkage.fixed.values()]
    # It only has to be near them, so that the same unit serves a traced length.
    largest = max((abs(float(size)) for size in sizes if isinstance(size, float)), default=1.0)
    return 2.0 ** math.frexp(largest)[1]


Hop = tuple[int, Step]
Route = tuple[str, tuple[Hop, ...]]
# What it costs to begin at a fixed point, and to take a step.
Costs = tuple[dict[str, float], Callable[[Step], float]]


class Routes:
    """The best route from a fixed point to each point, and the motion summed along it.

    Attributes
    ----------
    letters
        The points that can be reached.
    """

    def __init__(self, frame: ReferenceFrame) -> None:
        self._frame = frame
        self._places = _shortest(frame, *_place_costs(frame))
        self._motions = _shortest(frame, *_motion_costs(frame))
        self.letters = frozenset(self._places)
        self._strut = next((step for step in frame.steps if self._is_strut(step)), None)
        if self._strut:
            _, cost = _place_costs(frame, strut=0.0)
            self._over_strut = _shortest(frame, dict.fromkeys(frame.fixed, 0.0), cost)
            hops = self._places[self._strut.head][1]
            lengths = (step.length for _, step in hops if isinstance(step, Bar))
            sizes = (abs(length) / frame.scale for length in lengths if isinstance(length, float))
            self._longest_strut = sum(sizes)

    def _is_strut(self, step: Step) -> TypeGuard[Bar]:
        driver = self._frame.linkage.driver
        return isinstance(step, Bar) and length_of(str(step.length)) == driver

    def guide(self, letter: str) -> Slide | None:
        """Return the guide of a point to which this guide alone leads, else None."""
        hops = self._places[letter][1]
        step = hops[0][1] if len(hops) == 1 else None
        return step if isinstance(step, Slide) and isinstance(step.along, float) else None

    def pin(self, letter: str) -> Bar | None:
        """Return the bar of the driven crank at whose head a point always is, else None."""
        start, hops = self._places[letter]
        way, crank = hops[0] if hops else (0, None)
        if not isinstance(crank, Bar) or angle_of(crank.link) != self._frame.linkage.driver:
            return None
        blocks = all(isinstance(s, Slide) and isinstance(s.along, str) for _, s in hops[1:])
        forward = isinstance(crank.length, float) and way == 1
        return crank if start in self._frame.places and forward and blocks else None

    def route(self, letter: str) -> Route:
        """Return the route to a point: the fixed point at which it begins, and its steps."""
        return self._places[letter]

    def over_strut(self, letter: str, pose: Pose) -> tuple[Route, Number] | None:
        """Return the route over the driven strut, and whether it is the shorter one in a pose.

        None if there is no strut, or if it does not matter for this point.
        """
        if not self._strut or self._over_strut[letter] == self._places[letter]:
            return None
        size = self._frame.size(self._strut, pose)
        shorter = (size > 0.0) & (size < self._longest_strut)  # at length 0 it has no direction
        return self._over_strut[letter], shorter

    def along(self, route: Route, pose: Pose) -> Number:
        """Return the vector along a route, in the solver's unit and frame."""
        total: Number = 0j
        for way, step in route[1]:
            if isinstance(step, Slide):
                total = total + way * self._frame.shift(step)
            total = total + way * self._frame.displacement(step, pose)
        return total

    def rate(self, letter: str, pose: Pose, rates: tuple[Rates, ...]) -> Number:
        """Return the velocity (one order in ``rates``) or acceleration (two) of a point."""
        return self._frame.motion(self._motions[letter][1], pose, rates)


def _place_costs(frame: ReferenceFrame, strut: float = 3.0) -> Costs:
    """Let a route cost its length: a short one rounds least; say what a variable length costs.

    Every route is right, so that costs are floats.
    """

    def cost(step: Step) -> float:
        if isinstance(step, Slide):
            return min(1.0, strut) if isinstance(step.along, str) else 1e-9
        # The point of a lever under its block is where the pin is, and better found by the pin.
        return strut if isinstance(step.length, str) else abs(float(frame.size(step)))

    return {letter: float(abs(place)) for letter, place in frame.fixed.items()}, cost


def _motion_costs(frame: ReferenceFrame) -> Costs:
    """Let a route cost the number of its steps; a guide of the frame rounds least."""

    def cost(step: Step) -> float:
        return 0.5 if isinstance(step, Slide) and isinstance(step.along, float) else 1.0

    return dict.fromkeys(frame.fixed, 0.0), cost


def _shortest(
    frame: ReferenceFrame, start: dict[str, float], cost: Callable[[Step], float]
) -> dict[str, Route]:
    """Return the best route to each point; ``start`` is the cost of beginning at a fixed point.

    The best route uses what early loops find, because a later loop may be near a dead centre.  Of
    such routes the best is the guide of the point itself, then the cheapest one.
    """
    found = {
        # Where two lines cross, each of the two lengths has an error of its own.
        scalar: number + all(each.kind == "length" for each in pair)
        for number, pair in enumerate(frame.linkage.unknowns)
        for scalar in pair
    }
    leading: dict[str, list[tuple[int, Hop, str]]] = {}
    for number, step in enumerate(frame.steps):
        leading.setdefault(step.tail, []).append((2 * number, (1, step), step.head))
        leading.setdefault(step.head, []).append((2 * number + 1, (-1, step), step.tail))
    routes: dict[str, Route] = {letter: (letter, ()) for letter in frame.fixed}
    costs = {letter: (0, start[letter]) for letter in frame.fixed}
    waiting: list[tuple[tuple[int, float], int, tuple[int, float], Hop, str, str]] = []

    def look(tail: str) -> None:
        """Let the steps that lead from a point wait for their turn."""
        rank, so_far = costs[tail]
        for number, (way, step), head in leading.get(tail, ()):
            if head not in routes:
                total = max(rank, found.get(scalar_of(step), 0)), so_far + cost(step)
                guide = tail in frame.fixed and isinstance(step, Slide)
                key = (total[0], 0.0) if guide else total
                heapq.heappush(waiting, (key, number, total, (way, step), tail, head))

    for letter in frame.fixed:
        look(letter)
    while waiting:  # each step waits twice at most, once from each of its ends
        _, _, total, hop, tail, head = heapq.heappop(waiting)
        if head not in routes:
            begin, hops = routes[tail]
            routes[head], costs[head] = (begin, (*hops, hop)), total
            look(head)
    return routes
