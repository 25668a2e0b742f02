"""Command lines that nobody should type: exit code 0, 1 or 2, and one line with perhaps a hint.

A seed is the words of one command line.
"""

from __future__ import annotations

import io
import random
import tempfile
from collections.abc import Sequence
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path

from tests.fuzz.promise import broken
from vad.cli.run import run
from vad.files.examples import example_names
from vad.mechanisms import MECHANISMS

#: The most seconds that a command may take; what is written is soon written.
LONGEST = 30.0

VERBS = ["solve", "draw", "animate", "sweep", "compare", "list", "check", "example", "sovle", ""]
OPTIONS = [
    *("--ground", "--crank", "--coupler", "--rod", "--ram-height", "--offset", "--link"),
    *("--angle", "--omega", "--alpha", "--position", "--ground-angle", "--assembly", "--point"),
    *("--length-unit", "--panels", "--style", "--language", "--size", "--paper", "--fps"),
    *("--blank", "--at", "--over", "--columns", "--text"),
    *("--speed", "--still", "--steps", "--from", "--to", "--crnak", "--o", "-x", "-crank", "--"),
]
FLAGS = ["--json", "--subtitles", "--help", "-h", "--turn", "--json=1", "-"]
VALUES = [
    *("60", "0", "-1", "-4e-05", "1e400", "1e-320", "nan", "inf", "6 cm", "120 rpm", "6kg", "٣"),
    *("1e-9", "1e9", "5e151", "1e-150", "1e150", "1e200", "60 nan", "1 inf", "1e308 cm", "2/0"),
    *("", " ", "open", "crossed", "paper", "chalk", "de", "A4", "ft", "velocity", "velocity:2"),
    *("30,60", "position,velocity", ",", "640x360", "0x0", "1e5x3", "two\nlines", "\x1b[31m"),
    *("C on coupler 60", "P on coupler 1e300 at nan", "99999x99999", "16x16", "1000000000"),
    *("[red]x[/nope]", "%s{0}", "9" * 6000, "x" * 130_000, "--", "--json", "NaN deg", "\udc80"),
]
FILES = [
    *("a.json", "a.svg", "a.csv", "a.srt", "a.vtt", "a.xyz", "a", "/", ".", "..", "", "="),
    *("no/such/a.svg", "x" * 300 + ".srt", "two\nlines.srt", "\udc80.json", "[/b].csv", "\0.svg"),
]


def line(dice: random.Random) -> list[str]:
    """Return the words of one command line; what is written is soon written."""
    names = [*MECHANISMS, *example_names(), "four-bar", "fuor-bar", "press.toml"]
    words = [dice.choice(VERBS), dice.choice(names)]
    for _ in range(dice.randrange(4)):
        words += [dice.choice(OPTIONS), dice.choice(VALUES)]
    if dice.random() < 0.2:
        words.append(dice.choice(FLAGS))
    if dice.random() < 0.9:
        words += ["-o", dice.choice(FILES)]
    if dice.random() < 0.2:
        dice.shuffle(words)
    folder_of_frames = "animate" in words and words[-1] in ("a", ".", "..", "/")
    return words[:-2] if folder_of_frames else words


def case(seed: int) -> list[str]:
    """Return the words of one command line."""
    return line(random.Random(seed))


def fault(words: Sequence[str], _: int = 0) -> str | None:
    """Carry out a command line; return what it breaks, or None."""
    out, err = io.TextIOWrapper(io.BytesIO(), "utf-8", "backslashreplace"), io.StringIO()
    codes: list[int] = []
    with tempfile.TemporaryDirectory() as folder, chdir(folder):
        with redirect_stdout(out), redirect_stderr(err):
            broke = broken(lambda: codes.append(run(words)), LONGEST)
        left = list(Path(folder).rglob(".vad-*"))
    said = err.getvalue()
    lines = said.splitlines()
    starts = [each.partition(" ")[0] for each in lines]
    if broke:
        return broke
    if left:
        return f"leaves {left}"
    if codes[0] not in (0, 1, 2) or "internal fault" in said:
        return f"code {codes[0]}: {said[-600:]}"
    if starts not in ([[]] if codes[0] == 0 else [["error:"], ["error:", "hint:"]]):
        return f"code {codes[0]} with other lines than promised: {said[-600:]}"
    if not all(len(each) < 520 and each.isprintable() for each in lines):
        return f"is no line: {said[-600:]!r}"
    return None
