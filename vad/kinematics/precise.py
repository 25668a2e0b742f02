"""The direction of an angle in degrees, to more digits than a double has."""

from __future__ import annotations

from fractions import Fraction

from vad.kinematics.numbers import Number, ray
from vad.kinematics.symbol import Symbol

_BITS = 160
_PI = Fraction(314159265358979323846264338327950288419716939937510582097494459, 10**62)
_TERMS = 40  # of the series: the last one is below 10⁻⁵⁰ within an eighth of a turn


def exact_direction(degrees: Number) -> tuple[Number, Number]:
    """Return cosine and sine of an angle, to forty digits; of a traced one as a double has them.

    Examples
    --------
    >>> exact_direction(-90.0)
    (Fraction(0, 1), Fraction(-1, 1))
    >>> [float(x) for x in exact_direction(30.0)]
    [0.8660254037844386, 0.5]
    """
    if isinstance(degrees, Symbol):
        unit = ray(degrees)
        return unit.real, unit.imag
    quarters, beyond = divmod(Fraction(degrees) + 45, 90)
    angle = round((beyond - 45) * _PI / 180 * 2**_BITS)
    term, sums = 1 << _BITS, [0, 0]
    for k in range(_TERMS):
        sums[k % 2] += -term if k % 4 > 1 else term
        term = (term * angle >> _BITS) // (k + 1)
    x, y = (Fraction(part, 2**_BITS) for part in sums)
    for _ in range(quarters % 4):
        x, y = -y, x
    return x, y
