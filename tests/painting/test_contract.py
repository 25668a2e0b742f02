"""What every painter does with a shape and its look, read back from pixels.

A page of 400 by 300 pixels; lengths here are in pixels with y up, as on the page.
"""

from __future__ import annotations

import cmath
import math
import os
from collections.abc import Callable, Sequence

import matplotlib
import numpy as np
import pytest
from fontTools.pens.boundsPen import BoundsPen
from fontTools.ttLib import TTFont
from numpy.typing import NDArray

import vad
from tests.painting.readers import MEDIA, Medium, Pixels
from vad.painting.posed import posed
from vad.plan.format import Format
from vad.plan.items import Item, Level
from vad.plan.lettering.runs import Run
from vad.plan.marks import Bow, Disc, Lettering, Mark, Outline, Polygon, Polyline
from vad.plan.roles import ROLES
from vad.style import Look, Pen, load_style

pytestmark = pytest.mark.exhaustive

WIDTH, HEIGHT = 400, 300
FORM = Format(WIDTH / HEIGHT, 1.0, HEIGHT)
BLACK, WHITE, BLUE, RED = "#000000", "#FFFFFF", "#0072B2", "#D55E00"

Marks = Sequence[tuple[Outline, Look]]
Paint = Callable[..., Pixels]


@pytest.fixture(params=MEDIA)
def paint(request: pytest.FixtureRequest) -> Paint:
    """Return what paints marks on a ground, and reads the pixels back, once per medium."""

    def painted(*marks: tuple[Outline, Look], ground: str = WHITE, form: Format = FORM) -> Pixels:
        medium = Medium(request.param, form)
        medium.painter.begin(form, ground)
        medium.painter.group(Item("velocity:AB.whole", "velocity", Level.STROKE, ()))
        for shape, look in marks:
            medium.painter.paint(Mark(shape, "vector"), look)
        medium.painter.end()
        return medium.pixels()

    return painted


def z(x: float, y: float) -> complex:
    return complex(x, y) / HEIGHT


def line(*points: tuple[float, float]) -> Polyline:
    return Polyline((tuple(z(*point) for point in points),))


def ring(*points: tuple[float, float]) -> tuple[complex, ...]:
    return tuple(z(*point) for point in points)


def box(left: float, bottom: float, right: float, top: float) -> tuple[complex, ...]:
    return ring((left, bottom), (right, bottom), (right, top), (left, top))


def pen(width: float, colour: str = BLACK, dash: tuple[float, ...] = (), **kind: str) -> Pen:
    return Pen(colour, width / HEIGHT, tuple(part / HEIGHT for part in dash), **kind)


def ink(pixels: Pixels) -> NDArray[np.float64]:
    """Return how much of each pixel is covered by black on white, rows from the bottom up."""
    return (1.0 - pixels.mean(axis=2) / 255.0)[::-1]


def middle(cover: NDArray[np.float64]) -> complex:
    rows, columns = np.mgrid[: cover.shape[0], : cover.shape[1]] + 0.5
    return complex((columns * cover).sum(), (rows * cover).sum()) / cover.sum()


def rgb(colour: str) -> tuple[int, ...]:
    return tuple(int(colour[i : i + 2], 16) for i in (1, 3, 5))


def at(pixels: Pixels, x: int, y: int) -> Pixels:
    return pixels[HEIGHT - 1 - y, x]


def test_the_background_is_everywhere(paint: Paint) -> None:
    pixels = paint(ground="#1D2B27")
    assert pixels.shape == (HEIGHT, WIDTH, 3)
    assert np.abs(pixels - rgb("#1D2B27")).max() <= 1


@pytest.mark.parametrize("medium", MEDIA[1:])
def test_the_edge_has_the_background_too(medium: str) -> None:
    form = Format(1.0, 1.0, 200.0, edge=0.1)
    page = Medium(medium, form)
    page.painter.begin(form, "#1D2B27")
    page.painter.paint(Mark(Polygon(((0j, 1 + 0j, 1 + 1j, 1j),)), "block"), Look(WHITE))
    page.painter.end()
    pixels = page.pixels()
    assert pixels.shape == (240, 240, 3)
    assert np.abs(pixels[20:-20, 20:-20] - 255).max() <= 1
    pixels[20:-20, 20:-20] = rgb("#1D2B27")
    assert np.abs(pixels - rgb("#1D2B27")).max() <= 1


def test_an_area_is_filled_with_its_colour(paint: Paint) -> None:
    pixels = paint((Polygon((box(100, 80, 200, 140),)), Look(BLUE)))
    inside = pixels[HEIGHT - 140 : HEIGHT - 80, 100:200]
    assert np.abs(inside - rgb(BLUE)).max() <= 1
    assert (np.abs(pixels - 255).max(axis=2) > 1).sum() == 100 * 60


def test_a_line_is_as_wide_as_its_pen(paint: Paint) -> None:
    cover = ink(paint((line((50, 150.3), (350, 150.3)), Look(pen=pen(10)))))
    across = cover[:, 100:300].sum(axis=0)
    assert np.abs(across - 10).max() < 0.2
    assert middle(cover) == pytest.approx(z(200, 150.3) * HEIGHT, abs=0.1)


def test_lines_are_open_and_areas_are_closed(paint: Paint) -> None:
    corners = ((100, 50), (300, 50), (200, 250))
    opened = ink(paint((line(*corners), Look(pen=pen(4)))))
    closed = ink(paint((Polygon((ring(*corners),)), Look(pen=pen(4)))))
    assert opened[150, 140:160].sum() == pytest.approx(0.0, abs=0.01)
    assert closed[150, 140:160].sum() > 3.5
    assert opened[130, 160:240].sum() == closed[130, 160:240].sum() == 0.0


def test_pieces_are_apart(paint: Paint) -> None:
    pieces = ring((50, 100), (150, 100)), ring((250, 100), (350, 100))
    cover = ink(paint((Polyline(pieces), Look(pen=pen(4)))))
    assert cover.sum() == pytest.approx(800, abs=4)
    assert cover[:, 155:245].sum() == 0.0


@pytest.mark.parametrize(("alpha", "grey"), [(0.5, 128), (0.2, 204), (0.45, 140)])
def test_alpha_lets_the_ground_through(paint: Paint, alpha: float, grey: int) -> None:
    area = Polygon((box(50, 50, 150, 250),))
    marks = (
        (area, Look(BLACK, alpha=alpha)),
        (line((200, 150), (350, 150)), Look(pen=pen(40), alpha=alpha)),
        (Polygon((box(220, 20, 330, 80),)), Look(BLACK)),
    )
    pixels = paint(*marks)
    assert at(pixels, 100, 150) == pytest.approx([grey] * 3, abs=2)
    assert at(pixels, 275, 150) == pytest.approx([grey] * 3, abs=2)
    assert at(pixels, 275, 50) == pytest.approx([0] * 3, abs=1)


def test_a_line_that_crosses_itself_is_not_darker_there(paint: Paint) -> None:
    cross = line((100, 150), (300, 150), (300, 200), (200, 200), (200, 100))
    pixels = paint((cross, Look(pen=pen(20), alpha=0.5)))
    assert at(pixels, 200, 150) == pytest.approx(at(pixels, 120, 150), abs=2)


def test_dashes_are_on_and_off_in_turn(paint: Paint) -> None:
    cover = ink(paint((line((50, 150), (350, 150)), Look(pen=pen(6, dash=(30, 10, 5, 10))))))
    along = cover[149:151].mean(axis=0)
    edges = np.flatnonzero(np.diff((along > 0.5).astype(int))) + 1 - 50
    turns = [start + k for start in range(0, 300, 55) for k in (0, 30, 40, 45)]
    assert edges == pytest.approx([*(k for k in turns if k < 300), 300], abs=0.6)
    assert cover[:, 60:70].sum() == pytest.approx(60, abs=1)


def test_dashes_begin_anew_with_each_piece(paint: Paint) -> None:
    pieces = ring((50, 100), (80, 100)), ring((50, 200), (80, 200))
    cover = ink(paint((Polyline(pieces), Look(pen=pen(6, dash=(20, 20))))))
    assert cover[90:110] == pytest.approx(cover[190:210], abs=0.02)
    assert cover[90:110].sum() == pytest.approx(120, abs=1)


@pytest.mark.parametrize(("cap", "beyond"), [("butt", 0.0), ("round", math.pi / 4 * 400)])
def test_caps(paint: Paint, cap: str, beyond: float) -> None:
    cover = ink(paint((line((100, 150), (300, 150)), Look(pen=pen(20, cap=cap)))))
    assert cover.sum() == pytest.approx(200 * 20 + beyond, rel=0.002)
    reach = np.flatnonzero(cover[150] > 0.5)
    assert (reach[0], reach[-1]) == ((90, 309) if beyond else (100, 299))


@pytest.mark.parametrize(("join", "corner"), [("miter", 1.0), ("round", math.pi / 4)])
def test_joins(paint: Paint, join: str, corner: float) -> None:
    angle = line((100, 250), (100, 100), (250, 100))
    cover = ink(paint((angle, Look(pen=pen(40, join=join)))))
    assert cover[80:100, 80:100].sum() == pytest.approx(corner * 400, abs=4)


def test_a_sharp_corner_is_cut_off(paint: Paint) -> None:
    for rise, reach in ((25, 335), (15, 300)):  # as long as 8 and 13 widths: 10 are allowed
        spike = line((100, 150 - rise), (300, 150), (100, 150 + rise))
        inked = np.flatnonzero(ink(paint((spike, Look(pen=pen(10)))))[149:151].mean(axis=0) > 0.5)
        assert inked[-1] == pytest.approx(reach, abs=1.5)


def test_a_ring_the_other_way_round_is_a_hole(paint: Paint) -> None:
    outer, inner = box(100, 50, 300, 250), box(150, 100, 250, 200)
    with_hole = ink(paint((Polygon((outer, inner[::-1])), Look(BLACK))))
    without = ink(paint((Polygon((outer, inner)), Look(BLACK))))
    assert with_hole.sum() == pytest.approx(200 * 200 - 100 * 100, abs=2)
    assert without.sum() == pytest.approx(200 * 200, abs=2)


def test_a_disc_is_round_and_in_its_place(paint: Paint) -> None:
    disc = Disc(z(180.4, 120.7), 50 / HEIGHT)
    cover = ink(paint((disc, Look(BLACK))))
    assert cover.sum() == pytest.approx(math.pi * 2500, rel=0.004)
    assert abs(middle(cover) - (180.4 + 120.7j)) < 0.1
    rim = ink(paint((disc, Look(WHITE, pen(8)))))
    assert rim.sum() == pytest.approx(math.pi * (54**2 - 46**2), rel=0.008)
    assert rim[120, 180] == pytest.approx(0.0, abs=0.01)


@pytest.mark.parametrize(
    ("start", "sweep"), [(0, 90), (30, -75), (200, 300), (-20, 14), (0, 360), (90, -360), (5, 180)]
)
def test_a_bow_runs_from_its_start_over_its_sweep(paint: Paint, start: float, sweep: float) -> None:
    centre, radius, width = 200 + 150j, 100.0, 6.0
    bow = Bow(centre / HEIGHT, radius / HEIGHT, start, sweep)
    cover = ink(paint((bow, Look(pen=pen(width)))))
    assert cover.sum() == pytest.approx(radius * math.radians(abs(sweep)) * width, rel=0.01)
    rows, columns = np.nonzero(cover > 0.02)
    away = columns + 0.5 + 1j * (rows + 0.5) - centre
    assert np.abs(np.abs(away) - radius).max() < width / 2 + 1.2
    for share in (0.1, 0.5, 0.9):
        spot = centre + cmath.rect(radius, math.radians(start + share * sweep))
        assert cover[int(spot.imag), int(spot.real)] > 0.95
    if abs(sweep) < 340:
        for angle in (start - math.copysign(6, sweep), start + sweep + math.copysign(6, sweep)):
            spot = centre + cmath.rect(radius, math.radians(angle))
            assert cover[int(spot.imag), int(spot.real)] < 0.05


@pytest.mark.parametrize(
    ("axis", "narrow", "start", "sweep"),
    [(30, 0.5, 0, 360), (-70, 0.2, 40, -200), (135, 0.01, 90, 180)],
)
def test_a_narrow_bow_is_a_circle_seen_from_aside(
    paint: Paint, axis: float, narrow: float, start: float, sweep: float
) -> None:
    centre, radius, width = 200 + 150j, 100.0, 6.0
    way = cmath.rect(1.0, math.radians(axis))
    bow = Bow(centre / HEIGHT, radius / HEIGHT, start, sweep, way, narrow)
    angles = np.radians(start + sweep * np.linspace(0.0, 1.0, 721))
    circle = radius * np.exp(1j * angles) * way.conjugate()
    seen = centre + way * (circle.real + 1j * narrow * circle.imag)
    cover = ink(paint((bow, Look(pen=pen(width, join="round")))))
    rows, columns = np.nonzero(cover > 0.02)
    spots = columns + 0.5 + 1j * (rows + 0.5)
    assert np.abs(spots[:, None] - seen).min(axis=1).max() < width / 2 + 1.2
    for spot in seen[20:-20:25]:
        assert cover[int(spot.imag), int(spot.real)] > 0.95


@pytest.mark.parametrize("marks", [(), ((Polyline(()), Look(pen=pen(3))),)])
def test_nothing_is_nothing(paint: Paint, marks: Marks) -> None:
    assert ink(paint(*marks)).sum() == 0.0
    assert ink(paint((Lettering((Run(" "),), 0j, 0.1), Look(BLACK)))).sum() == 0.0


def test_what_is_painted_later_lies_above(paint: Paint) -> None:
    low, high = Polygon((box(50, 50, 200, 200),)), Polygon((box(150, 150, 300, 250),))
    band = line((60, 100), (190, 100))
    marks = (low, Look(RED)), (high, Look(BLUE)), (band, Look(pen=pen(10)))
    pixels = paint(*marks)
    assert at(pixels, 175, 175) == pytest.approx(rgb(BLUE), abs=1)
    assert at(pixels, 100, 100) == pytest.approx(rgb(BLACK), abs=1)
    assert at(paint(*marks[::-1]), 175, 175) == pytest.approx(rgb(RED), abs=1)


def test_the_line_lies_above_the_area_and_both_above_what_is_beneath(paint: Paint) -> None:
    area = Polygon((box(100, 100, 200, 200),))
    pixels = paint((area, Look(BLUE, pen(10, RED), pen(30, BLACK))))
    assert at(pixels, 150, 150) == pytest.approx(rgb(BLUE), abs=1)
    assert at(pixels, 103, 150) == pytest.approx(rgb(RED), abs=1)
    assert at(pixels, 97, 150) == pytest.approx(rgb(RED), abs=1)
    assert at(pixels, 90, 150) == pytest.approx(rgb(BLACK), abs=1)


def test_what_lies_beneath_is_as_dark_as_ever(paint: Paint) -> None:
    look = Look(pen=pen(10, WHITE), under=pen(40, BLACK), alpha=0.5)
    pixels = paint((line((50, 150), (350, 150)), look))
    assert at(pixels, 200, 162) == pytest.approx([0] * 3, abs=1)
    assert at(pixels, 200, 150) == pytest.approx([128] * 3, abs=2)


def test_a_dash_is_cleared_of_what_lies_beneath(paint: Paint) -> None:
    ground = Polygon((box(0, 0, 400, 300),))
    dashed = Look(pen=pen(6, BLUE, (20, 20)), under=pen(16, WHITE))
    pixels = paint((ground, Look(BLACK)), (line((50, 150), (350, 150)), dashed))
    assert at(pixels, 60, 150) == pytest.approx(rgb(BLUE), abs=1)
    assert at(pixels, 80, 150) == pytest.approx(rgb(WHITE), abs=1)
    assert at(pixels, 60, 156) == pytest.approx(rgb(WHITE), abs=1)
    assert at(pixels, 60, 160) == pytest.approx(rgb(BLACK), abs=1)


FACES = {
    "roman": "STIXGeneral",
    "italic": "STIXGeneralItalic",
    "bold": "STIXGeneralBol",
    "bolditalic": "STIXGeneralBolIta",
}


class Letter:
    """A letter as fontTools measures it, in ems: its advance and the box of its ink."""

    def __init__(self, text: str, face: str = "roman") -> None:
        folder = os.path.join(matplotlib.get_data_path(), "fonts", "ttf")
        font = TTFont(os.path.join(folder, FACES[face] + ".ttf"))
        glyphs, name = font.getGlyphSet(), font.getBestCmap()[ord(text)]
        bounds = BoundsPen(glyphs)
        glyphs[name].draw(bounds)
        em = font["head"].unitsPerEm
        self.advance = glyphs[name].width / em
        self.left, self.bottom, self.right, self.top = (each / em for each in bounds.bounds)


def reach(cover: NDArray[np.float64]) -> tuple[float, float, float, float]:
    """Return the box of the ink, its sides to a part of a pixel."""

    def ends(most: NDArray[np.float64]) -> tuple[float, float]:
        inked = np.flatnonzero(most > 0.05)
        return inked[0] + 1 - most[inked[0]], inked[-1] + most[inked[-1]]

    (left, right), (bottom, top) = ends(cover.max(axis=0)), ends(cover.max(axis=1))
    return left, bottom, right, top


@pytest.mark.parametrize("face", FACES)
@pytest.mark.parametrize("size", [24.0, 120.0])
def test_text_stands_on_its_baseline_in_its_face_and_size(
    paint: Paint, face: str, size: float
) -> None:
    text = Lettering((Run("HE", face),), z(60.5, 90.25), size / HEIGHT)
    left, bottom, right, top = reach(ink(paint((text, Look(BLACK)))))
    first, second = Letter("H", face), Letter("E", face)
    assert left == pytest.approx(60.5 + size * first.left, abs=0.7)
    assert right == pytest.approx(60.5 + size * (first.advance + second.right), abs=0.7)
    assert bottom == pytest.approx(90.25 + size * first.bottom, abs=0.7)
    assert top == pytest.approx(90.25 + size * first.top, abs=0.7)


@pytest.mark.parametrize(("script", "rise"), [(-1, -0.16), (1, 0.38)])
def test_scripts_are_small_and_off_the_baseline(paint: Paint, script: int, rise: float) -> None:
    size, whole, small = 100.0, Letter("H"), Letter("E", "italic")
    runs = Run("H"), Run("E", "italic", script)
    cover = ink(paint((Lettering(runs, z(100, 100), size / HEIGHT), Look(BLACK))))
    start = 100 + size * whole.advance
    _, bottom, right, top = reach(cover[:, round(100 + size * whole.right + 1) :])
    offset = round(100 + size * whole.right + 1)
    assert right + offset == pytest.approx(start + 0.7 * size * small.right, abs=0.7)
    assert bottom == pytest.approx(100 + size * (rise + 0.7 * small.bottom), abs=0.7)
    assert top == pytest.approx(100 + size * (rise + 0.7 * small.top), abs=0.7)


def test_what_is_not_shown_takes_up_its_room(paint: Paint) -> None:
    runs = Run("H", shown=False), Run("H")
    left, *_ = reach(ink(paint((Lettering(runs, z(100, 100), 80 / HEIGHT), Look(BLACK)))))
    letter = Letter("H")
    assert left == pytest.approx(100 + 80 * (letter.advance + letter.left), abs=0.7)


def test_blanks_keep_their_room(paint: Paint) -> None:
    text = Lettering((Run("1   H"),), z(50, 100), 60 / HEIGHT)
    *_, right, _ = reach(ink(paint((text, Look(BLACK)))))
    one, letter = Letter("1"), Letter("H")
    blank = 0.25  # of an em, in STIX
    assert right == pytest.approx(50 + 60 * (one.advance + 3 * blank + letter.right), abs=0.7)


def test_text_may_be_pale(paint: Paint) -> None:
    text = Lettering((Run("H", "bold"),), z(100, 50), 300 / HEIGHT)
    pixels = paint((text, Look(BLUE, alpha=0.42)))
    expected = [255 + 0.42 * (part - 255) for part in rgb(BLUE)]
    darkest = pixels[pixels.sum(axis=2) <= pixels.sum(axis=2).min() + 2]
    assert len(darkest) > 500
    assert darkest.mean(axis=0) == pytest.approx(expected, abs=2)


def test_a_halo_clears_what_lies_around_a_letter(paint: Paint) -> None:
    ground = Polygon((box(0, 0, 400, 300),)), Look(BLUE)
    text = Lettering((Run("l"),), z(150, 100), 150 / HEIGHT)
    halo = pen(24, WHITE, cap="round", join="round")
    pixels = paint(ground, (text, Look(BLACK, under=halo)))
    row = pixels[HEIGHT - 150]
    black = np.flatnonzero(row.sum(axis=1) < 60)
    letter = Letter("l")
    assert letter.left * 150 < black[0] - 150 and black[-1] - 150 < letter.right * 150
    for beside in (black[0] - 8, black[-1] + 8):
        assert row[beside] == pytest.approx([255] * 3, abs=1)
    for farther in (black[0] - 16, black[-1] + 16):
        assert row[farther] == pytest.approx(rgb(BLUE), abs=1)


def test_the_halo_of_one_letter_does_not_cover_another(paint: Paint) -> None:
    runs = Run("b", "italic"), Run("′"), Run("n", "italic", -1), Run("c", "italic"), Run("d")
    text = Lettering(runs, z(100, 100), 90 / HEIGHT)
    plain = ink(paint((text, Look(BLACK))))
    haloed = ink(paint((text, Look(BLACK, under=pen(27, WHITE, cap="round", join="round")))))
    assert np.abs(plain - haloed).max() < 0.02


class Listener:
    """A painter that notes what it is told: a medium could name its styles by that."""

    def __init__(self) -> None:
        self.told: list[tuple[str, Level, str, int | None, Look]] = []

    def begin(self, form: Format, background: str) -> None:
        """Begin nothing."""

    def group(self, item: Item) -> None:
        self.item = item

    def paint(self, mark: Mark, look: Look) -> None:
        self.told.append((self.item.stroke, self.item.level, mark.role, mark.row, look))

    def end(self) -> None:
        """End nothing."""


@pytest.mark.parametrize("style", ["paper", "print"])
def test_a_painter_is_told_stroke_role_and_row_of_every_mark(style: str) -> None:
    listener = Listener()
    posed(vad.draw(vad.solve(vad.SliderCrank())), style=style).play(listener)
    vectors = {
        (stroke, row) for stroke, _, role, row, _ in listener.told if role in ("vector", "whole")
    }
    assert {("velocity:AB.tangential", 0), ("acceleration:BC.normal", 1)} <= vectors
    looks: dict[tuple[str, int | None], set[Look]] = {}
    for _, _, role, row, look in listener.told:
        looks.setdefault((role, row), set()).add(look)
    assert {role for role, _ in looks} <= set(ROLES)
    assert looks["vector", 1] == {load_style(style).look("vector", 1)}
    pens = {key: each.pen for key, (each, *_) in looks.items() if each.pen}
    assert len(pens) > 15  # a style each, and no look had to be guessed back from a colour
