"""Engines: the two turning vectors against direct sums, and both terms against exact pistons."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vad
from vad.balancing.inertia import Cylinder, InertiaForces
from vad.errors import InputError
from vad.files.examples import example_path

row = st.tuples(
    st.floats(0.5, 30.0), st.floats(0.0, 360.0), st.floats(-500.0, 500.0), st.floats(0.0, 360.0)
)
WORDS = ("mass", "crank", "plane", "line")


def summed(cylinders, radius, ratio, omega, order, angle, couple=False):
    """Return a resultant as the sum of the force of each piston along its line."""
    total = mpmath.mpc(0)
    for each in cylinders:
        local = math.radians(angle + each["crank"] - each["line"])
        size = each["mass"] * radius / 1000 * omega**2 * mpmath.cos(order * mpmath.mpf(local))
        size *= 1 if order == 1 else mpmath.mpf(1) / ratio
        size *= each["plane"] / 1000 if couple else 1
        total += size * mpmath.expj(mpmath.radians(each["line"]))
    return complex(total)


@settings(deadline=None, max_examples=40)
@given(st.lists(row, min_size=1, max_size=6), st.floats(2.0, 6.0), st.floats(0.0, 360.0))
def test_resultants_are_sums_of_pistons(rows, ratio, angle):
    cylinders = [dict(zip(WORDS, each, strict=True)) for each in rows]
    omega = 500 * math.tau / 60
    pistons = tuple(Cylinder(f"A{k}", **each) for k, each in enumerate(cylinders))
    inertia = InertiaForces(pistons, 75.0, ratio, omega)
    for order, kind in ((1, "primary"), (2, "secondary")):
        for what in ("force", "couple"):
            phasors = inertia.phasors(kind, what)
            got = phasors.at(complex(math.cos(math.radians(angle)), math.sin(math.radians(angle))))
            exact = summed(cylinders, 75, ratio, omega, order, angle, what == "couple")
            scale = phasors.scale or 1.0
            assert abs(got - exact) < 1e-11 * scale
            # What is said to be largest and least is so over a turn, and where it is said to be.
            angles = np.arange(0.0, 360.0, 5.0)
            sizes = np.abs(phasors.at(np.exp(1j * np.radians(angles))))
            assert sizes.max() <= phasors.largest * (1 + 1e-12) + 1e-12 * scale
            assert sizes.min() >= phasors.least * (1 - 1e-12) - 1e-12 * scale
            for name, value in (("angles", phasors.largest), ("least_angles", phasors.least)):
                for place in getattr(phasors, name):
                    there = phasors.at(np.exp(1j * np.radians([place])))
                    assert abs(abs(there[0]) - value) < 1e-11 * scale


def test_both_terms_leave_out_little():
    """The largest part of what is left out is m·r·ω²·(cos 2θ - cos 4θ)/(4n³), at most at 90°."""
    one = vad.engine([{"mass": 2}], 50, 5, 600)
    unit = 2 * 0.05 * (20 * math.pi) ** 2
    assert one.left_out.force == pytest.approx(unit / (2 * 5**3), rel=0.05)
    assert one.left_out.angle in (90.0, 270.0)
    long = vad.engine([{"mass": 2}], 50, 50, 600)
    assert long.left_out.force < 1e-5 * unit


def test_exact_force_is_that_of_the_slider_crank():
    twin = vad.engine([{"mass": 3, "crank": 40}], 60, rod=140, rpm=300)
    motion = vad.solve(twin.motion.mechanism, angle=76.9, omega=10 * math.pi)
    found = twin.motion.mechanism.balancing(motion)
    crank = vad.solve(vad.SliderCrank(crank=60, rod=140), angle=116.9, omega=10 * math.pi)
    expected = -3 * crank.slide("slider").acceleration / 1000
    assert found.exact() == pytest.approx(expected, rel=1e-12)


def test_a_counterweight_balances_a_right_angled_v():
    cylinders = [{"mass": 11.5, "line": 45}, {"mass": 11.5, "line": -45}]
    weight = {"W": {"mass": 11.5, "radius": 75, "angle": 180, "plane": 0}}
    assert vad.engine(cylinders, 75, 4, 500, shaft=weight).largest("primary", "force") == 0.0


def test_straight_eight_is_balanced():
    cranks = (0, 180, 90, 270, 270, 90, 180, 0)
    cylinders = [{"mass": 1, "crank": c, "plane": 100 * k - 350} for k, c in enumerate(cranks)]
    found = vad.engine(cylinders, 40, 4, 3000)
    for kind in ("primary", "secondary"):
        for what in ("force", "couple"):
            assert found.largest(kind, what) == 0.0


def test_boxer_has_couples_alone():
    cylinders = [
        {"mass": 1, "crank": 0, "line": 0, "plane": 20},
        {"mass": 1, "crank": 180, "line": 180, "plane": -20},
    ]
    found = vad.engine(cylinders, 35, 4, 6000)
    assert found.largest("primary", "force") == found.largest("secondary", "force") == 0.0
    unit = 0.035 * (200 * math.pi) ** 2
    assert found.largest("primary", "couple") == pytest.approx(0.04 * unit)
    assert found.largest("secondary", "couple") == pytest.approx(0.04 * unit / 4)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ({"ratio": 0.9}, "a rod must be longer than its crank"),
        ({"ratio": 4, "rod": 200}, "rod and ratio say the same"),
        ({}, "neither rod nor ratio"),
        ({"ratio": 4, "rpm": 0}, "has no speed"),
    ],
)
def test_refused(words, said):
    given = {"rpm": 500} | words
    with pytest.raises(InputError) as caught:
        vad.engine([{"mass": 1}], 50, **given)
    assert said in str(caught.value)


def test_an_engine_has_an_even_speed():
    made = vad.engine([{"mass": 1}], 50, 4, 500).motion.mechanism
    with pytest.raises(InputError, match="even speed"):
        made.balancing(vad.solve(made, alpha=3))


def test_a_single_cylinder_partly_balanced():
    """With the share c balanced, (1 - c)·m·r·ω² is left along the stroke and c·m·r·ω² across it."""
    mechanism = vad.load(example_path("single-cylinder"))()
    engine = mechanism.balancing(vad.solve(mechanism))
    whole = 6 * 0.05 * (50 * math.pi) ** 2
    assert engine.largest("primary", "force") == pytest.approx(whole * 2 / 3, rel=1e-12)
    assert engine.least("primary", "force") == pytest.approx(whole / 3, rel=1e-12)
    assert engine.angles("primary", "force") == (90.0, 270.0)
    assert engine.least_angles("primary", "force") == (0.0, 180.0)
