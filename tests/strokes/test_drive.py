"""The driven body alone is in equilibrium, its arm gives the torque, and powers add up to zero."""

from __future__ import annotations

import pytest

import vad
from tests.statics.machines import MACHINES
from tests.strokes.test_forces import forces_of
from vad.errors import InputError
from vad.strokes.sheet import Arc, Arrow
from vad.units import metres_of

NAMES = sorted(MACHINES)
FORCES = ("load", "action")


def drive_of(found):
    panel = vad.draw(found, panels="drive").panel("drive")
    return {stroke.name: stroke for half in panel.halves for stroke in half.strokes}


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("friction", [0.0, 0.05])
def test_the_driven_body_is_in_equilibrium(name, friction):
    found = forces_of(name, friction=friction)
    try:
        panel = vad.draw(found, panels="drive").panel("drive")
    except InputError as error:
        pytest.skip(str(error))
    drawn = [
        stroke
        for stroke in panel.strokes
        if isinstance(stroke.shape, Arrow)
        and stroke.component in FORCES
        and stroke.name != "v.check"
    ]
    vectors = [stroke.shape.end - stroke.shape.start for stroke in drawn]
    assert abs(sum(vectors)) < 1e-11 * sum(map(abs, vectors))
    if found.bodies.driver.scalar.kind == "angle":
        # All arrows have one scale, so that their moments give the torque.
        metres = metres_of(found.mechanism.length_unit) or 1.0
        pivot = found.motion.point(found.bodies.driver.joint.point).position
        scale = _scale(found, panel)
        moment = sum(
            ((s.shape.start - pivot).conjugate() * (s.shape.end - s.shape.start)).imag
            for s in drawn
        )
        moment = moment / scale * metres
        couples = [
            found.acts(n)
            for n, each in enumerate(found.acting)
            if each.body == found.bodies.driver.name and not each.point
        ]
        sizes = sum(abs(s.shape.start - pivot) * abs(s.shape.end - s.shape.start) for s in drawn)
        largest = max(sizes / scale * metres, *map(abs, couples), 1e-300)
        assert moment + sum(couples) + found.drive == pytest.approx(0.0, abs=1e-10 * largest)


def _scale(found, panel):
    """The length of an arrow for one newton, from the force in the driver's own joint."""
    driver = found.bodies.driver
    mine = [j for j in found.joints if driver.name in (j.one, j.other)]
    mine += [f for f in found.friction if driver.name in (f.one, f.other)]
    acts = [
        abs(found.acts(n))
        for n, each in enumerate(found.acting)
        if each.body == driver.name and each.point
    ]
    largest = max([*(abs(each.force) for each in mine), *acts])
    return (
        max(
            abs(s.shape.end - s.shape.start)
            for s in panel.strokes
            if isinstance(s.shape, Arrow) and s.component in FORCES
        )
        / largest
    )


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_the_polygon_of_what_slides_gives_the_drive_back(name):
    found = forces_of(name)
    if found.bodies.driver.scalar.kind == "angle":
        pytest.skip("a link is driven")
    panel = vad.draw(found, panels="drive").panel("drive.below")
    arrows = [s for s in panel.strokes if isinstance(s.shape, Arrow)]
    total = sum(s.shape.end - s.shape.start for s in arrows)
    assert abs(total) < 1e-12 * sum(abs(s.shape.end - s.shape.start) for s in arrows)
    (drive,) = [s.shape for s in arrows if s.name == "drive.sliding"]
    slide = found.bodies.driver.joint.slide
    line = found.frame.line(slide, found.motion.pose) * found.frame.turn
    assert abs(drive.end - drive.start - found.drive * line) < 1e-11 * abs(found.drive)
    assert "Fₐ" in [s.label for s in arrows]


def four_bar(**more):
    machine = vad.FourBar(
        ground=500, crank=400, coupler=1000, rocker=750, points={"E": ("rocker", 350)}
    )
    return vad.forces(vad.solve(machine, angle=120, **more), ["F = 80 N @ 150 at E"])


def test_the_power_of_the_drive_is_that_of_the_load():
    strokes = drive_of(four_bar(omega=-10))
    assert strokes["ω.check"].caption == (
        "T·ω₂ = −18.69 N·m × −10 rad/s = 186.9 W; F·v_E = −186.9 W: together zero."
    )
    assert list(strokes)[-1] == "ω.check"


def test_at_rest_there_is_no_power():
    assert "ω.check" not in drive_of(four_bar(omega=0))


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_the_powers_that_are_said_add_up_to_zero(name):
    found = forces_of(name)
    strokes = drive_of(found)
    check = strokes.get("ω.check") or strokes.get("v.check")
    assert check is not None
    parts = check.said.parts
    power, taken = parts["power"].value, parts["taken"].value
    assert power + taken == pytest.approx(0.0, abs=1e-9 * found.power[1])
    assert power == pytest.approx(parts["value"].value * parts["rate"].value, rel=1e-12)


def test_arcs_turn_as_the_torque_and_the_crank():
    for omega in (10.0, -10.0):
        found = four_bar(omega=omega)
        strokes = drive_of(found)
        assert isinstance(strokes["T.couple"].shape, Arc)
        assert strokes["T.couple"].shape.sweep * found.drive > 0.0
        assert strokes["ω.check"].shape.sweep * omega > 0.0


def test_with_more_forces_the_torque_follows_by_moments():
    machine = vad.FourBar(points={"G": ("crank", 20)})
    loads = ["30 N @ 200 at C on rocker", "20 N @ 300 at G", "M = 2 N m on crank"]
    found = vad.forces(vad.solve(machine), loads)
    strokes = drive_of(found)
    caption = strokes["T.couple"].caption
    assert caption.startswith("Moments about A: T = ")
    assert "M2-1.couple" in strokes and "h.arm" not in strokes
    terms = strokes["T.couple"].said.parts["terms"].addends
    assert sum(each.value for each in terms) == pytest.approx(found.drive, rel=1e-12)


def test_the_trammel_has_its_torque():
    found = vad.forces(vad.solve(vad.EllipticalTrammel()), ["50 N @ 30 at P"])
    strokes = drive_of(found)
    assert {"F32A.action", "F42B.action", "PP.load", "T.couple"} <= {
        name.replace("P2P", "PP") for name in strokes
    }
    assert [
        s.label for s in vad.draw(found).panel("position").strokes if s.component == "load"
    ] == ["P"]


def test_names_are_those_of_every_pose():
    for name in ("double-slider", "gate-actuator", "four-bar"):
        names = []
        for place in (0.2, 0.6):
            panel = vad.draw(forces_of(name, place=place), panels="drive").panel("drive")
            names.append(
                [sorted(s.name for s in (*half.strokes, *half.zeros)) for half in panel.halves]
            )
        assert names[0] == names[1]


def test_couples_stand_in_the_table_beside_the_torque():
    machine = vad.FourBar(points={"E": ("rocker", 40)})
    sheet = vad.draw(vad.forces(vad.solve(machine), ["P = 80 N @ 150 at E", "-6 N m on coupler"]))
    *_, row = sheet.rows
    assert [(cell.symbol, cell.value) for cell in row.cells["force"]] == [("P", 80.0)]
    ((couple,),) = (row.cells["drive"],)
    assert (couple.symbol, couple.value, couple.unit, couple.given) == ("M", -6.0, "N m", True)
