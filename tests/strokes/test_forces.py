"""Force polygons: vertices give the solver's forces back, for every mechanism of the plane."""

from __future__ import annotations

import math
import re

import pytest

import vad
from tests.statics.machines import MACHINES, burden
from tests.statics.test_equilibrium import pose
from vad.errors import InputError, UsageError
from vad.export.sheet_json import sheet_from_json
from vad.strokes.draw import scene_of
from vad.strokes.forces import DyadEquation
from vad.strokes.sheet import Arrow
from vad.words import Language

NAMES = sorted(MACHINES)
#: Of the largest force.
CLOSE = 2e-12


def forces_of(name, seed=8, place=0.37, friction=0.0):
    machine = MACHINES[name]()
    motion, given = pose(machine, place), burden(machine, seed)
    blocks = [each.other for each in vad.forces(motion).bodies.joints if each.slide]
    rough = dict.fromkeys(blocks, friction) if friction else None
    return vad.forces(motion, **given, friction=rough)


def arrows(panel):
    """The vectors of the strokes, drawn or left out, by name."""
    return {
        stroke.name: stroke.shape.end - stroke.shape.start
        for stroke in (*panel.strokes, *panel.zeros)
        if isinstance(stroke.shape, Arrow)
    }


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("friction", [0.0, 0.05])
def test_the_vertices_give_the_forces_back(name, friction):
    found = forces_of(name, friction=friction)
    try:
        dyads = found.dyads
    except InputError as error:
        pytest.skip(str(error))
    panel = vad.draw(found, panels="force").panel("force")
    drawn = arrows(panel)
    outer = [half.outer for dyad in dyads for half in (dyad.first, dyad.second)]
    largest = max(abs(each.force) for each in outer)
    wholes = {n.removesuffix(".whole"): v for n, v in drawn.items() if n.endswith(".whole")}
    for joint in outer:
        told = found.force(joint.one, joint.other)
        ends = [v for n, v in wholes.items() if n.endswith(joint.point)]
        assert any(abs(vector - joint.force) < CLOSE * largest for vector in ends)
        twice = [j for j in found.joints if {j.one, j.other} == {joint.one, joint.other}]
        if len(twice) == 1:
            assert abs(told - joint.force) < CLOSE * largest
    assert len(wholes) == len(outer)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_each_polygon_closes_from_tip_to_tail(name):
    found = forces_of(name)
    panel = vad.draw(found, panels="force").panel("force")
    ends = [
        (s.shape.start, s.shape.end)
        for s in panel.strokes
        if isinstance(s.shape, Arrow) and s.part.which != "whole"
    ]
    largest = max(abs(end - start) for start, end in ends)
    for start, end in ends:
        for one, others in ((start, [e for _, e in ends]), (end, [s for s, _ in ends])):
            assert min(abs(one - other) for other in others) < CLOSE * largest


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_names_are_unique_and_the_same_in_every_pose(name):
    names = []
    for place in (0.2, 0.6):
        panel = vad.draw(forces_of(name, place=place), panels="force").panel("force")
        here = sorted(stroke.name for stroke in (*panel.strokes, *panel.zeros))
        assert len(here) == len(set(here))
        names.append(here)
    assert names[0] == names[1]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_captions_are_said_in_every_language(name, language):
    sheet = vad.draw(forces_of(name), language=language)
    for stroke in sheet.panel("force").strokes:
        assert stroke.caption.endswith(".")


#: What a caption calculates: the numbers that are typed, and the one that is printed.
NUMBER = r"(\d[\d.,\s]*?(?:×10[⁻⁰¹²³⁴-⁹]+)?)"
SUMS = [
    (rf"= {NUMBER} N·m/\({NUMBER} m\) = {NUMBER} N", lambda moment, arm: moment / arm),
    (rf"= √\({NUMBER}² \+ {NUMBER}²\) = {NUMBER} N", math.hypot),
    (rf"= {NUMBER} N × {NUMBER} m = {NUMBER} N·m", lambda force, arm: force * arm),
]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_a_calculator_confirms_what_captions_say(name, language):
    sheet = vad.draw(forces_of(name), language=language)
    captions = [stroke.caption for half in sheet.halves for stroke in half.strokes]
    found = [
        (calculate, match.groups())
        for caption in captions
        for pattern, calculate in SUMS
        for match in re.finditer(pattern, caption)
    ]
    wanted = [caption for caption in captions if "√" in caption or "N m/(" in caption]
    assert len(found) >= len(wanted)
    for calculate, groups in found:
        texts = [re.sub(r"\s", "", text).replace(",", ".") for text in groups]
        if any("×" in text for text in texts):
            continue
        one, other, printed = map(float, texts)
        places = len(texts[2].partition(".")[2])
        assert abs(calculate(one, other) - printed) <= 0.5 * 10.0**-places


def press():
    return vad.draw(forces_of_press())


def forces_of_press():
    machine = MACHINES["toggle-press.toml"]()
    return vad.forces(vad.solve(machine), ["1 kN @ 0 at D"])


def test_the_last_dyad_comes_first_and_hands_on_what_it_found():
    found = forces_of_press()
    panel = vad.draw(found).panel("force")
    labels = [s.label for s in panel.strokes if isinstance(s.shape, Arrow)]
    assert labels == ["P", "F₁₆", "F₄₅", "F₅₄", "F₁₄", "F₂₃"]
    drawn = arrows(panel)
    assert drawn["F54B.load"] == pytest.approx(-drawn["F45B.normal"], abs=1e-9)
    first, second = (
        [z for s in some if isinstance(s.shape, Arrow) for z in (s.shape.start, s.shape.end)]
        for some in (panel.strokes[:6], panel.strokes[6:])
    )
    beside = max(z.real for z in first) < min(z.real for z in second)
    assert beside or min(z.imag for z in first) > max(z.imag for z in second)


def test_a_four_bar_of_the_board():
    machine = vad.FourBar(
        ground=500, crank=400, coupler=1000, rocker=750, points={"E": ("rocker", 350)}
    )
    sheet = vad.draw(vad.forces(vad.solve(machine, angle=120), ["80 N @ 150 at E"]))
    assert [panel.name for panel in sheet.panels] == ["position", "force", "drive"]
    captions = {stroke.name: stroke.caption for stroke in sheet.panel("force").strokes}
    assert captions["F14D.line"] == "F₁₄ passes through D and O, too."
    assert captions["F23B.normal"] == "F₂₃ = 47.25 N: the crank pushes the coupler."
    assert captions["F23B.line"] == "The coupler BC has two forces only: both lie along BC."
    (load,) = [s for s in sheet.panel("position").strokes if s.component == "load"]
    e = vad.solve(machine, angle=120).point("E").position
    assert load.label == "P" and load.shape.end == e
    cells = [[cell.symbol for cell in row.cells["force"]] for row in sheet.rows]
    assert cells == [[], ["F₂₃"], ["F₁₄"], ["P"]]


def test_with_two_loads_tangential_parts_follow_by_moments():
    machine = vad.FourBar(
        ground=500, crank=400, coupler=1000, rocker=750, points={"E": ("rocker", 350)}
    )
    loads = ["80 N @ 150 at E", "0.001 N @ 0 at C on rocker"]
    panel = vad.draw(vad.forces(vad.solve(machine, angle=120), loads)).panel("force")
    captions = {stroke.name: stroke.caption for stroke in panel.strokes}
    assert captions["F14D.tangential"] == (
        "Moments about C: F₁₄ₜ = 31.285 N·m/(0.7500 m) = 41.713 N, ⟂ DC."
    )


def test_the_torque_is_force_times_arm():
    machine = vad.FourBar(
        ground=500, crank=400, coupler=1000, rocker=750, points={"E": ("rocker", 350)}
    )
    found = vad.forces(vad.solve(machine, angle=120), ["80 N @ 150 at E"])
    panel = vad.draw(found).panel("drive")
    strokes = {stroke.name: stroke for stroke in panel.strokes}
    one, other = (strokes[name].shape for name in ("F32B.action", "F12A.action"))
    assert abs(one.end - one.start + other.end - other.start) < 1e-9
    arm = strokes["h.arm"].shape
    span = arm.end - arm.start
    assert (span.conjugate() * (one.end - one.start)).real == pytest.approx(0.0, abs=1e-6)
    size = abs(found.force("coupler", "crank"))
    assert size * abs(span) / 1000 == pytest.approx(abs(found.drive), rel=1e-12)
    assert strokes["h.arm"].caption == "h = 0.3957 m is the distance of A from this line."
    assert strokes["T.couple"].caption == (
        "T = F₃₂·h = 47.247 N × 0.39567 m = 18.69 N·m, clockwise, must act on the crank."
    )


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_the_forces_on_the_driver_are_drawn_to_scale(name):
    found = forces_of(name)
    if found.bodies.driver.scalar.kind != "angle":
        pytest.skip("a slide is driven")
    panel = vad.draw(found, panels="drive").panel("drive")
    kinds = ("load", "action")
    drawn = [s.shape.end - s.shape.start for s in panel.strokes if s.component in kinds]
    assert abs(sum(drawn)) < 1e-12 * sum(map(abs, drawn))  # the link is in equilibrium
    names = [stroke.name for stroke in (*panel.strokes, *panel.zeros)]
    assert len(names) == len(set(names))


def test_a_weight_hangs_at_its_point():
    motion = vad.solve(vad.SliderCrank(), omega=0)
    sheet = vad.draw(vad.forces(motion, masses={"slider": 2}, gravity=9.81))
    (weight,) = [s for s in sheet.panel("position").strokes if s.component == "load"]
    assert weight.label == "W₄"
    assert weight.shape.start == motion.point("C").position
    assert weight.shape.end.imag < weight.shape.start.imag


def test_a_load_on_the_driver_alone_leaves_a_dot():
    panel = vad.draw(vad.forces(vad.solve(vad.FourBar()), ["5 N @ 0 at B on crank"])).panel("force")
    assert [stroke.caption for stroke in panel.strokes] == [
        "No joint bears a force: the loads act on the driver alone."
    ]


def test_forces_without_loads_say_how_a_load_is_written():
    with pytest.raises(InputError, match="forces: there is no load") as raised:
        vad.draw(vad.solve(vad.FourBar()), panels="force")
    assert "--load '80 N @ 150 at E'" in raised.value.hint


def test_in_space_there_are_none():
    with pytest.raises(UsageError, match="does not apply to spherical-four-bar"):
        vad.draw(vad.solve(vad.SphericalFourBar()), panels="force")


def test_many_poses_are_refused():
    with pytest.raises(InputError, match="a sheet shows one pose"):
        vad.draw(
            vad.forces(vad.solve(vad.FourBar(), angle=[60.0, 70.0]), ["5 N @ 0 at C on rocker"])
        )


@pytest.mark.parametrize("ending", ["png", "svg", "pdf", "html"])
def test_formats(tmp_path, ending):
    made = vad.animate(press()) if ending == "html" else press()
    vad.save(made, tmp_path / f"press.{ending}")
    assert (tmp_path / f"press.{ending}").stat().st_size > 1000


def test_json_there_and_back(tmp_path):
    sheet = press()
    vad.save(sheet, tmp_path / "press.json")
    assert sheet_from_json((tmp_path / "press.json").read_text()) == sheet


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_every_vector_is_the_force_whose_name_it_bears(name):
    """Loads, what later dyads hand on, and both parts of outer forces, each in its sense."""
    found = forces_of(name)
    drawn = arrows(vad.draw(found, panels="force").panel("force"))
    largest = max(abs(h.outer.force) for d in found.dyads for h in (d.first, d.second))

    def has(ending, vector):
        vectors = [v for n, v in drawn.items() if n.endswith(ending)]
        return min(abs(each - vector) for each in vectors) < CLOSE * largest

    for dyad in found.dyads:
        for half in (dyad.first, dyad.second):
            point = half.outer.point
            assert has(f"{point}.tangential", half.known)
            assert has(f"{point}.normal", half.unknown)
            for load in half.loads:
                assert any(
                    has(f"{load.point}{ending}.load", load.force) for ending in ("", "-2", "-3")
                ) or any(
                    abs(v - load.force) < CLOSE * largest
                    for n, v in drawn.items()
                    if n.endswith(".load")
                )


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_the_mechanism_shows_loads_and_couples_in_their_sense(name):
    found = forces_of(name)
    panel = vad.draw(found, panels="position").panel("position")
    acting = list(enumerate(found.acting))
    arrows_of_loads = [s.shape.end - s.shape.start for s in panel.strokes if s.component == "load"]
    forces = [found.acts(n) for n, each in acting if each.point and abs(found.acts(n)) > 1e-9]
    for force in forces:
        ways = [way / abs(way) for way in arrows_of_loads]
        assert min(abs(way - force / abs(force)) for way in ways) < 1e-9
    couples = [found.acts(n) for n, each in acting if not each.point and found.acts(n)]
    sweeps = [s.shape.sweep for s in panel.strokes if s.component == "couple"]
    assert [sweep > 0.0 for sweep in sweeps] == [couple > 0.0 for couple in couples]


def test_a_moved_inertia_force_has_the_moment_of_both():
    points = {"G": ("coupler", 90, 45), "P": ("rocker", 50)}
    machine = vad.FourBar(ground=190, crank=50, coupler=150, rocker=100, points=points)
    motion = vad.solve(machine, angle=60, omega=24)
    mass = {"coupler": {"mass": 1.5, "at": "G", "inertia": 0.006}}
    found = vad.forces(motion, ["80 N @ 330 at P on rocker"], mass)
    panel = vad.draw(found).panel("position")
    (line,) = [s.shape for s in panel.strokes if s.name == "I3G.moved"]
    g = motion.point("G")
    force = -1.5 * g.acceleration / 1000
    couple = -0.006 * motion.link("coupler").alpha
    arm = (line.until - g.position) / 1000
    assert (arm.conjugate() * force).imag == pytest.approx(couple, rel=1e-12)
    assert abs(line.direction - force / abs(force)) < 1e-12
    (arc,) = [s.shape for s in panel.strokes if s.part.which == "couple"]
    assert arc.sweep * motion.link("coupler").alpha < 0.0
    names = [panel.name for panel in vad.draw(found).panels]
    assert names == ["position", "acceleration", "force", "drive"]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_the_parts_of_an_equation_lead_from_vertex_to_vertex(name):
    scene = scene_of(forces_of(name).motion, Language("en"), forces_of(name))
    for dyad in scene.force_names.dyads:
        each = DyadEquation(dyad, scene.force_names)
        for chain in each.equation.chains:
            at = each.places[chain.start]
            for part in chain.parts:
                at += -part.vector if part.reverse else part.vector
                assert abs(at - each.places[part.stage]) <= CLOSE * each.equation.longest
            assert abs(at - each.places[chain.end]) <= CLOSE * each.equation.longest


def test_the_arrow_of_a_load_on_a_yoke_is_as_long_as_the_yoke_wants():
    """Its slot and shaft reach farther than its points, and a shorter arrow would be a head."""
    for angle in (60.0, 90.0):
        load = {"name": "P", "at": "C", "force": 500.0, "angle": 180.0}
        sheet = vad.draw(vad.forces(vad.solve(vad.ScotchYoke(), angle=angle), [load]))
        position = sheet.panel("position")
        shape = position.strokes[position.number("P.load")].shape
        assert abs(shape.end - shape.start) > 0.22 * 100.0
