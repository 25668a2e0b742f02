"""The loops of mechanisms in space as equations for Newton's method, in numbers of any precision.

In comes a problem, out go its results.  Four axes close if two walks end alike, that over the crank
and that over the frame; the ball-jointed coupler keeps its length.  Newton's method starts from a
pose that is near, and the rates follow from the derivatives of the same equations.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from vad.kinematics.linkage import Scalar, angle_of, length_of
from vad.kinematics.space.space_linkage import BallJointed, CrossedShafts, FourAxes, SpaceLinkage
from vad.methods.problem import Driven, Found, Jet
from vad.methods.walk import Arithmetic, Walk, between, dot

_MOST_STEPS = 60
_FOUR = (angle_of("rocker"), Scalar("joint", "B"), Scalar("joint", "C"))
_SLIDES = tuple(map(length_of, ("slide_d", "slide_b", "slide_c")))
_HOOKE = (angle_of("driven"), Scalar("joint", "P"), Scalar("joint", "Q"))
#: What does not close, and its two derivatives, each as a list of numbers.
Gap = tuple[list[Any], list[Any], list[Any]]
Jets = Mapping[Scalar, tuple[Any, Any, Any]]


@dataclass(frozen=True)
class SpaceProblem(Driven):
    """The loop of a mechanism in space, and the motion of its driver.

    Attributes
    ----------
    linkage
        Its axes or balls, whose numbers are taken as they stand.
    """

    linkage: SpaceLinkage

    @property
    def unknowns(self) -> tuple[Scalar, ...]:
        """All scalars that are to be found: angles of links and joints, and slides."""
        if isinstance(self.linkage, BallJointed):
            return _FOUR[:1]
        if isinstance(self.linkage, CrossedShafts):
            return _HOOKE
        return (*_FOUR, *_SLIDES) if self.linkage.slides else _FOUR

    def sense(self, scalar: Scalar) -> int:
        """Return -1 at Q of Hooke's joint, where ψ grows as the cross turns backward."""
        return -1 if scalar == _HOOKE[2] else 1


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
    loop = _Loop(problem, arithmetic, (angle, arithmetic.number(rate), arithmetic.number(second)))
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


class _Loop:
    """The equations of a problem for one place of its driver."""

    def __init__(
        self, problem: SpaceProblem, arithmetic: Arithmetic, driver: tuple[Any, Any, Any]
    ) -> None:
        self._unknowns = problem.unknowns
        self._arithmetic = arithmetic
        self._driver = driver
        linkage = problem.linkage
        self._equations: Callable[[Jets, tuple[Any, Any, Any]], Gap]
        if isinstance(linkage, BallJointed):
            self._equations = lambda jets, crank: _balls(arithmetic, linkage, jets, crank)
        else:
            self._equations = lambda jets, crank: _axes(arithmetic, linkage, jets, crank)

    def gap(self, place: Mapping[Scalar, Any], rates: Mapping[Scalar, Any] | None = None) -> Gap:
        """Return what does not close, with rates of the unknowns, or with none."""
        rates = rates or dict.fromkeys(place, 0)
        jets = {scalar: (place[scalar], rates[scalar], 0) for scalar in place}
        return self._equations(jets, self._driver)

    def solved(self, place: Mapping[Scalar, Any], gap: list[Any]) -> dict[Scalar, Any]:
        """Return what of the unknowns makes good a gap, to the first order."""
        columns = []
        still = (self._driver[0], 0, 0)
        for one in self._unknowns:
            jets = {scalar: (place[scalar], int(scalar == one), 0) for scalar in place}
            columns.append(self._equations(jets, still)[1])
        found = self._arithmetic.solve(columns, [-x for x in gap])
        return dict(zip(self._unknowns, found, strict=True))


def _axes(
    arithmetic: Arithmetic,
    linkage: FourAxes | CrossedShafts,
    jets: Jets,
    crank: tuple[Any, Any, Any],
) -> Gap:
    """Walk over crank and coupler, and over frame and rocker, to the coupler's foot at C."""
    if isinstance(linkage, FourAxes):
        arcs = [linkage.ground, linkage.crank, linkage.coupler, linkage.rocker]
        ground, first, coupler, last = ((arc.angle, arc.length) for arc in arcs)
        names, lead, slides = _FOUR, 0, linkage.slides
    else:
        ground, (first, coupler, last) = (linkage.shaft_angle, 0), ((90, 0),) * 3
        names, lead, slides = _HOOKE, -arithmetic.pi / 2, False
    turns = [(lead + jets[name][0], *jets[name][1:]) for name in names]
    at_d, at_b, at_c = (
        (turn, jets[slide] if slides else (0, 0, 0))
        for turn, slide in zip(turns, _SLIDES, strict=True)
    )
    frame = Walk(arithmetic)
    over_crank = frame.joint(crank).link(*first).joint(*at_b).link(*coupler)
    over_frame = frame.link(*ground).joint(*at_d).link(*last).joint(*at_c)
    gap = between(over_crank, over_frame)
    one, two, three = ([*turned, *(moved if slides else ())] for turned, moved in gap)
    return one, two, three


def _balls(
    arithmetic: Arithmetic, linkage: BallJointed, jets: Jets, crank: tuple[Any, Any, Any]
) -> Gap:
    """Walk to B and to C: half the square of BC does not change."""
    frame = Walk(arithmetic)
    b = frame.joint(crank).link(0, linkage.crank)
    foot = frame.joint((0, 0, 0), (-linkage.crank_offset, 0, 0))
    d = foot.link(linkage.ground_twist, linkage.ground)
    c = d.joint(jets[_FOUR[0]], (linkage.rocker_offset, 0, 0)).link(0, linkage.rocker)
    (_, way), (_, velocity), (_, acceleration) = between(c, b)
    coupler = arithmetic.number(linkage.coupler)
    place = (dot(way, way) - coupler * coupler) / 2
    return [place], [dot(way, velocity)], [dot(way, acceleration) + dot(velocity, velocity)]
