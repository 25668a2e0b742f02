"""The exact derivative of a result: beside a difference of values, for every result there is."""

from __future__ import annotations

import numpy as np
import pytest

import vad
from tests.kinds import KINDS
from vad.kinematics.derivative import derivative
from vad.kinematics.program import Program
from vad.kinematics.recording import OPERATIONS, Tape


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_it_is_the_slope_of_every_result(kind):
    motion = vad.solve(kind())
    recorded = motion.solver.recorded
    place, *rates = motion.inputs.values()
    step = 1e-5 * (abs(place) or 1.0)
    places = np.array([place, place + step, place - step])
    for name, result in motion.results.items():
        for part in recorded.parts(result):
            program = Program(recorded.inputs[:3], [part, derivative(part, recorded.inputs[0])])
            values, slopes = program.many([places, *rates], 3)
            if np.isfinite(values).all():
                slope = (values[1] - values[2]) / (2.0 * step)
                allowed = 1e-4 * abs(slopes[0]) + 1e-7 * abs(values[0]) + 1e-9
                assert abs(slope - slopes[0]) <= allowed, name


def test_each_operation_has_its_rule():
    """At a few places, against differences: what the solver records in one chain."""
    tape = Tape()
    x = tape.input("x")
    note = tape.note
    numbers = [
        abs(x - 2.0),
        note("minimum", x, 1.5),
        note("maximum", x * x, 1.5),
        note("copysign", -x, x - 1.0),
        note("arctan2", x * x, 3.0 - x),
        note("select", x < 1.2, x * x, 5.0 * x),
        note("fold", 100.0 * x),
        note("sqrt", x) / (1.0 + x),
        (x > 1.0) * 360.0 - x,
    ]
    places = np.array([0.31, 1.1, 1.73, 2.9])
    for number in numbers:
        slope = Program([x], [derivative(number, x)]).many([places], 4)[0]
        value = Program([x], [number])
        beside = [value.many([places + way * 1e-6], 4)[0] for way in (1.0, -1.0)]
        assert np.allclose(slope, (beside[0] - beside[1]) / 2e-6, rtol=1e-7, atol=1e-7)


def test_in_a_single_place_a_choice_counts_for_nothing():
    """The sine of exactly 30° is chosen, and still has the slope of its neighbours."""
    tape = Tape()
    x = tape.input("x")
    chosen = tape.note("select", x == 2.0, 4.0, x * x)
    assert Program([x], [derivative(chosen, x)]).many([np.array([2.0])], 1)[0] == 4.0


def test_only_what_jumps_or_chooses_has_no_rule():
    from vad.kinematics.derivative import _RULES

    constant = {"round", "place", "choose", "less", "greater", "equal", "both", "either"}
    assert OPERATIONS.keys() - _RULES.keys() == constant
