"""Layout, scale and placement as plain geometry."""

from __future__ import annotations

import cmath
import math

import pytest

from tests.plan.sheets import slider_crank
from vad.plan.board import Board
from vad.plan.labels import Obstacles, beside, fan, outward, place
from vad.plan.page import Rect, lay_out
from vad.plan.scale import fill, scale_bar
from vad.plan.vertices import corners, find_vertices

PANELS = {"position": 1, "velocity": 1, "acceleration": 1}


def test_three_columns_from_three_to_two_and_two_by_two_below():
    assert lay_out((1280, 720), PANELS, 3, 0).columns
    assert lay_out((1080, 720), PANELS, 3, 0).columns
    assert not lay_out((1024, 768), PANELS, 3, 0).columns


def test_columns_are_equal_and_fill_the_page():
    page = lay_out((1280, 720), PANELS, 3, 0)
    drawings = [place.drawing for place in page.panels.values()]
    assert drawings[0].left == pytest.approx(36)
    assert drawings[-1].right == pytest.approx(1244)
    assert len({round(drawing.width, 6) for drawing in drawings}) == 1


def test_one_panel_takes_the_whole_width():
    page = lay_out((1280, 720), {"velocity": 1}, 3, 1)
    assert page.columns
    assert page.panels["velocity"].drawing.width == pytest.approx(1208)


def test_sizes_follow_the_height():
    small, large = (lay_out(size, PANELS, 3, 1) for size in ((1280, 720), (3840, 2160)))
    for name, spot in small.panels.items():
        assert large.panels[name].drawing.width == pytest.approx(3 * spot.drawing.width)
        assert large.panels[name].title == pytest.approx(3 * spot.title)


def test_fill_scale_holds_all_points_inside_the_padding_and_centred():
    drawing = Rect(0, 0, 400, 300)
    points = [0j, 10 + 3j, -4 + 8j]
    scale = fill(points, drawing, 300.0, position=False)
    xs = [scale(p).real for p in points]
    assert min(xs) - 0 == pytest.approx(400 - max(xs))
    assert min(xs) >= 0.075 * 300 - 1e-9


@pytest.mark.parametrize("factor", [1e-7, 0.013, 0.5, 1.0, 86.4, 3e9])
def test_scale_bar_is_a_round_number_not_longer_than_its_room(factor: float):
    value = scale_bar(factor, 0.12 * 720)
    assert value * factor <= 0.12 * 720 * (1 + 1e-6)
    assert value * factor > 0.12 * 720 / 2.51
    mantissa = value / 10 ** math.floor(math.log10(value * (1 + 1e-9)))
    assert min(abs(mantissa - step) for step in (1, 2, 5)) < 1e-6


def test_a_label_stands_at_its_distance_along_the_bisector():
    centre = beside(0j, 1 + 0j, 10.0, 20.0, 8.0)
    assert centre == pytest.approx(20.0)
    assert outward([1 + 0j, 1j]) == pytest.approx(cmath.rect(1, math.radians(225)))
    assert fan(1 + 0j, 16)[1] == pytest.approx(cmath.rect(1, math.radians(22.5)))


def test_placed_labels_never_overlap_however_many_there_are():
    edge = Rect(0, 0, 300, 300)
    obstacles = Obstacles(edge)
    obstacles.line([20 + 150j, 280 + 150j], 3.0)
    boxes = [place(obstacles, 150 + 150j, 1j, 30.0, 16.0, 300.0).box for _ in range(20)]
    for number, box in enumerate(boxes):
        assert edge.holds(complex(box.left, box.bottom))
        assert edge.holds(complex(box.right, box.top))
        assert box.bottom > 153 or box.top < 147
        for other in boxes[:number]:
            apart_x = box.left >= other.right or other.left >= box.right
            assert apart_x or box.bottom >= other.top or other.bottom >= box.top


def test_coincident_points_share_a_dot_and_a_label():
    panel = slider_crank().panel("velocity")
    board = Board(slider_crank(), (1280, 720))
    letters = [v.label for v in find_vertices(panel, board.arts["velocity"].scale, 720.0)]
    assert letters == ["a, d", "b", "c"]
    tiny = fill(corners(panel), Rect(0, 0, 120, 100), 720.0, position=False)
    assert any("," in v.label for v in find_vertices(panel, tiny, 1e6))
