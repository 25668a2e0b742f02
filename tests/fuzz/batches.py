"""Files of sheets that nobody should write: mutated tables of a class, in TOML and in CSV.

A seed is a file with its name; `fault` makes its sheets, and says what that breaks.  What was made
lies in the folder and nowhere else, under names that any system can have, and is not made again.
Run as a program, this module tries so many seeds from a first one::

    python -m tests.fuzz.batches 1000 0
"""

from __future__ import annotations

import csv
import io
import os
import random
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from unicodedata import normalize
from unittest.mock import patch

import vad
from tests.fuzz.promise import broken
from vad.batches import making
from vad.files.examples import example_path

#: The most seconds that a file may take.
LONGEST = 20.0
#: In a try so many numbers are drawn before the program gives up, and so many sheets are made.
TRIES, MOST = 20, 12
#: What no file's name may hold on some system.  Names of devices are harmless behind a number.
FORBIDDEN = set('<>:"/\\|?*')


@dataclass(frozen=True)
class Case:
    """A file of sheets: its name and its bytes."""

    name: str
    content: bytes


TOML = (
    '[sheet]\nmechanism = "four-bar"\ncount = 2\nseed = 7\nfiles = ["key.json"]\n[vary]\n'
    "crank = { share = 0.25 }\nangle = { from = 0, to = 355, step = 5 }\n[keep]\nsine = 0.3\n",
    '[sheet]\nmechanism = "press.toml"\nfiles = ["problem.svg", "key.svg"]\nblank = "velocity"\n'
    '[vary]\ncrank = [170, "18 cm"]\nangle = 45\nassembly = ["B=right", { D = "right" }]\n',
    '[sheet]\nmechanism = "slider-crank"\nfiles = ["a.json", "film.srt"]\nfps = 5\nspeed = 8.5\n'
    'panels = ["velocity"]\nstyle = "print"\nlanguage = "de"\nlength_unit = "cm"\npaper = "A3"\n'
    '[sheet.points]\nE = ["rod", 30.0, 90.0]\n[vary]\nomega = ["60 rpm", 5]\nrod = [140]\n',
    '[sheet]\nmechanism = "double-slider"\nfiles = ["key.json"]\n[vary]\nlink = [900, 2e3]\n',
)
CSV = (
    "mechanism,crank,coupler,angle,omega,files,count\n"
    "four-bar,40,120,60,120 rpm,key.json,1\nfour-bar,130,120,0,,key.json,2\n",
    "mechanism;rod;offset;language;style;files\nslider-crank;140;2 cm;de;chalk;a.json b.json\n"
    "slider-crank;150;;;;c.svg\n",
    'mechanism,crank,files,size,fps,panels\npress.toml,"170",key.json,320x240,12.5,"velocity"\n'
    "scotch-yoke,50,key.json,,,\n",
)
CELLS = (
    *("", " ", "0", "-1", "1", "2", "60", "1e308", "1e-320", "nan", "inf", "1e400", "9" * 5000),
    *("9" * 140_000, "6 cm", "120 rpm", "6 kg", "٣", "four-bar", "press.toml", "../press.toml"),
    *("/etc/passwd.toml", "no.toml", "NUL", "key.json", "../key.json", "a/b.json", "a\\b.json"),
    *("CON.json", "key.json:x.json", "KEY.JSON", "Key.json", "k\u0130.json", "ki\u0307.json"),
    *("e\u0301.json", "\u00e9.json", ".key.json", "key.json ", "key .json", "k*?.json", "k|.json"),
    *("x" * 300 + ".json", "é" * 120 + ".json", "key", "key.xyz", "problem.mp4", "problem.json"),
    *("velocity", "velocity position", "de", "xx", "paper", "A4", "320x240", "0x0", "99999999"),
    *("=1+1", "@x", "'", '"', '""', "a,b", "a;b", "a\tb", "two\nlines", "two\rlines", "\x1b[31m"),
    *(
        "\ufeff",
        "\u2028",
        "\x85",
        "\u202e",
        "👩\u200d🔧",
        "True",
        "open",
        "B=left",
        "D=right B=left",
    ),
)
HEADS = (
    *("mechanism", "crank", "rod", "angle", "omega", "count", "files", "blank", "size", "seed"),
    *("length_unit", "assembly", "points", "title", "number", "", " ", "crnak", "Crank", "x" * 300),
    *("standalone", "text", "threads", "crank ", "\ufeffmechanism", "from", "share", "style"),
)
VALUES = (
    *("0", "-1", "1.5", "60", "nan", "inf", "-inf", "1e308", "1e-320", "9" * 400, "9" * 5000),
    *("true", "[]", "{}", '""', '" "', "[[1, 2], [3]]", "[1, 'x', true]", "1979-05-27", "0x10"),
    *("{ share = 0.25 }", "{ share = 2 }", "{ share = nan }", "{ from = 0, to = 1e9, step = 1 }"),
    *("{ from = 1, to = 1e300 }", "{ from = 5, to = 1 }", "{ from = 1e-300, to = 1e300 }"),
    *("{ from = -1, to = 1 }", "{ from = 0, to = 360, step = 1e-320 }", "{ from = 1 }"),
    *("{ from = 1, to = 9, step = -1 }", "{ from = '1 cm', to = '3 cm', step = '5 mm' }"),
    *("100000", "100001", "4", "{ E = ['rod', 30] }", "{ E = 3 }", "[320, 240]", "[1e9, 1e9]"),
    *('"open"', '"crossed"', '["open", "crossed"]', '{ B = "left" }', '"B=left"', '["B=x"]'),
)
WORDS = (
    *("mechanism", "count", "seed", "files", "blank", "panels", "language", "style", "paper"),
    *("fps", "size", "speed", "length_unit", "points", "crank", "rod", "angle", "omega", "share"),
    *("assembly", "sine", "title", "standalone", "text", "threads", "x", '"µ"', '"two words"'),
)
LINES = (
    *("[sheet]", "[vary]", "[keep]", "[other]", "[sheet.points]", "[[vary]]", "sine = 0.999", "x"),
    *("[fixed]", "[links]", "sine = 0", "sine = 1", "# \u2028 \x85", "\ufeff", "[vary.crank]"),
)


def case(seed: int) -> Case:
    """Return the file of a seed."""
    dice = random.Random(seed)
    if dice.random() < 0.5:
        text, name = dice.choice(TOML), "sheets.toml"
        for _ in range(dice.choice((1, 1, 2, 2, 3, 5))):
            text = dice.choice(OF_TOML)(text, dice)
    else:
        text, name = _table(dice), "sheets.csv"
    return Case(name, _encoded(text, dice))


def _table(dice: random.Random) -> str:
    """Return a table with odd cells, names, delimiters and ends of lines."""
    text = dice.choice(CSV)
    delimiter = ";" if text.partition("\n")[0].count(";") else ","
    rows = list(csv.reader(io.StringIO(text), delimiter=delimiter))
    for _ in range(dice.choice((0, 1, 1, 2, 3, 5))):
        dice.choice(OF_TABLES)(rows, dice)
    if len(rows) > 50 and any(len(cell) > 1000 for row in rows for cell in row):
        del rows[50:]
    table, end = io.StringIO(), dice.choice(("\n", "\n", "\r\n", "\r"))
    quoting = dice.choice((csv.QUOTE_MINIMAL, csv.QUOTE_MINIMAL, csv.QUOTE_ALL))
    other = dice.choice((delimiter, delimiter, delimiter, ",", ";", "\t"))
    csv.writer(table, delimiter=other, lineterminator=end, quoting=quoting).writerows(rows)
    return _sign(table.getvalue(), dice) if dice.random() < 0.1 else table.getvalue()


def _cell(rows: list[list[str]], dice: random.Random) -> None:
    row = dice.choice(rows)
    if row:
        row[dice.randrange(len(row))] = dice.choice(HEADS if row is rows[0] else CELLS)


def _column(rows: list[list[str]], dice: random.Random) -> None:
    head = dice.choice((*HEADS, *rows[0])) if rows[0] else "mechanism"
    for row in rows:
        row.append(head if row is rows[0] else dice.choice(CELLS))


def _shorter(rows: list[list[str]], dice: random.Random) -> None:
    row = dice.choice(rows)
    del row[dice.randrange(len(row) + 1) :]


def _longer(rows: list[list[str]], dice: random.Random) -> None:
    dice.choice(rows).extend(["", "", "x"][: dice.randrange(4)])


def _again(rows: list[list[str]], dice: random.Random) -> None:
    rows.append(list(dice.choice(rows)))


def _many(rows: list[list[str]], dice: random.Random) -> None:
    """Ask for more sheets than anybody wants: the last row again and again."""
    rows.extend([list(rows[-1])] * dice.choice((5, 5, 5, 2000)))


def _lost(rows: list[list[str]], dice: random.Random) -> None:
    rows[:] = rows[: dice.randrange(len(rows)) + 1]


OF_TABLES: tuple[Callable[[list[list[str]], random.Random], None], ...] = (
    *(_cell, _cell, _cell, _cell, _column, _shorter, _longer, _again, _again, _lost, _many),
)


def _value(text: str, dice: random.Random) -> str:
    """Put another value behind a word."""
    lines = text.split("\n")
    places = [place for place, line in enumerate(lines) if "=" in line]
    if places:
        place = dice.choice(places)
        word, _, old = lines[place].partition("=")
        name = f'"{_escaped(dice.choice(CELLS[20:]))}"'
        new = dice.choice((dice.choice(VALUES), name, f"[{name}, {name.upper()}]", old))
        lines[place] = f"{dice.choice((word, word, word, dice.choice(WORDS)))} = {new}"
    return "\n".join(lines)


def _escaped(cell: str) -> str:
    """Return a cell as it stands between quotation marks."""
    signs = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\x1b": "\\u001b"}
    return "".join(signs.get(sign, sign) for sign in cell)


def _line(text: str, dice: random.Random) -> str:
    """Add a line, leave one out, or move one."""
    lines = text.split("\n")
    kind = dice.randrange(3)
    line = lines.pop(dice.randrange(len(lines))) if kind else dice.choice(LINES)
    if kind != 1:
        new = f"{dice.choice(WORDS)} = {dice.choice(VALUES)}"
        lines.insert(dice.randrange(len(lines) + 1), dice.choice((line, line, new)))
    return "\n".join(lines)


def _sign(text: str, dice: random.Random) -> str:
    """Replace, add or leave out one character."""
    place = dice.randrange(len(text) + 1)
    sign = dice.choice(("", *"{}[]\"'=,;#.\t\r\n\0\x85\u2028\ufeff\u202e0123456789eA"))
    return text[:place] + sign + text[place + dice.randrange(2) :]


OF_TOML: tuple[Callable[[str, random.Random], str], ...] = (_value, _value, _value, _line, _sign)


def _encoded(text: str, dice: random.Random) -> bytes:
    """Return a text as bytes, mostly as it should be."""
    kind = dice.choice(("utf-8",) * 20 + ("utf-8-sig", "utf-16", "latin-1", "cp1252"))
    content = text.encode(kind, "replace")
    if dice.random() < 0.03:
        place = dice.randrange(len(content) + 1)
        content = content[:place] + bytes([dice.randrange(256)]) + content[place + 1 :]
    return content


def fault(case: Case, _: int = 0) -> str | None:
    """Make the sheets of a file; return what that breaks, or None."""
    with tempfile.TemporaryDirectory() as home:
        place = Path(home, "class")
        place.mkdir()
        (place / "press.toml").write_text(example_path("toggle-press").read_text("utf-8"), "utf-8")
        (place / case.name).write_bytes(case.content)
        before = {*place.parent.rglob("*")}
        with patch.object(making, "TRIES", TRIES), patch.dict(os.environ, {"TMPDIR": home}):
            found = broken(lambda: _made(place, case.name), LONGEST)
        inside = {each for each in place.parent.rglob("*") if (place / "out") in each.parents}
        strange = {*place.parent.rglob("*")} - before - inside - {place / "out"}
        hidden = [each.name for each in inside if each.name.startswith(".vad-")]
    if strange or hidden:
        return found or f"leaves {sorted(map(str, strange))} {hidden}"
    return found


def _made(place: Path, name: str) -> None:
    """Make the sheets twice, and look at what there is."""
    out = place / "out"

    def stop(done: int, total: int) -> None:
        if done >= MOST:
            raise vad.ExportError("enough of it")

    made = vad.batch(place / name, out, progress=stop)
    files = [path for each in made for path in each.files]
    for path in files:
        if path.parent != out or not path.is_file():
            raise AssertionError(f"says that it made {path}")
        if FORBIDDEN & set(path.name) or path.name[-1] in " ." or len(path.name.encode()) > 250:
            raise AssertionError(f"the name {path.name!r} is not one for every system")
    same = {normalize("NFC", normalize("NFC", path.name).casefold()) for path in files}
    if len(same) < len(files):
        raise AssertionError("two files have one name where cases are not told apart")
    for each in made:
        for line in (str(each.error), str(getattr(each.error, "hint", None) or ".")):
            if not line.isprintable() or len(line) > 500:
                raise AssertionError(f"is no line: {line[:600]!r}")
        if each.error is not None and "internal fault" in str(each.error):
            raise AssertionError(str(each.error))
    if [each.number for each in made] != list(range(1, len(made) + 1)):
        raise AssertionError("numbers are left out")
    for each in vad.batch(place / name, out, progress=stop):
        if each.new and each.error is None:
            raise AssertionError(f"makes sheet {each.number} again")


if __name__ == "__main__":
    from tests.fuzz.promise import run

    run(case, fault, *map(int, sys.argv[1:]))
