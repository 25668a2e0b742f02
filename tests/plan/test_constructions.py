"""Constructions: where the set square slides, and where compass arcs and guides meet.

Wherever the set square slides, it is in its panel and its leg is at the pencil.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import cache
from itertools import combinations, pairwise
from typing import Any

import pytest

import vad
from tests.kinds import KINDS, SPACE
from tests.plan.overlaps import planned
from vad.files.examples import example_path
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Item, Level, together
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import find_vertices
from vad.plan.marks import Bow, Mark, Polygon, Polyline
from vad.plan.pictures.constructions import LONG_LEG, place_square
from vad.plan.sketch import Sketch
from vad.plan.stage import Stage
from vad.strokes.sheet import Arrow, Block, Dot

ROOM = Rect(0.0, 0.0, 0.56, 0.35)
PIXEL = 1 / 720
IN_THE_PLANE = [kind for kind in KINDS if kind not in SPACE.values()]
in_the_plane = pytest.mark.parametrize("kind", IN_THE_PLANE, ids=lambda kind: kind.name)


@cache
def position(kind: Any) -> Sketch:
    """Return all that is drawn of the mechanism alone, also what passes."""
    return planned(vad.draw(vad.solve(kind()), panels="position")).sketches["position"]


def marks(sketch: Sketch, role: str) -> Iterator[tuple[Item, Mark]]:
    return ((item, mark) for item in sketch.items for mark in item.marks if mark.role == role)


@pytest.mark.exhaustive
@in_the_plane
def test_the_pin_of_a_block_is_found_on_a_line_that_is_drawn(kind: Any):
    """The ground line of a guide stands half a block away, so an axis shows where the pin moves."""
    sketch = position(kind)
    panel, found = sketch.setting.panel, set[complex]()
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Dot) and stroke.kind == "intersection":
            found.add(stroke.shape.at)
    blocks = [s.shape for s in panel.strokes if isinstance(s.shape, Block) and not s.shape.on]
    for block in (each for each in blocks if each.at in found and on_a_guide(sketch, each)):
        at, index = sketch.scale(block.at), last_of(sketch, block.at)
        axes = [m.shape for i, m in marks(sketch, "axis") if i.since <= sketch.setting.over(index)]
        pieces = [piece for each in axes if isinstance(each, Polyline) for piece in each.pieces]
        assert any(far(at, *piece) < PIXEL for piece in pieces), (kind.name, block)


def on_a_guide(sketch: Sketch, block: Block) -> bool:
    """Tell whether a block slides on a guide of the frame: not in the slot of a yoke."""
    guides = {s.link for s in sketch.setting.panel.strokes if s.kind == "guide"}
    return any(s.shape == block and s.link in guides for s in sketch.setting.panel.strokes)


def last_of(sketch: Sketch, at: complex) -> int:
    dots = enumerate(sketch.setting.panel.strokes)
    return next(i for i, s in dots if isinstance(s.shape, Dot) and s.shape.at == at)


def far(at: complex, start: complex, end: complex) -> float:
    """Return how far a place is from a stretch."""
    along = ((at - start) * (end - start).conjugate()).real / abs(end - start) ** 2
    return abs(at - start - min(max(along, 0.0), 1.0) * (end - start))


@pytest.mark.exhaustive
@in_the_plane
def test_compass_arcs_are_short_and_part_at_their_ends(kind: Any):
    """Two that cross at a small angle could not be told apart if they were long or dashed.

    A lens shows them once more, cut at its rim; those are left out here.
    """
    drawn = marks(position(kind), "compass arc")
    arcs = [mark.shape for item, mark in drawn if item.level != Level.LENS]
    bows = [each for each in arcs if isinstance(each, Bow)]
    assert len(bows) == len(arcs)
    for bow in bows:
        assert 0.5 * PIXEL < bow.radius * math.radians(abs(bow.sweep)) < 75 * PIXEL
    for pair in combinations(bows, 2):
        if abs(middle(pair[0]) - middle(pair[1])) < PIXEL:  # they find the same point
            for one, other in (pair, pair[::-1]):
                spots = list(pairwise(other.line()))
                for at in (one.line()[0], one.line()[-1]):
                    assert min(far(at, *each) for each in spots) > 4 * PIXEL, kind.name


def middle(bow: Bow) -> complex:
    """Return the middle of an arc: the point that it finds."""
    return bow.centre + cmath.rect(bow.radius, math.radians(bow.start + bow.sweep / 2))


@pytest.mark.parametrize("degrees", range(0, 360, 15))
@pytest.mark.parametrize("start", [0.28 + 0.17j, 0.04 + 0.04j, 0.545 + 0.175j, 0.28 + 0.335j])
def test_it_never_leaves_its_panel(start: complex, degrees: int):
    way = cmath.rect(1.0, math.radians(degrees))
    length = 0.0
    while ROOM.inside(0.006).holds(start + (length + 0.007) * way) and length < 0.21:
        length += 0.007
    square = place_square(start, start + length * way, way, [], Obstacles(ROOM))
    if square is None:
        assert length < 0.042
        return
    for share in (0.0, 0.2, 0.5, 0.9, 1.0):
        tip = start + share * length * way
        for mark in square.marks(length):
            shape = mark.at(share).shape
            assert isinstance(shape, Polygon)
            corners = shape.rings[0]
            assert all(ROOM.holds(corner, 1e-9) for corner in corners)
            along = [((corner - tip) * way.conjugate()).real for corner in corners[:2]]
            assert min(along) < 1e-9 < max(along) + 2e-9
            leg = abs(corners[1] - corners[0])
            assert math.isclose(leg, square.size * LONG_LEG)


@pytest.mark.parametrize("name", ["jansen-leg", "sewing-machine"])
def test_a_line_at_an_angle_of_a_link_has_the_arc_of_it_and_its_name_there(name: str):
    """The arc runs from the side of the image to the line; no two are seen at a time."""
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    stage = Stage(sheet, screen((1280, 720)), 0.058)
    sketch, panel = stage.scene(2).sketches["acceleration"], sheet.panel("acceleration")
    spans = [tag.span for tag in sketch.tags if tag.text.startswith("∠")]
    assert not any(together(*pair) for pair in combinations(spans, 2))
    shapes = [stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Arrow)]
    points = {each.head: each.end for each in shapes} | {each.tail: each.start for each in shapes}
    arcs = {
        item.stroke: mark.shape
        for item in sketch.items
        for mark in item.marks
        if mark.role == "right angle" and isinstance(mark.shape, Bow)
    }
    lines = [each for each in panel.strokes if each.label.startswith("∠")]
    assert len(spans) == len(arcs) == len(lines) >= 2
    for stroke in lines:
        arc, side = arcs[panel.full(stroke.name)], f"{stroke.label[2].lower()}′"
        assert arc.centre == pytest.approx(sketch.scale(stroke.shape.through))
        ways = sketch.scale(points[side]) - arc.centre, stroke.shape.direction
        for way, degrees in zip(ways, (arc.start, arc.start + arc.sweep), strict=True):
            turned = way * cmath.rect(1.0, -math.radians(degrees))
            assert cmath.phase(turned) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("name", ["whitworth", "crank-slotted-lever"])
def test_no_leader_of_a_construction_line_runs_through_a_dot(name: str) -> None:
    """That of "∥ lever" ran through qₙ in Whitworth's polygon."""
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name]()))
    stage = Stage(sheet, screen((1280, 720)), 0.058)
    for number in range(stage.count):
        for sketch in stage.scene(number).sketches.values():
            dots = find_vertices(sketch.setting.panel, sketch.scale)
            if sketch.setting.panel.picture != "vectors":
                continue
            for item in sketch.items:
                for mark in item.marks if item.until != FOREVER else ():
                    if mark.role == "leader" and isinstance(mark.shape, Polyline):
                        ((start, end),) = mark.shape.pieces
                        far = [off(dot.at, start, end) for dot in dots]
                        assert min(far, default=1.0) > 6.0 * PIXEL, item.stroke  # a dot's radius


def off(at: complex, start: complex, end: complex) -> float:
    """Return how far a place is from a line between two others."""
    along = (at - start) / (end - start)
    return abs(at - start - min(max(along.real, 0.0), 1.0) * (end - start))


@pytest.mark.parametrize(
    ("name", "size"), [("pin-on-rocker", {"DE": 1e-14}), ("pantograph", {"crank": 1e-15})]
)
def test_what_is_too_small_to_be_seen_is_drawn(name: str, size: dict[str, float]) -> None:
    """An angle that rounds to 0° has no arc, and nothing is divided by it."""
    mechanism = vad.load(example_path(name))(**size)
    plan = planned(vad.draw(vad.solve(mechanism)))
    shapes = [mark.shape for item in plan.items for mark in item.marks]
    assert all(math.isfinite(bow.radius) for bow in shapes if isinstance(bow, Bow))
