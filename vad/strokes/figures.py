"""How numbers and letters are written on the sheet."""

from __future__ import annotations

import math

MINUS = "\u2212"
PRIME = "\u2032"
_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def figure(value: float, digits: int = 4) -> str:
    """Write a measured value with four significant digits, without an exponent where it can be.

    Examples
    --------
    >>> [figure(x) for x in (490.0281, -3005.2, 57549.8, 0.0588235, 1.6e9, 0.0)]
    ['490.0', '−3005', '57550', '0.05882', '1.600×10⁹', '0']
    """
    if value == 0.0 or not math.isfinite(value):
        return "0" if value == 0.0 else str(value)
    mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    power = int(exponent)
    if -4 <= power < 7:
        # Rounded to the digits first: 57549.8 reads 57550.
        text = f"{float(f'{mantissa}e{exponent}'):.{max(digits - 1 - power, 0)}f}"
    else:
        text = f"{mantissa}×10{str(power).translate(_SUPERSCRIPTS)}"
    return text.replace("-", MINUS)


def given(value: float) -> str:
    """Write a given value as it was given, up to six digits.

    Examples
    --------
    >>> [given(x) for x in (60.0, -11.59, 0.0588235294)]
    ['60', '−11.59', '0.0588235']
    """
    if value and not 1e-4 <= abs(value) < 1e7:
        return figure(value)
    return f"{value + 0.0:.6g}".replace("-", MINUS) if abs(value) < 1e6 else figure(value, 7)


def squared(text: str) -> str:
    """Write the square of a written number.

    Examples
    --------
    >>> squared("2.432"), squared("2.583×10⁻⁵")
    ('2.432²', '(2.583×10⁻⁵)²')
    """
    return f"({text})²" if "×" in text else f"{text}²"


def degrees(value: float) -> str:
    """Write a measured angle with one decimal.

    Examples
    --------
    >>> degrees(338.2132)
    '338.2°'
    """
    return f"{value:.1f}°".replace("-", MINUS)


def subscript(number: int) -> str:
    """Write a whole number as a subscript.

    Examples
    --------
    >>> "ω" + subscript(3)
    'ω₃'
    """
    return str(number).translate(_SUBSCRIPTS)


def per_second(unit: str, order: int) -> str:
    """Write the unit of a derivative: mm, mm/s, mm/s²."""
    return unit + ("", "/s", "/s²")[order]
