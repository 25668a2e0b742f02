"""Sheets from which a student measures: what a ruler finds in the file is what the panel states."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import vad
from tests.painting.readers import centres, media_box, operations, pdf_catalog, pdf_text
from vad.errors import UsageError
from vad.painting.posed import posed
from vad.plan.format import paper_names
from vad.plan.reach import corners
from vad.strokes.sheet import Arrow, Sheet

pytestmark = pytest.mark.exhaustive

MILLIMETRE = 72 / 25.4
#: A hundredth of a millimetre, in points.
EXACT = 0.01 * MILLIMETRE
SIZES = {"A4": (297, 210), "A3": (420, 297), "letter": (279.4, 215.9)}
MANTISSAS = (1.0, 2.0, 2.5, 5.0)


def sheet_of(name: str) -> Sheet:
    mechanism = vad.MECHANISMS[name]()
    return vad.draw(vad.solve(mechanism))


@pytest.mark.parametrize("paper", paper_names())
def test_the_page_is_the_paper(folder: Path, paper: str) -> None:
    vad.save(sheet_of("four-bar"), "sheet.pdf", paper=paper)
    left, bottom, right, top = media_box(Path("sheet.pdf").read_bytes())
    size = (right - left) / MILLIMETRE, (top - bottom) / MILLIMETRE
    name, _, upright = paper.partition("-")
    wanted = SIZES[name][::-1] if upright else SIZES[name]
    assert size == pytest.approx(wanted, abs=0.01)


@pytest.mark.parametrize("panel", ["position", "velocity", "acceleration"])
@pytest.mark.parametrize("name", ["slider-crank", "crank-slotted-lever", "gate-actuator"])
def test_a_ruler_finds_every_vector_as_long_as_it_is(folder: Path, name: str, panel: str) -> None:
    sheet = sheet_of(name)
    vad.save(sheet, "sheet.pdf", paper="A4")
    data = Path("sheet.pdf").read_bytes()
    dots = centres(data)
    place = [each.name for each in sheet.panels].index(panel)
    stated = re.findall(r"1 cm = (\S+) ", pdf_text(data))[place]
    points_per_unit = 10 * MILLIMETRE / float(stated)
    arrows = [s.shape for s in sheet.panel(panel).strokes if isinstance(s.shape, Arrow)]
    assert arrows
    for arrow in arrows:
        true = (arrow.end - arrow.start) * points_per_unit
        assert any(abs(b - a - true) < EXACT for a in dots for b in dots)


@pytest.mark.parametrize("paper", paper_names())
@pytest.mark.parametrize("name", vad.MECHANISMS)
def test_scales_are_round_and_polygons_fit(name: str, paper: str) -> None:
    sheet = sheet_of(name)
    board = posed(sheet, paper=paper).board
    assert board.form.centimetre is not None
    for panel in sheet.panels:
        scale = board.sketches[panel.name].scale
        mantissa = float(f"{board.form.centimetre / scale.factor:.12e}".partition("e")[0])
        assert mantissa in MANTISSAS
        drawing = board.page.panels[panel.name].drawing
        assert all(drawing.holds(scale(point)) for point in corners(panel))


def test_the_bar_beside_the_statement_is_a_centimetre(folder: Path) -> None:
    vad.save(sheet_of("slider-crank"), "sheet.pdf", paper="A4")
    steps = operations(Path("sheet.pdf").read_bytes())
    lengths = [
        float(end[0]) - float(start[0])
        for (start, move), (end, line), (_, paint) in zip(steps, steps[1:], steps[2:], strict=False)
        if (move, line, paint) == ("m", "l", "S") and start[1] == end[1]
    ]
    assert sum(abs(length - 10 * MILLIMETRE) < EXACT for length in lengths) == 3


def test_a_length_has_its_ratio(folder: Path) -> None:
    vad.save(sheet_of("slider-crank"), "sheet.pdf", paper="A4")
    written = pdf_text(Path("sheet.pdf").read_bytes())
    assert "1 cm = 20 mm   (1 : 2)" in written
    vad.save(sheet_of("gate-actuator"), "sheet.pdf", paper="A4")
    written = pdf_text(Path("sheet.pdf").read_bytes())
    assert "1 cm = 0.5 ft\n" in written


def test_the_edge_has_the_background_too(folder: Path) -> None:
    vad.save(sheet_of("scotch-yoke"), "sheet.pdf", paper="A4", style="chalk")
    data = Path("sheet.pdf").read_bytes()
    first = next(index for index, (_, operator) in enumerate(operations(data)) if operator == "m")
    ground = [[float(value) for value in values] for values, _ in operations(data)[first:][:4]]
    left, bottom, right, top = media_box(data)
    assert ground == [[left, bottom], [right, bottom], [right, top], [left, top]]


def test_it_prints_in_true_size(folder: Path) -> None:
    vad.save(sheet_of("scotch-yoke"), "sheet.pdf", paper="A4")
    catalog = pdf_catalog(Path("sheet.pdf").read_bytes())
    assert catalog["/ViewerPreferences"]["/PrintScaling"] == "/None"


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("sheet.png", {"paper": "A4"}, "paper: .png has no such option"),
        ("sheet.json", {"paper": "A4"}, "paper: .json has no such option"),
        ("sheet.pdf", {"paper": "A44"}, "unknown paper 'A44'"),
        ("sheet.pdf", {"paper": "A4", "size": (1280, 720)}, "paper: not for a picture with a size"),
    ],
)
def test_what_cannot_be(folder: Path, name: str, options: dict[str, object], message: str) -> None:
    with pytest.raises(UsageError, match=re.escape(message)):
        vad.save(sheet_of("scotch-yoke"), name, **options)
    assert not list(folder.iterdir())


def test_a_step_of_a_lesson_has_no_scale(folder: Path) -> None:
    still = vad.still(vad.animate(sheet_of("scotch-yoke")), 3)
    with pytest.raises(UsageError, match="paper: not for a step of a lesson"):
        vad.save(still, "step.pdf", paper="A4")


@pytest.mark.parametrize("name", ["slider-crank", "crank-slotted-lever", "gate-actuator"])
def test_measured_lengths_are_those_of_the_drawing(folder: Path, name: str) -> None:
    sheet = sheet_of(name)
    vad.save(sheet, "sheet.pdf", paper="A4")
    data = Path("sheet.pdf").read_bytes()
    found = re.findall(r"(\d+\.\d\d) cm × ([\d.]+) = ([\d.]+) (\w+/s2?)", pdf_text(data))
    drawn = [stroke for panel in sheet.panels[1:] for stroke in panel.strokes]
    vectors = [stroke.shape for stroke in drawn if stroke.reveals]
    assert len(found) == len(vectors) > 1
    dots = centres(data)
    for (read, scale, result, _), vector in zip(found, vectors, strict=True):
        assert float(read) * float(scale) == pytest.approx(float(result), rel=1e-9)
        length = abs(vector.end - vector.start)
        assert float(read) * float(scale) == pytest.approx(length, abs=0.0051 * float(scale))
        apart = [abs(a - b) / (10 * MILLIMETRE) for a in dots for b in dots]
        assert min(abs(each - float(read)) for each in apart) < 0.006


def test_on_a_screen_nothing_is_measured_with_a_ruler(folder: Path) -> None:
    vad.save(sheet_of("slider-crank"), "sheet.pdf")
    assert " cm ×" not in pdf_text(Path("sheet.pdf").read_bytes())


def test_a_problem_does_not_say_what_was_measured(folder: Path) -> None:
    vad.save(sheet_of("slider-crank"), "problem.pdf", paper="A4", blank="velocity")
    assert pdf_text(Path("problem.pdf").read_bytes()).count(" cm ×") == 2
