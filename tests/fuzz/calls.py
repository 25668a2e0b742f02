"""Calls of Python that nobody should make: values of any type where another one is wanted.

A seed is a call; `fault` makes it, and says what it breaks.  Run as a program, this module tries so
many seeds from a first one::

    python -m tests.fuzz.calls 1000 0
"""

from __future__ import annotations

import array
import datetime
import itertools
import os
import random
import sys
import tempfile
import webbrowser
from collections import OrderedDict
from collections.abc import Callable
from contextlib import chdir
from dataclasses import fields
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType, SimpleNamespace
from typing import Any
from unittest.mock import patch

import numpy as np

import vad
from tests.fuzz.promise import broken
from vad.files.examples import example_names, example_path

#: The most seconds that a call may take.
LONGEST = 20.0


class Mute:
    """Cannot say what it is, be a number or an array."""

    def __repr__(self) -> str:
        raise RuntimeError("two\nlines")

    def __float__(self) -> float:
        raise ZeroDivisionError

    def __array__(self, *_: object, **__: object) -> object:
        raise ZeroDivisionError


def _rude(*names: str) -> type:
    """Return a class whose special methods of these names raise an error."""

    def method(*_: object, **__: object) -> Any:
        raise ZeroDivisionError("two\nlines")

    return type("Rude", (), {f"__{name}__": method for name in names})


_ASKED = ("repr", "str", "bool", "float", "int", "index", "array", "iter", "len", "eq", "hash")
_ASKED += ("getattr", "getitem", "contains", "fspath", "call", "lt", "abs", "complex", "format")


class Endless:
    """Yields numbers without an end."""

    def __iter__(self) -> Any:
        return itertools.count()


class EndlessPath:
    """A path that is no text."""

    def __fspath__(self) -> Any:
        return 60


class Wordy(str):
    """A text of a class of its own."""


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
    1e308,
    5e-324,
    2**64,
    complex("nan"),
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
    *(_rude(name)() for name in _ASKED),
    _rude(*_ASKED)(),
    _rude(*_ASKED),
    Endless(),
    EndlessPath(),
    itertools.count(),
    Wordy("velocity"),
    np.str_("velocity"),
    np.array(60.0),
    np.array([60.0]),
    np.array([60.0, 61.0]),
    np.array([None, 1.0]),
    np.array([1 + 2j]),
    np.array(["a", "b"]),
    np.arange(12.0).reshape(3, 4),
    np.zeros(3, dtype=[("a", float)]),
    np.datetime64("2024-02-29"),
    array.array("d", [60.0]),
    memoryview(b"60"),
    OrderedDict(angle=60),
    MappingProxyType({"C": "upper"}),
    SimpleNamespace(angle=60),
    {"P": ("coupler", 60.0)},
    {"P": ("coupler", np.array([1.0, 2.0]))},
    {"P": ["coupler", 1e308, 5e-324]},
    {"C": "upper"},
    {"A": (0, 0), "D": (100, 0)},
    {"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
    {"crank": {"angle": 60, "omega": 10}},
    {None: None},
    {"A": {"A": {}}},
    frozenset({"velocity"}),
    lambda *_: 1 / 0,
    NotImplemented,
    sys,
    Exception("two\nlines"),
    Path("a.svg"),
    Path("a.json"),
    os.devnull,
    *(example_path(name) for name in example_names()[:3]),
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
PRESS = vad.load(example_path("toggle-press"))
MECHANISMS = [kind() for kind in (*KINDS, PRESS)]
MOTIONS = [vad.solve(mechanism) for mechanism in MECHANISMS]
MOTIONS += [vad.solve(vad.FourBar(), angle=[60.0, 70.0]), vad.solve(vad.RSSR(), angle=[60.0])]
SHEET = vad.draw(MOTIONS[0])
LESSON = vad.animate(SHEET)
TURN = vad.turn(vad.FourBar())
STILL = vad.still(LESSON, 1)
MULTIPLES = vad.multiples(vad.FourBar(), (30, 60))
MADE = [SHEET, LESSON, TURN, STILL, MULTIPLES, SHEET.panels[0], *MECHANISMS, *MOTIONS]
FILE = example_path("four-bar").read_text("utf-8")
PICTURES = ("a.svg", "a.json", "a.srt", "a.vtt", "a.pdf", "a.html", "a.png", "a.tex", "a.mp4")


def case(seed: int) -> int:
    """Return the seed, which says which call is made."""
    return seed


def fault(seed: int, _: int = 0) -> str | None:
    """Make the call of a seed; return what it breaks, or None."""
    dice = random.Random(seed)
    verb = dice.choice(VERBS)
    work = tempfile.TemporaryDirectory()
    opened = patch.object(webbrowser, "open", lambda *_: True)
    served = patch("vad.showing._serve", lambda *_: None)
    with work as folder, chdir(folder), opened, served:
        found = broken(lambda: verb(dice), LONGEST)
        left = list(Path(folder).glob("**/.vad-*"))
    return found or (f"leaves {left}" if left else None)


def anything(dice: random.Random) -> Any:
    """Return a value that is rarely what is wanted."""
    value = dice.choice(dice.choice([NUMBERS, TEXTS, THINGS, THINGS, MADE]))
    if dice.random() < 0.1:
        value = dice.choice(
            ([value], (value, value), {"C": value}, {value: 1} if _hashes(value) else 0)
        )
    return (each for each in (value, "velocity")) if dice.random() < 0.02 else value


def _hashes(value: object) -> bool:
    try:
        hash(value)
    except Exception:
        return False
    return True


def some(dice: random.Random, *names: str) -> dict[str, Any]:
    """Return values for some of ``names``, mostly for one; whose function fails, that is his."""
    if dice.random() < 0.7:
        names = (dice.choice(names),) if names else ()
    found = {name: anything(dice) for name in names if dice.random() < 0.7}
    return {
        name: value for name, value in found.items() if name != "progress" or not callable(value)
    }


def one(dice: random.Random, usual: Any) -> Any:
    """Return what is wanted, or sometimes anything."""
    return anything(dice) if dice.random() < 0.2 else usual


def make(dice: random.Random) -> Any:
    """Make a mechanism, and solve it where it can be made."""
    kind = dice.choice((*KINDS, PRESS))
    vad.solve(kind(**some(dice, *(field.name for field in fields(kind))))).to_dict()


def solve(dice: random.Random) -> None:
    """Solve a pose, or many, and read all of it."""
    mechanism = dice.choice(MECHANISMS)
    motion = vad.solve(one(dice, mechanism), **some(dice, *mechanism.inputs))
    motion.to_dict()
    if not motion.many:
        motion.table()


def sweep(dice: random.Random) -> None:
    """Sweep a few results."""
    mechanism = dice.choice(MECHANISMS)
    letter = mechanism.letters[-1]
    results = one(dice, [f"{letter}.position", one(dice, f"{letter}.velocity")])
    vad.sweep(one(dice, mechanism), results, **some(dice, *mechanism.inputs))


def forces(dice: random.Random) -> None:
    """Find forces, and read all of them."""
    load = one(dice, some(dice, "at", "on", "force", "couple", "angle", "table", "unit", "name"))
    usual = {"at": dice.choice("ABC"), "on": "crank", "force": 3, "angle": 60}
    given = some(dice, "gravity", "friction", "masses") | {"loads": one(dice, [load, usual])}
    found = vad.forces(one(dice, dice.choice(MOTIONS)), **given)
    found.to_dict()
    if not found.many:
        found.table()
    found.flywheel(anything(dice), anything(dice))


def ask(dice: random.Random) -> None:
    """Ask for a part of a motion."""
    motion = dice.choice(MOTIONS)
    parts = ["link", "point", "slide"] + ["joint"] * hasattr(motion, "joint")
    part = getattr(motion, dice.choice(parts))(anything(dice))
    assert part is not None


def draw(dice: random.Random) -> None:
    """Draw a sheet."""
    motion = one(dice, dice.choice(MOTIONS))
    vad.draw(motion, **some(dice, "panels", "language"))


def animate(dice: random.Random) -> None:
    """Make a lesson, or one step of it."""
    given = some(dice, "fps", "size", "speed", "style", "loop")
    lesson = vad.animate(one(dice, SHEET), **given)
    vad.still(one(dice, lesson), anything(dice))


def still(dice: random.Random) -> None:
    """Take one step of a lesson."""
    vad.still(one(dice, LESSON), anything(dice))


def turn(dice: random.Random) -> None:
    """Make a film of a turn."""
    given = one(dice, dice.choice((*MOTIONS, *MECHANISMS)))
    film = vad.turn(given, **some(dice, "fps", "size", "speed", "style", "panels", "language"))
    film.pose(0)


def multiples(dice: random.Random) -> None:
    """Draw a few poses."""
    given = one(dice, dice.choice((*MOTIONS, *MECHANISMS)))
    places = anything(dice) if dice.random() < 0.5 else [anything(dice), anything(dice)]
    vad.multiples(given, places, **some(dice, "panels", "language"))


def save(dice: random.Random) -> None:
    """Save something, where there is a working folder for it."""
    thing = one(dice, dice.choice((SHEET, SHEET, LESSON, STILL, TURN, MULTIPLES)))
    path = dice.choice([anything(dice), dice.choice(PATHS), *PICTURES])
    names = ("beside", "style", "size", "paper", "text", "progress", "subtitles", "blank")
    names += ("standalone", "threads", "crf", dice.choice(("colour", "format", "x" * 300)))
    options = some(dice, *names)
    film = any(thing is each for each in (LESSON, TURN))
    if film and isinstance(path, str) and not path.endswith((".srt", ".vtt")):
        options["progress"] = _stop  # not a film's 2400 frames
    if not isinstance(path, str) or "." in path:
        vad.save(thing, path, **options)


def _stop(*_: object) -> None:
    raise vad.ExportError("enough of it")


def read(dice: random.Random) -> None:
    """Read a sheet back."""
    vad.sheet_from_json(anything(dice), **some(dice, "language"))


def load(dice: random.Random) -> None:
    """Load a mechanism from a file."""
    Path("lesson.toml").write_text(FILE, "utf-8")
    path = one(dice, anything(dice) if dice.random() < 0.8 else "lesson.toml")
    if not isinstance(path, int) or isinstance(path, bool):
        vad.load(path)


def tables(dice: random.Random) -> None:
    """Make a mechanism from tables."""
    given: dict[str, Any] = {
        "fixed": {"A": (0, 0), "D": (100, one(dice, 0))},
        "links": {"crank": {"AB": one(dice, 40)}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
        "driver": {"crank": {"angle": one(dice, 60), "omega": one(dice, 10)}},
    }
    others = ("guides", "assembly", "dimensions", "pose", "title", "unit", "about", "source")
    kind = vad.mechanism(
        **(given | some(dice, dice.choice((*given, *others)), dice.choice(others)))
    )
    vad.solve(kind()).to_dict()


def show(dice: random.Random) -> None:
    """Show something."""
    if dice.random() < 0.5:
        vad.widget(one(dice, dice.choice((*MECHANISMS, *MOTIONS))), **some(dice, "panels", "style"))
    else:
        vad.show(one(dice, dice.choice((SHEET, STILL, MULTIPLES, vad.FourBar()))))


def batch(dice: random.Random) -> None:
    """Make a sheet."""
    text = '[sheet]\nmechanism = "four-bar"\nfiles = ["key.json"]\ncount = 1\n'
    Path("sheets.toml").write_text(text, "utf-8")
    given = some(dice, dice.choice(("jobs", "cluster", "only", "progress")))
    jobs = given.get("jobs")
    if given.get("cluster") is None and not (isinstance(jobs, int) and 1 < jobs < 1000):
        vad.batch(one(dice, "sheets.toml"), one(dice, "sheets"), **given)


def name(dice: random.Random) -> None:
    """Look for a mechanism, or for a name of the package."""
    value = anything(dice)
    if _hashes(value) and value not in vad.MECHANISMS and isinstance(value, str):
        assert not hasattr(vad, value or "x")


VERBS: list[Callable[[random.Random], Any]] = [
    *(make, make, solve, solve, sweep, sweep, ask, draw, draw, animate, still, turn, multiples),
    *(save, save, save, read, load, tables, tables, show, batch, name, forces, forces),
]

if __name__ == "__main__":
    from tests.fuzz.promise import run

    run(case, fault, *map(int, sys.argv[1:]))
