"""Completion in a shell: which words may follow the words so far.

``vad --completion bash`` prints the script that teaches a shell to ask.  It asks by calling `vad`
again, with what it wants in the environment variable `VARIABLE`.
"""

from __future__ import annotations

from collections.abc import Callable, Collection

import click
from click import shell_completion
from click.shell_completion import CompletionItem, ShellComplete

from vad.errors import unknown

#: Where a shell says what it wants, such as ``bash_complete``.
VARIABLE = "_VAD_COMPLETE"
SHELLS = ("bash", "zsh", "fish")

Completer = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]


def script(shell: str) -> str:
    """Return the script that a shell reads once at its start.

    Raises
    ------
    vad.errors.UsageError
        For a shell that is not one of `SHELLS`.

    Examples
    --------
    >>> "complete -o nosort -F _vad_completion vad" in script("bash")
    True
    """
    if shell not in SHELLS:
        raise unknown("shell", shell, SHELLS)
    kind = shell_completion.get_completion_class(shell)
    assert kind is not None
    # The class's own method may start a shell to ask for its version.
    return ShellComplete.source(kind(click.Command("vad"), {}, "vad", VARIABLE))


def a_file(_: click.Context, __: click.Parameter, start: str) -> list[CompletionItem]:
    """Let the shell complete the name of a file."""
    return [CompletionItem(start, type="file")]


def one_of(names: Collection[str]) -> Completer:
    """Complete one of a few names."""

    def complete(_: click.Context, __: click.Parameter, start: str) -> list[CompletionItem]:
        return [CompletionItem(name) for name in names if name.startswith(start)]

    return complete


def several(names: Collection[str]) -> Completer:
    """Complete the last of some names with commas between them."""

    def complete(_: click.Context, __: click.Parameter, start: str) -> list[CompletionItem]:
        before, comma, last = start.rpartition(",")
        given = before.split(",")
        return [
            CompletionItem(before + comma + name)
            for name in names
            if name.startswith(last) and name not in given
        ]

    return complete
