from __future__ import annotations

import io

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.figure import Figure

import vad
from vad.export.sweep import plot
from vad.export.sweep.results import results_of
from vad.style import load_style


def test_a_plot_leaves_gaps_where_an_angle_passes_360():
    angles = plot._broken(np.array([350.0, 358.0, 6.0, 14.0]))
    assert np.isnan(angles).tolist() == [False, False, True, False]


def test_a_few_poses_near_a_dead_centre_do_not_dwarf_the_rest():
    calm = np.linspace(-1.0, 1.0, 100)
    assert plot._limits(calm) == (-1.0, 1.0)
    low, high = plot._limits(np.append(calm, [1e9, np.nan]))
    assert low == -1.0 and 1.0 < high < 10.0


def test_rounding_is_drawn_as_the_straight_line_that_it_stands_for():
    """Crank and rod of one length: the rod turns steadily, and its α is noise of 1e-13."""
    motion = vad.solve(vad.SliderCrank(crank=140, rod=140), angle=np.arange(0.0, 80.0))
    figure = Figure()
    plot._curves(figure, results_of(motion), load_style("paper"))
    alpha = next(each for each in figure.axes if "alpha" in each.get_title(loc="left"))
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
            plot.plot(motion, results_of(motion), file)
            assert dict(mpl.rcParams) == before
        pictures.append(file.getvalue())
    assert pictures[0] == pictures[1]
