"""How strokes come about: from where they begin, the pencil at the tip, and never backwards."""

from __future__ import annotations

import cmath
import math
from functools import cache
from itertools import pairwise

import pytest

from tests.plan.snapshots import SCENES, lesson, lesson_plan
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import (
    Bow,
    Disc,
    Fading,
    Flying,
    Growth,
    Lettering,
    Mark,
    Polygon,
    Polyline,
    Scaling,
    Trimming,
    Turning,
)
from vad.plan.pictures.compasses import HINGE, compass
from vad.strokes.sheet import Arrow

EVERY = pytest.mark.parametrize("scene", SCENES)
SHARES = [k / 8 for k in range(9)]
NEAR = 1e-9
#: What a pencil draws; in views a compass arc stays.
DRAWN = ("construction", "compass arc", "path")


@cache
def board(scene: str) -> Plan:
    return lesson_plan(lesson(scene))


def growing(scene: str, kind: type[Growth]) -> list[Mark]:
    return [m for item in board(scene).items for m in item.marks if isinstance(m.growth, kind)]


def by_role(items: list[Item], role: str) -> list[Mark]:
    return [mark for item in items for mark in item.marks if mark.role == role]


def strokes(scene: str) -> dict[str, list[Item]]:
    """Return the items of each stroke; what a lens shows once more is there at once."""
    found: dict[str, list[Item]] = {}
    for item in board(scene).items:
        if item.stroke.startswith(f"{item.region}:") and item.level is not Level.LENS:
            found.setdefault(item.stroke, []).append(item)
    return found


def length(mark: Mark | None) -> float:
    if mark is None:
        return 0.0
    if isinstance(mark.shape, Bow):
        return abs(math.radians(mark.shape.sweep)) * mark.shape.radius
    assert isinstance(mark.shape, Polyline)
    return sum(abs(b - a) for piece in mark.shape.pieces for a, b in pairwise(piece))


def first(mark: Mark) -> complex:
    shape = mark.shape
    return shape.curve()[0] if isinstance(shape, Bow) else shape.pieces[0][0]


def last(mark: Mark) -> complex:
    shape = mark.shape
    return shape.curve()[-1] if isinstance(shape, Bow) else shape.pieces[-1][-1]


@pytest.mark.exhaustive(8)
@EVERY
def test_what_is_drawn_to_the_end_is_as_it_stays(scene: str):
    for item in board(scene).items:
        for mark in item.marks:
            shown = mark.at(1.0)
            assert shown is not None and shown.alpha == mark.alpha
            for a, b in zip(points(shown), points(mark), strict=True):
                assert abs(a - b) < NEAR, (item.stroke, mark.role)


def points(mark: Mark) -> list[complex]:
    match mark.shape:
        case Polyline(pieces):
            return [z for piece in pieces for z in piece]
        case Polygon(rings):
            return [z for ring in rings for z in ring]
        case Disc(centre, radius):
            return [centre, centre + radius]
        case Bow():
            return mark.shape.curve()
        case Lettering(_, at, size):
            return [at, at + size]


@pytest.mark.exhaustive(4)
@EVERY
def test_lines_grow_from_their_first_point_and_only_grow(scene: str):
    for mark in growing(scene, Trimming):
        shown = [mark.at(share) for share in SHARES]
        lengths = [length(each) for each in shown]
        (begins, _), *_, (ends, _) = mark.growth.knots  # the parts of an arc come one by one
        assert shown[0] is None
        assert lengths == sorted(lengths) and length(mark.at((begins + ends) / 2)) < lengths[-1]
        assert length(mark) == pytest.approx(lengths[-1])
        assert all(abs(first(each) - first(mark)) < NEAR for each in shown if each)


@EVERY
def test_the_head_of_a_vector_runs_from_its_tail_to_its_tip(scene: str):
    heads = 0
    for panel in board(scene).sheet.panels:
        for stroke in panel.strokes if panel.picture == "vectors" else ():
            items = strokes(scene).get(f"{panel.name}:{stroke.name}", [])
            moving = [
                (item, head)
                for item in items
                for head in by_role([item], "head")
                if isinstance(head.growth, Flying)
            ]
            if not isinstance(stroke.shape, Arrow) or not moving:
                continue
            ((item, head),) = moving
            (shaft,) = by_role([item], "vector") or by_role([item], "whole")
            tips = [points(shown)[0] for share in SHARES if (shown := head.at(share))]
            assert len(tips) == len(SHARES)
            assert abs(tips[0] - first(shaft)) < NEAR
            way = tips[-1] - tips[0]
            for share, tip in zip(SHARES, tips, strict=True):
                assert abs(tip - (tips[0] + share * way)) < NEAR
                # The head is as long as its way allows: it does not reach back behind the tail.
                _, left, _, right = points(head.at(share))
                long = abs(tip - (left + right) / 2)
                assert long < max(0.75 * abs(tip - tips[0]), NEAR)
                drawn = shaft.at(share)
                if drawn:  # the shaft ends within its head
                    assert abs(last(drawn) - tip) <= 1.1 * long
                else:
                    assert share == 0.0
            heads += 1
    assert heads


@EVERY
def test_the_pencil_is_at_the_tip_of_what_is_drawn(scene: str):
    pencils = 0
    for name, items in strokes(scene).items():
        moving = [m for m in by_role(items, "pencil") if m.growth]
        drawn = [m for role in DRAWN for m in by_role(items, role)]
        for pencil in moving:
            (line,) = drawn
            for share in SHARES[1:]:
                tip, there = pencil.at(share), line.at(share)
                assert tip and there and isinstance(tip.shape, Disc)
                assert abs(tip.shape.centre - last(there)) < 1e-6, (name, share)
            pencils += 1
    assert pencils


@EVERY
def test_the_compass_stands_in_its_centre_and_does_not_change_its_span(scene: str):
    for mark in growing(scene, Turning):
        if mark.role != "compass leg":
            continue
        centre, _, tip = points(mark)
        for share in SHARES:
            foot, hinge, end = points(mark.at(share))
            assert abs(foot - centre) < NEAR
            assert abs(hinge - foot) == pytest.approx(abs(end - hinge))
            assert abs(end - foot) == pytest.approx(abs(tip - centre))


def test_the_compass_comes_to_rest_beside_labels():
    """It swings to the other side, or opens wider, as often as a label stands on its leg."""
    obstacles = Obstacles(Rect(0.0, 0.0, 0.6, 0.5))
    arc = Bow(0.2 + 0.25j, 0.2, -14.0, 28.0)
    for _ in range(4):
        leg = next(mark for mark in compass(arc, 0, obstacles) if mark.role == "compass leg")
        foot, hinge, tip = points(leg)
        # Beside the hinge, which has that radius, there is white.
        assert obstacles.clear_of_labels([(foot, hinge), (hinge, tip)], 1.9 * HINGE).all()
        x, y = hinge.real, hinge.imag
        obstacles.box(Rect(x - 0.01, y - 0.01, x + 0.01, y + 0.01))


@EVERY
def test_the_set_square_lies_along_its_line_at_the_pencil(scene: str):
    for items in strokes(scene).values():
        squares, lines = by_role(items, "set square"), by_role(items, "construction")
        for square in squares:
            (start, end) = points(lines[0])
            way = (end - start) / abs(end - start)
            for share in SHARES:
                corner, foot, _ = points(square.at(share))[:3]
                across = [((z - start) * way.conjugate()).imag for z in (corner, foot)]
                along = sorted(((z - start) * way.conjugate()).real for z in (corner, foot))
                assert max(map(abs, across)) < 1e-6
                drawn = share * abs(end - start)
                assert along[0] - 1e-6 <= drawn <= along[1] + 1e-6


@EVERY
def test_dots_swell_and_blocks_come_out_of_the_ground(scene: str):
    dots = [mark for mark in growing(scene, Scaling) if isinstance(mark.shape, Disc)]
    for mark in dots:
        discs = [mark.at(share).shape for share in SHARES]
        radii = [disc.radius for disc in discs]
        assert radii == sorted(radii)
        assert radii[0] <= 0.2 * radii[-1]
        assert all(abs(disc.centre - discs[-1].centre) < NEAR for disc in discs)
    for mark in growing(scene, Fading):
        shown = [mark.at(share) for share in SHARES]
        alphas = [each.alpha if each else 0.0 for each in shown]
        assert alphas == sorted(alphas)
        assert (alphas[0], alphas[-1]) == (0.0, 1.0)


def test_lines_that_swell_across_an_axis_keep_their_places_along_it():
    axis = cmath.rect(1.0, 0.4)
    growth = Scaling(1 + 1j, ((0.0, -0.5), (1.0, 1.0)), axis)
    end = 1 + 1j + (3 + 2j) * axis
    mark = Mark(Polyline(((1 + 1j, end),)), "path", growth=growth)
    begun, half = (mark.at(share) for share in (0.0, 0.5))
    for shown, across in ((begun, -1.0), (half, 0.5)):
        assert shown is not None and isinstance(shown.shape, Polyline)
        (line,) = shown.shape.pieces
        assert line[0] == 1 + 1j
        assert abs(line[1] - (1 + 1j + (3 + 1j * across) * axis)) < NEAR
    turned = mark.mapped(2.0, 1j).at(0.0)
    assert turned is not None and isinstance(turned.shape, Polyline)
    assert abs(turned.shape.pieces[0][1] - (2 * (1 + 1j + (3 - 1j) * axis) + 1j)) < NEAR


@pytest.mark.parametrize("sweep", [60.0, -60.0])
def test_a_turn_to_go_is_counter_clockwise_positive(sweep: float):
    turned = Mark(Disc(1 + 0j, 0.1), "pencil", growth=Turning(0j, ((0.0, sweep), (1.0, 0.0))))
    begun = turned.at(0.0)
    assert begun is not None and isinstance(begun.shape, Disc)
    assert abs(begun.shape.centre - cmath.rect(1.0, math.radians(sweep))) < NEAR
