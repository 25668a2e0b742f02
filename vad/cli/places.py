"""The places of the driver over which ``vad sweep`` runs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from vad.errors import AssemblyError, UsageError
from vad.mechanisms import Mechanism

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: The most poses of a sweep.
LARGEST = 10_000_000


def sweep_places(
    mechanism: Mechanism, start: float | None = None, stop: float | None = None, steps: int = 361
) -> NDArray[np.float64]:
    """Return ``steps`` places of the driver, evenly spaced from ``start`` to ``stop``.

    The ends that are left out are those of a whole turn of a driven link, or of the widest range in
    which a driven slide closes.

    Raises
    ------
    UsageError
        If the number of steps or the ends make no range.
    AssemblyError
        If the mechanism closes nowhere.
    """
    import numpy as np

    if not 2 <= steps <= LARGEST:
        raise UsageError(f"--steps: must be from 2 to {LARGEST}, got {steps}")
    if "angle" in mechanism.inputs:
        first, last = 0.0, 360.0
    elif start is None or stop is None:
        first, last = _widest(mechanism)
    first = first if start is None else start
    last = last if stop is None else stop
    if not math.isfinite(last - first) or first == last:
        raise UsageError(f"--from, --to: {first:g} to {last:g} is no range")
    return np.linspace(first, last, steps)


def _widest(mechanism: Mechanism) -> tuple[float, float]:
    """Return the widest range of the driver that closes, the greater one of two equal ones."""
    from vad.kinematics.reach import closing_range

    ranges = closing_range(mechanism)
    if not ranges:
        raise AssemblyError("with these lengths the links close nowhere")
    widest = max(ranges, key=lambda ends: (float(f"{ends[1] - ends[0]:.6g}"), ends[1]))
    if widest[0] == widest[1]:
        raise AssemblyError(f"with these lengths the links close only at {widest[0]:g}")
    return widest
