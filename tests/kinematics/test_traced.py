"""Numbers that remember how they were calculated, and what was decided by them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from vad.files.description import Expression
from vad.kinematics import elementary
from vad.kinematics.numbers import choose, exact, total
from vad.kinematics.program import Program
from vad.kinematics.symbol import as_complex, as_float
from vad.kinematics.traced import Guard, Traced, TracedTape, TracedVector, made_of

#: Another pair of numbers than that with which a function is traced.
OTHERS = [(0.9, -0.3), (0.2, 0.7), (-0.6, 0.45)]


def traced(*values: float) -> list[Traced]:
    """Return inputs on one record."""
    tape = TracedTape()
    return [Traced.input(tape, f"x{number}", value) for number, value in enumerate(values)]


def replayed(function: Callable[..., Any], others: Sequence[tuple[float, ...]]) -> list[float]:
    """Return what a function gives of other numbers than those with which it is traced."""
    inputs = traced(0.5, 0.8)
    made: list[Any] = [number.made for number in inputs]
    program = Program(made, [made_of(function(*inputs))], 1)
    columns = [np.array(column) for column in zip(*others, strict=True)]
    (found,) = program.many(columns, len(others))
    return [float(value) for value in found]


@pytest.mark.parametrize(
    "function",
    [
        elementary.hypot,
        elementary.bearing,
        lambda x, y: elementary.sqrt(abs(x) + y * y),
        lambda x, y: elementary.arcsine(x) + y,
        lambda x, y: elementary.arccosine(x) + y,
        lambda x, y: elementary.arctangent(x / y),
        lambda x, y: elementary.power(x, 3.0) * elementary.power(abs(y), -1.5),
        lambda x, y: elementary.sine(500.0 * x + y),
        lambda x, y: elementary.unit_at(500.0 * x + y).real,
        lambda x, y: total(x, 3.0 * y, -x, 1e-9 * x),
    ],
)
def test_functions_of_traced_numbers(function: Callable[..., float]) -> None:
    for found, pair in zip(replayed(function, OTHERS), OTHERS, strict=True):
        right = function(*pair)
        assert abs(found - right) <= 4e-15 * max(1.0, abs(right))


@pytest.mark.parametrize(
    "text",
    [
        "sqrt(abs(a)) + hypot(a, b)",
        "sin(40*a)*cos(70*b) + tan(30*a)",
        "asin(a) - acos(b) + atan(a/b) + atan2(b, a)",
        "a^2 - b**3 + abs(b)**0.5 + 2/(a + 3)",
    ],
)
def test_expressions_of_a_file_are_traced(text: str) -> None:
    expression = Expression.of(text, ["a", "b"])
    found = replayed(lambda a, b: expression({"a": a, "b": b}), OTHERS)
    for value, (a, b) in zip(found, OTHERS, strict=True):
        right = expression({"a": a, "b": b})
        assert abs(value - right) <= 1e-14 * max(1.0, abs(right))


def test_a_power_that_is_no_product_is_a_constant_behind_a_guard() -> None:
    x, y = traced(2.0, 0.3)
    with x.tape.watched():
        found = elementary.power(x, y)
    assert found == math.pow(2.0, 0.3)
    assert type(found) is float
    assert [guard.value for guard in x.tape.guards] == [True, True]


def test_functions_of_floats_have_the_bits_of_math() -> None:
    rng = np.random.default_rng(1)
    for x, y in rng.uniform(-1.0, 1.0, (300, 2)).tolist():
        assert elementary.hypot(x, y) == math.hypot(x, y)
        assert elementary.bearing(y, x) == math.degrees(math.atan2(y, x))
        assert elementary.arctangent(y) == math.degrees(math.atan(y))
        assert elementary.power(abs(x), y) == math.pow(abs(x), y)
        assert total(x, y, -1.0) == math.fsum((x, y, -1.0))
    assert exact(0.1, 3.0) == (Fraction(0.1), 3)
    assert total(*exact(0.1, 0.2)) == Fraction(0.1) + Fraction(0.2)


def test_a_traced_sum_is_rounded_nearly_once() -> None:
    big, small = traced(1e16, 1.25)
    assert float(total(big, small, -big)) == 1.25
    assert float(big + small - big) != 1.25


def test_a_constant_is_chosen_by_a_traced_number() -> None:
    centre, low, high = traced(1.0, 5.0, 7.0)
    found = choose(centre, {-1: low, 0: 6.0, 1: high})
    program = Program([x.made for x in (centre, low, high)], [made_of(found)], 1)
    (column,) = program.many([np.array([-1.0, 0.0, 1.0]), 5.5, 7.5], 3)
    assert column.tolist() == [5.5, 6.0, 7.5]


def test_a_decision_is_a_guard_while_the_record_is_watched() -> None:
    x, y = traced(2.0, 3.0)
    assert x < y
    with x.tape.watched():
        assert not x > y
        assert x != y
        assert x <= y
        assert bool(x)
        assert x == x  # the same number: nothing is decided
        assert float(x) < float(y)
        assert TracedVector(x, 0.0) != 1.0
    assert y > x
    texts = [(guard.made.operation, guard.value) for guard in x.tape.guards]
    assert texts == [
        ("greater", False),
        ("equal", False),
        ("either", True),
        ("equal", False),
        ("equal", False),
    ]
    assert all(isinstance(guard, Guard) for guard in x.tape.guards)


def test_no_cache_takes_a_traced_number_for_its_value() -> None:
    x, other = traced(2.0)[0], traced(2.0)[0]
    assert x == 2.0
    assert len({x, 2.0, other, TracedVector(x, 0.0), 2.0 + 0j}) == 4
    assert {x: 1}[x + 0.0] == 1  # it is made alike


def test_a_traced_number_stays_one_where_others_become_plain() -> None:
    x, _ = traced(2.0, 3.0)
    assert as_float(x) is x
    assert type(as_float(np.float64(2.0))) is float
    vector = TracedVector(0.0, x)
    assert as_complex(vector) is vector
    assert type(as_complex(np.complex128(1j))) is complex
    assert (x * 1j).real == 0.0
    assert type((x * 1j).real) is float
