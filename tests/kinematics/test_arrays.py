"""Whatever can hold numbers can be an input, and what comes out belongs to the caller."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import vad
from tests.kinematics.families import SAMPLERS, exists, samples
from tests.kinematics.worst_cases import read, solve

pytestmark = pytest.mark.exhaustive

NAMES = list(vad.MECHANISMS)
GOOD = np.array([20.0, 75.0, 130.0, 250.0, 340.0])


def rocker(angle: Any, **rates: Any) -> Any:
    return vad.solve(vad.FourBar(), angle=angle, **rates).link("rocker")


WANTED = rocker(GOOD).angle.tolist()


def values(motion: vad.Motion, names: dict[str, Any]) -> dict[tuple[str, str, str], Any]:
    """Return everything that a motion has, for the items listed in a to_dict().

    Of vectors in space it is each component.
    """
    found = {}
    for kind, attributes in (
        ("link", ("angle", "omega", "alpha")),
        ("joint", ("angle", "omega", "alpha")),
        ("point", ("position", "velocity", "acceleration")),
        ("slide", ("position", "velocity", "acceleration", "coriolis")),
    ):
        for name, item in names.get(kind + "s", {}).items():
            for attribute in (each for each in attributes if each in item):
                value = getattr(getattr(motion, kind)(name), attribute)
                if np.size(item[attribute]) == 3:
                    parts = zip("xyz", np.moveaxis(value, -1, 0), strict=True)
                    found |= {(kind, name, f"{attribute} {axis}"): part for axis, part in parts}
                else:
                    found[kind, name, attribute] = value
    return found


def driven(name: str, values_around: Any) -> dict[str, Any]:
    """Return inputs near the defaults of a mechanism, spread by relative values around 1."""
    inputs = vad.MECHANISMS[name].inputs
    first = next(iter(inputs))
    return {**inputs, first: inputs[first] * np.asarray(values_around)}


# --- what goes in -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "given",
    [
        GOOD,
        list(GOOD),
        tuple(GOOD),
        GOOD.astype(int),
        GOOD.astype(np.int8 if GOOD.max() < 128 else np.int16),
        GOOD.astype(np.uint16),
        GOOD.astype(np.float32),
        GOOD.astype(">f8"),
        np.repeat(GOOD, 3)[::3],
        GOOD[::-1][::-1],
        np.ma.asarray(GOOD).data,
    ],
    ids=str,
)
def test_every_kind_of_numbers_gives_the_same(given: Any) -> None:
    found = rocker(given).angle
    assert found.dtype == np.float64
    assert found.tolist() == WANTED


@pytest.mark.parametrize("given", [20, 20.0, np.float64(20), np.float32(20), np.int32(20)])
def test_one_number_gives_one_number(given: Any) -> None:
    found = rocker(given)
    assert np.ndim(found.angle) == np.ndim(found.omega) == 0
    assert float(found.angle) == rocker(float(given)).angle


def test_integer_rates() -> None:
    assert rocker(20, omega=10, alpha=5).alpha == rocker(20.0, omega=10.0, alpha=5.0).alpha
    wanted = rocker([20.0], omega=[10.0], alpha=[5.0]).alpha
    assert rocker([20], omega=[10], alpha=[5]).alpha == wanted


@pytest.mark.parametrize("shape", [(0,), (0, 3), (1,), (2, 0)])
@pytest.mark.parametrize("name", NAMES)
def test_few_or_none(name: str, shape: tuple[int, ...]) -> None:
    motion = vad.solve(vad.MECHANISMS[name](), **driven(name, np.ones(shape)))
    assert motion.assembled.shape == shape
    for key, value in values(motion, vad.solve(vad.MECHANISMS[name]()).to_dict()).items():
        assert np.shape(value) == shape, key


def test_an_array_without_dimensions_is_one_pose() -> None:
    assert float(rocker(np.array(20.0)).angle) == rocker(20.0).angle
    assert np.shape(rocker(np.array(20.0)).angle) == ()


@pytest.mark.parametrize("order", ["C", "F"])
def test_two_dimensions(order: Any) -> None:
    grid = np.asarray(np.stack([GOOD, GOOD[::-1], GOOD]), order=order)
    assert rocker(grid).angle.tolist() == [WANTED, WANTED[::-1], WANTED]
    assert rocker(grid.T).angle.T.tolist() == [WANTED, WANTED[::-1], WANTED]


def test_long_arrays_equal_their_pieces() -> None:
    angles = np.random.default_rng(1).uniform(-720, 720, 100_003)
    whole = rocker(angles, omega=3.0, alpha=1.0)
    for start, stop in ((0, 1), (5, 900), (31_000, 34_000), (99_990, 100_003)):
        piece = rocker(angles[start:stop], omega=3.0, alpha=1.0)
        assert np.array_equal(whole.angle[start:stop], piece.angle)
        assert np.array_equal(whole.alpha[start:stop], piece.alpha)


def test_angles_and_rates_broadcast() -> None:
    omega = np.array([1.0, 2.0, -3.0])
    found = rocker(GOOD[:, None], omega=omega, alpha=0.5)
    assert found.omega.shape == found.alpha.shape == (5, 3)
    for i, angle in enumerate(GOOD):
        for j, speed in enumerate(omega):
            single = rocker(float(angle), omega=float(speed), alpha=0.5)
            assert found.omega[i, j] == pytest.approx(single.omega, rel=1e-14)
            assert found.alpha[i, j] == pytest.approx(single.alpha, rel=1e-13)


def test_one_angle_and_many_rates() -> None:
    found = rocker(20.0, omega=np.array([1.0, 2.0, 4.0]))
    assert found.omega.shape == (3,)
    assert (found.omega == found.omega[0] * np.array([1, 2, 4])).all()
    motion = vad.solve(vad.FourBar(), angle=20.0, omega=np.array([1.0, 2.0]))
    assert motion.link("crank").angle.tolist() == [20.0, 20.0]
    assert motion.point("B").position.shape == (2,)


@pytest.mark.parametrize("name", NAMES)
def test_broadcasting_reaches_every_result(name: str) -> None:
    _, second, third = vad.MECHANISMS[name].inputs
    inputs = driven(name, np.linspace(0.95, 1.05, 4)[:, None])
    inputs |= {second: np.array([1.0, 2.0, 3.0]), third: 1.0}
    motion = vad.solve(vad.MECHANISMS[name](), **inputs)
    for key, value in values(motion, vad.solve(vad.MECHANISMS[name]()).to_dict()).items():
        assert np.shape(value) == (4, 3), key


# --- what is bad among the good ---------------------------------------------------------------


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name", NAMES)
def test_bad_poses_spoil_no_good_ones(name: str, bad: float) -> None:
    cls, listed = vad.MECHANISMS[name], vad.solve(vad.MECHANISMS[name]()).to_dict()
    spread = np.array([0.98, bad, 1.0, 1.02])
    good = values(vad.solve(cls(), **driven(name, np.delete(spread, 1))), listed)
    motion = vad.solve(cls(), **driven(name, spread))
    assert motion.assembled.tolist() == [True, False, True, True]
    for key, value in values(motion, listed).items():
        axes = np.shape(value)[1:]
        whole = np.broadcast_to(value, (*spread.shape, *axes))
        expected = np.broadcast_to(good[key], (3, *axes))
        assert np.array_equal(np.delete(whole, 1, axis=0), expected, equal_nan=True), key
        assert not np.isinf(whole).any()


@pytest.mark.parametrize("bad", [np.nan, np.inf])
@pytest.mark.parametrize("rate", ["omega", "alpha"])
def test_a_bad_rate_spoils_rates_alone(rate: str, bad: float) -> None:
    motion = vad.solve(vad.FourBar(), angle=GOOD, **{rate: np.array([1, bad, 1, 1, 1])})
    assert motion.link("rocker").angle.tolist() == WANTED
    assert not np.isinf(motion.link("rocker").alpha).any()
    assert np.isnan(motion.link("rocker").alpha).tolist() == [False, True, False, False, False]


def test_poses_out_of_reach_are_nan() -> None:
    motion = vad.solve(vad.FourBar(4, 3, 2, 3), angle=np.array([60.0, 120.0, 80.0]))
    assert motion.assembled.dtype == bool
    assert motion.assembled.tolist() == [True, False, True]
    assert np.isnan(motion.point("C").position).tolist() == [False, True, False]
    assert np.isnan(motion.link("coupler").alpha).tolist() == [False, True, False]


# --- one pose and many ------------------------------------------------------------------------


def same(a: Any, b: Any) -> bool:
    """Tell whether two numbers agree bit for bit; one NaN is like another."""
    a, b = np.asarray(a), np.asarray(b)
    return bool(np.isnan(a) and np.isnan(b)) or a.tobytes() == b.tobytes()


@pytest.mark.parametrize("variant", SAMPLERS)
@pytest.mark.parametrize("family", ["random", "toggle", "near pivot", "unequal"])
def test_one_pose_an_array_of_one_and_a_long_array_agree_bit_for_bit(
    variant: str, family: str
) -> None:
    if not exists(variant, family):
        pytest.skip("no such poses")
    for case, truth in samples(variant, family, 3, seed=7, conditions=False):
        first = next(iter(vad.MECHANISMS[case.name].inputs))
        place = case.inputs[first]
        many = solve(case, **{first: np.array([0.99 * place, place, 1.01 * place, 30.0, place])})
        alone, single = solve(case, **{first: np.array([place])}), solve(case)
        assert single.assembled == alone.assembled[0] == many.assembled[1]
        for key in truth:
            wanted = read(single, key)
            assert same(np.broadcast_to(read(alone, key), 1)[0], wanted), (key, case)
            assert same(np.broadcast_to(read(many, key), 5)[1], wanted), (key, case)
            assert same(np.broadcast_to(read(many, key), 5)[4], wanted), (key, case)


@pytest.mark.parametrize(
    "angle", [180.00000000000003, 540.0, -180.00000000000003, 1e15 + 180, 4e17]
)
def test_angles_are_folded_alike(angle: float) -> None:
    alone = vad.solve(vad.ScotchYoke(), angle=np.array([angle, 7.0])).point("B").position[0]
    assert same(alone, vad.solve(vad.ScotchYoke(), angle=angle).point("B").position)


@pytest.mark.parametrize(
    "given",
    [
        np.ma.masked_array([20.0, 30.0], [False, True]),
        np.array(["2026-01-01"], dtype="datetime64[D]"),
        np.array(["20", "30"]),
        ["20", "30"],
        np.array([20 + 1j]),
        np.array([True, False]),
        [20.0, None],
    ],
    ids=str,
)
def test_what_is_no_number_is_refused_by_name(given: Any) -> None:
    with pytest.raises(
        vad.InputError, match=r"^angle: must (be a number or an array|not be masked)"
    ):
        vad.solve(vad.FourBar(), angle=given)


# --- ownership --------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_results_share_no_memory(name: str) -> None:
    listed = vad.solve(vad.MECHANISMS[name]()).to_dict()
    inputs = driven(name, np.linspace(0.95, 1.05, 6))
    motion = vad.solve(vad.MECHANISMS[name](), **inputs)
    again = vad.solve(vad.MECHANISMS[name](), **inputs)
    first, second = values(motion, listed), values(again, listed)
    given = [value for value in inputs.values() if isinstance(value, np.ndarray)]
    for key, value in first.items():
        for other in (*second.values(), *given):
            assert not np.shares_memory(value, other), key


@pytest.mark.parametrize("name", NAMES)
def test_writing_into_results_changes_no_later_answer(name: str) -> None:
    listed = vad.solve(vad.MECHANISMS[name]()).to_dict()
    inputs = driven(name, np.linspace(0.95, 1.05, 6))
    motion = vad.solve(vad.MECHANISMS[name](), **inputs)
    wanted = {key: np.array(value) for key, value in values(motion, listed).items()}
    for value in values(motion, listed).values():
        value[...] = -1.0
    for mine in (motion, vad.solve(vad.MECHANISMS[name](), **inputs)):
        for key, value in values(mine, listed).items():
            assert np.array_equal(value, wanted[key], equal_nan=True), key


def test_writing_into_the_input_changes_no_later_answer() -> None:
    angles = GOOD.copy()
    motion = vad.solve(vad.FourBar(), angle=angles)
    angles[...] = 0.0
    assert motion.link("rocker").angle.tolist() == WANTED
    assert motion.link("crank").angle.tolist() == GOOD.tolist()


def test_what_is_not_asked_for_cannot_fail() -> None:
    """At a dead centre and with a bad rate, positions answer; without α, velocities do."""
    assert vad.solve(vad.FourBar(4, 3, 2, 3), angle=90).link("rocker").angle > 0
    motion = vad.solve(vad.FourBar(), angle=GOOD, omega=1.0, alpha=np.full(5, np.nan))
    assert motion.link("rocker").angle.tolist() == WANTED
    assert np.isfinite(motion.link("rocker").omega).all()


@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "gate-actuator"])
def test_of_a_pose_that_does_not_close_nothing_is_known(name: str) -> None:
    cls = vad.MECHANISMS[name]
    first = next(iter(cls.inputs))
    mechanism = cls(crank=230.0) if first == "angle" else cls()
    places = [0.0, 90.0] if first == "angle" else [3.8, 9.0]
    motion = vad.solve(mechanism, **{first: places})
    assert motion.assembled.sum() == 1
    for part in (*map(motion.link, motion.links), *map(motion.slide, motion.slides)):
        for value in (
            getattr(part, key, None) for key in ("angle", "position", "omega", "velocity")
        ):
            assert value is None or np.array_equal(np.isnan(value), ~motion.assembled)
    for point in map(motion.point, motion.points):
        for value in (point.position.real, point.position.imag, point.velocity.imag):
            assert np.array_equal(np.isnan(value), ~motion.assembled)
