"""The solver of linkages in the plane, and the formula of each result that a user can read.

The formulas take an `Evaluation`, on floats or on recorded numbers, and return a number or a plane
vector in the units and axes of the user.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence, Set
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import AnySolver, Evaluation, Result, order_of, round_the_turn
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.frame import ReferenceFrame, Route, Routes
from vad.kinematics.linkage import Bar, Linkage, Slide, angle_of
from vad.kinematics.loop import LoopSolver
from vad.kinematics.loop_kinds import loop_solver
from vad.kinematics.numbers import (
    Number,
    across,
    degrees_of,
    difference,
    direction,
    dot,
    fold,
    positive,
    select_vector,
    times,
    turned,
    vector,
)
from vad.kinematics.state import GROUND, Pose, Rates
from vad.kinematics.symbol import as_float

if TYPE_CHECKING:
    from vad.kinematics.refined import Refinement
    from vad.mechanisms.mechanism import Mechanism


# The square of a smaller sine would leave the range of double precision, and ω at a change point
# with it.
LEAST_SINE = 1e-100


@lru_cache(maxsize=64)
def solver_of(mechanism: Mechanism) -> AnySolver:
    """Return the solver of a mechanism in the plane or in space; it is made once."""
    return other_solver(mechanism, ())


def other_solver(mechanism: Mechanism, sides: Sequence[float]) -> AnySolver:
    """Return the solver of a mechanism that is assembled in another way.

    Parameters
    ----------
    mechanism
        The mechanism.
    sides
        For each loop a factor: with -1.0 it takes its other place, if it has two.  In space there
        is one.  The factors may be traced.
    """
    linkage, side = mechanism.marked(), -1.0 if mechanism.assembly == "crossed" else 1.0
    if not isinstance(linkage, Linkage):
        return linkage.solver(math.prod(sides, start=side))
    if sides:
        loops = zip(linkage.loops, sides, strict=True)
        turned = tuple(replace(loop, side=loop.side * factor) for loop, factor in loops)
        linkage = replace(linkage, loops=turned)
    return Solver(linkage, side)


class Solver(AnySolver):
    """The solver of a linkage in the plane: its loops, each with its closed form.

    Parameters
    ----------
    linkage
        The loops.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.

    Attributes
    ----------
    frame
        The unit and the axes in which it solves.
    loops
        Each loop with its closed form.
    """

    def __init__(self, linkage: Linkage, side: float) -> None:
        super().__init__()
        self.linkage = linkage
        self.driver = linkage.driver
        scalars = {linkage.driver, *(scalar for pair in linkage.unknowns for scalar in pair)}
        self.links = {scalar.name for scalar in scalars if scalar.kind == "angle"}
        self.slides = {scalar.name for scalar in scalars if scalar.kind == "length"}
        self.frame = ReferenceFrame(linkage)
        self.scale = self.frame.scale
        self.loops: list[LoopSolver] = [
            loop_solver(self.frame, side, loop, unknowns)
            for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
        ]
        #: What makes places exact in a linkage of many loops.
        self.refinement = self.frame.refined = _refinement(self.frame)
        self.two_assemblies = any(loop.two_ways for loop in self.loops)

    @cached_property
    def routes(self) -> Routes:
        """The routes from fixed points to all points."""
        return Routes(self.frame)

    @property
    def plane(self) -> Solver:
        """Itself."""
        return self

    @cached_property
    def letters(self) -> Set[str]:
        """Every point that can be reached."""
        return self.routes.letters

    @property
    def dyads(self) -> list[str]:
        """What each loop finds, by name, in the order of the sines."""
        return [" and ".join(scalar.name for scalar in pair) for pair in self.linkage.unknowns]

    @property
    def searched(self) -> list[int]:
        """The numbers of the loops whose limits have no closed form."""
        return [
            number
            for number, loop in enumerate(self.loops)
            if loop.two_ways and not (loop.crank or loop.loop.parallel or loop.limits())
        ]

    def searched_misses(self, pose: Pose, value: Number) -> list[Number]:
        """Return by how much the chains of each of these loops miss each other."""
        return [self.loops[number].miss(pose) for number in self.searched]

    def limits(self) -> NDArray[np.float64]:
        """Return all limits in closed form, of an angle within [0, 360], sorted."""
        found = [limit for loop in self.loops for limit in loop.limits()]
        if self.driver.kind == "angle":
            return round_the_turn(limit + self.frame.angle for limit in found)
        return np.unique([limit * self.scale for limit in found])

    def on_turning_link(self, slide: str) -> bool:
        """Tell whether a slide is on a link that turns, and so has a Coriolis component."""
        return guide_of(self.linkage, slide) is not None

    def evaluate(self, result: Result, evaluation: Evaluation) -> Number:
        """Return a result, of a point as a plane vector; NaN where it is undetermined."""
        kind, name, quantity = result
        return _FORMULAS[kind, quantity](evaluation, name, order_of(result))

    def positions(self, value: Number) -> Pose:
        """Solve all loops for the driver's angle (degrees) or length."""
        pose = Pose({GROUND: 1.0 + 0j}, {}, [])
        driver = self.linkage.driver
        if driver.kind == "angle":
            angle = fold(value)
            if self.frame.angle:
                angle = difference(angle, self.frame.angle)
            pose.unit[driver.name] = direction(angle, LEAST_SINE)
        else:
            pose.length[driver.name] = value / self.frame.scale
        if self.refinement and driver.kind == "angle":
            self.refinement.begin(driver.name, pose)
        for loop in self.loops:
            loop.place(pose)
            sine = pose.sine[-1]
            if isinstance(sine, float) and math.isnan(sine):
                raise OpenLoopError(loop.miss(pose))
            if self.refinement:
                self.refinement.improve(loop, pose)
        return pose

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve all loops for the driver's rate, of the order after those in ``lower``."""
        driver = self.linkage.driver
        if driver.kind == "angle":
            found = Rates({driver.name: value}, {})
        else:
            found = Rates({}, {driver.name: value / self.frame.scale})
        for loop, sine in zip(self.loops, pose.sine, strict=True):
            loop.move(pose, (*lower, found), sine)
        return found

    def is_dead(self, pose: Pose) -> bool:
        """Tell whether something has no rates in a single pose."""
        return self._dead(pose) is not None

    def why_dead(self, pose: Pose) -> str:
        """Say why a result is undetermined in a single pose."""
        dead = self._dead(pose)
        return dead.why_dead() if dead else "the result is undetermined at this dead centre"

    def _dead(self, pose: Pose) -> LoopSolver | None:
        """Return the first loop whose construction lines are parallel, if any."""
        loops = zip(self.loops, pose.sine, strict=True)
        return next((one for one, sine in loops if sine == 0.0 and not one.loop.parallel), None)

    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much the chains of a pose miss each other."""
        return f"{miss * self.scale:.4g} {length_unit}"


def _refinement(frame: ReferenceFrame) -> Refinement | None:
    """Return what makes places exact in a linkage of many loops."""
    if len(frame.linkage.loops) == 1:
        return None
    from vad.kinematics.refined import Refinement, is_refined  # one loop does not need it

    return Refinement(frame) if is_refined(frame.linkage) else None


def guide_of(linkage: Linkage, slide: str) -> str | None:
    """Return the turning link on which a slide slides; None on a line of the frame."""
    steps = (step for loop in linkage.loops for _, step in loop.steps())
    lines = [step.along for step in steps if isinstance(step, Slide) and step.name == slide]
    return next((line for line in lines if isinstance(line, str)), None)


def heading(guide: Slide) -> complex:
    """Return the direction of a guide in the user's axes, without turning there and back."""
    along: complex = direction(fold(guide.along))
    return along


def _angle(evaluation: Evaluation, name: str, order: int) -> Number:
    """Return a link's direction: as it was given, or read from its guide if it ends on one."""
    frame, pose = evaluation.solver.plane.frame, evaluation.pose
    if angle_of(name) == frame.linkage.driver:
        return positive(evaluation.driver_angle)
    if name in pose.leaning:
        leaning = turned(pose.leaning[name], frame.found_along[name].conjugate())
        return degrees_of(leaning, frame.guides[name])
    return degrees_of(_turned(evaluation, frame.unit(name, pose)))


def _turning(evaluation: Evaluation, name: str, order: int) -> Number:
    return evaluation.rates(order)[-1].turning[name]


def _position(evaluation: Evaluation, letter: str, order: int) -> Number:
    """Return where a point is: on its guide, on the driven crank, or at the end of its route."""
    plane = evaluation.solver.plane
    routes, frame = plane.routes, plane.frame
    guide, pin = routes.guide(letter), routes.pin(letter)
    if pin:
        along = turned(evaluation.driver_direction, pin.turn) * as_float(pin.length)
        return frame.places[routes.route(letter)[0]] + along
    if guide and not plane.refinement:
        return guide.origin + _sliding(evaluation, guide.name, order) * heading(guide)
    usual, other = routes.route(letter), routes.over_strut(letter, evaluation.pose)
    if other is None:
        return _end(evaluation, usual)
    over_strut, shorter = other
    return select_vector(shorter, _end(evaluation, over_strut), _end(evaluation, usual))


def _end(evaluation: Evaluation, route: Route) -> Number:
    """Return where a route ends."""
    plane, start = evaluation.solver.plane, route[0]
    frame = plane.frame
    if plane.refinement:
        return plane.refinement.end(route, evaluation.pose) * frame.scale
    from_start = plane.routes.along(route, evaluation.pose)
    if start in frame.places:
        return frame.places[start] + _outward(evaluation, from_start)
    return frame.linkage.place + _outward(evaluation, frame.fixed[start] + from_start)


def _motion(evaluation: Evaluation, letter: str, order: int) -> Number:
    """Return the velocity or acceleration of a point."""
    routes = evaluation.solver.plane.routes
    guide = routes.guide(letter)
    if guide:
        return _sliding(evaluation, guide.name, order) * heading(guide)
    return _outward(evaluation, routes.rate(letter, evaluation.pose, evaluation.rates(order)))


def _outward(evaluation: Evaluation, value: Number) -> Number:
    return _turned(evaluation, value) * evaluation.solver.plane.frame.scale


def _turned(evaluation: Evaluation, value: Number) -> Number:
    """Return a vector in the user's axes."""
    turn = evaluation.solver.plane.frame.turn
    return value if turn == 1 else times(value, turn)


def _sliding(evaluation: Evaluation, name: str, order: int) -> Number:
    """Return the position, velocity or acceleration of a slide along its line."""
    lengths = evaluation.rates(order)[-1].sliding if order else evaluation.pose.length
    return lengths[name] * evaluation.solver.plane.frame.scale


def _coriolis(evaluation: Evaluation, name: str, order: int) -> Number:
    """Return the magnitude of 2·ω·v of a slide on a turning link."""
    velocity, link = evaluation.rates(order)[0], guide_of(evaluation.solver.plane.linkage, name)
    twist = abs(2.0 * velocity.turning[str(link)] * velocity.sliding[name])
    return twist * evaluation.solver.plane.frame.scale


def _centre(evaluation: Evaluation, name: str, order: int) -> Number:
    """Return the instantaneous centre of two bodies, in homogeneous coordinates."""
    from vad.kinematics.kennedy import kennedy_of  # most motions do not need it

    return kennedy_of(evaluation.solver.plane).named(name, evaluation)


def _klein(evaluation: Evaluation, name: str, order: int) -> Number:
    """Return a point of Klein's construction."""
    from vad.kinematics.klein import figure_of  # most motions do not need it

    return figure_of(evaluation)[name]


def _transmission(evaluation: Evaluation, name: str, order: int) -> Number:
    """Return the transmission angle of the dyad that loop number ``name`` finds, in degrees.

    Between two bars it is the angle at their common pin, between a bar and a guide that from the
    guide's normal, which lies 90° counter-clockwise from the guide, to the bar, seen from the pin:
    both within 0 and 180.  Of other dyads it is the angle at which the construction lines of the
    velocities cross, at most 90.
    """
    pose, loop = evaluation.pose, evaluation.solver.plane.loops[int(name)]
    frame, one, other = loop.frame, loop.step, loop.other
    guided = isinstance(other, Slide) and isinstance(other.along, float)
    if isinstance(one, Bar) and isinstance(other, Bar):
        level = dot(_from_pin(frame, one, pose), _from_pin(frame, other, pose))
    elif isinstance(one, Bar) and isinstance(one.length, float) and guided:
        level = dot(_from_pin(frame, one, pose), across(frame.unknown_direction(other, pose)))
    else:
        p, q = (frame.unknown_direction(step, pose) for step in (one, other))
        level = abs(dot(p, q))
    return degrees_of(vector(level, abs(pose.sine[int(name)])))


def _from_pin(frame: ReferenceFrame, bar: Bar, pose: Pose) -> Number:
    """Return the unit vector of a bar from the pin in which its dyad closes to its other end."""
    heading = frame.heading(bar, pose)
    return heading if bar.reverse else -heading


_FORMULAS: dict[tuple[str, str], Callable[[Evaluation, str, int], Number]] = {
    ("link", "angle"): _angle,
    ("link", "omega"): _turning,
    ("link", "alpha"): _turning,
    ("point", "position"): _position,
    ("point", "velocity"): _motion,
    ("point", "acceleration"): _motion,
    ("slide", "position"): _sliding,
    ("slide", "velocity"): _sliding,
    ("slide", "acceleration"): _sliding,
    ("slide", "coriolis"): _coriolis,
    ("centre", "position"): _centre,
    ("klein", "position"): _klein,
    ("dyad", "transmission"): _transmission,
}
