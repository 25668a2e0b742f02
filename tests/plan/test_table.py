"""Results on the two-by-two page: whatever the numbers, no column touches another."""

from __future__ import annotations

from itertools import combinations

import pytest

import vad
from vad.plan.board import plan
from vad.plan.format import screen
from vad.plan.lettering.glyphs import typeset, width
from vad.plan.lettering.runs import plain, roman
from vad.plan.marks import Lettering
from vad.plan.page.quarter import after_point
from vad.plan.page.table import table
from vad.strokes.description import describe
from vad.strokes.sheet import Sheet
from vad.style import load_style

pytestmark = pytest.mark.exhaustive

SIZE = (1024, 768)


def fourbar(scale: float, language: str) -> Sheet:
    mechanism = vad.FourBar(
        ground=scale, crank=0.4123 * scale, coupler=1.2 * scale, rocker=0.8 * scale
    )
    motion = vad.solve(mechanism, angle=250, omega=scale, alpha=-2e-4 * scale)
    return vad.draw(motion, language=language)


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("style", ["paper", "print"])
@pytest.mark.parametrize("scale", [1e-3, 1e-9, 1e3, 1e9, 1.0])
def test_columns_never_touch(scale: float, style: str, language: str):
    board = plan(fourbar(scale, language), screen(SIZE), load_style(style).key, lesson=True)
    for beat in range(board.finished + 1):
        texts = [
            mark.shape
            for item in board.shown(beat)
            if item.region == "results"
            for mark in item.marks
            if isinstance(mark.shape, Lettering)
        ]
        boxes = [ink_box(text) for text in texts]
        for a, b in combinations(boxes, 2):
            gap = 0.01 if abs(a[1] - b[1]) < 0.016 else 0.0
            apart = a[2] + gap < b[0] or b[2] + gap < a[0] or a[3] < b[1] or b[3] < a[1]
            assert apart, (a, b)
        assert min(text.size for text in texts) > 0.018
        assert min(box[0] for box in boxes) >= board.page.left - 1e-9


def ink_box(text: Lettering) -> tuple[float, float, float, float]:
    shape, size, x, y = typeset(text.runs), text.size, text.at.real, text.at.imag
    return (
        x + size * shape.left,
        y + size * shape.bottom,
        x + size * shape.right,
        y + size * shape.top,
    )


COLUMNS = {
    "lever": (vad.CrankSlottedLever(rod=100, ram_height=180), {"angle": 40, "alpha": 20}),
    "trammel": (vad.EllipticalTrammel(), {"omega": "600 rpm"}),
    "double": (vad.DoubleSlider(), {"position": 990, "velocity": -2000}),
    "gate": (vad.GateActuator(), {}),
    "hooke": (vad.HookeJoint(), {}),
    "four-bar": (vad.FourBar(), {"omega": 1e-9, "alpha": 123456.7}),
}


@pytest.mark.parametrize("size", [(1280, 720), (1024, 768)])
@pytest.mark.parametrize("name", COLUMNS)
def test_decimal_points_stand_one_below_the_other(name, size):
    """Of the first numbers of a column; and no number leaves its column."""
    mechanism, inputs = COLUMNS[name]
    sheet = vad.draw(vad.solve(mechanism, **inputs))
    form, key = screen(size), load_style("paper").key
    board = plan(sheet, form, key)
    laid = table(sheet, board.page, key)
    wide = {place.drawing.width for place in board.page.panels.values()}
    beneath = board.page.results or len(wide) == 1
    for panel in sheet.panels:
        points: dict[tuple[str, bool], set[float]] = {}
        for index, row in enumerate(sheet.rows):
            entries = laid.cells(index, row, panel.name, False)
            for place, (cell, entry) in enumerate(zip(row.cells[panel.name], entries, strict=True)):
                number = entry.number.shape
                assert isinstance(number, Lettering)
                texts = [number, *(m.shape for m in entry.symbol if isinstance(m.shape, Lettering))]
                area = board.page.results or board.page.panels[panel.name].drawing
                if beneath:
                    assert max(ink_box(text)[2] for text in texts) <= area.right + 1e-9
                if place == 0:
                    ahead = width(number.runs, number.size) - after_point(number.runs, number.size)
                    head = cell.unit if board.page.results else ""
                    # Two halves of a table have columns of their own.
                    halves = board.page.columns and board.page.results is not None
                    right = halves and number.at.real > board.page.width / 2
                    points.setdefault((head, right), set()).add(round(number.at.real + ahead, 9))
        assert all(len(found) <= 1 for found in points.values()), (panel.name, points)


@pytest.mark.parametrize("turns", [{}, {"ω₄": -1.0, "α₄": 1.0}])
@pytest.mark.parametrize("name", ["whitworth", "four-bar"])
def test_the_head_of_a_column_stands_above_its_numbers(name, turns):
    """Its middle is above theirs, however long a given number is; round arrows do not count."""
    mechanism = vad.Whitworth(rod=300) if name == "whitworth" else vad.FourBar()
    sheet = vad.draw(vad.solve(mechanism, angle=60.123456, omega=6.2831853, alpha=20.0))
    key = load_style("paper").key
    laid = table(sheet, plan(sheet, screen(SIZE), key).page, key, turns=turns)
    notes = [mark.shape for mark in laid.frame() if mark.role == "notes"]
    heads = [(ink_box(text), plain(text.runs)) for text in notes if isinstance(text, Lettering)]
    for panel in sheet.panels:
        columns: dict[str, list[tuple[float, float]]] = {}
        for index, row in enumerate(sheet.rows):
            [cell, *_], [entry, *_] = (
                row.cells[panel.name],
                laid.cells(index, row, panel.name, False),
            )
            number = entry.number.shape
            assert isinstance(number, Lettering)
            bare = roman(plain(number.runs).partition("\N{NO-BREAK SPACE}")[0])
            left = number.at.real
            end = left + width(bare, number.size)
            columns.setdefault(cell.unit, []).append((left, end))
        for unit, ends in columns.items():
            first, last = min(left for left, _ in ends), max(right for _, right in ends)
            boxes = [box for box, text in heads if text.endswith(f", {unit}")]
            [box] = [box for box in boxes if box[0] < last and box[2] > first]
            slack = max(0.0, (box[2] - box[0] - last + first) / 2) + 0.003
            assert abs(box[0] + box[2] - first - last) / 2 < slack, (panel.name, unit)


def test_a_rate_is_printed_as_it_was_typed():
    sheet = vad.draw(vad.solve(vad.EllipticalTrammel(), omega="600 rpm"))
    assert "ω₂ = 600 rpm (given)" in describe(sheet) and "v_A = 10.88 m/s" in describe(sheet)


def test_several_numbers_with_one_unit_share_it_where_there_is_no_room_for_all():
    sheet = vad.draw(vad.solve(vad.HookeJoint()))
    key = load_style("paper").key
    laid = table(sheet, plan(sheet, screen((1280, 720)), key).page, key)
    entries = laid.cells(1, sheet.rows[1], "velocity", False)
    texts = ["".join(run.text for run in entry.number.shape.runs) for entry in entries]
    assert [text.endswith("rad/s") for text in texts] == [False, False, True]


def test_a_number_that_is_the_name_of_a_shaft_stands_once():
    sheet = vad.draw(vad.solve(vad.HookeJoint()))
    assert {row.cells["velocity"][0].body for row in sheet.rows} >= {"2", "4"}
    page = plan(sheet, screen((960, 720)), load_style("paper").key)
    marks = [mark.shape for item in page.items for mark in item.marks if mark.role == "words"]
    words = {"".join(run.text for run in each.runs) for each in marks}
    assert {"driving shaft 2", "driven shaft 4"} <= words
