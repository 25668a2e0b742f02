"""Two clients move mechanisms in one window for a long time: no error, and no growing memory."""

from __future__ import annotations

import json
import os
import random
import re
import signal
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

import pytest

from tests.gui.test_command import started
from vad.mechanisms import MECHANISMS

#: How many moves each client makes; ten thousand take some minutes: VAD_FULL=1.
MOVES = 10_000 if os.environ.get("VAD_FULL") else 12
#: So many at first, until all that is kept on purpose is there; and the most that comes then, in
#: bytes.
WARM, MOST = 24, 96e6
#: What both clients move, one after the other, and after how many moves the next comes.
MOVED, NEXT = ("four-bar", "slider-crank", "crank-slotted-lever", "hooke-joint"), 6


class Client:
    """A page in a browser, under a hand that moves the driver and, now and then, a length."""

    def __init__(self, address: str, seed: int) -> None:
        port, token = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=(\S+)\n", address).groups()
        self._line = HTTPConnection("127.0.0.1", int(port), timeout=60)
        self._headers = {"content-type": "application/json", "cookie": f"vad-{port}={token}"}
        self._dice = random.Random(seed)
        self._kept: dict[str, Any] = {}

    def close(self) -> None:
        """Close its connection."""
        self._line.close()

    def move(self, number: int) -> int:
        """Ask for a pose as the page does; return the status of the answer."""
        name = MOVED[number // NEXT % len(MOVED)]
        driver = next(iter(MECHANISMS[name].inputs))
        question = {"mechanism": name, "inputs": {driver: number * 1.7}}
        if number % NEXT == 0:
            self._kept = {}
        if number % 10 == 5:
            parameters = MECHANISMS[name]().parameters()
            changed = self._dice.choice(list(parameters))
            question["parameters"] = {changed: parameters[changed] * self._dice.uniform(0.9, 1.1)}
        path = "lesson" if number % 25 == 24 else "pose"
        body = json.dumps(question if path == "lesson" else {**question, **self._kept})
        self._line.request("POST", f"/api/{path}", body, self._headers)
        with self._line.getresponse() as answer:
            said = json.loads(answer.read())
        if path == "pose" and "panels" in said:
            self._kept = {"scales": said["scales"], "ways": said["ways"]}
        return answer.status

    def moves(self, first: int, last: int) -> list[int]:
        """Return the statuses of several moves that are not 200."""
        statuses = map(self.move, range(first, last))
        return [status for status in statuses if status != 200]


def memory(process: int) -> int:
    """Return the bytes that a process has in memory."""
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="nothing tells the memory")
def test_two_clients_move_for_a_long_time(record_property):
    server = started("four-bar", "--no-browser")
    try:
        address = server.stdout.readline()
        with (
            closing(Client(address, 1)) as one,
            closing(Client(address, 2)) as other,
            ThreadPoolExecutor(2) as pool,
        ):
            clients = [one, other]
            before = memory(server.pid)
            wrong = list(pool.map(lambda each: each.moves(0, WARM), clients))
            warm = memory(server.pid)
            wrong += pool.map(lambda each: each.moves(WARM, MOVES), clients)
            after = memory(server.pid)
    finally:
        server.send_signal(signal.SIGINT)
        said = server.communicate(timeout=60)
    for name, value in (("before", before), ("warm", warm), ("after", after)):
        record_property(name, value)
    assert (wrong, *said) == ([[], [], [], []], "", "")
    assert after - warm < MOST
