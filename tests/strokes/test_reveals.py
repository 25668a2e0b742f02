"""When the table fills: each result with the stroke that measures it, what is given at once."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

import vad
from tests.strokes.calculations import chains
from tests.strokes.motions import drawn, everything, in_every_language, poses
from vad.files.examples import example_path
from vad.kinematics.motion import Motion
from vad.lecture.lesson import animate, still
from vad.strokes.sheet import Cell, Panel, Sheet

Name = tuple[str, str]  # of a cell: panel, row, symbol


def cells(sheet: Sheet, panel: str) -> Iterator[tuple[Name, Cell]]:
    """Yield the cells of a panel: the first of a row, which a stroke measures."""
    for row in sheet.rows:
        for cell in row.cells.get(panel, ())[:1]:
            yield (panel, row.key, cell.symbol), cell


def measuring(panel: Panel, row: str, symbol: str) -> int | None:
    """Return the first stroke of a row's own whose caption states a quantity as a number."""
    for number, stroke in enumerate(panel.strokes):
        if stroke.link == row and any(
            chain.result and chain.symbol == symbol for chain in chains(stroke.caption)
        ):
            return number
    return None


@in_every_language
@everything
def test_a_result_is_revealed_by_the_stroke_that_measures_it(name: str, code: str) -> None:
    for motion in poses(name):
        sheet = drawn(motion, code)
        for panel in sheet.panels:
            for (_, row, symbol), cell in cells(sheet, panel.name):
                revealing = [i for i, stroke in enumerate(panel.strokes) if row in stroke.reveals]
                number = measuring(panel, row, symbol)
                if cell.given:
                    assert number is None or panel.strokes[number].kind == "known"
                else:
                    assert revealing == [number], (panel.name, row, symbol)


@everything
def test_what_is_zero_is_revealed_where_the_lines_cross(name: str) -> None:
    """A vector of length zero is no stroke: that it is none is seen at the crossing."""
    first, second, third = vad.MECHANISMS[name].inputs
    place = vad.MECHANISMS[name].inputs[first]
    inputs = [{first: angle} for angle in (0.0, 90.0, 180.0, 270.0)] if first == "angle" else []
    for given in [*inputs, {first: place, second: 0.0, third: 0.0}]:
        motion = vad.solve(vad.MECHANISMS[name](), **given)
        try:
            sheet = vad.draw(motion)
        except vad.DeadCentreError:
            continue
        for panel in sheet.panels:
            if panel.name != "position":
                _check_zeros(sheet, panel)


def _check_zeros(sheet: Sheet, panel: Panel) -> None:
    for (_, row, symbol), cell in cells(sheet, panel.name):
        if cell.given:
            continue
        (stroke,) = (stroke for stroke in panel.strokes if row in stroke.reveals)
        assert (measuring(panel, row, symbol) is None) == (cell.value == 0.0), (row, symbol)
        if cell.value == 0.0:
            assert stroke.kind in ("intersection", "pole")


@pytest.mark.exhaustive(4)
@in_every_language
@everything
def test_a_lesson_shows_what_has_been_measured_so_far(name: str, code: str) -> None:
    for motion in poses(name)[:3]:
        _check_lesson(drawn(motion, code))


def _check_lesson(sheet: Sheet) -> None:
    lesson = animate(sheet)
    known: set[Name] = set()
    for number, step in enumerate(lesson.steps, start=1):
        begun = step.panel.name
        for name, cell in cells(sheet, begun):
            if cell.given or measuring(step.panel, *name[1:]) == step.index:
                known.add(name)
        page = still(lesson, number).drawn
        shown = {name for panel in page.panels for name, _ in cells(page, panel.name)}
        assert shown == known, (number, step.stroke)


def test_a_swinging_cylinder_slides_when_that_is_drawn_not_when_its_turning_is() -> None:
    sheet = vad.draw(vad.solve(vad.load(example_path("oscillating-cylinder"))()))
    for panel, turning, sliding in (("velocity", "ω₃", "v"), ("acceleration", "α₃", "a")):
        measured = sheet.panel(panel)
        steps = [s for s in animate(sheet).steps if s.panel.name == panel]
        before = sum(len(each.strokes) for each in sheet.panels[: sheet.panels.index(measured)])
        since = {}
        for number, step in enumerate(steps, start=before + 1):
            for row in still(animate(sheet), number).drawn.rows:
                for cell in row.cells.get(panel, ()):
                    since.setdefault(cell.symbol, step.stroke.name)
        assert (since[turning], since[sliding]) == ("DQ.tangential", "QB.sliding")
        assert f"{sliding} = " in measured.strokes[measured.number("QB.sliding")].caption


@everything
def test_the_coriolis_cell_waits_for_its_vector(name: str) -> None:
    for motion in poses(name):
        panel = drawn(motion, "en").panel("acceleration")
        for number, stroke in enumerate(panel.strokes):
            if stroke.component == "coriolis":
                assert _last_cell(motion, str(stroke.link)).symbol == "2ωv"
                after = [i for i, s in enumerate(panel.strokes) if stroke.link in s.reveals]
                assert after and after[0] > number


def _last_cell(motion: Motion, row: str) -> Cell:
    rows = [found for found in drawn(motion, "en").rows if found.key == row]
    return rows[-1].cells["acceleration"][-1]
