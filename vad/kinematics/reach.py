"""Where a mechanism closes: the range of its driver, the travel of its slides, its change points.

Where the driver alone moves a loop, its limits have closed forms.  The limits of other loops are
searched for: on a grid, and between the points of the grid where the links come nearest to a
limit, so that no range is too narrow to be found.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.errors import InputError
from vad.kinematics.any_solver import AnySolver
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.loop_kinds import ParallelLoop
from vad.kinematics.numbers import cross, positive
from vad.kinematics.solver import Solver, solver_of

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


# Two points of the grid can hide a limit between them only if they are nearer to it than this.  The
# measure is the sine at which construction lines cross, or the length by which the links miss, in
# the solver's unit.
_NEAR = 0.2
_STRIDE = 5  # the search takes every fifth point of the grid
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
    """Return a length that the position of a driven slide never exceeds."""
    return sum(_sizes(frame)) / _steepness(frame)


def _sizes(frame: ReferenceFrame) -> list[float]:
    """Return the lengths of all bars, and the distances of fixed points and lines."""
    lengths = [step.length for step in frame.steps if isinstance(step, Bar)]
    lengths += [frame.linkage.ground[1]] if frame.linkage.ground else []
    guides = [s for s in frame.steps if isinstance(s, Slide) and isinstance(s.along, float)]
    fixed = [*frame.places.values(), *(guide.origin for guide in guides)]
    lengths += [abs(point - frame.linkage.place) for point in fixed]
    return [abs(length) for length in lengths if isinstance(length, float)]


def _steepness(frame: ReferenceFrame) -> float:
    """Return the least sine between two guides: a slide gets far where guides cross flat."""
    guides = [s for s in frame.steps if isinstance(s, Slide) and isinstance(s.along, float)]
    lines = [frame.line(guide, None) for guide in guides]
    sines = [abs(cross(p, q)) for p, q in combinations(lines, 2)]
    return min((sine for sine in sines if sine), default=1.0)


def _hidden(solver: AnySolver, grid: NDArray[np.float64]) -> list[float]:
    """Return places beyond a limit that the grid does not show: both neighbours are on one side.

    They are searched for around each place that is nearer to a limit than its neighbours are.
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
    """Return a place that closes though both ends do not, or the reverse, if there is one."""
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
    """Return the limit between two places of which exactly one closes."""
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


# A sine counts as zero below this: it belongs to lengths that are equal to the square of it.
_FLAT = 1e-6
_SAMPLES = 721
# A change point this near to another, as a part of the range, is the same.
_SAME = 1e-6


class ChangePoint(NamedTuple):
    """A place of the driver at which a loop folds flat and two motions go on from there.

    Attributes
    ----------
    place
        The driver's angle in degrees within [0, 360), or its position.
    loop
        The number of the loop, from 0.
    parallel
        Whether the loop is a parallelogram, and can be told to stay one.
    """

    place: float
    loop: int
    parallel: bool

    def words(self, unit: str) -> str:
        """Return the sentence about it; ``unit`` is that of the driver's place.

        Examples
        --------
        >>> ChangePoint(180.0, 0, True).words("°")
        'change point at 180°: two motions are possible; say parallel'
        """
        say = "; say parallel" if self.parallel else ""
        return f"change point at {self.place:.6g}{unit}: two motions are possible{say}"


@lru_cache(maxsize=64)
def change_points(mechanism: Mechanism) -> tuple[ChangePoint, ...]:
    """Return the change points within the range that closes, by loop and place.

    A loop that is declared `parallel` has none, because it stays a parallelogram.

    Examples
    --------
    >>> from vad.mechanisms.four_bar import FourBar
    >>> [(point.place, point.parallel) for point in change_points(FourBar(100, 40, 100, 40))]
    [(0.0, True), (180.0, True)]
    >>> change_points(FourBar(100, 40, 100, 40, assembly="parallel"))
    ()
    """
    solver = solver_of(mechanism)
    if not isinstance(solver, Solver):
        return ()
    found: list[ChangePoint] = []
    for number, loop in enumerate(solver.loops):
        if not loop.two_ways or loop.loop.parallel:
            continue
        parallel = _can_be_parallel(solver, number)
        places: list[float] = []
        for low, high in closing_range(mechanism):
            for place in _flat_places(solver, number, low, high):
                if all(abs(place - other) > _SAME * (high - low) for other in places):
                    places.append(place)
        found += [ChangePoint(place, number, parallel) for place in sorted(places)]
    return tuple(found)


def _flat_places(solver: Solver, number: int, low: float, high: float) -> Iterator[float]:
    """Yield the places within a range at which the sine of a loop touches zero."""
    turns = solver.linkage.driver.kind == "angle"
    exact = solver.limits()
    grid = np.union1d(np.linspace(low, high, _SAMPLES), exact)
    grid = grid[(grid >= low) & (grid <= high)]
    if turns and high - low == 360.0:  # the first place follows the last one
        grid = np.concatenate([grid, grid[1:2] + 360.0])
    sines = np.abs(solver.sines(grid)[number])
    for i in range(1, len(grid) - 1):
        if not sines[i - 1] > sines[i] <= sines[i + 1]:
            continue
        place, sine = grid[i], sines[i]
        for other, closes, near in approach(solver, grid[i - 1], grid[i + 1], [number]):
            if closes and near < sine:
                place, sine = other, near
        if sine < _FLAT:
            marks = np.append(exact, 0.0)  # symmetry puts change points at zero, too
            same = marks[np.abs(marks - place) < _SAME * (high - low)]
            place = same[0] if same.size else place
            yield float(positive(place - 360.0 * (place >= 360.0)) if turns else place)


def _can_be_parallel(solver: Solver, number: int) -> bool:
    """Tell whether a loop is a parallelogram."""
    linkage = solver.linkage
    loop = replace(linkage.loops[number], parallel=True)
    try:
        ParallelLoop(solver.frame, 1.0, loop, linkage.unknowns[number])
    except InputError:
        return False
    return True
