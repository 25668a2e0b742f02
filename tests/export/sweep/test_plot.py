from __future__ import annotations

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
