"""The rules of the house, of which linters know nothing: names, lengths, first sentences."""

from __future__ import annotations

import ast
import re
from itertools import pairwise
from pathlib import Path

import vad

HOME = Path(vad.__file__).parent
FILES = {path.relative_to(HOME): path.read_text("utf-8") for path in sorted(HOME.rglob("*.py"))}
LONGEST = 500


def imported(text: str) -> set[str]:
    """Return the modules that a file imports, wherever in it."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            names.update(each.name for each in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.add(node.module)
    return names


def test_no_file_is_long():
    """The words of a language are one table, however long."""
    files = {path: text for path, text in FILES.items() if path.parent.name != "words"}
    assert [str(path) for path, text in files.items() if len(text.splitlines()) > LONGEST] == []


def test_every_module_says_what_lives_in_it():
    sentences = {path: ast.get_docstring(ast.parse(text)) or "" for path, text in FILES.items()}
    assert [str(path) for path, sentence in sentences.items() if "." not in sentence] == []


def test_signals_are_the_affair_of_the_command_line():
    """But for the workers of a batch, which are started so that they hear none."""
    listeners = {path.as_posix() for path, text in FILES.items() if "signal" in imported(text)}
    assert listeners == {"cli/process.py", "batches/workers.py"}


def test_every_loop_says_what_bounds_it():
    """A loop without a count has a comment: what each round does, or for what it waits."""
    bound = re.compile(r"(#|//) .*\b(each round|waits)\b", re.IGNORECASE)
    scripts = {path.relative_to(HOME): path.read_text("utf-8") for path in HOME.rglob("*.js")}
    silent = [
        f"{path}:{number}"
        for path, text in (FILES | scripts).items()
        for number, (before, line) in enumerate(pairwise(["", *text.splitlines()]), 1)
        if re.match(r"\s*while\b.*[:{](\s*#.*)?$", line)
        and not (bound.search(before) or bound.search(line))
    ]
    assert silent == []
