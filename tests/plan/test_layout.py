"""Layout, scale and placement as plain geometry, in page units."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from itertools import cycle, islice

import pytest

import vad
from tests.kinds import KINDS, SPACE
from tests.plan.overlaps import KEY, planned
from tests.plan.sheets import slider_crank
from vad.errors import UsageError
from vad.plan.board import arrange, column, plan
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import Wish, beside, distance, fan, outward, place
from vad.plan.labels.vertices import find_vertices
from vad.plan.layout import FLOOR, GUTTER, Content, Page, Told, lay_out
from vad.plan.marks import Bow, Polygon
from vad.plan.pictures.angle_arcs import ENDS
from vad.plan.reach import corners, extent
from vad.plan.scale import fill, scale_bar

PANELS = {"position": 1, "velocity": 1, "acceleration": 1}


def contents(lines: dict[str, int]) -> dict[str, Content]:
    """Return a mechanism twice as wide as high, and polygons, with lines at their feet."""
    shapes = [2 + 1j, *[0j] * (len(lines) - 1)]
    return {
        name: Content([shape], lambda _, told, count=count: count if told else 0)
        for (name, count), shape in zip(lines.items(), shapes, strict=True)
    }


def laid_out(size: tuple[int, int], panels: dict[str, int] = PANELS, captions: int = 0) -> Page:
    return lay_out(screen(size), contents(panels), 3, captions)


def test_three_columns_from_three_to_two_and_two_by_two_below():
    assert laid_out((1280, 720)).columns
    assert laid_out((1080, 720)).columns
    assert not laid_out((1024, 768)).columns


def test_columns_are_equal_and_fill_the_page():
    drawings = [place.drawing for place in laid_out((1280, 720)).panels.values()]
    assert drawings[0].left * 720 == pytest.approx(36)
    assert drawings[-1].right * 720 == pytest.approx(1244)
    assert len({round(drawing.width, 9) for drawing in drawings}) == 1


def test_one_panel_takes_the_whole_width():
    page = laid_out((1280, 720), {"velocity": 1}, 1)
    assert page.columns
    assert page.panels["velocity"].drawing.width * 720 == pytest.approx(1208)


@pytest.mark.parametrize("count", range(1, 10))
@pytest.mark.parametrize("size", [(1280, 720), (1024, 768), (400, 600), (2000, 500)])
@pytest.mark.parametrize("captions", [0, 2])
def test_any_number_of_panels_has_room_and_none_overlaps(count: int, size, captions: int):
    page = laid_out(size, {f"panel {number}": 1 for number in range(count)}, captions)
    areas = [place.region for place in page.panels.values()]
    if page.results:
        areas.append(page.results)
    for number, one in enumerate(areas):
        assert one.width > 0.1
        assert one.height > 0.1
        for other in areas[:number]:
            apart = one.left >= other.right - 1e-9 or other.left >= one.right - 1e-9
            assert apart or one.bottom >= other.top - 1e-9 or other.bottom >= one.top - 1e-9
    assert all(place.drawing.height > 0.05 for place in page.panels.values())


def test_four_panels_and_the_results_stand_in_three_columns_of_a_narrow_page():
    page = laid_out((1024, 768), dict.fromkeys("abcd", 1))
    assert len({place.drawing.left for place in page.panels.values()}) == 3
    assert page.results.left == page.panels["a"].drawing.left
    assert page.results.top < page.panels["a"].drawing.bottom


@pytest.mark.parametrize("captions", [0, 2])
@pytest.mark.parametrize("lines", [1, 2])
def test_four_panels_stand_side_by_side_on_a_wide_page(captions: int, lines: int):
    names = ["position", "acceleration", "force", "drive"]
    page = laid_out((1280, 720), dict.fromkeys(names, lines), captions)
    wide = {name: place.drawing.width for name, place in page.panels.items()}
    assert page.columns
    assert wide["position"] > wide["acceleration"] > wide["drive"]
    assert wide["force"] == pytest.approx(wide["acceleration"])
    assert page.panels["drive"].drawing.right == pytest.approx(page.right)


def test_four_panels_stand_in_a_grid_where_many_rows_would_make_their_pictures_flat():
    form, names = screen((1280, 720)), dict.fromkeys("abcd", 1)
    assert lay_out(form, contents(names), rows=4, caption_lines=2).columns
    assert not lay_out(form, contents(names), rows=12, caption_lines=2).columns


@pytest.mark.parametrize("size", [(1280, 720), (1024, 768)])
def test_no_cell_of_a_grid_stays_empty(size: tuple[int, int]):
    for count in range(2, 9):
        page = laid_out(size, dict.fromkeys("abcdefgh"[:count], 1))
        if page.results and not page.columns:
            assert page.results.left == pytest.approx(page.left)
            lowest = {place.drawing.left: place for place in page.panels.values()}
            tops = [page.results.top, *(p.foot.top for p in page.panels.values() if p.foot)]
            for left, place in lowest.items():
                end = max(tops) if left < page.results.right else FLOOR
                assert place.region.bottom - end < 0.03
            rights = [page.results.right, *(each.drawing.right for each in lowest.values())]
            assert max(rights) == pytest.approx(page.right)


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_drawings_are_large_on_a_narrow_page(kind: type[vad.Mechanism]):
    form, sheet = screen((960, 720)), vad.draw(vad.solve(kind()))
    page, _ = arrange(sheet, form, 0)
    drawings = {name: place.drawing for name, place in page.panels.items()}
    share = sum(each.width * each.height for each in drawings.values()) / form.width / form.height
    assert share > (0.38 if kind in SPACE.values() else 0.39)
    for panel in sheet.panels:
        room = drawings[panel.name]
        assert min(room.width, room.height) > 0.29
        if panel.picture == "skeleton":
            points = corners(panel)
            extended = extent(points) * fill(points, room, position=True).factor
            assert max(extended.real, extended.imag) > 0.25


@pytest.mark.parametrize(("height", "column"), [(4.0, 0.33), (9.0, 0.30)])
def test_a_slender_column_is_wider_if_the_mechanism_in_it_becomes_larger(height, column):
    given = contents({"a": 1, "b": 1, "c": 1})
    given["a"] = given["a"]._replace(shapes=[complex(2.0, height)])
    page = lay_out(screen((960, 720)), given, 3, 0)
    first, *others = (place.drawing.width for place in page.panels.values())
    assert first == pytest.approx(column)
    assert len(others) == 2 and min(others) > 0.40
    assert first + sum(others) == pytest.approx(page.right - page.left - 2 * GUTTER)


def test_a_narrow_still_leaves_out_equations_only_for_larger_drawings():
    form = screen((960, 720))
    few, many = (lay_out(form, contents(dict.fromkeys("abc", n)), 3, 0) for n in (1, 5))
    assert (few.told, many.told) == (Told.TOGETHER, Told.NOWHERE)
    (first, *_), (larger, *_) = (list(page.panels.values()) for page in (few, many))
    assert larger.drawing.height > first.drawing.height + 0.1
    feet = [place.foot for place in few.panels.values()]
    assert [foot.top for foot in feet[1:]] == pytest.approx([foot.bottom for foot in feet[:-1]])
    assert feet[-1].bottom == pytest.approx(few.results.top)
    assert feet[0].top <= first.drawing.bottom
    lesson = lay_out(form, contents(dict.fromkeys("abc", 5)), 3, 2)
    assert lesson.told is Told.FEET


def test_a_page_is_the_same_at_every_size():
    for wide, high in ((16, 9), (4, 3)):
        small, large = (laid_out((wide * k, high * k), captions=2) for k in (40, 240))
        assert small == large


def test_fill_scale_holds_all_points_inside_the_padding_and_centred():
    room = Rect(0, 0, 400 / 300, 1.0)
    points = [0j, 10 + 3j, -4 + 8j]
    scale = fill(points, room, position=False)
    xs = [scale(p).real for p in points]
    assert min(xs) == pytest.approx(room.right - max(xs))
    assert min(xs) >= 0.075 - 1e-9


def test_padding_takes_no_more_than_half_of_a_small_drawing():
    for position in (False, True):
        small = Rect(0, 0, 0.06, 0.05)
        scale = fill([0j, 1 + 0j, 1j], small, position)
        assert scale.factor >= 0.025 * (1 - 1e-9)
        assert all(small.holds(scale(point)) for point in (0j, 1 + 0j, 1j))


@pytest.mark.parametrize("size", [(1280, 720), (1024, 768), (600, 900)])
def test_however_many_rows_there_are_a_sheet_is_drawn_or_refused(
    size: tuple[int, int], exhaustive: bool
):
    """In a usual run one number of rows in five is tried."""
    sheet, refused = slider_crank(), []
    counts = range(1, 25, 1 if exhaustive else 5)
    for count in counts:
        many = replace(sheet, rows=tuple(islice(cycle(sheet.rows), count)))
        try:
            assert plan(many, screen(size), KEY).items
        except UsageError as error:
            refused.append(count)
            assert f"{count} rows" in str(error)
    assert refused == list(counts)[len(counts) - len(refused) :]  # those that are too many


@pytest.mark.parametrize("factor", [1e-7, 0.013, 0.5, 1.0, 86.4, 3e9])
def test_scale_bar_is_a_round_number_not_longer_than_its_room(factor: float):
    value = scale_bar(factor, 0.12)
    assert value * factor <= 0.12 * (1 + 1e-6)
    assert value * factor > 0.12 / 2.51
    mantissa = value / 10 ** math.floor(math.log10(value * (1 + 1e-9)))
    assert min(abs(mantissa - step) for step in (1, 2, 5)) < 1e-6


def test_a_label_stands_at_its_distance_along_the_bisector():
    centre = beside(0j, 1 + 0j, 10.0, 20.0, 8.0)
    assert centre == pytest.approx(20.0)
    assert outward([1 + 0j, 1j]) == pytest.approx(cmath.rect(1, math.radians(225)))
    assert fan(1 + 0j, 16)[1] == pytest.approx(cmath.rect(1, math.radians(22.5)))


def test_placed_labels_never_overlap_however_many_there_are(exhaustive):
    edge = Rect(0, 0, 1, 1)
    obstacles = Obstacles(edge)
    obstacles.line([0.07 + 0.5j, 0.93 + 0.5j], 0.01)
    boxes = [
        place(obstacles, Wish(0.5 + 0.5j, 1j, 0.10, 0.053)).box
        for _ in range(20 if exhaustive else 12)
    ]
    for number, box in enumerate(boxes):
        assert edge.holds(complex(box.left, box.bottom))
        assert edge.holds(complex(box.right, box.top))
        assert box.bottom > 0.51 or box.top < 0.49
        for other in boxes[:number]:
            apart_x = box.left >= other.right or other.left >= box.right
            assert apart_x or box.bottom >= other.top or other.bottom >= box.top


def test_a_leader_that_must_cross_something_crosses_the_thinner():
    obstacles = Obstacles(Rect(0, 0, 1, 1))
    obstacles.line([0.53j, 1 + 0.53j], 0.02)
    obstacles.line([0.47j, 1 + 0.47j], 0.001)
    placed = place(obstacles, Wish(0.5 + 0.5j, 1j, 0.10, 0.053))
    assert placed.leader
    assert placed.box.top < 0.47


def test_letters_are_smaller_where_a_leader_would_cross_a_vector():
    """Beside c″ₙ of a four-bar at 90° a large letter has no place, and all round are vectors."""
    sheet, form = vad.draw(vad.solve(vad.FourBar(), angle=90)), screen((1280, 720))
    drawing = planned(sheet).page.panels["acceleration"].drawing
    for lenses in (False, True):
        panel = sheet.panel("acceleration")
        sketch = column(sheet, panel, drawing, form, lenses=lenses)["acceleration"]
        [tag] = [t for t in sketch.tags if t.text == "c″ₙ" and t.span[1] == FOREVER]
        [at] = [vertex.at for vertex in sketch.vertices if vertex.label == "c″ₙ"]
        shown = [lens(at) for lens in sketch.lenses if abs(lens(at) - lens.at) < lens.radius]
        assert not shown  # beside its dot the letter needs no lens
        assert abs(tag.box.centre - at) < 0.05


@pytest.mark.parametrize(("angle", "whole"), [(75, True), (90, False), (300, False)])
def test_the_arc_of_an_angle_is_smaller_where_it_would_cross_a_link(angle: float, whole: bool):
    board = planned(vad.draw(vad.solve(vad.CrankSlottedLever(), angle=angle)))
    marks = [mark for item in board.shown(board.finished) for mark in item.marks]
    arcs = [mark.shape for mark in marks if mark.role == "angle"]
    [slit] = [mark.shape for mark in marks if mark.role == "slit"]
    assert arcs and isinstance(slit, Polygon)
    for arc in arcs:
        assert isinstance(arc, Bow) and (arc.radius > 0.08) == whole
    start, end, *_ = slit.rings[0]
    # What is drawn to show where it begins and ends may meet the sides of the slit.
    ends = arcs[0].line()[0], arcs[-1].line()[-1]
    inner = [z for arc in arcs for z in arc.line() if min(abs(z - each) for each in ends) > ENDS]
    seen = [(z - start) / (end - start) for z in inner]
    off = [abs(z.imag) * abs(end - start) for z in seen if 0.0 < z.real < 1.0]
    assert min(off) > 0.003


def test_the_arc_of_an_angle_has_no_gap_beside_its_own_crank():
    board = planned(slider_crank())
    marks = [mark for item in board.shown(board.finished) for mark in item.marks]
    assert len([mark for mark in marks if mark.role == "angle"]) == 1


def test_points_share_a_label_where_they_are_equal_and_not_where_they_look_so():
    sheet = slider_crank()
    panel, sketch = sheet.panel("velocity"), planned(sheet).sketches["velocity"]
    assert [v.label for v in find_vertices(panel, sketch.scale)] == ["a, d", "b", "c"]
    tiny = fill(corners(panel), Rect(0, 0, 0.024, 0.026), position=False)
    assert [v.label for v in find_vertices(panel, tiny)] == ["a, d", "b", "c"]


def test_a_label_far_from_its_dot_stands_beside_no_other():
    obstacles = Obstacles(Rect(0.0, 0.0, 0.4, 0.4))
    at, rivals = 0.2 + 0.2j, [0.25 + 0.2j, 0.15 + 0.2j, 0.2 + 0.25j, 0.2 + 0.15j]
    obstacles.disc(at, 0.03)
    placed = place(obstacles, Wish(at, 1 + 0j, 0.02, 0.02, rivals=rivals))
    assert placed.leader
    assert not placed.forced
    assert min(distance(placed.box, rival) for rival in rivals) >= 20 / 720
