"""From a pointer that moves to the picture that follows, in a real browser, for every mechanism.

Run as ``python -m benchmarks.hand``; it needs playwright and chromium, on Linux.  Spans are wall
time, and so say something on a machine that has nothing else to do; what else ran is stated with
them.  The processor time that a move takes of the page's main thread is stated besides, which
others on the machine disturb less, and how many questions a drag asks: it should be none.

What a move takes contains what the browser takes to be driven from outside, more than a millisecond
on an empty page, and the frames in which the picture glides on after it.  So the time of a single
frame is stated, too: the page makes one move in each of many frames by itself, and nothing watches
it.  The pointer goes round a small circle in 60 frames.  The mean of these is taken twenty times:
the least is nearest to what a frame takes on a quiet machine, as what else runs there only adds to
it, and the median is what it takes on this one.  Machines differ by a factor of two, and a machine
that others use does so from one minute to the next.  So beside it stands, from before and after
these frames, the least that a frame takes in which one circle moves on an empty page.

A picture can be seen at the next frame of the display at the earliest, and a pointer moves at any
time between two frames.  So the moves are spread evenly over the time of a frame.  Otherwise each
would follow the end of a frame after a fixed pause of about three frames, and a page whose frame
ends a little sooner or later would wait for nearly no time or for a whole frame each time.
"""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np

import vad
from benchmarks.common import RESULTS, three, write_csv
from tests.browser import launched, opened, until

MOVES, FIRST, REST = 60, 10, 0.04  # the first ones load what is kept; seconds between two, at least
ROUNDS, BESIDE = 20, 3  # of as many frames as moves; of those on an empty page, before and after
#: The rest of the pause is a share of a frame.  That of each move, by its number: evenly spread,
#: however many there are.
FRAME, SPREAD = 1 / 60, (math.sqrt(5) - 1) / 2
#: Of each frame, in milliseconds: when the newest move that it shows was made, and when it ended.
#: To watch takes a twentieth of a frame, until ``watch_`` is told to end.
_WATCH = """() => {
  window.frames_ = [];
  window.watch_ = new AbortController();
  let moved = 0, due = false;
  addEventListener("pointermove", (event) => {
    moved = event.timeStamp;
    if (due) return;
    due = true;
    requestAnimationFrame(() => {
      due = false;
      const { port1, port2 } = new MessageChannel(), made = moved;
      port1.onmessage = () => frames_.push([made, performance.now()]);
      port2.postMessage(0);
    });
  }, { capture: true, signal: watch_.signal });
}"""


#: Makes one move in each of so many frames.  As with a pointer's move, the page hears of it before
#: its own animations run: the next step is asked for before the page asks for the next of these.
_FRAMES = """([x, y, count]) => new Promise((done) => {
  const ring = document.querySelector("[data-vad-grip]");
  const step = () => {
    const turn = 2 * Math.PI * count / 60, bubbles = true, pointerId = 1;
    const [clientX, clientY] = [x + 12 * Math.sin(turn), y + 12 * Math.cos(turn) - 12];
    if (count) requestAnimationFrame(step);
    ring.dispatchEvent(new PointerEvent("pointermove", { clientX, clientY, bubbles, pointerId }));
    if (!count--) done();
  };
  requestAnimationFrame(step);
})"""


#: Moves a circle in each of so many frames.
_CIRCLE = """(count) => new Promise((done) => {
  const circle = document.querySelector("circle");
  const step = () => {
    if (count) requestAnimationFrame(step);
    circle.setAttribute("cx", count % 7);
    if (!count--) done();
  };
  requestAnimationFrame(step);
})"""


def main() -> None:
    """Measure and write ``results/hand.csv``."""
    rows = []
    with launched() as browser:
        for name in vad.MECHANISMS:
            beside = empty(browser)
            times, worked, framed, asked = measured(browser, name)
            least = three(min(beside, empty(browser)))
            load = os.getloadavg()[0] / (os.cpu_count() or 1)
            median, most = np.percentile(times[:, 1] - times[:, 0], [50, 95])
            rows.append(
                [
                    name,
                    len(times),
                    *map(three, (median, most, worked, framed.min(), np.median(framed))),
                    least,
                    asked,
                    f"{load:.1f}",
                ]
            )
            print(*rows[-1], flush=True)
    head = ["mechanism", "frames", "median ms", "p95 ms", "page cpu ms", "frame cpu ms"]
    head += ["median frame cpu ms", "one circle cpu ms", "questions", "processes per core"]
    write_csv(RESULTS / "hand.csv", head, rows, ("playwright",))


def empty(browser: object) -> float:
    """Return the milliseconds of a frame in which one circle moves on an empty page."""
    with opened(browser) as page:
        page.set_content("<svg><circle r=6 cy=50></svg>")
        metrics = page.context.new_cdp_session(page)
        metrics.send("Performance.enable", {"timeDomain": "threadTicks"})
        return worked_in(metrics, lambda count: page.evaluate(_CIRCLE, count), BESIDE).min()


def measured(browser: object, name: str) -> tuple[np.ndarray, float, np.ndarray, int]:
    """Return the times of each frame, the page's work, that of frames, and questions asked.

    Work is in milliseconds: for a move that is made from outside, and for a frame in each round.
    """
    command = [sys.executable, "-m", "vad", "gui", name, "--no-browser"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    address = server.stdout.readline().strip()
    try:
        with opened(browser, server=address.partition("?")[0]) as page:
            page.goto(address)
            until(page, lambda: page.locator(".window.copied:not(.moving)").count(), 30)
            box = page.locator("[data-vad-grip]").bounding_box()
            x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            page.evaluate(_WATCH)
            metrics = page.context.new_cdp_session(page)
            metrics.send("Performance.enable", {"timeDomain": "threadTicks"})
            page.mouse.move(x, y)
            page.mouse.down()
            before, asked = (0, 0.0), []
            for number in range(FIRST + MOVES):
                if number == FIRST:
                    before = page.evaluate("frames_.length"), painting(metrics)
                    page.on("request", lambda request: asked.append(request.url))
                turn = math.tau * number / MOVES
                page.mouse.move(x + 12 * math.sin(turn), y + 12 * math.cos(turn) - 12)
                time.sleep(REST + number * SPREAD % 1 * FRAME)  # in Python, not in the page
            after = page.evaluate("frames_.length"), painting(metrics)
            times = np.array(page.evaluate("frames_"))[before[0] : after[0]]
            questions = len(asked)
            page.evaluate("watch_.abort()")
            framed = worked_in(metrics, lambda count: page.evaluate(_FRAMES, [x, y, count]), ROUNDS)
            page.mouse.up()
            until(page, lambda: page.locator(".window.copied:not(.moving)").count(), 30)
            return times, 1e3 * (after[1] - before[1]) / MOVES, framed, questions
    finally:
        server.send_signal(signal.SIGINT)
        server.wait()


def worked_in(metrics: object, played: Callable[[int], object], rounds: int) -> np.ndarray:
    """Return the milliseconds of a frame of those that are played, in each of some rounds."""
    played(MOVES)
    means = np.zeros(rounds)
    for number in range(rounds):
        begun = painting(metrics)
        played(MOVES)
        means[number] = 1e3 * (painting(metrics) - begun) / MOVES
    return means


def painting(metrics: object) -> float:
    """Return the time that the page's main thread has worked so far, in seconds."""
    found = metrics.send("Performance.getMetrics")["metrics"]
    return next(each["value"] for each in found if each["name"] == "TaskDuration")


if __name__ == "__main__":
    main()
