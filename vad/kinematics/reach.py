"""Where a mechanism can be assembled: the range of its driver, found by asking the solver."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

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
    limit = 360.0 if turns else sum(abs(size) for size in mechanism.parameters().values())
    grid = np.linspace(0.0 if turns else -limit, limit, samples)
    closes = _closes(solver, grid)
    if closes.all():
        return [(float(grid[0]), limit)]
    edges = np.flatnonzero(closes[1:] != closes[:-1])
    ends = [_edge(solver, float(grid[i]), float(grid[i + 1])) for i in edges]
    if not ends:
        return []
    if not closes[0]:
        return list(zip(ends[::2], ends[1::2], strict=True))
    if turns:
        ends = [ends[-1] - 360.0, *ends[:-1]]
        return list(zip(ends[::2], ends[1::2], strict=True))
    ends = [float(grid[0]), *ends, *([limit] if closes[-1] else [])]
    return list(zip(ends[::2], ends[1::2], strict=True))


def _closes(solver: Solver, values: NDArray[np.float64]) -> NDArray[np.bool_]:
    with np.errstate(all="ignore"):
        pose = solver.positions(values)
    closes: NDArray[np.bool_] = ~np.isnan(sum(pose.sine))
    return closes


def _edge(solver: Solver, inside: float, outside: float) -> float:
    """Return the last value that closes between two of which exactly one does."""
    if not _closes(solver, np.array([inside]))[0]:
        inside, outside = outside, inside
    middle = 0.5 * (inside + outside)
    while not (middle in (inside, outside) or math.isclose(inside, outside, abs_tol=1e-12)):
        if _closes(solver, np.array([middle]))[0]:
            inside = middle
        else:
            outside = middle
        middle = 0.5 * (inside + outside)
    return inside
