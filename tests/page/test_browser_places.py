"""The page wherever it is seen: windows, phones, print, a frame, without scripts."""

from __future__ import annotations

import re
from dataclasses import replace
from html import escape
from pathlib import Path

from playwright.sync_api import Browser, Page, expect
from pypdf import PdfReader

import vad
from tests.browser import opened, until
from tests.page.lessons import LESSON, STROKES, at, page_of, press, scrub, show
from vad.page.document import document


def test_it_fits_every_window(lesson: Page) -> None:
    over = """() => [document.documentElement.scrollWidth - innerWidth,
      document.documentElement.scrollHeight - innerHeight]"""
    least = """() => Math.min(...[...document.querySelectorAll('.buttons button')]
      .filter((button) => button.offsetParent)
      .map((button) => button.getBoundingClientRect())
      .flatMap(({ width, height }) => [width, height]))"""
    for width, height in (
        (320, 600),
        (390, 844),
        (768, 1024),
        (568, 320),
        (667, 375),  # a phone held across
        (844, 390),
        (1280, 720),
        (1920, 1080),
        (2560, 1440),
        (3840, 2160),
    ):
        lesson.set_viewport_size({"width": width, "height": height})
        wide, high = lesson.evaluate(over)
        assert wide <= 0, width
        if width >= 1280:
            assert high <= 0, width
        dock = lesson.locator(".control").bounding_box()
        assert dock["y"] + dock["height"] <= height + 0.5  # whatever lies under the fold
        assert dock["height"] <= 0.42 * height
        assert lesson.evaluate(least) >= max(36, 40 * (width >= 390), min(height, 2160) / 26)
    lesson.set_viewport_size({"width": 1280, "height": 720})


def test_remarks_of_two_lines_leave_the_buttons_in_the_window(
    browser: Browser, tmp_path: Path
) -> None:
    """Beneath both polygons of the ball-jointed four-bar, whose lengths take two lines, too."""
    with opened(browser, viewport={"width": 1280, "height": 720}) as page:
        for code in ("en", "de", "fr"):
            show(page, tmp_path, page_of("rssr", code))
            for key in ("End", "h"):
                press(page, key)
                dock = page.locator(".control").bounding_box()
                assert dock["y"] + dock["height"] <= 720.5


def test_the_most_of_words_fit_the_least_of_windows(browser: Browser, tmp_path: Path) -> None:
    """German names of chapters on a phone, and all of the handout on two sheets."""
    cut = """() => [...document.querySelectorAll('.chapters button')]
      .some((button) => button.scrollWidth > button.clientWidth)"""
    html = page_of("crank-slotted-lever", "de", whole=True)
    with opened(browser, viewport={"width": 320, "height": 600}) as page:
        show(page, tmp_path, html)
        assert not page.evaluate(cut)
        page.pdf(path=tmp_path / "a.pdf", prefer_css_page_size=True)
    assert len(PdfReader(tmp_path / "a.pdf").pages) == 2


def test_all_of_the_dock_is_in_it(browser: Browser, tmp_path: Path) -> None:
    """Of the lesson and of the hand: between a phone and a page with three panels, too."""
    past = """() => Math.max(
      ...[...document.querySelectorAll('.buttons > *, .said > *, .caption > *')]
        .map((each) => each.getBoundingClientRect().right)
      ) - document.querySelector('.control').getBoundingClientRect().right"""
    for code in ("en", "de", "fr"):
        with opened(browser, reduced_motion="reduce") as page:
            show(page, tmp_path, page_of("four-bar", code), "#step=14")
            for mode in ("lesson", "hand"):
                for width in (320, 390, 480, 540, 620, 640, 768, 1024):
                    page.set_viewport_size({"width": width, "height": 700})
                    assert page.evaluate(past) <= 0, (code, mode, width)
                press(page, "h")


def test_on_a_phone_the_panel_in_hand_is_in_sight(lesson: Page) -> None:
    lesson.set_viewport_size({"width": 390, "height": 844})
    for digit, panel in zip("321", (2, 1, 0), strict=True):
        press(lesson, digit, "Shift+ArrowRight")
        expect(lesson.locator(".panel h2").nth(panel)).to_be_in_viewport()
    lesson.set_viewport_size({"width": 1280, "height": 720})


def test_magnified_four_times_only_the_buttons_stay_in_the_window(
    browser: Browser, tmp_path: Path
) -> None:
    """1280 by 720 pixels at 400 %: all else is in the page, which scrolls one way alone."""
    with opened(browser, viewport={"width": 320, "height": 180}) as page:
        show(page, tmp_path, page_of("crank-slotted-lever", "de"))
        press(page, "End", "h")
        assert page.evaluate("document.documentElement.scrollWidth") <= 320
        staying = page.locator(".buttons").bounding_box()
        assert staying["height"] < 0.3 * 180 and staying["y"] + staying["height"] <= 180.5
        for what in ("[data-vad-grip]", ".turner", ".place input", ".results tbody tr >> nth=-1"):
            page.locator(what).scroll_into_view_if_needed()
            place = page.locator(what).bounding_box()
            assert place["x"] >= 0 and place["x"] + place["width"] <= 320
            assert 0 <= place["y"] < staying["y"], what


def test_on_a_phone_fingers_have_room_and_the_line_of_the_hand_fits(
    browser: Browser, tmp_path: Path
) -> None:
    edges = """() => [...document.querySelectorAll('.control > *, .said > *')]
      .filter((each) => each.offsetParent && each.localName !== 'dialog')
      .map((each) => each.getBoundingClientRect())
      .map(({ left, right, top, height }) => [left, right, top, height])"""
    with opened(browser, viewport={"width": 390, "height": 844}, has_touch=True) as page:
        show(page, tmp_path, page_of("crank-slotted-lever", "de"))
        for chapter in page.locator(".chapters button:not([title])").all():
            assert chapter.bounding_box()["height"] >= 44
        assert page.locator(".chapters button:visible").count() == 3
        dock = page.locator(".control").bounding_box()
        press(page, "End", "Home", "ArrowRight", "h")
        assert page.locator(".control").bounding_box() == dock
        for left, right, top, _ in page.evaluate(edges):
            assert left >= 0 and right <= 390 and top >= dock["y"]


def test_a_chosen_chapter_is_the_current_one_and_its_panel_is_seen(lesson: Page) -> None:
    lesson.set_viewport_size({"width": 390, "height": 844})
    chapters = lesson.locator(".chapters button")
    for number in (2, 1):
        chapters.nth(number).click()
        expect(chapters.nth(number)).to_have_attribute("aria-current", "true")
        expect(lesson.locator(".chapters [aria-current=true]")).to_have_count(1)
        expect(lesson.locator(".panel").nth(number)).to_be_visible()
        assert lesson.locator(".count").text_content().startswith("0 / ")
        press(lesson, "ArrowRight", "ArrowRight")
        assert lesson.locator(".count").text_content().startswith("1 / ")
    lesson.set_viewport_size({"width": 1280, "height": 720})


def test_the_list_is_in_reach_on_a_full_screen(lesson: Page) -> None:
    press(lesson, "f")
    until(lesson, lambda: lesson.evaluate("() => !!document.fullscreenElement"))
    lesson.locator(".rail").hover()
    lesson.mouse.wheel(0, 9999)
    expect(lesson.locator(".steps li").last).to_be_in_viewport()
    press(lesson, "f")
    until(lesson, lambda: lesson.evaluate("() => !document.fullscreenElement"))


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


def test_in_a_sandbox_it_plays_too(browser: Browser, tmp_path: Path) -> None:
    inner = escape(page_of("slider-crank"))
    frame = f'<iframe sandbox="allow-scripts" width="640" height="500" srcdoc="{inner}"></iframe>'
    with opened(browser) as page:
        show(page, tmp_path, f"<!doctype html><meta charset=utf-8>{frame}")
        inside = page.frame_locator("iframe")
        inside.locator("[data-do=last]").click()
        expect(inside.locator(".scrub")).to_have_js_property("value", str(STROKES))
        inside.locator("[data-do=first]").click()
        expect(inside.locator(".scrub")).to_have_js_property("value", "0")
        page.wait_for_timeout(300)


def test_it_prints_as_a_handout(lesson: Page, tmp_path: Path) -> None:
    """From any step on chalk: the finished sheet in the colours of paper, then all captions."""
    scrub(lesson, 3)
    press(lesson, "t")
    lesson.pdf(path=tmp_path / "a.pdf", prefer_css_page_size=True)
    assert at(lesson) == 3
    lesson.emulate_media(media="print")
    expect(lesson.locator(".vad")).to_have_css("background-color", "rgb(255, 255, 255)")
    lesson.emulate_media(media="null")
    press(lesson, "t")
    first, *_ = pages = PdfReader(tmp_path / "a.pdf").pages
    assert first.mediabox.width > first.mediabox.height
    assert re.search("639.5.*1918", first.extract_text())
    text = " ".join(page.extract_text() for page in pages)
    assert all(f"{number}." in text for number in range(1, 10)) and "All strokes" in text


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
