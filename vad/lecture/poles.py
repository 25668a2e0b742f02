"""Where the force polygons of a turn stand: each has a pole that is the same in all poses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from vad.strokes.force_tracks import ways_of
from vad.strokes.forces import APART

if TYPE_CHECKING:
    from vad.statics.forces import Forces

#: If the largest of all poses is very much larger than three in four, these decide.
USUAL, DWARFED, ABOUT = 75.0, 2.2, 1.15


def usual_limit(sizes: Any) -> float:
    """Return the size beyond which a few poses may leave the room that is made for all others.

    Examples
    --------
    >>> usual_limit([1.0, 2.0, 2.0, 3.0]), usual_limit([1.0, 2.0, 2.0, 2.0, 90.0])
    (3.0, 2.3)
    """
    usual, most = float(np.percentile(sizes, USUAL)), float(max(sizes))
    return ABOUT * usual if most > DWARFED * usual else most


def poles_of(found: Forces[Any, Any, Any]) -> dict[int, complex]:
    """Return a pole for each dyad: side by side, so that the polygons of many poses keep apart.

    A few poses near a dead centre, in which forces are very large, do not count.

    Parameters
    ----------
    found
        The forces over a turn.
    """
    boxes: dict[int, tuple[float, float]] = {}
    for number, vertices in ways_of(found).items():
        each = [np.broadcast_to(np.asarray(z, complex), found.shape) for z in vertices.values()]
        places = np.array([*each, np.zeros(found.shape)])
        places = places[:, np.isfinite(places).all(axis=0)]
        if not places.size:
            places = np.zeros((1, 1), complex)
        sizes = np.abs(places).max(axis=0)
        across = places.real[:, sizes <= usual_limit(sizes)]
        boxes[number] = float(across.min()), float(across.max())
    width = sum(high - low for low, high in boxes.values())
    poles, left = {}, 0.0
    for number, (low, high) in boxes.items():
        poles[number] = complex(left - low)
        if high > low:  # something acts there
            left += high - low + APART * width
    return poles
