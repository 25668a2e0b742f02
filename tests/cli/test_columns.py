"""``vad sweep --over --columns``: tables of chosen results, over a dimension or a turn."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest

import vad as library


def table(text: str) -> tuple[list[str], np.ndarray]:
    head, *rows = csv.reader(io.StringIO(text))
    return head, np.array([[float(cell or "nan") for cell in row] for row in rows])


def test_a_dimension_varies_in_one_pose(vad, tmp_path):
    path = tmp_path / "cranks.csv"
    words = ("--over", "crank 20 60 41", "--columns", "rocker.angle,transmission", "--angle", "75")
    assert vad("sweep", "four-bar", *words, "-o", str(path)).code == 0
    head, rows = table(path.read_text("utf-8"))
    assert head == ["crank [mm]", "rocker.angle [deg]", "transmission [deg]"]
    assert rows[:, 0].tolist() == np.linspace(20.0, 60.0, 41).tolist()
    one = library.solve(library.FourBar(crank=20.0), angle=75.0)
    assert rows[0, 1] == one.link("rocker").angle
    assert rows[0, 2] == one.read(one.results["transmission"])


def test_a_pipe_gets_the_table_alone(vad):
    result = vad("sweep", "four-bar", "--columns", "C.velocity", "--steps", "4", "-o", "-")
    head, rows = table(result.out)
    assert (result.code, result.err) == (0, "")
    assert head == ["angle [deg]", "C.velocity x [mm/s]", "C.velocity y [mm/s]"]
    assert rows.shape == (4, 3)


def test_lines_that_do_not_close_are_empty(vad):
    words = ("--over", "crank 40 200 5", "--columns", "rocker.omega", "--angle", "10")
    _, rows = table(vad("sweep", "four-bar", *words, "-o", "-").out)
    assert np.isfinite(rows[0]).all()
    assert np.isnan(rows[2:, 1]).any()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--over", "crnk 20 60 5"), "--over: unknown dimension 'crnk'"),
        (("--over", "crank 20 60"), "--over: 'crank 20 60' is no range"),
        (("--over", "crank 20 60 1"), "--over: steps must be from 2"),
        (("--over", "crank 20 6kg 5"), "--over: "),
        (("--over", "crank -20 60 5"), "crank: must be positive"),
        (("--over", "crank 20 60 5", "--from", "3"), "--from does not go with --over"),
        (("--angle", "3"), "--angle goes with --over"),
        (("--columns", "rocker.speed"), "unknown result 'rocker.speed'"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(vad, words, message):
    result = vad("sweep", "four-bar", *words, "-o", "-")
    assert result.code in (1, 2)
    assert result.out == ""
    assert message in result.err.splitlines()[0]


def test_a_plot_has_no_chosen_columns_yet(vad, tmp_path):
    words = ("--columns", "rocker.angle", "-o", str(tmp_path / "a.png"))
    result = vad("sweep", "four-bar", *words)
    assert (result.code, [*tmp_path.iterdir()]) == (2, [])
    assert "as .csv" in result.err
