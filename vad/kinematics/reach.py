"""Where a mechanism can be assembled: the range of its driver, found by asking the solver."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Slide
from vad.kinematics.numbers import cross
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
    # However short the other bar is, a strut as long as one of the bars reaches.
    grid = np.union1d(grid, [*sizes, *(-size for size in sizes)])
    closes = _closes(solver, grid)
    if closes.all():
        return [(float(grid[0]), float(grid[-1]))]
    edges = np.flatnonzero(closes[1:] != closes[:-1])
    ends = [_edge(solver, float(grid[i]), float(grid[i + 1]), 1e-15 * limit) for i in edges]
    if closes[0]:
        ends = [float(grid[0]), *ends]
    if closes[-1]:
        ends = [*ends, float(grid[-1])]
    if turns and closes[0]:  # the last interval runs on through 0°
        ends = [ends[-2] - 360.0, *ends[1:-2]]
    return list(zip(ends[::2], ends[1::2], strict=True))


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


def _edge(solver: Solver, inside: float, outside: float, tolerance: float) -> float:
    """Return the last value that closes between two of which exactly one does."""
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
