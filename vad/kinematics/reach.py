"""Where a mechanism can be assembled: the range of its driver, and how far its slides get.

The limits have closed forms where the driver alone moves a loop; the solver is asked between them,
and on a grid for what later loops allow.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.numbers import cross, fold, positive
from vad.kinematics.solver import Solver, solver_of

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


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
    solver = solver_of(mechanism)
    turns = solver.linkage.driver.kind == "angle"
    sizes = [] if turns else _sizes(solver.frame)
    limit = 360.0 if turns else sum(sizes) / _steepness(solver.frame)
    grid = np.linspace(0.0 if turns else -limit, limit, samples)
    limits = _limits(solver, turns)
    between = 0.5 * (limits[1:] + limits[:-1])
    grid = np.unique(np.concatenate([grid, limits, between]))
    closes = _closes(solver, grid)
    if closes.all():
        return [(float(grid[0]), float(grid[-1]))]
    ends = [
        _edge(solver, float(grid[i]), float(grid[i + 1]), limits, 1e-15 * limit)
        for i in np.flatnonzero(closes[1:] != closes[:-1])
    ]
    if closes[0]:
        ends = [float(grid[0]), *ends]
    if closes[-1]:
        ends = [*ends, float(grid[-1])]
    if turns and closes[0]:  # the last interval runs on through 0°
        ends = [ends[-2] - 360.0, *ends[1:-2]]
    return list(zip(ends[::2], ends[1::2], strict=True))


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
    with np.errstate(all="ignore"):
        lengths = solver.positions(np.concatenate([*ranges, [math.nan]])).length
    scale = solver.frame.scale
    return {
        name: (float(np.fmin.reduce(length)) * scale, float(np.fmax.reduce(length)) * scale)
        for name, length in lengths.items()
    }


def _limits(solver: Solver, turns: bool) -> NDArray[np.float64]:
    """Return all limits in closed form, of an angle within [0, 360), sorted."""
    frame = solver.frame
    found = [limit for loop in solver.loops for limit in loop.limits()]
    if turns:
        angles = {positive(fold(limit + frame.angle)) for limit in found}
        return np.array(sorted(angles | ({360.0} if 0.0 in angles else set())))
    return np.unique([limit * frame.scale for limit in found])


def _sizes(frame: ReferenceFrame) -> list[float]:
    """Return the lengths of all bars in the user's unit."""
    lengths = [step.length for step in frame.steps if isinstance(step, Bar)]
    lengths += [frame.linkage.ground[1]] if frame.linkage.ground else []
    return [abs(length) for length in lengths if isinstance(length, float)]


def _steepness(frame: ReferenceFrame) -> float:
    """Return the least sine between two guides: the flatter they cross, the farther they reach."""
    guides = [s for s in frame.steps if isinstance(s, Slide) and isinstance(s.along, float)]
    lines = [frame.line(guide, None) for guide in guides]
    sines = [abs(cross(p, q)) for p, q in combinations(lines, 2)]
    return min((sine for sine in sines if sine), default=1.0)


def _closes(solver: Solver, values: NDArray[np.float64]) -> NDArray[np.bool_]:
    with np.errstate(all="ignore"):
        pose = solver.positions(values)
    closes: NDArray[np.bool_] = ~np.isnan(sum(pose.sine))
    return closes


def _edge(
    solver: Solver, inside: float, outside: float, limits: NDArray[np.float64], tolerance: float
) -> float:
    """Return the limit between two values of which exactly one closes."""
    for end in (inside, outside):
        if end in limits:
            return end
    if not _closes(solver, np.array([inside]))[0]:
        inside, outside = outside, inside
    middle = 0.5 * (inside + outside)
    while abs(outside - inside) > tolerance and middle not in (inside, outside):
        if _closes(solver, np.array([middle]))[0]:
            inside = middle
        else:
            outside = middle
        middle = 0.5 * (inside + outside)
    return inside
