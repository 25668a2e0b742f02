"""How numbers read on the page: four significant digits, angles one decimal.

In come values and units, out go strings.
"""

from __future__ import annotations

import math

from vad.strokes.sheet import Cell

_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def plain(value: float) -> str:
    """Return a given value as it was likely typed, with a typographic minus.

    Examples
    --------
    >>> plain(-30.0), plain(0.05), plain(2e6)
    ('−30', '0.05', '2×10⁶')
    """
    return _typeset(f"{value:.5g}")


def measured(value: float) -> str:
    """Return a measured value with four significant digits.

    Examples
    --------
    >>> measured(160.0), measured(-3005.4), measured(17321.0), measured(1234567.0)
    ('160.0', '−3005', '17320', '1.235×10⁶')
    """
    if value == 0 or not math.isfinite(value):
        return "0" if value == 0 else "–"
    if 9999.5 <= abs(value) < 999950:
        # Up to a million the digits are easier to read than a power of ten.
        return _typeset(f"{round(value, 3 - math.floor(math.log10(abs(value)))):.0f}")
    return _typeset(f"{value:#.4g}")


def _typeset(text: str) -> str:
    mantissa, _, power = text.partition("e")
    mantissa = mantissa.removesuffix(".").replace("-", "−")
    return mantissa + ("×10" + str(int(power)).translate(_RAISED) if power else "")


def number(cell: Cell) -> str:
    """Return a cell's value: given ones plain, angles with one decimal.

    Examples
    --------
    >>> number(Cell("θ", 338.21, "°")), number(Cell("θ", 60.0, "°", given=True))
    ('338.2', '60')
    """
    if cell.given:
        return plain(cell.value)
    if cell.unit == "°":
        # 359.97° is 0.0°, not 360.0°.
        return _typeset(f"{round(cell.value, 1) % 360 if cell.value >= 0 else cell.value:.1f}")
    return measured(cell.value)


def with_unit(value: str, unit: str) -> str:
    """Return a value with its unit; a degree sign stands close.

    Examples
    --------
    >>> with_unit("60", "°"), with_unit("160.0", "mm")
    ('60°', '160.0 mm')
    """
    return value + ("" if unit == "°" or not unit else " ") + unit
