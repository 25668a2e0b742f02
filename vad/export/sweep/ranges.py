"""What of a sweep's columns is shown: angles that run on, and ranges without the wildest poses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from vad.export.sweep.results import Column

# Where this share of the poses at either end makes the range so much wider, it is cut off.
_TAIL, _PEAK = 4.0, 6.0


def unwrapped(column: Column) -> Column:
    """Return an angle that runs on past 360° and starts near 0; other columns as they are."""
    known = np.isfinite(column.values)
    if column.quantity != "angle" or not known.any():
        return column
    values = column.values.copy()
    values[known] = np.unwrap(values[known], period=360.0)
    return replace(column, values=values - 360.0 * np.round(values[known][0] / 360.0))


def limits(values: NDArray[np.float64]) -> tuple[float, float]:
    """Return the range to show: all of it, unless a few poses near a dead centre dwarf the rest."""
    values = values[np.isfinite(values)]
    if not values.size:
        return 0.0, 1.0
    low, high = float(values.min()), float(values.max())
    inner = np.percentile(values, [_TAIL, 100.0 - _TAIL])
    most = float(inner[1] - inner[0])
    if most and high - low > _PEAK * most:
        low, high = max(low, float(inner[0]) - most), min(high, float(inner[1]) + most)
    return low, high


def largest(columns: Sequence[Column]) -> float:
    """Return the largest magnitude that is shown of ``columns``."""
    return max(map(abs, limits(np.concatenate([column.values for column in columns]))))
