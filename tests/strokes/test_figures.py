"""Every figure in a caption, against the data; and its arithmetic, as a pocket calculator does it.

A caption calculates in chains: ``bc = 340.5 mm/s``, ``ω₃ = bc/BC = 340.5/140 = 2.432 rad/s``.
A figure is wrong by half a unit of its last place at most: that is the bound for each figure
against the data, and, carried through products and quotients, for each chain against itself.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from tests.strokes.motions import (
    ORDERS,
    between,
    drawn,
    everything,
    in_every_language,
    poses,
    strokes,
    vector,
)
from vad.kinematics.linkage import Slide
from vad.kinematics.motion import Motion
from vad.strokes.language import Language
from vad.strokes.sheet import Arrow, Panel, Sheet, Stroke
from vad.strokes.words import describe

FIGURE = re.compile(r"−?\d+(?:\.\d+)?(?:×10[⁻⁰¹²³⁴-⁹]+)?")
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
UNITS = {"ω": "rad/s", "α": "rad/s²", "θ": "°"}
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

        A measured number has four digits, then zeros; an angle has one decimal.  Less than that
        is a given number, which is written in full up to six digits.
        """
        mantissa, _, power = self._plain.partition("e")
        whole, _, decimals = mantissa.lstrip("-").partition(".")
        place = -len(decimals)
        digits = len((whole + decimals).lstrip("0"))
        if not decimals and digits > 4:
            place = digits - 4
        elif digits < 4 and not (self.unit == "°" and place == -1):
            place = digits - 6 - len(decimals)
        return 0.5 * 10.0 ** (place + int(power or 0))

    @cached_property
    def _plain(self) -> str:
        mantissa, _, power = self.text.replace("−", "-").partition("×10")
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
        """Read ``2 × 4.853 × 1202``, ``(1.2×10⁶)² × 3``, ``ω₃²·BC`` or ``dc/BC``."""
        above, _, below = text.partition("/")
        found = [(part, 1) for part in re.split(r" × |·", above)]
        found += [(part, -1) for part in ([below] if below else [])]
        return cls(tuple((_bare(part), sign * _power(part)) for part, sign in found))

    @property
    def in_figures(self) -> bool:
        """Whether it is written in figures, not in symbols."""
        return all(FIGURE.fullmatch(factor) for factor, _ in self.factors)


def _power(factor: str) -> int:
    return 2 if factor.endswith("²") and "×10²" not in factor else 1


def _bare(factor: str) -> str:
    return factor.removesuffix("²").strip("()") if _power(factor) == 2 else factor


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


class Data:
    """What a symbol in a caption stands for."""

    def __init__(self, motion: Motion, panel: Panel, stroke: Stroke) -> None:
        self.motion, self.panel, self.stroke = motion, panel, stroke

    @property
    def slide(self) -> Slide:
        steps = (step for step in self.motion.frame.steps if isinstance(step, Slide))
        return next(step for step in steps if step.name == self.stroke.link)

    @property
    def link(self) -> str:
        along = self.slide.along if self.stroke.component == "coriolis" else self.stroke.link
        assert isinstance(along, str)
        return along

    def __getitem__(self, symbol: str) -> float:
        """Return the value of a symbol; the rates of a product or quotient have no sign."""
        motion, order = self.motion, ORDERS[self.panel.name]
        if symbol[0] in "ωα":
            link = motion.link(self.link)
            return abs(link.omega if symbol[0] == "ω" else link.alpha)
        if symbol == "θ":
            return float(motion.link(str(self.stroke.link)).angle)
        if symbol in ("x", "y", "s", "v", "a"):
            slide = motion.slide(self.slide.name)
            value = {"v": slide.velocity, "a": slide.acceleration}.get(symbol, slide.position)
            return abs(value) if self.stroke.component == "coriolis" else float(value)
        if symbol == self.stroke.label and order:
            return abs(vector(self.stroke))
        if re.fullmatch("[A-Z]{2}", symbol):
            return abs(between(motion, symbol))
        return abs(between(motion, symbol.replace("′", "").upper(), order))


@in_every_language
@everything
def test_every_figure_agrees_with_the_data(name: str, code: str) -> None:
    for motion, panel, stroke in strokes(name, code):
        data = Data(motion, panel, stroke)
        read = 0
        for chain in chains(stroke.caption):
            if chain.result:
                read += 1
                assert chain.result.agrees(data[chain.symbol]), (stroke.caption, chain)
                unit = UNITS.get(chain.symbol[0], panel.unit)
                assert chain.result.unit == unit, stroke.caption
            for symbol, power, figure, again in chain.factors():
                read += 1
                truth = 2.0 if symbol == "2" else data[symbol]
                assert power == again and Figure(figure).agrees(truth), stroke.caption
            for figure, truth in _said_in_words(chain.rest, panel, stroke, data):
                read += 1
                assert figure.agrees(truth), stroke.caption
        # Of 2·ω·v, the 2 is part of the formula.
        written = FIGURE.findall(stroke.caption.replace("2·", ""))
        assert len(written) == read, stroke.caption


def _said_in_words(
    words: str, panel: Panel, stroke: Stroke, data: Data
) -> Iterator[tuple[Figure, float]]:
    """Yield figures outside of equations, with the truth: at 60°, 50 mm from D, at 5 mm."""
    for text, degrees in re.findall(rf"({FIGURE.pattern})(°?)", words):
        if not degrees:
            is_bar = isinstance(stroke.shape, Arrow)
            yield Figure(text), abs(vector(stroke)) if is_bar else data["s"]
        elif panel.name == "position":
            yield Figure(text), data["θ"]
        else:
            yield Figure(text), 90.0  # turned by a right angle


@in_every_language
@everything
def test_every_formula_holds(name: str, code: str) -> None:
    """The vector is ω·AB, ω is bc/BC, and vectors of one link are as its bars."""
    for motion, panel, stroke in strokes(name, code):
        data = Data(motion, panel, stroke)
        for chain in chains(stroke.caption):
            named = [
                side for side in (Side.read(chain.symbol), *chain.sides) if not side.in_figures
            ]
            if len(named) > 1:
                truth, *others = [
                    math.prod((float(x) if x == "2" else data[x]) ** p for x, p in side.factors)
                    for side in named
                ]
                assert all(abs(x - truth) <= FLOATS * abs(truth) for x in others), stroke.caption


@in_every_language
@everything
def test_the_arithmetic_of_a_caption_agrees_with_itself(name: str, code: str) -> None:
    for _, _, stroke in strokes(name, code):
        for chain in chains(stroke.caption):
            for side in chain.sides:
                if chain.result is None or not side.in_figures:
                    continue
                product, most = 1.0, 1.0
                for text, power in side.factors:
                    factor = Figure(text)
                    doubt = 0.0 if text == "2" else factor.half_a_unit / abs(factor.value)
                    product *= factor.value**power
                    most *= (1 + doubt) ** power if power > 0 else 1 / (1 - doubt)
                bound = abs(product) * (most - 1) + chain.result.half_a_unit
                off = abs(product - chain.result.value)
                assert off <= bound * (1 + FLOATS), stroke.caption


@in_every_language
@everything
def test_caption_and_table_write_one_quantity_one_way(name: str, code: str) -> None:
    for motion in poses(name):
        sheet = drawn(motion, code)
        table = _table(sheet)
        for panel in sheet.panels:
            for stroke in panel.strokes:
                for (key, symbol), text in _quantities(motion, panel, stroke):
                    # Of ω and α a caption says the size, and in words the sense.
                    sized = symbol in "ωα" or stroke.component == "coriolis"
                    cell = table[key, symbol].partition(" ")[0].rstrip("°")
                    assert text == (cell.lstrip("−") if sized else cell), stroke.caption


def _quantities(
    motion: Motion, panel: Panel, stroke: Stroke
) -> Iterator[tuple[tuple[str, str], str]]:
    """Yield the quantities of a caption that have a cell, by row and symbol, as text."""
    data = Data(motion, panel, stroke)
    for chain in chains(stroke.caption):
        written = [(symbol, figure) for symbol, _, figure, _ in chain.factors()]
        written += [(chain.symbol, chain.result.text)] if chain.result else []
        for symbol, text in written:
            if symbol[0] in "ωα":
                yield (data.link, symbol[0]), text
            elif symbol in ("θ", "x", "y", "s", "v", "a"):
                yield (str(stroke.link), symbol), text


def _table(sheet: Sheet) -> dict[tuple[str, str], str]:
    """Return the cells of the results by row and symbol, with their units, as they are read."""
    note = f" ({Language(sheet.language).say('given')})"
    results = describe(sheet).rpartition("\n")[2].partition(": ")[2].rstrip(".").split("; ")
    found = {}
    for row, line in zip(sheet.rows, results, strict=True):
        for cell in line.split(f" {row.letters} ", 1)[1].replace(note, "").split(", "):
            symbol, _, text = cell.partition(" = ")
            found[row.key, symbol] = text
    return found
