"""How numbers and quantities are written, by one rule for captions, tables, scale bars and axes.

A measured value has four significant digits, or all digits before the point if these are more.  A
given value is written as it was given, and a measured angle has one decimal.  `typed` is for the
terminal, from which numbers are copied.  Files for machines hold numbers in full.
"""

from __future__ import annotations

import math
import re
from functools import lru_cache

MINUS = "\N{MINUS SIGN}"
PRIME = "\N{PRIME}"
THIN_SPACE = "\N{NARROW NO-BREAK SPACE}"
#: Significant digits of a measured value, and the most that a given one shows.
MEASURED, GIVEN = 4, 6
#: Significant digits of a table in plain text, from which numbers are copied, and the most of them.
DIGITS, MOST_DIGITS = 12, 17
#: Powers of ten whose digits are written out: the first of them, and the first that is not.
WRITTEN_OUT = (-4, 6)

#: Whole numbers with at least so many digits get a space between thousands.
_PARTED = 5
_THOUSANDS = re.compile(r"(?<=\d)(?=(?:\d{3})+$)")
DEGREE = "°"
_DEGREES = (DEGREE, "deg")
_FULL_TURN = 360.0
#: The digits of a subscript: ``"O4".translate(LOW)`` is "O₄".
LOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_LEVEL = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_SIGNS = {"deg": DEGREE, "^2": "²"}


def quantity(value: float, unit: str, given: bool = False) -> str:
    """Write a value with its unit.

    Parameters
    ----------
    value
        The value, in ``unit``.
    unit
        The unit's sign, as in mm/s² or °; empty for a bare number.
    given
        Whether the value was given, not measured.

    Examples
    --------
    >>> quantity(1234567.0, "mm/s²"), quantity(338.213, "°"), quantity(60.0, "mm", given=True)
    ('1.235×10⁶ mm/s²', '338.2°', '60 mm')
    """
    return with_unit(number(value, unit, given), unit)


def number(value: float, unit: str = "", given: bool = False) -> str:
    """Write a value without its unit, which decides how many digits it has.

    Parameters
    ----------
    value, unit, given
        As for `quantity`.

    Examples
    --------
    >>> number(359.97, "°"), number(359.97, "°", given=True), number(359.97, "mm")
    ('0.0', '359.97', '360.0')
    """
    return typeset(plain(value, unit, given))


@lru_cache(maxsize=1024)  # the same number is in results, captions and calculations
def plain(value: float, unit: str = "", given: bool = False, digits: int = 0) -> str:
    """Write a value as `number` does, but in the notation of programs.

    Parameters
    ----------
    value, unit, given
        As for `quantity`.
    digits
        The significant digits that it has at least, where those of its kind are too few.

    Examples
    --------
    >>> plain(-1234567.0), plain(2.30769), plain(2.30769, digits=5), plain(60.0, given=True)
    ('-1.235e+06', '2.308', '2.3077', '60')
    >>> plain(4.2536, "°"), plain(4.2536, "°", digits=4)
    ('4.3', '4.254')
    """
    if not math.isfinite(value):
        return "–"
    if given:
        return typed(value, unit, max(GIVEN, digits))
    if unit != DEGREE:
        return _rounded(value, max(MEASURED, digits))
    usual = f"{in_turn(value):.1f}"
    shown = len(usual.replace(".", "").lstrip("-0"))
    return usual if digits <= shown else _rounded(math.fmod(value, _FULL_TURN), digits)


def _rounded(value: float, digits: int) -> str:
    """Round to significant digits; a number that is written out keeps all before its point."""
    if value == 0.0:
        return "0"
    rounded = f"{value:.{digits - 1}e}"
    power = int(rounded.partition("e")[2])  # that of the rounded number: 9999.7 becomes 10000
    if WRITTEN_OUT[0] <= power < WRITTEN_OUT[1]:
        return f"{value:.{max(digits - 1 - power, 0)}f}"
    return rounded


def measured(value: float) -> str:
    """Write a measured value: a power of ten only from a million on.

    Examples
    --------
    >>> [measured(x) for x in (490.0281, -3005.2, 1234567.0, 0.0588235, 2e-5, 0.0)]
    ['490.0', '−3005', '1.235×10⁶', '0.05882', '2.000×10⁻⁵', '0']
    """
    return number(value)


def given(value: float) -> str:
    """Write a given value as it was given, up to six digits.

    Examples
    --------
    >>> [given(x) for x in (60.0, -11.59, 0.0588235294, 2e6)]
    ['60', '−11.59', '0.0588235', '2×10⁶']
    """
    return number(value, given=True)


def in_turn(angle: float) -> float:
    """Round a measured angle to its one decimal, within a full turn; it keeps its sign.

    Examples
    --------
    >>> in_turn(338.213), in_turn(359.97), in_turn(-0.04), in_turn(-30.0)
    (338.2, 0.0, 0.0, -30.0)
    """
    return round(math.fmod(round(angle, 1), _FULL_TURN), 1) + 0.0


def typed(value: float, unit: str = "", digits: int = GIVEN) -> str:
    """Write a value as it is typed, so that it can be copied into another program.

    Parameters
    ----------
    value
        The value.
    unit
        Its unit's sign or name: an angle below a full turn never reads 360.
    digits
        The most significant digits that it shows.

    Examples
    --------
    >>> typed(-490.02810237, digits=12), typed(359.9999999, "deg"), typed(1e-17)
    ('-490.02810237', '0', '1e-17')
    """
    text = f"{value + 0.0:.{digits}g}"
    full = unit in _DEGREES and abs(value) < _FULL_TURN <= abs(float(text))
    return "0" if full else text


@lru_cache(maxsize=1024)
def typeset(text: str, point: str = ".") -> str:
    """Turn a number in the notation of programs into print.

    That is the minus, the power of ten, thousands parted from five digits on, and the decimal
    ``point`` of a language.  Every number of the page passes here.

    Examples
    --------
    >>> typeset("-1.235e+06"), typeset("57549.8", ",").replace(THIN_SPACE, " "), typeset("5754")
    ('−1.235×10⁶', '57 549,8', '5754')
    """
    mantissa, exponent, power = text.partition("e")
    whole, dot, decimals = mantissa.replace("-", MINUS).partition(".")
    if len(whole.removeprefix(MINUS)) >= _PARTED:
        whole = _THOUSANDS.sub(THIN_SPACE, whole)
    tail = power_of_ten(int(power)) if exponent else ""
    return whole + (point if dot else "") + decimals + tail


def power_of_ten(power: int) -> str:
    """Write the factor after a mantissa.

    Examples
    --------
    >>> "1.235" + power_of_ten(-6)
    '1.235×10⁻⁶'
    """
    return "×10" + str(power).translate(_SUPERSCRIPTS)


def with_unit(text: str, unit: str) -> str:
    """Put a unit behind a written number; a degree sign stands close.

    Examples
    --------
    >>> with_unit("60", "°"), with_unit("160.0", "mm"), with_unit("2", "")
    ('60°', '160.0 mm', '2')
    """
    return text + ("" if unit == DEGREE or not unit else " ") + unit


def sign(unit: str) -> str:
    """Return the sign of a unit that is named as in `vad.units`.

    Examples
    --------
    >>> sign("deg"), sign("rad/s^2")
    ('°', 'rad/s²')
    """
    for name, written in _SIGNS.items():
        unit = unit.replace(name, written)
    return unit


def per_second(unit: str, order: int) -> str:
    """Write the unit of a derivative: mm, mm/s, mm/s²."""
    return unit + ("", "/s", "/s²")[order]


def squared(text: str) -> str:
    """Write the square of a written number.

    Examples
    --------
    >>> squared("2.432"), squared("2.583×10⁻⁵")
    ('2.432²', '(2.583×10⁻⁵)²')
    """
    return f"({text})²" if "×" in text else f"{text}²"


def subscript(number: int) -> str:
    """Write a whole number as a subscript.

    Examples
    --------
    >>> "ω" + subscript(3)
    'ω₃'
    """
    return str(number).translate(LOW)


def numbered(symbol: str) -> tuple[str, str]:
    """Return a symbol without its body's number, and that number, empty where it has none.

    Examples
    --------
    >>> numbered("ω₃"), numbered("v")
    (('ω', '3'), ('v', ''))
    """
    bare = symbol.rstrip("₀₁₂₃₄₅₆₇₈₉")
    return bare, symbol[len(bare) :].translate(_LEVEL)


def base_name(slide: str) -> str:
    """Return the word for a slide, without what tells it from others of that word.

    Examples
    --------
    >>> base_name("piston_b"), base_name("ram")
    ('piston', 'ram')
    """
    return slide.split("_", maxsplit=1)[0]
