"""In which ways a mechanism can be assembled: each loop at one of the places that it has."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from vad.kinematics.solver import Solver, solver_of

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

#: The other assembly of a mechanism that has two.
_OTHER = {"open": "crossed", "crossed": "open"}


class Assembly(NamedTuple):
    """A way in which a mechanism can be assembled.

    Attributes
    ----------
    name
        What it is called, as `vad.kinematics.motion.Motion.assembly`.
    sides
        For each loop a factor, in space one: -1.0 if it takes another place than in the mechanism
        itself.
    """

    name: str | dict[str, str] | None
    sides: tuple[float, ...]


@lru_cache(maxsize=64)
def assemblies(mechanism: Mechanism) -> tuple[Assembly, ...]:
    """Return the ways in which a mechanism can be assembled with its dimensions, its own first.

    What stays a parallelogram stays one in all of them.

    Examples
    --------
    >>> import vad
    >>> [each.name for each in assemblies(vad.FourBar(assembly="crossed"))]
    ['crossed', 'open']
    """
    solver = solver_of(mechanism)
    loops = solver.loops if isinstance(solver, Solver) else None
    other = (-1.0,) if loops is None else tuple(1.0 - 2.0 * loop.two_ways for loop in loops)
    own = mechanism.assembly if solver.two_assemblies else None
    found = [Assembly(own, tuple(map(abs, other)))]
    if isinstance(own, dict):
        found = [Assembly(*way) for way in mechanism.placements()]
    elif own in _OTHER:
        found.append(Assembly(_OTHER[own], other))
    return tuple(found)
