"""How much work a move of the hand is in the window: counts, the same on every machine."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import pytest

from tests.browser import opened, until
from vad.gui.answers import lesson
from vad.gui.messages import ExportQuestion, LessonQuestion, as_json
from vad.gui.server import served
from vad.gui.window import window

if TYPE_CHECKING:
    from playwright.sync_api import Browser

MOVES = 24
#: Of each mechanism: the most attributes that a move sets, places that it tries for labels, and
#: kilobytes of its lesson.  They lie 1.3 times above what is needed.
MOST = {"four-bar": (111, 94, 83), "hooke-joint": (165, 240, 125), "whitworth": (95, 81, 88)}
#: The kilobytes of the window itself.
WINDOW = 320


@pytest.mark.parametrize("name", MOST)
def test_a_move_sets_no_more_than_it_moves_and_asks_nobody(browser: Browser, name: str) -> None:
    with served(ExportQuestion(name)) as key:
        home = key.address.partition("?")[0]
        with opened(browser, server=home, viewport={"width": 1280, "height": 800}) as page:
            page.goto(key.address)
            until(page, lambda: page.locator(".window.copied:not(.moving)").count(), 60)
            box = page.locator("[data-vad-grip]").bounding_box()
            x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            page.mouse.move(x, y)
            page.mouse.down()
            page.mouse.move(x + 3, y + 3)
            asked: list[str] = []
            page.on("request", lambda request: asked.append(request.url))
            page.evaluate(
                """() => {
                  window.poses_ = 0;
                  vad.addEventListener("pose", () => poses_++);
                  window.begun_ = vad.counts;
                }"""
            )
            for number in range(MOVES):
                turn = math.tau * number / MOVES
                page.mouse.move(x + 12 * math.sin(turn), y + 12 * math.cos(turn) - 12)
            found = page.evaluate("({ now: vad.counts, begun: begun_, poses: poses_ })")
            assert not [url for url in asked if "/api/pose" in url]
            page.mouse.up()
    attributes, candidates = (
        (found["now"][each] - found["begun"][each]) / found["poses"]
        for each in ("attributes", "candidates")
    )
    assert found["poses"] >= MOVES
    assert attributes <= MOST[name][0]
    assert candidates <= MOST[name][1]


@pytest.mark.parametrize("name", MOST)
def test_a_lesson_and_the_window_have_so_many_bytes(name: str) -> None:
    answer = lesson(LessonQuestion(name))
    size = len(as_json(answer).encode()) / 1000
    known = tuple(re.findall(r"^\.([\w-]+){", answer["looks"], re.MULTILINE))
    second = lesson(LessonQuestion(name, key=answer["key"], known=known))
    assert second["looks"].count("{") <= 0.1 * len(known)
    again = len(as_json(second).encode()) / 1000
    page = len(window(ExportQuestion(name), "").encode()) / 1000
    assert size <= MOST[name][2]
    assert again <= 0.6 * size, "what stands on the page is not sent again"
    assert page <= WINDOW
