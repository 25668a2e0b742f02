"""What must hold of every motion in space, whatever solves it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import vad

POSES = [(20.0, 3.0, -2.0), (140.0, 10.0, 0.0), (250.0, -4.0, 7.0), (333.0, 1.0, 20.0)]
SIDES = ["open", "crossed"]
SIZES = {"ground": 100.0, "crank": 40.0, "coupler": 80.0, "rocker": 60.0}
TWISTS = {"ground": 60.0, "crank": 30.0, "coupler": 55.0, "rocker": 45.0}
poses = pytest.mark.parametrize("pose", POSES, ids=str)
sides = pytest.mark.parametrize("side", SIDES)


def solved(mechanism: vad.Mechanism, pose: tuple[float, float, float]) -> Any:
    return vad.solve(mechanism, **dict(zip(("angle", "omega", "alpha"), pose, strict=True)))


def spherical(side: str, **arcs: float) -> vad.SphericalFourBar:
    return vad.SphericalFourBar(**arcs, assembly=side)


def spatial(side: str, scale: float = 1.0, **lengths: float) -> vad.SpatialFourBar:
    sizes = {name: scale * size for name, size in (SIZES | lengths).items()}
    twists = {f"{name}_twist": twist for name, twist in TWISTS.items()}
    return vad.SpatialFourBar(**sizes, **twists, assembly=side)


def sines(*degrees: float) -> list[float]:
    return [math.sin(math.radians(each)) for each in degrees]


@poses
@sides
def test_the_sine_law(side: str, pose: Any) -> None:
    """With a ruler: ω₄/ω₂ = sin AI / sin DI."""
    motion = solved(spherical(side), pose)
    tau, ground = motion.solver.axis(motion.pose).tau, motion.mechanism.ground
    ratio = motion.link("rocker").omega / motion.link("crank").omega
    one, other = sines(tau, tau - ground)
    assert ratio == pytest.approx(one / other, rel=1e-12)
    volume = -sines(motion.mechanism.coupler)[0] * sines(motion.solver.axis(motion.pose).delta)[0]
    assert motion.pose.sine[0] == pytest.approx(volume * other, rel=1e-12)


@poses
@sides
def test_both_triangles_hinge_at_the_instant_axis(side: str, pose: Any) -> None:
    """What is drawn by crossings, ω₄₂ and its change, closes with what one determinant solved."""
    motion = solved(spherical(side), pose)
    solver, found = motion.solver, motion.solver.axis(motion.pose)
    velocity = solver.axis_velocity(motion.pose, motion.velocity)
    along = solver.axis_acceleration(motion.pose, motion.acceleration)
    a, d, b, c = (motion.point(letter).position for letter in "ADBC")
    i, m, j = (np.array(each) for each in (found.i, found.m, found.j))
    rates = [motion.link(name).omega for name in ("crank", "rocker")]
    seconds = [motion.link(name).alpha for name in ("crank", "rocker")]
    joints = [motion.joint(letter) for letter in "BC"]
    scale = 1e-12 * max(np.abs([*rates, *seconds, *(each.alpha for each in joints)]))
    assert np.abs(rates[1] * d - rates[0] * a - velocity.omega * i).max() < scale
    assert np.abs(joints[0].omega * b - joints[1].omega * c - velocity.omega * i).max() < scale
    turned = velocity.omega * velocity.tau * m + along * i
    assert np.abs(seconds[1] * d - seconds[0] * a - turned).max() < scale * 10
    turned = velocity.omega * velocity.tau3 * j + along * i
    assert np.abs(joints[0].alpha * b - joints[1].alpha * c - turned).max() < scale * 10
    rate = np.linalg.norm(motion.point("I").velocity)
    assert rate == pytest.approx(abs(velocity.tau), rel=1e-12)


@poses
@sides
def test_transference(side: str, pose: Any) -> None:
    """Dual parts are the slides that three vectors find: s_B b - s_C c - s_D d closes the loop."""
    motion = solved(spatial(side), pose)
    image = solved(spherical(side, **TWISTS), pose)
    for name in ("crank", "rocker"):
        for quantity in ("angle", "omega", "alpha"):
            assert getattr(motion.link(name), quantity) == getattr(image.link(name), quantity)
    a, b, c, d = (image.point(letter).position for letter in "ABCD")
    normals = [
        SIZES[name] * np.cross(one, other) / np.linalg.norm(np.cross(one, other))
        for name, one, other in (
            ("ground", a, d),
            ("rocker", d, c),
            ("crank", a, b),
            ("coupler", b, c),
        )
    ]
    gap = normals[0] + normals[1] - normals[2] - normals[3]
    found = np.linalg.solve(np.array([b, -c, -d]).T, gap)
    mine = [motion.slide(f"slide_{letter}").position for letter in "bcd"]
    assert mine == pytest.approx(found, rel=1e-12)


@pytest.mark.parametrize("factor", [2.0**40, 2.0**-300, 1e-3])
@sides
def test_lengths_scale(side: str, factor: float) -> None:
    one, other = (solved(spatial(side, scale), POSES[0]) for scale in (1.0, factor))
    for name in one.slides:
        for quantity in ("position", "velocity", "acceleration"):
            small, large = (getattr(each.slide(name), quantity) for each in (one, other))
            exact = math.frexp(factor)[0] == 0.5
            assert large == (small * factor if exact else pytest.approx(small * factor, rel=1e-12))
    rssr = {"crank": 200.0, "coupler": 1200.0, "rocker": 700.0, "crank_offset": 400.0}
    rssr |= {"rocker_offset": 850.0, "ground": 30.0}
    motions = [
        solved(vad.RSSR(**{n: size * k for n, size in rssr.items()}, assembly=side), POSES[0])
        for k in (1.0, factor)
    ]
    angles = [each.link("rocker").alpha for each in motions]
    assert angles[0] == pytest.approx(angles[1], rel=1e-12)


@poses
@sides
def test_the_mirror(side: str, pose: Any) -> None:
    other = SIDES[1 - SIDES.index(side)]
    image = tuple(-x for x in pose)
    for one, mirrored in (
        (solved(spherical(side), pose), solved(spherical(other), image)),
        (solved(spatial(side), pose), solved(spatial(other), image)),
    ):
        assert mirrored.link("rocker").angle == pytest.approx(-one.link("rocker").angle % 360.0)
        for quantity in ("omega", "alpha"):
            mine, other_one = (getattr(m.link("rocker"), quantity) for m in (one, mirrored))
            assert other_one == pytest.approx(-mine, rel=1e-12)


@sides
def test_inversion(side: str) -> None:
    """Driven at D and read at A, it turns at the inverse ratio."""
    motion = solved(spherical(side), POSES[1])
    rocker = motion.link("rocker")
    swapped = spherical(side, crank=70.0, rocker=40.0)
    back = vad.solve(swapped, angle=180.0 - rocker.angle, omega=-rocker.omega, alpha=-rocker.alpha)
    assert back.link("rocker").angle == pytest.approx(180.0 - POSES[1][0])
    assert back.link("rocker").omega == pytest.approx(-POSES[1][1], rel=1e-12)
    assert back.link("rocker").alpha == pytest.approx(0.0, abs=1e-10)


@poses
@sides
def test_small_arcs_are_the_plane(side: str, pose: Any) -> None:
    sizes = {"ground": 100.0, "crank": 40.0, "coupler": 120.0, "rocker": 80.0}
    small = {name: math.degrees(1e-7 * size) for name, size in sizes.items()}
    plane = solved(vad.FourBar(**sizes, assembly=side), pose).link("rocker")
    sphere = solved(spherical(side, **small), pose).link("rocker")
    balls = solved(
        vad.RSSR(**sizes, ground_twist=0, crank_offset=0, rocker_offset=0, assembly=side), pose
    )
    for quantity in ("angle", "omega", "alpha"):
        wanted = getattr(plane, quantity)
        assert getattr(sphere, quantity) == pytest.approx(wanted, rel=1e-5)
        assert getattr(balls.link("rocker"), quantity) == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("shafts", [30.0, -50.0, 85.0, 0.0])
@poses
def test_two_hookes_joints_in_phase_turn_alike(shafts: float, pose: Any) -> None:
    """The forks of the shaft between lie in one plane; the outer shafts are parallel."""
    between = solved(vad.HookeJoint(shafts), pose).link("driven")
    last = vad.solve(
        vad.HookeJoint(shafts), angle=between.angle + 90.0, omega=between.omega, alpha=between.alpha
    ).link("driven")
    assert (last.angle - 90.0) % 360.0 == pytest.approx(pose[0])
    assert last.omega == pytest.approx(pose[1], rel=1e-12)
    assert last.alpha == pytest.approx(pose[2], rel=1e-11, abs=1e-10)


@poses
def test_hookes_joint_is_a_spherical_four_bar(pose: Any) -> None:
    joint = solved(vad.HookeJoint(30.0), pose)
    right = {"crank": 90.0, "coupler": 90.0, "rocker": 90.0}
    bars = solved(spherical("open", ground=30.0, **right), pose)
    assert bars.link("rocker").omega == pytest.approx(joint.link("driven").omega, rel=1e-12)
    assert bars.link("coupler").alpha == pytest.approx(joint.link("cross").alpha, abs=1e-11)
    assert -bars.point("C").velocity == pytest.approx(joint.point("Q").velocity, abs=1e-12)


def test_hookes_joint_has_formulas_of_its_own_for_a_reason() -> None:
    """Where the shafts are nearly in line, those of the spherical four-bar lose the digits of ψ."""
    shafts, angle = 1e-6, 40.0
    swing = math.asin(sines(shafts)[0] * math.cos(math.radians(angle)))
    joint = vad.solve(vad.HookeJoint(shafts), angle=angle).joint("Q").angle
    bars = vad.solve(spherical("open", ground=shafts, crank=90.0, coupler=90.0, rocker=90.0))
    other = vad.solve(bars.mechanism, angle=angle).joint("C").angle + 90.0
    assert math.radians(joint) == pytest.approx(swing, rel=1e-15)
    assert 1e-9 < abs(math.radians(other % 360.0) / swing - 1.0) < 1e-6


@pytest.mark.parametrize("angle", np.linspace(7.0, 173.0, 5))
def test_bennett_never_slides(angle: float) -> None:
    """Opposite links alike, a / sin α the same for both pairs."""
    short = 100.0 * sines(30.0)[0] / sines(110.0)[0]
    bennett = vad.SpatialFourBar(
        100.0, short, 100.0, short,
        ground_twist=110.0, crank_twist=30.0, coupler_twist=110.0, rocker_twist=30.0,
        assembly="crossed" if angle < 180.0 else "open",
    )  # fmt: skip
    motion = vad.solve(bennett, angle=angle, omega=-4.0, alpha=7.0)
    # At 173°, next to the dead centre, an ε in one length would make 20 times as much.
    for name in motion.slides:
        slide = motion.slide(name)
        assert abs(slide.position) < 1e-12
        assert abs(slide.velocity) < 1e-10
        assert abs(slide.acceleration) < 3e-9


@pytest.mark.parametrize(
    "mechanism",
    [vad.HookeJoint(40.0), vad.SphericalFourBar(), vad.SpatialFourBar(), vad.RSSR(ground=50.0)],
    ids=lambda mechanism: mechanism.name,
)
def test_rates_are_derivatives(mechanism: vad.Mechanism) -> None:
    """Of every point, and of ω of every body, by central differences."""
    step = 1e-5

    def at(time: float) -> Any:
        angle = 77.0 + math.degrees(2.0 * time + 1.5 * time**2)
        return vad.solve(mechanism, angle=angle, omega=2.0 + 3.0 * time, alpha=3.0)

    before, now, after = at(-step), at(0.0), at(step)
    for letter in now.points:
        for one, other in (("position", "velocity"), ("velocity", "acceleration")):
            ends = [getattr(each.point(letter), one) for each in (before, after)]
            found, size = getattr(now.point(letter), other), np.abs(ends).max()
            assert (ends[1] - ends[0]) / (2 * step) == pytest.approx(
                found, rel=1e-6, abs=1e-6 * size
            )
    for name in now.links:
        ends = [each.link(name).omega for each in (before, after)]
        found = now.link(name).alpha
        assert (ends[1] - ends[0]) / (2 * step) == pytest.approx(found, rel=1e-6, abs=1e-6)
    for letter in now.joints:
        (first, second), found = (each.joint(letter) for each in (before, after)), now.joint(letter)
        sign = -1 if letter == "Q" else 1  # there ψ grows as the cross turns backward
        turned = math.radians(second.angle - first.angle) / (2 * step)
        assert turned == pytest.approx(sign * found.omega, rel=1e-6, abs=1e-6)
        grown = (second.omega - first.omega) / (2 * step)
        assert grown == pytest.approx(found.alpha, rel=1e-6, abs=1e-6)
