"""The spatial four-bar on the board: its views and polygons say what the solver finds."""

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
from vad.export.sheet_json import to_text
from vad.kinematics.reach import closing_range
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import scene_of
from vad.strokes.scripts.spatial_four_bar import PICTORIAL
from vad.strokes.sheet import Arc, Curve, Line, Panel, Sheet
from vad.words import Language, languages

pytestmark = pytest.mark.exhaustive

ANGLES = [*range(0, 360, 30), 77, 341]
TWIST = math.radians(60.0)
A, D = (cmath.exp(1j * (-math.pi / 2 + side * TWIST / 2)) for side in (-1, 1))

poses = pytest.mark.parametrize("angle", ANGLES)


@cache
def motion(angle: float, alpha: float = 0.0) -> Any:
    return vad.solve(vad.SpatialFourBar(), angle=angle, omega=10.0, alpha=alpha)


@cache
def sheet(angle: float, alpha: float = 0.0, code: str = "en") -> Sheet:
    return vad.draw(motion(angle, alpha), language=code)


def line(panel: Panel, name: str) -> Line:
    shape = stroke(panel, name).shape
    assert isinstance(shape, Line)
    return shape


def curve(panel: Panel, name: str) -> tuple[complex, ...]:
    shape = stroke(panel, name).shape
    assert isinstance(shape, Curve)
    return shape.points


def instant_axis(here: Any) -> complex:
    """Return the unit vector along I as it is seen along DA."""
    _, y, z = (part.real for part in here.solver.axis(here.pose).i)
    return cmath.exp(-1j * (math.pi + TWIST) / 2) * complex(z, -y)


def motion_of_a(here: Any) -> tuple[list[tuple[float, float]], list[tuple[float, float]]]:
    """Return what the dual numbers say of A and of ω, α: along I and across it, by their order.

    Of the acceleration of A, what is due to the turning of I is left out.
    """
    axis = here.solver.axis(here.pose)
    pace = here.solver.axis_velocity(here.pose, here.velocity)
    grown = here.solver.axis_acceleration(here.pose, here.acceleration)
    omega, tau, h = pace.omega, pace.tau, axis.height
    sliding = [(omega.dual, omega.real * h), (grown.dual, grown.real * h + omega.real * tau.dual)]
    return sliding, [(omega.real, 0.0), (grown.real, omega.real * tau.real)]


def test_the_example_of_the_notes():
    cells = {
        (row.letters, cell.symbol): cell.value
        for row in sheet(60.0).rows
        for each in row.cells.values()
        for cell in each
    }
    wanted = {
        ("I", "τ"): -17.3,
        ("I", "AH"): 37.16,
        ("I", "ω₄₂"): -8.877,
        ("I", "v₄₂"): -386.9,
        ("I", "α₄₂ₜ"): 14.76,
        ("I", "v̇₄₂"): -3698.0,
        ("D", "θ₄"): 67.6,
        ("D", "s_D"): -25.24,
        ("D", "ω₄"): 3.050,
        ("D", "ṡ_D"): -406.8,
        ("D", "α₄"): 67.19,
        ("D", "s̈_D"): 1918.0,
    }
    for key, value in wanted.items():
        assert cells[key] == pytest.approx(value, rel=2e-3), key
    said = " ".join(s.caption for half in sheet(60.0).halves for s in half.strokes)
    for number in (
        "s_B = 54.97",
        "s_C = −28.80",
        "329.9",
        "305.0",
        "65.55",
        "3755",
        "490.1",
        "ḣ = 6.594",
        "6719",
    ):
        assert number in said, number


def test_strokes_have_the_same_names_in_every_pose():
    names: dict[str, set[frozenset[str]]] = {}
    for angle in ANGLES:
        for half in sheet(angle).halves:
            own = [s.name for s in (*half.strokes, *half.zeros)]
            assert len(own) == len(set(own))
            names.setdefault(half.name, set()).add(frozenset(own))
    assert all(len(found) == 1 for found in names.values())
    assert [*names] == [
        "position",
        "velocity",
        "velocity.below",
        "acceleration",
        "acceleration.below",
    ]


@poses
def test_both_polygons_have_the_same_two_construction_lines(angle: float):
    for name in ("velocity", "acceleration"):
        upper = sheet(angle).panel(name)
        assert upper.below and upper.unit != upper.below.unit
        for letter in "ID":
            ways = [line(half, f"{letter}.line").direction for half in upper.halves]
            assert abs((ways[0] * ways[1].conjugate()).imag) < 1e-12
        assert abs((line(upper, "D.line").direction * D.conjugate()).imag) < 1e-12
        for half in upper.halves:
            i, d = line(half, "I.line"), line(half, "D.line")
            assert i.until == pytest.approx(d.until, rel=1e-9)


@poses
@pytest.mark.parametrize("alpha", [0.0, 40.0])
def test_the_polygons_are_those_of_the_motion(angle: float, alpha: float):
    here, drawn = motion(angle, alpha), sheet(angle, alpha)
    sliding, turning = motion_of_a(here)
    omega, acceleration = drawn.panel("velocity"), drawn.panel("acceleration")
    assert vector(omega, "12") == pytest.approx(10.0 * A)
    assert vector(omega, "14") == pytest.approx(here.link("rocker").omega * D)
    assert vector(omega, "12") + vector(omega, "24") == pytest.approx(vector(omega, "14"))
    assert vector(acceleration, "14") == pytest.approx(here.link("rocker").alpha * D)
    turned = vector(acceleration, "12") + vector(acceleration, "24.normal")
    assert turned + vector(acceleration, "24") == pytest.approx(vector(acceleration, "14"))
    slide = here.slide("slide_d")
    for order, upper, slid in ((1, omega, slide.velocity), (2, acceleration, slide.acceleration)):
        below, i = upper.below, instant_axis(here)
        rocker = here.link("rocker")
        assert below is not None
        assert vector(below, "dz") == pytest.approx(
            (rocker.omega, rocker.alpha)[order - 1] * 100.0 * 1j * D
        )
        assert vector(below, "za4") == pytest.approx(slid * D)
        # What the dual numbers of the solver say of I closes the same polygon.
        along, across = sliding[order - 1]
        known = "ay" if order == 1 else "xy"
        assert vector(below, known) == pytest.approx(across * 1j * i, rel=1e-9, abs=1e-6)
        assert vector(below, "ya4") == pytest.approx(along * i, rel=1e-9, abs=1e-6)
        along, across = turning[order - 1]
        assert vector(upper, "24") == pytest.approx(along * i, rel=1e-9)
        if order == 2:
            assert vector(upper, "24.normal") == pytest.approx(across * 1j * i, rel=1e-9)
            velocity = omega.below
            assert velocity is not None
            whole = vector(velocity, "ay") + vector(velocity, "ya4")
            pace = here.solver.axis_velocity(here.pose, here.velocity).tau.real
            assert vector(below, "ax") == pytest.approx(pace * 1j * whole, rel=1e-9)


@poses
def test_what_is_called_a_derivative_is_one(angle: float):
    """v̇₄₂ is the derivative of v₄₂, and ḣ that of AH, as they are found at other moments."""
    step, (before, here, after) = 1e-6, (sheet_at(angle, by) for by in (-1e-6, 0.0, 1e-6))

    def found(drawn: Sheet, symbol: str) -> float:
        cells = (cell for row in drawn.rows for each in row.cells.values() for cell in each)
        return next(float(cell.value) for cell in cells if cell.symbol == symbol)

    said: Any = stroke(here.halves[-1], "xy").said
    rising = next(said.figures(("rising",))).value
    for symbol, rate in (("v₄₂", found(here, "v̇₄₂")), ("AH", rising)):
        change = found(after, symbol) - found(before, symbol)
        assert rate == pytest.approx(change / (2.0 * step), rel=1e-5, abs=1e-3), symbol


def sheet_at(angle: float, seconds: float) -> Sheet:
    """Return what is drawn so much later, as the crank goes on with ω = 10 and α = 40 rad/s²."""
    further = math.degrees(10.0 * seconds + 20.0 * seconds * seconds)
    omega = 10.0 + 40.0 * seconds
    return vad.draw(vad.solve(vad.SpatialFourBar(), angle=angle + further, omega=omega, alpha=40.0))


@poses
def test_the_view_shows_the_loop(angle: float):
    here, panel = motion(angle), sheet(angle).panel("position")
    places = {letter: here.point(letter).position for letter in "ABCD"}
    assert dot(panel, "A.fixed") == pytest.approx(0.0)
    assert dot(panel, "D.fixed") == pytest.approx(complex(PICTORIAL.way(places["D"])))
    assert dot(panel, "C.found") == pytest.approx(complex(PICTORIAL.way(places["C"])))
    assert vector(panel, "AB.crank") == pytest.approx(complex(PICTORIAL.way(places["B"])))
    b, c, d = (at[1] - at[0] for at in (curve(panel, f"{letter}.slide") for letter in "BCD"))
    coupler, rocker = curve(panel, "BC.coupler"), curve(panel, "DC.rocker")
    first = vector(panel, "AB.crank") + b + coupler[2] - coupler[1]
    second = complex(PICTORIAL.way(places["D"])) + d + rocker[1] - rocker[2] + c
    assert first == pytest.approx(second)
    # H is on AD, and star and rose stand above all of it.
    height = here.solver.axis(here.pose).height
    assert dot(panel, "H.found") == pytest.approx(
        height / 100.0 * complex(PICTORIAL.way(places["D"]))
    )
    low = min(z.imag for name in ("star.A", "star.D", "star.I") for z in curve(panel, name))
    assert low > max(z.imag for z in (*coupler, *rocker, dot(panel, "C.found")))


@poses
def test_i_is_where_the_planes_of_frame_and_coupler_meet(angle: float):
    here, panel = motion(angle), sheet(angle).panel("position")
    start, end = curve(panel, "star.I")
    axes = here.solver.moving_axes(here.pose)
    b, c = (np.array([float(part.real) for part in axis]) for axis in axes)
    way = (end - start) / abs(end - start) * cmath.exp(1j * (math.pi / 2 + TWIST / 2))
    i = np.array([0.0, -way.imag, way.real])
    assert np.linalg.det([b, c, i]) == pytest.approx(0.0, abs=1e-9)


@poses
def test_the_rate_at_which_oi_turns_follows_from_what_the_star_shows(angle: float):
    views, polygon = (sheet(angle).panel(name) for name in ("position", "acceleration"))
    told: Any = stroke(views, "star.O").said
    delta, tau, ib, ic = (
        math.radians(next(told.figures((each,))).value) for each in ("delta", "tau", "ib", "ic")
    )
    said: Any = stroke(polygon, "24.normal").said
    pace, omega, signed = (
        next(said.figures((each,))).value for each in ("pace", "omega", "signed")
    )
    cell = next(
        cell for row in sheet(angle).rows for cell in row.cells["velocity"] if cell.symbol == "ω₄₂"
    )
    assert omega == pytest.approx(abs(cell.value))
    twist = math.radians(55.0)
    along = cell.value * math.sin(ib) * math.sin(ic) / math.sin(twist)
    wanted = (along - 10.0 * math.sin(tau) * math.cos(delta)) / math.sin(delta)
    assert pace == pytest.approx(abs(wanted))
    assert signed == pytest.approx(wanted)
    # B and C are seen on circles about OA and OD.
    centre, (_, a), (_, d) = (
        dot(views, "star.O"),
        curve(views, "star.A"),
        curve(views, "star.D"),
    )
    for letter, start, arc in (("B", a, 30.0), ("C", d, 45.0)):
        way, axis = curve(views, f"star.{letter}")[0] - centre, start - centre
        cosine = (way * axis.conjugate()).real / abs(axis) ** 2
        assert cosine == pytest.approx(math.cos(math.radians(arc)))


def test_tracks_of_a_whole_turn_are_the_vertices_of_its_poses():
    angles = np.array(ANGLES, dtype=float)
    many = vad.solve(vad.SpatialFourBar(), angle=angles, omega=10.0, alpha=40.0)
    for name in ("position", "velocity", "acceleration"):
        tracks = DIAGRAMS[name].tracks(scene_of(many, Language("en")))
        for number, angle in enumerate(ANGLES):
            own = DIAGRAMS[name].tracks(scene_of(motion(angle, 40.0), Language("en")))
            assert own.keys() == tracks.keys()
            for letter, at in own.items():
                here = np.broadcast_to(tracks[letter], angles.shape)[number]
                assert here == pytest.approx(complex(at), rel=1e-7, abs=1e-7), (name, letter)


@pytest.mark.parametrize("code", languages())
def test_captions_are_sentences(code: str):
    for angle in ANGLES[::4]:
        for half in sheet(angle, 40.0, code).halves:
            for each in half.strokes:
                assert re.fullmatch(r".*[^\s.,;:]\.", each.caption), each.caption
                assert not re.search(r"[{}\x02\x03]|\s[.,]| {2}", each.caption), each.caption


@poses
def test_printed_products_and_sums_hold(angle: float):
    for half in sheet(angle, 40.0).halves:
        for each in half.strokes:
            found = re.search(r"= ([−\d.]+(?: [×+−] [−\d.]+)+) = ([−\d.]+) ", each.caption)
            if not found:
                continue
            sums, result = (text.replace("−", "-").replace("×", "*") for text in found.groups())
            digits = len(result.partition(".")[2])
            value = eval(sums)  # numbers and signs alone, as matched
            assert abs(value - float(result)) <= 0.5 * 10.0**-digits + 1e-9, each.caption


def test_what_does_not_slide_is_not_drawn():
    # Bennett's linkage: a/sin α alike, opposite links alike.
    other = 80.0 * math.sin(math.radians(30.0)) / math.sin(math.radians(50.0))
    bennett: dict[str, Any] = {
        "ground": 80.0,
        "crank": other,
        "coupler": 80.0,
        "rocker": other,
        "ground_twist": 50.0,
        "crank_twist": 30.0,
        "coupler_twist": 50.0,
        "rocker_twist": 30.0,
        "assembly": "crossed",
    }
    drawn = vad.draw(vad.solve(vad.SpatialFourBar(**bennett), angle=70.0, omega=10.0))
    panel = drawn.panel("position")
    assert {stroke.name for stroke in panel.zeros} == {"B.slide", "C.slide", "D.slide"}
    labels = [term.label for each in panel.equations for term in (*each.left, *each.right)]
    assert labels == ["AB", "BC", "AD", "DC"]
    below = drawn.panel("velocity").below
    assert below is not None and "za4" in {stroke.name for stroke in below.zeros}


def test_a_mechanism_that_swings_by_a_few_degrees_is_drawn():
    narrow = vad.SpatialFourBar(ground_twist=60, crank_twist=50, coupler_twist=1, rocker_twist=73)
    low, high = closing_range(narrow)[0]
    assert 7.5 * math.floor(low / 7.5) < low < high < 7.5 * math.ceil(low / 7.5)
    panel = vad.draw(vad.solve(narrow, angle=(low + high) / 2)).panel("position")
    assert all(math.isfinite(abs(z)) for z in curve(panel, "DC.rocker"))


def test_at_rest_there_are_two_poles():
    still = vad.draw(vad.solve(vad.SpatialFourBar(), angle=60.0, omega=0.0, alpha=0.0))
    for name in ("velocity", "acceleration"):
        for half in still.panel(name).halves:
            assert [each.name for each in half.strokes] == ["pole"]
            assert not half.equations
    poles = [half.strokes[0].label for half in still.halves[1:]]
    assert poles == ["1,2,4", "a,d,y,z,a₄", "1′,2′,4ₙ,4′", "a′,d′,x′,y′,z′,a′₄"]


def test_a_sheet_comes_back_from_its_json():
    drawn = sheet(77.0, 40.0)
    assert vad.sheet_from_json(to_text(drawn)) == drawn


@pytest.mark.parametrize("lesson", [False, True])
@pytest.mark.parametrize("angle", ANGLES[::3])
def test_no_label_stands_on_a_stroke_or_on_another(angle: float, lesson: bool):
    assert overlaps(sheet(angle), lesson=lesson) == []


@poses
def test_the_star_is_large_and_has_its_angles(angle: float):
    views = sheet(angle).panel("position")
    joints = [dot(views, f"{letter}.fixed") for letter in "AD"]
    rays = {letter: curve(views, f"star.{letter}") for letter in "ADI"}
    ways = {letter: (end - start) for letter, (start, end) in rays.items()}
    assert all(abs(way) > 0.5 * abs(joints[1] - joints[0]) for way in ways.values())
    shape = stroke(views, "star.tau").shape
    assert isinstance(shape, Arc)
    turned = cmath.phase(ways["I"] / ways["A"])
    assert math.radians(shape.sweep) == pytest.approx(turned, abs=1e-9)
    assert cmath.rect(1.0, math.radians(shape.start)) == pytest.approx(ways["A"] / abs(ways["A"]))
