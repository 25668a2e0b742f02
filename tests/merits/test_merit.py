"""Figures of merit: against textbooks, fifty digits, and the poses themselves."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

import vad
from tests.kinds import KINDS
from vad.merits.grashof import kind_of

lengths = st.floats(0.2, 10.0)


# --- by hand --------------------------------------------------------------------------------


def test_a_crank_and_slotted_lever_by_hand():
    """The lever leans by the angle whose sine is crank over ground, 30°: 240° against 120°."""
    lever = vad.CrankSlottedLever(ground=240, crank=120, lever=450, rod=300, ram_height=150)
    found = vad.merit(lever)
    assert found["time_ratio"] == pytest.approx(2.0, rel=1e-13)
    assert found["forward_angle"] == pytest.approx(240.0, rel=1e-13)
    assert found["stroke"] == pytest.approx(450.0, rel=1e-13)
    assert vad.merit(lever, output="lever")["stroke"] == pytest.approx(60.0, rel=1e-13)


def test_a_whitworth_quick_return_by_hand():
    """The return takes twice the angle whose cosine is ground over crank: 96.38°."""
    back = 2.0 * math.degrees(math.acos(50.0 / 75.0))
    found = vad.merit(vad.Whitworth(ground=50, crank=75, arm=60, rod=135))
    assert found["time_ratio"] == pytest.approx((360.0 - back) / back, rel=1e-12)
    assert found["return_angle"] == pytest.approx(back, rel=1e-12)
    assert found["stroke"] == pytest.approx(120.0, rel=1e-13)
    assert vad.merit(vad.Whitworth())["stroke"] is None


def test_a_double_crank_has_no_stroke():
    """The ground is the shortest link, and both others turn: the drag link."""
    found = vad.merit(vad.FourBar(ground=20, crank=50, coupler=45, rocker=60))
    assert found["grashof"] == "double-crank"
    assert found["stroke"] is None
    assert found["time_ratio"] is None


@pytest.mark.parametrize(
    ("sides", "kind"),
    [
        ((100, 40, 120, 80), "crank-rocker"),
        ((40, 100, 80, 120), "double-crank"),
        ((100, 80, 40, 120), "double-rocker"),
        ((100, 120, 80, 40), "rocker-crank"),
        ((100, 90, 110, 200), "triple-rocker"),
        ((100, 40, 100, 40), "change point"),
        ((0.3, 0.1, 0.4, 0.2), "change point"),
        ((1e-3, 1e3, 1e3, 1.5e-3), "double-crank"),
    ],
)
def test_kinds_of_four_bars(sides, kind):
    assert vad.merit(vad.FourBar(*sides))["grashof"] == kind


def test_grashof_is_for_four_bars():
    assert vad.merit(vad.SliderCrank())["grashof"] is None
    assert vad.merit(vad.HookeJoint())["grashof"] is None


@given(lengths, lengths, lengths, lengths)
@settings(max_examples=12, deadline=None)
def test_grashof_says_what_the_ranges_say(ground, crank, coupler, rocker):
    """The crank turns fully in a crank-rocker and a double-crank, and in no other."""
    kind = kind_of(ground=ground, crank=crank, coupler=coupler, rocker=rocker)
    ordered = sorted([ground, crank, coupler, rocker])
    assume(abs(ordered[0] + ordered[3] - ordered[1] - ordered[2]) > 1e-6)
    found = vad.merit(vad.FourBar(ground, crank, coupler, rocker))
    turns = found["ranges"] == [[0.0, 360.0]]
    assert turns == (kind in ("crank-rocker", "double-crank"))
    assert bool(found["dead_centres"]) != turns or found["ranges"] == []


# --- closed forms and fifty digits --------------------------------------------------------------


@given(st.floats(0.05, 0.6), st.integers(-35, 35).map(lambda share: 0.01 * share))
@settings(max_examples=8, deadline=None)
def test_the_stroke_of_an_offset_slider_crank(crank, offset):
    """Both ends have crank and rod in line."""
    found = vad.merit(vad.SliderCrank(crank, 1.0, offset))
    with mp.workdps(50):
        outer, inner, e = mpf(1) + mpf(crank), mpf(1) - mpf(crank), mpf(offset)
        stroke = mp.sqrt(outer**2 - e**2) - mp.sqrt(inner**2 - e**2)
        lead = abs(mp.asin(e / inner) - mp.asin(e / outer)) * 180 / mp.pi
        ratio = (180 + lead) / (180 - lead)
    assert found["stroke"] == pytest.approx(float(stroke), rel=1e-14)
    assert found["return_angle"] == pytest.approx(float(180 - lead), rel=1e-13)
    assert found["time_ratio"] == pytest.approx(float(ratio), rel=1e-13)


def crank_rockers():
    return st.tuples(lengths, lengths, lengths, lengths).filter(
        lambda sides: (
            kind_of(ground=sides[0], crank=sides[1], coupler=sides[2], rocker=sides[3])
            == "crank-rocker"
            and 2 * (max(sides) + min(sides)) < 0.98 * sum(sides)
        )
    )


@given(crank_rockers(), st.floats(-180.0, 180.0), st.sampled_from(["open", "crossed"]))
@settings(max_examples=8, deadline=None)
def test_swing_and_transmission_of_a_crank_rocker(sides, ground_angle, assembly):
    """By the law of cosines, with crank and coupler, and crank and ground, in line."""
    mechanism = vad.FourBar(*sides, ground_angle=ground_angle, assembly=assembly)
    found = vad.merit(mechanism)
    with mp.workdps(50):
        d, a, b, c = map(mpf, sides)

        def angle(opposite, one, other):
            cosine = (one**2 + other**2 - opposite**2) / (2 * one * other)
            return mp.acos(cosine) * 180 / mp.pi

        swing = abs(angle(b + a, d, c) - angle(b - a, d, c))
        lead = abs(angle(c, d, b + a) - angle(c, d, b - a))
        least, largest = angle(d - a, b, c), angle(d + a, b, c)
    assert found["stroke"] == pytest.approx(float(swing), rel=1e-11)
    assert found["forward_angle"] == pytest.approx(float(180 + lead), rel=1e-11)
    transmission = found["transmission"]
    assert transmission["least"] == pytest.approx(float(least), rel=1e-12)
    assert transmission["largest"] == pytest.approx(float(largest), rel=1e-12)
    turned = (transmission["least_at"] - ground_angle) % 360.0
    assert min(turned, 360.0 - turned) < 1e-11


def test_the_fastest_piston_to_fifty_digits():
    """The root of the acceleration of a slider-crank: rod 140, crank 60."""
    with mp.workdps(50):

        def position(t):
            return 60 * mp.cos(t) + mp.sqrt(mpf(140) ** 2 - (60 * mp.sin(t)) ** 2)

        root = mp.findroot(lambda t: mp.diff(position, t, 2), mpf("1.2"))
        place, speed = float(root * 180 / mp.pi), float(mp.diff(position, root) * 10)
    most = vad.merit(vad.SliderCrank())["extremes"]["slider.velocity"]
    assert most["least_at"] == pytest.approx(place, rel=1e-14)
    assert most["least"] == pytest.approx(speed, rel=1e-15)
    assert most["largest"] == pytest.approx(-speed, rel=1e-15)


def test_a_narrow_peak_is_found():
    """Near a change point ω of the rocker has a peak that is narrower than a degree."""
    mechanism = vad.FourBar(100, 40, 100.0005, 40.001)
    fine = vad.solve(mechanism, angle=np.linspace(0.0, 360.0, 200_001))
    most = vad.merit(mechanism)["extremes"]["rocker.omega"]
    swept = np.nanmax(fine.link("rocker").omega)
    assert most["largest"] >= swept
    assert most["largest"] == pytest.approx(swept, rel=1e-3)


# --- invariants ---------------------------------------------------------------------------------


@pytest.mark.exhaustive(24)
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_no_pose_is_beyond_the_extremes(kind):
    mechanism = kind()
    found = vad.merit(mechanism)
    driven = next(iter(mechanism.inputs))
    low, high = found["ranges"][0]
    places = np.linspace(low, high, 97)[1:-1]
    many = vad.solve(mechanism, **{driven: places})
    for name, (_, part, quantity) in list(many.results.items())[:8]:
        if name not in found["extremes"] or quantity == "angle":
            continue
        most = found["extremes"][name]
        values = np.asarray(many.read(many.results[name]))
        values = np.abs(values) if np.iscomplexobj(values) else values
        if values.ndim > 1:
            values = np.linalg.norm(values, axis=-1)
        scale = 1e-12 * np.nanmax(np.abs(values), initial=0.0)
        assert most["largest"] is None or np.nanmax(values) <= most["largest"] + scale, name
        assert most["least"] is None or np.nanmin(values) >= most["least"] - scale, name
        place = most["largest_at"]
        if most["largest"] is None or quantity not in ("omega", "alpha"):
            continue
        if (
            min(place - low, high - place) > 1e-9
        ):  # at a dead centre a rate may have a limit, but no value
            there = np.asarray(vad.solve(mechanism, **{driven: place}).read(many.results[name]))
            largest = np.linalg.norm(there) if there.ndim else there
            assert largest == pytest.approx(most["largest"], rel=1e-9, abs=scale), (name, part)


@pytest.mark.parametrize("gap", [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-11])
def test_rates_have_no_bound_at_dead_centres_beside_a_change_point(gap):
    """The chain would fold flat at 0° if its rocker were longer by the gap."""
    mechanism = vad.FourBar(ground=100, crank=40, coupler=120, rocker=60 - gap)
    found = vad.merit(mechanism)
    (low, high), most = found["ranges"][0], found["extremes"]["rocker.omega"]
    assert 0.0 < low < 1.5 and high == pytest.approx(360.0 - low)
    assert (most["least"], most["largest"]) == (None, None)
    assert {most["least_at"], most["largest_at"]} == {low, high}
    beside = vad.solve(mechanism, angle=low + (high - low) * 1e-13).link("rocker").omega
    assert abs(beside) > 1e3


@pytest.mark.parametrize("gap", [1e-2, 1e-5, 1e-8, 1e-11])
def test_no_rate_beside_a_change_point_is_beyond_the_extremes(gap):
    """The chain does not fold flat, but nearly does: its rates have narrow peaks beside 0°."""
    mechanism = vad.FourBar(ground=100, crank=40, coupler=120, rocker=60 + gap)
    near = np.geomspace(1e-12, 1.0, 4001)
    many = vad.solve(mechanism, angle=np.concatenate([-near, near]))
    for name in ("rocker.omega", "rocker.alpha", "coupler.omega"):
        values, most = many.read(many.results[name]), vad.merit(mechanism)["extremes"][name]
        room = 1e-9 * np.abs(values).max()
        assert most["least"] - room <= values.min()
        assert values.max() <= most["largest"] + room


def test_rates_grow_beyond_all_bounds_at_a_dead_centre():
    found = vad.merit(vad.FourBar(crank=130))
    assert found["extremes"]["rocker.omega"]["largest"] is None
    assert found["dead_centres"] == pytest.approx(
        [13.3253677, 120.2547874, 239.7452126, 346.6746323]
    )
    angle = found["extremes"]["rocker.angle"]
    assert angle["least"] is not None
    assert 0.0 <= angle["least"] < 360.0


def test_dead_centres_without_a_range_that_ends():
    assert vad.merit(vad.FourBar(100, 40, 100, 40))["dead_centres"] == [0.0, 180.0]
    assert vad.merit(vad.FourBar(100, 40, 100, 40, assembly="parallel"))["dead_centres"] == []
    assert vad.merit(vad.Whitworth(60, 60, 50))["dead_centres"] == [270.0]
    assert vad.merit(vad.DoubleSlider())["dead_centres"] == [-1000.0, 1000.0]


def test_what_closes_nowhere_has_no_figures():
    found = vad.merit(vad.FourBar(1000, 40, 120, 80))
    assert found["ranges"] == []
    assert found["stroke"] is None
    assert found["transmission"] is None
    assert found["extremes"]["rocker.omega"] is None


def test_the_advantage_is_that_of_virtual_work():
    """Couple over couple is ω over ω, force over force velocity over velocity."""
    motion = vad.solve(vad.FourBar(), angle=60)
    found = vad.merit(motion, loads=["6 N m on rocker"])
    assert found["advantage"] == pytest.approx(10.0 / motion.link("rocker").omega, rel=1e-12)
    piston = vad.solve(vad.SliderCrank(), angle=60)
    found = vad.merit(piston, loads=["2 kN @ 180 at C"])
    expected = 600.0 / abs(piston.slide("slider").velocity)
    assert found["advantage"] == pytest.approx(expected, rel=1e-12)
    assert vad.merit(piston)["advantage"] is None
    two = ["2 kN @ 180 at C", "1 N m on rod"]
    assert vad.merit(piston, loads=two)["advantage"] is None
    dead = vad.merit(vad.SliderCrank(), angle=0, loads=["2 kN @ 180 at C"])
    assert dead["advantage"] is None or dead["advantage"] > 1e12


def test_it_is_a_mapping_that_json_holds():
    found = vad.merit(vad.FourBar(), pins={"B": 50})
    assert set(found) == {
        *("output", "grashof", "ranges", "dead_centres", "stroke", "time_ratio", "forward_angle"),
        *("return_angle", "transmission", "extremes", "advantage", "rubbing", "slowest"),
    }
    assert len(found) == len(list(found))
    assert json.loads(json.dumps(found.to_dict(["C.velocity"])))["extremes"].keys() == {
        "rocker.angle",
        "rocker.omega",
        "rocker.alpha",
        "C.velocity",
    }
    assert all(math.isfinite(x) for x in (found["stroke"], found["time_ratio"]))


def test_wrong_names_are_answered_with_the_nearest():
    found = vad.merit(vad.FourBar())
    with pytest.raises(vad.UsageError, match="unknown figure 'strok'") as wrong:
        found["strok"]
    assert "stroke" in wrong.value.hint
    with pytest.raises(vad.UsageError, match=r"unknown result 'rocker\.omga'"):
        found["extremes"]["rocker.omga"]
    with pytest.raises(vad.UsageError, match="unknown output 'ram'"):
        vad.merit(vad.FourBar(), output="ram")
    with pytest.raises(vad.InputError, match="the pose must be one"):
        vad.merit(vad.FourBar(), angle=[0.0, 1.0])
    with pytest.raises(vad.InputError, match="must be a mechanism"):
        vad.merit("four-bar")


def test_in_space_what_makes_sense_is_there():
    found = vad.merit(vad.SphericalFourBar())
    assert found["output"] == "rocker"
    assert found["stroke"] > 0.0
    assert found["transmission"] is None
    assert found["slowest"] is None
    assert found["extremes"]["coupler.omega"]["least"] > 0.0
    joint = vad.merit(vad.HookeJoint(shaft_angle=30))["extremes"]["driven.omega"]
    assert joint["largest"] == pytest.approx(10.0 / math.cos(math.pi / 6), rel=1e-14)
    assert joint["least"] == pytest.approx(10.0 * math.cos(math.pi / 6), rel=1e-14)


def test_the_places_of_a_crank_that_turns_to_and_fro_are_angles_from_0_to_360():
    """Its range is written from -151° to 151°, and rounding makes -3·10⁻¹⁴° of the place 0."""
    rocker = vad.FourBar(ground=100, crank=26.6, coupler=91.63, rocker=32.3)
    most = vad.merit(rocker)["transmission"]
    assert most["least_at"] == 0.0
    assert most["largest_at"] == pytest.approx(209.042, abs=1e-3)
