"""The opening shot: one panel, large, between title and caption, on its way into its place."""

from __future__ import annotations

from functools import cache

import pytest

import vad
from tests.plan.snapshots import SCENES, lesson
from tests.plan.test_marks import points
from vad.files.examples import example_path
from vad.lecture.moment import Moment, done, drawing
from vad.painting.posed import board_of
from vad.plan.board import LARGEST, USUAL, Plan, seen
from vad.plan.board import reach as reach_of
from vad.plan.items import OPENING, Item
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Lettering, Mark

pytestmark = pytest.mark.exhaustive

EVERY = pytest.mark.parametrize("scene", SCENES)
SHARES = [k / 5 for k in range(6)]
NEAR = 1e-9


@cache
def board(scene: str, size: tuple[int, int] = (1280, 720)) -> Plan:
    return board_of(vad.animate(lesson(scene).sheet, size=size))


def own(shown: Plan) -> list[Item]:
    return [item for item in shown.items if item.region == shown.sheet.panels[0].name]


@pytest.mark.parametrize(
    ("scene", "size"),
    [
        *((scene, (1280, 720)) for scene in SCENES),
        ("shaper", (1024, 768)),
        ("four-bar", (900, 900)),
    ],
)
def test_the_mechanism_stands_large_between_title_and_caption(scene: str, size: tuple[int, int]):
    shown = board(scene, size)
    area = shown.regions[OPENING]
    assert area.top <= shown.regions["title"].bottom + NEAR
    assert area.bottom >= shown.regions["caption"].top - NEAR
    assert shown.opening.factor > 1.3
    grown = reach_of(shown.opening.large.values())
    if shown.opening.factor > LARGEST:
        assert grown.width < USUAL.real + NEAR
        assert grown.height < USUAL.imag + NEAR
    for item in own(shown):
        for mark in shown.opening.large[item].marks:
            for share in SHARES:
                grown = mark.at(share)
                assert grown is None or all(area.holds(z) for z in reach(grown)), item.stroke


def test_a_mechanism_in_a_small_panel_grows_to_the_usual_size():
    mechanism = vad.load(example_path("jansen-leg"))()
    shot = board_of(vad.animate(vad.draw(vad.solve(mechanism)))).opening
    assert shot.factor > 1.2 * LARGEST
    assert reach_of(shot.large.values()).height == pytest.approx(USUAL.imag)


def reach(mark: Mark) -> list[complex]:
    if isinstance(mark.shape, Lettering):
        ink = typeset(mark.shape.runs)
        corners = (complex(ink.left, ink.bottom), complex(ink.right, ink.top))
        return [mark.shape.at + mark.shape.size * z for z in corners]
    return points(mark)


@EVERY
def test_what_is_large_comes_about_as_what_is_small(scene: str):
    shown = board(scene)
    factor, shift = shown.opening.factor, shown.opening.shift
    for item in own(shown):
        large = shown.opening.large[item]
        assert (large.stroke, large.since, large.until) == (item.stroke, item.since, item.until)
        for small, mark in zip(item.marks, large.marks, strict=True):
            assert mark.width == pytest.approx(factor * small.width)
            for share in SHARES:
                here, there = small.at(share), mark.at(share)
                assert (here is None) == (there is None)
                if here and there:
                    assert there.alpha == here.alpha
                    for z, image in zip(points(here), points(there), strict=True):
                        size = isinstance(here.shape, Lettering) and z == points(here)[1]
                        assert size or abs(image - (factor * z + shift)) < NEAR


@EVERY
def test_it_glides_straight_into_its_panel_and_the_page_comes_with_it(scene: str):
    shown = board(scene)
    beat = done(len(shown.sheet.panels[0].strokes))
    regions = {item.region for item in seen(shown, Moment(beat, near=0.4))}
    assert regions == {OPENING, "title", "caption"}
    assert list(seen(shown, Moment(beat))) == shown.shown(beat)
    places = [
        [
            z
            for item in seen(shown, Moment(beat, near=near))
            if item.region == OPENING
            for mark in item.marks
            for z in points(mark)
        ]
        for near in (1.0, 0.5, 1e-12)
    ]
    still = [
        z for item in own(shown) if item in shown.shown(beat) for m in item.marks for z in points(m)
    ]
    for large, middle, small, z in zip(*places, still, strict=True):
        assert abs(middle - (large + small) / 2) < NEAR
        assert abs(small - z) < NEAR


def test_marks_are_large_from_the_first_frame_on():
    shown = board("slider-crank")
    (item,) = [i for i in seen(shown, Moment(drawing(0), near=1.0)) if i.region == OPENING]
    assert item.stroke == "position:A.fixed"
