"""Lines with as few points as the eye needs.

In come the points of a line, out go the numbers of those that are kept.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import SHORTEST

Complexes = NDArray[np.complex128]
Ints = NDArray[np.int64]

#: No point that is left out is farther than this from the line: a fourteenth of a pixel.
TOLERANCE = 1e-4
_PIECES = 4  # a closed line has no chord, but its quarters have


def thinned(points: Complexes) -> Ints:
    """Return the numbers of the points that are kept, in order; all of them where one is NaN."""
    last = len(points) - 1
    if not np.isfinite(points).all() or last < _PIECES:
        return np.arange(len(points))
    ends = [round(last * piece / _PIECES) for piece in range(_PIECES + 1)]
    kept, left = set(ends), list(pairwise(ends))
    while left:
        first, end = left.pop()
        if end - first < 2:
            continue
        chord, between = points[end] - points[first], points[first + 1 : end] - points[first]
        length = max(abs(chord), SHORTEST)
        turned = between * np.conj(chord) / length
        beyond = np.maximum(turned.real - length, -turned.real)
        away = np.maximum(np.abs(turned.imag), beyond)
        farthest = int(away.argmax())
        if away[farthest] > TOLERANCE:
            middle = first + 1 + farthest
            kept.add(middle)
            left += [(first, middle), (middle, end)]
    return np.array(sorted(kept))
