"""As accurate as double precision allows: errors against the oracle, in units of ε·κ.

``VAD_SAMPLES=1000 pytest tests/kinematics/test_accuracy.py`` looks longer.
"""

from __future__ import annotations

import dataclasses
import math
import os

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vad
from tests.kinds import PLANE
from tests.kinematics.families import (
    FAMILIES,
    LENGTHLESS,
    SAMPLERS,
    Case,
    exists,
    samples,
    scaled,
)
from tests.kinematics.worst_cases import BOUNDS, EPSILON, on_array, read, solve, worst
from tests.oracle import Key

pytestmark = pytest.mark.exhaustive

SAMPLES = int(os.environ.get("VAD_SAMPLES", "6"))
WHERE = [(v, f) for v in SAMPLERS for f in FAMILIES if exists(v, f)]
TURNED = [v for v in SAMPLERS if v not in ("double-slider", "gate-actuator")]


@pytest.mark.parametrize(("variant", "family"), WHERE)
def test_errors_stay_within_their_bounds(variant: str, family: str) -> None:
    found = worst(variant, family, SAMPLES)
    beyond = {name: size for name, size in found.items() if size[0] > BOUNDS[name]}
    assert not beyond


@pytest.mark.parametrize("variant", ["four-bar", "slider-crank"])
def test_rates_keep_their_accuracy_at_change_points(variant: str) -> None:
    """Near a change point κ grows without bound, but through the lengths alone.

    Lengths that lie in one line to the last bit cost ω nothing, however near the crank is.
    """
    for case, truth in samples(variant, "change point", 4 * SAMPLES):
        for motion in (solve(case), on_array(case)):
            for key, quantity in truth.items():
                if key[2] == "omega":
                    found = float(np.asarray(read(motion, key)).flat[0])
                    scale = max(map(abs, (quantity.value, quantity.terms["angle"])))
                    scale = max(scale, abs(case.inputs["omega"]))
                    assert abs(found - quantity.value) <= 32 * EPSILON * scale, (key, case)


@pytest.mark.parametrize("exponent", [*range(-16, 0), -50, -100, -200, -300])
@pytest.mark.parametrize("start", [0.0, 180.0])
@pytest.mark.parametrize("sign", [-1, 1])
def test_parallelogram_as_close_to_its_change_point_as_can_be_written(
    exponent: int, start: float, sign: int
) -> None:
    angle = start + sign * 10.0**exponent
    if angle == start:
        pytest.skip("not a different number")
    ratios = [
        vad.solve(vad.FourBar(2, 1, 2, 1, assembly=side), angle=angle, omega=1).link("rocker").omega
        for side in ("open", "crossed")
    ]
    half = math.radians((angle - start) / 2)
    antiparallel = -3 / (1 + 8 * math.sin(half) ** 2 if start == 0 else 9 - 8 * math.sin(half) ** 2)
    assert max(ratios) == pytest.approx(1, rel=1e-15)
    assert min(ratios) == pytest.approx(antiparallel, rel=1e-12)


# --- scale ------------------------------------------------------------------------------------


def shapes(case: Case, factor: float = 1.0) -> dict[Key, float]:
    """Return all results that have no length in them, after scaling everything that has."""
    resized = Case(
        case.name, scaled(case.parameters, factor), scaled(case.inputs, factor), case.assembly
    )
    motion = solve(resized)
    links = motion.to_dict()["links"]
    keys = [("link", name, sort) for name in links for sort in ("angle", "omega", "alpha")]
    return {key: read(motion, key) for key in keys}


@pytest.mark.parametrize(("variant", "family"), WHERE)
def test_powers_of_two_change_no_bit(variant: str, family: str) -> None:
    if family.startswith("scale"):
        pytest.skip("at the end of the range already")
    for case, _ in samples(variant, family, 2, seed=2, conditions=False):
        unscaled = shapes(case)
        for power in (-500, -53, -1, 1, 2, 10, 333, 500):
            assert shapes(case, 2.0**power) == unscaled, (power, case)


# --- angles -----------------------------------------------------------------------------------


@pytest.mark.parametrize("variant", TURNED)
@settings(max_examples=10, deadline=None)
@given(
    eighths=st.integers(-360 * 8, 360 * 8), turns=st.sampled_from([1, -1, 1000, 10**9, -(10**9)])
)
def test_turns_cost_no_accuracy(variant: str, eighths: int, turns: int) -> None:
    case = next(samples(variant, "random", 1, seed=3, conditions=False))[0]
    near, far = ({"angle": eighths / 8 + 360.0 * n} for n in (0, turns))
    try:
        motions = [solve(case, **angle) for angle in (near, far)]
        positions = [motion.point("B").position for motion in motions]
    except vad.AssemblyError:
        return
    assert positions[0] == positions[1]
    assert motions[0].to_dict()["links"] == motions[1].to_dict()["links"]


EXACT = {0: 0.0, 30: 0.5, 90: 1.0, 150: 0.5, 180: 0.0, 210: -0.5, 270: -1.0, 330: -0.5}


@pytest.mark.parametrize("turns", [0, 1, -1, 10**9])
@pytest.mark.parametrize("degrees", range(0, 360, 15))
def test_the_pin_is_exact_where_the_sine_is(degrees: int, turns: int) -> None:
    angle = degrees + 360.0 * turns
    for given_as in (angle, np.array([angle]), np.array([angle] * 9)):
        pin = np.asarray(vad.solve(vad.ScotchYoke(crank=2), angle=given_as).point("B").position)
        pin = pin.flat[-1]
        if degrees in EXACT:
            assert pin.imag == 2 * EXACT[degrees]
        if (90 + degrees) % 360 in EXACT:
            assert pin.real == 2 * EXACT[(90 + degrees) % 360]
        if degrees % 90 == 45:
            assert abs(pin.real) == abs(pin.imag) == pytest.approx(math.sqrt(2), rel=2.3e-16)


@pytest.mark.parametrize("angle", [-1e-17, -1e-300, 0.0, -0.0, 360.0, -360.0, 720.0, 360 - 1e-13])
def test_angles_come_out_below_a_full_turn(angle: float) -> None:
    for given_as in (angle, np.array([angle])):
        motion = vad.solve(vad.FourBar(), angle=given_as)
        for name in ("crank", "coupler", "rocker"):
            found = np.asarray(motion.link(name).angle)
            assert ((found >= 0) & (found < 360)).all()


def test_lengthless_numbers_are_named() -> None:
    """The scaling test leaves alone what has no length in it: no field may be missed."""
    for cls in PLANE.values():
        angles = {f.name for f in dataclasses.fields(cls) if f.metadata["quantity"] == "angle"}
        assert angles <= LENGTHLESS
