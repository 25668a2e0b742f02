"""The page for who hears it, or sees it otherwise: what is read out, axe, motion, colours."""

from __future__ import annotations

import io
import os
import re
from itertools import pairwise

import pytest
from PIL import Image
from playwright.sync_api import Page, expect

from tests.browser import violations
from tests.page.lessons import STROKES, press, scrub
from vad.style import load_style


def rgb(colour: str) -> str:
    """Return a colour as a browser tells it."""
    return "rgb({}, {}, {})".format(*bytes.fromhex(colour[1:]))


def test_what_is_read_out(lesson: Page) -> None:
    """The region speaks of every stroke, but not while the slider has the focus, which does."""
    status = lesson.locator("[role=status]")
    press(lesson, "2", "Shift+ArrowRight", "Shift+ArrowRight")
    expect(status).to_have_text(re.compile(r"^a b equals omega 2 times A B .*perpendicular to A B"))
    assert lesson.get_by_label("Velocity: 2 of 7 strokes drawn").is_visible()
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
    expect(lesson.locator(".vad")).to_have_css(  # which takes a moment to get there
        "background-color", rgb(load_style(theme).background)
    )
    for x in (0, 11, STROKES) if os.environ.get("VAD_FULL") else (11,):
        scrub(lesson, x)
        assert violations(lesson) == [], x
    if theme == "chalk":
        press(lesson, "t")


def test_who_wants_no_motion_sees_strokes_at_once(lesson: Page) -> None:
    lesson.emulate_media(reduced_motion="reduce")
    scrub(lesson, 9.3)
    there = lesson.locator(".board").inner_html()
    scrub(lesson, 10)
    same = r'value="[^"]*"|style="--share:[^"]*"'
    assert re.sub(same, "", there) == re.sub(same, "", lesson.locator(".board").inner_html())
    lesson.emulate_media(reduced_motion="null")


def test_forced_colours_leave_keys_and_drawings(lesson: Page) -> None:
    """On dark ones axe reads a fill that was forced away: there, the pixels are looked at."""
    lesson.emulate_media(forced_colors="active")
    press(lesson, "End")
    key = lesson.locator(".key path").first
    expect(key).to_have_css("stroke", rgb(load_style("paper").inks[0]))
    expect(lesson.locator(".scrub")).to_have_css("appearance", "auto")
    parts = [lesson.locator(f".panel:first-child {part}") for part in ("h2", ".drawing", ".foot")]
    boxes = [part.bounding_box() for part in parts]
    assert all(a["y"] + a["height"] <= b["y"] + 0.5 for a, b in pairwise(boxes))
    assert violations(lesson) == []
    lesson.emulate_media(color_scheme="dark")
    for part in ("h1", "header p", ".panel:first-child .foot p", ".results tbody tr:first-child"):
        picture = Image.open(io.BytesIO(lesson.locator(part).first.screenshot())).convert("RGB")
        shown = {colour for _, colour in picture.getcolors(1 << 24)}
        assert {(0, 0, 0), (255, 255, 255)} <= shown, part
    lesson.emulate_media(forced_colors="null", color_scheme="null")
