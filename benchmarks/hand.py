"""From a pointer that moves to the picture that follows, in a real browser, for every mechanism.

Run as ``python -m benchmarks.hand``; it needs playwright and chromium, on Linux.  Spans are wall
time, and so say something on a machine that has nothing else to do; what else ran is stated with
them.  The processor time that a move takes of the page's main thread is stated besides, which
others on the machine disturb less, and how many questions a drag asks: it should be none.

What a move takes contains what the browser takes to be driven from outside, more than a millisecond
on an empty page, and the frames in which the picture glides on after it.  So the time of a single
frame is stated, too: the page makes one move in each of many frames by itself, and nothing watches
it.  The pointer goes round a small circle in 60 frames, and the mean of these is taken four times.
The least is nearest to what a frame takes on a quiet machine, as what else runs there only adds to
it.  A machine that others use is twice as fast in one minute as in the next.  So all mechanisms are
measured in turn, five times.  Of a frame, the least of all is stated with what it takes at that
time to move one circle on an empty page, and the median, which is what it takes on this machine.

A picture can be seen at the next frame of the display at the earliest, and a pointer moves at any
time between two frames.  So the moves are spread evenly over the time of a frame.  Otherwise each
would follow the end of a frame after a fixed pause of about three frames, and a page whose frame
ends a little sooner or later would wait for nearly no time or for a whole frame each time.
"""

from __future__ import annotations

import math
import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

import vad
from benchmarks.common import RESULTS, three, write_csv
from tests.browser import launched, opened, until

MOVES, FIRST, REST = 60, 10, 0.04  # the first ones load what is kept; seconds between two, at least
PASSES, ROUNDS = 5, 4  # through all mechanisms; of as many frames as moves, in each
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


@dataclass(frozen=True)
class Measured:
    """One drag, frames and an empty page; times are in milliseconds.

    Attributes
    ----------
    moves
        From the newest move that a frame shows to its end.
    worked
        The page's work for a move that is made from outside.
    frames, circle
        The page's work for a frame, in each round, and for one of the empty page.
    asked, load
        Questions asked in the drag, and processes per core.
    """

    moves: np.ndarray
    worked: float
    frames: np.ndarray
    circle: float
    asked: int
    load: float


def main() -> None:
    """Measure and write ``results/hand.csv``."""
    found: dict[str, list[Measured]] = {name: [] for name in vad.MECHANISMS}
    with launched() as browser:
        for _ in range(PASSES):
            for name, passes in found.items():
                passes.append(measured(browser, name))
                print(name, *map(three, (passes[-1].frames.min(), passes[-1].circle)), flush=True)
    head = ["mechanism", "moves", "median ms", "p95 ms", "page cpu ms", "frame cpu ms"]
    head += ["one circle cpu ms", "median frame cpu ms", "questions", "processes per core"]
    write_csv(RESULTS / "hand.csv", head, map(row, found, found.values()), ("playwright",))


def row(name: str, passes: Sequence[Measured]) -> list[object]:
    """Return a line of the table."""
    moves = np.concatenate([each.moves for each in passes])
    frames = np.concatenate([each.frames for each in passes])
    best = min(passes, key=lambda each: each.frames.min())
    times = [*np.percentile(moves, [50, 95]), np.median([each.worked for each in passes])]
    times += [frames.min(), best.circle, np.median(frames)]
    asked, load = sum(each.asked for each in passes), max(each.load for each in passes)
    return [name, len(moves), *map(three, times), asked, f"{load:.1f}"]


def measured(browser: object, name: str) -> Measured:
    """Measure a mechanism in the window, and an empty page after it."""
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
            metrics = watched(page)
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
            frames = worked_in(metrics, lambda count: page.evaluate(_FRAMES, [x, y, count]))
            page.mouse.up()
            until(page, lambda: page.locator(".window.copied:not(.moving)").count(), 30)
    finally:
        server.terminate()
        server.wait()
    with opened(browser) as page:
        page.set_content("<svg><circle r=6 cy=50></svg>")
        circle = worked_in(watched(page), lambda count: page.evaluate(_CIRCLE, count)).min()
    return Measured(
        moves=times[:, 1] - times[:, 0],
        worked=1e3 * (after[1] - before[1]) / MOVES,
        frames=frames,
        circle=circle,
        asked=questions,
        load=os.getloadavg()[0] / (os.cpu_count() or 1),
    )


def watched(page: object) -> object:
    """Return a page's metrics: they count its main thread's own time from now on."""
    metrics = page.context.new_cdp_session(page)
    metrics.send("Performance.enable", {"timeDomain": "threadTicks"})
    return metrics


def worked_in(metrics: object, played: Callable[[int], object]) -> np.ndarray:
    """Return the milliseconds of a frame of those that are played, in each of some rounds."""
    played(MOVES)
    means = np.zeros(ROUNDS)
    for number in range(ROUNDS):
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
