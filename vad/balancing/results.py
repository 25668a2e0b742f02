"""What is found of a shaft, an engine or a locomotive, as single numbers with names and units.

Tables of answers and question banks take their numbers from here.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from vad.balancing.balance import Balance
from vad.balancing.engine import Engine
from vad.balancing.inertia import KINDS
from vad.balancing.locomotive import Locomotive

UNITS = {"force": "N", "couple": "N m"}


class Result(NamedTuple):
    """One number that is found.

    Attributes
    ----------
    name
        What it is called: "X.mass", "primary.force", "X.hammer_blow".
    value, unit
        The number; its unit as JSON has it.
    kind
        What is found: "mass", "primary force" …
    panel
        The name of the diagram that finds it.
    """

    name: str
    value: float
    unit: str
    kind: str
    panel: str


def results(found: Balance | Engine) -> dict[str, Result]:
    """Return the numbers that are found, by name.

    These are the numbers that were left out of the masses of a shaft; the largest primary and
    secondary forces and couples of an engine; the balance masses of a locomotive, its hammer blows,
    and the largest change of its tractive force and of its swaying couple.

    Examples
    --------
    >>> import vad
    >>> shaft = vad.balance({"A": {"mass": 2, "radius": 30, "angle": 0}, "X": {"radius": 40}})
    >>> [(each.name, each.value, each.unit) for each in results(shaft).values()]
    [('X.mass', 1.5, 'kg'), ('X.angle', 180.0, 'deg')]
    """
    if isinstance(found, Balance):
        listed = _of_shaft(found)
    elif found.locomotive:
        listed = _of_locomotive(found.locomotive)
    else:
        listed = _of_engine(found)
    return {each.name: each for each in listed}


def _of_shaft(found: Balance) -> Iterator[Result]:
    units = {"mass": "kg", "angle": "deg"}
    for name, what in found.unknowns:
        unit = units.get(what, found.length_unit)
        yield Result(f"{name}.{what}", found.masses[name][what], unit, what, "force")


def _of_engine(found: Engine) -> Iterator[Result]:
    inertia = found.inertia
    whats = ("force",) if inertia.in_one_plane else ("force", "couple")
    for kind in KINDS if inertia.ratio is not None else KINDS[:1]:
        for what in whats:
            largest = found.largest(kind, what)
            yield Result(f"{kind}.{what}", largest, UNITS[what], f"{kind} {what}", kind)


def _of_locomotive(found: Locomotive) -> Iterator[Result]:
    masses = {each.name: each.numbers() for each in found.balance.masses}
    for name in found.names:
        yield Result(f"{name}.mass", masses[name]["mass"], "kg", "mass", "force")
        yield Result(f"{name}.angle", masses[name]["angle"], "deg", "angle", "force")
    for blow in found.hammer_blows:
        kind = "hammer blow"
        yield Result(f"{blow.wheel}.hammer_blow", blow.force, "N", kind, "hammer")
    pull, sway = found.tractive_force.largest, found.swaying_couple.largest
    yield Result("tractive_force", pull, "N", "tractive force", "traction")
    yield Result("swaying_couple", sway, "N m", "swaying couple", "traction")
