"""The numbers of a turn, in columns of fixed width, have the digits that they have elsewhere."""

from __future__ import annotations

import pytest

import vad
from tests.plan.turns import board_of
from vad.files.examples import example_path
from vad.plan.chart import Clock, fixed_width
from vad.plan.format import screen
from vad.plan.lettering.glyphs import width
from vad.plan.marks import Lettering
from vad.plan.turn_layout import lay_out_turn
from vad.written import number


@pytest.mark.parametrize(
    ("unit", "values"),
    [
        ("mm/s", (1234.5, -2.0)),
        ("mm/s", (57543.2, 12.0)),
        ("mm/s", (9999.7,)),
        ("mm/s", (0.00123, 0.001)),
        ("mm/s²", (1234567.0, 3.0)),
        ("°", (338.213, 12.0)),
    ],
)
def test_the_largest_number_of_a_column_is_written_as_everywhere(
    unit: str, values: tuple[float, ...]
):
    shown = "".join(run.text for run in fixed_width(unit, values).bare(values[0]))
    assert shown == number(values[0], unit).replace("⁶", "6")  # raised, as a run


@pytest.mark.parametrize(
    ("unit", "values", "shown"),
    [
        ("mm/s", (-371.94, 0.0, -0.04, 9.96, 1250.0), ["−372", "0", "0", "10", "1250"]),
        (
            "mm/s",
            (57543.2, -2345.0, 12.0),
            ["57\N{NARROW NO-BREAK SPACE}543", "−2\N{NARROW NO-BREAK SPACE}345", "12"],
        ),
        ("rad/s²", (2.5e7, -1e3), ["2,500×107", "0,000×107"]),  # 7 is raised
        ("°", (359.98, 7.0, 120.04), ["0,0", "7,0", "120,0"]),
    ],
)
def test_numbers_are_always_as_wide(unit: str, values: tuple[float, ...], shown: list[str]):
    form = fixed_width(unit, values, ",")
    found = [[run.text for run in form.runs(value) if run.shown] for value in values]
    assert list(map("".join, found)) == shown
    assert len({width(form.runs(value), 1.0) for value in values}) == 1


def test_an_axis_ends_at_a_full_turn_where_a_reading_begins_anew() -> None:
    form = fixed_width("°", (0.0, 359.97))
    end = "".join(run.text for run in form.bare(359.97))
    reading = "".join(run.text for run in form.runs(359.97) if run.shown)
    assert (end, reading) == ("360.0", "0.0")


@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
@pytest.mark.parametrize(
    ("name", "language", "shorter"),
    [("excavator-bucket", "en", "OB moves between"), ("jansen-leg", "de", "Schwungphase 192°")],
)
def test_the_line_above_a_mechanism_fits_its_panel(
    name: str, language: str, shorter: str, size: tuple[int, int]
):
    turn = vad.turn(vad.load(example_path(name))(), size=size, language=language)
    sheet = turn.sheet
    names = [panel.name for panel in sheet.panels]
    room = lay_out_turn(screen(size), names).page.panels["position"].drawing
    texts = [m.shape for m in Clock(turn.cycle, turn.course, sheet, room).marks(0.0)]
    said = []
    for text in texts:
        assert isinstance(text, Lettering)
        assert text.at.real + width(text.runs, text.size) <= room.right
        said.append("".join(run.text for run in text.runs))
    last = said[0] if turn.course.swing else said[-1]
    assert last.startswith(shorter) == (size == (960, 720))


def test_a_value_that_stays_the_same_but_for_rounding_is_a_level_line():
    """The tracer of a pantograph on a crank runs along a circle with one speed."""
    board = board_of(vad.load(example_path("pantograph"))())
    for name, value in (("velocity", "400.0"), ("acceleration", "3200")):
        chart = board.charts[name]
        assert len({chart.at(share, chart.value(share)).imag for share in (0.0, 0.3, 0.7)}) == 1
        texts = [mark.shape for mark in chart.still() if isinstance(mark.shape, Lettering)]
        assert ["".join(run.text for run in text.runs) for text in texts] == [value]
