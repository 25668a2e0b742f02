"""Where views stand over a turn: every pose has room, and poses without a place are left out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import vad
from tests.plan.overlaps import KEY
from vad.kinematics.reach import closing_range
from vad.plan.board import plan
from vad.plan.format import screen
from vad.strokes.space.layout import (
    Corners,
    beside,
    corners,
    over_a_turn,
    over_its_range,
)


def test_corners_leave_out_poses_in_which_a_point_has_no_place() -> None:
    nowhere = complex(np.nan, np.nan)
    first, second = np.array([1 + 2j, 90 + 90j, -3 + 1j]), np.array([5 - 1j, nowhere, 4 + 0j])
    assert corners([first, second, 0j]) == Corners(-3 - 1j, 5 + 2j)
    assert corners([first, second, 0j]).size == 8 + 3j


def test_a_turn_has_equal_steps_and_each_pose_once() -> None:
    motion: Any = over_a_turn(vad.SpatialFourBar(), 8).motion
    assert motion.link("crank").angle.tolist() == [45.0 * k for k in range(8)]


def test_what_swings_between_two_poses_of_a_turn_is_found_in_its_range() -> None:
    narrow = vad.SpatialFourBar(ground_twist=60, crank_twist=50, coupler_twist=1, rocker_twist=73)
    ranges = closing_range(narrow)
    motion: Any = over_a_turn(narrow, 8).motion
    angles = motion.link("crank").angle
    assert motion.assembled.any()
    assert angles.shape == (8 * len(ranges),)
    low, high = ranges[0]
    np.testing.assert_allclose(angles[1:7], np.linspace(low, high, 8)[1:7], rtol=1e-12)
    again: Any = over_its_range(narrow, 8).motion
    np.testing.assert_array_equal(again.link("crank").angle, angles)


@pytest.mark.parametrize("length", [2.0, 30.0, 400.0])
@pytest.mark.parametrize("swing", [20.0, 170.0])
def test_views_stand_apart_in_every_pose(swing: float, length: float) -> None:
    """A third view that passes the lower one as it swings round stands above it."""
    ways = np.exp(1j * np.radians(np.linspace(-swing, swing, 41)))
    upper, lower = [-2 - 3j, 9 * ways, 4j], [-4 - 5j, 7 + 6j * ways.real]
    third = [9 * ways, (9 - length) * ways + 2j * ways]
    views = beside(upper, lower, third, ways)
    for own in range(len(ways)):
        above, below, laid = (
            np.array([np.broadcast_to(each, ways.shape)[own] for each in points])
            for points in (upper, lower, third)
        )
        near, far = ((each * ways[own].conjugate()).real for each in (above, laid))
        far += views.aside
        assert far.max() < near.min() or near.max() < far.min()
        below, laid = below - 1j * views.drop, laid + views.aside * ways[own]
        assert above.imag.min() > below.imag.max()
        apart = laid.imag.min() > below.imag.max()
        assert apart or laid.real.max() < below.real.min() or laid.real.min() > below.real.max()


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("angle", [60.0, 200.0])
@pytest.mark.parametrize("name", ["hooke-joint", "rssr", "spherical-four-bar", "spatial-four-bar"])
def test_views_have_the_height_of_a_page_that_is_4_by_3(name: str, angle: float) -> None:
    """They stand one above the other: beside two polygons they are twice as high as above one."""
    motion = vad.solve(vad.MECHANISMS[name](), angle=angle, alpha=20.0)
    board = plan(vad.draw(motion), screen((1280, 960)), KEY)
    assert board.page.columns
    shares = {n: p.drawing.height / board.page.height for n, p in board.page.panels.items()}
    assert shares["position"] > 0.5
    assert min(shares.values()) > 0.37
    assert board.sketches["position"].astray < 0.3
