"""What numbers are drawn from: nice ones, even ranges, lists, with units."""

from __future__ import annotations

import math
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

import vad
from vad.batches.choices import Quantity, choices, nice, offered
from vad.errors import InputError

CRANK = Quantity("length", "mm", usual=40.0, signed=False)
ANGLE = Quantity("angle", "mm", usual=60.0)
OMEGA = Quantity("omega", "mm", usual=10.0)


@given(st.floats(1e-6, 1e9), st.floats(1.0, 100.0))
def test_nice_numbers_have_two_digits_and_lie_in_the_range(low, factor):
    found = nice(low, low * factor)
    assert list(found) == sorted(set(found))
    for number in found:
        assert low * (1 - 1e-9) <= number <= low * factor * (1 + 1e-9)
        digits = Decimal(repr(number)).normalize().as_tuple().digits
        assert len(digits) <= 2
        assert digits[0] == 1 or digits[1:] in ((), (5,))


@given(st.floats(1e-6, 1e9))
def test_none_is_left_out(low):
    """Between a number and its tenfold stand all ten of 1.x and the two for each later digit."""
    exponent = math.floor(math.log10(low))
    first = float(f"1e{exponent}")
    assert len(nice(first, 9.5 * first)) == 10 + 2 * 8


@pytest.mark.parametrize(
    ("value", "quantity", "found"),
    [
        (60, CRANK, (60.0,)),
        ("6 cm", CRANK, (60.0,)),
        ([50, "6 cm"], CRANK, (50.0, 60.0)),
        ({"share": 0.1}, CRANK, (40.0,)),
        ({"share": 0.25}, CRANK, (30.0, 35.0, 40.0, 45.0, 50.0)),
        ({"from": 8, "to": "1.2 cm"}, CRANK, (8.0, 8.5, 9.0, 9.5, 10.0, 11.0, 12.0)),
        ({"from": -20, "to": -17}, ANGLE, (-20.0, -19.0, -18.0, -17.0)),
        ({"from": 0, "to": 0.7, "step": 0.1}, ANGLE, (0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7)),
        ({"from": 0, "to": 8, "step": 5}, ANGLE, (0.0, 5.0)),
    ],
)
def test_what_is_offered(value, quantity, found):
    assert choices(value, quantity) == found


def test_units_are_those_of_the_scene():
    assert choices(["60 rpm"], OMEGA)[0] == pytest.approx(2 * math.pi, rel=1e-15)


@pytest.mark.parametrize(
    ("value", "quantity", "part"),
    [
        (-3, CRANK, "must be positive, got -3"),
        ([], CRANK, "the list is empty"),
        (True, CRANK, "must be a number, got True"),
        ("sixty", CRANK, "'sixty' is not a number"),
        (math.nan, CRANK, "must be a finite number"),
        (10**400, CRANK, "must be a finite number"),
        ({"share": 2}, CRANK, "share: must be between 0 and 1, got 2"),
        ({"share": 0.25}, Quantity("length", "mm"), "share: there is no value"),
        ({"share": 0.01}, Quantity("length", "mm", 73.0), "no nice number from 72.27 to 73.73"),
        ({"form": 1, "to": 2}, CRANK, "unknown word 'form'"),
        ({"from": 1}, CRANK, "neither from and to nor a share"),
        ({"from": 2, "to": 1}, CRANK, "from 2 to 1 is no range"),
        ({"from": 0, "to": 355}, ANGLE, "no nice way from 0 to 355"),
        ({"from": 0, "to": 355, "step": -5}, ANGLE, "step: must be positive, got -5"),
        ({"from": 0, "to": 1, "step": 1e-9}, ANGLE, "step: makes 1000000001 numbers"),
    ],
)
def test_what_is_none(value, quantity, part):
    with pytest.raises(InputError) as caught:
        choices(value, quantity)
    assert part in str(caught.value)


def test_an_assembly_is_not_refused_for_the_usual_lengths():
    assert offered(vad.FourBar, "assembly", ["parallel", "open"], None) == ("parallel", "open")
    with pytest.raises(vad.InputError, match="unknown assembly 'paralel'"):
        offered(vad.FourBar, "assembly", "paralel", None)
