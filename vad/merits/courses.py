"""How a result runs over the range of the driver, and where it is least and largest.

Between the places of a grid stand the roots of the exact derivative, each to the last bit.  So what
is least or largest is found where it is, and not at the nearest place of a grid.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import AnySolver, Result
from vad.kinematics.derivative import derivative
from vad.kinematics.numbers import sqrt
from vad.kinematics.program import Program
from vad.kinematics.reach import crossings, grid_between
from vad.kinematics.recording import Operand

Array = NDArray[np.float64]
Ends = tuple[float, float]

_TURN = 360.0
#: A place nearer to 0° or 360° than this is 0: it is as far from there as roots are rounded.
_ROUNDED = 1e-12
#: The places of a whole turn, and one step more: the last place follows the first one.
_STEPS = 1440
#: Places beside an end, as shares of the range.  What grows from each to the next by more than this
#: factor has no bound there: a rate near a dead centre grows at least as the root of the distance.
#: Where links nearly have a change point, it grows only so near to the end.
_BESIDE, _GROWS = np.array([1e-9, 3e-11, 1e-12]), 3.0


class Extremes(NamedTuple):
    """The least and the largest value of a result, and the places of the driver where they occur.

    A value is None where the result grows beyond all bounds; the place is then that dead centre.
    """

    least: float | None
    least_at: float
    largest: float | None
    largest_at: float


@dataclass(frozen=True)
class Piece:
    """A result over one range of the driver.

    Attributes
    ----------
    places, values
        Places in order, with all places at which it turns back, and the values there.
    turning
        The places at which it turns back.
    boundless
        The ends of the range at which it grows beyond all bounds, each with its sign there.
    whole
        Whether the range is a whole turn.
    turns
        Whether the values are angles, which run on beyond 360.
    driver_turns
        Whether the places are angles, of a driver that turns.
    """

    places: Array
    values: Array
    turning: Array
    boundless: tuple[tuple[float, float], ...]
    whole: bool
    turns: bool
    driver_turns: bool


def part_of(solver: AnySolver, result: Result, axis: str = "") -> Operand:
    """Return a result as one recorded number: itself, one axis of a vector, or a vector's size."""
    parts = solver.recorded.parts(result)
    if len(parts) == 1:
        return parts[0]
    if axis:
        return parts["xyz".index(axis)]
    return sqrt(sum(part * part for part in parts))


def pieces(
    solver: AnySolver, ranges: Sequence[Ends], inputs: Sequence[float], part: Operand, turns: bool
) -> list[Piece]:
    """Return how a number runs over each range of the driver.

    Parameters
    ----------
    solver
        The solver.
    ranges
        The ranges that close.
    inputs
        The driver's place, which does not matter, and its two rates, which are the same everywhere.
    part
        The number, recorded.
    turns
        Whether it is an angle in degrees, which runs on beyond 360.
    """
    given = list(solver.recorded.inputs[: len(inputs)])
    value, slope = Program(given, [part]), Program(given, [derivative(part, given[0])])

    def measured(program: Program, places: Array) -> Array:
        (found,) = program.many([places, *inputs[1:]], places.size)
        return np.where(np.isfinite(found), found, math.nan)

    found = []
    angle = solver.driver.kind == "angle"
    for low, high in ranges:
        whole = high - low == _TURN and angle
        grid = _turn(low) if whole else grid_between(low, high)
        turning = crossings(lambda places: measured(slope, places), grid)
        if whole:
            turning = np.where(turning > high - _ROUNDED, turning - _TURN, turning)
            grid = grid[:-1]
        turning = np.unique(_about_zero(turning))
        places = np.union1d(_about_zero(grid) if angle else grid, turning)
        values = measured(value, places)
        grows = [] if whole else [_boundless(measured, value, low, high, end) for end in (0, 1)]
        run_on = _unwrapped(values) if turns else values
        ends = tuple(filter(None, grows))
        found.append(Piece(places, run_on, turning, ends, whole, turns, angle))
    return found


def extremes(found: Sequence[Piece]) -> Extremes | None:
    """Return the least and the largest value; None where there is no value at all.

    The place of a driver that turns is an angle from 0 to 360.
    """
    chosen: list[tuple[float | None, float]] = []
    for sign in (-1.0, 1.0):
        beyond = [place for piece in found for place, way in piece.boundless if way == sign]
        best = [
            (sign * float(piece.values[at]), float(piece.places[at]))
            for piece in found
            if np.isfinite(piece.values).any()
            for at in [int(np.nanargmax(sign * piece.values))]
        ]
        if not best:
            return None
        size, place = max(best, key=lambda each: each[0])
        value, at = (None, beyond[0]) if beyond else (sign * size + 0.0, place)
        turned = any(piece.driver_turns for piece in found)
        chosen.append((value, at % _TURN % _TURN if turned else at))
    return Extremes(*chosen[0], *chosen[1])


def _boundless(
    measured: Callable[[Program, Array], Array], value: Program, low: float, high: float, end: int
) -> tuple[float, float] | None:
    """Return an end at which a number grows beyond all bounds, with its sign there."""
    if not high > low:
        return None
    beside: Array = (high - low) * _BESIDE
    sizes = measured(value, high - beside if end else low + beside)
    if (np.abs(sizes[1:]) > _GROWS * np.abs(sizes[:-1])).all():  # never where it is not known
        return (high if end else low), math.copysign(1.0, float(sizes[-1]))
    return None


def _about_zero(places: Array) -> Array:
    """Return places, with 0 for one that only rounding tells from it."""
    return np.where(np.abs(places) < _ROUNDED, 0.0, places)


def _turn(low: float) -> Array:
    return np.linspace(low, low + _TURN + _TURN / _STEPS, _STEPS + 2)


def _unwrapped(values: Array) -> Array:
    """Return angles that run on beyond 360; what is not known stays so."""
    known = np.isfinite(values)
    run_on = values.copy()
    run_on[known] = np.unwrap(values[known], period=_TURN)
    return run_on
