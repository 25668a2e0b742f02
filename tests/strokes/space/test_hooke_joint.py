"""Hooke's joint on the board: what its views and polygons say is what the solver finds."""

from __future__ import annotations

import cmath
import math
import re
from functools import cache
from typing import Any

import numpy as np
import pytest

import vad
from tests.plan.overlaps import overlaps
from tests.strokes.named import dot, stroke, vector
from vad.export.sheet_json import sheet_from_json, to_text
from vad.kinematics.space.crossed_shafts import UniversalSolver
from vad.strokes.draw import scene_of
from vad.strokes.scripts import hooke_joint
from vad.strokes.sheet import Arc, Curve, Line, PolarInset, Sheet
from vad.words import Language, languages

pytestmark = pytest.mark.exhaustive

PLAN = hooke_joint.PLAN.at
ANGLES = [*range(0, 360, 45), 60, 130, 200, 341]
SHAFTS = (30.0, -50.0, 0.0, 89.0, -89.0)


@cache
def motion(angle: float, shafts: float = 30.0, omega: float = 10.0, alpha: float = 40.0) -> Any:
    return vad.solve(vad.HookeJoint(shaft_angle=shafts), angle=angle, omega=omega, alpha=alpha)


@cache
def sheet(angle: float, shafts: float = 30.0, code: str = "en") -> Sheet:
    return vad.draw(motion(angle, shafts), language=code)


poses = pytest.mark.parametrize("angle", ANGLES)
shaft_angles = pytest.mark.parametrize("shafts", SHAFTS)


@shaft_angles
def test_strokes_have_the_same_names_in_every_pose(shafts: float):
    names = {panel.name: set() for panel in sheet(60.0).panels}
    for angle in ANGLES:
        for panel in sheet(angle, shafts).panels:
            own = [s.name for s in (*panel.strokes, *panel.zeros)]
            assert len(own) == len(set(own))
            names[panel.name].add(frozenset(own))
    assert all(len(found) == 1 for found in names.values())


@pytest.mark.parametrize("code", languages())
def test_captions_are_sentences(code: str):
    for angle in ANGLES[::3]:
        for panel in sheet(angle, code=code).panels:
            for each in panel.strokes:
                assert re.fullmatch(r".*[^\s.,;:]\.", each.caption), each.caption
                assert not re.search(r"\s\s|[{}\x02\x03]|\s[.,]", each.caption), each.caption


@poses
@shaft_angles
def test_the_views_are_those_of_the_pins(angle: float, shafts: float):
    here, panel = motion(angle, shafts), sheet(angle, shafts).panel("position")
    x, y = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    assert vector(panel, "OP.arm") / 2 == pytest.approx(complex(x, y))
    q, width = dot(panel, "Q.found"), math.cos(math.radians(shafts))
    # The right angle of the cross is seen, and Q is on the ellipse.
    assert (q * complex(x, -y)).real == pytest.approx(0.0, abs=1e-12)
    assert (q.real / width) ** 2 + q.imag**2 == pytest.approx(1.0)
    theta = math.radians(here.link("driven").angle)
    turned = stroke(panel, "Q.turned").shape
    assert isinstance(turned, Curve)
    assert turned.points[0].imag == pytest.approx(turned.points[1].imag)
    assert turned.points[1] == pytest.approx(1j * cmath.exp(1j * theta))
    # One above the other in both views, and of the same length in space.
    for letter, seen in (("P", complex(x, y)), ("Q", q)):
        arm = vector(panel, f"{letter}.plan") / 2
        assert arm.real == pytest.approx(seen.real)
        assert math.hypot(seen.real, seen.imag, arm.imag) == pytest.approx(1.0)
    # How far each pin stands off the plane of the other yoke is the sine of the cross's swing.
    drawn = {each.name: each.shape for each in (*panel.strokes, *panel.zeros)}
    for pin, swing, way in (
        ("Q", "P", 1.0 + 0j),
        ("P", "Q", cmath.rect(1.0, math.radians(shafts))),
    ):
        edge, off = drawn[f"{pin}.edge"], drawn[f"{pin}.off"]
        assert isinstance(edge, Curve) and isinstance(off, Curve)
        start, foot = off.points
        assert edge.points == (PLAN, foot)
        assert start == pytest.approx(PLAN + vector(panel, f"{pin}.plan") / 2)
        assert ((foot - PLAN) * way.conjugate()).imag == pytest.approx(0.0, abs=1e-12)
        assert ((start - foot) * way.conjugate()).real == pytest.approx(0.0, abs=1e-12)
        sine = math.sin(math.radians(here.joint(swing).angle))
        assert abs(start - foot) == pytest.approx(abs(sine), abs=1e-12)


@poses
@shaft_angles
def test_ot_is_in_the_plane_of_the_cross_and_in_that_of_the_shafts(angle: float, shafts: float):
    here, panel = motion(angle, shafts), sheet(angle, shafts).panel("position")
    line, at = stroke(panel, "PQ.line").shape, dot(panel, "T.found")
    assert isinstance(line, Line)
    assert at.imag == pytest.approx(0.0, abs=1e-12)
    away = (at - line.through) * line.direction.conjugate()
    assert away.imag == pytest.approx(0.0, abs=1e-12)
    assert -1e-12 <= away.real <= abs(line.until - line.through) + 1e-12
    ot = dot(panel, "T.plan") - PLAN
    assert ot.real == pytest.approx(at.real)
    assert ot.real > 0.0  # it stays on its side all through a turn
    assert isinstance(here.solver, UniversalSolver)
    i = here.solver.axis(here.pose).i
    assert (ot.conjugate() * complex(-i[1], -i[2])).imag == pytest.approx(0.0, abs=1e-12)


@poses
@shaft_angles
def test_the_triangles_of_omega(angle: float, shafts: float):
    here, velocity = motion(angle, shafts), sheet(angle, shafts).panel("velocity")
    position = sheet(angle, shafts).panel("position")
    two, four, three = (
        vector(velocity, name) for name in ("12.absolute", "14.absolute", "23.relative")
    )
    relative, at_q = vector(velocity, "24.relative"), vector(velocity, "43.relative")
    largest = max(abs(two), abs(four))
    near = {"abs": 1e-9 * largest}
    assert two == pytest.approx(-10j)
    assert abs(four) == pytest.approx(here.link("driven").omega)
    axis = stroke(position, "4.shaft").shape
    assert isinstance(axis, Curve)
    along = axis.points[1] - axis.points[0]
    assert (four * along.conjugate()).imag == pytest.approx(0.0, **near)
    assert two + relative == pytest.approx(four, **near)
    ot = dot(position, "T.plan") - PLAN
    assert (relative * ot.conjugate()).imag == pytest.approx(0.0, **near)
    # The cross laid over: a right angle at 3.
    assert three - relative == pytest.approx(at_q, **near)
    assert abs(three) == pytest.approx(abs(here.joint("P").omega), **near)
    assert abs(at_q) == pytest.approx(abs(here.joint("Q").omega), **near)
    assert (three * at_q.conjugate()).real == pytest.approx(0.0, abs=1e-9 * largest**2)


@poses
@shaft_angles
def test_the_quadrilateral_of_alpha(angle: float, shafts: float):
    here, panel = motion(angle, shafts), sheet(angle, shafts).panel("acceleration")
    turned, grown = vector(panel, "24.normal"), vector(panel, "24.tangential")
    two, four = vector(panel, "12.absolute"), vector(panel, "14.absolute")
    largest = max(map(abs, (turned, grown, two, four)))
    near = {"abs": 1e-9 * largest}
    assert two == pytest.approx(-40j)
    assert abs(four) == pytest.approx(abs(here.link("driven").alpha), **near)
    assert two + turned + grown == pytest.approx(four, **near)
    assert isinstance(here.solver, UniversalSolver)
    found = here.solver.axis_velocity(here.pose, here.velocity)
    assert abs(turned) == pytest.approx(abs(found.omega * found.tau), **near)
    ot = dot(sheet(angle, shafts).panel("position"), "T.plan") - PLAN
    assert (turned * ot.conjugate()).real == pytest.approx(0.0, **near)
    assert (grown * ot.conjugate()).imag == pytest.approx(0.0, **near)
    size = here.solver.axis_acceleration(here.pose, here.acceleration)
    assert abs(grown) == pytest.approx(abs(size), **near)


@poses
def test_every_result_is_revealed_once(angle: float):
    for panel in sheet(angle).panels:
        revealed = [row for each in panel.strokes for row in each.reveals]
        assert sorted(revealed) == ["cross", "driven"]


def test_printed_factors_give_the_printed_product():
    for angle in ANGLES:
        panel = sheet(angle).panel("acceleration")
        for each in panel.strokes:
            found = re.search(r"\|ω₄₂·τ̇\| = ([\d.]+) × ([\d.]+) = ([\d.]+)", each.caption)
            assert bool(found) == (each.name == "24.normal")
            if found:
                omega, pace, value = found.groups()
                digits = len(value.partition(".")[2])
                assert f"{float(omega) * float(pace):.{digits}f}" == value


@pytest.mark.parametrize("shafts", [30.0, -50.0])
@pytest.mark.parametrize("angle", [60, 200, 341])
def test_the_formulas_of_captions_hold(angle: float, shafts: float):
    drawn, theta, beta = motion(angle, shafts), math.radians(angle), math.radians(shafts)
    position, polygon = (sheet(angle, shafts).panel(name) for name in ("position", "acceleration"))
    line, arc = (stroke(position, f"OT.{which}").shape for which in ("line", "angle"))
    assert isinstance(line, Curve) and isinstance(arc, Arc)
    way = line.points[1] - line.points[0]
    tau = math.radians(arc.sweep)
    assert math.tan(tau) == pytest.approx(way.imag / way.real)
    assert math.tan(tau) == pytest.approx(math.tan(beta) * math.sin(theta) ** 2)
    said: Any = stroke(polygon, "24.normal").said
    pace = next(said.figures(("pace",))).value
    wanted = 10.0 * math.tan(beta) * math.sin(2.0 * theta) * math.cos(tau) ** 2
    assert pace == pytest.approx(abs(wanted))
    p, q, driven = drawn.joint("P"), drawn.joint("Q"), math.radians(drawn.link("driven").angle)
    swings = [math.sin(math.radians(joint.angle)) for joint in (p, q)]
    assert swings[0] == pytest.approx(math.sin(beta) * math.sin(driven))
    assert swings[1] == pytest.approx(math.sin(beta) * math.cos(theta))
    whole = np.linalg.norm(drawn.link("cross").omega)
    assert whole == pytest.approx(math.hypot(10.0, p.omega))
    said = stroke(position, "OP.laid").said
    at_p, at_q = (math.radians(next(said.figures((name,))).value) for name in ("at_p", "at_q"))
    assert math.cos(at_p) == pytest.approx(math.cos(tau) * math.cos(theta))
    assert abs(math.cos(at_q)) == pytest.approx(math.sin(at_p))


def test_what_does_not_turn_is_its_pole():
    still = vad.draw(motion(60.0, omega=0.0, alpha=0.0))
    for name in ("velocity", "acceleration"):
        panel = still.panel(name)
        assert [s.name for s in panel.strokes] == ["pole"]
        assert set(panel.strokes[0].reveals) >= {"cross", "driven"}
        names = {s.name for s in (*panel.strokes, *panel.zeros)}
        assert names == {
            s.name for s in (*sheet(60.0).panel(name).strokes, *sheet(60.0).panel(name).zeros)
        }


@pytest.mark.parametrize("shafts", [30.0, 60.0])
def test_the_inset_shows_the_ratio_over_a_turn(shafts: float):
    inset = sheet(60.0, shafts).panel("velocity").inset
    assert isinstance(inset, PolarInset)
    for number, point in list(enumerate(inset.curve))[:-1:8]:
        theta = 360.0 * number / (len(inset.curve) - 1)
        assert abs(point) == pytest.approx(motion(theta, shafts).link("driven").omega)
        assert cmath.phase(point) % math.tau == pytest.approx(math.radians(theta))
    assert abs(inset.ray) == pytest.approx(motion(60.0, shafts).link("driven").omega)
    for point in inset.dots:
        theta = math.degrees(cmath.phase(point))
        assert motion(theta, shafts).link("driven").omega == pytest.approx(10.0)
    low, high = (
        float(each)
        for each in re.findall(r"[\d.]+", inset.range.partition("=")[2].replace("…", ""))
    )
    assert low == pytest.approx(math.cos(math.radians(shafts)), abs=1e-3)
    assert high == pytest.approx(1.0 / math.cos(math.radians(shafts)), abs=1e-3)


def test_tracks_of_a_turn_are_the_vertices_of_its_poses():
    many = vad.solve(vad.HookeJoint(), angle=np.array(ANGLES, float), omega=10.0, alpha=40.0)
    scene: Any = scene_of(many, Language("en"))
    from vad.strokes.diagrams import DIAGRAMS

    for name in ("position", "velocity", "acceleration"):
        tracks = DIAGRAMS[name].tracks(scene)
        for number, angle in enumerate(ANGLES):
            one: Any = scene_of(motion(angle), Language("en"))
            for letter, place in DIAGRAMS[name].tracks(one).items():
                way = np.broadcast_to(tracks[letter], (len(ANGLES),))
                assert way[number] == pytest.approx(complex(place), abs=1e-9)


def test_the_angle_of_the_pin_is_drawn_on_its_circle():
    panel = sheet(200.0).panel("position")
    arc = stroke(panel, "P.angle").shape
    assert isinstance(arc, Arc)
    assert (arc.centre, arc.start, arc.sweep) == (0j, 0.0, 200.0)


@shaft_angles
def test_a_sheet_reads_back_from_its_json(shafts: float):
    assert sheet_from_json(to_text(sheet(60.0, shafts))) == sheet(60.0, shafts)


@pytest.mark.parametrize("angle", range(5, 365, 120))
def test_no_label_lies_on_a_stroke(angle: int):
    assert overlaps(sheet(angle), lesson=True) == []
    assert overlaps(sheet(angle + 30, -20.0, "de")) == []


@pytest.mark.parametrize("shafts", [30.0, -50.0])
def test_the_rotation_of_shaft_4_relative_to_2_stands_in_the_table(shafts: float):
    """The acceleration is calculated with it; its caption and the table have the same sign."""
    drawn = sheet(60.0, shafts)
    cells = [cell for row in drawn.rows for cell in row.cells["velocity"]]
    omega = next(cell.value for cell in cells if cell.symbol == "ω₄₂")
    two, four = (vector(drawn.panel("velocity"), f"{name}.absolute") for name in ("12", "14"))
    assert abs(omega) == pytest.approx(abs(four - two))
    caption = next(each.caption for each in drawn.panel("velocity").strokes if each.label == "ω₄₂")
    assert ("−" in caption) == (omega < 0.0) == (shafts < 0.0)


@pytest.mark.parametrize("alpha", [0.0, 40.0])
def test_the_caption_of_the_sum_says_when_it_is_that_of_the_driven_shaft(alpha: float):
    panel = vad.draw(motion(60.0, alpha=alpha)).panel("acceleration")
    whole, driven = (vector(panel, name) for name in ("24.whole", "14.absolute"))
    alike = abs(whole - driven) <= 1e-9 * abs(driven)
    assert alike == ("the vector α₄" in stroke(panel, "24.whole").caption) == (not alpha)


@pytest.mark.parametrize("angle", [20.0, 60.0, 130.0, 200.0, 310.0])
def test_captions_have_the_signs_of_the_table(angle: float):
    drawn = sheet(angle)
    said = [each.caption for each in drawn.panel("acceleration").strokes]
    cells = [cell for row in drawn.rows for cell in row.cells["acceleration"]]
    tangential = next(cell.value for cell in cells if cell.symbol == "α₄₂ₜ")
    caption = next(each for each in said if "α₄₂ₜ = " in each)
    assert ("−" in caption.partition("α₄₂ₜ = ")[2]) == (tangential < 0.0)


def test_an_end_without_a_letter_is_described():
    captions = [sheet(angle).panel("position").strokes for angle in range(0, 360, 30)]
    lines = {
        each.caption
        for strokes in captions
        for each in strokes
        if "meets the plane" in each.caption
    }
    assert len(lines) > 1
    assert not any("′" in each for each in lines)
    assert any("the other end of O" in each for each in lines)
