"""Rubbing at pins and slowest points of links as columns of a sweep: each a number by its name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from vad.errors import UsageError, unknown
from vad.kinematics.motion import Motion
from vad.kinematics.solver import Solver
from vad.merits.pins import rubbing, slowest

_RUBBING = ".rubbing"
_SLOWEST = ".slowest."
#: What a sweep has of a slowest point, as `vad.merit` calls it, and its type.
_OF_SLOWEST: dict[str, type] = {"distance": float, "position": complex, "velocity": complex}


def is_of_pins(name: str) -> bool:
    """Tell whether a column is the rubbing of a pin or belongs to the slowest point of a link.

    Examples
    --------
    >>> is_of_pins("B.rubbing"), is_of_pins("coupler.slowest.position"), is_of_pins("B.velocity")
    (True, True, False)
    """
    return name.endswith(_RUBBING) or name.rpartition(".")[0].endswith(_SLOWEST[:-1])


def rubbing_names(motion: Motion[Any, Any, Any], pins: Mapping[str, Any]) -> list[str]:
    """Return the names of the columns of all pins, in their order.

    A pin that joins two bodies is named by its point, ``"B.rubbing"``; one that joins more has a
    column for each pair, ``"C.coupler.rod.rubbing"``.

    Raises
    ------
    vad.errors.VadError
        As for `vad.merits.pins.rubbing`.

    Examples
    --------
    >>> import vad
    >>> rubbing_names(vad.solve(vad.FourBar()), {"B": 50, "C": 30})
    ['B.rubbing', 'C.rubbing']
    """
    return list(_rubs(motion, pins))


def type_of(motion: Motion[Any, Any, Any], name: str, pins: Mapping[str, Any]) -> type:
    """Return the type of a column, real or complex.

    Raises
    ------
    vad.errors.UsageError
        For a pin whose diameter is unknown, and for what there is not.
    """
    if name.endswith(_RUBBING):
        known = _rubs(motion, pins)
        if name not in known:
            raise _unknown_rubbing(name, known, pins)
        return float
    names = [f"{link}{_SLOWEST}{part}" for link in motion.links for part in _OF_SLOWEST]
    if name not in names or not isinstance(motion.solver, Solver):
        raise unknown(
            "result", name, names if isinstance(motion.solver, Solver) else motion.results
        )
    return _OF_SLOWEST[name.rpartition(".")[2]]


def values_of(
    motion: Motion[Any, Any, Any], names: Iterable[str], pins: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the values of columns by their names; NaN where a link does not turn."""
    listed = list(names)
    rubs = _rubs(motion, pins)
    points = slowest(motion) if any(name not in rubs for name in listed) else {}
    found: dict[str, Any] = {}
    for name in listed:
        if name in rubs:
            found[name] = rubs[name]
            continue
        link, _, part = name.partition(_SLOWEST)
        point = points[link]
        found[name] = np.nan if point is None else getattr(point, part)
    return found


def _rubs(motion: Motion[Any, Any, Any], pins: Mapping[str, Any]) -> dict[str, Any]:
    """Return the velocities of rubbing by the names of their columns."""
    found = rubbing(motion, pins)
    at = [each.pin for each in found]
    return {
        each.pin + ("" if at.count(each.pin) == 1 else f".{each.one}.{each.other}") + _RUBBING: (
            each.velocity
        )
        for each in found
    }


def _unknown_rubbing(name: str, known: Mapping[str, Any], pins: Mapping[str, Any]) -> UsageError:
    point = name.partition(".")[0]
    if point in pins:
        return unknown("result", name, known)
    return UsageError(
        f"{name}: the diameter of pin {point} is unknown",
        f"give it: --pin '{point} 50', or pins={{\"{point}\": 50}} in Python",
    )
