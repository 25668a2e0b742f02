"""Motions in space as they are asked: lazily, in arrays, at their limits, in words and as data."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

import vad
from tests.kinds import SPACE
from vad.cli.run import run
from vad.kinematics.any_solver import OFTEN
from vad.kinematics.motion import MotionInSpace
from vad.kinematics.reach import closing_range
from vad.kinematics.solver import solver_of

SWINGING: dict[str, vad.Mechanism] = {
    "spherical-four-bar": vad.SphericalFourBar(crank=75.0),
    "spatial-four-bar": vad.SpatialFourBar(crank_twist=72.0, assembly="crossed"),
    "rssr": vad.RSSR(crank=600.0),
}
ALL = [*(kind() for kind in SPACE.values()), *SWINGING.values()]
each = pytest.mark.parametrize("mechanism", ALL, ids=lambda m: f"{m.name}-{m.parameters()}"[:40])


def readings(motion: Any) -> list[Any]:
    """Return every result of a motion; NaN for what one pose does not have."""
    found = []
    turning, moving = ("angle", "omega", "alpha"), ("position", "velocity", "acceleration")
    parts = [(motion.link, name, turning[name in motion.solver.bodies :]) for name in motion.links]
    parts += [(motion.joint, letter, turning) for letter in motion.joints]
    parts += [(motion.slide, name, moving) for name in motion.slides]
    parts += [(motion.point, letter, moving) for letter in motion.points]
    for part, name, quantities in parts:
        for quantity in quantities:
            try:
                found.append(getattr(part(name), quantity))
            except (vad.AssemblyError, vad.DeadCentreError):
                found.append(np.full(3, math.nan)[: 3 if part == motion.point else None])
    return found


@each
def test_an_array_holds_the_bits_of_its_poses(mechanism: vad.Mechanism) -> None:
    angles, seconds = np.linspace(-400.0, 400.0, 9), np.linspace(-1.0, 1.0, 9)
    many: Any = vad.solve(mechanism, angle=angles, omega=3.0, alpha=seconds)
    arrays = readings(many)
    for number in range(len(angles)):
        one = vad.solve(mechanism, angle=angles[number], omega=3.0, alpha=seconds[number])
        assert one.assembled == many.assembled[number]
        for array, alone in zip(arrays, readings(one), strict=True):
            assert array.dtype == np.float64
            if np.isnan(alone).any():
                assert np.isnan(array[number]).all()
            else:
                assert (array[number] == alone).all()


def test_results_asked_for_often_keep_their_bits() -> None:
    for mechanism in ALL:
        first = vad.solve(mechanism, angle=17.0).point("C" if "C" in mechanism.letters else "Q")
        wanted = first.acceleration
        for _ in range(OFTEN + 2):
            assert (first.acceleration == wanted).all()


def test_vectors_stand_on_the_last_axis() -> None:
    motion = vad.solve(vad.RSSR(), angle=np.zeros((2, 5)), omega=np.ones((5,)))
    assert motion.point("C").velocity.shape == motion.link("coupler").omega.shape == (2, 5, 3)
    assert motion.link("rocker").omega.shape == (2, 5)


def test_out_of_reach_is_nan_and_nothing_else(recwarn: Any) -> None:
    for mechanism in SWINGING.values():
        motion: Any = vad.solve(mechanism, angle=np.linspace(0.0, 360.0, 721))
        assert 0 < motion.assembled.sum() < 721
        for array in readings(motion):
            assert np.isnan(array[~motion.assembled]).all()
            assert np.isfinite(array[motion.assembled]).all()
    assert not recwarn


@each
def test_a_position_costs_no_velocity(mechanism: vad.Mechanism, monkeypatch: Any) -> None:
    solver_of.cache_clear()  # what other tests have recorded is played without being asked
    solver, asked = solver_of(mechanism), []
    found = type(solver).rates

    def counted(self: Any, pose: Any, lower: Any, value: Any) -> Any:
        asked.append(len(lower))
        return found(self, pose, lower, value)

    monkeypatch.setattr(type(solver), "rates", counted)
    motion: Any = vad.solve(mechanism, angle=20.0)
    for letter in motion.points:
        motion.point(letter).position  # noqa: B018
    assert motion.assembled and not asked
    for letter in motion.points:
        motion.point(letter).velocity  # noqa: B018
    assert asked == [0]
    motion.to_dict()
    assert asked == [0, 1]


@pytest.mark.parametrize("name", ["spherical-four-bar", "spatial-four-bar"])
def test_limits_are_right_to_the_last_digits(name: str) -> None:
    mechanism = SWINGING[name]
    (low, high), *_ = closing_range(mechanism)
    for limit, inward in ((low, 1e-12), (high, -1e-12)):
        assert vad.solve(mechanism, angle=limit).assembled
        assert vad.solve(mechanism, angle=limit + inward * abs(limit)).assembled
        assert not vad.solve(mechanism, angle=limit - inward * abs(limit)).assembled


def test_what_the_search_finds_of_balls() -> None:
    """Where the rocker's circle touches the coupler's: by the sign of the gap itself."""
    mechanism = vad.RSSR(crank=600.0)
    ranges = closing_range(mechanism)
    assert len(ranges) == 2
    for end in (end for pair in ranges for end in pair):
        beside = [vad.solve(mechanism, angle=end + by).assembled for by in (-1e-9, 1e-9)]
        assert sorted(beside) == [False, True]


def test_a_pose_that_does_not_close_says_so() -> None:
    sphere = vad.solve(vad.SphericalFourBar(crank=75.0), angle=180.0)
    message = "angle 180°: the links miss by 15° of arc; they close for angle -"
    with pytest.raises(vad.AssemblyError, match=message) as caught:
        sphere.link("rocker").angle  # noqa: B018
    assert str(caught.value.hint).startswith("try angle ")
    balls = vad.solve(vad.RSSR(crank=600.0), angle=100.0)
    with pytest.raises(vad.AssemblyError, match=r"miss by 221\.3 mm; they close for angle -70\.4"):
        balls.point("C").position  # noqa: B018
    never = vad.solve(vad.SphericalFourBar(170.0, 5.0, 5.0, 5.0))
    with pytest.raises(vad.AssemblyError, match="with these lengths they close at no angle"):
        never.link("rocker").angle  # noqa: B018


def test_a_dead_centre_has_a_position_and_no_rates() -> None:
    sphere = vad.SphericalFourBar(60.0, 70.0, 55.0, 45.0)  # as 70 - 60 = 55 - 45
    motion = vad.solve(sphere, angle=0.0)
    assert motion.assembled and math.isfinite(motion.link("rocker").angle)
    with pytest.raises(vad.DeadCentreError, match="B, C and D lie on one great circle"):
        motion.link("rocker").omega  # noqa: B018
    many = vad.solve(sphere, angle=np.array([0.0, 1.0]))
    assert many.assembled.all()
    assert np.isnan(many.link("rocker").omega).tolist() == [True, False]
    spatial = vad.SpatialFourBar(crank_twist=70.0)
    with pytest.raises(vad.DeadCentreError, match="at B, C and D are parallel to one plane"):
        vad.solve(spatial, angle=0.0).slide("slide_d").position  # noqa: B018


@pytest.mark.parametrize(
    ("kind", "wrong", "message", "hint"),
    [
        (vad.HookeJoint, {"shaft_angle": 90}, "between -90° and 90°, got 90°", "at 90° it locks"),
        (vad.SphericalFourBar, {"crank": 180}, "0° and 180°, got 180°", "both axes are one"),
        (vad.SpatialFourBar, {"ground_twist": 0}, "between 0° and 180°, got 0°", "in the plane"),
        (vad.SphericalFourBar, {"rocker": 1e-40}, "at least 1e-30°", "both axes are one"),
        (vad.RSSR, {"coupler": -5}, "must be positive, got -5", "try 5"),
        (vad.RSSR, {"points": {"T": ("coupler", 5)}}, "in the plane alone", "None"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(kind: Any, wrong: Any, message: str, hint: str) -> None:
    with pytest.raises(vad.InputError, match=message) as caught:
        kind(**wrong)
    assert hint in str(caught.value.hint)


def test_a_body_about_no_fixed_line_has_no_angle() -> None:
    motion = vad.solve(vad.RSSR())
    with pytest.raises(vad.UsageError, match="coupler: has no angle"):
        motion.link("coupler").angle  # noqa: B018
    with pytest.raises(vad.UsageError, match="unknown joint 'E'"):
        vad.solve(vad.SphericalFourBar()).joint("E")


@pytest.mark.parametrize("name", SPACE)
def test_as_data_and_in_words(name: str, capsys: Any) -> None:
    kind = SPACE[name]
    motion = vad.solve(kind())
    assert isinstance(motion, MotionInSpace)
    assert run(["solve", name, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data == motion.to_dict()
    assert list(data) == [
        "mechanism", "parameters", "input", "assembly", "units",
        "links", "joints", "points", "slides",
    ]  # fmt: skip
    assert list(data["joints"]) == [*kind.joints] and list(data["links"]) == [*kind.links]
    for link, found in data["links"].items():
        free = link in motion.solver.bodies
        assert list(found) == (["omega", "alpha"] if free else ["angle", "omega", "alpha"])
        assert isinstance(found["omega"], list) == free
    assert all(len(value) == 3 for point in data["points"].values() for value in point.values())
    table = motion.table()
    for word in ("x, mm", "a_z, mm/s^2", *data["points"], *data["joints"], *data["slides"]):
        assert word in table


def test_the_plane_has_no_joints() -> None:
    motion = vad.solve(vad.FourBar())
    assert "joints" not in motion.to_dict() and not isinstance(motion, MotionInSpace)


def test_sweeps(tmp_path: Any) -> None:
    table, plot = tmp_path / "sweep.csv", tmp_path / "sweep.png"
    for path in (table, plot):
        assert run(["sweep", "spatial-four-bar", "--steps", "5", "-o", str(path)]) == 0
    head, *rows = table.read_text().splitlines()
    assert len(rows) == 5 and plot.stat().st_size > 10_000
    names = head.split(",")
    row = dict(zip(names, map(float, rows[1].split(",")), strict=True))
    motion = vad.solve(vad.SpatialFourBar(), angle=row["angle [deg]"])
    assert row["joint B omega [rad/s]"] == motion.joint("B").omega
    assert row["coupler alpha z [rad/s^2]"] == motion.link("coupler").alpha[2]
    assert row["slide_d velocity [mm/s]"] == motion.slide("slide_d").velocity
    wanted = ("C.position", "B.angle", "coupler.omega")
    blocks = vad.sweep(vad.SpatialFourBar(), wanted, angle=np.array([row["angle [deg]"]]))
    assert (blocks["C.position"][0] == motion.point("C").position).all()
    assert blocks["B.angle"][0] == motion.joint("B").angle


def test_a_batch(tmp_path: Any) -> None:
    """Exercises in space: numbers drawn clear of dead centres, answers by axes."""
    sheets = tmp_path / "sheets.toml"
    sheets.write_text(
        '[sheet]\nmechanism = "spherical-four-bar"\ncount = 2\nseed = 3\nfiles = ["key.json"]\n'
        "[vary]\ncrank = [30, 75]\nangle = [20, 100, 180, 200]\n[keep]\nsine = 0.2\n",
        encoding="utf-8",
    )
    made = list(vad.batch(sheets, tmp_path / "sheets"))
    assert [each.error for each in made] == [None, None]
    head, *rows = (tmp_path / "sheets" / "answers.csv").read_text().splitlines()
    assert len(rows) == 2
    for name in ("joint B omega [rad/s]", "coupler alpha z [rad/s^2]", "C position z [mm]"):
        assert name in head
