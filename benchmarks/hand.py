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
import time
from pathlib import Path

import numpy as np

import vad
from benchmarks.common import RESULTS, three, write_csv
from tests.browser import launched, opened, until

MOVES, FIRST, REST = 60, 10, 0.04  # the first ones load what is kept; seconds between two
#: Of each answer, in milliseconds: when the newest move that it knows was made, when it was asked
#: for, when it was read, and when the frame ended that shows it.
_WATCH = """() => {
  window.answers = [];
  let moved = 0;
  addEventListener("pointerrawupdate", (event) => { moved = event.timeStamp; }, true);
  const ask = fetch;
  window.fetch = async (path, options) => {
    const times = [moved, performance.now()], answer = await ask(path, options);
    if (!path.endsWith("/pose")) return answer;
    const read = answer.json.bind(answer);
    answer.json = async () => {
      const said = await read();
      times.push(performance.now());
      requestAnimationFrame(() => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => answers.push([...times, performance.now()]);
        port2.postMessage(0);
      });
      return said;
    };
    return answer;
  };
}"""


def main() -> None:
    """Measure and write ``results/hand.csv``."""
    rows = []
    with launched() as browser:
        for name in vad.MECHANISMS:
            times, served, worked = measured(browser, name)
            load = os.getloadavg()[0] / (os.cpu_count() or 1)
            median, most = np.percentile(times[:, 3] - times[:, 0], [50, 95])
            legs = np.median(np.diff(times), axis=0)
            found = [*map(three, (median, most, *legs, served, worked)), f"{load:.1f}"]
            rows.append([name, len(times), *found])
            print(*rows[-1], flush=True)
    head = ["mechanism", "answers", "median ms", "p95 ms", "to ask ms", "to answer ms"]
    head += ["to paint ms", "server cpu ms", "page cpu ms", "processes per core"]
    write_csv(RESULTS / "hand.csv", head, rows, ("starlette", "uvicorn", "playwright"))


def measured(browser: object, name: str) -> tuple[np.ndarray, float, float]:
    """Return the times of each answer, and the milliseconds of both processors for one."""
    command = [sys.executable, "-m", "vad", "gui", name, "--no-browser"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    address = server.stdout.readline().strip()
    try:
        with opened(browser, server=address.partition("?")[0]) as page:
            page.goto(address)
            until(page, lambda: page.locator(".control:not([hidden])").count(), 30)
            box = page.locator(".handle").bounding_box()
            x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            page.evaluate(_WATCH)
            metrics = page.context.new_cdp_session(page)
            metrics.send("Performance.enable", {"timeDomain": "threadTicks"})
            page.mouse.move(x, y)
            page.mouse.down()
            before = 0, 0.0, 0.0
            for number in range(FIRST + MOVES):
                if number == FIRST:
                    before = page.evaluate("answers.length"), spent(server.pid), painting(metrics)
                turn = math.tau * number / MOVES
                page.mouse.move(x + 12 * math.sin(turn), y + 12 * math.cos(turn) - 12)
                time.sleep(REST)  # in Python, not in the page
            after = page.evaluate("answers.length"), spent(server.pid), painting(metrics)
            count, served, worked = (b - a for a, b in zip(before, after, strict=True))
            times = np.array(page.evaluate("answers"))[before[0] : after[0]]
            page.mouse.up()
            return times, 1e3 * served / count, 1e3 * worked / count
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
