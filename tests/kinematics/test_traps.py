"""Where solvers break: known traps, assemblies, toggles, and what cannot be assembled."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest

import vad
from tests.kinematics.test_arrays import values

pytestmark = pytest.mark.exhaustive

SIDES = ("open", "crossed")


def crank(mechanism: Any, angle: Any, omega: Any = 1.0, alpha: Any = 0.0) -> vad.Motion:
    return vad.solve(mechanism, angle=angle, omega=omega, alpha=alpha)


def both_ways(mechanism: Any, angle: float, link: str) -> list[tuple[float, float]]:
    """Return angle and ω of a link, solved as a number and as an array."""
    motions = [crank(mechanism, angle), crank(mechanism, np.array([angle]))]
    links = [motion.link(link) for motion in motions]
    return [(float(np.ravel(x.angle)[0]), float(np.ravel(x.omega)[0])) for x in links]


# --- the table of traps -----------------------------------------------------------------------


def test_four_bar_where_the_half_angle_quadratic_fails() -> None:
    crossed = vad.FourBar(4, 3, 5, 8, assembly="crossed")
    for angle, omega in both_ways(crossed, 90.0, "rocker"):
        assert angle == pytest.approx(180, rel=1e-15)
        assert omega == pytest.approx(0.5, rel=1e-15)
    for angle, omega in both_ways(vad.FourBar(4, 3, 5, 8), 90.0, "rocker"):
        assert math.radians(angle) == pytest.approx(1.854590436003, rel=3e-13)
        assert omega == pytest.approx(0.22, rel=1e-15)


def test_four_bar_at_a_change_point() -> None:
    angle = math.degrees(1e-9)
    motions = [crank(vad.FourBar(2, 1, 2, 1, assembly=side), angle) for side in SIDES]
    found = sorted((m.link("rocker").omega, m.link("coupler").omega) for m in motions)
    assert found[0] == pytest.approx((-3, -2), rel=1e-15)
    assert found[1] == pytest.approx((1, 0), rel=1e-15, abs=1e-15)


def test_slider_crank_after_a_billion_turns() -> None:
    motion = crank(vad.SliderCrank(60, 140), 360e9 + 30)
    assert motion.slide("slider").position == 188.70946753883975


def test_slider_crank_at_a_change_point() -> None:
    motion = crank(vad.SliderCrank(1, 1), 90 - 1e-9)
    assert motion.slide("slider").velocity == pytest.approx(-2, rel=1e-15)
    assert motion.link("rod").omega == pytest.approx(-1, rel=1e-15)


@pytest.mark.parametrize("lengths", [{"ground": 1, "crank": 1}, {"ground": 3, "crank": 3}])
def test_slotted_lever_with_its_pin_near_the_pivot(lengths: dict[str, float]) -> None:
    motion = crank(vad.CrankSlottedLever(**lengths), -90 + 1e-8)
    assert motion.link("lever").omega == pytest.approx(0.5, rel=1e-15)
    exact = 2 * lengths["crank"] * math.sin(math.radians((90 + (-90 + 1e-8)) / 2))
    assert motion.slide("block").position == pytest.approx(exact, rel=1e-15)
    assert motion.slide("block").position == pytest.approx(1.7453e-10 * lengths["crank"], rel=1e-4)


def test_double_slider_near_its_toggle() -> None:
    inputs = {"position": 1 - 1e-15, "velocity": 2, "acceleration": 1}
    motion = vad.solve(vad.DoubleSlider(link=1), **inputs)
    assert motion.slide("slider_b").acceleration == pytest.approx(-4.47750303561e22, rel=6e-12)


# --- assemblies never jump --------------------------------------------------------------------


def side_of_coupler(motion: vad.Motion) -> np.ndarray:
    """Return the area that tells open (+) from crossed (−), over the product of its sides."""
    b, c, d = (motion.point(name).position for name in "BCD")
    area = (np.conj(d - b) * (c - b)).imag
    return area / (abs(d - b) * abs(c - b))


def grashof_linkages(count: int) -> list[tuple[float, float, float, float]]:
    """Return ground, crank, coupler and rocker of linkages whose crank turns fully."""
    draw, found = random.Random(1), []
    while len(found) < count:
        lengths = sorted(draw.uniform(1, 100) for _ in range(4))
        if lengths[0] + lengths[3] < lengths[1] + lengths[2]:
            shortest, *others = lengths
            draw.shuffle(others)
            found.append(  # the shortest link is the crank or the ground
                (others[0], shortest, *others[1:]) if draw.random() < 0.5 else (shortest, *others)
            )
    return found


@pytest.mark.parametrize("steps", [3, 12, 77, 1000])
@pytest.mark.parametrize("side", SIDES)
def test_grashof_linkages_keep_their_assembly(side: str, steps: int) -> None:
    sign = 1 if side == "open" else -1
    for lengths in grashof_linkages(42):
        turn = crank(vad.FourBar(*lengths, assembly=side), np.linspace(0, 720, steps))
        assert turn.assembled.all()
        assert (sign * side_of_coupler(turn) > 0).all(), lengths


@pytest.mark.parametrize("lengths", [(2, 1, 2, 1), (1, 2, 1, 2), (3, 1, 2, 2), (5, 2, 4, 3)])
@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("steps", [13, 360, 361, 7201])
def test_assemblies_stay_through_change_points(
    lengths: tuple[float, ...], side: str, steps: int
) -> None:
    sign = 1 if side == "open" else -1
    turn = crank(vad.FourBar(*lengths, assembly=side), np.linspace(-360, 360, steps))
    assert turn.assembled.all()
    sides = sign * side_of_coupler(turn)
    assert (sides[np.isfinite(sides)] >= -1e-15).all()
    omega = turn.link("rocker").omega
    flat = abs(sides) < 1e-12
    assert np.isfinite(omega[~flat]).all()
    assert not np.isinf(omega).any()


@pytest.mark.parametrize("side", SIDES)
def test_one_pose_does_not_depend_on_its_neighbours(side: str) -> None:
    """A branch is not the pose nearest to the last one: shuffled angles give the same answers."""
    mechanism = vad.FourBar(assembly=side)
    angles = np.linspace(0, 360, 1001)
    order = np.random.default_rng(1).permutation(angles.size)
    straight = crank(mechanism, angles).link("rocker").angle
    shuffled = crank(mechanism, angles[order]).link("rocker").angle
    assert (straight[order] == shuffled).all()


@pytest.mark.parametrize("side", SIDES)
def test_open_means_what_the_contract_says(side: str) -> None:
    sign = 1 if side == "open" else -1
    slider = crank(vad.SliderCrank(assembly=side), 60.0)
    assert sign * (slider.point("C").position - slider.point("B").position).real > 0
    for lever in (vad.CrankSlottedLever, vad.Whitworth):
        ram = crank(lever(rod=300, ram_height=40, assembly=side), 60.0)
        assert sign * (ram.point("E").position - ram.point("C").position).real > 0
    slides = [
        vad.solve(vad.DoubleSlider(1000, 0, 60, assembly=s), position=500).slide("slider_b")
        for s in (side, SIDES[1 - SIDES.index(side)])
    ]
    assert sign * (slides[0].position - slides[1].position) > 0
    gate = vad.solve(vad.GateActuator(assembly=side), position=3.8)
    d, b = gate.point("D").position, gate.point("B").position
    assert sign * ((-d).conjugate() * (b - d)).imag > 0


# --- toggles and dead centres -----------------------------------------------------------------

TOGGLES: dict[str, tuple[Any, dict[str, float], dict[str, float], str, str, complex]] = {
    "four-bar": (vad.FourBar(4, 3, 2, 3), {"angle": 90}, {"angle": 91}, "rocker", "C", 1.6 + 1.8j),
    "slider-crank": (vad.SliderCrank(2, 1, 1), {"angle": 90}, {"angle": -90}, "rod", "C", 1j),
    "double-slider": (vad.DoubleSlider(1), {"position": 1}, {"position": 1.01}, "link", "B", 0),
    "gate-actuator": (
        vad.GateActuator(ground=3, arm=5, ground_angle=0),
        {"position": 8},
        {"position": 8.01},
        "arm",
        "B",
        -5,
    ),
    "ram": (
        vad.Whitworth(ground=1, crank=2, arm=1, rod=2, ram_height=-4),
        {"angle": 90},
        {"angle": -90},
        "rod",
        "E",
        -4j,
    ),
}
"""Mechanism, an input on its toggle, one beyond it, a link whose rates fail, and a point there."""


@pytest.fixture(params=TOGGLES, name="toggle")
def toggle_of(request: pytest.FixtureRequest) -> Any:
    return TOGGLES[request.param]


def test_toggle_positions_answer(toggle: Any) -> None:
    mechanism, inputs, _, link, point, place = toggle
    motion = vad.solve(mechanism, **inputs)
    assert motion.point(point).position == pytest.approx(place, abs=1e-15)
    assert 0 <= motion.link(link).angle < 360


def test_toggle_rates_raise_for_one_pose(toggle: Any) -> None:
    mechanism, inputs, _, link, point, _ = toggle
    motion = vad.solve(mechanism, **inputs)
    for ask in (
        lambda: motion.link(link).omega,
        lambda: motion.link(link).alpha,
        lambda: motion.point(point).velocity,
        lambda: motion.point(point).acceleration,
    ):
        with pytest.raises(vad.DeadCentreError):
            ask()


def test_toggle_rates_are_nan_in_arrays(toggle: Any) -> None:
    mechanism, inputs, _, link, point, place = toggle
    motion = vad.solve(mechanism, **{key: np.array([value]) for key, value in inputs.items()})
    assert motion.assembled.tolist() == [True]
    assert motion.point(point).position[0] == pytest.approx(place, abs=1e-15)
    for rate in (motion.link(link).omega, motion.link(link).alpha, motion.point(point).velocity):
        assert np.isnan(rate).all()


def test_beyond_a_toggle_there_is_no_pose(toggle: Any) -> None:
    mechanism, _, beyond, link, point, _ = toggle
    with pytest.raises(vad.AssemblyError):
        vad.solve(mechanism, **beyond).point(point).position  # noqa: B018
    motion = vad.solve(mechanism, **{key: np.array([value]) for key, value in beyond.items()})
    assert motion.assembled.tolist() == [False]
    for value in (motion.link(link).angle, motion.link(link).omega, motion.point(point).position):
        assert np.isnan(value).all()


@pytest.mark.parametrize("side", SIDES)
def test_the_rounding_band_of_a_toggle_is_the_toggle(side: str) -> None:
    mechanism = vad.FourBar(4, 3, 2, 3, assembly=side)
    motion = crank(mechanism, np.nextafter(90.0, 91.0))
    assert motion.point("C").position == pytest.approx(1.6 + 1.8j, abs=1e-7)
    with pytest.raises(vad.AssemblyError):
        crank(mechanism, 90 + 1e-9).point("C").position  # noqa: B018


def test_assembly_errors_say_what_would_work() -> None:
    mechanism = vad.FourBar(4, 3, 2, 3)
    with pytest.raises(vad.AssemblyError) as caught:
        crank(mechanism, 120.0).point("C").position  # noqa: B018
    assert "\n" not in str(caught.value)
    assert "they close for angle -90° … 90°" in str(caught.value)
    assert caught.value.hint is not None
    assert crank(mechanism, float(caught.value.hint.split()[-1])).assembled


@pytest.mark.parametrize("cls", [vad.CrankSlottedLever, vad.Whitworth])
def test_a_pin_on_the_pivot_has_no_lever_angle(cls: Any) -> None:
    mechanism = cls(ground=1, crank=1)
    motion = crank(mechanism, -90.0)
    assert motion.point("B").position == -1j
    assert motion.slide("block").position == 0
    for ask in (lambda: motion.link("lever").angle, lambda: motion.link("lever").omega):
        with pytest.raises(vad.DeadCentreError):
            ask()
    several = crank(mechanism, np.array([-90.0, 0.0]))
    assert several.assembled.tolist() == [True, True]
    assert np.isnan(several.link("lever").angle).tolist() == [True, False]
    assert np.isnan(several.link("lever").omega).tolist() == [True, False]


@pytest.mark.parametrize("angle", [0.0, 180.0, 360.0])
def test_a_flat_parallelogram_has_a_pose_but_no_rates(angle: float) -> None:
    motion = crank(vad.FourBar(2, 1, 2, 1), angle)
    assert motion.point("C").position == (2 + 1 if angle % 360 == 0 else 1)
    with pytest.raises(vad.DeadCentreError):
        motion.link("rocker").omega  # noqa: B018


# --- never ±inf, never a warning --------------------------------------------------------------

AWKWARD = np.array(
    [0, -0.0, 45, 90, -90, 180, 270, 360, 90 - 1e-14, 1e-9, 1e-300, 5e-324, -1e-17, 1e17, 1e300]
)
NOTHING = np.array([np.nan, np.inf, -np.inf])


@pytest.mark.parametrize("name", list(vad.MECHANISMS))
@pytest.mark.parametrize("side", SIDES)
@pytest.mark.filterwarnings("error")
def test_awkward_inputs_give_numbers_or_nan(name: str, side: str) -> None:
    cls = vad.MECHANISMS[name]
    first, second, third = cls.inputs
    given = np.concatenate([AWKWARD, NOTHING])
    motion = vad.solve(cls(assembly=side), **{first: given, second: 2.0, third: -1.0})
    assert motion.assembled.shape == given.shape
    assert not motion.assembled[~np.isfinite(given)].any()
    single = vad.solve(cls(assembly=side)).to_dict()
    for (kind, _, _), value in values(motion, single).items():
        assert not np.isinf(value).any()
        assert kind == "link" or value.shape == given.shape


@pytest.mark.parametrize("angle", [1e17, 1e300, -1e17, 5e-324])
def test_huge_and_tiny_angles_are_angles(angle: float) -> None:
    motion = crank(vad.FourBar(), angle)
    assert motion.link("crank").angle == math.fmod(angle, 360) % 360
