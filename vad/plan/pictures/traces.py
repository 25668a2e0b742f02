"""What shows the way of a flight: ghosts, a dotted path, and a ring where a head will dock.

They are gone when the vector has landed.  The path bends so that it crosses few words beside the
panels, and then few strokes and labels.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from vad.plan.geometry import Rect
from vad.plan.items import Span
from vad.plan.labels.obstacles import Complexes, Obstacles, crossed
from vad.plan.marks import Fading, Mark, Polygon, disc, line
from vad.plan.roles import ROLES, VECTOR
from vad.plan.sketch import Sketch

#: How much ink ghosts have, one for each phase before the last.
GHOSTS = (0.20, 0.28, 0.36)
#: The radius of the ring in which a head docks.
RING = 0.018
#: At once, as a share of a flight.
AT_ONCE = 1e-6
Points = Sequence[complex]


def ghosts(moving: Mark, shares: Iterable[float], landed: float) -> Iterator[Mark]:
    """Yield the ghosts that a flying mark leaves at some shares, until it has ``landed``."""
    width = moving.width * ROLES[moving.role].width / VECTOR
    for ink, share in zip(GHOSTS, shares, strict=False):
        still = moving.at(share)
        assert still is not None
        if isinstance(still.shape, Polygon):
            role = "ghost head" if moving.role == "head" else moving.role
            still = replace(still, role=role)
        else:
            still = replace(still, role="ghost", width=width)
        yield replace(still, alpha=ink, growth=_seen(share, landed))


def path(points: Points, share: float, landed: float) -> Mark:
    """Return the dotted path on which the end of a vector flies from a share on."""
    return line(points, "flight path", growth=_seen(share, landed))


def ring(at: complex, share: float, landed: float) -> Mark:
    """Return the ring in which a head docks that flies from a share on."""
    return disc(at, RING, "ring", growth=_seen(share, landed))


def _seen(share: float, landed: float) -> Fading:
    """Return the ink of what is there from a share on, and fades when something has landed."""
    return Fading(((share, 0.0), (share + AT_ONCE, 1.0), (landed, 1.0), (1.0, 0.0)))


def strokes_at(sketches: Iterable[Sketch], span: Span) -> Complexes:
    """Return the ends of all strokes that show at some time in a span, shape (strokes, 2).

    A label is two strokes, from corner to corner.
    """
    found: list[tuple[complex, complex]] = []
    for sketch in sketches:
        shown = sketch.obstacles.during(span)
        found += [(start, end) for start, end, _, _ in shown.lines if start != end]
        for box, _ in shown.boxes:
            found.append((complex(box.left, box.bottom), complex(box.right, box.top)))
            found.append((complex(box.left, box.top), complex(box.right, box.bottom)))
    return np.array(found, dtype=np.complex128).reshape(-1, 2)


def crossings(points: Points, strokes: Complexes) -> int:
    """Return how often a path crosses strokes.

    Examples
    --------
    >>> crossings((0j, 2 + 0j), np.array([[1 - 1j, 1 + 1j], [3 - 1j, 3 + 1j]]))
    1
    """
    met = (crossed(strokes[:, 0], strokes[:, 1], *each) for each in pairwise(points))
    return sum(int(np.count_nonzero(each)) for each in met)


def swept(paths: Sequence[Points], boxes: Sequence[Rect]) -> int:
    """Return how many boxes something meets whose ends move on two paths.

    Examples
    --------
    >>> swept([(0j, 2 + 0j), (1j, 2 + 1j)], [Rect(-0.1, 0.4, 0.1, 0.6), Rect(5.0, 0.0, 6.0, 1.0)])
    1
    """
    if not boxes:
        return 0
    ways = Obstacles(boxes[0])
    for each in (*paths, *zip(*paths, strict=True)):
        ways.line(each, 0.0)
    return int(np.count_nonzero(ways.under(boxes).any(axis=1)))
