"""Digits for calculations: there is an end, even where no number of digits makes them hold."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import vad
from tests.limits import within
from vad.files.examples import example_path
from vad.strokes.arithmetic import Figure, product, product_of_sines, total, with_digits
from vad.strokes.notation import Notation
from vad.strokes.sentences import Sentence
from vad.written import plain

VALUES = st.sampled_from([0.0, 5e-324, 1e-151, 1 / 3, 12.0, 99999.5, 2e5, 5e151, 1e250])
VALUES_OF_SHEETS = st.floats(0.01, 99.0)
FIGURES = st.builds(Figure, VALUES, st.sampled_from(["mm", "°", "mm/s²"]), st.booleans())


@given(st.lists(st.tuples(FIGURES, FIGURES, FIGURES), min_size=1, max_size=4))
def test_there_is_an_end(triples):
    said = [
        Sentence("", dict(zip("abc", triple, strict=True)), (calculate("a", "b", "c"),))
        for triple in triples
        for calculate in (product, total)
    ]
    with within(5.0):
        parts = [with_digits([each], Notation(metres=True))[0] for each in said]
        parts += with_digits(said, Notation(metres=True))
    assert all(0 <= figure.digits <= 15 for each in parts for figure in each.values())


def said(sheet, phrase):
    """Return the captions of a phrase."""
    strokes = (stroke for panel in sheet.panels for stroke in panel.strokes)
    return [str(each.said) for each in strokes if each.said.phrase == phrase]


def test_a_number_has_the_same_digits_wherever_a_caption_calculates_with_it():
    """The square of 2.308 times 140 is not 745.6, that of 2.3077 is: so it is found as that."""
    sheet = vad.draw(vad.solve(vad.SliderCrank()))
    (found,), (used,) = (said(sheet, each) for each in ("measured omega", "normal"))
    assert "bc/BC = 323.08/140 = 2.3077 rad/s" in found
    assert "ω₃²·BC = 2.3077² × 140 = 745.6 mm/s²" in used


def test_the_operand_that_is_rounded_most_gets_the_digit():
    """888.6/126.2 is 7.041; the quarter of a thousandth of 126.2 is more than that of 888.6."""
    figures = {"a": Figure(888.63 / 126.238), "b": Figure(888.63), "c": Figure(126.238, power=-1)}
    (parts,) = with_digits([Sentence("", figures, (product("a", "b", "c"),))], Notation())
    texts = {name: plain(each.value, digits=each.digits) for name, each in parts.items()}
    assert texts == {"a": "7.039", "b": "888.6", "c": "126.24"}


@settings(max_examples=200)
@given(VALUES_OF_SHEETS, VALUES_OF_SHEETS)
def test_a_product_has_the_digits_of_the_table(one, other):
    """Only factors have more, and where they have, the product would else not come out.

    A product that lies almost halfway between two numbers of four digits gets a digit, too.
    """
    figures = {"a": Figure(one * other), "b": Figure(one), "c": Figure(other)}
    (parts,) = with_digits([Sentence("", figures, (product("a", "b", "c"),))], Notation())
    printed, usual = (
        {name: Fraction(plain(each.value, digits=each.digits)) for name, each in found.items()}
        for found in (parts, figures)
    )
    last = Fraction(10) ** (math.floor(math.log10(printed["a"])) - 3)
    if parts != figures:
        assert 2 * abs(usual["b"] * usual["c"] - usual["a"]) >= last
    halfway = abs(2 * abs(Fraction(one * other) - usual["a"]) - last) < last / 25
    assert printed["a"] == usual["a"] or halfway
    last = last if printed["a"] == usual["a"] else last / 10
    assert 2 * abs(printed["b"] * printed["c"] - printed["a"]) < last


@pytest.mark.parametrize(("name", "lengths"), [("trunnion", {"crank": 5e151}), ("roberts", None)])
def test_a_drawing_with_lengths_far_apart_is_made(name, lengths):
    kind = vad.load(example_path(name))
    lengths = lengths or {"side": 1e150 * kind().side}
    with within(20.0):
        vad.draw(vad.solve(kind(**lengths)))


@settings(max_examples=200)
@given(st.floats(0.001, 179.0), st.floats(1.0, 179.0))
@example(1.0, 177.984375)
def test_angles_have_more_decimals_where_their_sines_would_not_come_out(above, below):
    size = math.sin(math.radians(above)) / math.sin(math.radians(below))
    figures = {"a": Figure(size), "b": Figure(above, "°"), "c": Figure(below, "°", power=-1)}
    (parts,) = with_digits([Sentence("", figures, (product_of_sines("a", "b", "c"),))], Notation())
    texts = {name: plain(x.value, x.unit, digits=x.digits) for name, x in parts.items()}
    made = math.sin(math.radians(float(texts["b"]))) / math.sin(math.radians(float(texts["c"])))
    last = Fraction(10) ** (math.floor(math.log10(float(texts["a"]))) - 3)
    assert abs(made - float(texts["a"])) <= last / 2, texts
    assert all(parts[name].digits <= most for name, most in {"a": 5, "b": 9, "c": 9}.items()), texts


def test_an_angle_that_shows_no_digit_is_no_divisor():
    """The sine of 0.02° is not that of 0.0°, by which nothing is divided."""
    figures = {"a": Figure(0.5), "b": Figure(0.01, "°"), "c": Figure(0.02, "°", power=-1)}
    (parts,) = with_digits([Sentence("", figures, (product_of_sines("a", "b", "c"),))], Notation())
    assert [plain(parts[x].value, "°", digits=parts[x].digits) for x in "bc"] == ["0.010", "0.020"]
