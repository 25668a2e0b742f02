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
    GAP,
    TALLEST,
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
def test_views_stand_apart_and_the_bar_has_room(length: float) -> None:
    upper, lower = Corners(-2 - 3j, 9 + 4j), Corners(-4 - 5j, 7 + 6j)
    third = Corners(length * (-0.8 - 0.1j), length * (0.1 + 0.6j))
    views = beside(upper, lower, third, length)
    top = lower.high.imag - views.drop
    assert upper.low.imag - top == pytest.approx(GAP * 11.0)
    height = upper.high.imag - (lower.low.imag - views.drop)
    assert views.share <= max(1.0, TALLEST * height / length)
    assert views.share * length <= TALLEST * height
    low, high = (views.place + views.share * corner for corner in third)
    assert low.real > upper.high.real
    middle = 0.5 * (low + high).imag
    assert middle == pytest.approx(upper.high.imag - 0.5 * height)


@pytest.mark.exhaustive(4)
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
