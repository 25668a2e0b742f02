"""``python -m docs.manual`` writes the manual page of the command, ``packaging/vad.1``.

The page follows from the commands and their options, as ``vad help`` does.  It goes into the wheel,
so that ``man vad`` finds it once the package is installed.
"""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from pathlib import Path

import click

from vad import __version__
from vad.cli.app import CARD, app
from vad.cli.design import DesignGroup
from vad.cli.groups import MechanismGroup

PAGE = Path(__file__).parents[1] / "packaging" / "vad.1"
_EXIT = """\
0 if all went well; 1 for a mechanism or file that cannot be, with one line that begins with error:
and perhaps one that begins with hint:; 2 for wrong words on the command line."""


def manual() -> str:
    """Return the manual page in the notation of man."""
    examples = CARD.partition("\n\nTry\n")[2].partition("\n\n")[0]
    lines = [
        f'.TH VAD 1 "" "vad {__version__}" "User Commands"',
        ".SH NAME",
        rf"vad \- {_text(_first(app).rstrip('.'))}",
        ".SH SYNOPSIS",
        r".B vad",
        r"VERB [NAME] [OPTIONS]",
        ".SH DESCRIPTION",
        "NAME is the name of a mechanism, which vad list shows, or a file such as press.toml.",
        "vad help VERB NAME shows the dimensions of a mechanism as options.",
    ]
    for name, command in app.all_commands().items():
        lines += [f".SH VAD {name.upper()}", _text(_first(command)), *_options(command)]
    lines += [".SH EXIT STATUS", _text(_EXIT), ".SH EXAMPLES", ".nf"]
    lines += [_text(line.strip()) for line in examples.splitlines()]
    return "\n".join([*lines, ".fi", ""])


def _first(command: click.Command) -> str:
    """Return the first paragraph of a command's help."""
    return inspect.cleandoc(command.help or "").partition("\n\n")[0]


def _options(command: click.Command) -> Iterator[str]:
    """Yield the lines of a command's options."""
    has_names = isinstance(command, MechanismGroup | DesignGroup)
    own = command.options if has_names else command.params
    context = click.Context(command)
    for option in own:
        record = option.get_help_record(context)
        if record is not None and isinstance(option, click.Option):
            yield from (".TP", rf"\fB{_text(record[0])}\fR", _text(record[1]))


def _text(words: str) -> str:
    """Return words as man reads them: it takes some signs for its own."""
    line = " ".join(words.split()).replace("\\", r"\e").replace("-", r"\-")
    line = "".join(each if each.isascii() else f"\\[u{ord(each):04X}]" for each in line)
    return rf"\&{line}" if line.startswith((".", "'")) else line


if __name__ == "__main__":
    PAGE.write_text(manual(), "utf-8")
