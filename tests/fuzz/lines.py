"""Command lines that nobody should type: verbs, mechanisms, options and values at random.

A seed is a line of words; most of them nearly make sense.  `fault` carries them out in this process
and says what they break: an exit code is 0, 1 or 2, and where it is not 0 there is one line about
it, perhaps with a hint.  Films end after their first picture, and no browser is started.  Run as a
program, this module tries so many seeds from a first one::

    python -m tests.fuzz.lines 1000 0
"""

from __future__ import annotations

import io
import os
import random
import sys
import tempfile
from collections.abc import Sequence
from contextlib import chdir, redirect_stderr, redirect_stdout
from functools import cache
from pathlib import Path
from unittest.mock import patch

import click

from tests.fuzz.promise import broken
from vad.cli import output, verbs
from vad.cli.app import app
from vad.cli.completion import VARIABLE
from vad.cli.design import DesignGroup
from vad.cli.groups import MechanismGroup
from vad.cli.main import answer
from vad.cli.run import run
from vad.errors import ExportError
from vad.files.examples import example_path
from vad.mechanisms import MECHANISMS

#: The most seconds that a line may take.
LONGEST = 60.0
#: The longest line of text that is printed about an error.
_WIDEST = 520

DRAWING = ["solve", "draw", "animate", "sweep", "compare", "gui"]
OTHERS = [
    *(
        "list",
        "example",
        "check",
        "batch",
        "quiz",
        "design",
        "design",
        "exercise",
        "sovle",
        "",
        "-h",
    ),
    *("--version", "--completion"),
]
TASKS = DesignGroup().list_commands(click.Context(app))
NAMES = [
    *("fuor-bar", "press.toml", "press.toml", "press.toml", "no.toml", "bad.toml", "watt-1", ""),
    *("four-bar.toml", "sheets.toml", "/", "\udc80", "x" * 300, "FOUR-BAR"),
]
OPTIONS = [
    "--crnak",
    "--o",
    "-x",
    "-crank",
    "--",
    "-",
    "--help",
    "-h",
    "--json=1",
    "-o",
    "--=",
    "-o=",
]
VALUES = [
    *("60", "0", "-1", "-4e-05", "1e400", "1e-320", "nan", "inf", "6 cm", "120 rpm", "6kg", "٣"),
    *("", " ", "open", "crossed", "paper", "chalk", "de", "A4", "ft", "velocity", "velocity:2"),
    *("30,60", "position,velocity", ",", "320x240", "0x0", "1e5x3", "two\nlines", "\x1b[31m"),
    *("[red]x[/nope]", "%s{0}", "9" * 6000, "x" * 130_000, "--", "--json", "NaN deg", "1/0"),
    *("D on rod 30", "D on rod 30 at 9e9", "D on", "B=left", "B=", "=left", "parallel", "a3"),
    *("1", "2", "3", "7", "12", "361", "-90", "180", "1e150", "1e-150", "1e308", "0.5 turn"),
    *("80 N @ 150 at C", "-6 N m on rod", "P = 2 kN at B on crank", "rod 2 kg at C", "slider 0.1"),
    *("80 N @ nan at C", "@ at on", "rod 1e400", "9.81,", "0,-9.81", "crank 0.01 kg m^2"),
    *("x^1.5", "x^x^x", "1/(x-1)", "1 4", "40 70, 60 82, 80 97", "0 0, 60 0", "1.2", "0.5", "1e9"),
    *("0 0 0, 60 30 20, 90 80 55", "0 0 0, 0 0 0, 0 0 0", "30 120", "sin(", "__import__('os')"),
    *("0,90,180", "30,", "1,2,3,4,5,6,7", "60 nan", "mm", "nan", "bash", "zsh", "\udc80", "\0"),
]
#: Numbers that are often possible.
USUAL = ["60", "45", "90", "120", "30", "200", "80.5", "10", "1", "2", "3", "-20", "6 cm"]
#: What a verb can write, and what no verb can.
WRITTEN = {
    "draw": ("a.json", "a.svg", "a.html", "a.pdf"),
    "animate": ("a.srt", "a.vtt", "a.gif", "a.html", "a.svg"),
    "sweep": ("a.csv", "a.csv", "a.csv", "a.png"),
    "batch": ("out", "out/"),
    "quiz": ("a.xml", "a.gift", "a.md", "a.zip"),
    "design": ("a.toml", "a.json", "a.svg"),
}
FILES = [
    *("a.json", "a.svg", "a.csv", "a.png", "a.pdf", "a.html", "a.srt", "a.vtt", "a.mp4", "a.gif"),
    *("a.xyz", "a", "/", ".", "..", "", "=", "no/such/a.svg", "x" * 300 + ".srt", "a/", "out/"),
    *("two\nlines.srt", "\udc80.json", "[/b].csv", "\0.svg", "press.toml", "A.SVG", "a.svg/b.svg"),
]
SHEETS = '[sheet]\nmechanism = "four-bar"\nfiles = ["key.json"]\ncount = 2\n[vary]\ncrank = [40]\n'


def case(seed: int) -> list[str]:
    """Return the words of a line."""
    dice = random.Random(seed)
    verb = dice.choice(DRAWING if dice.random() < 0.75 else OTHERS)
    name = dice.choice(list(MECHANISMS) if dice.random() < 0.75 else NAMES)
    words = [verb]
    if verb == "design":
        name = dice.choice([*TASKS, *TASKS, "four-bar", "desgin", ""])
        words.append(name)
    elif verb in ("batch", "quiz"):
        words.append(dice.choice(("sheets.toml", "sheets.toml", "press.toml", "sheets.csv", name)))
    elif verb == "check":
        words.append(dice.choice(("press.toml", "bad.toml", name)))
    elif verb in DRAWING or dice.random() < 0.3:
        words.append(name)
    known = _options(verb, name)
    for _ in range(dice.choice((0, 1, 1, 2, 2, 3, 5))):
        if known and dice.random() < 0.9:
            words += _given(*dice.choice(list(known.items())), dice)
        else:
            words += dice.choice([[dice.choice(_every_option()), dice.choice(VALUES)], OPTIONS[:1]])
    if verb in WRITTEN or dice.random() < 0.05:
        files = WRITTEN[verb] if verb in WRITTEN and dice.random() < 0.8 else FILES
        words += ["-o", dice.choice(files)]
    if dice.random() < 0.1:
        dice.shuffle(words)
    return words if dice.random() < 0.95 else words[: dice.randrange(len(words) + 1)]


def _given(option: str, known: click.Parameter, dice: random.Random) -> list[str]:
    """Return an option with a value that it may take, or with a strange one."""
    flag = getattr(known, "is_flag", False)
    if dice.random() < 0.05:
        flag = not flag
    if flag:
        return [option]
    several = list(getattr(known, "names", ())) or USUAL
    value = dice.choice(several if dice.random() < 0.9 else VALUES)
    return [f"{option}={value}"] if dice.random() < 0.1 else [option, value]


@cache
def _options(verb: str, name: str) -> dict[str, click.Parameter]:
    """Return the options of a verb for a mechanism."""
    command = app.all_commands().get(verb)
    if isinstance(command, MechanismGroup):
        kind = name if name in MECHANISMS else "four-bar"
        command = command.get_command(click.Context(app), kind)
    if isinstance(command, DesignGroup):
        task = name if name in TASKS else TASKS[0]
        command = command.get_command(click.Context(app), task)
    params = getattr(command, "params", ())
    return {option: each for each in params for option in each.opts if option.startswith("-")}


@cache
def _every_option() -> list[str]:
    """Return all options of all verbs, and some that are none."""
    verbs = app.all_commands()
    of_verbs = {option for verb in verbs for name in MECHANISMS for option in _options(verb, name)}
    return sorted(of_verbs) + OPTIONS


def fault(words: Sequence[str], seed: int = 0) -> str | None:
    """Carry out a line; return what it breaks, or None."""
    out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", errors="replace")
    err = io.StringIO()
    asked = random.Random(seed).random() < 0.1
    with (
        tempfile.TemporaryDirectory() as folder,
        chdir(folder),
        patch.dict(os.environ, {"VAD_DEBUG": "1", "TMPDIR": folder}),
        patch("vad.gui.visit._visit", lambda *_: None),
        patch.object(output, "check_interrupt", _stop),
        patch.object(verbs, "wait_for_signal", lambda: None),
    ):
        Path("press.toml").write_text(example_path("toggle-press").read_text("utf-8"), "utf-8")
        Path("bad.toml").write_text("[links]\ncrank = 3\n", "utf-8")
        Path("sheets.toml").write_text(SHEETS, "utf-8")
        Path("sheets.csv").write_text("mechanism,files\nfour-bar,key.json\n", "utf-8")
        with redirect_stdout(out), redirect_stderr(err):
            found = broken(lambda: (_completed if asked else _carried_out)(words, err), LONGEST)
        left = [each.name for each in Path(folder).rglob(".vad-*")]
    return found or (f"leaves {left}" if left else None)


def _carried_out(words: Sequence[str], err: io.StringIO) -> None:
    code = run(words)
    lines = err.getvalue().splitlines()
    if code not in (0, 1, 2):
        raise AssertionError(f"exit code {code}")
    begun = [line.partition(" ")[0] for line in lines]
    if code and begun not in (["error:"], ["error:", "hint:"]) and "batch" not in words:
        raise AssertionError(f"says {lines}")
    if not code and set(begun) - {"note:", "hint:"}:
        raise AssertionError(f"says {lines}")
    for line in lines:
        if len(line) > _WIDEST or not line.isprintable():
            raise AssertionError(f"is no line: {line[:600]!r}")


def _completed(words: Sequence[str], _: io.StringIO) -> None:
    """Let a shell ask how the last of the words may go on."""
    line = " ".join(word for word in words if "\0" not in word)[:9000]
    asked = {VARIABLE: "", "COMP_WORDS": f"vad {line}", "COMP_CWORD": str(len(line.split()))}
    with patch.dict(os.environ, {name: os.fsdecode(os.fsencode(x)) for name, x in asked.items()}):
        answer("bash_complete")


def _stop() -> None:
    raise ExportError("enough of it")


if __name__ == "__main__":
    from tests.fuzz.promise import run as tried

    tried(case, fault, *map(int, sys.argv[1:]))
