"""A solver that finds forces, too, and the formula of each result that is a force."""

from __future__ import annotations

from collections.abc import Set
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import AnySolver, Evaluation, Result
from vad.kinematics.bodies import Bodies
from vad.kinematics.numbers import (
    Number,
    cross,
    direction,
    dot,
    fold,
    times,
    vector,
)
from vad.kinematics.solver import Solver
from vad.kinematics.state import Pose, Rates
from vad.statics.equilibrium import Equilibrium, Reactions

#: The kinds of results that are forces.
KINDS = ("drive", "reaction", "rubbing", "acting", "shaking", "power")


class Acting(NamedTuple):
    """Something that acts on a body.

    Attributes
    ----------
    kind
        ``force`` or ``couple`` of a load, ``weight``, ``inertia`` (the force of a mass) or ``spin``
        (the couple of a moment of inertia).
    body, point
        Where; a couple has no point.
    inputs
        The names of its numbers: size and angle, or mass, or moment of inertia.
    name
        What the user calls it.
    """

    kind: str
    body: str
    point: str
    inputs: tuple[str, ...]
    name: str = ""


class StaticSolver(AnySolver):
    """A solver that finds forces, too.

    Parameters
    ----------
    plane
        The solver of the linkage.
    bodies
        Its bodies.
    acting
        All that acts on them.
    rough
        The slides with friction.
    metres
        How many metres the user's unit of length has; moments are in newtons times so many metres.
    """

    def __init__(
        self,
        plane: Solver,
        bodies: Bodies,
        acting: tuple[Acting, ...],
        rough: tuple[str, ...],
        metres: float,
    ) -> None:
        super().__init__()
        self._plane = plane
        self.tree = bodies
        self.acting = acting
        self.rough = {slide: f"mu{number}" for number, slide in enumerate(rough)}
        self.metres = metres
        self.driver, self.scale = plane.driver, plane.scale
        self.links, self.slides = plane.links, plane.slides
        self.two_assemblies = plane.two_assemblies
        names = [name for each in acting for name in each.inputs]
        self.further = tuple(dict.fromkeys([*names, *self.rough.values()]))
        moving = any(each.kind in ("inertia", "spin") for each in acting)
        #: What the forces need: one of the quantities of results that are forces.
        self.stage = "dynamic" if moving else "rubbing" if rough else "static"

    @property
    def plane(self) -> Solver:
        """The solver of the linkage."""
        return self._plane

    @property
    def letters(self) -> Set[str]:
        """Every point that can be reached."""
        return self._plane.letters

    def positions(self, value: Number) -> Pose:
        """Return the pose for the driver's angle (degrees) or length."""
        return self._plane.positions(value)

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Return the rates of the order after those in ``lower``."""
        return self._plane.rates(pose, lower, value)

    def evaluation(self, inputs: tuple[Number, ...]) -> Evaluation:
        """Return what is to be found of one pose, or of recorded numbers."""
        return ForceEvaluation(self, inputs)

    def evaluate(self, result: Result, evaluation: Evaluation) -> Number:
        """Return a result: a force in newtons, a moment in newtons times metres, a power."""
        kind, name, _ = result
        if kind not in KINDS:
            return self._plane.evaluate(result, evaluation)
        assert isinstance(evaluation, ForceEvaluation)
        return getattr(evaluation, kind)(name)

    def why_dead(self, pose: Pose) -> str:
        """Say why the forces of a single pose are undetermined."""
        for loop, sine in zip(self._plane.loops, pose.sine, strict=True):
            if sine == 0.0 and loop.loop.parallel:
                return "change point: all links lie in one line, and no force is determined"
        return self._plane.why_dead(pose)

    def is_dead(self, pose: Pose) -> bool:
        """Tell whether forces are undetermined."""
        return 0.0 in pose.sine

    def miss_in_words(self, miss: float, length_unit: str) -> str:
        """Say by how much the chains of a pose miss each other."""
        return self._plane.miss_in_words(miss, length_unit)

    def limits(self) -> NDArray[np.float64]:
        """Return all limits in closed form."""
        return self._plane.limits()

    @property
    def dyads(self) -> list[str]:
        """What each loop finds, by name."""
        return self._plane.dyads

    @property
    def searched(self) -> list[int]:
        """The numbers of the loops whose limits have no closed form."""
        return self._plane.searched

    def searched_misses(self, pose: Pose, value: Number) -> list[Number]:
        """Return by how much the chains of each of these loops miss each other."""
        return self._plane.searched_misses(pose, value)


class ForceEvaluation(Evaluation):
    """Pose, rates and forces of one pose, or of recorded numbers."""

    solver: StaticSolver

    def __init__(self, solver: StaticSolver, inputs: tuple[Number, ...]) -> None:
        super().__init__(solver, inputs)
        self._given = dict(zip(solver.further, inputs[-len(solver.further) :], strict=False))
        self._reactions: Reactions | None = None

    @property
    def reactions(self) -> Reactions:
        """The drive and the force in each joint, in the axes of the reference frame."""
        if self._reactions is None:
            self._reactions = Equilibrium(self).reactions()
        return self._reactions

    def number(self, name: str) -> Number:
        """Return a further input."""
        return self._given[name]

    def drive(self, _: str) -> Number:
        """Return the drive: a moment, or a force along the driven slide."""
        turns = self.solver.driver.kind == "angle"
        drive = self.reactions.drive
        return drive * (self.solver.scale * self.solver.metres) if turns else drive

    def reaction(self, number: str) -> Number:
        """Return the force in a joint, in the user's axes."""
        return self._outward(self.reactions.forces[self.solver.tree.joints[int(number)]])

    def rubbing(self, slide: str) -> Number:
        """Return the friction on a block, in the user's axes."""
        return self._outward(self.reactions.rubbing[slide])

    def acting(self, number: str) -> Number:
        """Return a force that acts, in the user's axes, or a couple."""
        solver = self.solver
        kind, body, point, inputs, _ = solver.acting[int(number)]
        given = [self.number(name) for name in inputs]
        if kind == "force":
            return given[0] * direction(fold(given[1]))
        if kind == "weight":
            return vector(given[0] * given[1], given[0] * given[2])
        if kind == "inertia":
            result = "point", point, "acceleration"
            return (given[0] * -solver.metres) * solver.plane.evaluate(result, self)
        if kind == "spin":
            link = solver.tree.bodies[body].link
            return -(given[0] * self.rates(2)[1].turning[str(link)])
        return given[0]

    def shaking(self, what: str) -> Number:
        """Return the sum of all that acts, or of its moments about the pivot."""
        force: Number = 0j
        moment: Number = 0.0
        linkage, metres = self.solver.plane.linkage, self.solver.metres
        for number, each in enumerate(self.solver.acting):
            value = self.acting(str(number))
            if each.point:
                force = force + value
                arm = self._point(each.point, "position") - linkage.place
                value = cross(arm, value) * metres if what == "moment" else 0.0
            moment = moment + value
        return moment if what == "moment" else force

    def power(self, what: str) -> Number:
        """Return the sum of the powers of all that acts, or the sum of their sizes."""
        solver = self.solver
        turning, sliding = self.rates(1)[0].turning, self.rates(1)[0].sliding
        turns = solver.driver.kind == "angle"
        unit = 1.0 if turns else solver.metres
        powers = [self.drive("") * (self.inputs[1] * unit)]
        for number, each in enumerate(solver.acting):
            value = self.acting(str(number))
            link = solver.tree.bodies[each.body].link
            if each.point:
                powers.append(dot(value, self._point(each.point, "velocity")) * solver.metres)
            elif link:
                powers.append(value * turning[link])
        for joint in solver.tree.joints:
            if joint.slide and joint.slide.name in solver.rough:
                line = solver.plane.frame.line(joint.slide, self.pose)
                rubbing = dot(self.reactions.rubbing[joint.slide.name], line)
                rubbing = rubbing * sliding[joint.slide.name]
                powers.append(rubbing * (solver.scale * solver.metres))
        total: Number = 0.0
        for power in powers:
            total = total + (abs(power) if what == "sizes" else power)
        return total

    def _point(self, letter: str, quantity: str) -> Number:
        return self.solver.plane.evaluate(("point", letter, quantity), self)

    def _outward(self, force: Number) -> Number:
        turn = self.solver.plane.frame.turn
        return force if turn == 1 else times(force, turn)
