"""Every figure in a caption, against the data; and its arithmetic, as a calculator does it.

A caption calculates in chains: ``bc = 340.5 mm/s``, ``ω₃ = bc/BC = 340.5/140 = 2.432 rad/s``.
A figure is wrong by half a unit of its last place at most: that is the bound for each figure
against the data, and for the result of a product or quotient of printed factors.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from fractions import Fraction

import pytest

from tests.strokes.calculations import FIGURE, FLOATS, Figure, Side, chains
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
from tests.strokes.poses import MECHANISMS, sheets
from vad.kinematics.linkage import Slide
from vad.kinematics.motion import Motion
from vad.strokes.description import describe
from vad.strokes.sheet import Arrow, Panel, Sheet, Stroke
from vad.words import Language

SLIDES = ("x", "y", "s", "l", "v", "a")
UNITS = {"ω": "rad/s", "α": "rad/s²", "θ": "°"}


class Data:
    """What a symbol in a caption stands for."""

    def __init__(self, motion: Motion, panel: Panel, stroke: Stroke) -> None:
        self.motion, self.panel, self.stroke = motion, panel, stroke
        self.notation = drawn(motion, "en").notation

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
        kept = symbol[0] in "ωαθ" or self.typed
        kept = kept or (re.fullmatch("[A-Z]{2}", symbol) is not None and not self.carries)
        value = self._raw(symbol) if kept else self.written(self._raw(symbol))
        return float(f"{value:.6g}") if self.typed else value

    @property
    def typed(self) -> bool:
        """Whether the caption says the given rate of what slides, as it was given."""
        slides = self.stroke.kind == "known" and self.stroke.link in self.motion.slides
        return slides and self.stroke.component in ("sliding", "absolute")

    @property
    def carries(self) -> bool:
        """Whether factors have their units, because a length is written in metres."""
        return re.search(r" m\b(?!/)", self.stroke.caption) is not None

    @property
    def unit(self) -> str:
        """The unit in which the caption writes vectors."""
        return self.panel.unit if self.typed else self.notation.unit(self.panel.unit)

    def written(self, value: float) -> float:
        """Return a length or a rate of it in the unit of the sheet."""
        return self.notation.scaled(value, self.panel.unit)

    def _raw(self, symbol: str) -> float:
        motion, order = self.motion, ORDERS[self.panel.name]
        if symbol[0] in "ωα":
            link = motion.link(self.link)
            return abs(link.omega if symbol[0] == "ω" else link.alpha)
        if symbol[0] == "θ":
            return float(motion.link(str(self.stroke.link)).angle)
        symbol = symbol.partition("_")[0]  # v_A, where A is not the only one that slides
        if symbol in SLIDES:
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
                unit = UNITS.get(chain.symbol[0], data.unit)
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
            yield Figure(text), data.written(abs(vector(stroke))) if is_bar else data["s"]
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
def test_a_pocket_calculator_agrees(name: str, code: str) -> None:
    for _, _, stroke in strokes(name, code):
        calculate(stroke.caption)


def calculate(caption: str) -> int:
    """Check that printed factors give the printed result, and return how many calculations."""
    done = 0
    for chain in chains(caption):
        for side in chain.sides:
            if chain.result is None or not side.in_figures:
                continue
            product = math.prod(
                (Figure(text).exact ** power for text, power in side.factors), start=Fraction(1)
            )
            assert abs(product - chain.result.exact) < chain.result.last_place / 2, caption
            done += 1
    return done


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("name", MECHANISMS)
def test_it_does_so_all_round(name: str) -> None:
    """Every mechanism, in both assemblies, over its whole range."""
    turn = sheets(MECHANISMS[name], language="de")
    drawn = (panel for sheet in turn for panel in sheet.halves)
    done = sum(calculate(stroke.caption) for panel in drawn for stroke in panel.strokes)
    assert done >= (5 if "hooke" in name or "spherical" in name else 25)


@in_every_language
@everything
def test_the_table_rounds_what_the_captions_say(name: str, code: str) -> None:
    """A caption has the digits that its calculation needs, the table four."""
    for motion in poses(name):
        sheet = drawn(motion, code)
        table = _table(sheet)
        for panel in sheet.panels:
            for stroke in panel.strokes:
                for (key, symbol), text in _quantities(motion, panel, stroke):
                    # Of ω and α a caption says the size, and in words the sense.
                    sized = symbol[0] in "ωα" or stroke.component == "coriolis"
                    cell = table[key, symbol].partition(" ")[0].rstrip("°")
                    said = Figure(cell.lstrip("−") if sized else cell)
                    assert said.agrees(Figure(text).value), stroke.caption


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
                yield (data.link, symbol), text
            elif symbol[0] == "θ" or symbol.partition("_")[0] in SLIDES:
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
