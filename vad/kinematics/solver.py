"""Positions, velocities and accelerations of any linkage, order by order.

A `Solver` is a linkage made ready: lengths divided by a power of two, directions turned into the
frame of the ground link, each loop given its closed form.  Its three methods take the motion of
the driver and return what they found; the components of every step, which they add up, are the
same that the polygon builder draws.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.errors import DeadCentreError, InputError
from vad.kinematics import sweep
from vad.kinematics.closures import (
    AngleAndLength,
    GroundedCrank,
    Slot,
    TwoAngles,
    TwoLengths,
    crossing,
)
from vad.kinematics.linkage import (
    Bar,
    Linkage,
    Loop,
    Scalar,
    Slide,
    Step,
    angle_of,
    length_of,
    scalar_of,
)
from vad.kinematics.numbers import Number, direction, fold, is_array

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


@lru_cache(maxsize=64)
def solver_of(mechanism: Mechanism) -> Solver:
    """Return the solver of a mechanism, made once."""
    return Solver(mechanism.linkage(), 1.0 if mechanism.assembly == "open" else -1.0)


@dataclass(slots=True)
class Pose:
    """Unit vector of every link, length of every slide, and of every loop the sine at which its
    construction lines cross."""

    unit: dict[str, Number]
    length: dict[str, Number]
    sine: list[Number]

    def flat(self) -> dict[Any, Number]:
        """Return all values in one dictionary."""
        units = {angle_of(name): value for name, value in self.unit.items()}
        lengths = {length_of(name): value for name, value in self.length.items()}
        return units | lengths | dict(enumerate(self.sine))

    @classmethod
    def of(cls, values: dict[Any, Number]) -> Pose:
        """Return the pose whose `flat` is ``values``."""
        pose = cls({}, {}, [])
        for key, value in values.items():
            if isinstance(key, Scalar):
                (pose.unit if key.kind == "angle" else pose.length)[key.name] = value
            else:
                pose.sine.append(value)
        return pose

    def cut(self, part: slice) -> Pose:
        """Return the poses in ``part``."""
        return Pose(
            sweep.cut(self.unit, part),
            sweep.cut(self.length, part),
            list(sweep.cut(dict(enumerate(self.sine)), part).values()),
        )


@dataclass(slots=True)
class Rates:
    """First or second derivatives: of every link's angle and of every slide's length."""

    turning: dict[str, Number]
    sliding: dict[str, Number]

    def flat(self) -> dict[Scalar, Number]:
        """Return all values in one dictionary."""
        turning = {angle_of(name): value for name, value in self.turning.items()}
        return turning | {length_of(name): value for name, value in self.sliding.items()}

    @classmethod
    def of(cls, values: dict[Scalar, Number]) -> Rates:
        """Return the rates whose `flat` is ``values``."""
        rates = cls({}, {})
        for key, value in values.items():
            (rates.turning if key.kind == "angle" else rates.sliding)[key.name] = value
        return rates

    def cut(self, part: slice) -> Rates:
        """Return the rates of the poses in ``part``."""
        return Rates(sweep.cut(self.turning, part), sweep.cut(self.sliding, part))


@dataclass(frozen=True, slots=True)
class Component:
    """One part of a step's velocity or acceleration: ``amount`` along ``direction``.

    ``name`` is the textbook's: normal, tangential, coriolis or sliding.  An ``amount`` of None
    stands for the unknown one, of which only the direction is known yet.
    """

    name: str
    direction: Number
    amount: Number | None


class LoopSolver:
    """One loop of a linkage with its closed form."""

    def __init__(self, solver: Solver, loop: Loop, unknowns: tuple[Scalar, ...]) -> None:
        self._solver = solver
        # Bars before slides, as the closed forms take them.
        self.unknown = sorted(
            {scalar_of(step): (way, step) for way, step in loop.steps() if scalar_of(step) in unknowns}.values(),
            key=lambda found: isinstance(found[1], Slide),
        )
        scalars = {scalar_of(step) for _, step in self.unknown}
        self.known = [(way, step) for way, step in loop.steps() if scalar_of(step) not in scalars]
        ends = [chain[0].ends[-1 if chain[0].reverse else 0] for chain in (loop.first, loop.second)]
        fixed = solver.fixed
        self.offset = 0j if ends[0] == ends[1] else fixed[ends[1]] - fixed[ends[0]]
        self.offset += sum(
            way * solver.shift(step) for way, step in loop.steps() if isinstance(step, Slide)
        )
        self._crank = self._grounded_crank()
        self._prepare()

    def _grounded_crank(self) -> GroundedCrank | None:
        solver = self._solver
        if len(self.known) != 1:
            return None
        way, bar = self.known[0]
        if not isinstance(bar, Bar) or angle_of(bar.link) != solver.linkage.driver:
            return None
        return GroundedCrank(self.offset, way * solver.size(bar))

    def _prepare(self) -> None:
        solver, (first, second) = self._solver, self.unknown
        (way, bar), (slide_way, other) = first, second
        crank = self._crank
        on_axis = crank if crank and crank.c.imag == 0.0 else None
        if isinstance(other, Bar):
            if (way, slide_way) != (-1, 1):
                raise InputError("each of a loop's two chains must end with one unknown bar")
            fixed = isinstance(bar.length, float) and isinstance(other.length, float)
            sizes = (solver.size(bar), solver.size(other)) if fixed else (0.0, 0.0)
            self._closure: Any = TwoAngles(solver.side, on_axis if fixed else None, *sizes)
        elif isinstance(bar, Slide):
            self._closure = TwoLengths()
        elif bar.length == other.name:
            self._crank = on_axis
            self._closure = Slot()
        else:
            if crank:
                crank = GroundedCrank(-way * crank.c, -way * crank.t)
            guide = -way * slide_way * solver.line(other, None)
            self._closure = AngleAndLength(solver.side, crank, solver.size(bar), guide)

    def close(self, pose: Pose) -> None:
        """Find the two unknowns of the position and write them into ``pose``."""
        solver, ((way, step), (other_way, other)) = self._solver, self.unknown
        driver = solver.linkage.driver
        u = pose.unit.get(driver.name)
        gap: Number
        if self._crank is not None:
            gap = self._crank.gap(u)
        else:
            gap = self.offset
            for sense, known in self.known:
                gap = gap + sense * solver.displacement(known, pose)
        if isinstance(other, Bar):
            sizes = (solver.size(step, pose), solver.size(other, pose))
            pose.unit[step.link], pose.unit[other.link], sine = self._closure.close(gap, u, *sizes)
        elif isinstance(step, Slide):
            lines = way * solver.line(step, pose), -other_way * solver.line(other, pose)
            pose.length[step.name], pose.length[other.name], sine = self._closure.close(-gap, *lines)
        elif isinstance(self._closure, Slot):
            pose.unit[step.link], pose.length[other.name], sine = self._closure.close(-way * gap)
        else:
            found = self._closure.close(-way * gap, u, solver.size(step))
            pose.unit[step.link], pose.length[other.name], sine = found
        pose.sine.append(sine)

    def cross(self, pose: Pose, rates: tuple[Rates, ...], sine: Number) -> None:
        """Find the two unknown rates of the highest order and write them into ``rates[-1]``."""
        solver = self._solver
        total: Number = 0.0
        for way, step in (*self.known, *self.unknown):
            for part in solver.components(step, pose, rates):
                if part.amount is not None:
                    total = total + (way * part.amount) * part.direction
        (way, step), (other_way, other) = self.unknown
        p = way * solver.unknown_direction(step, pose)
        q = -other_way * solver.unknown_direction(other, pose)
        if isinstance(self._closure, Slot):
            sine = float(way * other_way)
        x, y = crossing(-total, p, q, sine)
        for value, found in ((x, step), (y, other)):
            if isinstance(found, Bar):
                rates[-1].turning[found.link] = value / self._turning_radius(found, pose)
            else:
                rates[-1].sliding[found.name] = value

    def _turning_radius(self, bar: Bar, pose: Pose) -> Number:
        radius = self._solver.size(bar, pose)
        if isinstance(self._closure, Slot):
            if is_array(radius):
                return np.where(radius == 0.0, np.nan, radius)
            if radius == 0.0:
                raise DeadCentreError(
                    f"{bar.link}: its pin {bar.ends[1]} stands on its pivot {bar.ends[0]}, where "
                    f"{bar.link} may point anywhere"
                )
        return radius


class Solver:
    """A linkage made ready for solving.

    Parameters
    ----------
    linkage
        The loops.
    side
        +1.0 for the open assembly, -1.0 for the crossed one.
    """

    def __init__(self, linkage: Linkage, side: float) -> None:
        self.linkage = linkage
        self.side = side
        #: Lengths are solved in this unit, a power of two, which changes no bit of a ratio.
        self.scale = _power_of_two(linkage)
        self.frame = fold(linkage.frame)
        self.turn = direction(self.frame)
        self.fixed = {linkage.pivot: 0j}
        if linkage.ground:
            self.fixed[linkage.ground[0]] = complex(linkage.ground[1] / self.scale)
        steps = [step for loop in linkage.loops for _, step in loop.steps()]
        self.steps = (*steps, *linkage.images)
        moving = {step.ends[1] for step in steps}
        for step in steps:
            if isinstance(step, Slide) and isinstance(step.along, float):
                tail = step.ends[0]
                if tail not in moving and tail not in self.fixed and step.origin is not None:
                    self.fixed[tail] = self._inward(step.origin)
        self._lines = {
            step.name: direction(fold(step.along - self.frame))
            for step in steps
            if isinstance(step, Slide) and isinstance(step.along, float)
        }
        self.loops = [
            LoopSolver(self, loop, unknowns)
            for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
        ]

    def _inward(self, point: complex) -> complex:
        return point / self.scale * self.turn.conjugate()

    def shift(self, slide: Slide) -> complex:
        """Return the vector from the tail of a slide to the zero of its line."""
        tail = slide.ends[0]
        if not isinstance(slide.along, float) or tail not in self.fixed:
            return 0j
        return self._inward(slide.origin) - self.fixed[tail]

    def size(self, bar: Bar, pose: Pose | None = None) -> Number:
        """Return the length of a bar in the solver's unit."""
        if isinstance(bar.length, str):
            return pose.length[bar.length] if pose else math.nan
        return bar.length / self.scale

    def line(self, slide: Slide, pose: Pose | None) -> Number:
        """Return the unit vector along which a slide slides."""
        if isinstance(slide.along, str):
            return pose.unit[slide.along] if pose else math.nan
        return self._lines[slide.name]

    def displacement(self, step: Step, pose: Pose) -> Number:
        """Return the vector from tail to head, less a slide's shift.

        On a turning link that is zero: there the bar carries the length.
        """
        if isinstance(step, Bar):
            return self.size(step, pose) * pose.unit[step.link]
        if isinstance(step.along, str):
            return 0.0
        return pose.length[step.name] * self.line(step, pose)

    def unknown_direction(self, step: Step, pose: Pose) -> Number:
        """Return the unit vector of the component that the driver does not dictate: across a
        bar, along a slide."""
        return 1j * pose.unit[step.link] if isinstance(step, Bar) else self.line(step, pose)

    def components(
        self, step: Step, pose: Pose, rates: tuple[Rates, ...]
    ) -> Iterator[Component]:
        """Yield the parts of a step's velocity (one order in ``rates``) or acceleration (two).

        With u the unit vector and r the length, the derivatives of r·u are
        ṙ·u + ωr·iu and r̈·u - ω²r·u + αr·iu + 2ωṙ·iu.
        """
        *lower, last = rates
        if isinstance(step, Bar):
            unit, size = pose.unit[step.link], self.size(step, pose)
            if lower:
                omega = lower[0].turning[step.link]
                yield Component("normal", -unit, omega * omega * size)
            rate = last.turning.get(step.link)
            yield Component("tangential", 1j * unit, None if rate is None else rate * size)
            return
        line = self.line(step, pose)
        if lower and isinstance(step.along, str):
            twist = 2.0 * lower[0].turning[step.along] * lower[0].sliding[step.name]
            yield Component("coriolis", 1j * line, twist)
        yield Component("sliding", line, last.sliding.get(step.name))

    def positions(self, value: Number) -> Pose:
        """Solve all loops for the driver's angle (degrees) or length."""
        pose = Pose({}, {}, [])
        driver = self.linkage.driver
        if driver.kind == "angle":
            angle = fold(value)
            if self.frame:
                angle = fold(angle - self.frame)
            pose.unit[driver.name] = direction(angle)
        else:
            pose.length[driver.name] = value / self.scale
        for loop in self.loops:
            loop.close(pose)
        return pose

    def rates(self, pose: Pose, lower: tuple[Rates, ...], value: Number) -> Rates:
        """Solve all loops for the driver's rate, of the order after those in ``lower``.

        Raises
        ------
        DeadCentreError
            For a single pose at a dead centre; in arrays its rates are NaN.
        """
        driver = self.linkage.driver
        if driver.kind == "angle":
            found = Rates({driver.name: value}, {})
        else:
            found = Rates({}, {driver.name: value / self.scale})
        for loop, sine in zip(self.loops, pose.sine, strict=True):
            if is_array(sine):
                # A copy only where there is a dead centre: division must not meet a zero.
                dead = sine == 0.0
                if dead.any():
                    sine = np.where(dead, np.nan, sine)
            elif sine == 0.0:
                raise DeadCentreError(_dead_centre(loop.unknown))
            loop.cross(pose, (*lower, found), sine)
        return found


def _power_of_two(linkage: Linkage) -> float:
    sizes = [step.length for loop in linkage.loops for _, step in loop.steps() if isinstance(step, Bar)]
    sizes += [bar.length for bar in linkage.images]
    if linkage.ground:
        sizes.append(linkage.ground[1])
    largest = max((abs(size) for size in sizes if isinstance(size, float)), default=1.0)
    return 2.0 ** math.frexp(largest)[1]


def _dead_centre(unknown: list[tuple[int, Step]]) -> str:
    names = " and ".join(
        step.link if isinstance(step, Bar) else step.name for _, step in unknown
    )
    return f"dead centre: the construction lines of {names} are parallel and do not cross"
