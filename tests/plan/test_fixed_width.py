"""The numbers of a turn, in columns of fixed width, have the digits that they have elsewhere."""

from __future__ import annotations

import pytest

from vad.plan.lettering.glyphs import width
from vad.plan.turning.fixed_width import Figures
from vad.strokes.sheet import Cell
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
        ("°", (359.97, 12.0)),
    ],
)
def test_the_largest_number_of_a_column_is_written_as_everywhere(
    unit: str, values: tuple[float, ...]
):
    cells = [Cell("v", value, unit) for value in values]
    shown = "".join(run.text for run in Figures(cells)(cells[0]) if run.shown)
    assert shown == number(values[0], unit).replace("⁶", "6")  # raised, as a run


def test_thousands_are_parted_alike_in_all_of_a_column():
    cells = [Cell("v", value, "mm/s") for value in (57543.2, -2345.0, 12.0)]
    figures = Figures(cells, ",")
    assert len({width(figures(cell), 1.0) for cell in cells}) == 1
