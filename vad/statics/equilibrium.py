"""The forces of a linkage, dyad by dyad, the last one first: the loops of the rates, transposed.

Every dyad is cut at its inner joint.  With λ the force there, each side says one thing: a link that
hangs by a pin turns about it (moments), a block slides freely on its line.  So λ lies on two lines,
and these cross as the construction lines of the rates do, at the same sine.  What a dyad hands to
the bodies on which it hangs is a load of the dyads before it.

Forces are in newtons, in the axes of the reference frame; moments are in newtons times the solver's
unit of length.  The code runs on floats and on recorded numbers alike.

Sources: the transposed equations are the principle of virtual work (J. J. Uicker, G. R. Pennock,
J. E. Shigley, Theory of Machines and Mechanisms, chapter on static forces); dyads from the last to
the first: I. I. Artobolevski, Theory of Mechanisms, kinetostatics of Assur groups; inertia forces:
d'Alembert's principle.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, NamedTuple

from vad.kinematics.bodies import FRAME, Dyad, Joint, Side, contact
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.numbers import (
    Number,
    across,
    copysign,
    cross,
    dot,
    nonzero,
    over,
    select,
    times,
    vector,
)

if TYPE_CHECKING:
    from vad.statics.solver import ForceEvaluation


class Reactions(NamedTuple):
    """What holds a pose.

    Attributes
    ----------
    drive
        The moment on the driven link, or the force along the driven slide.
    forces
        The force in each joint: on the body that hangs by it, in the inner joint of a dyad on its
        second body.  That of a line on a block is square to the line.
    rubbing
        The friction on each block that has some, by the name of its slide.
    """

    drive: Number
    forces: dict[Joint, Number]
    rubbing: dict[str, Number]


@dataclass
class _Sum:
    """The forces on a body, and their moments about its reference point; None is no force."""

    force: Number = None
    moment: Number = None

    def add(self, force: Number, moment: Number) -> None:
        if force is not None:
            self.force = force if self.force is None else self.force + force
        if moment is not None:
            self.moment = moment if self.moment is None else self.moment + moment


@dataclass
class _Line:
    """The line on which one side of a dyad wants λ: λ·across = known, and its friction.

    ``pressed`` is the force of the line of a block on it, without λ; ``sign`` that of λ on it.
    """

    across: Number
    known: Number
    slide: Slide | None = None
    pressed: Number = 0j
    sign: float = 1.0
    grip: Number = 0.0


class Equilibrium:
    """The sums on all bodies, while dyad after dyad hands down what it carries."""

    def __init__(self, evaluation: ForceEvaluation) -> None:
        self.evaluation = evaluation
        self.solver = evaluation.solver
        self.tree = self.solver.tree
        self.frame = self.solver.plane.frame
        self.pose = evaluation.pose
        self.sums = {name: _Sum() for name in self.tree.bodies}
        self.forces: dict[Joint, Number] = {}
        self.rubbing: dict[str, Number] = {}
        self.drive: Number = 0.0
        turn = self.frame.turn
        unit = self.solver.scale * self.solver.metres
        for number, each in enumerate(self.solver.acting):
            value = evaluation.acting(str(number))
            if each.point:
                inward = value if turn == 1 else times(value, turn.conjugate())
                self.push(each.body, each.point, inward)
            else:
                self.sums[each.body].add(None, value / unit)

    def arm(self, body: str, point: str) -> Number:
        """Return the vector from the reference point of a body to a point; None at that point."""
        total = None
        for way, step in self.tree.bodies[body].paths[point]:
            vector = way * self.frame.displacement(step, self.pose)
            total = vector if total is None else total + vector
        return total

    def push(self, body: str, point: str, force: Number, couple: Number = None) -> None:
        """Let a force act at a point of a body, and a couple."""
        if body == FRAME:
            return
        arm = self.arm(body, point)
        self.sums[body].add(force, None if arm is None or force is None else cross(arm, force))
        self.sums[body].add(None, couple)

    def reactions(self) -> Reactions:
        """Return what holds the pose."""
        for dyad in reversed(self.tree.dyads):
            self.solve(dyad)
        driver = self.tree.driver
        if driver.joint not in self.forces:
            self.hand_down(driver.name)
        return Reactions(self.drive, self.forces, self.rubbing)

    def solve(self, dyad: Dyad) -> None:
        """Find the force in the inner joint, and hand everything down."""
        inner, block = dyad.inner, dyad.block
        if block:  # its line takes every couple of it to the body on which it slides
            self.sums[inner.one].add(None, self.sums[block].moment)
            self.sums[block].moment = None
        one, other = self.line(dyad, dyad.first, 1.0), self.line(dyad, dyad.second, -1.0)
        sine = dyad.sense * self.pose.sine[dyad.loop]
        force = self.crossing(one, other, sine)
        for side, sign in ((dyad.first, force), (dyad.second, -force)):
            top = side.bodies[-1]
            under = inner.slide and top == inner.one
            self.push(top, contact(inner) if under else inner.point, sign)
        for side in (dyad.first, dyad.second):
            if inner.slide and side.bodies[-1] == inner.other:
                held = force if side is dyad.first else -force
                self.forces[inner] = self.pressing(inner.slide, held)[0]
            for name in reversed(side.bodies):
                self.hand_down(name)
        if not inner.slide:
            self.forces[inner] = -force if inner.other == dyad.second.bodies[-1] else force

    def line(self, dyad: Dyad, side: Side, sign: float) -> _Line:
        """Return what one side says of λ, which acts on it with a sign."""
        names = [*side.bodies]
        bodies = [self.tree.bodies[name] for name in names]
        if names[-1] == dyad.block:
            slide = dyad.inner.slide
            assert slide
            return _Line(self.frame.line(slide, self.pose), 0.0, slide, sign=sign)
        force = moment = None
        for name in reversed(names):
            own = self.sums[name]
            total = _Sum(own.force, own.moment)
            if force is not None or moment is not None:
                above = bodies[names.index(name) + 1]
                arm = self.arm(name, above.contact)
                total.add(force, None if arm is None or force is None else cross(arm, force))
                total.add(None, None if above.pinned else moment)
            force, moment = total.force, total.moment
            if isinstance(side.step, Bar) and name == side.turning:
                size = side.way * self.frame.size(side.step, self.pose)
                heading = across(self.frame.heading(side.step, self.pose))
                return _Line(heading, 0.0 if moment is None else -sign * (moment / size))
        assert isinstance(side.step, Slide)
        line = self.frame.line(side.step, self.pose)
        pressed = 0j if force is None else -force
        known = 0.0 if force is None else sign * dot(pressed, line)
        return _Line(line, known, side.step, pressed, -sign)

    def crossing(self, one: _Line, other: _Line, sine: Number) -> Number:
        """Return λ from two lines; with friction, that sense of pressing which confirms itself."""
        rough = [each for each in (one, other) if each.slide and self.is_rough(each.slide)]
        if not rough:
            return _crossed(one.across, one.known, other.across, other.known, nonzero(sine))
        found, count, force = [], 0.0, 0j
        for senses in product((1.0, -1.0), repeat=len(rough)):
            for line, sense in zip(rough, senses, strict=True):
                line.grip = self.grip(line.slide) * sense
            tilted = [self.tilted(each) for each in (one, other)]
            tried = _crossed(*tilted[0], *tilted[1], nonzero(self.sine(one, other, sine)))
            fits: Number = 1.0
            for line, sense in zip(rough, senses, strict=True):
                normal = dot(line.pressed + line.sign * tried, across(line.across))
                right = (normal > 0.0) | (normal == 0.0) if sense > 0.0 else normal < 0.0
                fits = select(right, fits, 0.0)
            found.append((fits, tried))
            count = count + fits
        for fits, tried in found:
            force = force + vector(
                select(fits == 1.0, tried.real, 0.0), select(fits == 1.0, tried.imag, 0.0)
            )
        jams = select(count == 1.0, 1.0, math.nan)
        return force * jams

    def is_rough(self, slide: Slide) -> bool:
        """Tell whether a slide has friction."""
        return slide.name in self.solver.rough

    def grip(self, slide: Slide | None) -> Number:
        """Return the coefficient of friction with the sign of the block's velocity."""
        assert slide
        speed = self.evaluation.rates(1)[0].sliding[slide.name]
        sense = select(speed == 0.0, math.nan, copysign(1.0, speed))
        return self.evaluation.number(self.solver.rough[slide.name]) * sense

    def tilted(self, line: _Line) -> tuple[Number, Number]:
        """Return a line with friction: what presses on a block is no longer square to its line."""
        if line.slide is None or not self.is_rough(line.slide):
            return line.across, line.known
        tilt = line.across + line.grip * across(line.across)
        return tilt, -line.sign * dot(line.pressed, tilt)

    def sine(self, one: _Line, other: _Line, sine: Number) -> Number:
        """Return the cross product of two tilted lines."""
        p, q = across(one.across), across(other.across)
        total = sine + other.grip * cross(one.across, q) + one.grip * cross(p, other.across)
        return total + one.grip * other.grip * sine

    def pressing(self, slide: Slide, force: Number) -> tuple[Number, Number]:
        """Return what is square to the line in the force on a block, and that with its friction."""
        along = self.frame.line(slide, self.pose)
        normal = dot(force, across(along))
        held = normal * across(along)
        if not self.is_rough(slide):
            return held, held
        self.rubbing[slide.name] = rubbing = -(self.grip(slide) * abs(normal)) * along
        return held, held + rubbing

    def hand_down(self, name: str) -> None:
        """Let a body hang: what it carries goes to the body on which it hangs."""
        body, total = self.tree.bodies[name], self.sums[name]
        force = 0j if total.force is None else total.force
        moment = 0.0 if total.moment is None else total.moment
        driven = body.scalar == self.solver.driver
        if body.joint.slide is None:
            held = -force
            self.push(body.parent, body.contact, total.force)
            if driven:
                self.drive = -moment
        else:
            held, whole = self.pressing(body.joint.slide, -force)
            self.push(body.parent, body.contact, -whole, total.moment)
            if driven:
                along = self.frame.line(body.joint.slide, self.pose)
                self.drive = -dot(force + whole, along)
                if body.parent != FRAME:
                    self.push(body.parent, body.contact, -self.drive * along)
        self.forces[body.joint] = held


def _crossed(p: Number, x: Number, q: Number, y: Number, sine: Number) -> Number:
    """Return the vector with the products x with p, and y with q; ``sine`` is p × q."""
    square = x * vector(q.imag, -q.real) - y * vector(p.imag, -p.real)
    return over(square, sine)
