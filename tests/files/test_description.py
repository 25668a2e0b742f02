"""The arithmetic of a file: every function against numbers that are known by heart."""

from __future__ import annotations

import math

import pytest

from vad.errors import InputError
from vad.files.description import Expression


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2*3 - 4/8", 6.5),
        ("2^3 + 2**-1", 8.5),
        ("-(3 - 5) + +1", 3.0),
        ("sqrt(2)", math.sqrt(2.0)),
        ("hypot(3, 4)", 5.0),
        ("abs(-7)", 7.0),
        ("sin(30)", 0.5),
        ("sin(-90)", -1.0),
        ("cos(120)", -0.5),
        ("tan(45)", 1.0),
        ("asin(0.5)", 30.0),
        ("acos(-0.5)", 120.0),
        ("atan(1)", 45.0),
        ("atan2(1, sqrt(3))", 30.0),
        ("atan2(sqrt(3), 1)", 60.0),
        ("atan2(1, 0)", 90.0),
        ("atan2(0, -1)", 180.0),
        ("atan2(-1, -1)", -135.0),
        ("180*sin(90)/pi", 180.0 / math.pi),
    ],
)
def test_what_an_expression_is(text, value):
    assert Expression.of(text, [])({}) == pytest.approx(value, rel=1e-15)


def test_dimensions_in_an_expression():
    expression = Expression.of("a/(b - 1)", ["a", "b", "c"])
    assert expression.names == {"a", "b"}
    assert expression({"a": 6.0, "b": 4.0, "c": 0.0}) == 2.0
    for values in ({"a": 6.0, "b": 1.0}, {"a": 1e308, "b": 1.0 + 1e-15}):
        with pytest.raises(InputError, match="has no value"):
            expression(values)


@pytest.mark.parametrize("text", ["hypot(1)", "sin(1, 2)", "a.b", "a[0]", "f(1)", "1 if 1 else 2"])
def test_what_is_no_expression(text):
    with pytest.raises(InputError, match="is no number and no expression"):
        Expression.of(text, ["a"])
