"""One rule for written numbers, at its edges and in every place where numbers stand."""

from __future__ import annotations

import re

import pytest

import vad
from vad.strokes.description import describe, title
from vad.written import given, measured, number, quantity, typed


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (-0.0, "0"),
        (1e-4, "0.0001000"),
        (9.9994e-5, "9.999×10⁻⁵"),
        (9.99996e-5, "0.0001000"),
        (0.0588235, "0.05882"),
        (1.0, "1.000"),
        (-59.996, "−60.00"),
        (9999.4, "9999"),
        (9999.6, "10\u202f000"),
        (57549.8, "57\u202f550"),
        (999949.0, "999\u202f949"),
        (999951.0, "1.000×10⁶"),
        (-1234567.0, "−1.235×10⁶"),
        (float("nan"), "–"),
    ],
)
def test_a_measured_value_has_four_digits(value: float, text: str):
    assert measured(value) == number(value) == number(value, "mm") == text


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (60.0, "60"),
        (-0.0, "0"),
        (0.05, "0.05"),
        (1 / 17, "0.0588235"),
        (-11.59, "−11.59"),
        (123456.7, "123\u202f457"),
        (2e6, "2×10⁶"),
        (-2.5e-7, "−2.5×10⁻⁷"),
    ],
)
def test_a_given_value_is_as_it_was_given(value: float, text: str):
    assert given(value) == number(value, "mm", given=True) == text


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0.0°"),
        (338.213, "338.2°"),
        (359.94, "359.9°"),
        (359.95001, "0.0°"),
        (359.97, "0.0°"),
        (360.0 - 1e-12, "0.0°"),
        (-0.04, "0.0°"),
        (-30.26, "−30.3°"),
        (-359.97, "0.0°"),
    ],
)
def test_a_measured_angle_has_one_decimal_and_is_less_than_a_turn(value: float, text: str):
    assert quantity(value, "°") == text


def test_a_given_angle_below_a_turn_never_reads_360():
    assert quantity(360.0 - 1e-9, "°", given=True) == "0°"
    assert quantity(359.97, "°", given=True) == "359.97°"
    assert typed(360.0 - 1e-13, "deg", 12) == "0"


@pytest.mark.parametrize("angle", [1e-9, 1e-5, 0.05, 359.97, 360.0 - 1e-9, 360.0 - 1e-13])
def test_no_angle_reads_360_wherever_it_stands(angle: float):
    """The rod of a slider-crank is a little below a turn where its crank is a little above 0."""
    motion = vad.solve(vad.SliderCrank(), angle=angle)
    sheet = vad.draw(motion)
    words = [stroke.caption + stroke.label for p in sheet.panels for stroke in p.strokes]
    for text in (*words, describe(sheet), motion.table()):
        assert not re.search(r"360(\.0*)?(°| |$)", text, re.MULTILINE), text


def test_the_title_says_parameters_as_they_were_given():
    sheet = vad.draw(vad.solve(vad.SliderCrank(crank=60.25, rod=140)))
    assert title(sheet) == "Slider–crank: crank 60.25 mm, rod 140 mm, offset 0"


def test_one_quantity_is_written_one_way():
    """The gate's given velocity, 1/17 ft/s: in captions, in the table, on the terminal."""
    sheet = vad.draw(vad.solve(vad.GateActuator(), acceleration=0.2))
    captions = " ".join(stroke.caption for panel in sheet.panels for stroke in panel.strokes)
    assert re.findall(r"0\.058\d*", captions) == ["0.0588235"] * 2
    assert "v = 0.0588235 ft/s (given)" in describe(sheet)
    assert typed(1 / 17) == "0.0588235"
