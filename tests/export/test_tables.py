"""Tables and plots of chosen columns, read by somebody else's readers."""

from __future__ import annotations

import io
import json
from itertools import combinations

import matplotlib as mpl
import numpy as np
import openpyxl
import pytest
from matplotlib.figure import Figure

import vad
from vad.errors import InputError
from vad.export import plotting, table_csv, table_json, table_png, table_xlsx
from vad.export.plotting import Look
from vad.export.sweep import Column, Table, table_of
from vad.style import load_style

CRANKS = np.linspace(20.0, 340.0, 9)
NAMES = ("rocker.angle", "C.velocity", "transmission", "transmission.least", "stroke")


@pytest.fixture(scope="module")
def table() -> Table:
    mechanism = vad.FourBar(crank=CRANKS)
    motion = vad.solve(mechanism, angle=100.0)
    found = vad.sweep(mechanism, NAMES, angle=100.0)
    velocity = found["C.velocity"]
    columns = (
        Column("rocker.angle", "deg", found["rocker.angle"]),
        Column("C.velocity x", "mm/s", velocity.real),
        Column("C.velocity y", "mm/s", velocity.imag),
        Column("transmission", "deg", found["transmission"]),
        Column("transmission.least", "deg", found["transmission.least"]),
        Column("stroke", "deg", found["stroke"]),
    )
    return Table(motion, Column("crank", "mm", CRANKS), columns)


def saved(module, table: Table) -> bytes:
    target = io.BytesIO()
    module.write(table, target)
    return target.getvalue()


def expected(table: Table) -> list[list[float | None]]:
    columns = [table.over, *table.columns]
    rows = np.column_stack([column.values for column in columns]).tolist()
    return [[None if value != value else value for value in row] for row in rows]


def test_the_table_has_gaps_and_numbers(table):
    assert np.isnan(table.columns[0].values).any() and np.isfinite(table.columns[0].values).any()


def test_a_table_in_excel_has_every_digit_and_empty_cells(table):
    book = openpyxl.load_workbook(io.BytesIO(saved(table_xlsx, table)))
    head, *rows = book["sweep"].iter_rows(values_only=True)
    assert list(head) == table.heads
    for found, row in zip(rows, expected(table), strict=True):
        assert [value is None for value in found] == [value is None for value in row]
        # A file of Excel holds sixteen significant digits.
        known = [(a, b) for a, b in zip(found, row, strict=True) if b is not None]
        assert all(a == pytest.approx(b, rel=1e-15) for a, b in known)
    given = {row[0]: row[1:] for row in book["mechanism"].iter_rows(values_only=True)}
    assert given["ground"] == (100, "mm") and given["angle"] == (100, "deg")
    assert "crank" not in given


def test_a_table_in_excel_is_the_same_file_each_time(table):
    assert saved(table_xlsx, table) == saved(table_xlsx, table)


def test_excel_needs_its_extra(table, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "xlsxwriter", None)
    with pytest.raises(InputError, match="xlsxwriter is not installed") as wrong:
        saved(table_xlsx, table)
    assert wrong.value.hint == "pip install 'vad-diagrams[excel]'"


def test_a_sheet_takes_no_more_lines_than_excel_has(table, monkeypatch):
    monkeypatch.setattr(table_xlsx, "MOST_LINES", 8)
    with pytest.raises(vad.UsageError, match="9 lines and 7 columns"):
        saved(table_xlsx, table)


def test_a_table_in_json_has_every_digit(table):
    data = json.loads(saved(table_json, table))
    assert data["over"] == {"name": "crank", "unit": "mm", "values": CRANKS.tolist()}
    assert [each["values"] for each in data["columns"]] == [
        list(column) for column in zip(*expected(table), strict=True)
    ][1:]
    assert data["input"] == {"angle": 100.0, "omega": 10.0, "alpha": 0.0}
    assert "crank" not in data["parameters"]


def test_a_table_in_csv_has_a_line_for_each_place(table):
    head, *rows = saved(table_csv, table).decode().splitlines()
    assert head == ",".join(table.heads)
    assert [[float(cell) if cell else None for cell in row.split(",")] for row in rows] == expected(
        table
    )


@pytest.mark.parametrize("name", [*vad.MECHANISMS])
def test_all_columns_of_a_motion_are_those_of_a_sweep(name):
    mechanism = vad.MECHANISMS[name]()
    driven = next(iter(mechanism.inputs))
    middle = mechanism.inputs[driven]
    motion = vad.solve(mechanism, **{driven: middle + np.linspace(0.0, 0.1, 3)})
    for column in table_of(motion).columns:
        result, _, axis = column.quantity.partition(" ")
        found = vad.sweep(mechanism, result, **motion.inputs)[result]
        if axis:
            parts = (found.real, found.imag) if np.iscomplexobj(found) else found.T
            found = parts["xyz".index(axis)]
        assert column.values.tolist() == found.tolist()


def figure_of(table: Table, language: str = "en") -> Figure:
    look = Look.of("paper", language, table.motion.mechanism)
    figure = Figure((16, 12))
    table_png._draw(figure, table, table_png._panels(table, look), look, 1.0)
    return figure


@pytest.fixture
def settings():
    with mpl.rc_context(plotting.settings(load_style("paper"))):
        yield


@pytest.mark.usefixtures("settings")
def test_each_quantity_has_a_panel_with_its_symbol_and_unit(table):
    titles = {axes.get_title(loc="left") for axes in figure_of(table).axes}
    assert titles == {"$\\theta$, °", "$v$, mm/s", "$\\mu$, °", "stroke, °"}


@pytest.mark.usefixtures("settings")
def test_curves_have_the_values_of_their_columns_and_gaps(table):
    (axes,) = (each for each in figure_of(table).axes if "$v$" in each.get_title(loc="left"))
    curves = [line.get_ydata() for line in axes.lines if len(line.get_xdata()) == len(CRANKS)]
    for curve, column in zip(curves, table.columns[1:3], strict=True):
        assert np.array_equal(curve, column.values, equal_nan=True)


@pytest.mark.usefixtures("settings")
@pytest.mark.exhaustive
@pytest.mark.parametrize("language", ["de", "en", "fr"])
def test_names_of_curves_touch_nothing_and_stay_on_the_page(table, language):
    figure = figure_of(table, language)
    for axes in figure.axes:
        boxes = [label.get_window_extent() for label in axes.texts]
        assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))
        assert all(box.x1 <= figure.bbox.x1 for box in boxes)
        ticks = [label.get_window_extent() for label in axes.get_xticklabels()]
        assert not any(box.overlaps(tick) for box in boxes for tick in ticks if tick.width > 1)


@pytest.mark.usefixtures("settings")
def test_what_does_not_close_is_grey_from_the_last_pose_to_the_next(table):
    few = Table(table.motion, table.over, table.columns[:1])
    known = np.isfinite(few.columns[0].values)
    (axes,) = figure_of(few).axes
    ends = {(round(patch.get_x(), 9), round(patch.get_width(), 9)) for patch in axes.patches}
    last = CRANKS[np.flatnonzero(known)[-1]]
    assert ends == {(last, CRANKS[-1] - last)}
    assert "does not close" in [text.get_text() for text in axes.texts]
