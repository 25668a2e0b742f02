"""The loops of mechanisms in space as equations for Newton’s method, in numbers of any precision.

A walk leads from body to body and carries the motion of each.  It knows nothing of spheres or of
polygons: a joint turns about the frame’s z and slides along it, a link leads along x and twists
about it.  Four axes close if two walks end alike, one over the crank and one over the frame; the
coupler between two balls keeps its length.  Newton’s method starts from a pose that is near, and
the rates follow from the derivatives of the same equations.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from vad.kinematics.linkage import Scalar
from vad.kinematics.space.linkages import BallJointed, CrossedShafts, FourAxes
from vad.methods.problem import FOUR_AXES, HOOKE, SLIDES, Found, Jet, SpaceProblem

Triple = tuple[Any, Any, Any]
Matrix = list[list[Any]]
#: A value with its first and second derivative in time.
Derivatives = tuple[Any, Any, Any]
_NOTHING: Triple = (0, 0, 0)


class Arithmetic(NamedTuple):
    """How numbers of some precision are made and used.

    Attributes
    ----------
    number
        Makes one of a float.
    cos, sin, pi
        Of angles in radians.
    solve
        Returns x of a system of linear equations: its columns, and what they are to add up to.
    """

    number: Callable[[Any], Any]
    cos: Callable[[Any], Any]
    sin: Callable[[Any], Any]
    pi: Any
    solve: Callable[[Matrix, list[Any]], list[Any]]


@dataclass(frozen=True)
class Walk:
    """A frame of a body and its motion.

    Attributes
    ----------
    arithmetic
        What calculates.
    x, z, origin
        The frame.
    spin, speed
        ω and α of the body; velocity and acceleration of the origin.
    """

    arithmetic: Arithmetic
    x: Triple = (1, 0, 0)
    z: Triple = (0, 0, 1)
    origin: Triple = _NOTHING
    spin: tuple[Triple, Triple] = (_NOTHING, _NOTHING)
    speed: tuple[Triple, Triple] = (_NOTHING, _NOTHING)

    @property
    def y(self) -> Triple:
        """The third axis."""
        return cross(self.z, self.x)

    def joint(self, angle: Derivatives, slide: Derivatives = (0, 0, 0)) -> Walk:
        """Turn about z and slide along it, by a value with its two derivatives."""
        moved = self._along(scaled(slide[0], self.z))
        omega, alpha = self.spin
        velocity = added(moved.speed[0], scaled(slide[1], self.z))
        acceleration = added(
            moved.speed[1],
            scaled(slide[2], self.z),
            scaled(2 * slide[1], cross(omega, self.z)),
        )
        turning = scaled(angle[1], self.z)
        spin = (
            added(omega, turning),
            added(alpha, scaled(angle[2], self.z), cross(omega, turning)),
        )
        cosine, sine = self.arithmetic.cos(angle[0]), self.arithmetic.sin(angle[0])
        x = added(scaled(cosine, self.x), scaled(sine, self.y))
        return replace(moved, x=x, spin=spin, speed=(velocity, acceleration))

    def link(self, twist: Any, length: Any = 0) -> Walk:
        """Go along x and twist about it, by degrees."""
        turn = self.arithmetic.pi * twist / 180
        cosine, sine = self.arithmetic.cos(turn), self.arithmetic.sin(turn)
        z = added(scaled(cosine, self.z), scaled(-sine, self.y))
        return replace(self._along(scaled(length, self.x)), z=z)

    def _along(self, way: Triple) -> Walk:
        """Go to another point of the same body."""
        omega, alpha = self.spin
        moving = cross(omega, way)
        return replace(
            self,
            origin=added(self.origin, way),
            speed=(
                added(self.speed[0], moving),
                added(self.speed[1], cross(alpha, way), cross(omega, moving)),
            ),
        )


def between(one: Walk, other: Walk) -> tuple[tuple[Triple, Triple], ...]:
    """Return the difference of two ends, in direction and in place, and both its derivatives.

    The first is right to the first order, and zero where the ends agree.
    """
    turned = added(cross(other.x, one.x), cross(other.y, one.y), cross(other.z, one.z))
    place = scaled(one.arithmetic.number(0.5), turned), less(one.origin, other.origin)
    rates = (
        (less(one.spin[order], other.spin[order]), less(one.speed[order], other.speed[order]))
        for order in range(2)
    )
    return place, *rates


def less(a: Triple, b: Triple) -> Triple:
    """Return the difference of two vectors."""
    return added(a, scaled(-1, b))


def cross(a: Triple, b: Triple) -> Triple:
    """Return the vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def added(*vectors: Triple) -> Triple:
    """Return the sum of vectors."""
    x, y, z = map(sum, zip(*vectors, strict=True))
    return x, y, z


def scaled(factor: Any, a: Triple) -> Triple:
    """Return a multiple of a vector."""
    return factor * a[0], factor * a[1], factor * a[2]


def dot(a: Triple, b: Triple) -> Any:
    """Return the scalar product."""
    return sum(x * y for x, y in zip(a, b, strict=True))


_MOST_STEPS = 60
#: What does not close, and its two derivatives, each as a list of numbers.
Miss = tuple[list[Any], list[Any], list[Any]]
Jets = Mapping[Scalar, Derivatives]


def solve(
    problem: SpaceProblem, arithmetic: Arithmetic, start: Mapping[Scalar, Any], least: Any
) -> Found:
    """Solve one pose.

    Parameters
    ----------
    problem
        The problem.
    arithmetic
        What calculates.
    start
        A pose that is near, with angles in radians.
    least
        A step smaller than that ends the iteration.

    Raises
    ------
    ArithmeticError
        If the iteration does not converge, or the rates do not exist.
    """
    degrees, rate, second = problem.drive
    angle = arithmetic.pi * arithmetic.number(degrees % 360) / 180
    loop = LoopInSpace(
        problem, arithmetic, (angle, arithmetic.number(rate), arithmetic.number(second))
    )
    place = {scalar: arithmetic.number(start[scalar]) for scalar in problem.unknowns}
    for _ in range(_MOST_STEPS):
        steps = loop.solved(place, loop.gap(place)[0])
        place = {scalar: place[scalar] + steps[scalar] for scalar in place}
        sizes = {scalar: max(problem.unit(scalar), abs(place[scalar])) for scalar in steps}
        if all(abs(steps[scalar]) < least * size for scalar, size in sizes.items()):
            break
    else:
        raise ArithmeticError("the iteration does not converge")
    rates = loop.solved(place, loop.gap(place)[1])
    seconds = loop.solved(place, loop.gap(place, rates)[2])
    return {
        each: Jet(
            place[each], problem.sense(each) * rates[each], problem.sense(each) * seconds[each]
        )
        for each in problem.unknowns
    }


class LoopInSpace:
    """The equations of a problem for one place of its driver."""

    def __init__(self, problem: SpaceProblem, arithmetic: Arithmetic, driver: Derivatives) -> None:
        self._unknowns = problem.unknowns
        self._arithmetic = arithmetic
        self._driver = driver
        linkage = problem.linkage
        self._equations: Callable[[Jets, Derivatives], Miss]
        if isinstance(linkage, BallJointed):
            self._equations = lambda jets, crank: _balls(arithmetic, linkage, jets, crank)
        else:
            self._equations = lambda jets, crank: _axes(arithmetic, linkage, jets, crank)

    def gap(self, place: Mapping[Scalar, Any], rates: Mapping[Scalar, Any] | None = None) -> Miss:
        """Return what does not close, with rates of the unknowns, or with none."""
        rates = rates or dict.fromkeys(place, 0)
        jets = {scalar: (place[scalar], rates[scalar], 0) for scalar in place}
        return self._equations(jets, self._driver)

    def solved(self, place: Mapping[Scalar, Any], gap: list[Any]) -> dict[Scalar, Any]:
        """Return the change of the unknowns that closes a gap, to the first order."""
        unit = ({scalar: int(scalar == one) for scalar in place} for one in self._unknowns)
        columns = [self.change(place, rates) for rates in unit]
        found = self._arithmetic.solve(columns, [-x for x in gap])
        return dict(zip(self._unknowns, found, strict=True))

    def change(self, place: Mapping[Scalar, Any], rates: Mapping[Scalar, Any]) -> list[Any]:
        """Return how fast a gap opens if the unknowns move and the driver rests."""
        jets = {scalar: (place[scalar], rates[scalar], 0) for scalar in place}
        return self._equations(jets, (self._driver[0], 0, 0))[1]


def _axes(
    arithmetic: Arithmetic,
    linkage: FourAxes | CrossedShafts,
    jets: Jets,
    crank: Derivatives,
) -> Miss:
    """Walk over crank and coupler, and over frame and rocker, to the coupler's foot at C."""
    if isinstance(linkage, FourAxes):
        arcs = [linkage.ground, linkage.crank, linkage.coupler, linkage.rocker]
        ground, first, coupler, last = ((arc.angle, arc.length) for arc in arcs)
        names, lead, slides = FOUR_AXES, 0, linkage.slides
    else:
        ground, (first, coupler, last) = (linkage.shaft_angle, 0), ((90, 0),) * 3
        names, lead, slides = HOOKE, -arithmetic.pi / 2, False
    turns = [(lead + jets[name][0], *jets[name][1:]) for name in names]
    at_d, at_b, at_c = (
        (turn, jets[slide] if slides else (0, 0, 0))
        for turn, slide in zip(turns, SLIDES, strict=True)
    )
    frame = Walk(arithmetic)
    over_crank = frame.joint(crank).link(*first).joint(*at_b).link(*coupler)
    over_frame = frame.link(*ground).joint(*at_d).link(*last).joint(*at_c)
    gap = between(over_crank, over_frame)
    one, two, three = ([*turned, *(moved if slides else ())] for turned, moved in gap)
    return one, two, three


def _balls(arithmetic: Arithmetic, linkage: BallJointed, jets: Jets, crank: Derivatives) -> Miss:
    """Walk to B and to C: half the square of BC does not change."""
    frame = Walk(arithmetic)
    b = frame.joint(crank).link(0, linkage.crank)
    foot = frame.joint((0, 0, 0), (-linkage.crank_offset, 0, 0))
    d = foot.link(linkage.ground_twist, linkage.ground)
    c = d.joint(jets[FOUR_AXES[0]], (linkage.rocker_offset, 0, 0)).link(0, linkage.rocker)
    (_, way), (_, velocity), (_, acceleration) = between(c, b)
    coupler = arithmetic.number(linkage.coupler)
    place = (dot(way, way) - coupler * coupler) / 2
    return [place], [dot(way, velocity)], [dot(way, acceleration) + dot(velocity, velocity)]
