"""Numbers as people write them: "6 cm" becomes 60.0, and "120 rpm" becomes 12.56….

A bare number is in the unit of the scene and is taken as it is.  Conversion uses 28 decimal digits
and rounds once.  Pint is loaded only when a unit is written.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING

from vad import gate
from vad.errors import UsageError, quoted

if TYPE_CHECKING:
    from pint import UnitRegistry

_SCENE = {
    "length": "{}",
    "angle": "deg",
    "omega": "rad/s",
    "alpha": "rad/s^2",
    "position": "{}",
    "velocity": "{}/s",
    "acceleration": "{}/s^2",
    "number": "",
    "force": "N",
    "couple": "N m",
    "mass": "kg",
    "inertia": "kg m^2",
    "gravity": "m/s^2",
    "direction": "deg",
    "friction": "",
}
# What a quantity is called in a sentence, and a few of its units.
_WORDS = {
    "length": ("a unit of length", "mm, cm, m, in, ft"),
    "angle": ("a unit of angle", "deg, rad, turn"),
    "omega": ("a unit of turning speed", "rad/s, deg/s, rpm"),
    "alpha": ("a unit of angular acceleration", "rad/s^2, deg/s^2, rpm/s"),
    "position": ("a unit of length", "mm, cm, m, in, ft"),
    "velocity": ("a unit of velocity", "mm/s, m/s, ft/min"),
    "acceleration": ("a unit of acceleration", "mm/s^2, m/s^2, ft/s^2"),
    "number": ("a unit of length or angle", "mm, cm, m, in, deg"),
    "force": ("a unit of force", "N, kN, lbf"),
    "couple": ("a unit of moment", "N m, kN m, lbf in, lbf ft"),
    "mass": ("a unit of mass", "kg, g, t, lb"),
    "inertia": ("a unit of moment of inertia", "kg m^2, kg cm^2, lb in^2"),
    "gravity": ("a unit of acceleration", "m/s^2, ft/s^2"),
    "direction": ("a unit of angle", "deg, rad, turn"),
    "friction": ("a unit of friction, which has none", "0.1"),
}
#: The quantities of dimensions; a plain number has no unit.
DIMENSIONS = ("length", "angle", "number")
#: The usual units of length.
LENGTH_UNITS = ("mm", "cm", "m", "km", "in", "ft", "yd")
_METRES = {
    "mm": 0.001, "cm": 0.01, "m": 1.0, "km": 1000.0, "in": 0.0254, "ft": 0.3048, "yd": 0.9144,
}  # fmt: skip

# Not pint's own table: here a radian is no mere number, so that "2 Hz" is not taken for 2 rad/s,
# nor "50 percent" for half a radian.
_DEFINITIONS = """
micro- = 1e-6 = µ- = μ- = u-
milli- = 1e-3 = m-
centi- = 1e-2 = c-
kilo- = 1e3 = k-
metre = [length] = m = meter
inch = 25.4 * millimetre = in = inches
foot = 12 * inch = ft = feet
yard = 3 * foot = yd
mile = 1760 * yard = mi
radian = [angle] = rad
turn = 6.28318530717958647692528676655900577 * radian = _ = rev = revolution
degree = turn / 360 = deg = °
gon = turn / 400 = _ = grad
second = [time] = s = sec
minute = 60 * second = min
hour = 60 * minute = h
rpm = turn / minute
rps = turn / second
gram = [mass] = g
tonne = 1000 * kilogram = t
pound = 0.45359237 * kilogram = lb
slug = pound_force * second ** 2 / foot
newton = kilogram * metre / second ** 2 = N
pound_force = 4.4482216152605 * newton = lbf
kilogram_force = 9.80665 * newton = kgf
ounce_force = pound_force / 16 = ozf
""".strip().splitlines()

#: Longer texts are refused, because the time to read one grows with the square of its length.
_LONGEST, _LONGEST_UNIT = 1000, 60
_WRITTEN = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\W\d_].*?|°.*?)\s*")
_POWER = r"(?:(?:\^|\*\*)-?[1-3]|⁻?[¹²³])?"
_NAME = rf"(?:[^\W\d_]+|°){_POWER}"
_UNIT = re.compile(rf"{_NAME}(?:(?:\s*[/*·]\s*|\s+){_NAME}){{0,3}}")


def scene_unit(quantity: str, length_unit: str = "mm") -> str:
    """Return the unit in which the program takes and gives a quantity.

    Parameters
    ----------
    quantity
        One of length, angle, omega, alpha, position, velocity and acceleration; of force, couple,
        mass, inertia, gravity, direction and friction; or number, which has no unit, and is read as
        a length or an angle where it is written with one.
    length_unit
        The unit of the scene's lengths.

    Examples
    --------
    >>> scene_unit("acceleration", "ft")
    'ft/s^2'
    """
    return _SCENE[quantity].format(length_unit)


def read(text: str, quantity: str, length_unit: str = "mm") -> float:
    """Return the number that ``text`` says, in the scene's unit.

    Parameters
    ----------
    text
        A number in any notation, with or without a unit.
    quantity, length_unit
        As for `scene_unit`.

    Raises
    ------
    UsageError
        If it is no number, or its unit is unknown or of another quantity.

    Examples
    --------
    >>> read("-4e-05", "alpha"), read("6 cm", "length"), read("90deg/s", "omega")
    (-4e-05, 60.0, 1.5707963267948966)
    """
    text = text.replace("\N{MINUS SIGN}", "-")
    try:
        return float(text)
    except ValueError:
        written = _WRITTEN.fullmatch(text) if len(text) <= _LONGEST else None
    if written is None:
        raise UsageError(f"{quoted(text)} is not a number", hint=_example(text, quantity))
    number, unit = written.groups()
    factor = _factor(unit, quantity, length_unit)
    value = float(number)
    if value == 0.0 or math.isinf(value):
        return value  # decimal arithmetic would choke on an exponent of twenty digits
    return float(Decimal(number) * factor)


def number_of(name: str, value: object, quantity: str, length_unit: str = "mm") -> float:
    """Return a number, or a text with a unit, as a finite float in the scene's unit.

    Parameters
    ----------
    name
        How errors call it; they begin with it unless it is empty.
    value
        A number or a text: anything, for it comes from outside.
    quantity, length_unit
        As for `scene_unit`.

    Raises
    ------
    vad.errors.UsageError
        For a text that says no number of this quantity.
    vad.errors.InputError
        For anything else that is no finite number.

    Examples
    --------
    >>> number_of("crank", "6 cm", "length"), number_of("crank", 60, "length")
    (60.0, 60.0)
    """
    if isinstance(value, str):
        try:
            value = read(value, quantity, length_unit)
        except UsageError as error:
            raise UsageError(f"{name}: {error}" if name else str(error), error.hint) from None
    return gate.number(name, value)


def _example(text: str, quantity: str) -> str:
    """Return what to write in place of ``text``."""
    if re.search(r"\d,\d", text):
        return "with a point, as in 1.5"
    return f"write 60 or '60 {_WORDS[quantity][1].split(',')[0]}'"


@cache
def metres_of(length_unit: str) -> float | None:
    """Return how many metres a unit of length has; None for a word that is no unit.

    Examples
    --------
    >>> metres_of("mm"), metres_of("ft"), metres_of("squares")
    (0.001, 0.3048, None)
    """
    if length_unit in _METRES:
        return _METRES[length_unit]
    try:
        return float(_factor(length_unit, "length", "m"))
    except UsageError:
        return None


def check_length_unit(name: str) -> str:
    """Return ``name`` if lengths can be given in it.

    Raises
    ------
    UsageError
        If it is not the name of a unit of length.

    Examples
    --------
    >>> check_length_unit("ft")
    'ft'
    """
    if name not in LENGTH_UNITS:
        _factor(name if name.isalpha() else "", "length", "mm", written=name)
    return name


def _factor(unit: str, quantity: str, length_unit: str, written: str | None = None) -> Decimal:
    """Return how many of the scene's unit make one ``unit``, which was given as ``written``."""
    what, examples = _WORDS[quantity]
    name = quoted(unit if written is None else written)
    wrong = UsageError(f"{name} is not {what}", f"try {examples}")
    if len(unit) > _LONGEST_UNIT or not _UNIT.fullmatch(unit) or quantity == "friction":
        raise wrong
    registry = _registry()
    targets = [scene_unit(quantity, length_unit)]
    if quantity == "number":
        targets = [scene_unit(kind, length_unit) for kind in ("length", "angle")]
    for target in targets:
        try:
            one = registry.Quantity(Decimal(1), registry.parse_units(unit))
            return Decimal(one.to(target).magnitude)
        except Exception:  # an unknown unit, or a word that pint reads as a number: nan, inf
            continue
    raise wrong


@cache
def _registry() -> UnitRegistry[Decimal]:
    """Return the table of units; the first call loads pint."""
    from pint import UnitRegistry

    registry: UnitRegistry[Decimal] = UnitRegistry(None, non_int_type=Decimal)
    registry.load_definitions(_DEFINITIONS)
    return registry
