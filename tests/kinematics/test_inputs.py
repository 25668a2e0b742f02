"""What may be given as an input: numbers and arrays of them, not what numpy makes of the rest."""

from __future__ import annotations

import array
import datetime
import math
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import vad

TODAY = datetime.date(2024, 2, 29)


class Rude:
    """Refuses to be an array, in its own way."""

    def __array__(self, *_: object, **__: object) -> object:
        raise ZeroDivisionError("no\nnumbers")


@pytest.mark.parametrize(
    "value",
    [
        1 + 2j,
        b"60",
        True,
        None,
        TODAY,
        np.True_,
        np.datetime64("2024-02-29"),
        np.timedelta64(3, "s"),
        np.complex128(1 + 2j),
        bytearray(b"60"),
        {60.0},
        {"angle": 60.0},
        object(),
        Rude(),
        [1 + 0j, 2.0],
        ["60", "70"],
        [60.0, "70"],
        [b"60"],
        [True, False],
        [None, 60.0],
        [TODAY],
        [np.datetime64("2024-02-29")],
        [np.timedelta64(3, "s")],
        [[60.0], [70.0, 80.0]],
        [10**400, 10**400],
        np.array([("x", 1.0)], dtype=[("name", "U1"), ("value", float)]),
        (angle for angle in (60.0, 70.0)),
    ],
    ids=lambda value: type(value).__name__,
)
@pytest.mark.parametrize("name", ["angle", "omega"])
def test_what_is_no_number_is_refused(name, value):
    with pytest.raises(vad.InputError, match=rf"^{name}: must be a number or an array of numbers"):
        vad.solve(vad.FourBar(), **{name: value})


@pytest.mark.parametrize(
    "value",
    [10**400, -(10**400), 10**5000, Decimal("1e400"), Decimal("nan")],
    ids=lambda value: type(value).__name__,
)
def test_a_number_beyond_every_float_is_not_finite(value):
    with pytest.raises(vad.InputError, match=r"^angle: must be a finite number"):
        vad.solve(vad.FourBar(), angle=value)


def test_a_mask_is_not_lost():
    angles = np.ma.masked_greater([60.0, 9999.0], 360.0)
    with pytest.raises(vad.InputError, match=r"^angle: must not be masked") as caught:
        vad.solve(vad.FourBar(), angle=angles)
    assert "filled" in caught.value.hint
    turn = vad.solve(vad.FourBar(), angle=angles.filled(np.nan))
    assert np.isnan(turn.link("rocker").angle).tolist() == [False, True]


def test_an_array_of_which_nothing_is_masked_is_an_array():
    turn = vad.solve(vad.FourBar(), angle=np.ma.masked_greater([60.0, 90.0], 360.0))
    assert turn.assembled.tolist() == [True, True]


@pytest.mark.parametrize(
    "sixty",
    [60, Fraction(60), Decimal(60), np.int64(60), np.uint8(60), np.float32(60), np.longdouble(60)],
    ids=lambda value: type(value).__name__,
)
def test_any_real_number_is_a_number(sixty):
    motion, plain = (vad.solve(vad.FourBar(), angle=each) for each in (sixty, 60.0))
    assert not motion.many
    assert motion.link("rocker").angle == plain.link("rocker").angle


@pytest.mark.parametrize(
    "angles",
    [
        [60, 90.0],
        (60, 90),
        range(60, 91, 30),
        array.array("d", [60.0, 90.0]),
        [Fraction(60), Decimal(90)],
        np.array([60, 90], dtype=np.uint8),
        np.array([60.0, 90.0], dtype=object),
        memoryview(array.array("d", [60.0, 90.0])),
    ],
    ids=lambda value: type(value).__name__,
)
def test_any_array_of_numbers_is_an_array(angles):
    rocker = vad.solve(vad.FourBar(), angle=angles).link("rocker")
    plain = vad.solve(vad.FourBar(), angle=[60.0, 90.0]).link("rocker")
    assert rocker.angle.tolist() == plain.angle.tolist()


@pytest.mark.parametrize("ask", ["link", "point", "slide"])
@pytest.mark.parametrize("name", [0, None, [], {}, b"rocker", ("rocker",), "", "Rocker "])
def test_what_is_asked_for_by_no_name_is_refused(ask, name):
    with pytest.raises(vad.UsageError, match=f"^unknown {ask} "):
        getattr(vad.solve(vad.FourBar()), ask)(name)


@pytest.mark.parametrize("mechanism", [None, "four-bar", vad.FourBar, 3])
def test_what_is_no_mechanism_is_refused(mechanism):
    with pytest.raises(vad.InputError, match=r"^mechanism: must be a mechanism"):
        vad.solve(mechanism)


def test_what_was_solved_keeps_its_inputs():
    motion = vad.solve(vad.FourBar(), angle=[60.0, 90.0])
    with pytest.raises(TypeError):
        motion.inputs["angle"] = 30.0  # type: ignore[index]
    with pytest.raises(ValueError, match="read-only"):
        motion.inputs["angle"][0] = 30.0


@pytest.mark.parametrize("kind", vad.MECHANISMS.values())
def test_defaults_belong_to_nobody(kind):
    with pytest.raises(TypeError):
        kind.inputs["angle"] = 30.0
    assert vad.solve(kind()).inputs == dict(kind.inputs)


@pytest.mark.parametrize(
    ("given", "omega"), [("10", 10.0), ("120 rpm", 4.0 * math.pi), ("-90 deg/s", -math.pi / 2.0)]
)
def test_a_text_is_a_number_with_its_unit(given, omega):
    assert vad.solve(vad.FourBar(), omega=given).link("crank").omega == pytest.approx(omega, abs=0)
    assert vad.solve(vad.DoubleSlider(), position="0.4 m").inputs["position"] == 400.0
    assert vad.solve(vad.DoubleSlider(length_unit="m", link=1), position="40 cm").assembled


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        ({"angle": "x"}, "angle: 'x' is not a number"),
        ({"angle": "3 kg"}, "angle: 'kg' is not a unit of angle"),
        ({"omega": "1e70"}, "omega: must be within ±1e+60, got 1e+70"),
        ({"omega": "inf"}, "omega: must be a finite number, got inf"),
    ],
)
def test_a_text_that_is_no_input_is_refused(inputs, words):
    with pytest.raises(vad.InputError) as refused:
        vad.solve(vad.FourBar(), **inputs)
    assert str(refused.value) == words
