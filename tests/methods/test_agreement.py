"""Every method agrees with the closed form, and that with fifty digits, on every mechanism."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from mpmath import mp

import vad
from tests.kinds import PLANE
from tests.kinematics.hand_built import BUILT, HandBuilt
from tests.oracle import reference
from vad.kinematics.linkage import Bar, angle_of, length_of
from vad.methods import (
    METHODS,
    construction,
    finite_differences,
    high_precision,
    loop_closure,
    newton,
    problem_of,
)
from vad.methods.comparison import compare, largest_error
from vad.methods.problem import LoopEquation, LoopVector

pytestmark = pytest.mark.exhaustive

# Dimensions and inputs besides the defaults: rams, offsets, slanted grounds, every quadrant.
POSES = {
    "four-bar": ({"ground_angle": 37.0}, {"angle": 200.0, "omega": -2.0, "alpha": 3.0}),
    "slider-crank": ({"offset": -20.0}, {"angle": 250.0, "omega": -2.0, "alpha": 3.0}),
    "crank-slotted-lever": ({"rod": 120.0, "ram_height": 140.0}, {"angle": 310.0, "alpha": 3.0}),
    "whitworth": ({"rod": 200.0, "ground_angle": -60.0}, {"angle": 130.0, "alpha": -40.0}),
    "elliptical-trammel": ({"tracer": -30.0}, {"angle": 200.0, "alpha": 3.0}),
    "scotch-yoke": ({}, {"angle": 290.0, "omega": -2.0, "alpha": 3.0}),
    "double-slider": ({"guide_a": 20.0, "guide_b": 250.0}, {"position": -300.0}),
    "gate-actuator": ({"ground_angle": 10.0}, {"position": 4.1, "acceleration": 2.0}),
}
CASES = [
    (name, assembly, *pose)
    for name in PLANE
    for assembly in ("open", "crossed")
    for pose in (({}, {}), POSES.get(name, ({}, {})))
]
# In units of the last place of a result these would be some tens: the poses are well-conditioned
# but for the gate's default, whose accelerations are a hundredth of the terms that they are
# the difference of.
ROUNDING = 3e-13
TOLERANCES = {
    "construction": ROUNDING,
    "unit vectors": ROUNDING,
    "loop closure": ROUNDING,
    "closed form": ROUNDING,
    "Newton": ROUNDING,  # after a step below 1e-10 the error is below 1e-20 but for rounding
    # Truncation h² and rounding ε/h² of the second difference meet at 1e-8 for h = 1e-4; terms
    # that cancel and third derivatives larger than 1 cost up to three digits more.
    "finite differences": 1e-5,
}


@pytest.mark.parametrize(("name", "assembly", "dimensions", "inputs"), CASES)
def test_every_method_agrees(name, assembly, dimensions, inputs):
    mechanism = vad.MECHANISMS[name](**dimensions, assembly=assembly)
    problem = problem_of(mechanism, inputs)
    truth = high_precision.solve(problem)
    for method, solve in METHODS.items():
        assert largest_error(solve(problem), truth) < TOLERANCES[method], method


@pytest.mark.parametrize(
    ("name", "assembly", "dimensions", "inputs"), [case for case in CASES if case[0] in POSES]
)
def test_high_precision_agrees_with_the_tests_own_oracle(name, assembly, dimensions, inputs):
    mechanism = vad.MECHANISMS[name](**dimensions, assembly=assembly)
    given = {**mechanism.inputs, **inputs}
    truth = reference(name, mechanism.parameters(), given, assembly, conditions=False)
    attributes = {
        "angle": ("link", "angle", "omega", "alpha"),
        "length": ("slide", "position", "velocity", "acceleration"),
    }
    # The height of Whitworth's ram is by default a product rounded to double precision.
    digits = 14 if name == "whitworth" and "rod" in dimensions else 40
    with mp.workdps(50):
        for scalar, jet in high_precision.solve(problem_of(mechanism, inputs)).items():
            kind, *names = attributes[scalar.kind]
            for attribute, found in zip(names, jet, strict=True):
                expected = truth[kind, scalar.name, attribute].value
                miss = found - expected
                if attribute == "angle":
                    miss -= 2 * mp.pi * mp.nint(miss / (2 * mp.pi))
                assert abs(miss) <= abs(expected) * mp.mpf(10) ** -digits


@pytest.mark.parametrize("angle", [60.0, 250.0])
@pytest.mark.parametrize("ground_angle", [0.0, 37.0])
def test_every_method_keeps_a_parallelogram_one(angle: float, ground_angle: float):
    """Its coupler does not turn: what is zero is measured by what is not."""
    mechanism = vad.FourBar(100, 40, 100, 40, ground_angle=ground_angle, assembly="parallel")
    comparison = compare(mechanism, {"angle": angle, "omega": 1.0, "alpha": 3.0})
    for row in comparison.rows:
        assert row.error < TOLERANCES[row.method], row.method
    coupler = comparison.truth[angle_of("coupler")]
    assert (coupler.rate, coupler.second) == (0, 0)


def test_table_1_of_the_paper():
    """A link of 1 m between perpendicular guides, x = 0.5 m, v = 2 m/s, a = 1 m/s²."""
    mechanism = vad.DoubleSlider(link=1, length_unit="m")
    inputs = {"position": 0.5, "velocity": 2.0, "acceleration": 1.0}
    comparison = compare(mechanism, inputs)
    assert [row.method for row in comparison.rows] == list(METHODS)
    for row in comparison.rows:
        (_, link), (_, slider) = sorted(row.found.items())
        assert link.rate == pytest.approx(2.31, abs=0.005)
        assert slider.rate == pytest.approx(-1.15, abs=0.005)
        assert link.second == pytest.approx(4.23, abs=0.005)
        assert slider.second == pytest.approx(-6.74, abs=0.005)
        assert row.error < 1e-7 and row.seconds > 0


def test_a_smaller_tolerance_brings_newton_nearer():
    problem = problem_of(vad.FourBar(), {})
    truth = high_precision.solve(problem)
    errors = [
        largest_error(newton.solve(problem, tolerance=tolerance), truth)
        for tolerance in (1e-2, 1e-4, 1e-6)
    ]
    assert errors[0] > 1e-5 > errors[1] > 1e-11 > errors[2]  # digits double with every step


def test_finite_differences_gain_until_rounding_takes_over():
    problem = problem_of(vad.SliderCrank(), {})
    truth = high_precision.solve(problem)
    coarse, best, fine = (
        largest_error(finite_differences.solve(problem, step=step), truth)
        for step in (1e-1, 1e-4, 1e-7)
    )
    assert best < 1e-6 and coarse > 1e-4 and fine > 1e-4


def test_a_driver_at_rest_moves_nothing():
    for name, kind in PLANE.items():
        place, rate, second = kind.inputs
        problem = problem_of(kind(), {place: kind.inputs[place], rate: 0.0, second: 0.0})
        for solve in METHODS.values():
            for jet in solve(problem).values():
                assert (jet.rate, jet.second) == (0.0, 0.0), name


def test_newton_says_that_it_has_run_over_to_the_other_side():
    open_, crossed = (
        problem_of(vad.FourBar(assembly=assembly), {}) for assembly in ("open", "crossed")
    )
    with pytest.raises(ArithmeticError, match="other assembly"):
        newton.solve(open_, start=newton.sketch(crossed))


def test_a_method_without_an_answer_has_a_reason():
    """So near a toggle whole degrees are no start for Newton, nor is there room for differences."""
    mechanism = vad.FourBar(ground=4, crank=3, coupler=2, rocker=3)
    rows = {row.method: row for row in compare(mechanism, {"angle": 90 - 1e-7}).rows}
    assert rows["Newton"].found is None and "converge" in rows["Newton"].problem
    assert rows["finite differences"].found is None
    assert rows["closed form"].error < 1e-6
    assert math.isnan(rows["Newton"].error)


def test_a_pose_that_cannot_be_is_the_closed_form_s_error():
    with pytest.raises(vad.AssemblyError):
        compare(vad.FourBar(crank=130), {"angle": 0.0})
    with pytest.raises(vad.DeadCentreError):
        compare(vad.FourBar(ground=4, crank=3, coupler=2, rocker=3), {"angle": 90.0})


@pytest.mark.parametrize("name", list(BUILT))
def test_every_method_knows_linkages_of_many_dyads(name: str) -> None:
    problem = problem_of(HandBuilt(BUILT[name]()), {})
    if problem.driver.kind == "length":
        problem = problem_of(problem.mechanism, {"position": 420.0, "velocity": -60.0})
    truth = high_precision.solve(problem)
    for method, solve in METHODS.items():
        tolerance = 1e-4 if method == "finite differences" else 1e-10  # the feed's terms cancel
        assert largest_error(solve(problem), truth) < tolerance, method


def test_a_slot_beside_its_pivot_is_refused() -> None:
    linkage = BUILT["oscillating-cylinder"]()
    loop = replace(linkage.loops[0], second=(Bar("DQ", "cylinder", "cylinder", offset=20j),))
    with pytest.raises(vad.InputError, match=r"^cylinder: to be compared, its slot must pass"):
        problem_of(HandBuilt(replace(linkage, loops=(loop,))), {})


@pytest.mark.parametrize("pivot", [-1e10, 1e10])
@pytest.mark.parametrize("method", [construction, loop_closure])
def test_a_lever_whose_slope_is_too_small_for_a_double(method, pivot):
    lever, block = angle_of("lever"), length_of("block")
    vectors = LoopVector(-1, 100.0, angle_of("crank")), LoopVector(1, block, lever)
    equation = LoopEquation(complex(pivot), vectors, (lever, block))
    found = method.position(equation, {angle_of("crank"): 1e-320}, 1)
    assert math.remainder(found[lever], math.pi) == 0.0
    assert abs(found[block]) == abs(pivot - 100.0)
