"""Instantaneous centres: published cases, and what must hold of any of them.

The bodies' motion is taken from velocities, which the centres do not use.
"""

from __future__ import annotations

import json
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vad
from tests.statics.machines import MACHINES
from tests.statics.test_cases import motion
from tests.statics.test_equilibrium import pose, varied
from vad.errors import DeadCentreError, InputError, UsageError, VadError
from vad.kinematics import kennedy
from vad.kinematics.bodies import FRAME
from vad.kinematics.reach import closing_range

CASES = json.loads(Path(__file__).with_name("centres.json").read_text("utf-8"))
BOUND = 2e-12
NAMES = sorted(MACHINES)
#: Of the sum of the speeds that are compared.
CLOSE = 1e-8


@pytest.mark.parametrize(
    "case", [each for each in CASES if each["kind"] == "centres"], ids=lambda each: each["id"]
)
def test_cases(case):
    centres = vad.centres(motion(case))
    for name, value in case["expected"].items():
        pair = name.split()
        if isinstance(value, dict):
            assert centres.at(*pair) is None
            assert centres.far(*pair) == pytest.approx(value["far"], rel=BOUND)
        else:
            assert centres.far(*pair) is None
            place = complex(*value)
            assert abs(centres.at(*pair) - place) <= BOUND * abs(place)
            assert centres.at(*pair[::-1]) == centres.at(*pair)


def speeds(motion, body):
    """Return ω of a body and the velocity of one of its points, with the point."""
    if body == FRAME:
        return 0.0, 0j, 0j
    own = vad.centres(motion).kennedy.bodies.bodies[body]
    point = motion.point(own.joint.point)
    return motion.link(own.link).omega if own.link else 0.0, point.velocity, point.position


def slip(motion, one, other):
    """Return by how much two bodies slip in their centre, over the sum of the speeds there."""
    centres = vad.centres(motion)
    (omega, v, p), (rate, u, q) = (speeds(motion, body) for body in (one, other))
    at, far = centres.at(one, other), centres.far(one, other)
    assert (at is None) is (far is not None)
    if at is None:
        # Both turn alike, and move apart square to where the centre lies.
        way, drift = np.exp(1j * np.radians(far)), v + 1j * omega * (q - p) - u
        size = abs(v) + abs(omega) * abs(q - p) + abs(u)
        return abs((drift * way.conjugate()).real) / size if size else 0.0
    size = abs(v) + abs(omega) * abs(at - p) + abs(u) + abs(rate) * abs(at - q)
    return abs(v + 1j * omega * (at - p) - u - 1j * rate * (at - q)) / size if size else 0.0


def determined(motion):
    """Return the pairs of bodies whose centre is determined in a pose."""
    centres, found = vad.centres(motion), []
    for pair in combinations(centres.bodies, 2):
        try:
            centres.at(*pair)
        except DeadCentreError:
            continue
        found.append(pair)
    return found


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
@settings(max_examples=6, deadline=None)
@given(st.floats(0.02, 0.98), st.integers(0, 10**6))
def test_both_bodies_have_one_velocity_in_their_centre(name, share, seed):
    machine = MACHINES[name]()
    try:
        moved = pose(varied(machine, seed), share)
        pairs = determined(moved)
        slips = {pair: slip(moved, *pair) for pair in pairs}
    except (VadError, IndexError):  # with these lengths it does not close
        return
    assert max(slips.values()) < CLOSE, slips


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("name", NAMES)
def test_all_centres_are_found(name):
    moved = pose(MACHINES[name](), 0.31)
    assert len(determined(moved)) == len(list(combinations(vad.centres(moved).bodies, 2)))


def homogeneous(centres, one, other, size):
    at = centres.at(one, other)
    if at is None:
        way = np.exp(1j * np.radians(centres.far(one, other)))
        return np.array([way.real, way.imag, 0.0])
    found = np.array([at.real / size, at.imag / size, 1.0])
    return found / np.linalg.norm(found)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_three_centres_of_three_bodies_are_in_line(name):
    moved = pose(MACHINES[name](), 0.31)
    centres, size = vad.centres(moved), moved.plane.scale
    for bodies in combinations(centres.bodies, 3):
        three = [homogeneous(centres, *pair, size) for pair in combinations(bodies, 2)]
        assert abs(np.linalg.det(np.array(three))) < 1e-12, bodies


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_ratios_of_omega_agree_with_the_solver(name):
    moved = pose(MACHINES[name](), 0.31)
    centres = vad.centres(moved)
    links = [link for link in moved.links if link in centres.bodies]
    fastest = max(abs(moved.link(link).omega) for link in links)
    for one, other in combinations(links, 2):
        ratio = centres.ratio(one, other)
        rates = [moved.link(link).omega for link in (one, other)]
        if ratio is None:
            pivots = {centres.at(FRAME, link) for link in (one, other)}
            assert min(map(abs, rates)) < 1e-9 * fastest or len(pivots) == 1
        else:
            assert abs(ratio * rates[1] - rates[0]) < 1e-9 * fastest


@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "crank-slotted-lever", "watt-1.toml"])
def test_centrodes_roll(name):
    """Both curves have the same length between two poses, and touch in the centre."""
    machine = MACHINES[name]()
    low, high = closing_range(machine)[0]
    angles = np.linspace(low + 0.2 * (high - low), low + 0.21 * (high - low), 4001)
    moved = vad.solve(machine, angle=angles)
    centres = vad.centres(moved)
    for body in centres.bodies[1:]:
        if centres.kennedy.alike(body, FRAME):
            with pytest.raises(UsageError, match="always far away"):
                centres.centrodes(body)
            continue
        fixed, moving = centres.centrodes(body)
        steps, rolled = np.diff(fixed), np.diff(moving)
        if abs(steps).max() <= 1e-9 * abs(fixed).max():
            continue  # it turns about a fixed point
        assert np.allclose(abs(steps), abs(rolled), rtol=1e-5)
        assert fixed[0] == pytest.approx(moving[0], rel=1e-12)
        assert abs(abs(steps).sum() - abs(rolled).sum()) < 1e-7 * abs(steps).sum()


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_one_pose_and_many_agree(name):
    machine = MACHINES[name]()
    low, high = closing_range(machine)[0]
    place = next(iter(machine.inputs))
    places = low + (high - low) * np.array([0.11, 0.47, 0.83])
    many = vad.centres(vad.solve(machine, **{place: places}))
    for number, each in enumerate(places):
        one = vad.centres(vad.solve(machine, **{place: float(each)}))
        for pair in combinations(one.bodies, 2):
            at, far = many.at(*pair)[number], many.far(*pair)[number]
            try:
                own = one.at(*pair), one.far(*pair)
            except DeadCentreError:
                own = None, None
            assert np.isnan(at) if own[0] is None else at == own[0], pair
            assert np.isnan(far) if own[1] is None else far == own[1]


def test_what_does_not_close_is_nan():
    centres = vad.centres(vad.solve(vad.FourBar(crank=130), angle=np.array([10.0, 60.0])))
    assert np.isnan(centres.at("frame", "coupler")).tolist() == [True, False]
    assert np.isnan(centres.far("frame", "coupler")).all()


def test_parallel_lines_meet_far_away():
    """At 90° the crank and the normal of the guide are parallel: the rod translates."""
    centres = vad.centres(vad.solve(vad.SliderCrank(), angle=90))
    assert centres.at("frame", "rod") is None
    assert centres.far("frame", "rod") == 90.0
    assert centres.ratio("rod", "crank") is None


def test_the_dead_centre_of_the_driver_has_centres():
    """A double slider at its dead centre: its link turns about a point all the same."""
    moved = vad.solve(vad.DoubleSlider(), position=1000.0)
    with pytest.raises(DeadCentreError):
        moved.link("link").omega  # noqa: B018
    assert vad.centres(moved).at("frame", "link") == pytest.approx(1000.0)


def test_a_change_point_is_said():
    """All links in one line: any point of it could be the centre."""
    moved = vad.solve(vad.FourBar(100, 40, 100, 40, assembly="parallel"), angle=0)
    with pytest.raises(DeadCentreError, match="the lines on which it lies coincide") as caught:
        vad.centres(moved).at("frame", "coupler")
    assert caught.value.hint


def test_wrong_bodies():
    centres = vad.centres(vad.solve(vad.FourBar()))
    with pytest.raises(UsageError, match="unknown body 'rod'") as caught:
        centres.at("rod", "crank")
    assert "rocker" in str(caught.value.hint)
    with pytest.raises(UsageError, match="crank has no centre with itself"):
        centres.far("crank", "crank")
    with pytest.raises(InputError, match="hooke-joint moves in space"):
        vad.centres(vad.solve(vad.HookeJoint()))
    with pytest.raises(InputError, match="must be a motion"):
        vad.centres(vad.FourBar())
    with pytest.raises(InputError, match="one pose has a centre, and no curves"):
        centres.centrodes("coupler")


# --- faults that are planted ---------------------------------------------------------------------


def with_parallel_slides(monkeypatch):
    """The centre of a slide lies along the slide."""
    monkeypatch.setattr(kennedy, "across", lambda line: line)


def with_another_line(monkeypatch):
    """A line leads through the centres of a wrong pair."""
    right = kennedy.Kennedy.pair

    def wrong(self, one, other):
        found = right(self, one, other)
        return (self.names[0], self.names[2]) if found == (self.names[0], self.names[1]) else found

    monkeypatch.setattr(kennedy.Kennedy, "pair", wrong)


@pytest.mark.parametrize("plant", [with_parallel_slides, with_another_line])
def test_planted_faults_are_noticed(plant, monkeypatch):
    moved = pose(vad.SliderCrank(), 0.31)
    pairs = [("frame", "rod"), ("crank", "slider")]
    kennedy.kennedy_of.cache_clear()
    assert all(slip(moved, *pair) < CLOSE for pair in pairs)
    kennedy.kennedy_of.cache_clear()
    plant(monkeypatch)
    moved = pose(vad.SliderCrank(rod=141), 0.31)
    try:
        noticed = not all(slip(moved, *pair) < CLOSE for pair in pairs)
    except DeadCentreError:  # wrong lines coincide
        noticed = True
    kennedy.kennedy_of.cache_clear()
    assert noticed
