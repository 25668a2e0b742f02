"""How a caption calculates, read back: chains of equations, and the figures in them.

In comes a caption: ``bc = 340.5 mm/s, so ω₃ = bc/BC = 340.5/140 = 2.432 rad/s``.
Out go its chains, one for ``bc`` and one for ``ω₃``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

THIN = "\N{NARROW NO-BREAK SPACE}"
FIGURE = re.compile(rf"−?\d+(?:{THIN}\d{{3}})*(?:[.,]\d+)?(?:×10[⁻⁰¹²³⁴-⁹]+)?")
SINE = re.compile(rf"sin\(({FIGURE.pattern})°\)")
CARRIED = re.compile(rf"({FIGURE.pattern}) (?:[a-z]+/s²?|m)(?!\w)")
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
PLAIN = str.maketrans({"−": "-", ",": ".", THIN: ""})
FLOATS = 1e-9  # what is left of double precision


@dataclass(frozen=True)
class Figure:
    """A number as it is written, and the unit behind it."""

    text: str
    unit: str = ""

    @cached_property
    def value(self) -> float:
        return float(self._plain)

    @cached_property
    def half_a_unit(self) -> float:
        """Half a unit of the last place: the most that rounding has taken or added.

        A measured number has four digits at least; an angle has one decimal.  Less than that
        is a given number, which is written in full up to six digits.
        """
        digits = len(re.sub(r"e.*|\D", "", self._plain).lstrip("0"))
        is_given = digits < 4 and not (self.unit == "°" and "." in self._plain)
        return float(self.last_place / 2) * (10.0 ** (digits - 6) if is_given else 1.0)

    @cached_property
    def exact(self) -> Fraction:
        """The number that a calculator is given."""
        return Fraction(self._plain)

    @cached_property
    def last_place(self) -> Fraction:
        """One unit of the last digit that is written."""
        mantissa, _, power = self._plain.partition("e")
        return Fraction(10) ** (int(power or 0) - len(mantissa.partition(".")[2]))

    @cached_property
    def _plain(self) -> str:
        mantissa, _, power = self.text.translate(PLAIN).partition("×10")
        return mantissa + (f"e{power.translate(RAISED)}" if power else "")

    def agrees(self, truth: float) -> bool:
        """Tell whether it is ``truth``, to the digits written."""
        return abs(self.value - truth) <= self.half_a_unit + FLOATS * abs(truth)


@dataclass(frozen=True)
class Side:
    """One side of an equation: factors, each with its power."""

    factors: tuple[tuple[str, int], ...]

    @classmethod
    def read(cls, text: str) -> Side:
        """Read ``2 × 4.853 × 1202``, ``(1.2×10⁶)² × 3``, ``ω₃²·BC`` or ``dc/BC``.

        Factors may have units: ``(10 rad/s)² × 0.06 m``, ``(3 m/s)/(0.1 m)``.  The sine of an angle
        in figures is a figure.
        """
        text = SINE.sub(_sine, CARRIED.sub(r"\1", text))
        above, _, below = text.partition("/")
        found = [(part, 1) for part in re.split(r" × |·", above)]
        found += [(part, -1) for part in ([below] if below else [])]
        return cls(tuple((_bare(part), sign * _power(part)) for part, sign in found))

    @property
    def in_figures(self) -> bool:
        """Whether it is written in figures, not in symbols."""
        return all(FIGURE.fullmatch(factor) for factor, _ in self.factors)


def _sine(found: re.Match[str]) -> str:
    """Write the sine of an angle as a calculator shows it."""
    return f"{math.sin(math.radians(Figure(found[1]).value)):.15f}".replace("-", "−")


def _power(factor: str) -> int:
    return 2 if factor.endswith("²") and "×10²" not in factor else 1


def _bare(factor: str) -> str:
    return (factor.removesuffix("²") if _power(factor) == 2 else factor).strip("() ")


@dataclass(frozen=True)
class Chain:
    """``symbol = symbols = figures = result unit``; the two in the middle may be left out.

    ``rest`` are the words that follow.
    """

    symbol: str
    sides: tuple[Side, ...]
    result: Figure | None
    rest: str

    def factors(self) -> Iterator[tuple[str, int, str, int]]:
        """Yield the symbols of its product or quotient with the figures put for them."""
        named = [side for side in self.sides if not side.in_figures]
        counted = [side for side in self.sides if side.in_figures]
        for symbols, figures in zip(named[-1:], counted, strict=True):
            for one, other in zip(symbols.factors, figures.factors, strict=True):
                yield *one, *other


def chains(caption: str) -> Iterator[Chain]:
    """Read the equations of a caption."""
    for sentence in re.split(r"[,;:] ", caption.rstrip(".")):
        first, *parts = sentence.split(" = ")
        last = re.match(rf"({FIGURE.pattern}) ?((?:°|[a-z])\S*)", parts[-1]) if parts else None
        result, rest = (Figure(*last.groups()), parts.pop()[last.end() :]) if last else (None, "")
        symbol = first.split(" ")[-1] if parts or result else ""
        rest = rest if symbol else first
        yield Chain(symbol, tuple(map(Side.read, parts)), result, rest)
