"""From a pointer that moves to the picture that follows, in a real browser, for every mechanism.

Run as ``python -m benchmarks.hand``; it needs playwright and chromium, on Linux.  Spans are wall
time, and so say something on a machine that has nothing else to do; what else ran is stated with
them.  The processor time that a move takes of the server and of the page's main thread is stated
besides, which others on the machine disturb less.
"""

from __future__ import annotations

import math
import os
import signal
import subprocess
import sys
from pathlib import Path

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
            spans, served, painted = measured(browser, name)
            load = os.getloadavg()[0] / (os.cpu_count() or 1)
            median, most = np.percentile(spans, [50, 95])
            cost = three(served), three(painted)
            rows.append([name, len(spans), three(median), three(most), *cost, f"{load:.1f}"])
            print(*rows[-1], flush=True)
    head = ["mechanism", "moves", "median ms", "p95 ms", "server cpu ms", "page cpu ms"]
    head += ["processes per core"]
    write_csv(RESULTS / "hand.csv", head, rows, ("starlette", "uvicorn", "playwright"))


def measured(browser: object, name: str) -> tuple[list[float], float, float]:
    """Return the milliseconds of each move that was answered, and those of both processors."""
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
            metrics = page.context.new_cdp_session(page)
            metrics.send("Performance.enable", {"timeDomain": "threadTicks"})
            before = spent(server.pid), painting(metrics)
            for number in range(MOVES):
                turn = math.tau * number / MOVES
                page.mouse.move(x + 12 * math.sin(turn), y + 12 * math.cos(turn) - 12)
                page.wait_for_timeout(REST)
            after = spent(server.pid), painting(metrics)
            page.mouse.up()
            found: list[float] = page.evaluate("spans")
            each = [1e3 * (b - a) / len(found) for a, b in zip(before, after, strict=True)]
            return found[3:], each[0], each[1]  # the first ones load what is kept
    finally:
        server.send_signal(signal.SIGINT)
        server.wait()


def spent(pid: int) -> float:
    """Return the processor time of a process so far, in seconds."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def painting(metrics: object) -> float:
    """Return the time that the page's main thread has worked so far, in seconds."""
    found = metrics.send("Performance.getMetrics")["metrics"]
    return next(each["value"] for each in found if each["name"] == "TaskDuration")


if __name__ == "__main__":
    main()
