"""From a pointer that moves to the picture that follows, in a real browser, for every mechanism.

Run as ``python -m benchmarks.hand``; it needs playwright and chromium.  Times are wall time, and so
say something on a machine that has nothing else to do; what else ran is stated with them.
"""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys

import numpy as np

import vad
from benchmarks.common import RESULTS, three, write_csv
from tests.browser import launched, opened, until

MOVES, REST = 60, 40  # milliseconds between two moves, so that each has its own answer
#: From the time stamp of a pointer's move to the end of the frame in which its answer is painted.
_WATCH = """() => {
  let moved = 0;
  window.spans = [];
  addEventListener("pointermove", (event) => { moved ||= event.timeStamp; }, true);
  new MutationObserver(() => requestAnimationFrame(() => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => {
      if (moved) spans.push(performance.now() - moved);
      moved = 0;
    };
    channel.port2.postMessage(0);
  })).observe(document.querySelector(".panels"), { childList: true, subtree: true });
}"""


def main() -> None:
    """Measure and write ``results/hand.csv``."""
    rows = []
    with launched() as browser:
        for name in vad.MECHANISMS:
            spans = measured(browser, name)
            load = os.getloadavg()[0] / (os.cpu_count() or 1)
            median, most = np.percentile(spans, [50, 95])
            rows.append([name, len(spans), three(median), three(most), f"{load:.1f}"])
            print(*rows[-1], flush=True)
    head = ["mechanism", "moves", "median ms", "p95 ms", "processes per core"]
    write_csv(RESULTS / "hand.csv", head, rows, ("starlette", "uvicorn", "playwright"))


def measured(browser: object, name: str) -> list[float]:
    """Return the milliseconds of each move that was answered."""
    command = [sys.executable, "-m", "vad", "gui", name, "--no-browser"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    address = server.stdout.readline().strip()
    try:
        with opened(browser, server=address.partition("?")[0]) as page:
            page.goto(address)
            until(page, lambda: page.locator(".control:not([hidden])").count(), 30)
            box = page.locator(".handle").bounding_box()
            x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            page.mouse.move(x, y)
            page.mouse.down()
            page.evaluate(_WATCH)
            for number in range(MOVES):
                turn = math.tau * number / MOVES
                page.mouse.move(x + 12 * math.sin(turn), y + 12 * math.cos(turn) - 12)
                page.wait_for_timeout(REST)
            page.mouse.up()
            found: list[float] = page.evaluate("spans")
            return found[3:]  # the first ones load what is kept
    finally:
        server.send_signal(signal.SIGINT)
        server.wait()


if __name__ == "__main__":
    main()
