"""Small multiples: poses side by side at one scale, each titled by the place of its driver."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest

import vad
from tests.painting.readers import centres, pdf_text
from tests.plan.overlaps import _in_panel
from vad.errors import AssemblyError, InputError, UsageError
from vad.files.examples import example_path
from vad.lecture.moment import Moment
from vad.painting.posed import posed
from vad.plan.board import reach
from vad.plan.format import paper, screen
from vad.plan.items import Level
from vad.plan.marks import Lettering
from vad.plan.multiples_board import LOWEST, NARROWEST, NARROWEST_VIEWS, MultiplesBoard
from vad.plan.reach import corners, extent

PLACES = {
    "turn": (vad.FourBar(), (0, 60, 120, 180, 240, 300), screen((1280, 720))),
    "slide": (vad.GateActuator(), (3.3, 3.8, 4.2), screen((1024, 768))),
    "paper": (vad.SliderCrank(), (30, 60, 90), paper("A4")),
}


@cache
def board(case: str) -> MultiplesBoard:
    mechanism, at, form = PLACES[case]
    return MultiplesBoard(vad.multiples(mechanism, at), form)


def words(page: MultiplesBoard, region: str) -> list[str]:
    marks = [mark for item in page.at(Moment(0)) if item.region == region for mark in item.marks]
    shapes = [mark.shape for mark in marks if isinstance(mark.shape, Lettering)]
    return ["".join(run.text for run in shape.runs) for shape in shapes]


@pytest.mark.parametrize("case", PLACES)
def test_a_kind_of_panel_has_one_scale_and_stays_in_its_cells(case: str) -> None:
    page = board(case)
    for name in ("position", "velocity", "acceleration"):
        sketches = [found[name] for found in page.sketches]
        least = min(sketch.scale.factor for sketch in sketches)
        times = [sketch.scale.factor / least for sketch in sketches]
        assert times == pytest.approx([round(each) for each in times])
        assert {round(each) for each in times} <= ({1} if name == "position" else {1, 2, 4, 8})
        larger = [f"×{round(each):g}" for each in times if round(each) > 1]
        assert [word for word in words(page, name) if word.startswith("×")] == larger
        rooms = [sketch.setting.room for sketch in sketches]
        assert len({round(room.width, 12) for room in rooms}) == 1
        assert all(one.right < other.left for one, other in pairwise(rooms))
        for sketch in sketches:
            room = sketch.setting.room
            assert room.width >= NARROWEST * 0.999 and room.height >= LOWEST * 0.999
            points = corners(sketch.setting.panel)
            assert all(room.holds(sketch.scale(point), 1e-9) for point in points)


@pytest.mark.parametrize("case", PLACES)
def test_labels_keep_clear(case: str) -> None:
    assert [_in_panel(sketch) for found in board(case).sketches for sketch in found.values()] == [
        [] for found in board(case).sketches for _ in found
    ]


def test_a_mechanism_stands_at_the_same_place_of_every_cell() -> None:
    sketches = [found["position"] for found in board("turn").sketches]
    offsets = [sketch.scale.origin - sketch.setting.room.left for sketch in sketches]
    assert offsets == pytest.approx([offsets[0]] * len(offsets))


def test_a_small_polygon_fills_its_cell_and_says_how_much_it_is_enlarged() -> None:
    leg = vad.multiples(vad.load(example_path("jansen-leg"))(), (0, 90, 180))
    page = MultiplesBoard(leg, screen((1280, 720)))
    sketches = [found["acceleration"] for found in page.sketches]
    for sketch in sketches:
        points = [sketch.scale(z) for z in corners(sketch.setting.panel)]
        room, drawn = sketch.setting.room, extent(points)
        assert max(drawn.real / room.width, drawn.imag / room.height) > 0.3
    factors = [sketch.scale.factor for sketch in sketches]
    assert factors == pytest.approx([4 * factors[2], 4 * factors[2], factors[2]])


def test_views_have_room_for_their_notes() -> None:
    page = MultiplesBoard(vad.multiples(vad.RSSR(), (0, 90, 180), "position"), screen((960, 720)))
    for found in page.sketches:
        assert not _in_panel(found["position"])
        assert found["position"].setting.room.width >= NARROWEST_VIEWS * 0.999


def test_no_letter_stands_on_the_words_of_an_enlarged_polygon() -> None:
    bars = vad.multiples(vad.load(example_path("watt-1"))(), (0, 60, 120, 180))
    page = MultiplesBoard(bars, screen((960, 720)))
    rows = [item for item in page.at(Moment(0)) if item.level == Level.LABEL and not item.stroke]
    notes = [reach([replace(row, marks=(mark,))]) for row in rows for mark in row.marks]
    tags = [tag.box for found in page.sketches for each in found.values() for tag in each.tags]
    assert notes and tags
    for box in tags:
        for note in notes:
            aside = box.left >= note.right or box.right <= note.left
            assert aside or box.bottom >= note.top or box.top <= note.bottom


def test_titles_are_the_places_of_the_driver_as_given() -> None:
    assert words(board("turn"), "title")[2:] == [f"θ2 = {each}°" for each in range(0, 360, 60)]
    assert words(board("slide"), "title")[2:] == ["l = 3.3 ft", "l = 3.8 ft", "l = 4.2 ft"]
    assert "θ2 = −30°" in words(
        MultiplesBoard(vad.multiples(vad.FourBar(), (-30, 390), "position"), screen((640, 480))),
        "title",
    )


def test_a_row_says_its_scale_and_the_given_rate_once() -> None:
    head = words(board("turn"), "velocity")[:3]
    assert head[0] == "Velocity" and head[1].endswith(" mm/s") and head[2] == "ω2 = 10 rad/s"
    assert not any("=" in word for word in words(board("turn"), "position"))


def test_rates_are_those_of_the_pose_that_is_given() -> None:
    poses = vad.multiples(vad.solve(vad.FourBar(), angle=5, omega=-3), at=(40, 80))
    expected = vad.draw(vad.solve(vad.FourBar(), angle=80, omega=-3))
    assert poses.sheets[1] == expected


def test_scales_on_paper_are_round_and_true(folder: Path) -> None:
    poses = vad.multiples(vad.SliderCrank(), (30, 60, 90))
    vad.save(poses, "poses.pdf", paper="A4")
    data = Path("poses.pdf").read_bytes()
    stated = re.search(r"1 cm = (\S+) mm\b", pdf_text(data))
    assert stated
    rod = 140 / float(stated[1]) * 72 / 2.54
    dots = centres(data)
    assert sum(abs(abs(a - b) - rod) < 0.03 for a in dots for b in dots) >= 2 * 3


def test_every_pose_is_told_in_words(folder: Path) -> None:
    poses = vad.multiples(vad.ScotchYoke(), (30, 60), panels="velocity")
    vad.save(poses, "poses.svg")
    svg = Path("poses.svg").read_text("utf-8")
    description = svg.partition("<desc>")[2].partition("</desc>")[0]
    assert description.count("Velocity: ") == 2
    names = re.findall(r' id="([^"]*)"', svg)
    assert len(names) == len(set(names))


def test_what_stands_still_has_no_scale() -> None:
    page = MultiplesBoard(
        vad.multiples(vad.solve(vad.FourBar(), omega=0), (60, 90)), screen((640, 480))
    )
    assert words(page, "velocity")[:2] == ["Velocity", "ω2 = 0 rad/s"]


@pytest.mark.parametrize("at", [(), (30,), range(7), 30, "30,60", None])
def test_too_few_places_or_too_many(at: object) -> None:
    with pytest.raises(UsageError, match=r"^at: must be 2 to 6 places of the driver, got "):
        vad.multiples(vad.FourBar(), at)


def test_what_cannot_be() -> None:
    with pytest.raises(AssemblyError, match="the links miss"):
        vad.multiples(vad.FourBar(crank=130), (30, 10))
    with pytest.raises(InputError, match="angle"):
        vad.multiples(vad.FourBar(), (30, float("nan")))
    with pytest.raises(InputError, match="arrays of poses"):
        vad.multiples(vad.solve(vad.FourBar(), angle=[1, 2]), (30, 40))
    with pytest.raises(UsageError, match="blank: not for several poses"):
        posed(vad.multiples(vad.FourBar(), (30, 40)), blank="velocity")
