"""The pages that follow from code and from files: mechanisms, command line, benchmarks, errors.

Out go pages in Markdown by their paths.
"""

from __future__ import annotations

import csv
import inspect
import json
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import click

from docs.copied import copied_pages
from vad.cli.app import app
from vad.cli.groups import MechanismGroup
from vad.cli.options import mechanism_options
from vad.files.examples import example_names, example_title
from vad.mechanisms import MECHANISMS, Mechanism

_BENCHMARKS = Path(__file__).parents[1] / "benchmarks" / "results"
_ABOUT = """\
All of them can be turned by hand in [the gallery](../gallery/index.md). Options of the command line
are fields of the class in Python. Whatever else is made of dyads is
described by [a file](../how-to/mechanism-file.md); below are those that ship with the program.
"""
_SPEED = """\
## A million poses

Time divided by that of `sin`, `cos`, `sqrt` and `arctan2` of as many numbers, in one thread: for a
point's position; for four results (its position and acceleration and two rates; of a four-bar the
rocker's ω and the coupler's α) that are read one after the other from a motion; for the same by
`vad.sweep`; for that where it is compiled (`vad-diagrams[fast]`); and for the same four of one pose
alone.
"""
_LARGEST = """\
What `python -m benchmarks.errors --table` has found: random mechanisms, at least half of them where
trouble is, each against a hundred digits. ε·κ is the measure of
[How exact, how fast](../explanation/accuracy.md); the pose that gives the largest error is written
with all its digits.

An ulp is one unit in the last place of the true number. These are errors of poses that are drawn
without looking for trouble; where a result is the small difference of large numbers, its last place
is far below what its input holds, and ulps can be many. With the poses of the largest errors in
ulps, everything is in `benchmarks/results/errors.csv`. Chains of dyads are drawn from a seed by
`benchmarks/errors/chains.py`; their links, points and slides are counted together. The last are
[the files that ship with the program](mechanisms.md#from-files), over their ranges.
"""
_FILMS = """\
## Films and pictures

The default slider–crank lecture at 1280×720 and 30 frames a second, in ratios within one run, whole
processes. `FuncAnimation` is timed on a part of the frames and extrapolated; it pays for every
frame of a pause.
"""


def made_pages() -> dict[str, str]:
    """Return the made pages by their paths."""
    return {
        "reference/mechanisms.md": _mechanisms(),
        "reference/command-line.md": _command_line(),
        "reference/errors.md": _errors(),
        "explanation/benchmarks.md": _benchmarks(),
        **copied_pages(),
    }


def _mechanisms() -> str:
    parts = ["# Mechanisms", _ABOUT]
    for name, kind in MECHANISMS.items():
        parts += [f"## {kind.title} {{ #{name} }}", inspect.getdoc(kind) or ""]
        if name not in _without_poster():
            parts.append(f"![{kind.title}](../gallery/posters/{name}-paper.png)")
        parts.append(f"`vad solve {name}` · `vad.{kind.__name__}`")
        parts += [_options(mechanism_options(kind)), _reported(kind)]
    examples = [[f"`vad example {name}`", example_title(name)] for name in example_names()]
    return _joined([*parts, "## From files", _table(["file", ""], examples)])


def _without_poster() -> set[str]:
    posters = (Path(__file__).parents[1] / "gallery" / "posters").glob("*-paper.png")
    return set(MECHANISMS) - {poster.stem.removesuffix("-paper") for poster in posters}


def _reported(kind: type[Mechanism]) -> str:
    """Say what the results are called."""
    links = [f"`{name}` {ends}" for name, ends in kind.links.items()]
    slides = [f"`{name}` at {point}" for name, point in kind.slides.items()]
    joints = [f"`{letter}`, {between}" for letter, between in kind.joints.items()]
    points = [f"`{letter}`" for letter in kind.letters]
    named = {"Links": links, "Joints": joints, "Slides": slides, "Points": points}
    return " · ".join(f"{what}: {', '.join(each)}" for what, each in named.items() if each) + "."


def _command_line() -> str:
    with click.Context(app, info_name="vad", **app.context_settings) as context:
        own = app.get_params(context)
    parts = ["# Command line", app.help or "", "`vad [OPTIONS] COMMAND …`", _options(own)]
    parts.append(
        "The exit code is 0; 1 for a mechanism or a file that cannot be, with one line `error: …` "
        "and perhaps one `hint: …`; 2 for wrong usage."
    )
    for name, command in app.all_commands().items():
        taken = [each for each in command.params if isinstance(each, click.Argument)]
        options: Iterable[click.Parameter] = [each for each in command.params if each not in taken]
        arguments = [each.human_readable_name for each in taken]
        if isinstance(command, MechanismGroup):
            arguments, options = ["NAME"], command.options
        words = " ".join(["vad", name, *arguments, "[OPTIONS]"])
        parts += [f"## vad {name}", f"`{words}`", _help(command.help or ""), _options(options)]
        if isinstance(command, MechanismGroup):
            parts.append("And the options of the [mechanism](mechanisms.md).")
    return _joined(parts)


def _help(text: str) -> str:
    r"""Return a command's help; a paragraph after ``\b`` stands as it is written."""
    return re.sub(r"^\x08\n(.+?)(?=\n\n|\Z)", r"```text\n\1\n```", text, flags=re.M | re.S)


def _options(options: Iterable[click.Parameter]) -> str:
    rows = []
    for option in options:
        assert isinstance(option, click.Option)
        takes = "" if option.is_flag else f" {option.metavar or ''}"
        rows.append([f"`{', '.join(option.opts)}{takes}`".replace("|", r"\|"), option.help or ""])
    return _table(["option", ""], rows)


def _benchmarks() -> str:
    machine, speed = _measured("speed")
    _, films = _measured("rendering")
    parts = ["# Benchmarks", "  \n".join(machine), _SPEED, speed, _FILMS, films]
    return _joined([*parts, "The scripts are in `benchmarks/`."])


def _errors() -> str:
    lines = (_BENCHMARKS / "errors.csv").read_text("utf-8").splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    parts = ["# Largest errors", _LARGEST]
    for name in dict.fromkeys(row["mechanism"] for row in rows):
        title = MECHANISMS[name].title if name in MECHANISMS else _title(name)
        found = [
            [
                f"{row['part']} {row['quantity']}",
                row["error"],
                row["bound"],
                _command(name, row["where"]),
                row["most"],
                row["most_ulps"],
            ]
            for row in rows
            if row["mechanism"] == name
        ]
        head = ["result", "ε·κ", "bound", "in this pose", "ulps, 99 of 100", "ulps, largest"]
        parts += [f"## {title}", _table(head, found)]
    return _joined(parts)


def _title(name: str) -> str:
    file = name.removesuffix(".toml")
    return example_title(file) if file != name else name.capitalize()


def _command(name: str, pose: str) -> str:
    """Return the command that solves a pose, or what makes a chain again."""
    if name == "chains" or not pose:
        return f"`{pose}`" if pose else ""
    numbers = json.loads(pose).items()
    options = " ".join(f"--{key.replace('_', '-')} {value}" for key, value in numbers)
    return f"`vad solve {name} {options}`"


def _measured(name: str) -> tuple[list[str], str]:
    """Return what is said of the machine and the table of one benchmark."""
    lines = (_BENCHMARKS / f"{name}.csv").read_text("utf-8").splitlines()
    machine = [line.removeprefix("# ") for line in lines if line.startswith("#")]
    head, *rows = csv.reader(line for line in lines if not line.startswith("#"))
    return machine, _table(head, rows)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def _joined(parts: Iterable[str]) -> str:
    return "\n\n".join(part.strip() for part in parts if part) + "\n"
