"""Balanced shafts: both sums are zero about every plane, whichever way they were found."""

from __future__ import annotations

import cmath
import math

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vad
from vad.balancing.shaft import balanced, masses_of
from vad.errors import InputError

KHURMI = {
    "A": {"mass": 200, "radius": 80, "angle": 0, "plane": 0},
    "B": {"mass": 300, "radius": 70, "angle": 45, "plane": 300},
    "C": {"mass": 400, "radius": 60, "angle": 115, "plane": 400},
    "D": {"mass": 200, "radius": 80, "angle": 235, "plane": 700},
    "X": {"radius": 100, "plane": 100},
    "Y": {"radius": 100, "plane": 500},
}
few = settings(deadline=None, max_examples=40)
mass = st.floats(1.0, 50.0)
angle = st.floats(0.0, 359.0)


def sums(masses, plane=0.0):
    """Return force and couple about a plane, their sizes, by mpmath alone."""
    with mpmath.workdps(40):
        vectors = [
            mpmath.mpf(each["mass"])
            * each["radius"]
            * mpmath.expj(mpmath.mpf(each["angle"]) * mpmath.pi / 180)
            for each in masses.values()
        ]
        arms = [mpmath.mpf(each.get("plane", 0.0)) - plane for each in masses.values()]
        couples = [v * arm for v, arm in zip(vectors, arms, strict=True)]
        sizes = max(map(abs, vectors)), max([*map(abs, couples), mpmath.mpf(1)])
        return (
            float(abs(mpmath.fsum(vectors)) / sizes[0]),
            float(abs(mpmath.fsum(couples)) / sizes[1]),
        )


def solved(masses, choice=0):
    """Return the masses of an answer, without the motion of a shaft."""
    found = balanced(masses_of(masses), "mm")[choice]
    return {each.name: each.numbers() for each in found.masses}


def check(masses):
    planes = [each["plane"] for each in masses.values() if "plane" in each] or [0.0]
    for plane in (*planes, min(planes) - 777.0, sum(planes) / len(planes)):
        force, couple = sums(masses, plane)
        assert force < 1e-12
        if "plane" in next(iter(masses.values())):
            assert couple < 1e-11


@few
@given(st.lists(st.tuples(mass, mass, angle, st.floats(-900.0, 900.0)), min_size=1, max_size=6))
def test_two_masses_balance_any_shaft(rows):
    masses = {
        letter: dict(zip(("mass", "radius", "angle", "plane"), row, strict=True))
        for letter, row in zip("ABCDEF", rows, strict=False)
    }
    masses |= {"X": {"radius": 10.0, "plane": -1000.0}, "Y": {"radius": 20.0, "plane": 1000.0}}
    check(solved(masses))


@few
@given(st.lists(st.tuples(mass, mass, angle), min_size=1, max_size=6))
def test_one_mass_balances_any_disc(rows):
    masses = {
        letter: dict(zip(("mass", "radius", "angle"), row, strict=True))
        for letter, row in zip("ABCDEF", rows, strict=False)
    }
    check(solved(masses | {"X": {"radius": 10.0}}))


@few
@given(mass, angle, angle, st.floats(5.0, 175.0))
def test_two_sizes(size, turn, first, between):
    masses = {
        "A": {"mass": size, "radius": 10.0, "angle": turn},
        "X": {"radius": 10.0, "angle": first},
        "Y": {"radius": 10.0, "angle": first + between},
    }
    check(solved(masses))


@few
@given(mass, angle, st.floats(0.55, 0.95), st.floats(0.55, 0.95))
def test_two_angles_have_two_answers_that_mirror_each_other(size, turn, one, other):
    masses = {
        "A": {"mass": size, "radius": 10.0, "angle": turn},
        "X": {"mass": one * size, "radius": 10.0},
        "Y": {"mass": other * size, "radius": 10.0},
    }
    first, second = (solved(masses, number) for number in (0, 1))
    check(first)
    check(second)
    for name in "XY":
        both = first[name]["angle"] + second[name]["angle"]
        assert math.remainder(both - 2 * turn, 360.0) == pytest.approx(0.0, abs=1e-9)
    # The first vector of the first answer lies to the left of the line that closes the polygon.
    closing = -cmath.rect(1.0, math.radians(turn))
    x = cmath.rect(1.0, math.radians(first["X"]["angle"]))
    assert (closing.conjugate() * x).imag > 0.0


@few
@given(mass, angle, angle, st.floats(1.05, 3.0))
def test_a_size_and_an_angle(size, turn, line, share):
    masses = {
        "A": {"mass": size, "radius": 10.0, "angle": turn},
        "X": {"radius": 10.0, "angle": line},
        "Y": {"mass": share * size, "radius": 10.0},
    }
    for number in range(len(balanced(masses_of(masses), "mm"))):
        check(solved(masses, number))


def test_both_answers():
    masses = {
        "A": {"mass": 5, "radius": 10, "angle": 30},
        "X": {"mass": 3, "radius": 10},
        "Y": {"mass": 4, "radius": 10},
    }
    found, second = vad.balance(masses), vad.balance(masses, choice=1)
    (other,) = found.others
    check(found.masses)
    check(other.masses)
    assert dict(other.masses) == dict(second.masses) != dict(found.masses)
    assert dict(second.others[0].masses) == dict(found.masses)


def test_the_order_of_the_planes_makes_no_difference():
    """The couples are taken about X or about Y: the masses are the same."""
    names = ("A", "B", "C", "D", "Y", "X")
    other = vad.balance({name: KHURMI[name] for name in names})
    found = vad.balance(KHURMI)
    assert (found.found.couple.reference, other.found.couple.reference) == ("X", "Y")
    for name in names:
        for what, value in found.masses[name].items():
            assert other.masses[name][what] == pytest.approx(value, rel=1e-13)


def test_clockwise_books():
    """Khurmi's example 21.2 counts angles clockwise in its answer: 145° and 12°."""
    turned = {
        name: {**each, "angle": -each["angle"]} if "angle" in each else each
        for name, each in KHURMI.items()
    }
    found, other = vad.balance(turned, clockwise=True), vad.balance(KHURMI)
    for name, each in other.masses.items():
        angle = -each["angle"] % 360.0
        assert found.masses[name]["angle"] == pytest.approx(angle, abs=1e-12)
        assert found.masses[name]["mass"] == pytest.approx(each["mass"], rel=1e-14)


def test_forces_on_bearings():
    found = vad.balance(KHURMI, rpm=300, bearings=(-100, 800))
    (one, other), omega = found.bearing_forces, 10 * math.pi
    assert one.force == other.force == 0
    known = {name: each for name, each in found.masses.items() if name in "ABCD"}
    vectors = [
        each["mass"] * each["radius"] * cmath.rect(1, math.radians(each["angle"]))
        for each in known.values()
    ]
    planes = [each["plane"] for each in known.values()]
    pull = omega**2 / 1000
    assert one.without + other.without == pytest.approx(pull * sum(vectors))
    about = pull * sum(v * (at + 100) for v, at in zip(vectors, planes, strict=True))
    assert other.without * 900 == pytest.approx(about)


def test_a_shaft_that_is_not_balanced():
    known = {name: KHURMI[name] for name in "ABCD"}
    found = vad.balance(known, rpm=300, bearings=(-100, 800))
    assert not found.balanced
    assert found.bearing_forces == tuple(
        each._replace(force=each.without)
        for each in vad.balance(KHURMI, rpm=300, bearings=(-100, 800)).bearing_forces
    )


def test_a_shaft_that_is_balanced_says_so():
    found = vad.balance({name: dict(each) for name, each in vad.balance(KHURMI).masses.items()})
    assert found.balanced and found.residual == (0j, 0j) and not found.unknowns
    assert "balanced" in found.table()


@pytest.mark.parametrize(
    ("masses", "said"),
    {
        "three": (
            {**KHURMI, "Y": {"radius": 100, "angle": 0, "plane": 500}},
            "3 unknowns (X's mass, X's angle, Y's mass), not 4",
        ),
        "one plane": (
            {**KHURMI, "Y": {"radius": 100, "plane": 100}},
            "X and Y are in one plane, at 100 mm",
        ),
        "none": (
            {"A": {"mass": 1, "radius": 1, "angle": 0}},
            "0 unknowns, not 2",
        ),
        "product": (
            {"A": {"mass": 1, "radius": 1, "angle": 0}, "X": {"angle": 0}},
            "mass and radius are both left out",
        ),
        "parallel": (
            {
                "A": {"mass": 1, "radius": 1, "angle": 10},
                "X": {"radius": 1, "angle": 40},
                "Y": {"radius": 1, "angle": 220},
            },
            "parallel lines, at 40°",
        ),
        "open": (
            {
                "A": {"mass": 9, "radius": 1, "angle": 10},
                "X": {"radius": 1, "mass": 2},
                "Y": {"radius": 1, "mass": 3},
            },
            "X (2 kg·mm) and Y (3 kg·mm) do not reach over a gap of 9 kg·mm",
        ),
        "line": (
            {
                "A": {"mass": 9, "radius": 1, "angle": 90},
                "X": {"radius": 1, "angle": 0},
                "Y": {"radius": 1, "mass": 3},
            },
            "Y (3 kg·mm) does not reach the line of X, 9 kg·mm away",
        ),
    }.values(),
)
def test_refused(masses, said):
    with pytest.raises(InputError) as caught:
        vad.balance(masses)
    assert said in str(caught.value) and caught.value.hint


def test_a_negative_mass_is_material_to_be_taken_away():
    found = vad.balance(
        {
            "A": {"mass": 4, "radius": 10, "angle": 0},
            "X": {"radius": 10, "angle": 0},
            "Y": {"radius": 10, "angle": 90},
        }
    )
    assert found.masses["X"]["mass"] == -4 and found.masses["Y"]["mass"] == 0
