"""From a mechanism with its input to its loop equations, read off the declared loops alone."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from vad.errors import InputError
from vad.kinematics.linkage import (
    Bar,
    Linkage,
    Loop,
    Scalar,
    Slide,
    angle_of,
    length_of,
)
from vad.kinematics.space.space_linkage import BallJointed, FourAxes, SpaceLinkage
from vad.mechanisms import Mechanism
from vad.methods.loops_in_space import SpaceProblem
from vad.methods.problem import Jet, LoopEquation, Problem, Vector


def problem_of(mechanism: Mechanism, inputs: Mapping[str, float]) -> Problem | SpaceProblem:
    """Return the equations of a mechanism; inputs that are left out have their defaults.

    Raises
    ------
    vad.errors.InputError
        For a slot beside its pivot, or counted backward, which not every method knows.

    Examples
    --------
    >>> from vad.mechanisms.double_slider import DoubleSlider
    >>> (equation,) = problem_of(DoubleSlider(), {}).equations
    >>> for sign, length, angle, _ in equation.vectors:
    ...     print(f"{sign:+} ({length}) along ({angle})")
    -1 (the length of slider_a) along (0.0)
    -1 (1000.0) along (the angle of link)
    +1 (the length of slider_b) along (90.0)
    """
    linkage = mechanism.marked()
    drive = Jet(*({**mechanism.inputs, **inputs}[name] for name in mechanism.inputs))
    if not isinstance(linkage, Linkage):
        return SpaceProblem(mechanism, linkage.driver, drive, _largest(linkage), linkage)
    crossed = mechanism.assembly == "crossed"
    reader = _Reader(linkage, -1 if crossed else 1)
    equations = tuple(
        reader.equation(loop, unknowns)
        for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True)
    )
    lengths = [v.length for equation in equations for v in equation.vectors]
    size = max(abs(length) for length in lengths if isinstance(length, float))
    return Problem(mechanism, linkage.driver, drive, size, equations, reader.zeros)


def _largest(linkage: SpaceLinkage) -> float:
    """Return the largest length of a mechanism in space; 1 on a sphere."""
    if isinstance(linkage, BallJointed):
        return max(map(abs, (linkage.ground, linkage.crank, linkage.coupler, linkage.rocker)))
    if isinstance(linkage, FourAxes):
        arcs = linkage.ground, linkage.crank, linkage.coupler, linkage.rocker
        return max(abs(arc.length) for arc in arcs) or 1.0
    return 1.0


class _Place(NamedTuple):
    """Where a fixed point is: a number, and vectors to be added to it."""

    constant: complex
    vectors: tuple[Vector, ...] = ()

    def times(self, sign: int) -> _Place:
        return _Place(
            sign * self.constant, tuple(v._replace(sign=sign * v.sign) for v in self.vectors)
        )


class _Reader:
    """Reads loop after loop; the vector by which a link is found gives the link its axis."""

    def __init__(self, linkage: Linkage, side: int) -> None:
        self._places = _fixed_points(linkage)
        self._side = side
        self._axes: dict[str, complex] = {}
        self.zeros: dict[Scalar, float] = {}

    def equation(self, loop: Loop, unknowns: tuple[Scalar, ...]) -> LoopEquation:
        """Return second chain - first chain = 0."""
        places = self._places
        parts = [
            places.get(chain[0].start, _Place(0j)).times(sign)
            for sign, chain in ((-1, loop.first), (1, loop.second))
        ]
        vectors: list[Vector] = []
        for sign, step in loop.steps():
            if isinstance(step, Bar):
                vectors += self._bar(sign, step, loop, unknowns)
            elif isinstance(step.along, float):
                vectors.append(Vector(sign, length_of(step.name), step.along))
                if step.tail in places:  # the length is counted from the origin of the line
                    parts += [_Place(step.origin).times(sign), places[step.tail].times(-sign)]
        vectors += [vector for part in parts for vector in part.vectors]
        total = sum(part.constant for part in parts)
        side = 0 if loop.parallel else self._side * int(loop.side)
        return LoopEquation(complex(total), tuple(_without_opposites(vectors)), unknowns, side)

    def _bar(self, sign: int, bar: Bar, loop: Loop, unknowns: tuple[Scalar, ...]) -> list[Vector]:
        angle = angle_of(bar.link)
        if bar.against and angle in unknowns:
            bar = replace(bar, length=-float(bar.length), turn=-bar.turn)
        if angle in unknowns:
            self._axes[bar.link] = bar.turn
            self.zeros[angle] = cmath.phase(bar.turn)
        axis = self._axes.get(bar.link, 1.0 + 0j)
        turn = 1.0 + 0j if bar.turn == axis else bar.turn * axis.conjugate()
        if isinstance(bar.length, float):
            return [Vector(sign, bar.length, angle, _degrees(turn))]
        length = length_of(bar.length)
        if {angle, length} <= {*unknowns}:
            if bar.offset.imag or loop.side < 0.0:
                raise InputError(
                    f"{bar.link}: to be compared, its slot must pass through {bar.tail} and count "
                    f"from there towards {bar.head}"
                )
            self.zeros[length] = bar.offset.real
        offset = bar.offset - self.zeros.get(length, 0.0)
        found = [Vector(sign, length, angle, _degrees(turn))]
        if offset:
            found.append(Vector(sign, abs(offset), angle, _degrees(turn * offset)))
        return found


def _degrees(vector: complex) -> float:
    return math.degrees(cmath.phase(vector))


def _fixed_points(linkage: Linkage) -> dict[str, _Place]:
    places = {linkage.pivot: _Place(linkage.place)}
    if linkage.ground:
        letter, distance, degrees = linkage.ground
        places[letter] = _Place(linkage.place, (Vector(1, distance, degrees),))
    places |= {name: _Place(place) for name, place in linkage.fixed.items()}
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    moving = {step.head for step in steps}
    for step in steps:
        if isinstance(step, Slide) and isinstance(step.along, float) and step.tail not in moving:
            places.setdefault(step.tail, _Place(step.origin))
    return places


def _without_opposites(vectors: list[Vector]) -> list[Vector]:
    """Return the vectors without pairs that cancel."""
    kept: list[Vector] = []
    for vector in vectors:
        opposite = vector._replace(sign=-vector.sign)
        if opposite in kept:
            kept.remove(opposite)
        else:
            kept.append(vector)
    return kept
