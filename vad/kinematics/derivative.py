"""The exact derivative of a recorded number by an input: each operation by its own rule.

What is recorded once is known as a chain of operations, and the derivative of each operation is
another few (forward differentiation; A. Griewank and A. Walther, *Evaluating Derivatives*).  So
every result has a derivative to full precision by the driver's place, and where it turns back is a
root instead of a search for the largest value.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from vad.kinematics.numbers import select
from vad.kinematics.program import needed
from vad.kinematics.recording import Operand, Recorded


def derivative(number: Operand, by: Recorded) -> Operand:
    """Return the derivative of a recorded number by an input, all other inputs being constant.

    Where a number jumps it is that beside the jump; steps of a choice count as constant.

    Examples
    --------
    >>> from vad.kinematics.program import Program
    >>> from vad.kinematics.recording import Tape
    >>> x = Tape().input("x")
    >>> import numpy as np
    >>> Program([x], [derivative(x * x + 3.0 * x, x)]).many([np.array([2.0])], 1)[0]
    array([7.])
    """
    if not isinstance(number, Recorded):
        return 0.0
    known: dict[str, Operand] = {by.name: 1.0}
    for step in needed([by], [number]):
        rule = _RULES.get(step.operation)
        slopes = [known.get(x.name, 0.0) if isinstance(x, Recorded) else 0.0 for x in step.operands]
        if rule and not all(isinstance(slope, float) and slope == 0.0 for slope in slopes):
            known[step.name] = rule(step, *step.operands, *slopes)
    return known.get(number.name, 0.0)


def _times(one: Operand, other: Operand) -> Operand:
    """Return a product, which is zero where a factor is zero."""
    if any(isinstance(x, float) and x == 0.0 for x in (one, other)):
        return 0.0
    return one * other


def _unless(condition: Operand, rare: Operand, usual: Operand) -> Operand:
    both_constant = isinstance(rare, float) and isinstance(usual, float)
    return rare if both_constant and rare == usual else select(condition, rare, usual)


def _copysign(step: Recorded, size: Operand, sign: Operand, ds: Operand, _: Operand) -> Operand:
    slope = _unless(size < 0.0, -ds, ds)
    return _unless(step < 0.0, -slope, slope)


def _angle(step: Recorded, y: Operand, x: Operand, dy: Operand, dx: Operand) -> Operand:
    return (_times(x, dy) - _times(y, dx)) / (x * x + y * y)


def _quotient(step: Recorded, x: Operand, y: Operand, dx: Operand, dy: Operand) -> Operand:
    return (dx - _times(step, dy)) / y


def _select(
    step: Recorded, of: Operand, rare: Operand, usual: Operand, *slopes: Operand
) -> Operand:
    _, at_rare, at_usual = slopes
    if isinstance(of, Recorded) and of.operation == "equal":  # in a single place, as at 30°
        return at_usual
    return _unless(of, at_rare, at_usual)


# The rule of an operation takes its result, its operands, and their derivatives.  What is not here
# is constant but for jumps.
_RULES: dict[str, Callable[..., Any]] = {
    "fold": lambda step, x, dx: dx,
    "copy": lambda step, x, dx: dx,
    "add": lambda step, x, y, dx, dy: dx + dy,
    "subtract": lambda step, x, y, dx, dy: dx - dy,
    "multiply": lambda step, x, y, dx, dy: _times(dx, y) + _times(x, dy),
    "divide": _quotient,
    "negative": lambda step, x, dx: -dx,
    "absolute": lambda step, x, dx: _unless(x < 0.0, -dx, dx),
    "minimum": lambda step, x, y, dx, dy: _unless(x < y, dx, dy),
    "maximum": lambda step, x, y, dx, dy: _unless(x > y, dx, dy),
    "sqrt": lambda step, x, dx: dx / (2.0 * step),
    "copysign": _copysign,
    "arctan2": _angle,
    "select": _select,
}
