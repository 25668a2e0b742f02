"""Numbers with units: read to the last digit, or refused by name."""

from __future__ import annotations

import contextlib
import math
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vad.errors import InputError, UsageError
from vad.units import check_length_unit, number_of, read, scene_unit

QUANTITIES = ("length", "angle", "omega", "alpha", "position", "velocity", "acceleration")


@pytest.mark.parametrize(
    ("text", "quantity", "value"),
    [
        ("6 cm", "length", 60.0),
        ("6.1 cm", "length", 61.0),
        ("0.3 m", "position", 300.0),
        ("1e-3m", "length", 1.0),
        (" 5 µm ", "length", 0.005),
        ("5 \N{GREEK SMALL LETTER MU}m", "length", 0.005),
        ("2 in", "length", 50.8),
        ("2 inches", "length", 50.8),
        ("1 ft", "length", 304.8),
        ("-3 feet", "position", -914.4),
        ("0.5 rad", "angle", 0.5 * 180 / math.pi),
        ("-1 turn", "angle", -360.0),
        ("30°", "angle", 30.0),
        ("30 degrees", "angle", 30.0),
        ("100 gon", "angle", 90.0),
        ("120 rpm", "omega", 4 * math.pi),
        ("2 rev/s", "omega", 4 * math.pi),
        ("180 deg/s", "omega", math.pi),
        ("60 deg / min", "omega", math.pi / 180),
        ("1 rad s^-1", "omega", 1.0),
        ("1 krpm", "omega", 1000 * math.pi / 30),
        ("1 rad/min**2", "alpha", 1 / 3600),
        ("2 rad·s⁻²", "alpha", 2.0),
        ("36 km/h", "velocity", 1e4),
        ("1 m/s²", "acceleration", 1000.0),
        ("1 mm s^-2", "acceleration", 1.0),
    ],
)
def test_units(text, quantity, value):
    assert read(text, quantity) == pytest.approx(value, rel=2.3e-16)


def test_lengths_go_to_the_scene_s_unit():
    assert read("1 in", "length", "cm") == 2.54
    assert read("6 in/s", "velocity", "ft") == 0.5
    assert read("1 ft/min^2", "acceleration", "in") == pytest.approx(12 / 3600, rel=2.3e-16)
    assert read("5", "length", "parsec") == 5.0  # a bare number is not converted


@given(st.floats(allow_nan=False), st.sampled_from(QUANTITIES))
def test_a_bare_number_is_taken_as_it_is(number, quantity):
    assert read(repr(number), quantity) == number


@given(st.floats(-1e300, 1e300), st.sampled_from(QUANTITIES))
def test_the_scene_s_own_unit_changes_nothing(number, quantity):
    assert read(f"{number!r} {scene_unit(quantity)}", quantity) == number


@given(st.text(), st.sampled_from(QUANTITIES))
def test_any_text_is_a_number_or_a_usage_error(text, quantity):
    try:
        value = read(text, quantity)
    except UsageError as error:
        assert error.hint
    else:
        assert isinstance(value, float)


@given(st.text(alphabet="16e+-. /*^²⁻·°()cmrads", max_size=12), st.sampled_from(QUANTITIES))
def test_what_is_nearly_a_number_too(text, quantity):
    test_any_text_is_a_number_or_a_usage_error.hypothesis.inner_test(text, quantity)


@pytest.mark.parametrize(
    ("text", "quantity"),
    [
        ("6 kg", "length"),
        ("6 cm", "angle"),
        ("6 cm", "velocity"),
        ("6 rad", "length"),
        ("2 Hz", "omega"),  # would it be 2 or 4π rad/s?
        ("2 min^-1", "omega"),
        ("50 percent", "angle"),
        ("6 CM", "length"),
        ("6 cm²", "length"),
        ("6 m**999999999", "length"),
        ("6 m*m*m*m*m*m", "length"),
        ("6 cm/", "length"),
    ],
)
def test_a_wrong_unit_is_named(text, quantity):
    unit = text.split(" ", 1)[1]
    with pytest.raises(UsageError) as caught:
        read(text, quantity)
    assert str(caught.value).startswith(f"'{unit}' is not a unit of ")
    assert caught.value.hint.startswith("try ")


@pytest.mark.parametrize("unit", ["nan", "inf", "NaN", "infinity", "e", "pi", "mm nan", "nan/s"])
@pytest.mark.parametrize("quantity", QUANTITIES)
def test_a_word_that_is_a_number_to_others_is_no_unit(unit, quantity):
    """The library of units reads some words as numbers, and fails at them in its own way."""
    with pytest.raises(UsageError, match=f"^'{unit}' is not a unit of "):
        read(f"60 {unit}", quantity)
    with pytest.raises(UsageError, match="is not a unit of length"):
        check_length_unit(unit)


@pytest.mark.parametrize("value", ["nan", "1e400 cm", math.inf, 10**400, True, None, [60.0], 1j])
def test_a_quantity_is_a_finite_number(value):
    with pytest.raises(InputError, match=r"^crank: must be (a|one) (finite )?number, got "):
        number_of("crank", value, "length")


@pytest.mark.parametrize(
    "text", ["", " ", "six", "cm", "--rod", "6 5", "1/17", "0x10", "6 (", "1e"]
)
def test_what_is_no_number_is_named(text):
    with pytest.raises(UsageError, match=r"is not a (number|unit)"):
        read(text, "length")


@pytest.mark.parametrize(
    "text",
    [
        "1" * 60_000 + "x",
        "1" * 60_000 + " ",
        "1 " + "m*" * 30_000,
        " " * 60_000 + "m",
        "1e" * 30_000,
    ],
)
def test_a_text_as_long_as_a_book_takes_no_time(text):
    """The pattern of a number with its unit takes time that grows with the square."""
    check_length_unit("mm")  # the table of units is loaded once
    start = time.perf_counter()
    with contextlib.suppress(UsageError):
        read(text, "length")
    assert time.perf_counter() - start < 0.5


def test_a_text_as_long_as_a_book_is_not_quoted_in_full():
    with pytest.raises(UsageError, match=r"^'111.*…1*x' is not a number$") as caught:
        read("1" * 60_000 + "x", "length")
    assert len(str(caught.value)) < 100


def test_a_decimal_comma_is_answered_with_a_point():
    with pytest.raises(UsageError) as caught:
        read("1,5 cm", "length")
    assert "as in 1.5" in caught.value.hint


@pytest.mark.parametrize("text", ["1e400 cm", "1e99999999999999999999 cm", "9" * 400 + " cm"])
def test_too_large_a_number_is_infinite(text):
    assert read(text, "length") == math.inf


@pytest.mark.parametrize("text", ["1e-400 cm", "-1e-99999999999999999999 cm", "0 cm"])
def test_too_small_a_number_is_zero(text):
    assert read(text, "length") == 0.0


@pytest.mark.parametrize("name", ["mm", "cm", "m", "km", "in", "ft", "yd", "mi", "µm", "inch"])
def test_length_units(name):
    assert check_length_unit(name) == name


@pytest.mark.parametrize("name", ["", " ", "s", "deg", "bananas", "mm/s", "m m", "1", "mm\n", "MM"])
def test_what_is_no_length_unit(name):
    with pytest.raises(UsageError, match="is not a unit of length"):
        check_length_unit(name)
