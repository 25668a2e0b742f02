"""The examples of a page: in comes its Markdown, out go fenced blocks, and what running them gives.

A block of ``sh`` holds commands, one of ``console`` commands after ``$`` with what they print, one
of ``python`` a program or, with ``>>>``, a session; the blocks of a page share their names.  A
block with a title is a file.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from vad.cli.run import run

_FENCE = re.compile(
    r"^```(?P<language>\w+)(?: title=\"(?P<title>[^\"]+)\")?\n(?P<text>.*?)^```$", re.M | re.S
)
_PICTURE = re.compile(
    r"!\[[^]]*\]\((?P<path>[^)]+)\)|<(?:video|source)[^>]* src=\"(?P<film>[^\"]+)\""
)
#: Makes a film in a moment instead of seconds; a turn takes most of its time for its panels.
_BRIEFLY = ("--fps", "5", "--size", "320x240", "--speed", "10")
_ONE_PANEL = ("--panels", "velocity")


@dataclass(frozen=True)
class Block:
    """One fenced block.

    Attributes
    ----------
    language
        What stands behind the fence.
    text
        What stands between the fences.
    title
        The name of the file that it is, if it is one.
    """

    language: str
    text: str
    title: str | None = None


class ExampleError(AssertionError):
    """An example does not do what its page says."""


def blocks(text: str) -> list[Block]:
    r"""Return the fenced blocks of a page.

    Examples
    --------
    >>> blocks("One command:\n\n```sh\nvad list\n```\n")
    [Block(language='sh', text='vad list\n', title=None)]
    """
    return [
        Block(found["language"], found["text"], found["title"]) for found in _FENCE.finditer(text)
    ]


def commands(block: Block) -> list[list[str]]:
    """Return the words of every command of a block of ``sh``: of ``vad``, and of its own files."""
    lines = block.text.replace("\\\n", " ").splitlines()
    every = [shlex.split(line, comments=True) for line in lines]
    return [words for words in every if words and words[0] in ("vad", "python")]


def draw_pictures(page: Path) -> None:
    """Run those commands of a page that write a picture which the page shows.

    The files appear beside the page.

    Raises
    ------
    ExampleError
        If one fails.
    """
    text = page.read_text("utf-8")
    shown = {found["path"] or found["film"] for found in _PICTURE.finditer(text)}
    for block in blocks(text):
        if block.title:
            (page.parent / block.title).write_text(block.text, encoding="utf-8")
        if block.language == "sh":
            for words in commands(block):
                if shown.intersection(words):
                    _succeed(words, page.parent)
    for block in blocks(text):
        if block.title:
            (page.parent / block.title).unlink()


def run_examples(text: str, folder: Path) -> None:
    """Run all examples of a page in ``folder``, films briefly, turns in one panel.

    Raises
    ------
    ExampleError
        If one fails, or prints something else than the page says.
    """
    names: dict[str, Any] = {"__name__": "__page__"}
    for block in blocks(text):
        if block.title:
            (folder / block.title).write_text(block.text, encoding="utf-8")
        elif block.language == "sh":
            for words in commands(block):
                film = "animate" in words and "--still" not in words
                turn = "--turn" in words and "--panels" not in words
                brief = (*(_BRIEFLY if film else ()), *(_ONE_PANEL if turn else ()))
                _succeed([*words, *brief], folder)
        elif block.language == "console":
            _compare(block, folder)
        elif block.language == "python":
            _execute(block, names, folder)


def _succeed(words: list[str], folder: Path) -> None:
    """Run a command; what it prints goes into a file if the command says so."""
    words, target = (words[:-2], words[-1]) if words[-2:-1] == [">"] else (words, None)
    code, printed = _call(words, folder)
    if code != 0:
        raise ExampleError(f"{shlex.join(words)}: exit code {code}\n{printed}")
    if target:
        (folder / target).write_text(printed, encoding="utf-8")


def _call(words: list[str], folder: Path) -> tuple[int, str]:
    """Return the exit code of a command and what it prints, its error too."""
    if words[0] == "python":
        done = subprocess.run(
            [sys.executable, *words[1:]], cwd=folder, capture_output=True, text=True, check=False
        )
        return done.returncode, done.stdout + done.stderr
    printed = io.StringIO()
    with (
        contextlib.chdir(folder),
        contextlib.redirect_stdout(printed),
        contextlib.redirect_stderr(printed),
    ):
        code = run(words[1:])
    return code, printed.getvalue()


def _compare(block: Block, folder: Path) -> None:
    """Run the commands after ``$`` and compare what they print with what stands below each."""
    for session in re.split(r"^\$ ", block.text, flags=re.M)[1:]:
        command, _, expected = session.partition("\n")
        _, printed = _call(shlex.split(command), folder)
        if printed.split() != expected.split():
            raise ExampleError(f"$ {command}\n{printed}\ninstead of\n{expected}")


def _execute(block: Block, names: dict[str, Any], folder: Path) -> None:
    with contextlib.chdir(folder):
        if ">>>" not in block.text:
            exec(compile(block.text, "<page>", "exec"), names)
            return
        session = doctest.DocTestParser().get_doctest(block.text, names, "page", None, 0)
        report = io.StringIO()
        doctest.DocTestRunner().run(session, out=report.write, clear_globs=False)
        names.update(session.globs)
    if report.getvalue():
        raise ExampleError(report.getvalue())
