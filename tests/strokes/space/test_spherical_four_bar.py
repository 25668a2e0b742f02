"""The spherical four-bar on the board: what is seen on the sphere, and both triangles."""

from __future__ import annotations

import cmath
import math
from functools import cache
from typing import Any

import numpy as np
import pytest

import vad
from tests.plan.overlaps import overlaps, planned
from tests.strokes.named import dot, stroke, vector
from vad.export.sheet_json import sheet_from_json, to_text
from vad.plan.marks import Polyline, Scaling
from vad.strokes.sheet import Arc, Curve, Ellipse, Fold, Line, Sheet

pytestmark = pytest.mark.exhaustive

ANGLES = [*range(0, 360, 30), 140]
#: The frame's bisector points down: the direction of OA on the page.
ALONG_A = cmath.exp(-0.75j * math.pi)
poses = pytest.mark.parametrize("angle", ANGLES)
assemblies = pytest.mark.parametrize("assembly", ["open", "crossed"])


@cache
def motion(angle: float, assembly: str = "open", alpha: float = 30.0) -> Any:
    return vad.solve(vad.SphericalFourBar(assembly=assembly), angle=angle, alpha=alpha)


@cache
def sheet(angle: float, assembly: str = "open", language: str = "en") -> Sheet:
    return vad.draw(motion(angle, assembly), language=language)


def parts(arm: Any, pose: Any) -> tuple[float, float]:
    """Return an axis along OI and across it, both in the plane of the coupler."""
    i = pose.point("I").position
    return float(arm @ i), float(np.linalg.norm(np.cross(i, arm)))


@poses
@assemblies
def test_strokes_have_the_same_names_in_every_pose(angle: int, assembly: str):
    for panel in sheet(angle, assembly).panels:
        names = sorted(s.name for s in (*panel.strokes, *panel.zeros))
        assert len(names) == len(set(names))
        other = sheet(140).panel(panel.name)
        assert names == sorted(s.name for s in (*other.strokes, *other.zeros))


@poses
@assemblies
def test_all_is_seen_square_to_the_plane_of_the_frame(angle: int, assembly: str):
    pose, panel = motion(angle, assembly), sheet(angle, assembly).panel("position")
    for letter, name in zip("ABCDI", ("fixed", "known", "found", "fixed", "found"), strict=True):
        x, y, z = pose.point(letter).position
        at = dot(panel, f"{letter}.{name}")
        assert at == pytest.approx(ALONG_A * complex(z, -y))
        assert abs(at) == pytest.approx(math.sqrt(1.0 - x * x))  # so A, D and I on the outline
    bar = stroke(panel, "DC.arc").shape
    assert isinstance(bar, Ellipse)
    ends = [bar.at(bar.start), bar.at(bar.start + bar.sweep)]
    assert ends == pytest.approx([dot(panel, "D.fixed"), dot(panel, "C.found")])
    # From D on, which lies in the paper, all of it is on the side of C.
    hidden = sum(last - first for first, last in bar.far)
    behind = pose.point("C").position[0] < 0.0
    assert hidden == pytest.approx(bar.sweep if behind else 0.0)


@poses
@assemblies
def test_the_polygon_of_velocities_has_the_solved_rates(angle: int, assembly: str):
    pose, panel = motion(angle, assembly), sheet(angle, assembly).panel("velocity")
    d, i = (dot(sheet(angle, assembly).panel("position"), f"{x}") for x in ("D.fixed", "I.found"))
    assert vector(panel, "12.absolute") == pytest.approx(10.0 * ALONG_A)
    assert vector(panel, "14.absolute") == pytest.approx(pose.link("rocker").omega * d)
    crossing = vector(panel, "24.relative")
    assert abs((crossing * i.conjugate()).imag) < 1e-9 * abs(crossing)
    for name, letter in (("23", "B"), ("43", "C")):
        found, along = vector(panel, f"{name}.relative"), parts(pose.point(letter).position, pose)
        omega = pose.joint(letter).omega
        assert abs(found) == pytest.approx(abs(omega))
        inside = found * i.conjugate()
        assert inside.real == pytest.approx(omega * along[0], abs=1e-9)
        assert abs(inside.imag) == pytest.approx(abs(omega) * along[1], abs=1e-9)


@poses
@assemblies
def test_the_polygon_of_accelerations_closes(angle: int, assembly: str):
    pose, panel = motion(angle, assembly), sheet(angle, assembly).panel("acceleration")
    second = vector(panel, "12.absolute") + vector(panel, "24.normal")
    assert second + vector(panel, "24.tangential") == pytest.approx(vector(panel, "14.absolute"))
    assert abs(vector(panel, "14.absolute")) == pytest.approx(abs(pose.link("rocker").alpha))
    third = second - vector(panel, "34.normal") + vector(panel, "23.relative")
    assert third == pytest.approx(dot(panel, "3.crossing"))
    assert abs(vector(panel, "43.relative")) == pytest.approx(abs(pose.joint("C").alpha))


def test_the_sine_law_is_what_the_caption_says():
    said = stroke(sheet(140).panel("velocity"), "14.absolute").caption
    calculated = "ω₂·sin AI / sin DI = 10 × sin(39.07°) / sin(129.07°)"
    assert said == f"ω₄ = {calculated} = 8.118 rad/s."
    omega = 10.0 * math.sin(math.radians(39.07)) / math.sin(math.radians(129.07))
    assert round(omega, 3) == round(motion(140).link("rocker").omega, 3) == 8.118


def test_where_nothing_turns_the_pole_is_the_whole_polygon():
    drawn = vad.draw(vad.solve(vad.SphericalFourBar(), angle=50, omega=0, alpha=0))
    for name in ("velocity", "acceleration"):
        assert [s.name for s in drawn.panel(name).strokes] == ["pole"]
        assert drawn.panel(name).strokes[0].reveals == ("crank", "B", "C", "rocker")


@poses
def test_the_plane_of_the_coupler_swings_from_where_it_is_into_the_paper(angle: int):
    pose, drawn = motion(angle), sheet(angle)
    shape = stroke(drawn.panel("velocity"), "fold").shape
    assert isinstance(shape, Fold)
    lines = [stroke(drawn.panel("velocity"), f"{n}.line").shape for n in ("23", "43")]
    plan = planned(drawn, lesson=True)
    scale = plan.sketches["position"].scale
    swung = [
        mark
        for item in plan.items
        if item.stroke == "velocity:fold" and item.region == "position"
        for mark in item.marks
        if isinstance(mark.growth, Scaling)
    ]
    (mark,) = swung
    before, after = (mark.growth.of(mark.shape, share)[0] for share in (0.0, 1.0))
    assert isinstance(before, Polyline)
    assert isinstance(after, Polyline)
    for number, letter in enumerate("BC"):
        _, y, z = pose.point(letter).position
        assert before.pieces[number][1] == pytest.approx(scale(ALONG_A * complex(z, -y)))
        assert after.pieces[number][1] == pytest.approx(scale(shape.arms[number]))
        assert abs(shape.arms[number]) == pytest.approx(1.0)
        line = lines[number]
        assert isinstance(line, Line)
        assert abs((line.direction * shape.arms[number].conjugate()).imag) < 1e-9
        laid = stroke(drawn.panel("position"), f"O{letter}.laid").shape
        assert isinstance(laid, Curve)
        assert laid.points[0] == pytest.approx(shape.arms[number])


@poses
def test_no_label_stands_on_a_stroke(angle: int):
    assert overlaps(sheet(angle), lesson=angle % 60 == 0) == []


def test_a_sheet_comes_back_from_json():
    drawn = sheet(140)
    assert sheet_from_json(to_text(drawn)) == drawn


def test_great_circles_of_a_mirrored_mechanism_are_mirrored():
    one = sheet(70).panel("position")
    other = vad.draw(vad.solve(vad.SphericalFourBar(assembly="crossed"), angle=-70))
    mirrored = other.panel("position")
    assert abs(dot(one, "C.found") - dot(mirrored, "C.found")) < 1e-12
    # The instant axis is the same line; which end is called I goes with the assembly.
    assert abs(dot(one, "I.found") + dot(mirrored, "I.found")) < 1e-12


@poses
@assemblies
def test_the_axes_turned_into_the_paper_stay_with_their_angles(angle: int, assembly: str):
    """They are parallel to the vectors for which they serve, at their angles in space from OI."""
    pose, here = motion(angle, assembly), sheet(angle, assembly)
    views, polygon = here.panel("position"), here.panel("velocity")
    i, at = pose.point("I").position, dot(views, "I.found")
    again = here.panel("acceleration")
    for letter, ends in (("B", "23"), ("C", "43")):
        shape = stroke(views, f"O{letter}.laid").shape
        assert isinstance(shape, Curve)
        outer, _, inner = shape.points
        assert inner == 0 and abs(outer) == pytest.approx(1.0)
        for found in (vector(each, f"{ends}.relative") for each in (polygon, again)):
            assert (outer * found.conjugate()).imag == pytest.approx(0.0, abs=1e-9 * abs(found))
        arc, size = (
            stroke(views, f"O{letter}.arc"),
            math.degrees(math.acos(pose.point(letter).position @ i)),
        )
        assert isinstance(arc.shape, Arc) and abs(arc.shape.sweep) == pytest.approx(size, abs=1e-6)
        turned = arc.shape.start + arc.shape.sweep
        assert cmath.rect(1.0, math.radians(turned)) == pytest.approx(outer)
        assert at * cmath.rect(1.0, -math.radians(arc.shape.start)) == pytest.approx(abs(at))
        assert arc.label == f"{size:.1f}°" or arc in views.zeros
