"""As accurate as double precision allows, in space too: errors in ε·κ, near dead centres as well.

The bounds are those of the plane, 2, 4 and 8 by order.
"""

from __future__ import annotations

import math
from typing import Any

from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

import vad
from tests.kinematics.space.conditions import BOUNDS, errors
from vad.kinematics.solver import solver_of

FEW = settings(max_examples=3, deadline=None, suppress_health_check=list(HealthCheck))
arcs = st.floats(5.0, 175.0)
sides = st.sampled_from(["open", "crossed"])
inputs = st.fixed_dictionaries(
    {"angle": st.floats(0.0, 360.0), "omega": st.floats(0.1, 5.0), "alpha": st.floats(-9.0, 9.0)}
)


def check(mechanism: vad.Mechanism, given: dict[str, float]) -> None:
    try:
        vad.solve(mechanism, **given).to_dict()
    except vad.VadError:
        assume(False)
    found = errors(mechanism, given)
    beyond = {key: size for key, size in found.items() if size > BOUNDS[key[1]]}
    assert not beyond


def spherical(sizes: list[float], side: str) -> vad.SphericalFourBar:
    return vad.SphericalFourBar(*sizes, assembly=side)


def spatial(twists: list[float], lengths: list[float], side: str) -> vad.SpatialFourBar:
    names = ("ground_twist", "crank_twist", "coupler_twist", "rocker_twist")
    return vad.SpatialFourBar(*lengths, **dict(zip(names, twists, strict=True)), assembly=side)


four_arcs = st.lists(arcs, min_size=4, max_size=4)
four_lengths = st.lists(st.floats(-100.0, 100.0), min_size=4, max_size=4)


@FEW
@given(shafts=st.floats(-89.9, 89.9), given=inputs)
def test_hooke(shafts: float, given: Any) -> None:
    check(vad.HookeJoint(shafts), given)


@FEW
@given(sizes=four_arcs, side=sides, given=inputs, small=st.floats(0.0, 5.0))
def test_spherical(sizes: list[float], side: str, given: Any, small: float) -> None:
    check(spherical([each * 10.0**-small for each in sizes], side), given)


@settings(FEW, max_examples=1)
@given(twists=four_arcs, lengths=four_lengths, side=sides, given=inputs)
def test_spatial(twists: list[float], lengths: list[float], side: str, given: Any) -> None:
    check(spatial(twists, lengths, side), given)


@FEW
@given(
    bars=st.lists(st.floats(20.0, 200.0), min_size=3, max_size=3),
    others=st.lists(st.floats(-90.0, 90.0), min_size=4, max_size=4),
    side=sides,
    given=inputs,
)
def test_balls(bars: list[float], others: list[float], side: str, given: Any) -> None:
    ground, twist, crank_offset, rocker_offset = others
    offsets = {"crank_offset": crank_offset, "rocker_offset": rocker_offset}
    check(vad.RSSR(ground, *bars, ground_twist=2 * twist, **offsets, assembly=side), given)


@settings(FEW, max_examples=2)
@given(
    sizes=four_arcs,
    lengths=st.none() | four_lengths,
    side=sides,
    near=st.integers(3, 9),
    within=st.sampled_from([-1.0, 1.0]),
    given=inputs,
)
def test_near_a_dead_centre(
    sizes: list[float],
    lengths: list[float] | None,
    side: str,
    near: int,
    within: float,
    given: Any,
) -> None:
    mechanism: Any = spatial(sizes, lengths, side) if lengths else spherical(sizes, side)
    limits = solver_of(mechanism).limits()
    assume(len(limits))
    given["angle"] = float(limits[0]) + within * math.degrees(10.0**-near)
    check(mechanism, given)
