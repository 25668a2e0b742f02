"""How numbers read on the page: four significant digits, angles one decimal.

In come values and units, out go strings.
"""

from __future__ import annotations

import math

from vad.diagrams.strokes import Cell

_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def plain(value: float) -> str:
    """Return a given value as it was likely typed, with a typographic minus.

    Examples
    --------
    >>> plain(-30.0), plain(0.05), plain(2000000.0)
    ('−30', '0.05', '2×10⁶')
    """
    return _typeset(f"{value:.6g}")


def measured(value: float) -> str:
    """Return a measured value with four significant digits.

    Examples
    --------
    >>> measured(160.0), measured(-3005.4), measured(1234567.0), measured(0.0)
    ('160.0', '−3005', '1.235×10⁶', '0')
    """
    if value == 0 or not math.isfinite(value):
        return "0" if value == 0 else "–"
    return _typeset(f"{value:#.4g}" if abs(value) < 99999.5 else _large(value))


def _large(value: float) -> str:
    # Up to a million the digits are easier to read than a power of ten.
    if abs(value) < 999950:
        return f"{round(value, -int(math.floor(math.log10(abs(value)))) + 3):.0f}"
    return f"{value:.3e}"


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
