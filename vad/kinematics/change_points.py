"""Where a mechanism can leave its assembly: a loop folds flat, and two motions go on from there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from vad.errors import InputError
from vad.kinematics.closing.parallelogram import ParallelLoop
from vad.kinematics.numbers import positive
from vad.kinematics.reach import approach, closing_range
from vad.kinematics.solver import Solver, solver_of

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

# A sine counts as zero below this: it belongs to lengths that are equal to the square of it.
_FLAT = 1e-6
_SAMPLES = 721
# A change point this near to another, as a part of the range, is the same.
_SAME = 1e-6


class ChangePoint(NamedTuple):
    """A place of the driver at which a loop's construction lines are parallel, and it goes on.

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
        """Say it, with the unit of the driver's place.

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

    A loop that is `parallel` has none: it goes on as it is.

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
    if turns and high - low == 360.0:  # round and round
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
            marks = np.append(exact, 0.0)  # and zero, where symmetry puts it
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
