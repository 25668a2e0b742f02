"""Sheets in JSON that nobody should write: read, painted, and written again.

A seed is a sheet with a few values replaced, left out, repeated or exchanged, or a text cut short.
"""

from __future__ import annotations

import json
import random
import tempfile
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

import vad
from tests.fuzz.promise import broken, check_numbers
from vad.export import sheet_json

#: The most seconds that a sheet may take from its text to its picture.
LONGEST = 20.0

MECHANISMS = [
    *(vad.FourBar(), vad.SliderCrank(offset=10.0), vad.CrankSlottedLever(rod=100, ram_height=180)),
    *(vad.Whitworth(), vad.GateActuator(), vad.HookeJoint(), vad.SphericalFourBar(), vad.RSSR()),
]
TEXTS = [sheet_json.to_text(vad.draw(vad.solve(each))) for each in MECHANISMS]
NUMBERS = (
    *(0, -1, 1, 2, 3, 17, 18, 10**7, 10**400, 0.0, 0.5, -2.5, 360.0, 1e7, -1e7, 1e12, 1e30),
    *(1e-12, 1e-30, 1e-160, 5e-324, 1e100, -1e155, 1e200, 1e249, 1e308, float("nan"), -1e308),
)
OTHERS = (None, True, "", "x", "ₙ", "9" * 400, "x" * 3000, "\x00", "<b>", [], [[]], {}, {"": {}})


def case(seed: int) -> str:
    """Return the text of a sheet."""
    dice = random.Random(seed)
    text = dice.choice(TEXTS)
    if dice.random() < 0.03:
        at = dice.randrange(1, len(text))
        return text[:at] + dice.choice(("", "x", text[at // 2 :]))
    data = json.loads(text)
    for _ in range(dice.choice((1, 1, 1, 2, 3, 8))):
        _mutate(data, dice)
    return json.dumps(data)


def _mutate(data: Any, dice: random.Random) -> None:
    """Change one value, most often a number for another number."""
    ways = list(places(data))
    numbers = [way for way in ways if isinstance(_at(data, way), int | float)]
    way = dice.choice(numbers if numbers and dice.random() < 0.5 else ways)
    held, last, kind = _at(data, way[:-1]), way[-1], dice.random()
    if kind < 0.15:
        del held[last]
    elif kind < 0.25:
        held[last] = deepcopy(_at(data, dice.choice(ways)))
    elif kind < 0.32 and isinstance(held, list):
        held[last:last] = [held[last]] * dice.choice((1, 3, 400))
    elif kind < 0.4:
        held[last] = dice.choice(OTHERS)
    elif isinstance(held[last], str):
        held[last] = dice.choice(
            (held[last][:-1], held[last] * 2, held[last].upper(), *OTHERS[2:9])
        )
    else:
        held[last] = dice.choice(NUMBERS)


def _at(data: Any, way: tuple[Any, ...]) -> Any:
    for key in way:
        data = data[key]
    return data


def places(data: Any, way: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the way to every value."""
    for key, value in data.items() if isinstance(data, dict) else enumerate(data):
        yield (*way, key)
        if isinstance(value, dict | list):
            yield from places(value, (*way, key))


def fault(text: str, _: int = 0) -> str | None:
    """Read and paint a sheet; return what it breaks, or None."""

    def tried() -> None:
        sheet = vad.sheet_from_json(text)
        if vad.sheet_from_json(sheet_json.to_text(sheet)) != sheet:
            raise AssertionError("comes back as another sheet")
        with tempfile.TemporaryDirectory() as folder:
            vad.save(sheet, Path(folder) / "a.svg")
            check_numbers(Path(folder) / "a.svg")

    return broken(tried, LONGEST)
