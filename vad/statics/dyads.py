"""The equation of each dyad, as it is drawn: two known chains of forces, and two lines that cross.

The forces on a dyad from outside, in its two outer joints, hold what loads it::

    R₁ + loads of the first half + loads of the second half + R₂ = 0

Of each R one part is known, by moments about the inner joint, or along the line of a block; the
line of the other part is known.  So the polygon of a dyad is a vector equation with two unknown
lengths, as those of the velocities are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from vad.errors import InputError
from vad.kinematics.bodies import Dyad, Side
from vad.kinematics.linkage import Slide

if TYPE_CHECKING:
    from vad.statics.forces import Forces, JointForce


class Load(NamedTuple):
    """A force on a body that is known when its dyad is drawn.

    Attributes
    ----------
    kind
        ``force``, ``weight``, ``inertia``, ``friction``; ``joint`` for what a later dyad hands on.
    name
        What the user calls it; of a joint, and of friction, the other body.
    body, point
        Where it acts.
    force
        As x + iy in newtons.
    """

    kind: str
    name: str
    body: str
    point: str
    force: complex


@dataclass(frozen=True)
class Half:
    """One half of a dyad.

    Attributes
    ----------
    bodies
        Their names, from the outer joint to the inner one.
    outer
        The force on it from outside, in its outer joint.
    known, unknown
        The parts of that force: the one that is known before the polygon is drawn, and the other.
    direction
        The direction of the line of the unknown part, as a unit vector.
    loads
        The forces on its bodies, from the outer joint to the inner one.
    couples
        The sum of the couples on them, in newton metres.
    """

    bodies: tuple[str, ...]
    outer: JointForce
    known: complex
    unknown: complex
    direction: complex
    loads: tuple[Load, ...]
    couples: float


@dataclass(frozen=True)
class DyadForces:
    """The forces of one dyad in one pose.

    Attributes
    ----------
    number
        The number of its loop, from 0.
    first, second
        Its halves; the first is that of the loop's first chain.
    inner
        The force in its inner joint, of the first half on the second one.
    """

    number: int
    first: Half
    second: Half
    inner: JointForce


def dyads_of(found: Forces[Any, Any, Any]) -> tuple[DyadForces, ...]:
    """Return the dyads of one pose in the order of drawing, the last one first.

    Raises
    ------
    vad.errors.InputError
        For many poses.
    """
    if found.many:
        raise InputError("dyads: are those of one pose", "solve a single place of the driver")
    reader = _Reader(found)
    return tuple(reader.dyad(dyad) for dyad in reversed(found.bodies.dyads))


def chains_of(found: Forces[Any, Any, Any]) -> tuple[tuple[JointForce, tuple[Load, ...]], ...]:
    """Return the first outer force of each dyad, and its loads from there on, of many poses too.

    Both are in the order of drawing.  The second outer force closes their sum.
    """
    reader = _Reader(found)
    return tuple(
        (reader.outer(dyad.first), tuple(reader.along(dyad)))
        for dyad in reversed(found.bodies.dyads)
    )


def outer_forces(found: Forces[Any, Any, Any]) -> list[tuple[str, JointForce]]:
    """Return the force in each outer joint of all dyads with the body that it holds.

    They are in the order of drawing, of one pose or of many.
    """
    reader = _Reader(found)
    sides = (side for dyad in reversed(found.bodies.dyads) for side in (dyad.first, dyad.second))
    return [(side.bodies[0], reader.outer(side)) for side in sides]


class _Reader:
    """Forces by their joints."""

    def __init__(self, found: Forces[Any, Any, Any]) -> None:
        self.found = found
        self.bodies = found.bodies.bodies
        self.joints = dict(zip(found.bodies.joints, found.joints, strict=True))
        self.rubbing = {each.other: each for each in found.friction}

    def dyad(self, dyad: Dyad) -> DyadForces:
        inner = self.joints[dyad.inner]
        if inner.one in dyad.second.bodies:
            inner = inner._replace(one=inner.other, other=inner.one, force=-inner.force)
        within = {*dyad.first.bodies, *dyad.second.bodies}
        halves = [self.half(dyad, side, within) for side in (dyad.first, dyad.second)]
        return DyadForces(dyad.loop, halves[0], halves[1], inner)

    def outer(self, side: Side) -> JointForce:
        """Return the force in the outer joint of a half."""
        return self.joints[self.bodies[side.bodies[0]].joint]

    def along(self, dyad: Dyad) -> list[Load]:
        """Return all loads of a dyad in the order in which a polygon lays them."""
        within = {*dyad.first.bodies, *dyad.second.bodies}
        first, second = (
            [load for name in side.bodies for load in self.loads(name, within)]
            for side in (dyad.first, dyad.second)
        )
        return [*first, *reversed(second)]

    def half(self, dyad: Dyad, side: Side, within: set[str]) -> Half:
        joint = self.bodies[side.bodies[0]].joint
        outer = self.outer(side)
        direction = self.direction(dyad, side)
        along = (outer.force * direction.conjugate()).real
        unknown = outer.force if joint.slide else along * direction
        loads = [load for name in side.bodies for load in self.loads(name, within)]
        couples = [
            self.found.acts(number)
            for number, each in enumerate(self.found.acting)
            if each.body in side.bodies and not each.point
        ]
        known = outer.force - unknown
        return Half(side.bodies, outer, known, unknown, direction, tuple(loads), sum(couples, 0.0))

    def direction(self, dyad: Dyad, side: Side) -> complex:
        """Return the direction of the line of the unknown part."""
        body = self.bodies[side.bodies[0]]
        slide = body.joint.slide or (dyad.inner.slide if body.name == dyad.block else None)
        if slide:
            return 1j * self.line(slide)
        ends = (body.joint.point, dyad.inner.point)
        outer, inner = (self.found.read(("point", point, "position")) for point in ends)
        along: complex = (inner - outer) / abs(inner - outer)
        return along

    def line(self, slide: Slide) -> complex:
        """Return the direction of a slide in the user's axes."""
        line: complex = self.found.frame.line(slide, self.found.pose) * self.found.frame.turn
        return line

    def loads(self, body: str, within: set[str]) -> list[Load]:
        """Return what acts on a body, and what hangs on it."""
        found = [
            Load(each.kind, each.name, body, each.point, self.found.acts(number))
            for number, each in enumerate(self.found.acting)
            if each.body == body and each.point
        ]
        for force in self.joints.values():
            if body == force.one and force.other not in within:
                found.append(Load("joint", force.other, body, force.point, -force.force))
        for one, other, point, force in self.rubbing.values():
            if body == other and one not in within:
                found.append(Load("friction", one, body, point, force))
            if body == one and other not in within:
                found.append(Load("friction", other, body, point, -force))
        return found
