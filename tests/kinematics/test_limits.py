"""At the ends: of the range of doubles, of what closes, and where results must be exact."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from mpmath import mp

import vad
from tests.kinds import PLANE, SPACE
from tests.kinematics.test_traps import crank
from vad.files.examples import example_path
from vad.kinematics.reach import closing_range, slide_travels


@pytest.mark.filterwarnings("error")
def test_what_leaves_the_range_is_nan_in_arrays_and_an_error_for_one_pose() -> None:
    mechanism = vad.FourBar(4e170, 1e170, 4e170, 2e170)
    motion = crank(mechanism, np.array([60.0]), 1e60, 1e60)
    yoke = vad.ScotchYoke(1e200)
    assert np.isnan(crank(yoke, np.array([60.0]), 1e60).slide("yoke").acceleration)
    assert np.isfinite(motion.point("C").acceleration).all()
    with pytest.raises(vad.InputError):
        crank(yoke, 60.0, 1e60).slide("yoke").acceleration  # noqa: B018


@pytest.mark.parametrize("name", PLANE)
def test_one_pose_gives_plain_numbers(name: str) -> None:
    cls = vad.MECHANISMS[name]
    inputs = {key: np.float64(value) for key, value in cls.inputs.items()}
    motion = vad.solve(cls(), **inputs)
    turning = [name for name in motion.links if name not in motion.solver.bodies]
    for part in (*map(motion.link, turning), *map(motion.slide, motion.slides)):
        names = ("angle", "omega", "alpha", "position", "velocity", "acceleration", "coriolis")
        found = {getattr(part, attribute, None) for attribute in names} - {None}
        assert {type(value) for value in found} == {float}
    for point in map(motion.point, motion.points):
        for value in (point.position, point.velocity, point.acceleration):
            assert type(value) is complex if name in PLANE else value.shape == (3,)


@pytest.mark.parametrize("name", SPACE)
def test_one_pose_in_space_gives_plain_numbers_and_vectors(name: str) -> None:
    cls = SPACE[name]
    motion: Any = vad.solve(cls(), **{k: np.float64(value) for k, value in cls.inputs.items()})
    for part in (*map(motion.joint, motion.joints), motion.link(motion.solver.driver.name)):
        assert {type(value) for value in (part.angle, part.omega, part.alpha)} == {float}
    for point in map(motion.point, motion.points):
        for value in (point.position, point.velocity, point.acceleration):
            assert (value.dtype, value.shape) == (np.float64, (3,))


# --- where they close -------------------------------------------------------------------------


def test_a_strut_of_negative_length_closes_nowhere() -> None:
    gate = vad.GateActuator(3, 5, ground_angle=0)
    with pytest.raises(vad.AssemblyError):
        vad.solve(gate, position=-3).point("B").position  # noqa: B018
    assert vad.solve(gate, position=[-3.0, 3.0]).assembled.tolist() == [False, True]


def test_a_strut_without_length_points_nowhere() -> None:
    gate = vad.GateActuator(5, 5, ground_angle=0)
    motion = vad.solve(gate, position=0)
    assert motion.point("B").position == 5
    with pytest.raises(vad.DeadCentreError):
        motion.link("actuator").angle  # noqa: B018
    several = vad.solve(gate, position=[0.0, 5.0])
    assert several.assembled.tolist() == [True, True]
    assert np.isnan(several.link("arm").omega).tolist() == [True, False]


@pytest.mark.parametrize(
    ("mechanism", "ranges"),
    [
        (vad.GateActuator(3, 5, ground_angle=0), [(2, 8)]),
        (vad.GateActuator(3, 1e-6), [(3 - 1e-6, 3 + 1e-6)]),
        (vad.DoubleSlider(1, 0, 30), [(-2, 2)]),
        (vad.DoubleSlider(1, 20, 110), [(-1, 1)]),
        (vad.FourBar(4, 1, 1, 1), []),
        (vad.FourBar(4, 3, 2, 3), [(-90, 90)]),
        (vad.SliderCrank(4, 1, -3), [(210, 330)]),
    ],
    ids=str,
)
def test_the_closing_range(mechanism: Any, ranges: list[tuple[float, float]]) -> None:
    found = closing_range(mechanism)
    assert len(found) == len(ranges)
    for interval, wanted in zip(found, ranges, strict=True):
        assert interval == pytest.approx(wanted, rel=1e-9)


# --- what must be exact -----------------------------------------------------------------------


@pytest.mark.parametrize("ground_angle", [-90.0, 12.3, -83.9])
def test_points_move_as_what_carries_them(ground_angle: float) -> None:
    """A ram has its slide's motion along y = const; the pin's place knows nothing of the ground."""
    ram = crank(vad.Whitworth(rod=200, ram_height=7, ground_angle=ground_angle), 33.3, 3.0, 2.0)
    point, slide = ram.point("E"), ram.slide("ram")
    assert point.position == complex(slide.position, 7)
    assert point.velocity == complex(slide.velocity)
    assert point.acceleration == complex(slide.acceleration)
    assert ram.point("B").position == crank(vad.ScotchYoke(90), 33.3).point("B").position


def test_a_tiny_ground_does_not_hide_the_rates_against_the_crank() -> None:
    """With α₂ = 0 the lever's α is all relative to the crank: of the order of the ground."""
    motion = crank(vad.Whitworth(ground=1e-8, crank=1.0, ground_angle=0), 90.0, 1.0)
    assert motion.link("lever").alpha == pytest.approx(-1e-8, rel=1e-15)
    assert motion.slide("block").velocity == pytest.approx(1e-8, rel=1e-15)


@pytest.mark.parametrize(
    "mechanism",
    [
        vad.FourBar(crank=1e-199, rocker=1e140),
        vad.FourBar(ground=1e-199, rocker=1e140),
        vad.SliderCrank(crank=1e-199, rod=1.0, offset=1e140),
        vad.Whitworth(ground=1.0, crank=1e199, arm=1.0, rod=1e-199),
        vad.load(example_path("offset-lever"))(lever=1e199),
    ],
    ids=str,
)
def test_links_that_are_nothing_beside_others_close_nowhere(mechanism: Any) -> None:
    with pytest.raises(vad.AssemblyError, match="close at no angle"):
        vad.solve(mechanism).point("C").position  # noqa: B018
    assert closing_range(mechanism) == []


@pytest.mark.parametrize("length", [1e201, 1e-201, float("inf"), float("nan"), 0.0, -3.0])
def test_lengths_beyond_the_range_are_refused_by_name(length: float) -> None:
    with pytest.raises(vad.InputError, match=r"^crank: must be"):
        vad.FourBar(crank=length)


@pytest.mark.parametrize(
    ("mechanism", "place", "words", "works"),
    [
        (vad.FourBar(crank=130), 10.0, "13.3254° … 120.255° and 239.745° … 346.675°", 15.46),
        (vad.FourBar(crank=300), 60.0, "they close for angle 0°", 0.0),
        (vad.GateActuator(), 9.0, "3.20018 ft … 4.57302 ft", 4.546),
    ],
)
def test_an_open_loop_says_by_how_much_and_where_it_would_close(
    mechanism: Any, place: float, words: str, works: float
) -> None:
    first = next(iter(mechanism.inputs))
    with pytest.raises(vad.AssemblyError, match="the links miss by") as caught:
        vad.solve(mechanism, **{first: place}).point("B").position  # noqa: B018
    assert words in str(caught.value)
    assert caught.value.hint == f"try {first} {works:g}"
    assert vad.solve(mechanism, **{first: works}).assembled


@pytest.mark.parametrize(
    ("mechanism", "place"),
    [
        (vad.SliderCrank(2, 4, 5.99999999), 0.0),
        (vad.FourBar(100, 1, 50, 49.0000001, ground_angle=0.05), 180.0),
        (vad.DoubleSlider(1e-6), 5.0),
        (vad.GateActuator(3, 1e-6), 9.0),
        (vad.FourBar(crank=300), 60.0),
        (vad.FourBar(4, 3, 2, 3), 120.0),
    ],
)
def test_the_hint_always_works(mechanism: Any, place: float) -> None:
    first = next(iter(mechanism.inputs))
    with pytest.raises(vad.AssemblyError) as caught:
        vad.solve(mechanism, **{first: place}).point("B").position  # noqa: B018
    assert caught.value.hint is not None
    works = float(caught.value.hint.rsplit(" ", 1)[1])
    assert vad.solve(mechanism, **{first: works}).assembled


def lever(reach: float, highest: bool) -> tuple[Any, list[float]]:
    """Return a lever whose ram closes by ``reach`` where its tip is highest or lowest, and where.

    The lever stands upright with the crank; or it is at the end of its swing, across the crank.
    """
    ground, crank, tip, rod = 120.0, 50.0, 250.0, 10.0
    upright, swing = tip - ground, tip * math.sqrt(1 - (crank / ground) ** 2) - ground
    height = upright + rod - reach if highest else swing - rod + reach
    across = math.degrees(math.asin(crank / ground))
    where = [90.0, 270.0] if highest else [180.0 + across, 360.0 - across]
    return vad.CrankSlottedLever(ground, crank, tip, rod=rod, ram_height=height), where


@pytest.mark.parametrize("reach", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("highest", [True, False])
def test_no_range_of_a_ram_is_too_narrow_to_be_found(reach: float, highest: bool) -> None:
    mechanism, where = lever(reach, highest)
    ranges = closing_range(mechanism)
    assert len(ranges) == 2
    for (low, high), middle in zip(ranges, where, strict=True):
        assert low < middle < high < low + 80 * math.sqrt(reach)
        assert vad.solve(mechanism, angle=[low, high]).assembled.all()
        assert not vad.solve(mechanism, angle=[low - 1e-6, high + 1e-6]).assembled.any()
    with pytest.raises(vad.AssemblyError) as caught:
        vad.solve(mechanism, angle=0.0).point("E").position  # noqa: B018
    works = float(str(caught.value.hint).rsplit(" ", 1)[1])
    assert vad.solve(mechanism, angle=works).assembled


def test_no_gap_of_a_ram_is_too_narrow_to_be_found() -> None:
    """The rod is a hundred-millionth too short where the lever is at the ends of its swing."""
    swing = 250 * math.sqrt(1 - (50 / 120) ** 2) - 120
    mechanism = vad.CrankSlottedLever(120, 50, 250, rod=140 - swing - 1e-8, ram_height=140.0)
    (_, first), (second, third) = closing_range(mechanism)
    across = math.degrees(math.asin(50 / 120))
    assert first < 180 + across < second < first + 0.01
    assert third < 360 - across < third + 0.01


def test_a_narrow_range_is_exact() -> None:
    """sin θ = (h − rod)/crank, to the last digits however narrow the range."""
    with mp.workdps(40):
        sine = (mp.mpf(5.99999999) - 4) / 2
        wanted = float(mp.asin(sine) * 180 / mp.pi)
    [(low, high)] = closing_range(vad.SliderCrank(2, 4, 5.99999999))
    assert low == pytest.approx(wanted, abs=3e-14)
    assert high == pytest.approx(180 - wanted, abs=3e-14)


@pytest.mark.parametrize(
    ("mechanism", "slide", "ends"),
    [
        (vad.ScotchYoke(crank=30), "block", (-30.0, 30.0)),
        (vad.SliderCrank(crank=60, rod=140), "slider", (80.0, 200.0)),
        (vad.SliderCrank(crank=60, rod=140, assembly="crossed"), "slider", (-200.0, -80.0)),
        (vad.Whitworth(ground=40, crank=90), "block", (50.0, 130.0)),
        (vad.GateActuator(ground=1.0, arm=4.0), "actuator", (3.0, 5.0)),
        (vad.DoubleSlider(link=10), "slider_b", (0.0, 10.0)),
    ],
)
def test_how_far_slides_get(mechanism: Any, slide: str, ends: tuple[float, float]) -> None:
    assert slide_travels(mechanism)[slide] == pytest.approx(ends, abs=1e-9)


def test_a_slot_beside_its_pivot_closes_in_the_narrowest_range():
    """The pin is never as far from the pivot D as the slot is beside it, but for two moments."""
    ground, crank, aside, way = 100.0, 40.0, 139.9999999, -72.345
    kind = vad.mechanism(
        fixed={"A": [0, 0], "D": {"from": "A", "length": ground, "angle": way}},
        links={"crank": {"AB": crank}, "lever": {"DC": 200}},
        guides={"B": {"along": "DC", "offset": aside}},
        driver={"crank": {"angle": way + 180.0, "omega": 10}},
    )
    ((low, high),) = closing_range(kind())
    square = (ground + crank) ** 2 - aside**2
    half = math.degrees(2.0 * math.asin(math.sqrt(square / (4.0 * ground * crank))))
    assert (low + high) / 2.0 == pytest.approx(way + 180.0, abs=1e-9)
    assert (high - low) / 2.0 == pytest.approx(half, rel=1e-6)
