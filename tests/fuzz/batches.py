"""Files of batches that nobody should write; of what can be made, two sheets are made."""

from __future__ import annotations

import random
import re
import tempfile
from collections.abc import Callable
from pathlib import Path

import vad
from tests.fuzz import files
from tests.fuzz.promise import broken

#: The most seconds that two sheets may take.
LONGEST = 30.0

HEADS = (
    '[sheet]\nmechanism = "four-bar"\ncount = 2\nfiles = ["key.json"]\n',
    '[sheet]\nmechanism = "press.toml"\ncount = 2\nseed = 3\nfiles = ["problem.svg", "key.json"]\n'
    'blank = ["velocity"]\n',
    '[sheet]\nmechanism = "slider-crank"\ncount = 2\nfiles = ["key.svg"]\npaper = "A4"\n'
    'title = "x"\nlanguage = "de"\n',
)
VARIES = (
    "[vary]\ncrank = { share = 0.25 }\nangle = { from = 0, to = 355, step = 5 }\n",
    '[vary]\ncrank = { from = 30, to = 50 }\nomega = ["60 rpm", "90 rpm"]\n[keep]\nsine = 0.3\n',
    '[vary]\nangle = [10, 20, 30]\nassembly = ["open", "crossed"]\n',
)
TABLES = (
    "mechanism,crank,angle\nfour-bar,40,60\nfour-bar,41,61\n",
    "mechanism;crank;omega\nslider-crank;40,5;60 rpm\nslider-crank;41;3\n",
)
PRESS = files.EXAMPLES[0]


def case(seed: int) -> tuple[str, str]:
    """Return the name of a file and its text."""
    dice = random.Random(seed)
    table = dice.random() < 0.25
    text = dice.choice(TABLES) if table else dice.choice(HEADS) + dice.choice(VARIES)
    for _ in range(dice.choice((1, 1, 2, 3, 6))):
        text = dice.choice(MUTATIONS)(text, dice)
    return ("sheets.csv" if table else "sheets.toml"), text


def _value(text: str, dice: random.Random) -> str:
    """Put another value for one of the text."""
    found = list(re.finditer(r'"[^"\n]*"|-?\d+(?:\.\d+)?|\w+', text))
    if not found:
        return text
    here = dice.choice(found)
    value = dice.choice((*files.NUMBERS, *files.WORDS, "100000", '["a.png"]', '"../a.svg"', "1e9"))
    return text[: here.start()] + value + text[here.end() :]


def _letter(text: str, dice: random.Random) -> str:
    at = dice.randrange(len(text) + 1)
    return text[:at] + dice.choice(files.LETTERS) + text[at + dice.randrange(3) :]


def _lines(text: str, dice: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    at = dice.randrange(len(lines) + 1)
    lines[at : at + dice.randrange(2)] = [dice.choice((*lines, "x = 3\n", ",,\n", "\n", "[x]\n"))]
    return "".join(lines)


MUTATIONS: tuple[Callable[[str, random.Random], str], ...] = (
    _value,
    _value,
    _value,
    _letter,
    _lines,
)


class _EnoughError(vad.VadError):
    """Two sheets are enough."""


def fault(named: tuple[str, str], _: int = 0) -> str | None:
    """Make two sheets of a file; return what it breaks, or None."""
    name, text = named

    def enough(done: int, *_: object) -> None:
        if done >= 2:
            raise _EnoughError("enough of it")

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_bytes(text.encode("utf-8", "surrogatepass"))
        (Path(folder) / "press.toml").write_text(PRESS, "utf-8")
        found = broken(lambda: vad.batch(path, Path(folder) / "out", progress=enough), LONGEST)
        left = list(Path(folder).rglob(".vad-*"))
    return found or (f"leaves {left}" if left else None)
