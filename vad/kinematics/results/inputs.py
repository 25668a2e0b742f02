"""The motion of the driver as it is given: in come numbers or arrays, out go floats or new arrays.

What may be given is said here for type checkers, too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from numbers import Real
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from vad.errors import InputError
from vad.kinematics.numbers import Number

One = float | np.floating[Any] | np.integer[Any]
Many = Sequence[One] | Sequence[Sequence[One]] | NDArray[np.floating[Any] | np.integer[Any]]


class OnePose(TypedDict, total=False):
    """The inputs of one pose: those of a crank (degrees, rad/s, rad/s²) or those of a slide."""

    angle: One
    omega: One
    alpha: One
    position: One
    velocity: One
    acceleration: One


class ManyPoses(TypedDict, total=False):
    """The inputs of many poses: arrays that broadcast."""

    angle: One | Many
    omega: One | Many
    alpha: One | Many
    position: One | Many
    velocity: One | Many
    acceleration: One | Many


def checked(name: str, value: object, largest: float) -> Number:
    """Return an input as a float, or as a new array in which what is not finite is NaN.

    Raises
    ------
    vad.errors.InputError
        If it is neither a number nor an array of them, or a number that is not finite or greater
        than ``largest``.
    """
    if type(value) is float and -largest <= value <= largest and math.isfinite(value):
        return value  # the usual case, first
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float | int) and not isinstance(value, bool):
        number = float(value)
        if not math.isfinite(number):
            raise InputError(f"{name}: must be a finite number, got {number}")
        if abs(number) > largest:
            raise InputError(f"{name}: must be within ±{largest:g}, got {number:g}")
        return number
    try:
        array = np.array(_numbers(value), dtype=float)
    except (TypeError, ValueError, OverflowError):
        wanted = "must be a number or an array of numbers"
        raise InputError(f"{name}: {wanted}, got {_shown(value)}") from None
    with np.errstate(invalid="ignore"):
        array[~(np.isfinite(array) & (np.abs(array) <= largest))] = np.nan
    return array


def _numbers(value: object) -> NDArray[Any]:
    """Return an array as it is given, if it holds nothing but real numbers."""
    if np.ma.is_masked(value):
        raise TypeError("masked elements are no numbers")
    given = np.asarray(value)
    if given.dtype == object and all(
        isinstance(x, Real) and not isinstance(x, bool) for x in given.flat
    ):
        return given
    if given.dtype.kind not in "iuf":
        raise TypeError("not real numbers")
    return given


def _shown(value: object) -> str:
    """Return a value as an error shows it: in one line, and not all of a long one."""
    words = " ".join(repr(value).split())
    return words if len(words) <= 60 else f"{words[:57]}..."
