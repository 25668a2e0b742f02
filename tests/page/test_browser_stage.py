"""The stage of a page: the panel in work is large, and a change of panels is a move."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

import vad
from tests.browser import opened, painted, until
from tests.page.lessons import FIRST, STROKES, bundle_of, page_of, press, scrub, show, written

#: Where the drawings are, the panels and the table, when all have come to rest.
_PLACES = """() => {
  document.getAnimations().forEach((each) => each.finish());
  const box = ({ left, top, right, bottom }) => [left, top, right, bottom];
  const all = (names) =>
    [...document.querySelectorAll(names)].map((each) => box(each.getBoundingClientRect()));
  return { drawings: all(".drawing > svg"), ghosts: all(".ghost svg"), panels: all(".panel"),
    table: all(".results table")[0],
    board: all(".board")[0], texts: all(".small text"), scale: all(".panel:not(.small) .bar")[0] };
}"""

#: Stops all moves of drawings in their middle, and tells how long they last.
_HALFWAY = """() => {
  const moves = document.getAnimations().filter(({ effect: { target } }) =>
    target.closest(".drawing"));
  const lasts = moves.map((each) => each.effect.getTiming().duration);
  moves.forEach((each, i) => { each.pause(); each.currentTime = lasts[i] / 2; });
  return lasts;
}"""
#: Where two places of each panel on the sheet are seen, as it may be drawn anew for a large room.
_SEEN = """(large) => [...document.querySelectorAll(".drawing > svg")].flatMap((svg, i) => {
  const [, factor, x, y] = svg.closest(".grand") ? large[i] : [0, 1, 0, 0];
  const matrix = svg.getScreenCTM();
  return [[600, 300], [700, 200]].map(([u, v]) =>
    new DOMPoint(factor * u + x, factor * v + y).matrixTransform(matrix)).map(({ x, y }) => [x, y]);
})"""


@pytest.fixture(scope="module")
def large() -> list[Any]:
    """Return how large the page draws each panel, and where."""
    found: list[Any] = bundle_of(page_of("slider-crank"))[1]["large"]
    return found


def places(page: Page, x: float) -> dict[str, Any]:
    """Return where all is after so many strokes."""
    scrub(page, x)
    found: dict[str, Any] = page.evaluate(_PLACES)
    return found


def wide(box: list[float]) -> float:
    return box[2] - box[0]


def high(box: list[float]) -> float:
    return box[3] - box[1]


def apart(one: list[float], other: list[float]) -> bool:
    sides = [one[0] - other[2], other[0] - one[2], one[1] - other[3], other[1] - one[3]]
    return max(sides) > 0.0


def test_the_panel_in_work_is_large_and_at_the_end_the_sheet_stands_there(lesson: Page) -> None:
    sheet = places(lesson, STROKES)
    assert max(map(wide, sheet["panels"])) < 1.01 * min(map(wide, sheet["panels"]))
    for number, first in enumerate(FIRST):
        found = places(lesson, first + 1)
        large = found["drawings"].pop(number)
        panel = found["panels"].pop(number)
        room = found["board"]
        assert 0.55 < wide(panel) / (wide(room) - 55) < 0.65
        assert high(large) > 0.55 * 720
        assert wide(large) > 1.9 * wide(sheet["drawings"][number])
        for small in found["drawings"]:
            assert 0.4 < wide(small) / wide(sheet["drawings"][number]) < 1.0
        others = [*found["panels"], found["table"]]
        boxes = [panel, *(each for each in others if high(each))]
        for place, one in enumerate(boxes):
            assert all(apart(one, other) for other in boxes[:place])
        assert high(room) == pytest.approx(high(sheet["board"]), abs=1.0)
        assert found["table"][3] <= panel[3] + 1.0
        assert all(high(each) > 9.0 for each in found["texts"] if high(each))
        ratio = wide(found["scale"]) / wide(large)
        lesson.set_viewport_size({"width": 640, "height": 600})
        narrow = lesson.evaluate(_PLACES)
        shown = [each for each in narrow["panels"] if high(each)]
        assert len(shown) == 2 and wide(shown[0]) == pytest.approx(wide(shown[1]), abs=1.0)
        lesson.set_viewport_size({"width": 1280, "height": 720})
        assert 0.05 < ratio < 0.9


#: How much of its cell each thumbnail fills, across and upright, and how large its letters are.
_FILLED = """() => [...document.querySelectorAll(".small .drawing")].map((cell) => {
  const room = cell.getBoundingClientRect();
  const boxes = [...cell.querySelectorAll("svg > [data-s].on")]
    .map((each) => each.getBoundingClientRect()).filter(({ width, height }) => width + height);
  const reach = (low, high) =>
    Math.max(...boxes.map((each) => each[high])) - Math.min(...boxes.map((each) => each[low]));
  return [reach("left", "right") / room.width, reach("top", "bottom") / room.height];
})"""


def test_thumbnails_show_what_is_drawn_and_all_of_it_when_a_hand_moves_it(
    lesson: Page, large: list[Any]
) -> None:
    places(lesson, FIRST[2] + 3)
    for filled in lesson.evaluate(_FILLED):
        assert 0.7 < max(filled) < 1.05
    # As wide as the view of the sheet in the hand, and in the lesson as what is drawn on it.
    [view, *_] = re.findall(r'<svg[^>]* viewBox="([^"]*)"', page_of("slider-crank"))
    sheet, drawn = (float(each.split()[2]) for each in (view, large[0][5]))
    assert sheet > drawn
    mechanism = lesson.locator(".small .drawing > svg").first
    width = "(each) => each.viewBox.baseVal.width"
    press(lesson, "h")
    assert mechanism.evaluate(width) == pytest.approx(sheet, abs=0.01)
    press(lesson, "Escape")
    until(lesson, lambda: lesson.locator(".turned").count() == 0)
    assert mechanism.evaluate(width) == pytest.approx(drawn, abs=0.01)


def test_a_change_of_panel_is_a_move_of_a_second(lesson: Page, large: list[Any]) -> None:
    """All that is drawn moves straight, though it is another picture when it is large."""
    places(lesson, FIRST[1])
    before = lesson.evaluate(_SEEN, large)
    press(lesson, "Shift+ArrowRight")
    lasts = lesson.evaluate(_HALFWAY)
    half = lesson.evaluate(_SEEN, large)
    lesson.evaluate(_PLACES)
    after = lesson.evaluate(_SEEN, large)
    assert lasts == [1000] * 3
    for one, middle, other in zip(before, half, after, strict=True):
        assert middle == pytest.approx(
            [(a + b) / 2 for a, b in zip(one, other, strict=True)], abs=1
        )
    sizes = [math.dist(*seen[2:4]) for seen in (before, after)]
    assert sizes[1] > 2.0 * sizes[0]


def test_the_hand_keeps_the_arrangement_of_the_moment(lesson: Page) -> None:
    before = places(lesson, FIRST[1] + 3)
    press(lesson, "h")
    held = lesson.evaluate(_PLACES)
    assert held["drawings"] == before["drawings"] and held["table"][:2] == before["table"][:2]
    lesson.locator("[data-do=all]").click()
    assert lesson.evaluate(_PLACES)["drawings"] == places(lesson, STROKES)["drawings"]
    press(lesson, "Escape")


#: Where the first drawing and its letters are: their left ends and their widths.
_LAYERS = """() => [...document.querySelector(".drawing").querySelectorAll("svg")].map((svg) => {
  const { a, e } = svg.getScreenCTM();
  return [a, e];
})"""


def test_what_was_let_go_of_glides_to_its_place(lesson: Page) -> None:
    """A thumbnail shows all the room that its mechanism needs, but not while it is held."""
    places(lesson, FIRST[1] + 3)
    ring = lesson.locator("[data-vad-grip]").bounding_box()
    x, y = ring["x"] + ring["width"] / 2, ring["y"] + ring["height"] / 2
    lesson.mouse.move(x, y)
    lesson.mouse.down()
    lesson.mouse.move(x - 5, y, steps=3)
    (held, _) = lesson.evaluate(_LAYERS)
    # In the frame in which it is let go of nothing has moved; later it has, with its letters.
    lesson.evaluate(
        """() => addEventListener("pointerup", () => requestAnimationFrame(() => {
          for (const each of document.getAnimations()) { each.pause(); each.currentTime = 0; }
        }), { once: true })"""
    )
    lesson.mouse.up()
    painted(lesson)
    own, above = lesson.evaluate(_LAYERS)
    assert own == pytest.approx(held, rel=1e-4) and above == pytest.approx(own, rel=1e-6)
    lesson.evaluate("() => document.getAnimations().forEach((each) => each.finish())")
    own, above = lesson.evaluate(_LAYERS)
    assert own[0] < 0.95 * held[0] and above == own
    press(lesson, "Escape")
    until(lesson, lambda: not lesson.locator(".turned").count())


def test_letters_glide_with_their_drawing_when_all_is_asked_for(lesson: Page) -> None:
    places(lesson, FIRST[1] + 3)
    press(lesson, "h")
    lesson.locator("[data-do=all]").click()
    lesson.evaluate(
        """() => document.getAnimations().forEach((each) => {
          each.pause();
          each.currentTime = 400;
        })"""
    )
    own, above = lesson.evaluate(_LAYERS)
    assert above == pytest.approx(own, rel=1e-6)
    lesson.evaluate("() => document.getAnimations().forEach((each) => each.finish())")
    assert lesson.evaluate(_LAYERS)[0][0] != pytest.approx(own[0], rel=0.05)
    press(lesson, "Escape")
    until(lesson, lambda: not lesson.locator(".turned").count())


def test_letters_under_the_hand_lie_over_their_lines(lesson: Page) -> None:
    """They are in a layer above the drawing, which is seen through the same view."""
    for x, width in ((12, 1280), (STROKES, 1280), (12, 700)):
        lesson.set_viewport_size({"width": width, "height": 800})
        scrub(lesson, x)
        lesson.evaluate(_PLACES)
        press(lesson, "h")
        found = lesson.evaluate(
            """() => [...document.querySelectorAll(".drawing")].map((each) =>
              [...each.querySelectorAll("svg")].map((svg) => {
                const { a, e, f } = svg.getScreenCTM(), labels = svg.querySelectorAll(".label");
                return [a, e, f, svg.getAttribute("viewBox"), labels.length];
              }))"""
        )
        assert len(found) == len(FIRST)
        for (*own, none), (*above, some) in found:
            assert own == above and none == 0 < some
        press(lesson, "Escape")
        until(lesson, lambda: not lesson.locator(".turned").count())


def test_who_wants_no_motion_sees_one_picture_fade_into_another(
    browser: Browser, tmp_path: Path
) -> None:
    with opened(browser, reduced_motion="reduce", viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path, page_of("slider-crank"), f"#step={FIRST[1]}")
        before = page.evaluate(_PLACES)["drawings"]
        press(page, "Shift+ArrowRight")
        found = page.evaluate(
            "() => document.getAnimations().map((each) => (each.pause(), each.effect)).map("
            "(effect) => [effect.getTiming().duration, effect.getKeyframes().some((each) =>"
            " 'transform' in each), effect.getKeyframes().at(-1).opacity === '0'])"
        )
        assert found and all(each[:2] == [200, False] for each in found)
        assert sum(each[2] for each in found) == 1  # what was there fades
        fading = page.evaluate(_PLACES.replace("document.getAnimations()", "[]"))
        assert fading["ghosts"] == [each for each in before if high(each)]
        assert len(fading["drawings"]) == len(before)  # for scripts there are no others
        page.evaluate(_PLACES)
        until(page, lambda: page.locator(".ghost").count() == 0)


def test_the_scale_in_the_head_of_two_polygons_stands_above_the_first(
    browser: Browser, tmp_path: Path
) -> None:
    with opened(browser, viewport={"width": 1280, "height": 800}) as page:
        show(page, tmp_path, written(vad.SpatialFourBar()))
        panel = page.locator(".panel").nth(1)

        def beyond_the_middle() -> float:
            page.evaluate(_PLACES)
            room, bar = panel.bounding_box(), panel.locator(".scale:not(.hand) .bar").bounding_box()
            assert room and bar
            return bar["x"] + bar["width"] - room["x"] - room["width"] / 2

        scrub(page, 44.0)
        assert beyond_the_middle() < 0.0
        scrub(page, float(page.evaluate("document.querySelector('.scrub').max")))
        assert beyond_the_middle() > 0.0  # at the end one is below the other


def test_the_lower_scale_keeps_its_number_where_a_hand_turns_a_large_panel(
    browser: Browser, tmp_path: Path
) -> None:
    with opened(browser, viewport={"width": 1280, "height": 800}) as page:
        show(page, tmp_path, written(vad.SpatialFourBar()))
        found = []
        for stroke in (44.0, float(page.evaluate("document.querySelector('.scrub').max"))):
            scrub(page, stroke)
            press(page, "h")
            page.wait_for_timeout(900)  # the picture glides to its scale
            text, line = page.locator(".panel:nth-child(2) .hand [data-bar]").evaluate(
                """(bar) => ["text", "path"].map((each) =>
                  bar.querySelector(each).getBoundingClientRect().toJSON())"""
            )
            middle = (text["top"] + text["bottom"] - line["top"] - line["bottom"]) / 2
            assert abs(middle) < 0.3 * text["height"]
            assert 0 < text["left"] - line["right"] < text["height"]
            found.append(line["top"])
            press(page, "h")
            until(page, lambda: page.locator(".turned").count() == 0)
        assert abs(found[0] - found[1]) > 20  # the large panel is another
