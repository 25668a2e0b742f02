"""Messages to the window that no page sends: an answer, or an error of one line.

A seed is a path and a body for the server, or a message by the channel of a notebook.
"""

from __future__ import annotations

import json
import random
from copy import deepcopy
from functools import cache
from threading import Event
from typing import Any

from starlette.testclient import TestClient

import vad
from tests.fuzz.promise import broken
from vad.gui.guard import PageKey
from vad.gui.messages import ExportQuestion
from vad.gui.server import application
from vad.gui.widget import reply

#: The most seconds that an answer may take.
LONGEST = 60.0

PORT = 8765
PATHS = ("/api/pose",) * 4 + ("/api/lesson",) * 2 + ("/api/export/svg", "/api/export/json")
STRANGE = ("/", "/api/export/exe", "/api/export/../x", "/api/", "/api/pose/x", "/%00", "/api/pose?")
#: Stands for a path: the message comes by the channel of a notebook.
CELL = "cell"
VALUES: tuple[Any, ...] = (
    *(None, True, 0, -1, 60, 1e-12, 1e7, 1e-150, 1e150, 1e199, 1e308, float("nan"), 10**400),
    *("", "60", "6 cm", "60 nan", "1e400", "x" * 3000, "\x00", "\ud800", "<b>", "open", "crossed"),
    *([], [[]], {}, {"": {}}, [1, 2, 3], ["velocity"], {"crank": 5e151}, {"angle": "nan"}),
    {f"P{number}": ["coupler", number, 3] for number in range(400)},
    *([640, 360], [1e9, 1e9], ["velocity"] * 1000, {"velocity": [1, 2, 3]}, {"x": [0, 0, 0]}),
)
CELL_PATHS = ("pose", "lesson", "export/svg", "export/json", *STRANGE, *VALUES)
FIELDS = (
    *(
        "mechanism",
        "parameters",
        "inputs",
        "assembly",
        "points",
        "length_unit",
        "panels",
        "language",
    ),
    *("style", "burden", "scales", "ways", "stands", "known", "size", "fps", "speed", "crnak", ""),
)


def case(seed: int) -> tuple[str, bytes]:
    """Return a path and a body."""
    dice = random.Random(seed)
    kind = dice.choice(list(vad.MECHANISMS.values()))
    mechanism = kind()
    data: dict[str, Any] = {"mechanism": kind.name}
    if dice.random() < 0.8:
        scaled = 10.0 ** dice.choice((0, 0, 1, -1, 4, -4, 9, -12, 100, -150, 150))
        lengths = dict(mechanism.parameters())
        for name in dice.sample(list(lengths), dice.randint(1, len(lengths))):
            lengths[name] = lengths[name] * scaled if lengths[name] is not None else 1.0
        data["parameters"] = {name: value for name, value in lengths.items() if value is not None}
    if dice.random() < 0.7:
        data["inputs"] = {next(iter(kind.inputs)): dice.uniform(-400.0, 400.0)}
    if dice.random() < 0.4:
        data["burden"] = _burden(dice, mechanism)
    for _ in range(dice.choice((0, 1, 1, 1, 2, 4))):
        held = dice.choice([data, *(each for each in data.values() if isinstance(each, dict))])
        held[dice.choice(list(held) if held and dice.random() < 0.4 else FIELDS)] = _one(dice)
    if dice.random() < 0.2:
        asked = {"id": dice.choice((1, 1, *VALUES)), "path": dice.choice(CELL_PATHS), "body": data}
        for _ in range(dice.choice((0, 0, 0, 1, 2))):
            asked[dice.choice(list(asked))] = _one(dice)
        if dice.random() < 0.1:
            del asked[dice.choice(list(asked))]
        return CELL, json.dumps(_one(dice) if dice.random() < 0.05 else asked).encode()
    body = json.dumps(data).encode()
    if dice.random() < 0.1:
        at = dice.randrange(len(body))
        body = body[:at] + dice.choice((b"", b"\xff", b"[" * 50_000, b"9" * 5000)) + body[at + 1 :]
    return dice.choice(STRANGE) if dice.random() < 0.05 else dice.choice(PATHS), body


def _burden(dice: random.Random, mechanism: vad.Mechanism) -> dict[str, Any]:
    """Return loads and masses on bodies that there are, in part of values that cannot be."""
    letters, bodies = [*mechanism.letters, "Z"], [*mechanism.links, *mechanism.slides, "frame"]

    def number() -> Any:
        return (
            _one(dice)
            if dice.random() < 0.2
            else dice.uniform(-1.0, 1.0) * 10.0 ** dice.choice((0, 3, 59))
        )

    loads = [
        {
            "at": dice.choice(letters),
            "on": dice.choice(bodies),
            "force": number(),
            "angle": number(),
        },
        {"on": dice.choice(bodies), "couple": number()},
        {"at": dice.choice(letters), "table": [[0, 90, number()], [number(), 1, 2]]},
        f"{dice.uniform(-9, 9)} N at {dice.choice(letters)}",
    ]
    found: dict[str, Any] = {"loads": dice.sample(loads, dice.randint(0, len(loads)))}
    if dice.random() < 0.5:
        found["masses"] = {
            dice.choice(bodies): dice.choice((number(), {"mass": 1, "inertia": number()}))
        }
        found["gravity"] = dice.choice((9.81, number(), [0, number()]))
    if dice.random() < 0.2:
        found["friction"] = {dice.choice(bodies): number()}
    return found


def _one(dice: random.Random) -> Any:
    """Return a value of its own, which may be changed."""
    return deepcopy(dice.choice(VALUES))


@cache
def client() -> TestClient:
    """Return a client that may ask."""
    key, home = PageKey(PORT), f"http://127.0.0.1:{PORT}"
    app = application(key, ExportQuestion("slider-crank"), Event())
    asking = TestClient(app, home, raise_server_exceptions=True)
    asking.cookies.set(key.cookie, key.token)
    return asking


def fault(message: tuple[str, bytes], _: int = 0) -> str | None:
    """Send a message; return what the answer breaks, or None."""
    path, body = message

    def asked_in_a_cell() -> None:
        (_, (said,)) = reply(json.loads(body))
        _check(json.loads(said) if said.startswith(b"{") else None)

    def asked() -> None:
        headers = {"content-type": "application/json"}
        answer = client().post(path, content=body, headers=headers)
        if answer.status_code >= 500 and answer.status_code != 503:
            raise AssertionError(f"{answer.status_code}: {answer.text[:300]}")
        if answer.status_code == 200 and "json" in answer.headers.get("content-type", ""):
            _check(answer.json())

    return broken(asked_in_a_cell if path == CELL else asked, LONGEST)


def _check(said: object) -> None:
    """Raise if an answer has an error that is no line."""
    line = said.get("error", "x") if isinstance(said, dict) else "x"
    line = line.get("message", "x") if isinstance(line, dict) else line
    if not isinstance(line, str) or not line.isprintable() or len(line) > 520:
        raise AssertionError(f"is no line: {line!r}"[:600])
