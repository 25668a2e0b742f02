"""Calls that nobody should make, at random: what of them breaks the promise of one line.

In come a number of tries and a seed, out go the faults that were found, as text.
"""

from __future__ import annotations

import datetime
import random
import traceback
import warnings
from collections.abc import Callable, Iterator
from dataclasses import fields
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np

import vad


class Mute:
    """Cannot say what it is, be a number or an array."""

    def __repr__(self) -> str:
        raise RuntimeError("two\nlines")

    def __float__(self) -> float:
        raise ZeroDivisionError

    def __array__(self, *_: object, **__: object) -> object:
        raise ZeroDivisionError


NUMBERS = [
    0,
    -0.0,
    1,
    -1,
    3.5,
    60.0,
    1e-320,
    -1e300,
    1e61,
    float("nan"),
    float("inf"),
    10**400,
    -(10**5000),
    True,
    1j,
    Fraction(1, 3),
    Fraction(10**400, 3),
    Decimal("sNaN"),
    Decimal("1e999"),
    np.int64(7),
    np.float16(2.5),
    np.bool_(True),
    np.timedelta64(1, "s"),
]
TEXTS = [
    "",
    " ",
    "60",
    "open",
    "paper",
    "en",
    "velocity",
    "velocity:2",
    "velocity:x",
    ":::",
    "two\nlines",
    "\x00",
    "\x1b[31m",
    "\udc80",
    "٣",
    "9" * 6000,
    "x" * 200_000,
    b"60",
    bytearray(b"60"),
]
THINGS = [
    None,
    [],
    (),
    {},
    {1: 2},
    {60.0},
    [[]],
    [60.0, 70.0],
    [True],
    ["60"],
    [None],
    [[1.0], [2.0, 3.0]],
    [10**400],
    (640, 360),
    (640.0, 360.0),
    (640.5, 360),
    ("640", "360"),
    (10**5000, 1),
    (1, 2, 3),
    ("velocity",),
    ["velocity", "velocity"],
    (".srt",),
    ["srt"],
    range(3),
    np.array([]),
    np.array(5.0),
    np.array(["velocity"]),
    np.ma.masked,
    np.ma.masked_greater([1.0, 2.0], 1.0),
    np.zeros((2, 0)),
    datetime.date(2024, 2, 29),
    object,
    Ellipsis,
    Mute(),
    Mute,
    print,
    vad,
    vad.FourBar,
    vad.FourBar(),
]
PATHS = [
    "",
    ".",
    "..",
    "/",
    "a\0.png",
    "x" * 300 + ".png",
    "no/such/a.png",
    "a.xyz",
    "a.json",
    "a/",
]

KINDS = list(vad.MECHANISMS.values())
MOTIONS = [vad.solve(kind()) for kind in KINDS]
SHEET = vad.draw(MOTIONS[0])
LESSON = vad.animate(SHEET)


def calls(tries: int, seed: int) -> Iterator[str]:
    """Make so many calls of the public verbs; yield those that broke the promise, and how."""
    dice = random.Random(seed)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for _ in range(tries):
            verb = dice.choice(VERBS)
            try:
                verb(dice)
            except vad.VadError as error:
                for line in (str(error), error.hint or "."):
                    if not line.isprintable() or not 0 < len(line) <= 500:
                        yield f"{verb.__name__}: {line[:600]!r}"
            except Exception:
                yield f"{verb.__name__}: {traceback.format_exc()}"


def anything(dice: random.Random) -> Any:
    """Return a value that is rarely what is wanted."""
    return dice.choice(dice.choice([NUMBERS, TEXTS, THINGS]))


def some(dice: random.Random, *names: str) -> dict[str, Any]:
    """Return values for some of ``names``."""
    return {name: anything(dice) for name in names if dice.random() < 0.4}


def make(dice: random.Random) -> Any:
    """Make a mechanism."""
    kind = dice.choice(KINDS)
    return kind(**some(dice, *(field.name for field in fields(kind))))


def solve(dice: random.Random) -> None:
    """Solve a pose, or many, and read all of it."""
    kind = dice.choice(KINDS)
    mechanism = anything(dice) if dice.random() < 0.2 else kind()
    motion = vad.solve(mechanism, **some(dice, *kind.inputs, "speed"))
    motion.to_dict()
    if not motion.many:
        motion.table()


def ask(dice: random.Random) -> None:
    """Ask for a part of a motion."""
    part = getattr(dice.choice(MOTIONS), dice.choice(["link", "point", "slide"]))(anything(dice))
    assert part is not None


def draw(dice: random.Random) -> None:
    """Draw a sheet."""
    motion = anything(dice) if dice.random() < 0.2 else dice.choice(MOTIONS)
    vad.draw(motion, **some(dice, "panels", "language"))


def animate(dice: random.Random) -> None:
    """Make a lesson, or one step of it."""
    sheet = anything(dice) if dice.random() < 0.2 else SHEET
    lesson = vad.animate(sheet, **some(dice, "fps", "size", "speed", "style"))
    vad.still(anything(dice) if dice.random() < 0.2 else lesson, anything(dice))


def turn(dice: random.Random) -> None:
    """Make a film of a turn."""
    given = anything(dice) if dice.random() < 0.2 else dice.choice(MOTIONS)
    film = vad.turn(given, **some(dice, "fps", "size", "speed", "style", "panels", "language"))
    film.pose(0)


def multiples(dice: random.Random) -> None:
    """Draw a few poses."""
    given = anything(dice) if dice.random() < 0.2 else dice.choice(MOTIONS)
    places = anything(dice) if dice.random() < 0.5 else [anything(dice), anything(dice)]
    vad.multiples(given, places, **some(dice, "panels", "language"))


def save(dice: random.Random) -> None:
    """Save something, where there is a working folder for it."""
    poses = vad.multiples(vad.FourBar(), (30, 60))
    things = [SHEET, LESSON, vad.still(LESSON, 1), vad.turn(vad.FourBar()), poses]
    thing = anything(dice) if dice.random() < 0.2 else dice.choice(things)
    path = dice.choice([anything(dice), dice.choice(PATHS), "a.svg", Path("a.json"), "a.srt"])
    options = some(
        dice, "beside", "style", "size", "paper", "text", "progress", "subtitles", "blank"
    )
    if not isinstance(path, str) or "." in path:  # not a folder of a film's 2400 frames
        vad.save(thing, path, **options)


def read(dice: random.Random) -> None:
    """Read a sheet back."""
    vad.sheet_from_json(anything(dice))


VERBS: list[Callable[[random.Random], Any]] = [
    make,
    solve,
    ask,
    draw,
    animate,
    turn,
    multiples,
    save,
    read,
]
