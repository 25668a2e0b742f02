"""Velocities of rubbing at the pins of one pose or many, and the slowest point of each link."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from vad import gate
from vad.errors import InputError, UsageError, quoted, unknown
from vad.kinematics.bodies import FRAME, Joint, bodies_of
from vad.kinematics.linkage import points_of
from vad.kinematics.motion import Motion
from vad.kinematics.numbers import Number
from vad.kinematics.solver import Solver
from vad.units import read

AnyMotion = Motion[Any, Any, Any]


class Rubbing(NamedTuple):
    """How fast a pin rubs in its hole.

    Attributes
    ----------
    pin
        The point at which it is.
    diameter
        Its diameter, in the unit of lengths.
    one, other
        The two bodies that it joins; one that stands still is the second.
    velocity
        (ω₁ - ω₂)·r, the peripheral velocity of the first body against the second one on the circle
        of the pin: counter-clockwise positive.  Where both turn against each other, it is the sum
        of their sizes.
    """

    pin: str
    diameter: float
    one: str
    other: str
    velocity: Any


class Slowest(NamedTuple):
    """The slowest point of the line of a link.

    Its image is the foot of the perpendicular from the pole on the image of the link.

    Attributes
    ----------
    distance
        From the first end of the link towards the second one; beyond them it is outside.
    position, velocity
        Where it is, and its velocity, along the link.
    on_link
        Whether it lies between both ends.
    """

    distance: Any
    position: Any
    velocity: Any
    on_link: Any


def rubbing(motion: AnyMotion, pins: Mapping[str, Any]) -> list[Rubbing]:
    """Return the velocity of rubbing at each pin, for all pairs of bodies that it joins.

    Parameters
    ----------
    motion
        One pose or many.
    pins
        The diameters of pins in the unit of lengths, or texts with a unit, by their points.

    Raises
    ------
    vad.errors.UsageError
        For a point at which there is no pin.
    vad.errors.InputError
        For a diameter that is no positive number, and for a mechanism in space.

    Examples
    --------
    A crank of 0.5 m and a rod of 2 m at 180 rpm; they turn against each other.

    >>> import math, vad
    >>> engine = vad.SliderCrank(crank=0.5, rod=2, length_unit="m")
    >>> motion = vad.solve(engine, angle=45, omega=180 * math.pi / 30)
    >>> [(each.one, each.other, round(each.velocity, 3)) for each in rubbing(motion, {"B": 0.06})]
    [('crank', 'rod', 0.667)]
    """
    if not isinstance(pins, Mapping):
        raise InputError(
            f"pins: must be diameters by point, got {quoted(pins)}", 'as in pins={"B": 50}'
        )
    joints = _pins(motion) if pins else {}
    found = []
    for point, diameter in pins.items():
        if point not in joints:
            raise _no_pin(motion, point, joints)
        size = _diameter(point, diameter, motion.mechanism.length_unit)
        for one, other in joints[point]:
            spin = _omega(motion, one) - _omega(motion, other)
            found.append(Rubbing(point, size, one, other, 0.5 * size * spin + 0.0))
    return found


def slowest(motion: AnyMotion) -> dict[str, Slowest | None]:
    """Return the slowest point of each link; None for a link that does not turn.

    A link that does not turn has the same velocity everywhere.  In an array such a pose is NaN.
    """
    found: dict[str, Slowest | None] = {}
    for name in motion.links:
        tail, head = (motion.point(letter) for letter in points_of(motion.mechanism.links[name]))
        along, omega = head.position - tail.position, motion.link(name).omega
        if not motion.many and (omega == 0.0 or along == 0.0):
            found[name] = None
            continue
        length = abs(along)
        unit, velocity = along / length, tail.velocity
        distance = _quotient(-(velocity * (1j * unit).conjugate()).real, omega)
        between = (distance >= 0.0) & (distance <= length)
        found[name] = Slowest(
            distance + 0.0,
            tail.position + distance * unit,
            (velocity * unit.conjugate()).real * unit + 0.0,
            between,
        )
    return found


def _quotient(number: Number, divisor: Number) -> Number:
    import numpy as np

    with np.errstate(all="ignore"):
        found = number / divisor
    return np.where(np.isfinite(found), found, np.nan) if np.ndim(found) else found


def listed(found: list[Rubbing]) -> list[dict[str, Any]]:
    """Return velocities of rubbing as JSON holds them.

    Examples
    --------
    >>> listed([Rubbing("A", 20.0, "crank", "frame", 100.0)])
    [{'pin': 'A', 'diameter': 20.0, 'of': 'crank', 'against': 'frame', 'velocity': 100.0}]
    """
    from vad.kinematics.results import plain

    return [
        {"pin": pin, "diameter": size, "of": one, "against": other, "velocity": plain(velocity)}
        for pin, size, one, other, velocity in found
    ]


def _pins(motion: AnyMotion) -> dict[str, list[tuple[str, str]]]:
    """Return the bodies that each pin joins, in the order of the links; the frame is the last."""
    solver, mechanism = motion.solver, motion.mechanism
    if not isinstance(solver, Solver):
        raise InputError(
            f"pins: {mechanism.name} moves in space, where joints are balls and axes",
            "rubbing is found for mechanisms in the plane, as slider-crank",
        )
    order = [*mechanism.links, *mechanism.slides]
    rank = {name: number for number, name in enumerate(order)} | {FRAME: len(order) + 1}
    found: dict[str, list[tuple[str, str]]] = {}
    for joint in _pinned(bodies_of(solver).joints):
        pair = sorted((joint.one, joint.other), key=lambda name: rank.get(name, len(order)))
        found.setdefault(joint.point, []).append((pair[0], pair[1]))
    return dict(sorted(found.items()))


def _pinned(joints: Any) -> Iterator[Joint]:
    return (joint for joint in joints if joint.slide is None)


def _omega(motion: AnyMotion, body: str) -> Any:
    """Return how fast a body turns: the frame and what slides on it do not."""
    if body == FRAME:
        return 0.0
    link = bodies_of(motion.solver.plane).bodies[body].link
    return 0.0 if link is None else motion.link(link).omega


def _diameter(point: str, value: Any, unit: str) -> float:
    if isinstance(value, str):
        value = read(value, "length", unit)
    return gate.dimension(f"pin {point}", value, signed=False)


def _no_pin(motion: AnyMotion, point: object, joints: Mapping[str, Any]) -> UsageError:
    if isinstance(point, str) and point in motion.points:
        return UsageError(
            f"pin {point}: no pin joins two bodies there", f"one of {', '.join(joints)}"
        )
    return unknown("pin", point, joints)
