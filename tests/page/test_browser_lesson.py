"""The page of a lesson in a browser: played by keys, pointer and address."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser import opened, painted, until, violations
from tests.page.lessons import (
    FIRST,
    LESSON,
    STROKES,
    WORDS,
    at,
    bundle_of,
    page_of,
    press,
    scrub,
    show,
)

#: How many groups of strokes are seen in each panel.
_SEEN = """() => [...document.querySelectorAll(".drawing > svg")].map((svg) =>
  [...(svg.closest(".grand") ? svg.querySelector(".scene") : svg).children]
    .filter((each) => !each.matches(".hand"))
    .filter((each) => getComputedStyle(each).display !== "none").length)"""

#: What the browser says of each object that it has to lay out anew, and why.
_INVALID = ["devtools.timeline", "disabled-by-default-devtools.timeline.invalidationTracking"]
_LAID = "LayoutInvalidationTracking"


def test_it_opens_with_the_mechanism_and_in_its_own_type(lesson: Page) -> None:
    assert at(lesson) == 0
    opened = lesson.evaluate(_SEEN)
    assert opened[0] > 5 and opened[1:] == [0, 0]
    scrub(lesson, FIRST[1])
    assert lesson.evaluate(_SEEN) == opened
    scrub(lesson, 0.5)
    assert lesson.evaluate(_SEEN)[0] < opened[0]
    press(lesson, "Home")
    expect(lesson.locator(".caption")).to_have_text(WORDS["begin"])
    scrub(lesson, 7)  # a new value is bold
    loaded = """async () => {
      await document.fonts.ready;
      return [...document.fonts].map((face) => `${face.family} ${face.status}`);
    }"""
    assert lesson.evaluate(loaded) == ["vad loaded"] * 3


def test_a_stroke_that_grows_leaves_the_pictures_where_they_are(lesson: Page) -> None:
    """A view that is set anew, even to what it was, has the browser lay out all of the picture."""
    scrub(lesson, 7.2)
    lesson.evaluate(
        """() => {
          window.set_ = [];
          const names = (all) => all.map((each) => each.attributeName);
          const seen = new MutationObserver((all) => set_.push(...names(all)));
          for (const picture of document.querySelectorAll(".drawing > svg"))
            seen.observe(picture, { attributes: true, subtree: true });
        }"""
    )
    for part in (7.3, 7.5, 7.7):
        scrub(lesson, part)
    found = lesson.evaluate("set_")
    assert found and "viewBox" not in found


def test_a_stroke_that_grows_leaves_the_pictures_their_sizes(lesson: Page) -> None:
    """A picture that is measured in between with another size is laid out as a whole, twice."""
    scrub(lesson, 12.2)

    def grown() -> None:
        for part in (12.3, 12.5, 12.7):
            scrub(lesson, part)

    def sized(what: Callable[[], object]) -> bool:
        lesson.context.browser.start_tracing(page=lesson, categories=_INVALID)
        what()
        painted(lesson)
        events = json.loads(lesson.context.browser.stop_tracing())["traceEvents"]
        found = [each["args"]["data"] for each in events if each["name"] == _LAID]
        assert found
        return any(each["reason"] == "Size changed" for each in found)

    assert not sized(grown)
    assert sized(lambda: lesson.set_viewport_size({"width": 1100, "height": 800}))


def test_it_plays_without_a_net(lesson: Page) -> None:
    lesson.context.set_offline(True)
    press(lesson, " ")
    until(lesson, lambda: at(lesson) > 0)
    press(lesson, " ")
    lesson.context.set_offline(False)


def test_every_stroke_by_keyboard_and_back(lesson: Page) -> None:
    captions = [step.stroke.caption for step in LESSON.steps]
    spoken = bundle_of(page_of("slider-crank"))[1]["spoken"]
    for number in range(1, STROKES + 1):
        press(lesson, "Shift+ArrowRight" if number % 2 else "Shift+PageDown")
        assert at(lesson) == number
        text = lesson.locator(".caption p").inner_text().replace("\u00a0", " ")
        plain = captions[number - 1].translate(str.maketrans("₀₁₂₃₄₅ₙ²", "012345n2"))
        assert text == plain
        words = next(each for each in reversed(spoken[:number]) if each)
        assert lesson.locator(".scrub").get_attribute("aria-valuetext") == words
    press(lesson, "ArrowRight", "PageDown")
    assert at(lesson) == STROKES
    expect(lesson.locator(".steps a[aria-current]")).to_be_in_viewport(ratio=1)
    for number in reversed(range(STROKES)):
        press(lesson, "ArrowLeft" if number % 2 else "PageUp")
        assert at(lesson) == number
    press(lesson, "End")
    assert at(lesson) == STROKES
    for digit, first in zip("123", FIRST, strict=True):
        press(lesson, digit)
        assert at(lesson) == first


def test_back_leads_to_the_very_same_page(lesson: Page) -> None:
    """A state is a function of the step, whatever was before; the order of classes is none."""
    look = """() => {
      const copy = document.querySelector(".board").cloneNode(true);
      for (const each of copy.querySelectorAll("[class]")) {
        const names = [...each.classList].sort().join(" ");
        if (names) each.setAttribute("class", names);
        else each.removeAttribute("class");
      }
      return copy.outerHTML;
    }"""
    states = []
    for _ in range(STROKES):
        press(lesson, "Shift+ArrowRight")
        states.append(lesson.evaluate(look))
    for number in reversed(range(STROKES - 1)):
        scrub(lesson, number + 0.5)
        scrub(lesson, number + 1)
        assert lesson.evaluate(look) == states[number]


def test_forward_draws_and_stops_and_again_finishes(lesson: Page) -> None:
    press(lesson, "ArrowRight")
    until(lesson, lambda: 0 < at(lesson) < 1)
    press(lesson, "ArrowRight")
    assert at(lesson) == 1
    lesson.locator(".drawing").first.click()
    until(lesson, lambda: at(lesson) == 2, 5)
    lesson.wait_for_timeout(150)
    assert at(lesson) == 2


def test_back_in_the_middle_of_a_stroke_takes_that_stroke_away(lesson: Page) -> None:
    for start, after in ((3.5, 3), (3, 2), (0.2, 0)):
        scrub(lesson, start)
        press(lesson, "ArrowLeft")
        assert at(lesson) == after


def test_letters_can_be_switched_off(lesson: Page) -> None:
    press(lesson, "?")
    box = lesson.locator("dialog .letters")
    assert violations(lesson) == []
    box.uncheck()
    press(lesson, "Escape")
    expect(lesson.locator("dialog")).to_be_hidden()
    press(lesson, "2", "t", "s")
    assert at(lesson) == 0
    assert lesson.locator(".vad").get_attribute("data-theme") == "paper"
    press(lesson, "End")
    assert at(lesson) == STROKES
    lesson.locator("[data-do=keys]").click()
    box.check()
    lesson.locator("[data-do=close]").click()
    press(lesson, "2")
    assert at(lesson) == FIRST[1]


def test_buttons_keep_their_own_keys_and_fields_all(lesson: Page) -> None:
    lesson.locator("[data-do=last]").focus()
    press(lesson, "Enter")
    assert at(lesson) == STROKES
    lesson.locator("[data-do=first]").focus()
    press(lesson, " ")
    assert at(lesson) == 0
    lesson.locator(".speed").focus()
    press(lesson, "ArrowRight", "2")
    assert at(lesson) == 0
    lesson.locator(".speed").select_option("1")


def test_speed_and_theme_and_list(lesson: Page) -> None:
    press(lesson, "+", "+")
    expect(lesson.locator(".speed")).to_have_value("2")
    press(lesson, "-", "-")
    expect(lesson.locator(".speed")).to_have_value("1")
    expect(lesson.locator(".steps")).to_be_visible()
    lesson.locator('.steps a[href="#step=velocity:4"]').click()
    assert at(lesson) == FIRST[1] + 4
    expect(lesson.locator(".panel h2").nth(1)).to_be_in_viewport()
    expect(lesson.locator(".steps a[aria-current]")).to_have_count(1)
    press(lesson, "s")
    expect(lesson.locator(".steps")).to_be_hidden()
    press(lesson, "s")
    expect(lesson.locator(".steps")).to_be_visible()


def test_scrubbing_is_continuous_and_lets_go_at_a_stroke(lesson: Page) -> None:
    box = lesson.locator(".scrub").bounding_box()
    y = box["y"] + box["height"] / 2
    lesson.mouse.move(box["x"] + box["width"] * 0.42, y)
    lesson.mouse.down()
    lesson.mouse.move(box["x"] + box["width"] * 0.53, y, steps=4)
    held = at(lesson)
    assert held == pytest.approx(0.53 * STROKES, abs=0.3) and held != int(held)
    lesson.mouse.up()
    assert at(lesson) == round(held)
    press(lesson, "ArrowLeft", "ArrowLeft", "ArrowRight")
    assert at(lesson) == round(held) - 1


def test_play_takes_the_time_of_the_lesson(browser: Browser, tmp_path: Path) -> None:
    with opened(browser) as page:
        page.clock.install(time=0)
        show(page, tmp_path, page_of("slider-crank"))
        page.locator(".speed").select_option("4")
        seconds = sum(step.frames for step in LESSON.steps) / LESSON.fps / 4
        button = page.locator("[data-do=play]")
        page.clock.pause_at(60)  # from here on its time runs by the test alone
        button.click()
        expect(button).to_have_attribute("aria-label", WORDS["pause"])
        page.clock.run_for(int(1000 * seconds) - 500)
        assert at(page) > STROKES - 1
        expect(button).to_have_attribute("aria-label", WORDS["pause"])
        page.clock.run_for(550)
        expect(button).to_have_attribute("aria-label", WORDS["play"])
        assert at(page) == STROKES


def test_the_address(browser: Browser, tmp_path: Path) -> None:
    with opened(browser) as page:
        show(page, tmp_path, page_of("slider-crank"), "#step=velocity:4")
        assert at(page) == 12
        press(page, "ArrowLeft")
        until(page, lambda: page.url.endswith("#step=11"))
        for hash_, x in (
            ("#step=7", 7),
            ("#step=99", 7),
            ("#step=velocity:8", 7),
            ("#step=velocity:0", 7),
            ("#step=flight:1", 7),
            ("#step=%3Cb%3E", 7),
            ("#step=-1", 7),
            ("#step=acceleration:9", 24),
            ("#step=0", 0),
        ):
            page.evaluate("hash => { location.hash = hash; }", hash_)
            until(page, lambda x=x: at(page) == x, 3)
