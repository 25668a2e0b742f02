"""What a user can read of a motion in the plane, each result in one formula.

They take an `Evaluation`, on floats or on recorded numbers, and return a number or a plane vector
in the user's units and axes.
"""

from __future__ import annotations

from collections.abc import Callable

from vad.kinematics.evaluation import Evaluation
from vad.kinematics.linkage import Linkage, Slide, angle_of
from vad.kinematics.numbers import (
    Number,
    degrees_of,
    direction,
    fold,
    positive,
    times,
    turned,
)

# What is read: the kind link, joint, point or slide, its name, and which quantity of it.
Result = tuple[str, str, str]


def order_of(result: Result) -> int:
    """Return how many derivatives a result needs."""
    return _ORDERS[result[2]]


def evaluate(result: Result, evaluation: Evaluation) -> Number:
    """Return a result; NaN where it is undetermined."""
    kind, name, quantity = result
    return _FORMULAS[kind, quantity](evaluation, name, _ORDERS[quantity])


def guide_of(linkage: Linkage, slide: str) -> str | None:
    """Return the name of the turning link on which a slide slides, if it does."""
    steps = (step for loop in linkage.loops for _, step in loop.steps())
    lines = [step.along for step in steps if isinstance(step, Slide) and step.name == slide]
    return next((line for line in lines if isinstance(line, str)), None)


def heading(guide: Slide) -> complex:
    """Return the direction of a guide in the user's axes, where turning there and back is exact."""
    return complex(direction(fold(float(guide.along))))


def _angle(evaluation: Evaluation, name: str, order: int) -> Number:
    """Return a link's direction: as it was given, or as seen along its guide where it has one."""
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
    start = routes.start(letter)
    guide, pin = routes.guide(letter), routes.pin(letter)
    if guide:
        return guide.origin + _sliding(evaluation, guide.name, order) * heading(guide)
    if pin:
        along = turned(evaluation.driver_direction, pin.turn) * float(pin.length)
        return frame.places[start] + along
    from_start = routes.position(letter, evaluation.pose)
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


# How many derivatives a quantity needs.
_ORDERS = {
    "angle": 0,
    "omega": 1,
    "alpha": 2,
    "position": 0,
    "velocity": 1,
    "acceleration": 2,
    "coriolis": 1,
}
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
}
