"""The motion of the driver as it is given: in come numbers or arrays, out go floats or new arrays.

What may be given is said here for type checkers, too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from numbers import Real
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from vad.errors import InputError, shown
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
    if _is_number(value):
        return _one(name, value, largest)
    array = _many(name, value)
    with np.errstate(invalid="ignore"):
        array[~(np.isfinite(array) & (np.abs(array) <= largest))] = np.nan
    array.flags.writeable = False  # what is solved from it would no longer belong to it
    return array


def _one(name: str, value: Any, largest: float) -> float:
    try:
        number = float(value)
    except (ValueError, OverflowError):  # a whole number beyond every float
        number = math.inf
    if not math.isfinite(number):
        raise InputError(f"{name}: must be a finite number, got {shown(value)}")
    if abs(number) > largest:
        raise InputError(f"{name}: must be within ±{largest:g}, got {number:g}")
    return number


def _many(name: str, value: object) -> NDArray[np.float64]:
    """Return a new array; what numpy would make numbers of, such as text and dates, is refused."""
    if np.ma.is_masked(value):
        hint = "array.filled(numpy.nan) gives NaN, which is answered with NaN"
        raise InputError(f"{name}: must not be masked, for a mask would be lost", hint)
    try:
        if isinstance(value, str | bytes | bytearray):
            raise TypeError
        array = np.asarray(value)
        kind = array.dtype.kind
        if kind not in "iufO" or (kind == "O" and not all(map(_is_number, array.flat))):
            raise TypeError
        return np.array(array, dtype=float)
    except Exception as error:  # whatever a class says that is asked for an array
        if isinstance(error, MemoryError):
            raise
        wanted = "must be a number or an array of numbers"
        raise InputError(f"{name}: {wanted}, got {shown(value)}") from None


def _is_number(value: object) -> bool:
    # To Python, a truth value is a number, and so is numpy's span of time.
    return isinstance(value, Real | Decimal) and not isinstance(value, bool | np.timedelta64)
