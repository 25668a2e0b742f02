"""The numbers of a turn, in columns of fixed width, have the digits that they have elsewhere."""

from __future__ import annotations

import pytest

from vad.plan.chart import fixed_width
from vad.plan.lettering.glyphs import width
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
