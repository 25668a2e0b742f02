"""``vad sweep``: the results over a range of the input as a table or a plot."""

from __future__ import annotations

import csv
import math

import numpy as np
import pytest
from PIL import Image

import vad as library
from vad.mechanisms import MECHANISMS


def swept(vad, folder, *words):
    """Return the header and the columns of a sweep's table; None for an empty cell."""
    path = folder / "sweep.csv"
    result = vad("sweep", *words, "-o", str(path))
    assert (result.code, result.out, result.err) == (0, "", "")
    with path.open(newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    columns = zip(*rows, strict=True)
    return {
        name: [float(cell) if cell else None for cell in column]
        for name, column in zip(head, columns, strict=True)
    }


def test_a_turn_of_the_crank(vad, tmp_path):
    table = swept(vad, tmp_path, "slider-crank", "--omega", "120 rpm", "--alpha", "-3")
    angles = np.linspace(0.0, 360.0, 361)
    motion = library.solve(library.SliderCrank(), angle=angles, omega=4 * math.pi, alpha=-3.0)
    assert list(table) == [
        "angle [deg]",
        *(
            f"{link} {of}"
            for link in ("crank", "rod")
            for of in ("angle [deg]", "omega [rad/s]", "alpha [rad/s^2]")
        ),
        "slider position [mm]",
        "slider velocity [mm/s]",
        "slider acceleration [mm/s^2]",
    ]
    assert table["angle [deg]"] == angles.tolist()
    assert table["rod alpha [rad/s^2]"] == motion.link("rod").alpha.tolist()
    assert table["slider velocity [mm/s]"] == motion.slide("slider").velocity.tolist()


@pytest.mark.parametrize("name", MECHANISMS)
def test_every_mechanism_closes_over_its_own_range(vad, tmp_path, name):
    table = swept(vad, tmp_path, name, "--steps", "7")
    positions = [column for head, column in table.items() if "angle" in head or "position" in head]
    assert all(None not in column for column in positions)
    assert {len(column) for column in table.values()} == {7}


def test_poses_that_cannot_be_assembled_are_empty_cells(vad, tmp_path):
    table = swept(vad, tmp_path, "four-bar", "--crank", "130", "--steps", "5")
    assert table["rocker omega [rad/s]"][0] is None
    assert table["rocker omega [rad/s]"][1] is not None
    assert table["crank omega [rad/s]"][0] is None
    assert table["angle [deg]"] == [0.0, 90.0, 180.0, 270.0, 360.0]


def test_the_ends_may_be_given_in_any_unit_and_order(vad, tmp_path):
    words = ("four-bar", "--from", "0.5 turn", "--to", "-90", "--steps", "4")
    assert swept(vad, tmp_path, *words)["angle [deg]"] == [180.0, 90.0, 0.0, -90.0]
    words = ("gate-actuator", "--from", "42 in", "--to", "4", "--steps", "2")
    assert swept(vad, tmp_path, *words)["position [ft]"] == [3.5, 4.0]


def test_a_driven_slide_runs_over_the_range_in_which_it_closes(vad, tmp_path):
    table = swept(vad, tmp_path, "gate-actuator", "--steps", "2")
    gate = MECHANISMS["gate-actuator"]()
    ends = [gate.arm - gate.ground, gate.arm + gate.ground]
    assert table["position [ft]"] == pytest.approx(ends, rel=1e-8)


def test_more_poses_than_one_chunk(vad, tmp_path):
    table = swept(vad, tmp_path, "scotch-yoke", "--steps", "20001")
    assert table["angle [deg]"] == np.linspace(0.0, 360.0, 20001).tolist()
    assert None not in table["yoke acceleration [mm/s^2]"]


@pytest.mark.exhaustive(3)
@pytest.mark.parametrize("name", ["crank-slotted-lever", "double-slider", "gate-actuator"])
def test_a_plot_over_a_crank_a_slide_and_a_strut(vad, tmp_path, name):
    path = tmp_path / "sweep.PNG"
    result = vad("sweep", name, "--steps", "91", "-o", str(path))
    assert (result.code, result.out, result.err) == (0, "", "")
    with Image.open(path) as picture:
        assert picture.size == (1600, 1200)
        assert len(picture.convert("RGB").getcolors(100_000)) > 10


def test_a_plot_has_the_digits_of_every_power(vad, tmp_path):
    words = ("--crank", "1.234e-150", "--omega", "5.67e45", "--alpha", "1e50")
    result = vad("sweep", "scotch-yoke", *words, "-o", str(tmp_path / "sweep.png"))
    assert (result.code, result.out, result.err) == (0, "", "")


def test_a_plot_with_gaps_and_peaks(vad, tmp_path):
    path = tmp_path / "sweep.png"
    assert vad("sweep", "four-bar", "--crank", "130", "-o", str(path)).code == 0


def test_an_older_file_is_replaced_only_by_a_whole_one(vad, tmp_path):
    path = tmp_path / "old.csv"
    path.write_text("old")
    assert vad("sweep", "four-bar", "--steps", "1", "-o", str(path)).code == 2
    assert path.read_text() == "old"
    assert vad("sweep", "four-bar", "-o", str(path)).code == 0
    assert path.read_text().startswith("angle [deg]")


def test_an_equals_sign_after_the_short_option_is_no_part_of_the_name(vad, tmp_path):
    assert vad("sweep", "four-bar", f"-o={tmp_path}/a.csv").code == 0
    assert [each.name for each in tmp_path.iterdir()] == ["a.csv"]


PARALLELOGRAM = (
    "four-bar",
    "--ground",
    "100",
    "--crank",
    "40",
    "--coupler",
    "100",
    "--rocker",
    "40",
)


@pytest.mark.parametrize(
    ("words", "places"),
    [
        ((), ["0°", "180°"]),
        (("--from", "10", "--to", "190"), ["180°"]),
        (("--from", "300", "--to", "400"), ["0°"]),
        (("--from", "10", "--to", "170"), []),
        (("--assembly", "parallel"), []),
    ],
)
def test_change_points_on_the_way_are_told(vad, tmp_path, words, places):
    result = vad("sweep", *PARALLELOGRAM, *words, "-o", str(tmp_path / "sweep.csv"))
    assert (result.code, result.out) == (0, "")
    told = "note: change point at {}: two motions are possible; say parallel"
    assert result.err.splitlines() == [told.format(place) for place in places]
