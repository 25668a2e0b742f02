"""Where a mechanism can be assembled: the range of its driver, and how far its slides get.

The limits have closed forms where the driver alone moves a loop.  What other loops allow is asked
of the solver on a grid; between its points it is searched for where it comes nearest to a limit,
so that no range is too narrow to be found.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.any_solver import AnySolver
from vad.kinematics.closing.closures import OpenLoopError
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.numbers import cross
from vad.kinematics.solver import solver_of

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


# Farther than this from a limit nothing is hidden between two points of the grid: as the sine at
# which construction lines cross, or as a length by which the links miss, of the largest one.
_NEAR = 0.2
_STRIDE = 5  # the search takes one point of the grid in so many
_GOLDEN = 0.5 * (5**0.5 - 1.0)
_SECTIONS = 80


def closing_range(mechanism: Mechanism, samples: int = 3601) -> list[tuple[float, float]]:
    """Return the intervals of the driver's angle (degrees) or position that close.

    A full turn is ``[(0.0, 360.0)]``, an interval through 0° is written with a negative start,
    and an empty list means that the links close nowhere.

    Examples
    --------
    >>> from vad.mechanisms.four_bar import FourBar
    >>> closing_range(FourBar())
    [(0.0, 360.0)]
    >>> [(round(a, 2), round(b, 2)) for a, b in closing_range(FourBar(crank=130))]
    [(13.33, 120.25), (239.75, 346.67)]
    """
    return list(_ranges(mechanism, samples))


@lru_cache(maxsize=64)
def _ranges(mechanism: Mechanism, samples: int) -> tuple[tuple[float, float], ...]:
    solver = solver_of(mechanism)
    turns = solver.driver.kind == "angle"
    limit = 360.0 if turns else _farthest(solver.plane.frame)
    grid = np.linspace(0.0 if turns else -limit, limit, samples)
    edges = solver.limits()
    between = 0.5 * (edges[1:] + edges[:-1])
    grid = np.unique(np.concatenate([grid, edges, between]))
    grid = np.union1d(grid, _hidden(solver, grid[::_STRIDE]))
    closes = solver.closes(grid)
    if closes.all():
        return ((float(grid[0]), float(grid[-1])),)
    ends = [
        _edge(solver, float(grid[i]), float(grid[i + 1]), edges, 1e-15 * limit)
        for i in np.flatnonzero(closes[1:] != closes[:-1])
    ]
    if closes[0]:
        ends = [float(grid[0]), *ends]
    if closes[-1]:
        ends = [*ends, float(grid[-1])]
    if turns and closes[0]:  # the last interval runs on through 0°
        ends = [ends[-2] - 360.0, *ends[1:-2]]
    return tuple(zip(ends[::2], ends[1::2], strict=True))


@lru_cache(maxsize=64)
def travels(mechanism: Mechanism, samples: int = 721) -> Mapping[str, tuple[float, float]]:
    """Return the least and the greatest position of every slide over all poses that close.

    They are found on a grid of the driver's range, as finely as they are drawn; NaN where the
    links close nowhere on it.

    Examples
    --------
    >>> from vad.mechanisms.scotch_yoke import ScotchYoke
    >>> travels(ScotchYoke(crank=50))["block"]
    (-50.0, 50.0)
    """
    solver = solver_of(mechanism)
    ranges = [np.linspace(low, high, samples) for low, high in closing_range(mechanism)]
    places = np.concatenate([*ranges, [math.nan]])
    known = [places, *solver.recorded.order(0).many([places], places.size)]
    found = {}
    for name in solver.slides:
        (slid,) = solver.recorded.result(("slide", name, "position")).many(known, places.size)
        found[name] = float(np.fmin.reduce(slid)), float(np.fmax.reduce(slid))
    return found


def _farthest(frame: ReferenceFrame) -> float:
    """Return a position that no driven slide exceeds."""
    return sum(_sizes(frame)) / _steepness(frame)


def _sizes(frame: ReferenceFrame) -> list[float]:
    """Return the lengths of all bars in the user's unit, and how far fixed points and lines are."""
    lengths = [step.length for step in frame.steps if isinstance(step, Bar)]
    lengths += [frame.linkage.ground[1]] if frame.linkage.ground else []
    guides = [s for s in frame.steps if isinstance(s, Slide) and isinstance(s.along, float)]
    fixed = [*frame.places.values(), *(guide.origin for guide in guides)]
    lengths += [abs(point - frame.linkage.place) for point in fixed]
    return [abs(length) for length in lengths if isinstance(length, float)]


def _steepness(frame: ReferenceFrame) -> float:
    """Return the least sine between two guides: the flatter they cross, the farther they reach."""
    guides = [s for s in frame.steps if isinstance(s, Slide) and isinstance(s.along, float)]
    lines = [frame.line(guide, None) for guide in guides]
    sines = [abs(cross(p, q)) for p, q in combinations(lines, 2)]
    return min((sine for sine in sines if sine), default=1.0)


def _hidden(solver: AnySolver, grid: NDArray[np.float64]) -> list[float]:
    """Return places on the other side of a limit than both of their neighbours in the grid.

    They are looked for about each place that is nearer to a limit than its neighbours are.
    """
    loops = solver.searched
    if not loops:
        return []
    closes = solver.closes(grid)
    crossing = np.abs(solver.sines(grid)[loops]).min(axis=0)
    near = [
        s if c else _nearness(solver, x, loops)[1]
        for x, s, c in zip(grid, crossing, closes, strict=True)
    ]
    found = []
    for i in range(1, len(grid) - 1):
        alike = closes[i - 1] == closes[i] == closes[i + 1]
        if alike and near[i - 1] > near[i] <= near[i + 1] and near[i] < _NEAR:
            found += _beyond(solver, grid[i - 1], grid[i + 1], bool(closes[i]), loops)
    return found


def _nearness(solver: AnySolver, value: float, loops: list[int]) -> tuple[bool, float]:
    """Tell whether a place closes, and how near it is to where it just does."""
    try:
        pose = solver.positions(float(value))
    except OpenLoopError as gap:
        return False, gap.miss
    return True, min(abs(pose.sine[k]) for k in loops)


def _beyond(
    solver: AnySolver, low: float, high: float, closed: bool, loops: list[int]
) -> list[float]:
    """Return a place that closes where the ends do not, or the reverse, if there is one."""
    places = approach(solver, low, high, loops)
    return next(([place] for place, closes, _ in places if closes != closed), [])


def approach(
    solver: AnySolver, low: float, high: float, loops: list[int]
) -> Iterator[tuple[float, bool, float]]:
    """Yield places nearer and nearer to where some loops come nearest to a limit.

    They are found by golden section; with each comes whether it closes, and how near it is.
    """
    for _ in range(_SECTIONS):
        step = _GOLDEN * (high - low)
        inner, near = (high - step, low + step), []
        for place in inner:
            closes, distance = _nearness(solver, place, loops)
            yield place, closes, distance
            near.append(distance)
        low, high = (low, inner[1]) if near[0] < near[1] else (inner[0], high)


def _edge(
    solver: AnySolver, inside: float, outside: float, edges: NDArray[np.float64], tolerance: float
) -> float:
    """Return the limit between two values of which exactly one closes."""
    for end in (inside, outside):
        if end in edges:
            return end
    if not solver.closes(np.array([inside]))[0]:
        inside, outside = outside, inside
    middle = 0.5 * (inside + outside)
    while abs(outside - inside) > tolerance and middle not in (inside, outside):
        if solver.closes(np.array([middle]))[0]:
            inside = middle
        else:
            outside = middle
        middle = 0.5 * (inside + outside)
    return inside
