from __future__ import annotations

import io
import re
from itertools import combinations

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

import vad
from vad.export import plotting, sweep_png
from vad.export.plotting import Look
from vad.export.sweep import limits, results_of
from vad.style import load_style

TURN = np.linspace(0.0, 360.0, 73)
RANGES = {"gate-actuator": np.linspace(3.25, 4.5, 51)}


@pytest.fixture(autouse=True)
def settings():
    """Let texts be as wide as they are in the file."""
    with mpl.rc_context(plotting.settings(load_style("paper"))):
        yield


def plots(motion) -> list[Axes]:
    """Return the plots of a sweep: positions, velocities and accelerations of links and slides."""
    figure, symbols = (
        Figure((16, 12)),
        {"block": "s", "ram": "x", "slider": "x", "slider_a": "x", "slider_b": "y"},
    )
    sweep_png._curves(figure, results_of(motion), symbols, Look.of("paper", "en", motion.mechanism))
    return figure.axes


def curve(axes: Axes, name: str):
    """Return the line of the curve whose name stands at its end in its colour."""
    (label,) = (each for each in axes.texts if each.get_text().startswith(name))
    return next(each for each in axes.lines if each.get_color() == label.get_color())


def test_an_angle_runs_on_past_360_and_starts_near_0():
    rod = curve(plots(vad.solve(vad.SliderCrank(), angle=TURN))[0], "rod")
    expected = -np.degrees(np.arcsin(60 / 140 * np.sin(np.radians(TURN))))
    assert rod.get_ydata() == pytest.approx(expected, abs=1e-9)
    lever = curve(plots(vad.solve(vad.Whitworth(), angle=TURN))[0], "lever").get_ydata()
    assert lever[-1] - lever[0] == pytest.approx(360.0) and abs(lever[0]) < 180.0
    assert np.all(np.diff(lever) > 0.0)


def test_poses_that_do_not_close_leave_a_gap_in_an_angle():
    motion = vad.solve(vad.FourBar(crank=130), angle=TURN)
    rocker = curve(plots(motion)[0], "rocker").get_ydata()
    assert (np.isnan(rocker) == ~motion.assembled).all()


def test_names_and_symbols_are_those_of_the_sheet():
    shaper = vad.CrankSlottedLever(rod=100, ram_height=180)
    axes = plots(vad.solve(shaper, angle=TURN))
    titles = [each.get_title(loc="left") for each in axes]
    assert titles[:3] == ["$\\theta$, °", "$s$ / $x$, mm", "$\\omega$, rad/s"]
    inks = {label.get_text(): label.get_color() for each in axes for label in each.texts}
    assert inks == {
        "lever $\\mathit{DC}$": "#D76104",
        "rod $\\mathit{CE}$": "#02A374",
        "block $\\mathit{B}$": "#AF0976",
        "ram $\\mathit{E}$": "#000000",
    }


def test_the_numbers_of_an_axis_are_parted_like_all_others():
    axes = plots(vad.solve(vad.EllipticalTrammel(), angle=TURN))
    axes[-1].figure.draw_without_rendering()
    seen = {label.get_text() for each in axes for label in each.get_yticklabels()}
    assert any(r"20\,000" in text for text in seen)
    assert not any(re.search(r"\d{5}", text) for text in seen)


def test_a_strut_is_named_by_its_own_ends():
    results = results_of(vad.solve(vad.GateActuator(), position=RANGES["gate-actuator"]))
    assert [(row.name, row.letters) for row in results.slides] == [("actuator", "DB")]


@pytest.mark.parametrize("name", ["four-bar", "crank-slotted-lever", "gate-actuator"])
def test_names_at_the_ends_never_touch_and_stay_on_the_page(name):
    mechanism = vad.MECHANISMS[name]()
    driven = next(iter(mechanism.inputs))
    motion = vad.solve(mechanism, **{driven: RANGES.get(name, TURN)})
    for axes in plots(motion):
        boxes = [label.get_window_extent() for label in axes.texts]
        assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))
        assert all(box.x1 <= axes.figure.bbox.x1 for box in boxes)


def test_a_few_poses_near_a_dead_centre_do_not_dwarf_the_rest():
    calm = np.linspace(-1.0, 1.0, 100)
    assert limits(calm) == (-1.0, 1.0)
    low, high = limits(np.append(calm, [1e9, np.nan]))
    assert low == -1.0 and 1.0 < high < 10.0


def test_rounding_is_drawn_as_the_straight_line_that_it_stands_for():
    """Crank and rod of one length: the rod turns steadily, and its α is noise of 1e-13."""
    motion = vad.solve(vad.SliderCrank(crank=140, rod=140), angle=np.arange(0.0, 80.0))
    alpha = next(each for each in plots(motion) if "alpha" in each.get_title(loc="left"))
    assert alpha.get_ylim() == pytest.approx((-1.0, 1.0))


def test_the_user_s_own_settings_change_nothing():
    """What a matplotlibrc may say of text, lines, axes, ticks, legends and files."""
    motion = vad.solve(vad.FourBar(), angle=np.linspace(0.0, 360.0, 13))
    own = {
        "text.usetex": True,
        "text.hinting": "none",
        "text.antialiased": False,
        "font.weight": "bold",
        "lines.linewidth": 5.0,
        "lines.linestyle": ":",
        "lines.marker": "o",
        "axes.grid": True,
        "axes.facecolor": "red",
        "axes.edgecolor": "green",
        "axes.spines.top": False,
        "axes.titlelocation": "right",
        "axes.titlesize": 30.0,
        "axes.unicode_minus": False,
        "axes.xmargin": 0.4,
        "axes.formatter.useoffset": False,
        "xtick.direction": "in",
        "xtick.labelsize": 30.0,
        "ytick.right": True,
        "ytick.minor.visible": True,
        "legend.fontsize": 30.0,
        "legend.frameon": True,
        "figure.autolayout": True,
        "figure.constrained_layout.use": False,
        "figure.subplot.left": 0.4,
        "savefig.bbox": "tight",
        "savefig.dpi": 50.0,
        "savefig.facecolor": "blue",
        "savefig.transparent": True,
        "path.sketch": (1.0, 100.0, 2.0),
        "path.simplify": False,
        "agg.path.chunksize": 7,
    }
    pictures = []
    for settings in ({}, own):
        file = io.BytesIO()
        with mpl.rc_context(settings):
            before = dict(mpl.rcParams)
            sweep_png.write(motion, file)
            assert dict(mpl.rcParams) == before
        pictures.append(file.getvalue())
    assert pictures[0] == pictures[1]
