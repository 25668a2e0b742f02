"""How much work a move of the hand is in the window: counts, the same on every machine."""

from __future__ import annotations

import json
import math
import re
from statistics import median
from typing import TYPE_CHECKING, Any

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
#: kilobytes of its lesson; elements that the browser styles for it, and objects that it lays out.
#: They lie 1.3 times above what is needed.
MOST = {
    "four-bar": (90, 94, 83, 26, 153),
    "hooke-joint": (129, 240, 125, 53, 219),
    "whitworth": (88, 81, 88, 32, 178),
}
_TRACED = ["devtools.timeline", "disabled-by-default-devtools.timeline"]
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
            page.wait_for_timeout(200)  # scales and labels glide on
            browser.start_tracing(page=page, categories=_TRACED)
            for number in range(16):
                page.mouse.move(x, y - number % 2)
            styled, laid, whole = work(json.loads(browser.stop_tracing()))
            assert not [url for url in asked if "/api/pose" in url]
            page.mouse.up()
    attributes, candidates = (
        (found["now"][each] - found["begun"][each]) / found["poses"]
        for each in ("attributes", "candidates")
    )
    assert found["poses"] >= MOVES
    assert attributes <= MOST[name][0]
    assert candidates <= MOST[name][1]
    assert styled <= MOST[name][3]
    assert laid <= MOST[name][4]
    assert whole == 0, "drawings, table and track are laid out by themselves"


def work(events: dict[str, Any]) -> tuple[float, float, float]:
    """Return what the browser does for most frames: elements styled, objects and pages laid out."""
    found = [(each["name"], each["args"]) for each in events["traceEvents"]]
    styled = [args.get("elementCount", 0) for name, args in found if name == "UpdateLayoutTree"]
    laid = [args["beginData"] for name, args in found if name == "Layout"]
    objects = median(each["dirtyObjects"] for each in laid)
    return median(styled), objects, median(not each["partialLayout"] for each in laid)


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
