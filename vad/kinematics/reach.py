"""Where a mechanism closes: the range of its driver, the travel of its slides, its change points.

Where the driver alone moves a loop, its limits have closed forms.  The limits of other loops are
searched for on a grid between the limits that are known, one loop after another, and between the
points of the grid wherever the chains come nearest to a limit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import combinations, compress, pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.errors import InputError
from vad.kinematics.any_solver import AnySolver
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.loop_kinds import ParallelLoop, loop_solver
from vad.kinematics.numbers import cross, positive
from vad.kinematics.solver import Solver, solver_of

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

Array = NDArray[np.float64]

# The points of the grid between two limits that are known.
_POINTS = 1441
# What is found on the grid is narrowed down: its neighbourhood is cut into so many parts, and the
# best of them again, until what is left is below the last bit of a double.
_PARTS = np.linspace(0.0, 1.0, 17)
_SECTIONS = 12


def closing_range(mechanism: Mechanism) -> list[tuple[float, float]]:
    """Return the intervals of the driver's angle (degrees) or position that close.

    A full turn is ``[(0.0, 360.0)]``, an interval through 0° is written with a negative start,
    and an empty list means that the links close nowhere.  Limits of the driver itself have closed
    forms.  Between two of them a search finds every gap and every piece that is wider than a
    thousandth, and narrower ones where the links come nearest to a limit but once around them.

    Examples
    --------
    >>> from vad.mechanisms.four_bar import FourBar
    >>> closing_range(FourBar())
    [(0.0, 360.0)]
    >>> [(round(a, 2), round(b, 2)) for a, b in closing_range(FourBar(crank=130))]
    [(13.33, 120.25), (239.75, 346.67)]
    """
    return list(_ranges(mechanism))


@lru_cache(maxsize=64)
def _ranges(mechanism: Mechanism) -> tuple[tuple[float, float], ...]:
    solver = solver_of(mechanism)
    marks = _first_marks(solver)
    for loop in range(len(solver.searched)):
        marks = np.union1d(marks, _limits(solver, loop, marks))
    # Between two marks nothing changes.  A mark itself may close where its neighbourhood does not.
    between = solver.closes(0.5 * (marks[1:] + marks[:-1]))
    pieces = list(compress(pairwise(marks.tolist()), between))
    pieces += [(mark, mark) for mark in marks[solver.closes(marks)].tolist()]
    joined: list[tuple[float, float]] = []
    for low, high in sorted(pieces):
        if joined and low <= joined[-1][1]:
            joined[-1] = joined[-1][0], max(high, joined[-1][1])
        else:
            joined.append((low, high))
    if solver.driver.kind == "angle" and len(joined) > 1 and joined[0][0] == 0.0:
        (_, first), *others, (last, _) = joined  # the last interval runs on through 0°
        joined = [(last - 360.0, first), *others]
    return tuple(joined)


def _first_marks(solver: AnySolver) -> Array:
    """Return the limits in closed form, and the ends between which others are searched for.

    These are the ends of a turn, or the outermost limits of the driven slide: all limits in closed
    form of a slide bound it on both sides.  Without such limits, a driven slide is followed as far
    as the lengths and the directions of the guides let expect a limit.
    """
    limits = solver.limits()
    if solver.driver.kind == "angle":
        return np.union1d(limits, [0.0, 360.0])
    if limits.size:
        return limits
    frame = solver.plane.frame
    size = sum(_sizes(frame))
    return np.array([-size / _steepness(frame), -size, size, size / _steepness(frame)])


@lru_cache(maxsize=64)
def slide_travels(mechanism: Mechanism, samples: int = 721) -> Mapping[str, tuple[float, float]]:
    """Return the least and the greatest position of every slide over all poses that close.

    They are found on a grid of the driver's range, as finely as they are drawn; NaN where the
    links close nowhere on it.

    Examples
    --------
    >>> from vad.mechanisms.scotch_yoke import ScotchYoke
    >>> slide_travels(ScotchYoke(crank=50))["block"]
    (-50.0, 50.0)
    """
    solver = solver_of(mechanism)
    ranges = [np.linspace(low, high, samples) for low, high in closing_range(mechanism)]
    places = np.concatenate([*ranges, [math.nan]])
    slides = sorted(solver.slides)
    program = solver.recorded.program(tuple(("slide", name, "position") for name in slides))
    _, *slid = program.many([places], places.size)
    least, greatest = (map(float, map(end, slid)) for end in (np.fmin.reduce, np.fmax.reduce))
    return dict(zip(slides, zip(least, greatest, strict=True), strict=True))


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


def grid_between(low: float, high: float) -> Array:
    """Return places between two limits, close together near both of them.

    Near a limit what a loop moves goes as the square root of the distance from it.  On this grid
    it moves by nearly equal steps.
    """
    share = np.sin(np.linspace(0.0, 0.5 * math.pi, _POINTS)) ** 2
    return low + (high - low) * share


def _limits(solver: AnySolver, loop: int, marks: Array) -> list[float]:
    """Return the limits of a searched loop between the marks, which are those of others.

    No piece that closes, and no gap, is left out that is wider than a step of the grid, and none in
    which the chains come nearest to a limit but once within two steps of the grid.
    """

    def misses(places: Array) -> Array:
        return solver.misses(places)[loop]

    ends = (crossings(misses, grid_between(low, high)) for low, high in pairwise(marks))
    return [place for found in ends for place in found.tolist()]


Measure = Callable[[Array], Array]


def crossings(measure: Measure, grid: Array) -> Array:
    """Return the places, along a grid, at which a measure goes from ≤ 0 to > 0 or back.

    Each is narrowed down to the last bit, from the side on which the measure is not positive.  None
    is left out between which there is a point of the grid, nor any pair where the measure comes
    nearest to zero but once within two steps of the grid.
    """
    measured = measure(grid)
    beyond = _beyond(measure, grid, measured)
    if beyond.size:
        grid = np.union1d(grid, beyond)
        measured = measure(grid)
    below, above = measured <= 0.0, measured > 0.0  # neither where it is not known
    (ends,) = np.nonzero(below[:-1] & above[1:])
    (starts,) = np.nonzero(above[:-1] & below[1:])
    inside = np.concatenate([grid[ends], grid[starts + 1]])
    outside = np.concatenate([grid[ends + 1], grid[starts]])
    return _edges(measure, inside, outside)


def _beyond(misses: Measure, grid: Array, miss: Array) -> Array:
    """Return places beyond a limit that the grid does not show: all around is on one side of it.

    They are searched for around each point that is nearer to a limit than its neighbours are.
    """
    around = np.pad(miss, 1, mode="edge")
    distance = np.abs(around)
    nearest = (distance[:-2] >= distance[1:-1]) & (distance[1:-1] <= distance[2:])
    closes = miss <= 0.0
    alike = ((around[:-2] <= 0.0) == closes) & (closes == (around[2:] <= 0.0))
    (at,) = np.nonzero(nearest & alike)
    low, high = grid[np.maximum(at - 1, 0)], grid[np.minimum(at + 1, len(grid) - 1)]
    found = [np.empty(0)]
    for places, beyond in approach(misses, low, high):
        changed = np.where(closes[at][:, None], beyond > 0.0, beyond <= 0.0)
        found.append(places[changed])
    return np.concatenate(found)


def approach(measure: Measure, low: Array, high: Array) -> Iterator[tuple[Array, Array]]:
    """Yield places in some intervals, as rows, nearer and nearer to where a measure is zero.

    What is measured there comes with them.
    """
    for _ in range(_SECTIONS if low.size else 0):
        places = low[:, None] + (high - low)[:, None] * _PARTS
        measured = measure(places.ravel()).reshape(places.shape)
        yield places, measured
        best = np.where(np.isnan(measured), math.inf, np.abs(measured)).argmin(axis=1)
        rows = np.arange(len(best))
        low = places[rows, np.maximum(best - 1, 0)]
        high = places[rows, np.minimum(best + 1, len(_PARTS) - 1)]


def _edges(misses: Measure, inside: Array, outside: Array) -> Array:
    """Return the limits between places that close and others that do not."""
    for _ in range(_SECTIONS if inside.size else 0):
        places = inside[:, None] + (outside - inside)[:, None] * _PARTS
        opens = (misses(places.ravel()) > 0.0).reshape(places.shape)
        opens[:, 0], opens[:, -1] = False, True
        first, rows = opens.argmax(axis=1), np.arange(len(inside))
        inside, outside = places[rows, first - 1], places[rows, first]
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

    def measure(places: Array) -> Array:
        return np.abs(solver.sines(places)[number])

    sines = measure(grid)
    (at,) = np.nonzero((sines[:-2] > sines[1:-1]) & (sines[1:-1] <= sines[2:]))
    best, least = grid[at + 1], sines[at + 1]
    for places, sizes in approach(measure, grid[at], grid[at + 2]):
        nearest = np.where(np.isnan(sizes), math.inf, sizes).argmin(axis=1)
        rows = np.arange(len(at))
        better = sizes[rows, nearest] < least
        best = np.where(better, places[rows, nearest], best)
        least = np.where(better, sizes[rows, nearest], least)
    for place in best[least < _FLAT].tolist():
        marks = np.append(exact, 0.0)  # symmetry puts change points at zero, too
        same = marks[np.abs(marks - place) < _SAME * (high - low)]
        found = float(same[0]) if same.size else place
        yield float(positive(found - 360.0 * (found >= 360.0)) if turns else found) + 0.0


def _can_be_parallel(solver: Solver, number: int) -> bool:
    """Tell whether a loop is a parallelogram."""
    linkage = solver.linkage
    loop = replace(linkage.loops[number], parallel=True)
    try:
        solved = loop_solver(solver.frame, 1.0, loop, linkage.unknowns[number])
    except InputError:
        return False
    return isinstance(solved, ParallelLoop)  # a bar and a slide make none
