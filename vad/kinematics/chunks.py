"""Many poses at once, in chunks that stay in the processor's cache.

Straight through arrays of a million poses every intermediate result would travel to memory and
back; in chunks the whole solution costs a third of that.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from vad.kinematics.numbers import Number, is_array

CHUNK = 8192


def gather(size: int, solve: Callable[[slice], Mapping[Any, Number]]) -> dict[Any, Number]:
    """Call ``solve`` on one slice after another and join what it returns, key by key.

    Values that are not arrays are the same in every slice and are kept as they are.  Poses that
    do not exist are NaN, of which numpy must not warn.
    """
    results: dict[Any, Number] = {}
    with np.errstate(all="ignore"):
        for start in range(0, max(size, 1), CHUNK):
            part = slice(start, min(start + CHUNK, size))
            for key, value in solve(part).items():
                if is_array(value):
                    if key not in results:
                        results[key] = np.empty(size, value.dtype)
                    results[key][part] = value
                else:
                    results[key] = value
    return results


def cut(values: Mapping[Any, Number], part: slice) -> dict[Any, Number]:
    """Return the slice ``part`` of every array in ``values``."""
    return {key: value[part] if is_array(value) else value for key, value in values.items()}


def expand(
    values: Mapping[Any, Number], shape: tuple[int, ...], target: tuple[int, ...]
) -> dict[Any, Number]:
    """Return flat arrays of ``shape`` repeated to flat arrays of the broadcast shape ``target``."""
    if shape == target:
        return dict(values)
    return {
        key: np.broadcast_to(value.reshape(shape), target).ravel() if is_array(value) else value
        for key, value in values.items()
    }
