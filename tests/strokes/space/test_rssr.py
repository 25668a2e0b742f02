"""The ball-jointed four-bar on the board: what the strokes measure is what the solver finds."""

from __future__ import annotations

import cmath
import math
import re
from typing import Any

import numpy as np
import pytest

import vad
from vad.strokes.draw import scene_of
from vad.strokes.sheet import Arrow, Line, Panel
from vad.words import Language

SLANTED = vad.RSSR(
    ground=100.0, crank=40.0, coupler=120.0, rocker=80.0,
    ground_twist=40.0, crank_offset=30.0, rocker_offset=-20.0,
)  # fmt: skip
MECHANISMS = [vad.RSSR(), SLANTED, vad.RSSR(assembly="crossed")]
ANGLES = [0.0, 75.0, 160.0, 290.0]
poses = pytest.mark.parametrize(
    "motion",
    [vad.solve(kind, angle=angle, alpha=5.0) for kind in MECHANISMS for angle in ANGLES],
    ids=lambda motion: f"{motion.mechanism.assembly}-{motion.inputs['angle']:g}",
)


def arrows(panel: Panel) -> dict[str, complex]:
    """Return every vector that is drawn or left out, by its name."""
    strokes = (*panel.strokes, *panel.zeros)
    shapes = {stroke.name: stroke.shape for stroke in strokes}
    return {n: s.end - s.start for n, s in shapes.items() if isinstance(s, Arrow)}


def third_view(motion: Any) -> Any:
    scene: Any = scene_of(motion, Language("en"))
    return scene.script.true


@poses
def test_velocities(motion: Any) -> None:
    """Along the path and across BC all is measured true; the rest is what leads off the paper."""
    drawn, seen = arrows(vad.draw(motion).panel("velocity")), third_view(motion)
    b, c = motion.point("B").velocity, motion.point("C").velocity
    assert abs(drawn["DC.tangential"]) == pytest.approx(np.linalg.norm(c), rel=1e-12)
    assert c @ np.array(seen.toward) == pytest.approx(0.0, abs=1e-9 * np.linalg.norm(c))
    relative = abs(drawn["BC.tangential"]) ** 2 + (b @ np.array(seen.toward)) ** 2
    assert relative == pytest.approx((c - b) @ (c - b), rel=1e-12)
    sides = drawn["AB.tangential"] + drawn["BC.tangential"], drawn["DC.tangential"]
    assert sides[0] == pytest.approx(sides[1], rel=1e-12)


@poses
def test_accelerations(motion: Any) -> None:
    drawn, seen = arrows(vad.draw(motion).panel("acceleration")), third_view(motion)
    rocker, sizes = motion.link("rocker"), motion.mechanism.parameters()
    relative = motion.point("C").velocity - motion.point("B").velocity
    normal = relative @ relative / sizes["coupler"]
    assert abs(drawn["BC.normal"]) == pytest.approx(normal, rel=1e-12)
    tangential = abs(rocker.alpha) * sizes["rocker"]
    assert abs(drawn["DC.tangential"]) == pytest.approx(tangential, rel=1e-12)
    for point, name in (("B", "AB"), ("C", "DC")):
        whole = seen.way(motion.point(point).acceleration)
        parts = drawn[f"{name}.normal"] + drawn[f"{name}.tangential"]
        assert parts == pytest.approx(complex(whole), rel=1e-11)


@poses
def test_lines_run_as_in_the_third_view(motion: Any) -> None:
    sheet = vad.draw(motion)
    bars = arrows(sheet.panel("position"))
    shapes = {stroke.name: stroke.shape for stroke in sheet.panel("velocity").strokes}
    across, path = shapes["BC.line"], shapes["DC.line"]
    assert isinstance(across, Line) and isinstance(path, Line)
    along = bars["BC.third"] / abs(bars["BC.third"])
    assert (across.direction * along.conjugate()).real == pytest.approx(0.0, abs=1e-12)
    # The angle between BC and the path is true.
    b, c = motion.point("B").position, motion.point("C").position
    cosine = (c - b) @ motion.point("C").velocity
    cosine /= np.linalg.norm(c - b) * np.linalg.norm(motion.point("C").velocity)
    turned = cmath.phase(path.direction / along)
    assert abs(np.cos(turned)) == pytest.approx(abs(cosine), abs=1e-12)


@poses
def test_circles_are_in_true_size(motion: Any) -> None:
    bars, sizes = arrows(vad.draw(motion).panel("position")), motion.mechanism.parameters()
    assert abs(bars["AB.bar"]) == pytest.approx(sizes["crank"], rel=1e-12)
    assert abs(bars["DC.front"]) == pytest.approx(sizes["rocker"], rel=1e-12)
    for name in ("AB", "BC", "DC"):
        above, below = bars[f"{name}.front"], bars["AB.bar" if name == "AB" else f"{name}.top"]
        assert above.real == pytest.approx(below.real, abs=1e-9)  # one straight over the other
    assert cmath.phase(bars["DC.front"]) % cmath.tau == pytest.approx(
        np.radians(motion.link("rocker").angle), abs=1e-12
    )


@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_strokes_have_the_same_names_in_every_pose(language: str) -> None:
    names = set()
    for angle in (*ANGLES, 95.5):
        for omega in (0.0, 10.0):
            sheet = vad.draw(vad.solve(vad.RSSR(), angle=angle, omega=omega), language=language)
            names.add(
                tuple(
                    tuple(sorted(stroke.name for stroke in (*panel.strokes, *panel.zeros)))
                    for panel in sheet.panels
                )
            )
            said = [stroke.caption for panel in sheet.panels for stroke in panel.strokes]
            assert all(said) and not any("{" in caption for caption in said)
    assert len(names) == 1


def test_without_twist_the_polygon_is_the_four_bars() -> None:
    """Turned into the third view, letter by letter."""
    sizes = {"ground": 100.0, "crank": 40.0, "coupler": 120.0, "rocker": 80.0}
    flat = vad.solve(vad.RSSR(**sizes, ground_twist=0.0, crank_offset=0.0, rocker_offset=0.0))
    plane = vad.solve(vad.FourBar(**sizes))
    for name in ("velocity", "acceleration"):
        mine, other = (arrows(vad.draw(motion).panel(name)) for motion in (flat, plane))
        turn = mine["DC.tangential"] / other["DC.tangential"]
        assert abs(turn) == pytest.approx(1.0)
        assert mine.keys() == other.keys()
        for vector, value in mine.items():
            assert value == pytest.approx(turn * other[vector], abs=1e-8)


@pytest.mark.parametrize("panel", ["position", "velocity", "acceleration"])
def test_balls_that_meet_nowhere_are_an_error(panel: str) -> None:
    with pytest.raises(vad.AssemblyError, match="they close at no angle"):
        vad.draw(vad.solve(vad.RSSR(coupler=300.0)), panels=panel)


def test_where_bc_lies_along_the_path_the_third_view_is_along_the_axis() -> None:
    """The rocker upright, BC level: then every view square to BC shows both in true length."""
    sizes = {"ground": 100.0, "crank": math.hypot(20.0, 80.0), "coupler": 120.0, "rocker": 80.0}
    flat = vad.RSSR(**sizes, ground_twist=0.0, crank_offset=0.0, rocker_offset=0.0)
    motion = vad.solve(flat, angle=math.degrees(math.atan2(80.0, -20.0)))
    assert motion.link("rocker").angle == pytest.approx(90.0)
    assert np.array(third_view(motion).toward) == pytest.approx([0.0, 0.0, 1.0])
    bars = arrows(vad.draw(motion).panel("position"))
    assert abs(bars["BC.third"]) == pytest.approx(120.0)


@poses
def test_lines_perpendicular_to_the_path_lead_from_the_front_to_the_third_view(motion: Any) -> None:
    """The plane of BC and C's path is rotated about this path, and nothing is enlarged."""
    shapes = {each.name: each.shape for each in vad.draw(motion).panel("position").strokes}
    path = np.subtract(*reversed(shapes["C.line"].points))
    assert shapes["DC.front"].end - shapes["DC.front"].start == pytest.approx(
        -1j * motion.mechanism.rocker * path / abs(path), abs=1e-9
    )
    for letter, bar in (("A", "AB"), ("B", "BC"), ("C", "DC")):
        end = "end" if letter == "C" else "start"
        begun, reached = shapes[f"{letter}.aside"].points
        assert begun == getattr(shapes[f"{bar}.front"], end)
        assert reached == getattr(shapes[f"{bar}.third"], end)
        along = (reached - begun) / path
        assert abs(along.real) < 1e-9 * abs(along.imag)
    laid = shapes["BC.third"]
    assert abs(laid.end - laid.start) == pytest.approx(motion.mechanism.coupler, rel=1e-12)


@poses
def test_the_angle_of_the_rocker_is_seen_from_a_zero_line(motion: Any) -> None:
    """It stands near the end of the rocker, where also a small angle is wider than the bar."""
    shapes = {each.name: each.shape for each in vad.draw(motion).panel("position").strokes}
    arc, (start, end), d = shapes["DC.angle"], shapes["DC.zero"].points, shapes["DC.front"].start
    assert (arc.centre, arc.start, start) == (d, 0.0, d)
    assert (end - d).imag == 0.0
    assert 0.5 * motion.mechanism.rocker < arc.radius < (end - d).real < motion.mechanism.rocker
    assert math.radians(arc.sweep) == pytest.approx(cmath.phase(shapes["DC.front"].end - d))


@poses
def test_both_offsets_are_drawn_with_their_lengths(motion: Any) -> None:
    """Each along its own axis, in the view along the other one, from there to the other point."""
    drawn, sizes = vad.draw(motion).panel("position"), motion.mechanism.parameters()
    strokes = {each.name: each for each in drawn.strokes}
    slant = math.sin(math.radians(sizes["ground_twist"]))
    for name, link in (("A.offset", "crank_offset"), ("D.offset", "rocker_offset")):
        begin, foot, end = strokes[name].shape.points
        assert abs(foot - begin) == pytest.approx(abs(sizes[link]) * slant)
        assert ((foot - end) / abs(sizes[link])).imag == pytest.approx(0.0, abs=1e-9)
        assert strokes[name].label == f"{sizes[link]:g}".replace("-", "−")


@poses
def test_projections_have_letters_of_their_own_and_are_all_explained(motion: Any) -> None:
    """With the parts that lead into the paper they make the true lengths, and h·ω² has its sign."""
    sheet, number = vad.draw(motion), r"(−?\d+(?:\s\d{3})*(?:\.\d+)?)"
    told = sheet.panel("position").strokes[-1].caption
    seen, off = (
        {ends: float(value.replace("−", "-")) for ends, value in re.findall(each, told)}
        for each in (rf"p_(\w\w) = {number}", rf"h_(\w\w) = {number}")
    )
    sizes = motion.mechanism.parameters()
    true = {"AB": sizes["crank"], "BT": sizes["crank"], "DC": sizes["rocker"]}
    for ends, length in true.items():
        assert math.hypot(seen[ends], off[ends]) == pytest.approx(length, rel=1e-3)
    toward = np.array(third_view(motion).toward)
    for ends, (tail, head) in (("AB", "AB"), ("DC", "DC")):
        depth = (motion.point(tail).position - motion.point(head).position) @ toward
        assert off[ends] == pytest.approx(depth, rel=1e-3, abs=1e-3 * true[ends])
    strokes = {s.name: s.caption for s in sheet.panel("acceleration").strokes}
    assert "ω₂²·p_AB = " in strokes["AB.normal"]
    assert "ω₄²·p_DC = " in strokes["DC.normal"]
    assert "ω₃²·BC = " in strokes["BC.normal"]
    assert "α₂·p_BT = " in strokes["AB.tangential"]
    change = motion.point("B").acceleration - motion.point("C").acceleration
    (said,) = re.findall(rf"into the paper [^:]+ = {number}\s", strokes["BC.tangential"])
    into = float("".join(said.split()).replace("−", "-"))
    assert into == pytest.approx(change @ toward, rel=1e-3)


def test_lengths_whose_squares_underflow_are_drawn_as_any_others():
    unit = 2.0**-620
    usual = vad.RSSR().parameters()
    angle = usual.pop("ground_twist")
    tiny = vad.RSSR(ground_twist=angle, **{name: size * unit for name, size in usual.items()})
    drawn, wanted = (
        vad.draw(vad.solve(each, angle=50.0)).panel("velocity").strokes
        for each in (tiny, vad.RSSR())
    )
    for one, other in zip(drawn, wanted, strict=True):
        if isinstance(one.shape, Arrow):
            assert one.shape.end / unit == pytest.approx(other.shape.end, rel=1e-12)


def test_a_bar_that_is_nothing_beside_the_others_is_refused_by_name():
    kind = vad.RSSR(ground=0, crank=30, coupler=1e-170, rocker=50, crank_offset=40, rocker_offset=0)
    with pytest.raises(vad.InputError, match="BC: is too short beside the others to be drawn"):
        vad.draw(vad.solve(kind, angle=0.0), "position")
