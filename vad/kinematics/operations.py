"""The operations of which the solver is made: as Python writes them, on floats and on blocks.

All three give the same bits.  A block holds a few thousand poses; what numpy makes of it is
written to ``out``.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np


class Operation(NamedTuple):
    """One operation: as Python writes it, as it acts on floats, and on blocks of poses."""

    text: str
    on_floats: Callable[..., Any]
    on_blocks: Callable[..., Any]
    kind: type = float


def _select(condition: Any, rare: Any, usual: Any, out: Any) -> None:
    if out is not usual:
        np.copyto(out, usual)
    if np.count_nonzero(condition):
        np.putmask(out, condition, rare)


def _fold(degrees: Any, out: Any) -> None:
    degrees = np.asarray(degrees)  # of rates alone there may be many
    # Beyond 1e15, 360·k is no longer exact; fmod is, and 720 keeps which of ±180 is meant.
    if not (degrees.min() >= -1e15 and degrees.max() <= 1e15):
        degrees = np.where(np.abs(degrees) > 1e15, np.fmod(degrees, 720.0), degrees)
    np.divide(degrees, 360.0, out=out)
    np.rint(out, out=out)
    np.multiply(out, 360.0, out=out)
    np.subtract(degrees, out, out=out)
    if not (out.min() >= -180.0 and out.max() <= 180.0):  # a quotient was rounded onto one half
        beyond = np.abs(out) > 180.0
        out[beyond] -= np.copysign(360.0, out[beyond])


def _place(number: Any, out: Any) -> None:
    np.copyto(out, number, casting="unsafe")


def _choose(place: Any, constants: Any, out: Any) -> None:
    constants.take(place, None, out, "clip")  # five times as fast as numpy.where


def _either(condition: bool, rare: float, usual: float) -> float:
    return rare if condition else usual


OPERATIONS = {
    "fold": Operation("remainder({}, 360.0)", lambda x: math.remainder(x, 360.0), _fold),
    "add": Operation("{} + {}", operator.add, np.add),
    "subtract": Operation("{} - {}", operator.sub, np.subtract),
    "multiply": Operation("{} * {}", operator.mul, np.multiply),
    "divide": Operation("{} / {}", operator.truediv, np.divide),
    "negative": Operation("-{}", operator.neg, np.negative),
    "absolute": Operation("abs({})", abs, np.absolute),
    "copy": Operation("{}", float, np.positive),
    "minimum": Operation("{0} if {0} < {1} else {1}", min, np.minimum),
    "maximum": Operation("{0} if {0} > {1} else {1}", lambda x, y: x if x > y else y, np.fmax),
    "sqrt": Operation("sqrt({})", math.sqrt, np.sqrt),
    "copysign": Operation("copysign({}, {})", math.copysign, np.copysign),
    # numpy's for one pose too: its last bit is not always that of the C library.
    "arctan2": Operation(
        "float(arctan2({}, {}))", lambda y, x: float(np.arctan2(y, x)), np.arctan2
    ),
    "round": Operation(  # of a number within ±1
        "1.0 if {0} > 0.5 else -1.0 if {0} < -0.5 else 0.0", lambda x: float(round(x)), np.rint
    ),
    "place": Operation("{}", int, _place, np.intp),
    "choose": Operation(
        "{1[0]} if {0} < 0.5 else {1[2]} if {0} > 1.5 else {1[1]}", lambda i, of: of[i], _choose
    ),
    "less": Operation("{} < {}", operator.lt, np.less, bool),
    "greater": Operation("{} > {}", operator.gt, np.greater, bool),
    "equal": Operation("{} == {}", operator.eq, np.equal, bool),
    "both": Operation("{} & {}", operator.and_, np.logical_and, bool),
    "either": Operation("{} | {}", operator.or_, np.logical_or, bool),
    "select": Operation("{1} if {0} else {2}", _either, _select),
}


def function_of(
    arguments: list[str], lines: list[str], names: Mapping[str, Any]
) -> Callable[..., Any]:
    """Return the function with that text, of which every word was written by this program."""
    space = dict(names)
    exec("\n    ".join([f"def program({', '.join(arguments)}):", *lines]), space)
    function: Callable[..., Any] = space["program"]
    return function
