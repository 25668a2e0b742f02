"""How much work a move of the hand is in the window: counts, the same on every machine."""

from __future__ import annotations

import json
import math
import re
from statistics import median, quantiles
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
#: They lie about 1.3 times above what is needed where letters follow in each frame, as they do
#: where a machine is slow; elsewhere they follow in every second one.
MOST = {
    "four-bar": (54, 29, 83, 26, 82),
    "hooke-joint": (87, 177, 125, 57, 115),
    "spherical-four-bar": (84, 568, 165, 59, 110),
    "whitworth": (63, 63, 88, 33, 95),
}
#: Milliseconds from one text to the next while the hand moves.
LEGIBLE = 160
#: Moves in each of so many frames, and then twice at once: in how many of these frames the ring has
#: another place and the table another text, and what the box says and should say after each of the
#: last moves, when the hand lets go and when a program asks for a pose.  The last move has left its
#: labels to the next frame: how many places are tried for them when the hand lets go.
_READ = """([x, y, count]) => new Promise((done) => {
  const one = (name) => document.querySelector(name), begun = performance.now();
  const ring = one("[data-vad-grip]"), box = one(".said input"), table = one(".results");
  const found = { drawn: 0, written: 0, box: [] };
  let place = "", text = "";
  const to = (number, kind = "pointermove") => ring.dispatchEvent(new PointerEvent(kind,
    { clientX: x + number % 6, clientY: y - number * number % 5, bubbles: true, pointerId: 1 }));
  const tried = (what) => {
    const { candidates } = vad.counts;
    what();
    return vad.counts.candidates - candidates;
  };
  const says = () => found.box.push([parseFloat(box.value), vad.state.angle]);
  const step = () => {
    to(count);
    found.drawn += place !== (place = ring.getAttribute("cx"));
    found.written += text !== (text = table.textContent);
    if (--count) return requestAnimationFrame(step);
    to(7), says(), to(9), says(); // at most one of them finds it due
    while (tried(() => to(++count)) && count < 9);
    found.late = tried(() => to(count, "pointerup")), says();
    vad.pose({ angle: 40 }), says();
    vad.pose({ angle: 41 }), says();
    done({ ...found, time: performance.now() - begun });
  };
  requestAnimationFrame(step);
})"""
#: As many moves at once, so that no frame in which labels glide on lies between: what each takes.
_COUNTED = """([x, y, count]) => {
  const ring = document.querySelector("[data-vad-grip]"), begun = vad.counts;
  for (let n = 0; n < count; n++) {
    const turn = 2 * Math.PI * n / count, bubbles = true, pointerId = 1;
    const [clientX, clientY] = [x + 12 * Math.sin(turn), y + 12 * Math.cos(turn) - 12];
    ring.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY, bubbles, pointerId }));
  }
  return ["attributes", "candidates"].map((each) => (vad.counts[each] - begun[each]) / count);
}"""
_TRACED = ["devtools.timeline", "disabled-by-default-devtools.timeline"]
#: The kilobytes of the window itself.
WINDOW = 320


@pytest.mark.exhaustive(8)
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
            attributes, candidates = page.evaluate(_COUNTED, [x, y, MOVES])
            page.evaluate(
                """() => {
                  window.poses_ = 0;
                  vad.addEventListener("pose", () => poses_++);
                  window.again_ = [];
                  addEventListener("pointermove", () => {
                    const { candidates } = vad.counts;
                    requestAnimationFrame(() => again_.push(vad.counts.candidates - candidates));
                  });
                }"""
            )
            for number in range(MOVES):
                turn = math.tau * number / MOVES
                page.mouse.move(x + 12 * math.sin(turn), y + 12 * math.cos(turn) - 12)
            poses, again = page.evaluate("[poses_, again_]")
            page.wait_for_timeout(200)  # scales and labels glide on
            browser.start_tracing(page=page, categories=_TRACED)
            for number in range(16):
                page.mouse.move(x, y - number % 2)
            styled, laid, whole = work(json.loads(browser.stop_tracing()))
            assert not [url for url in asked if "/api/pose" in url]
            read = page.evaluate(_READ, [x, y, MOVES])
            page.mouse.up()
    assert poses >= MOVES
    assert attributes <= MOST[name][0]
    assert candidates <= MOST[name][1]
    assert sum(map(bool, again)) <= MOVES / 8, "labels are placed once in a frame"
    assert styled <= MOST[name][3]
    assert laid <= MOST[name][4]
    assert read["drawn"] == MOVES
    assert 2 <= read["written"] <= read["time"] / LEGIBLE + 2, "nobody reads more"
    assert read["late"] > 0, "labels are there when the hand lets go"
    one, other, *rest = read["box"]
    assert one[0] != one[1] or other[0] != other[1], "the box follows as slowly as the table"
    assert all(said == asked for said, asked in rest)
    assert whole == 0, "drawings, table and track are laid out by themselves"


def work(events: dict[str, Any]) -> tuple[float, float, float]:
    """Return what the browser does for a frame: elements styled, objects and pages laid out.

    That of most frames: in some the table is written, too, and on a busy machine in many of them.
    """
    found = [(each["name"], each["args"]) for each in events["traceEvents"]]
    styled = [args.get("elementCount", 0) for name, args in found if name == "UpdateLayoutTree"]
    laid = [args["beginData"] for name, args in found if name == "Layout"]
    objects = quantiles([each["dirtyObjects"] for each in laid])[0]
    return median(styled), objects, median(not each["partialLayout"] for each in laid)


@pytest.mark.exhaustive(4)
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
