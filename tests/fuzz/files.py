"""Files of mechanisms that nobody should write: mutated examples, loaded, checked and drawn.

`case` makes a text from a seed, always the same one.  `fault` says what one text breaks: every
fault but a `VadError` of one line, every warning, and every text that takes longer than `LONGEST`
seconds.  Run as a program, this module tries so many seeds from a first one::

    python -m tests.fuzz.files 1000 0
"""

from __future__ import annotations

import random
import re
import sys
from collections.abc import Callable
from contextlib import suppress

import vad
from tests.fuzz.promise import broken
from vad.files.examination import examine
from vad.files.examples import example_names, example_path
from vad.files.loading import WrittenMechanism, class_of
from vad.files.tables import read_text
from vad.plan.board import plan
from vad.plan.format import screen
from vad.style import load_style

#: The most seconds of the processor that a file may take from its text to the plan of its page.
LONGEST = 20.0

#: The share of the files that are examined, of the mechanisms of which several poses are solved at
#: once, and of the poses whose page is planned.  Each of these costs more than all the rest, which
#: is tried with every file; so four times as many files are tried.
EXAMINED, SEVERAL, PLANNED = 0.5, 0.25, 0.1

EXAMPLES = tuple(example_path(name).read_text("utf-8") for name in example_names())
NUMBERS = (
    *("0", "-0.0", "1", "-1", "90", "180", "360", "1e-12", "1e12", "1e-150", "1e150", "1e-199"),
    *("1e199", "1e-300", "1e300", "1e308", "5e-324", "nan", "inf", "-inf", "0x10", "1_000", "1e61"),
    *("9" * 400, "9" * 5000, "-" + "7" * 4301, "true", "false", "1979-05-27", "07:32:00", "٣"),
    *('"6 cm"', '"60 nan"', '"nan"', '"inf"', '"1e400 cm"', '"60 µm"', '"120 rpm"', '"2/0"'),
    *('"crank/2"', '"2^0.5"', '"9**9**9"', '"sqrt(-1)"', '"(" * 99', '"µ"', '"ﬁx"', '"1 kg"'),
    *('"side"', '"hypot(3, 4)"', '"1e-5 m"', '"-4"', '"variable"', '""', '" "', "{}", "[]"),
)
WORDS = (
    *("upper", "lower", "left", "right", "parallel", "variable", "clockwise", "AB", "BC", "DC"),
    *("O2A", "ABC", "A", "Q", "crank", "slider", "block", "mm", "ft", "m", "kg", "µm", "x" * 300),
    *("D٣", "É", "µ", "ﬁx", "👩\u200d🔧", "a\u0301", "\u2028", "\x85", "", " ", "1", "nan"),
)
LINES = (
    *("[links]", "[guides]", "[dimensions]", "[pose]", "[assembly]", "[fixed]", "[driver]"),
    *("[links.crank]", "[links.rod]\nBC = 90", "[[links]]", "[x]", "[driver.crank]\nangle = 3"),
    *("a = 3", '"µ" = 3', '"ﬁx" = 3', '"D٣" = [3, 4]', "lambda = 3", "angle = 3", "Z = { y = 0 }"),
    *('"👩\u200d🔧" = 3', 'unit = "ft"', 'unit = "nan"', 'title = "\u2028"', "# \u2028 \x85", "x"),
    *("B = [0, 0]", 'B = "left"', 'C = "parallel"', "C = [3, nan]", "P = { through = 'A' }"),
    *("strut = { AC = 'variable' }", "foot = 'BCE'", "E = { along = 'BC', offset = 1e-9 }"),
    *("[loads]", "[masses]", "[friction]", "gravity = 9.81", "gravity = [0, nan]", "crank = 2"),
    *('P = { at = "C", force = "2 kN", angle = 180 }', "M = { on = 'crank', couple = -6 }"),
    *('Q = { at = "C", table = "card.csv" }', 'rod = { mass = 2, at = "C", inertia = 1e-3 }'),
    *("slider = 0.1", "Q = { at = 'C', table = [[0, 180], [1e3, 2e3]], unit = 'kN' }"),
    *("crank = { angle = 60, omega = 10 }", "rod = { BD = 90, DE = 30 }", "G = { x = 1e150 }"),
)
LETTERS = "ABCDEFGHOPQ\u0661µ{}[]\"'=,#.-_ \t\r\n\x00\x85\u2028\ufeff\u202e0123456789e"

_NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w.])")
_TEXT = re.compile(r'"[^"\n]*"')
_POINT = re.compile(r"[A-Z]\d?")
_NAME = re.compile(r"\b[a-z][a-z_]+\b")


def case(seed: int) -> str:
    """Return the text of a file."""
    dice = random.Random(seed)
    text = dice.choice(EXAMPLES)
    for _ in range(dice.choice((1, 1, 1, 2, 2, 3, 5, 9))):
        text = dice.choice(MUTATIONS)(text, dice)
    return text


def fault(text: str, seed: int = 0) -> str | None:
    """Return what a text breaks, or None; the seed chooses the pose."""
    return broken(lambda: _tried(text, random.Random(seed)), LONGEST)


def _tried(text: str, dice: random.Random) -> None:
    """Load, check, solve and draw what a text describes."""
    kind = class_of(read_text(text, "lesson.toml"))
    if dice.random() < EXAMINED:
        with suppress(vad.AssemblyError, vad.DeadCentreError):
            examine(kind)
    _solved(kind(), dice)
    with suppress(vad.InputError):  # another number than that of the file
        name, value = dice.choice(list(kind().parameters().items()))
        _solved(kind(**{name: value * dice.choice((-1.0, 0.5, 1.001, 1e-9, 1e9, 1e100))}), dice)


def _solved(mechanism: WrittenMechanism, dice: random.Random) -> None:
    """Solve and draw one pose, and read all results of it and of a few others."""
    driven, place = next(iter(mechanism.inputs.items()))
    other = dice.choice((place, place * 1.1, 0.0, 90.0, 180.0, dice.uniform(0.0, 360.0)))
    if dice.random() < SEVERAL:
        vad.solve(mechanism, **{driven: [place, other, float("nan")]}).to_dict()
    for start in dict.fromkeys((place, other)):
        with suppress(vad.AssemblyError, vad.DeadCentreError):
            motion = vad.solve(mechanism, **{driven: start})
            motion.table()
            if mechanism.burden:
                with suppress(vad.InputError):  # a slide that jams, or stands still
                    vad.forces(motion).table()
            sheet = vad.draw(motion)
            if dice.random() < PLANNED:
                plan(sheet, screen((1280, 720)), load_style("paper").key)


def _number(text: str, dice: random.Random) -> str:
    """Replace a number."""
    return _replaced(text, _NUMBER, dice, lambda _: dice.choice(NUMBERS))


def _scaled(text: str, dice: random.Random) -> str:
    """Multiply a number, perhaps by a power of ten that takes it beyond a limit."""
    factor = dice.choice((-1.0, 0.5, 2.0, 1 + 1e-9, 1e-3, 1e3, 10.0 ** dice.uniform(-160, 160)))
    return _replaced(text, _NUMBER, dice, lambda old: repr(float(old) * factor))


def _same(text: str, dice: random.Random) -> str:
    """Put one number of the text in place of another."""
    return _replaced(text, _NUMBER, dice, lambda old: dice.choice(_NUMBER.findall(text) or [old]))


def _word(text: str, dice: random.Random) -> str:
    """Replace a text."""
    return _replaced(text, _TEXT, dice, lambda _: f'"{dice.choice(WORDS)}"')


def _letter(text: str, dice: random.Random) -> str:
    """Put one point in place of another."""
    return _replaced(text, _POINT, dice, lambda _: dice.choice(_POINT.findall(text)))


def _name(text: str, dice: random.Random) -> str:
    """Put one name or word in place of another."""
    return _replaced(text, _NAME, dice, lambda _: dice.choice(_NAME.findall(text)))


def _replaced(
    text: str, pattern: re.Pattern[str], dice: random.Random, new: Callable[[str], str]
) -> str:
    found = list(pattern.finditer(text))
    if not found:
        return text
    one = dice.choice(found)
    return text[: one.start()] + new(one[0]) + text[one.end() :]


def _without_line(text: str, dice: random.Random) -> str:
    """Leave out a line."""
    lines = text.split("\n")
    del lines[dice.randrange(len(lines))]
    return "\n".join(lines)


def _with_line(text: str, dice: random.Random) -> str:
    """Add a line: one of the text, of another example, or a strange one."""
    lines = text.split("\n")
    several = (lines, dice.choice(EXAMPLES).split("\n"), LINES)
    lines.insert(dice.randrange(len(lines) + 1), dice.choice(dice.choice(several)))
    return "\n".join(lines)


def _moved_line(text: str, dice: random.Random) -> str:
    """Move a line elsewhere."""
    lines = text.split("\n")
    line = lines.pop(dice.randrange(len(lines)))
    lines.insert(dice.randrange(len(lines) + 1), line)
    return "\n".join(lines)


def _other_table(text: str, dice: random.Random) -> str:
    """Put a table of another example in place of the text's own."""
    both = text, dice.choice(EXAMPLES)
    parts, others = (re.split(r"^(?=\[)", each, flags=re.M) for each in both)
    parts[dice.randrange(len(parts))] = dice.choice(others)
    return "".join(parts)


def _sign(text: str, dice: random.Random) -> str:
    """Replace, add or leave out one character."""
    place = dice.randrange(len(text) + 1)
    new = dice.choice(("", dice.choice(LETTERS)))
    return text[:place] + new + text[place + dice.randrange(2) :]


def _as_dimension(text: str, dice: random.Random) -> str:
    """Give a number a name in the table of dimensions, and write an expression of it."""
    name = dice.choice(("a", "side", "half", "µ", "ﬁx", "pi", "e", "É"))
    value = dice.choice(("60", "1e-199", "1e199", "nan", "0", "-3"))
    text = _replaced(
        text, _NUMBER, dice, lambda old: f'"{dice.choice((name, f"{old}+{name}", f"{name}*1e9"))}"'
    )
    return text.replace("[fixed]", f'[dimensions]\n"{name}" = {value}\n[fixed]', 1)


MUTATIONS: tuple[Callable[[str, random.Random], str], ...] = (
    *(_number, _number, _scaled, _scaled, _same, _word, _letter, _letter, _letter, _name),
    *(_without_line, _with_line, _with_line, _moved_line, _other_table, _sign, _as_dimension),
)


if __name__ == "__main__":
    from tests.fuzz.promise import run

    run(case, fault, *map(int, sys.argv[1:]))
