"""``vad sweep --over --columns``: tables of chosen results, over a dimension or a turn."""

from __future__ import annotations

import csv
import io
import json

import numpy as np
import pytest

import vad as library
from vad.files.examples import example_path


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
        (("--over", "crank nan 60 5"), "--over: crank: must be a finite number, got nan"),
        (("--over", "crank 20 nan 5"), "--over: crank: must be a finite number, got nan"),
        (("--over", "crank inf 60 5"), "--over: crank: must be a finite number, got inf"),
        (("--over", "crank -20 60 5"), "crank: must be positive"),
        (("--over", "crank 20 60 5", "--from", "3"), "--from does not go with --over"),
        (("--angle", "3"), "--angle goes with --over"),
        (("--columns", "rocker.speed"), "--columns: unknown result 'rocker.speed'"),
        (("--columns", "foo"), "--columns: 'foo' is no result"),
        (("--columns", ""), "--columns: '' is no result"),
        (("--columns", "rocker.omega,"), "--columns: '' is no result"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(vad, words, message):
    result = vad("sweep", "four-bar", *words, "-o", "-")
    assert result.code in (1, 2)
    assert result.out == ""
    assert message in result.err.splitlines()[0]
    assert "(" not in result.err  # the hint is no notation of Python


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ((), "--columns: none of these poses has a value of drive"),
        (("--crank", "500", "--rod", "5", "--offset", "900"), "the links close at none"),
    ],
)
def test_poses_without_a_value_are_told_from_links_that_do_not_close(vad, words, message):
    loaded = ("--load", "1 N @ 180 at C", "--friction", "slider 0.1", "--columns", "drive")
    result = vad("sweep", "slider-crank", *words, *loaded, "--steps", "3", "-o", "-")
    assert (result.code, result.out) == (1, "")
    assert message in result.err.splitlines()[0]


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("kind", ["csv", "json", "xlsx", "png", "svg", "pdf"])
@pytest.mark.parametrize("words", [(), ("--over", "crank 20 60 5"), ("--columns", "drive")])
def test_a_sweep_is_saved_as_every_kind_of_file(vad, tmp_path, words, kind):
    path = tmp_path / f"swept.{kind}"
    load = ("--load", "6 N m on rocker") if "drive" in words else ()
    result = vad("sweep", "four-bar", "--steps", "7", *words, *load, "-o", str(path))
    if "--over" in words:
        result = vad("sweep", "four-bar", *words, "-o", str(path))
    assert (result.code, result.err) == (0, "")
    assert path.stat().st_size > 100


def test_a_plot_has_words_and_a_table_has_none(vad, tmp_path):
    words = ("sweep", "slider-crank", "--steps", "7", "--language", "de", "-o")
    assert vad(*words, str(tmp_path / "a.svg")).code == 0
    assert "Schubkurbel" in (tmp_path / "a.svg").read_text("utf-8")
    refused = vad(*words, str(tmp_path / "a.csv"))
    assert refused.code == 2
    assert "language: .csv has no such option" in refused.err


@pytest.mark.parametrize("columns", [(), ("--columns", "piston_b.velocity,link_rod.omega")])
def test_a_plot_has_the_names_of_the_file_in_its_language(vad, tmp_path, columns):
    (tmp_path / "v.toml").write_text(example_path("v-engine").read_text("utf-8"), "utf-8")
    words = ("--steps", "7", "--language", "de", *columns, "-o", str(tmp_path / "a.svg"))
    assert vad("sweep", str(tmp_path / "v.toml"), *words).code == 0
    drawn = (tmp_path / "a.svg").read_text("utf-8")
    assert "V-Motor mit angelenktem Nebenpleuel" in drawn
    assert "<!-- Nebenpleuel" in drawn
    assert "<!-- Kolben" in drawn


def test_figures_of_merit_are_columns_of_a_dimension(vad):
    names = "stroke,time_ratio,transmission.least,rocker.omega.largest,rocker.omega.largest_at"
    words = ("--over", "crank 30 40 2", "--columns", f"{names},advantage")
    load = ("--load", "6 N m on rocker")
    head, rows = table(vad("sweep", "four-bar", *words, *load, "-o", "-").out)
    assert head[1:] == [
        "stroke [deg]",
        "time_ratio",
        "transmission.least [deg]",
        "rocker.omega.largest [rad/s]",
        "rocker.omega.largest_at [deg]",
        "advantage",
    ]
    for crank, row in zip((30.0, 40.0), rows, strict=True):
        found = library.merit(library.FourBar(crank=crank), loads=["6 N m on rocker"])
        most = found["extremes"]["rocker.omega"]
        expected = [found["stroke"], found["time_ratio"], found["transmission"]["least"]]
        expected += [most["largest"], most["largest_at"], found["advantage"]]
        assert row[1:].tolist() == expected


def test_the_stroke_of_a_slide_is_a_length(vad):
    words = ("--over", "crank 30 40 2", "--columns", "stroke,C.position x.least")
    head, rows = table(vad("sweep", "slider-crank", *words, "-o", "-").out)
    assert head[1:] == ["stroke [mm]", "C.position x.least [mm]"]
    assert rows[:, 1] == pytest.approx([60.0, 80.0], abs=1e-12)


def test_a_plot_names_what_has_no_room(vad, tmp_path):
    names = ",".join(f"C.{each}.largest" for each in ("velocity", "acceleration"))
    more = "C.position,C.velocity,C.acceleration,stroke,time_ratio,transmission"
    many = "coupler.angle,coupler.omega,coupler.alpha,forward_angle,return_angle"
    path = tmp_path / "a.png"
    words = ("--steps", "5", "--columns", f"{names},{more},{many}", "-o", str(path))
    result = vad("sweep", "four-bar", *words)
    assert (result.code, [*tmp_path.iterdir()]) == (2, [])
    assert "a plot has room for 9 quantities" in result.err


def test_pins_and_slowest_points_are_columns_of_a_turn(vad):
    names = "coupler.slowest.velocity,coupler.slowest.distance"
    words = ("--pin", "B 50", "--columns", names, "--from", "60", "--to", "70", "--steps", "2")
    heads, rows = table(vad("sweep", "four-bar", *words, "-o", "-").out)
    pose = vad("solve", "four-bar", "--angle", "60", "--pin", "B 50", "--merit", "--json")
    merit = json.loads(pose.out)["merit"]
    slow = merit["slowest"]["coupler"]
    found = dict(zip(heads, rows[0], strict=True))
    assert found["B.rubbing [mm/s]"] == pytest.approx(merit["rubbing"][0]["velocity"], rel=1e-12)
    assert found["coupler.slowest.distance [mm]"] == pytest.approx(slow["distance"], rel=1e-9)
    for axis, value in zip("xy", slow["velocity"], strict=True):
        assert found[f"coupler.slowest.velocity {axis} [mm/s]"] == pytest.approx(value, rel=1e-9)


def test_a_pin_is_a_column_beside_all_others(vad, tmp_path):
    heads, _ = table(vad("sweep", "four-bar", "--pin", "B 50", "--steps", "3", "-o", "-").out)
    assert heads[-1] == "B.rubbing [mm/s]"
    assert "rocker.omega [rad/s]" in heads
    result = vad("sweep", "four-bar", "--columns", "C.rubbing", "-o", "-")
    assert (result.code in (1, 2), result.out) == (True, "")
    assert "--pin 'C 50'" in result.err.splitlines()[1]
    words = ("--pin", "B 50", "--columns", "coupler.slowest.position", "--steps", "9")
    assert vad("sweep", "four-bar", *words, "-o", str(tmp_path / "turn.svg")).code == 0
