"""Functions of `math` that also take traced numbers; angles are in degrees.

Of floats they give the bits of `math`.
"""

from __future__ import annotations

import cmath
import math
from typing import Any

from vad.kinematics.symbol import Symbol, as_float, is_symbolic

#: Powers of a traced number up to this one are products.
_HIGHEST = 16


def hypot(x: float, y: float) -> float:
    """Return the length of a vector."""
    if is_symbolic(x) or is_symbolic(y):
        return sqrt(x * x + y * y)
    return math.hypot(x, y)


def sqrt(value: float) -> float:
    """Return the square root."""
    return _noted("sqrt", value) if isinstance(value, Symbol) else math.sqrt(value)


def arcsine(ratio: float) -> float:
    """Return the angle with a sine, within ±90°."""
    if isinstance(ratio, Symbol):
        return bearing(ratio, _leg(ratio))
    return math.degrees(math.asin(ratio))


def arccosine(ratio: float) -> float:
    """Return the angle with a cosine, within 0° and 180°."""
    if isinstance(ratio, Symbol):
        return bearing(_leg(ratio), ratio)
    return math.degrees(math.acos(ratio))


def arctangent(slope: float) -> float:
    """Return the angle with a tangent, within ±90°."""
    if isinstance(slope, Symbol):
        return bearing(slope, 1.0)
    return math.degrees(math.atan(slope))


def bearing(y: float, x: float) -> float:
    """Return the direction of a vector, within ±180°."""
    if isinstance(y, Symbol) or isinstance(x, Symbol):
        return _noted("arctan2", y, x) * math.degrees(1.0)
    return math.degrees(math.atan2(y, x))


def power(base: float, exponent: float) -> float:
    """Return a power; of a traced number a whole one, or the square root of such a power."""
    if not (isinstance(base, Symbol) or isinstance(exponent, Symbol)):
        return math.pow(base, exponent)
    twice = 2.0 * as_float(exponent)
    if isinstance(twice, Symbol) or twice != round(twice) or abs(twice) > 2 * _HIGHEST:
        return math.pow(pinned(base), pinned(exponent))
    whole = math.prod([base] * (abs(round(twice)) // 2)) * (sqrt(base) if twice % 2.0 else 1.0)
    return 1.0 / whole if twice < 0.0 else whole


def pinned(value: float) -> float:
    """Return a traced number as a constant, after the decision that it has this value."""
    if not isinstance(value, Symbol):
        return value
    constant = float(value)
    if value == constant:
        return constant
    raise ValueError("it has no value")


def unit_at(degrees: float) -> complex:
    """Return the unit vector at an angle of any number of turns."""
    if isinstance(degrees, Symbol):
        from vad.kinematics.numbers import ray  # mechanisms alone do not need it

        traced: complex = ray(degrees)
        return traced
    return cmath.rect(1.0, math.radians(math.remainder(degrees, 360.0)))


def sine(degrees: float) -> float:
    """Return the sine of an angle of any number of turns."""
    if isinstance(degrees, Symbol):
        return unit_at(degrees).imag
    folded = math.remainder(degrees, 360.0)
    beyond = abs(folded) > 90.0
    return math.sin(math.radians(math.copysign(180.0, folded) - folded if beyond else folded))


def _leg(ratio: float) -> float:
    """Return the other leg of a right-angled triangle with the hypotenuse 1."""
    return sqrt((1.0 - ratio) * (1.0 + ratio))


def _noted(operation: str, *operands: Any) -> Any:
    symbol = next(each for each in operands if isinstance(each, Symbol))
    return symbol.note(operation, *operands)
