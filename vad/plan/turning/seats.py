"""Seats: what each moving label says in one pose, and where it may stand to be read rightly.

In come the lettered points of a pose, out go `Seat` objects; points that coincide share one, as
in stills.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import Rect
from vad.plan.labels.tags import SMALL_SIZE
from vad.plan.labels.vertices import COINCIDENT, LETTER
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.turning.spots import CORIOLIS, Spot, Spots, grouped

Bools = NDArray[np.bool_]
Complexes = NDArray[np.complex128]
Reals = NDArray[np.float64]

#: Any other dot's rim is farther from a label than its own by this factor, and by so much more.
FACTOR, MORE = 1.3, 0.004


@dataclass(frozen=True, slots=True)
class Seat:
    """A label in one pose: its text and size, its dot, and all the other dots, on the page.

    ``radius`` is that of every dot in the panel.
    """

    text: str
    size: tuple[float, float]
    spot: Spot
    rivals: Complexes
    radius: float

    def owns(self, centres: Sequence[complex] | Complexes, spare: float = 0) -> Bools:
        """Tell for each centre whether the label would there be clearly nearest to its own dot.

        ``spare`` is a distance to be kept beyond what is needed.
        """
        at = np.asarray(centres, dtype=np.complex128)
        need = np.full(len(at), MORE + spare + self.radius)
        if self.text != CORIOLIS:  # which names a vector, not a dot
            own = distances(at, self.size, np.array([self.spot.at]))[:, 0]
            need += FACTOR * np.maximum(own - self.radius, 0.0)
        farther = distances(at, self.size, self.rivals) > need[:, None]
        return np.asarray(farther.all(axis=1))


def distances(centres: Complexes, size: tuple[float, float], points: Complexes) -> Reals:
    """Return how far boxes (rows) are from points (columns); 0 for a point within."""
    away = centres[:, None] - points
    aside = np.maximum(np.abs(away.real) - size[0] / 2, 0.0)
    above = np.maximum(np.abs(away.imag) - size[1] / 2, 0.0)
    return np.hypot(aside, above)


def letter_size(text: str) -> float:
    """Return the size of type of a label."""
    return SMALL_SIZE if text == CORIOLIS else LETTER


def seats(
    pose: Spots, groups: Sequence[tuple[str, ...]], edge: Rect, radius: float
) -> list[Seat | None]:
    """Return the seat of each group of letters.

    None where its point is not in the panel, or shares the label of a group before it.
    """
    found: list[list[str]] = [[] for _ in groups]
    leaders: list[tuple[int, complex]] = []
    for index, group in enumerate(groups):
        spot = grouped(pose, group)
        if spot is None or not edge.holds(spot.at):
            continue
        names_dot = CORIOLIS not in group
        near = [leader for leader, at in leaders if names_dot and abs(at - spot.at) < COINCIDENT]
        if near:
            found[near[0]] += group
            continue
        found[index] += group
        if names_dot:
            leaders.append((index, spot.at))
    return [_seat(pose, letters, edge, radius) for letters in found]


def _seat(pose: Spots, letters: Sequence[str], edge: Rect, radius: float) -> Seat | None:
    spot, text = grouped(pose, letters), ", ".join(letters)
    if spot is None:
        return None
    rivals = [
        other.at
        for letter, other in pose.items()
        if letter not in letters and letter != CORIOLIS and edge.holds(other.at)
    ]
    size = ink_size(symbols(text), letter_size(text))
    return Seat(text, size, spot, np.array(rivals, dtype=np.complex128), radius)
