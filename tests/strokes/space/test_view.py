"""What a view shows of points, circles and arcs in space, and what it finds to be far."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from vad.strokes.sheet import Ellipse
from vad.strokes.space.view import ORIGIN, View, circle

VIEWS = [View.of_frame(20.0), View.of_frame(-70.0), View.from_above(-62.0, 38.0)]
views = pytest.mark.parametrize("view", VIEWS, ids=["frame", "turned", "pictorial"])


def numbers(vector: Any) -> Any:
    return np.array(vector, float)


def unit(vector: Any) -> Any:
    return vector / np.linalg.norm(vector)


def random_axes(number: int) -> Any:
    rng = np.random.default_rng(number)
    return [unit(rng.normal(size=3)) for _ in range(2)]


def is_far(arc: Ellipse, degrees: float) -> bool:
    return any(low <= degrees <= high for low, high in arc.far)


@views
def test_it_projects_along_lines_square_to_the_page(view: View):
    right, up, toward = map(numbers, (view.right, view.up, view.toward))
    assert np.cross(right, up) == pytest.approx(toward)
    assert view.way(tuple(toward)) == pytest.approx(0.0, abs=1e-15)
    for vector in random_axes(1):
        seen = view.way(tuple(vector))
        assert abs(seen) ** 2 + (vector @ toward) ** 2 == pytest.approx(1.0)
    many = np.array(random_axes(2)).T
    assert view.way(tuple(many)) == pytest.approx([view.way(tuple(each)) for each in many.T])


def test_the_view_of_a_frame_has_its_axes_on_the_page():
    """A, and D at the arc of 40° from it about the normal, with the bisector downward."""
    view, ground = View.of_frame(20.0), math.radians(40.0)
    a, d = (0.0, 0.0, 1.0), (0.0, -math.sin(ground), math.cos(ground))
    assert view.way(a) == pytest.approx(np.exp(1j * math.radians(-110.0)))
    assert view.way(d) == pytest.approx(np.exp(1j * math.radians(-70.0)))


def test_a_view_stands_at_its_place_and_is_turned_and_enlarged():
    view = View((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), at=3 - 2j, turn=2j)
    assert view.point((1.0, 0.0, 5.0)) == 3 + 0j
    assert view.way((1.0, 0.0, 5.0)) == 2j


@views
@pytest.mark.parametrize("number", range(8))
def test_what_lies_behind_the_centre_of_the_sphere_is_far(view: View, number: int):
    """By the depth of points along great and small circles, whole and in part."""
    axis, point = random_axes(number)
    toward, c, s = numbers(view.toward), np.cos, np.sin
    first = unit(np.cross(axis, point))
    second, foot = np.cross(axis, first), (axis @ point) * axis
    small = np.linalg.norm(point - foot)
    cases = [
        (ORIGIN, first, second, 0.0, 360.0),
        (ORIGIN, first, second, -50.0, 210.0),
        (tuple(foot), small * first, small * second, 30.0, -120.0),
    ]
    for centre, one, other, start, sweep in cases:
        arc = view.circle(centre, tuple(one), tuple(other), start, sweep)
        for degrees in np.linspace(start, start + sweep, 73):
            angle = math.radians(degrees)
            at = numbers(centre) + c(angle) * one + s(angle) * other
            assert arc.at(degrees) == pytest.approx(complex(view.point(tuple(at))), abs=1e-12)
            if abs(at @ toward) > 1e-6:
                assert is_far(arc, degrees) == (at @ toward < 0.0)


def test_a_circle_in_the_paper_is_all_near():
    view = View((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    assert view.circle(ORIGIN, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)).far == ()


@views
def test_an_arc_runs_the_shorter_way_between_its_ends(view: View):
    start, end = random_axes(5)
    arc = view.arc(tuple(start), tuple(end))
    assert math.cos(math.radians(arc.sweep)) == pytest.approx(start @ end)
    assert 0.0 < arc.sweep < 180.0
    ends = [complex(view.way(tuple(each))) for each in (start, end)]
    assert [arc.at(0.0), arc.at(arc.sweep)] == pytest.approx(ends)


@views
def test_a_compass_goes_as_far_to_either_side_of_its_point(view: View):
    axis, point = random_axes(6)
    arc = view.about(tuple(axis), tuple(point), 25.0)
    assert (arc.start, arc.sweep) == (-25.0, 50.0)
    assert arc.at(0.0) == pytest.approx(complex(view.way(tuple(point))))
    turned = math.radians(25.0)
    other = (axis @ point) * axis * (1.0 - math.cos(turned))
    other = other + math.cos(turned) * point + math.sin(turned) * np.cross(axis, point)
    assert arc.at(25.0) == pytest.approx(complex(view.way(tuple(other))))


def test_a_circle_about_an_axis_in_the_paper_is_on_edge():
    view = View.of_frame(0.0)
    one, other = view.edge((0.0, 0.0, 1.0), 40.0).points
    along = complex(view.way((0.0, 0.0, 1.0)))
    assert (one * along.conjugate()).real == pytest.approx(math.cos(math.radians(40.0)))
    assert one - other == pytest.approx(2j * math.sin(math.radians(40.0)) * along)


def test_a_circle_along_its_axis_is_round():
    arc = circle(1 + 1j, 2.0, 90.0, 45.0)
    assert arc.at(arc.start) == pytest.approx(1 + 3j)
    assert abs(arc.at(arc.start + arc.sweep) - (1 + 1j)) == pytest.approx(2.0)
