"""What ``vad check`` tells about a mechanism from a file.

That is its bodies and joints, its dyads with their loops and places, the range of the driver in
which it closes, and where in this range a dyad is nearest to a dead centre.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from vad.files.loading import Written, WrittenMechanism
from vad.files.structure import Dyad
from vad.kinematics.linkage import Loop
from vad.kinematics.reach import ChangePoint, change_points, closing_range
from vad.kinematics.solver import solver_of

#: Poses in which every range is looked at.
_SAMPLES = 3601


class Choice(NamedTuple):
    """Where a point is, in a word and by coordinates, and the other place that it could have."""

    point: str
    word: str
    place: complex
    other: complex


class FoundDyad(NamedTuple):
    """One dyad: what it finds, from which loop, and at which of two places."""

    dyad: Dyad
    what: str
    loop: str
    choices: tuple[Choice, ...]


class Nearest(NamedTuple):
    """Where the lines of a dyad cross at the smallest sine, and the number of that dyad."""

    place: float
    dyad: int
    sine: float


@dataclass(frozen=True)
class Examination:
    """What `examine` finds.

    Attributes
    ----------
    mechanism
        The mechanism with the numbers of its file.
    found
        Its dyads in the order of drawing.
    closes
        The ranges of the driver, in degrees or in the unit of length.
    nearest
        Where it is nearest to a dead centre; None if it has no dyad, or closes nowhere.
    changes
        Its change points, from which two motions go on.
    """

    mechanism: WrittenMechanism
    found: tuple[FoundDyad, ...]
    closes: tuple[tuple[float, float], ...]
    nearest: Nearest | None
    changes: tuple[ChangePoint, ...]


def examine(kind: type[WrittenMechanism]) -> Examination:
    """Look at a mechanism over the range of its driver."""
    mechanism = kind()
    written = mechanism.written
    assembly = written.assembly({})
    found = []
    for dyad, loop in zip(written.dyads, mechanism.linkage().loops, strict=True):
        choices = tuple(
            Choice(point, assembly.words.get(point, ""), *assembly.places[point])
            for point in dyad.points
            if point in assembly.places
        )
        found.append(FoundDyad(dyad, _what(written, dyad), _equation(loop), choices))
    ranges = tuple(closing_range(mechanism))
    nearest, changes = _nearest(mechanism, ranges), change_points(mechanism)
    return Examination(mechanism, tuple(found), ranges, nearest, changes)


def _nearest(
    mechanism: WrittenMechanism, ranges: tuple[tuple[float, float], ...]
) -> Nearest | None:
    """Look for the smallest sine on a grid."""
    solver = solver_of(mechanism).plane
    if not ranges or not solver.loops:
        return None
    places = np.concatenate([np.linspace(low, high, _SAMPLES) for low, high in ranges])
    sines = np.abs(solver.sines(places))
    sines[np.isnan(sines)] = np.inf
    sines[[loop.parallel for loop in solver.linkage.loops]] = np.inf  # they run through a sine of 0
    if not np.isfinite(sines).any():
        return None
    loop, at = np.unravel_index(np.argmin(sines), sines.shape)
    return Nearest(float(places[at]), int(loop) + 1, float(sines[loop, at]))


def _equation(loop: Loop) -> str:
    """Return a loop as an equation of vectors, each on the side on which it is positive."""
    starts = loop.first[0].start, loop.second[0].start
    ground = ["".join(starts)] if starts[0] != starts[1] else []
    sides = []
    for chain, other in ((loop.first, loop.second), (loop.second, loop.first)):
        onward = [step.ends for step in chain if not step.reverse]
        back = [step.ends for step in reversed(other) if step.reverse]
        vectors = [*back, *onward] if not ground and other[0].reverse else [*onward, *back]
        sides.append([*(ground if chain is loop.second else []), *vectors])
    return " = ".join(" + ".join(side) or "0" for side in sides)


def _what(written: Written, dyad: Dyad) -> str:
    """Say what a dyad finds: its links by their names, then what slides on which line."""
    lines = written.source.table("guides")
    slides = [
        f"{guide.slide} {guide.point} on {_line(lines[guide.point])}" for guide in dyad.guides
    ]
    return ", ".join([*(link.name for link in dyad.links), *slides])


def _line(words: Mapping[str, Any]) -> str:
    """Return a line as it is written in the file."""
    if "along" in words:
        aside = f", {words['offset']} aside" if words.get("offset") else ""
        return f"{words['along']}{aside}"
    if "through" in words:
        return f"a line through {words['through']} at {words['angle']}°"
    return next(f"{axis} = {words[axis]}" for axis in "yx" if axis in words)
