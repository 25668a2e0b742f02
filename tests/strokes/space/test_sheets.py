"""What is true of every sheet in space: its figures are its data, its polygons close."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

import pytest

import vad
from tests.kinds import SPACE
from tests.strokes.calculations import FIGURE, FLOATS, Figure, chains
from tests.strokes.crossings import crossings_lie_on_lines, size
from tests.strokes.poses import IN_SPACE, sheets
from tests.strokes.wording import WORDING
from vad.strokes.sheet import Arrow, Cell, Dot, Panel, Row, Sheet, Stroke
from vad.words import languages

pytestmark = pytest.mark.exhaustive

everything = pytest.mark.parametrize("mechanism", IN_SPACE.values(), ids=list(IN_SPACE))
each_kind = pytest.mark.parametrize("kind", SPACE.values(), ids=list(SPACE))
in_every_language = pytest.mark.parametrize("code", languages())


def polygons(mechanism: Any) -> Iterator[tuple[Sheet, Panel]]:
    """Yield the polygons of every pose, those below others, too."""
    for sheet in sheets(mechanism):
        for panel in sheet.halves:
            if panel.picture == "vectors":
                yield sheet, panel


def vector(stroke: Stroke) -> complex:
    assert isinstance(stroke.shape, Arrow), stroke
    return stroke.shape.end - stroke.shape.start


# --- geometry ---------------------------------------------------------------------------------


@everything
def test_every_vertex_has_one_place(mechanism: Any) -> None:
    for _, panel in polygons(mechanism):
        places: dict[str, complex] = {}
        for stroke in panel.strokes:
            if isinstance(stroke.shape, Dot):
                ends = [(letter, stroke.shape.at) for letter in stroke.label.split(",")]
            elif isinstance(stroke.shape, Arrow):
                shape = stroke.shape
                ends = [(shape.tail, shape.start), (shape.head, shape.end)]
            else:
                continue
            for letter, at in ends:
                assert abs(places.setdefault(letter, at) - at) <= 1e-12 * size(panel), stroke


@everything
def test_the_equations_under_a_polygon_hold(mechanism: Any) -> None:
    for _, panel in polygons(mechanism):
        resting = [stroke.kind for stroke in panel.strokes] == ["pole"]
        assert resting or panel.equations
        for equation in panel.equations:
            total = 0j
            for sign, terms in ((1, equation.left), (-1, equation.right)):
                drawn = [term.stroke for term in terms if term.stroke is not None]
                total += sign * sum(vector(panel.strokes[panel.number(name)]) for name in drawn)
            assert abs(total) <= 1e-11 * size(panel)


@everything
def test_crossings_lie_on_their_lines(mechanism: Any) -> None:
    for _, panel in polygons(mechanism):
        assert not crossings_lie_on_lines(panel)


# --- what is said -----------------------------------------------------------------------------


def cells(sheet: Sheet, panel: Panel) -> Iterator[tuple[Row, tuple[Cell, ...]]]:
    """Yield the cells that a half of a panel measures, by their rows."""
    for row in sheet.rows:
        whole = sheet.panel(panel.column)
        (own,) = (found for half, found in whole.measures(row) if half is panel)
        if not all(cell.given for cell in own):
            yield row, own


@everything
def test_every_result_is_measured_once_by_a_stroke_that_says_it(mechanism: Any) -> None:
    for sheet in sheets(mechanism):
        for panel in sheet.halves:
            rows = {row.key for row in sheet.rows}
            assert {stroke.link for stroke in panel.strokes} <= {None, *rows}
            revealed = [key for stroke in panel.strokes for key in stroke.reveals]
            assert len(revealed) == len(set(revealed))
            # Where nothing turns the pole shows what is given, too.
            assert {row.key for row, _ in cells(sheet, panel)} <= {*revealed} <= rows
            for row, (cell, *_) in cells(sheet, panel):
                (stroke,) = (s for s in panel.strokes if row.key in s.reveals)
                if panel.picture == "vectors" and cell.value:
                    assert any(cell.symbol in symbols for symbols, _ in results(stroke)), stroke


def results(stroke: Stroke) -> Iterator[tuple[set[str], Figure]]:
    """Yield the results of a caption, with the symbols of which each is said to be."""
    for chain in chains(stroke.caption):
        if chain.result:
            alone = [side.factors[0] for side in chain.sides if len(side.factors) == 1]
            yield {chain.symbol, *(name for name, power in alone if power == 1)}, chain.result


@in_every_language
@everything
def test_every_figure_of_a_result_agrees_with_its_cell_and_its_vector(
    mechanism: Any, code: str
) -> None:
    """With its sign, but where a word says the sense."""
    read: set[str] = set()
    for sheet in sheets(mechanism, steps=2, language=code):
        for panel in sheet.halves:
            known: dict[str, list[float]] = {}
            for cell in (cell for row in sheet.rows for cell in row.cells.get(panel.column, ())):
                known.setdefault(cell.symbol, []).append(cell.value)
            for stroke in panel.strokes:
                sensed = WORDING[code].count(stroke.caption)[1]
                for symbols, figure in results(stroke):
                    for symbol in symbols & {*known}:
                        read.add(symbol)
                        values = [abs(x) if sensed else x for x in known[symbol]]
                        scaled = [sheet.notation.scaled(value, panel.unit) for value in values]
                        assert any(map(figure.agrees, scaled)), stroke.caption
                    if stroke.label in symbols and panel.picture == "vectors":
                        length = sheet.notation.scaled(abs(vector(stroke)), panel.unit)
                        found = Figure(figure.text.lstrip("−"))
                        assert found.agrees(length), stroke.caption
    assert len(read) >= 4


_F = FIGURE.pattern
ROOT = re.compile(rf"√\(({_F})² ([+−]) ({_F})²\)(?:/BC)? = ({_F})[ /]")
SINE = rf"sin\(({_F})°\)"
SINES = re.compile(rf"= ({_F}) × {SINE} / {SINE} = ({_F}) ")
INCLINED = re.compile(rf"= ({_F}) × \(({_F}) ([+−]) ({_F})·cos δ\)/{SINE} = ({_F}) ")
SUM = re.compile(rf"= ({_F}(?: [+−] {_F})+) = ({_F}) ")


@in_every_language
def test_roots_sines_and_sums_come_out_as_on_a_pocket_calculator(code: str) -> None:
    found = {"root": 0, "sines": 0, "inclined": 0, "sum": 0}
    for mechanism in IN_SPACE.values():
        for sheet in sheets(mechanism, steps=2, language=code):
            for caption in (s.caption for panel in sheet.halves for s in panel.strokes):
                for long, sign, off, root in ROOT.findall(caption):
                    sides = [Figure(text).value ** 2 for text in (long, off)]
                    squares = sides[0] + (1 if sign == "+" else -1) * sides[1]
                    near(squares**0.5, Figure(root), caption)
                    found["root"] += 1
                for factor, above, below, product in SINES.findall(caption):
                    sines = [math.sin(math.radians(Figure(x).value)) for x in (above, below)]
                    near(Figure(factor).value * sines[0] / sines[1], Figure(product), caption)
                    found["sines"] += 1
                for factor, first, sign, second, angle, product in INCLINED.findall(caption):
                    delta = math.radians(Figure(angle).value)
                    leaning = (1 if sign == "+" else -1) * Figure(second).value * math.cos(delta)
                    across = (Figure(first).value + leaning) / math.sin(delta)
                    near(Figure(factor).value * across, Figure(product), caption)
                    found["inclined"] += 1
                for addends, total in SUM.findall(caption):
                    parts = addends.replace("− ", "−").replace("+ ", "").split()
                    near(sum(Figure(text).value for text in parts), Figure(total), caption)
                    found["sum"] += 1
    assert min(found.values()) > 4, found


def near(value: float, printed: Figure, caption: str) -> None:
    """Check that a value rounds to what is printed."""
    assert abs(value - printed.value) < float(printed.last_place) / 2 + FLOATS * abs(value), caption


@in_every_language
@everything
def test_every_caption_is_a_sentence(mechanism: Any, code: str) -> None:
    for sheet in sheets(mechanism, steps=2, language=code):
        for stroke in (stroke for panel in sheet.halves for stroke in panel.strokes):
            assert re.fullmatch(r".*[^\s.,;:]\.", stroke.caption), stroke.caption
            assert not re.search(r"\s\s|[{}\x02\x03]|\s[.,]", stroke.caption), stroke.caption
            assert not re.search("(sin|cos|tan|[×/]) ?−", stroke.caption), stroke.caption


@each_kind
def test_geometry_and_names_are_the_same_in_every_language(kind: Any) -> None:
    motion = vad.solve(kind(), alpha=5.0)
    drawn = [
        [[(s.name, s.shape) for s in panel.strokes] for panel in sheet.halves]
        for sheet in (vad.draw(motion, language=code) for code in languages())
    ]
    assert all(other == drawn[0] for other in drawn)


@in_every_language
@everything
def test_no_caption_names_a_vector_by_two_digits(mechanism: Any, code: str) -> None:
    """Vertices are bodies, and "12 = 10 rad/s" would read as numbers: a vector has its symbol."""
    for motion in (vad.solve(mechanism, alpha=alpha) for alpha in (0.0, 20.0)):
        for panel in vad.draw(motion, language=code).halves:
            for stroke in panel.strokes:
                assert not re.search(r"(?<![\d.,])[1-4][′ₙ]?[1-4][′ₙ]? = ", stroke.caption), stroke
