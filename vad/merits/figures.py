"""Figures of merit that are one number each: what a sweep of a dimension has as a column."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from vad.errors import InputError
from vad.kinematics.motion import Motion
from vad.merits.merit import Merit, merit

#: The figures whose names have no full stop.
ALONE = ("stroke", "time_ratio", "forward_angle", "return_angle")
#: The ends of a result over the range of the driver, and the places where they occur.
ENDS = ("least", "least_at", "largest", "largest_at")


def is_figure(name: str) -> bool:
    """Tell whether a column is a figure of merit.

    Examples
    --------
    >>> is_figure("time_ratio"), is_figure("rocker.omega.largest"), is_figure("rocker.omega")
    (True, True, False)
    """
    return name in ALONE or name.rpartition(".")[2] in ENDS


def figure(found: Merit, name: str) -> float:
    """Return a figure of merit by the name of its column; NaN where there is none.

    Parameters
    ----------
    found
        The figures of a mechanism.
    name
        One of `ALONE`, or ``"transmission"`` or a result with a full stop and one of `ENDS`.

    Raises
    ------
    vad.errors.UsageError
        For a result that there is not.

    Examples
    --------
    >>> import vad
    >>> found = vad.merit(vad.SliderCrank())
    >>> figure(found, "stroke"), figure(found, "slider.position.largest_at")
    (120.0, 0.0)
    """
    if name in ALONE:
        value = found[name]
    else:
        result, _, end = name.rpartition(".")
        most = found["transmission"] if result == "transmission" else found["extremes"][result]
        value = None if most is None else most[end]
    return math.nan if value is None else float(value)


def merit_of(motion: Motion[Any, Any, Any]) -> Merit:
    """Return the figures of the mechanism of one pose or many, all with the same rates.

    Raises
    ------
    vad.errors.InputError
        If a rate is an array of different numbers.
    """
    inputs: dict[str, Any] = {}
    place, *_ = motion.inputs
    for name, values in motion.inputs.items():
        several = np.unique(values)
        if name != place and several.size > 1:
            raise InputError(f"{name}: figures of merit take one number, got an array")
        inputs[name] = float(several[0])
    return merit(motion.mechanism, **inputs)
