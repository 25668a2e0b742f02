"""The verb `forces`: from a motion with loads and masses to the drive and all joint forces."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property, lru_cache
from typing import Any, Generic, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad import gate
from vad.errors import InputError, UsageError, VadError, one_of, quoted
from vad.kinematics.any_solver import Result
from vad.kinematics.bodies import FRAME, Bodies, bodies_of
from vad.kinematics.motion import Motion
from vad.kinematics.numbers import Number, Real, Truth, Vector
from vad.kinematics.solution import Solution
from vad.kinematics.solver import Solver
from vad.statics.burden import NOTHING, Burden
from vad.statics.dyads import DyadForces, dyads_of
from vad.statics.listing import listed, table
from vad.statics.loads import Given, gravity_of, listed_loads
from vad.statics.solver import Acting, StaticSolver
from vad.statics.turn import Turning
from vad.units import metres_of, number_of
from vad.written import DIGITS, MOST_DIGITS


def forces(
    motion: Motion[Real, Vector, Truth],
    loads: Iterable[Mapping[str, Any]] = (),
    masses: Mapping[str, Any] | None = None,
    gravity: Any = None,
    friction: Mapping[str, Any] | None = None,
) -> Forces[Real, Vector, Truth]:
    """Find what loads, weights and inertia ask of the joints and of the driver.

    Nothing is computed yet: each force is found when it is asked for.  What the file of a mechanism
    has of loads, masses, gravity and friction counts, too; what is given here comes to it.

    Parameters
    ----------
    motion
        One pose or many, of a mechanism in the plane.
    loads
        Each is a force in newtons at a point, ``{"at": "E", "on": "rocker", "force": 80,
        "angle": 150}``, or a couple in newton metres, ``{"on": "rocker", "couple": -6}``,
        counter-clockwise.  Numbers may be arrays that broadcast with the motion, and texts with a
        unit, ``"80 lbf"``.  ``on`` may be left out where one body alone has the point; where
        something slides there, it is the slide.  A load may have a ``name``.  In place of ``force``
        or ``couple`` a load may have a ``table``: the places of the driver and the loads there.  A
        load may be a text, too: ``"80 N @ 150 at E on rocker"``, ``"-6 N m on rocker"``.
    masses
        By the name of a body: a mass in kg, at the point of the slide or the first point of the
        link; or ``{"mass": 2, "at": "G", "inertia": 0.01}`` with the moment of inertia about that
        point in kg·m², or a ``radius`` of gyration in the unit of lengths.
    gravity
        In m/s², along -y, or as x and y; without it weights are neglected.
    friction
        Coefficients by the names of slides.

    Raises
    ------
    vad.errors.InputError
        For a mechanism in space, and for what acts nowhere or is no number.

    Examples
    --------
    The slider-crank of a textbook (S. S. Rattan, Theory of Machines, ex. 12.1): 2 kN on the piston.

    >>> import vad
    >>> motion = vad.solve(vad.SliderCrank(crank=100, rod=450), angle=120)
    >>> found = vad.forces(motion, [{"at": "C", "force": "2 kN", "angle": 180}])
    >>> round(found.drive, 2), round(found.force("frame", "slider").imag, 2)
    (-153.59, 392.23)
    """
    if not isinstance(motion, Motion):
        raise InputError(
            f"motion: must be a motion, got {quoted(motion)}",
            "as in vad.forces(vad.solve(vad.FourBar()), loads)",
        )
    given = given_burden(loads, masses, gravity, friction)
    return forces_of(motion, motion.mechanism.burden or NOTHING, given)


def given_burden(
    loads: Iterable[Any],
    masses: Mapping[str, Any] | None,
    gravity: Any,
    friction: Mapping[str, Any] | None,
) -> Burden:
    """Return what is given to `forces`, after checking that there are lists and names.

    Raises
    ------
    vad.errors.InputError
        For anything else.
    """
    return Burden(
        listed_loads(loads), _by_name("masses", masses), gravity, _by_name("friction", friction)
    )


def forces_of(
    motion: Motion[Real, Vector, Truth], burden: Burden, more: Burden = NOTHING
) -> Forces[Real, Vector, Truth]:
    """Return the forces of a burden alone, and of more that comes to it.

    Raises
    ------
    vad.errors.InputError
        As for `forces`.
    """
    mechanism, plane = motion.mechanism, motion.solver
    if not isinstance(plane, Solver):
        raise InputError(
            f"forces: {mechanism.name} moves in space, and forces are found in the plane",
            "draw its velocity and acceleration; a mechanism in the plane is slider-crank",
        )
    both = burden.beside(more)
    motion.check_one()
    bodies, place = bodies_of(plane), next(iter(motion.inputs.values()))
    given = Given(bodies, mechanism.links, mechanism.slides, mechanism.length_unit, place)
    given.loads(both.loads)
    given.masses(both.masses, gravity_of(both.gravity))
    given.friction(both.friction)
    metres = metres_of(mechanism.length_unit) or 1.0
    solver = _solver(plane, tuple(given.acting), tuple(given.rough), metres)
    numbers = {name: given.numbers[name] for name in solver.further}
    return Forces(motion, solver, numbers, more)


def _by_name(what: str, given: Any) -> Mapping[str, Any]:
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        as_in = '{"slider": 25}' if what == "masses" else '{"slider": 0.1}'
        raise InputError(f"{what}: must be numbers by name, got {quoted(given)}", f"as in {as_in}")
    return given


@lru_cache(maxsize=64)
def _solver(
    plane: Solver, acting: tuple[Acting, ...], rough: tuple[str, ...], metres: float
) -> StaticSolver:
    return StaticSolver(plane, bodies_of(plane), acting, rough, metres)


#: How the results of a sweep are called: that of the drive, and the end of those of joints.
DRIVE, FORCE = "drive", ".force"


class JointForce(NamedTuple):
    """The force in a joint: of body ``one`` on body ``other``, at a point, as x + iy in newtons."""

    one: str
    other: str
    point: str
    force: Any


class Forces(Solution[Truth], Generic[Real, Vector, Truth]):
    """The forces in a motion; made by `forces`.

    Forces are in newtons, as complex numbers x + iy; couples in newton metres, counter-clockwise;
    where the unit of length is none, in newtons times that unit.  Those of many poses are arrays,
    NaN where the links do not close, at a dead centre, and where friction leaves no equilibrium.

    Attributes
    ----------
    motion
        The motion.
    burden
        What was given beside what its mechanism has to bear of its own.
    """

    solver: StaticSolver

    def __init__(
        self,
        motion: Motion[Real, Vector, Truth],
        solver: StaticSolver,
        numbers: dict[str, Number],
        burden: Burden = NOTHING,
    ) -> None:
        self.motion = motion
        self.burden = burden
        super().__init__(motion.mechanism, solver, {**motion.inputs, **numbers})

    @property
    def bodies(self) -> Bodies:
        """The bodies, their joints, and the dyads in which the forces are found."""
        return self.solver.tree

    @property
    def acting(self) -> tuple[Acting, ...]:
        """All that acts: loads, weights, inertia forces and couples; `acts` gives their values."""
        return self.solver.acting

    def acts(self, number: int) -> Any:
        """Return what acts: a force in newtons, or a couple in newton metres."""
        return self._of("acting", str(number))

    @property
    def drive(self) -> Real:
        """What must act on the driver: in N·m counter-clockwise, or in N along the driven slide.

        That on the rod of a driven cylinder acts on its barrel, too, the other way.
        """
        drive: Real = self._of("drive")
        return drive

    def force(self, one: str, other: str) -> Vector:
        """Return the force of the first body on the second one, through all their joints.

        The frame is the body ``"frame"``.  The force of a line on a block is square to the line:
        its friction is not in it, nor is the force that drives it.

        Raises
        ------
        vad.errors.UsageError
            For two bodies without a joint.
        """
        for name in (one, other):
            one_of("body", name, [FRAME, *self.bodies.bodies])
        total: Any = None
        for number in range(len(self.bodies.joints)):
            pair = self._pair(number)
            if {one, other} == {*pair}:
                found = self._of("reaction", str(number))
                found = found if pair == (one, other) else -found
                total = found if total is None else total + found
        if total is None:
            pairs = (self._pair(number) for number in range(len(self.bodies.joints)))
            beside = [b if a == one else a for a, b in pairs if one in (a, b)]
            message = f"force: {one} and {other} have no joint"
            raise UsageError(message, f"{one} has one with {' and with '.join(beside)}")
        force: Vector = total + 0.0
        return force

    @property
    def joints(self) -> tuple[JointForce, ...]:
        """The force in each joint, in the order of drawing: the last dyad first."""
        return tuple(
            JointForce(*self._pair(number), joint.point, self._of("reaction", str(number)))
            for number, joint in enumerate(self.bodies.joints)
        )

    @property
    def friction(self) -> tuple[JointForce, ...]:
        """The friction in each slide that has some: the force of its line on its block."""
        return tuple(
            JointForce(joint.one, joint.other, joint.point, self._of("rubbing", joint.slide.name))
            for joint in self.bodies.joints
            if joint.slide and joint.slide.name in self.solver.rough
        )

    @property
    def results(self) -> dict[str, Result]:
        """The drive and the force in each joint as results, by the names of a sweep's columns.

        Where two bodies have two joints, the first one has their name.
        """
        found: dict[str, Result] = {DRIVE: ("drive", "", self.solver.stage)}
        for number in range(len(self.bodies.joints)):
            name = ".".join(self._pair(number)) + FORCE
            found.setdefault(name, ("reaction", str(number), self.solver.stage))
        return found

    def _pair(self, number: int) -> tuple[str, str]:
        """Return the two bodies of a joint: the force is that of the first on the second."""
        joint = self.bodies.joints[number]
        child = next((b for b in self.bodies.bodies.values() if b.joint == joint), None)
        return (child.parent, child.name) if child else (joint.one, joint.other)

    def superposed(self) -> dict[str, Forces[Real, Vector, Truth]]:
        """Return the forces of each load alone and of each mass alone, whose sums are these forces.

        A load has its name, or else its number: "load 1".

        Raises
        ------
        vad.errors.InputError
            With friction, which depends on all loads together.
        """
        if self.solver.rough:
            raise InputError("forces: with friction they are not sums", "leave out the friction")
        groups: dict[str, set[str]] = {}
        for number, each in enumerate(self.acting, start=1):
            groups.setdefault(each.name or f"load {number}", {"gx", "gy"}).update(each.inputs)
        own = self.solver.further
        return {
            name: Forces(
                self.motion,
                self.solver,
                {each: self.inputs[each] if each in kept else 0.0 for each in own},
            )
            for name, kept in groups.items()
        }

    @property
    def dyads(self) -> tuple[DyadForces, ...]:
        """The forces of each dyad of one pose as they are drawn, the last dyad first."""
        return dyads_of(self)

    @property
    def shaking_force(self) -> Vector:
        """The force that the frame feels in all: loads, weights and inertia forces together."""
        force: Vector = self._of("shaking", "force")
        return force

    @property
    def shaking_moment(self) -> Real:
        """The moment of all that acts about the driver's pivot: what the frame feels in all.

        The reaction of the drive's couple on the frame is part of it.
        """
        moment: Real = self._of("shaking", "moment")
        return moment

    @property
    def power(self) -> tuple[Real, Real]:
        """The sum of the powers of the drive and of all that acts, in W, and that of their sizes.

        The first is zero but for rounding: this checks drive and loads by the motion alone.
        """
        return self._of("power", "sum"), self._of("power", "sizes")

    @property
    def mean_drive(self) -> Any:
        """The mean of the drive over a turn of the driver, which the last axis must hold."""
        return self._turning().mean

    @property
    def fluctuation(self) -> Any:
        """The greatest excess energy in a turn, in J: of the drive beyond its mean."""
        return self._turning().fluctuation

    def flywheel(self, ratio: float, speed: float | str) -> Any:
        """Return the moment of inertia, in kg·m², with which the speed fluctuates by a ratio.

        Parameters
        ----------
        ratio
            The coefficient of fluctuation: the difference of the greatest and the least speed,
            over the mean.
        speed
            The mean speed in rad/s, or as text with its unit: "500 rpm".
        """
        return self._turning().flywheel(ratio, number_of("speed", speed, "omega"))

    def _turning(self) -> Turning:
        name, place = next(iter(self.inputs.items()))
        if name != "angle":
            driver = self.bodies.driver.name
            raise InputError(
                f"forces: {driver} swings to and fro; mean drive, excess energy and flywheel are "
                "those of a driver that goes round by even turns"
            )
        if not np.ndim(place):
            raise InputError(
                "forces: a turn needs an array of angles of the driver",
                "as in vad.solve(mechanism, angle=numpy.linspace(0, 360, 361))",
            )
        return Turning(np.broadcast_to(place, self.shape), np.asarray(self.drive))

    def to_dict(self) -> dict[str, Any]:
        """Return the forces as ``vad solve --json`` has them under ``forces``."""
        return listed(self)

    def table(self, digits: int = DIGITS) -> str:
        """Return the forces of one pose as a table in plain text; digits as in `Motion.table`."""
        checked = gate.whole("digits", digits, 1, MOST_DIGITS)
        return table(self.to_dict(), self.bodies.driver.name, checked)

    @property
    def moment_unit(self) -> str:
        """The unit of couples: that of newtons times metres, or times a length without metres."""
        unit = self.mechanism.length_unit
        return f"N {unit}" if metres_of(unit) is None else "N m"

    @property
    def drive_unit(self) -> str:
        """The unit of the drive: that of a couple, or newtons for a driven slide."""
        return self.moment_unit if self.solver.driver.kind == "angle" else "N"

    def _of(self, kind: str, name: str = "") -> Any:
        stage = self.solver.stage
        if kind == "power" and stage == "static":
            stage = "rubbing"
        if kind in ("acting", "shaking"):
            stage = "dynamic" if self.solver.stage == "dynamic" else "static"
        if self.many and kind in ("drive", "reaction", "rubbing"):
            parts = self._all_at_once[kind, name]
            value = np.empty(parts[0].shape, float if len(parts) == 1 else complex)
            value.real = parts[0]
            if len(parts) > 1:
                value.imag = parts[1]
            return value.reshape(self.shape)
        return self.read((kind, name, stage))

    @cached_property
    def _all_at_once(self) -> dict[tuple[str, str], list[NDArray[np.float64]]]:
        """What holds many poses: one force costs little less than all of them."""
        names = [("drive", ""), *(("rubbing", slide) for slide in self.solver.rough)]
        names += [("reaction", str(number)) for number in range(len(self.bodies.joints))]
        found = self.read_apart([(*name, self.solver.stage) for name in names])
        return dict(zip(names, found, strict=True))

    def dead_centre(self) -> VadError:  # type: ignore[override]
        """Return why forces of a single pose do not exist."""
        if self.solver.is_dead(self.pose) or not self.solver.rough:
            return super().dead_centre()
        slides = self.velocity.sliding
        for slide in self.solver.rough:
            if slides[slide] == 0.0:
                return InputError(
                    f"friction: the {slide} stands still, so that its friction has no direction",
                    "with a speed, or at another place, it has one",
                )
        names = ", ".join(f"{self.inputs[number]:g}" for number in self.solver.rough.values())
        jammed = " and ".join(f"the {slide}" for slide in self.solver.rough)
        verb = "jams" if len(self.solver.rough) == 1 else "jam"
        return InputError(
            f"{jammed} {verb}: friction {names} leaves no equilibrium",
            "with less friction it moves",
        )
