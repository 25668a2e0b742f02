"""The page of a lesson in a browser: keys, pointer, address, sizes, print, and who cannot see."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import replace
from html import escape
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect
from pypdf import PdfReader

import vad
from tests.browser import opened, until, violations
from tests.page.lessons import at, lesson_of, page_of, scrub, show
from vad.lecture.lesson import Lesson
from vad.page.document import document
from vad.page.phrases import phrases

WORDS = phrases("en")["player"]
LESSON: Lesson = lesson_of("slider-crank")
STROKES = len(LESSON.steps)
FIRST = [0, 8, 15]


@pytest.fixture(scope="module")
def shared(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    """Return one page for all tests that only play."""
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        show(page, tmp_path_factory.mktemp("page"), page_of("slider-crank"))
        yield page


@pytest.fixture
def lesson(shared: Page) -> Page:
    """Return the page of a lesson at its beginning, with the focus nowhere."""
    shared.evaluate("document.activeElement.blur()")
    shared.keyboard.press("Home")
    return shared


def press(page: Page, *keys: str) -> None:
    for key in keys:
        page.keyboard.press(key)


def panel_of(page: Page, name: str) -> str | None:
    return page.locator(f'.drawing svg[aria-label^="{name}"]').get_attribute("aria-label")


def test_it_opens_empty_and_in_its_own_type(lesson: Page) -> None:
    assert at(lesson) == 0
    expect(lesson.locator(".caption")).to_have_text(WORDS["begin"])
    scrub(lesson, 7)  # a new value is bold
    loaded = """async () => {
      await document.fonts.ready;
      return [...document.fonts].map((face) => `${face.family} ${face.status}`);
    }"""
    assert lesson.evaluate(loaded) == ["vad loaded"] * 3


def test_it_plays_without_a_net(lesson: Page) -> None:
    lesson.context.set_offline(True)
    press(lesson, " ")
    until(lesson, lambda: at(lesson) > 0)
    press(lesson, " ")
    lesson.context.set_offline(False)


def test_every_stroke_by_keyboard_and_back(lesson: Page) -> None:
    captions = [step.stroke.caption for step in LESSON.steps]
    spoken = lesson.evaluate("() => JSON.parse(document.getElementById('data').textContent).spoken")
    for number in range(1, STROKES + 1):
        press(lesson, "Shift+ArrowRight" if number % 2 else "Shift+PageDown")
        assert at(lesson) == number
        text = lesson.locator(".caption p").inner_text().replace("\u00a0", " ")
        plain = captions[number - 1].translate(str.maketrans("₀₁₂₃₄₅ₙ²", "012345n2"))
        assert text == plain
        assert lesson.locator(".scrub").get_attribute("aria-valuetext") == spoken[number - 1]
    press(lesson, "ArrowRight", "PageDown")
    assert at(lesson) == STROKES
    for number in reversed(range(STROKES)):
        press(lesson, "ArrowLeft" if number % 2 else "PageUp")
        assert at(lesson) == number
    press(lesson, "End")
    assert at(lesson) == STROKES
    for digit, first in zip("123", FIRST, strict=True):
        press(lesson, digit)
        assert at(lesson) == first


def test_back_leads_to_the_very_same_page(lesson: Page) -> None:
    """A state is a function of the step, whatever was before."""
    look = "() => document.querySelector('.board').outerHTML"
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
    press(lesson, "s")
    expect(lesson.locator(".steps")).to_be_visible()
    lesson.locator('.steps a[href="#step=velocity:4"]').click()
    assert at(lesson) == FIRST[1] + 4
    expect(lesson.locator(".steps a[aria-current]")).to_have_count(1)
    press(lesson, "s")
    expect(lesson.locator(".steps")).to_be_hidden()


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


def test_what_is_read_out(lesson: Page) -> None:
    """The region speaks of every stroke, but not while the slider has the focus, which does."""
    status = lesson.locator("[role=status]")
    press(lesson, "2", "Shift+ArrowRight", "Shift+ArrowRight")
    expect(status).to_have_text(re.compile(r"^a b equals omega 2 times A B .*perpendicular to A B"))
    assert panel_of(lesson, "Velocity") == "Velocity: 2 of 7 strokes drawn"
    lesson.locator(".scrub").focus()
    press(lesson, "ArrowRight")
    expect(status).to_be_empty()
    expect(lesson.locator(".scrub")).to_have_attribute(
        "aria-valuetext", re.compile("perpendicular")
    )


@pytest.mark.parametrize("theme", ["paper", "chalk"])
def test_axe_finds_nothing(lesson: Page, theme: str) -> None:
    """At the middle with the list open; VAD_FULL=1 looks at more."""
    if theme == "chalk":
        press(lesson, "t")
    expect(lesson.locator(".vad")).to_have_attribute("data-theme", theme)
    press(lesson, "s")
    for x in (0, 11, STROKES) if os.environ.get("VAD_FULL") else (11,):
        scrub(lesson, x)
        assert violations(lesson) == [], x
    press(lesson, "s")
    if theme == "chalk":
        press(lesson, "t")


def test_it_fits_every_window(lesson: Page) -> None:
    over = """() => [document.documentElement.scrollWidth - innerWidth,
      document.documentElement.scrollHeight - innerHeight]"""
    least = """() => Math.min(...[...document.querySelectorAll('.buttons button')]
      .filter((button) => button.offsetParent)
      .flatMap((button) => [button.offsetWidth, button.offsetHeight]))"""
    for width, height in (
        (320, 600),
        (390, 844),
        (768, 1024),
        (1280, 720),
        (1920, 1080),
        (3840, 2160),
    ):
        lesson.set_viewport_size({"width": width, "height": height})
        wide, high = lesson.evaluate(over)
        assert wide <= 0, width
        if width >= 1280:
            assert high <= 0, width
        assert lesson.evaluate(least) >= (40 if width >= 390 else 36)
    lesson.set_viewport_size({"width": 1280, "height": 720})


def test_on_a_phone_the_panel_in_hand_is_in_sight(lesson: Page) -> None:
    lesson.set_viewport_size({"width": 390, "height": 844})
    for digit, panel in zip("321", (2, 1, 0), strict=True):
        press(lesson, digit, "Shift+ArrowRight")
        expect(lesson.locator(".panel h2").nth(panel)).to_be_in_viewport()
    lesson.set_viewport_size({"width": 1280, "height": 720})


def test_play_takes_the_time_of_the_lesson(browser: Browser, tmp_path: Path) -> None:
    with opened(browser) as page:
        page.clock.install(time=0)
        show(page, tmp_path, page_of("slider-crank"))
        page.locator(".speed").select_option("4")
        seconds = sum(step.grow + step.hold for step in LESSON.steps) / LESSON.fps / 4
        button = page.locator("[data-do=play]")
        button.click()
        expect(button).to_have_attribute("aria-label", WORDS["pause"])
        page.clock.run_for(int(1000 * seconds) - 500)
        assert at(page) > STROKES - 1
        expect(button).to_have_attribute("aria-label", WORDS["pause"])
        page.clock.run_for(550)
        expect(button).to_have_attribute("aria-label", WORDS["play"])
        assert at(page) == STROKES


def test_without_scripts_the_sheet_and_every_caption_stand(
    browser: Browser, tmp_path: Path
) -> None:
    with opened(browser, java_script_enabled=False) as page:
        show(page, tmp_path, page_of("slider-crank"))
        expect(page.locator(".control")).to_be_hidden()
        expect(page.locator(".steps li")).to_have_count(STROKES)
        expect(page.locator(".steps li").last).to_be_visible()
        texts = page.locator(".drawing text:visible").all_text_contents()
        assert {"b", "c", "C"} <= {text.strip() for text in texts}
        assert not [text for text in texts if "⟂" in text]


def test_who_wants_no_motion_sees_strokes_at_once(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, reduced_motion="reduce") as page:
        show(page, tmp_path, page_of("slider-crank"))
        scrub(page, 9.3)
        there = page.locator(".board").inner_html()
        scrub(page, 10)
        same = r'value="[^"]*"|style="--share:[^"]*"'
        assert re.sub(same, "", there) == re.sub(same, "", page.locator(".board").inner_html())


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


def test_in_a_sandbox_it_plays_too(browser: Browser, tmp_path: Path) -> None:
    inner = escape(page_of("slider-crank"))
    frame = f'<iframe sandbox="allow-scripts" title="x" srcdoc="{inner}"></iframe>'
    with opened(browser) as page:
        show(page, tmp_path, f"<!doctype html><meta charset=utf-8>{frame}")
        inside = page.frame_locator("iframe")
        inside.locator("[data-do=last]").click()
        expect(inside.locator(".scrub")).to_have_js_property("value", str(STROKES))
        inside.locator("[data-do=first]").click()
        expect(inside.locator(".scrub")).to_have_js_property("value", "0")
        page.wait_for_timeout(300)


def test_it_prints_as_a_handout(browser: Browser, tmp_path: Path) -> None:
    """From any step on chalk: the finished sheet in the colours of paper, then all captions."""
    with opened(browser) as page:
        show(page, tmp_path, page_of("slider-crank"), "#step=3")
        press(page, "t")
        page.pdf(path=tmp_path / "a.pdf", prefer_css_page_size=True)
        assert at(page) == 3
        page.emulate_media(media="print")
        ground = page.locator(".vad").evaluate("e => getComputedStyle(e).backgroundColor")
        assert ground == "rgb(255, 255, 255)"
    first, *others = PdfReader(tmp_path / "a.pdf").pages
    assert first.mediabox.width > first.mediabox.height
    assert re.search("639.5.*1918", first.extract_text())
    text = " ".join(page.extract_text() for page in others)
    assert all(f"{number}." in text for number in range(1, 10)) and "All strokes" in text


def test_forced_colours_leave_keys_and_drawings(browser: Browser, tmp_path: Path) -> None:
    with opened(browser, forced_colors="active") as page:
        show(page, tmp_path, page_of("slider-crank"))
        press(page, "End")
        ink = page.locator(".key path").first.evaluate("e => getComputedStyle(e).stroke")
        assert ink == "rgb(0, 114, 178)"
        expect(page.locator(".scrub")).to_have_css("appearance", "auto")


def test_a_title_and_a_unit_are_text(browser: Browser, tmp_path: Path) -> None:
    evil = "</script><script>alert(1)</script><img src=x onerror=alert(2)>&amp;"
    sheet, unit = LESSON.sheet, "<b>&'\""
    panels = tuple(replace(panel, title=evil, unit=unit) for panel in sheet.panels)
    with opened(browser) as page:
        show(page, tmp_path, document(vad.animate(replace(sheet, title=evil, panels=panels))))
        press(page, "End")
        expect(page.locator("h1")).to_have_text(evil)
        expect(page.locator(".panel h2").first).to_have_text(evil)
        expect(page.locator(".scale").first).to_contain_text(unit)
        assert page.locator("img, .board b:not(button b)").count() == 0
