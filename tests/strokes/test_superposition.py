"""Superposition: the polygons of each load alone, whose forces add up to those of all together."""

from __future__ import annotations

import pytest

import vad
from tests.statics.machines import MACHINES
from tests.strokes.test_forces import arrows, forces_of
from vad.errors import InputError
from vad.export.sheet_json import sheet_from_json
from vad.strokes.sheet import Arrow

NAMES = sorted(MACHINES)


def four_bar(**more):
    points = {"E": ("rocker", 350), "G": ("coupler", 400)}
    machine = vad.FourBar(ground=500, crank=400, coupler=1000, rocker=750, points=points)
    loads = ["F = 80 N @ 150 at E", "P = 60 N @ 260 at G"]
    return vad.forces(vad.solve(machine, angle=120), loads, **more)


@pytest.mark.exhaustive(48)
@pytest.mark.parametrize("name", NAMES)
def test_the_parts_add_up_to_the_forces_of_all_loads(name):
    found = forces_of(name)
    sheet = vad.draw(found, superpose=True)
    panel = sheet.panel("force")
    drawn = arrows(panel)
    names = [stroke.name for stroke in (*panel.strokes, *panel.zeros)]
    assert len(names) == len(set(names))
    outer = [half.outer for dyad in found.dyads for half in (dyad.first, dyad.second)]
    largest = max(abs(each.force) for each in outer)
    sums = {n.removesuffix(".sum"): v for n, v in drawn.items() if n.endswith(".sum")}
    assert len(sums) == len(outer)
    for (plain, whole), joint in zip(sums.items(), outer, strict=False):
        parts = [v for n, v in drawn.items() if n.startswith(f"{plain}.part")]
        assert len(parts) == len(found.superposed())
        assert abs(sum(parts) - whole) < 1e-10 * largest
        assert min(abs(whole - each.force) for each in outer) < 1e-10 * largest
        assert joint.point in plain or any(each.point in plain for each in outer)


def test_each_load_has_its_own_polygon():
    found = four_bar()
    panel = vad.draw(found, superpose=True).panel("force")
    drawn = arrows(panel)
    for number, part in enumerate(found.superposed().values(), start=1):
        force = part.force("crank", "coupler")
        assert abs(drawn[f"F23B-alone{number}.whole"] - force) < 1e-10 * abs(force)
        assert abs(drawn[f"F23B.part{number}"] - force) < 1e-10 * abs(force)
    assert abs(drawn["F23B.sum"] - found.force("crank", "coupler")) < 1e-9
    revealed = [row for stroke in panel.strokes for row in stroke.reveals]
    assert revealed == ["coupler", "rocker"]


def test_polygons_do_not_overlap():
    panel = vad.draw(four_bar(), superpose=True).panel("force")
    boxes = []
    for group in ("alone1", "alone2", "F23B.part", "F14D.part"):
        own = [s for s in panel.strokes if group in s.name and isinstance(s.shape, Arrow)]
        ends = [z for s in own for z in (s.shape.start, s.shape.end)]
        xs, ys = [z.real for z in ends], [z.imag for z in ends]
        boxes.append((min(xs), max(xs), min(ys), max(ys)))
    for number, one in enumerate(boxes):
        for other in boxes[number + 1 :]:
            apart = one[1] < other[0] or other[1] < one[0] or one[3] < other[2] or other[3] < one[2]
            assert apart


def test_the_torque_is_the_sum():
    found = four_bar()
    strokes = {s.name: s for s in vad.draw(found, superpose=True).panel("drive").strokes}
    terms = strokes["T.couple"].said.parts["terms"].addends
    assert sum(each.value for each in terms) == pytest.approx(found.drive, rel=1e-12)
    assert strokes["T.couple"].caption.startswith("T = T′ + T″ = −")


@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_it_is_said_in_every_language_and_read_back(tmp_path, language, exhaustive):
    sheet = vad.draw(four_bar(), language=language, superpose=True)
    assert all(s.caption.endswith(".") for s in sheet.panel("force").strokes)
    vad.save(sheet, tmp_path / "sheet.json")
    assert sheet_from_json((tmp_path / "sheet.json").read_text("utf-8")) == sheet
    if exhaustive or language == "de":  # which has the longest sentences
        vad.save(vad.animate(sheet), tmp_path / "lesson.html")


def test_one_load_alone_needs_no_superposition():
    found = vad.forces(vad.solve(vad.SliderCrank()), ["800 N @ 180 at C"])
    assert vad.draw(found, superpose=True) == vad.draw(found)


def test_without_loads_or_with_friction_it_is_refused():
    with pytest.raises(InputError, match="superpose: there are no loads"):
        vad.draw(vad.solve(vad.FourBar()), superpose=True)
    machine = vad.SliderCrank()
    loads = ["800 N @ 180 at C", "5 N @ 0 at B on crank"]
    found = vad.forces(vad.solve(machine), loads, friction={"slider": 0.1})
    with pytest.raises(InputError, match="with friction they are not sums"):
        vad.draw(found, superpose=True)


def test_forces_without_names_are_numbered_as_they_were_given():
    machine = vad.FourBar(points={"E": ("rocker", 40), "G": ("coupler", 50)})
    found = vad.forces(vad.solve(machine), ["80 N @ 150 at E", "60 N @ 260 at G"])
    sheet = vad.draw(found, superpose=True)
    loads = {s.label: s.caption for s in sheet.panel("position").strokes if s.component == "load"}
    assert loads["P₁"].startswith("P₁ = 80 N")
    assert loads["P₂"].startswith("P₂ = 60 N")
    assert [cell.symbol for cell in sheet.rows[-1].cells["force"]] == ["P₁", "P₂"]


def test_each_load_is_announced_and_each_part_says_whose_it_is():
    said = [s.caption for s in vad.draw(four_bar(), superpose=True).panel("force").strokes]
    heads = [each for each in said if " alone: " in each]
    assert [each.split(" alone: ")[0] for each in heads] == ["F", "P"]
    assert [each.split()[-2] for each in said if each.endswith(" alone.")] == ["F", "P"] * 2


def test_the_force_on_a_driven_slide_is_the_sum():
    found = vad.forces(
        vad.solve(vad.DoubleSlider()), ["80 N @ 150 at B", "60 N @ 260 at A on link"]
    )
    strokes = vad.draw(found, superpose=True).panel("drive").strokes
    said = next(s.said for s in strokes if s.name == "drive.action")
    assert sum(each.value for each in said.parts["terms"].addends) == pytest.approx(found.drive)
    assert str(said).startswith("Fₐ = Fₐ′ + Fₐ″ = ")
