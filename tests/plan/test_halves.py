"""The results of many rows stand in two halves: nothing touches, and all is there."""

from __future__ import annotations

from importlib.resources import files
from itertools import combinations

import pytest

import vad
from tests.plan.test_table import ink_box
from vad.plan.board import Plan, plan
from vad.plan.format import screen
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.page.table import MOST
from vad.strokes.sheet import Sheet
from vad.style import load_style

pytestmark = pytest.mark.exhaustive


def sheet(name: str) -> Sheet:
    return vad.draw(vad.solve(vad.load(str(files("vad") / "examples" / f"{name}.toml"))()))


def texts(board: Plan) -> list[Lettering]:
    items = [item for item in board.shown(board.finished) if item.region == "results"]
    shapes = [mark.shape for item in items for mark in item.marks]
    return [shape for shape in shapes if isinstance(shape, Lettering)]


def number_of(text: Lettering) -> str:
    """Return a text without the sign of the sense that may stand behind a rate."""
    return plain(text.runs).rstrip("↺↻ \N{NO-BREAK SPACE}\N{THIN SPACE}")


@pytest.mark.parametrize("style", ["paper", "print"])
@pytest.mark.parametrize("name", ["jansen-leg", "shaper", "beam-engine"])
def test_seven_rows_stand_in_two_halves(name: str, style: str):
    drawn = sheet(name)
    assert len(drawn.rows) > MOST
    board = plan(drawn, screen((1280, 720)), load_style(style).key, lesson=True)
    found = texts(board)
    said = [number_of(text) for text in found]
    for row in drawn.rows:
        [heading] = [text for text in found if plain(text.runs).startswith(f"{row.title} ")]
        for cells in row.cells.values():
            number, _ = drawn.notation.cell(cells[0].value, cells[0].unit, cells[0].given)
            assert number in said
            level = [t for t in found if abs(t.at.imag - heading.at.imag) < 1e-9]
            assert number in [number_of(text) for text in level]
    boxes = [ink_box(text) for text in found]
    for a, b in combinations(boxes, 2):
        assert a[2] < b[0] or b[2] < a[0] or a[3] < b[1] or b[3] < a[1]
    assert min(text.size for text in found) >= 0.025
    assert max(box[2] for box in boxes) <= board.page.right + 1e-9
    assert min(box[1] for box in boxes) >= max(board.page.captions) + 0.02


def test_halves_leave_the_panels_more_room():
    page = plan(sheet("jansen-leg"), screen((1280, 720)), 0.058).page
    assert page.panels["position"].drawing.height > 0.30
    assert page.rows == () and page.results is not None
    assert plan(sheet("watt-1"), screen((1280, 720)), 0.058).page.results is None
