"""What a verb shows while it writes a file, and when the file is complete.

A terminal shows a progress bar, and then the name of the file.  Output into a pipe has neither.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

from vad.cli.process import check_interrupt, signals_held_back

if TYPE_CHECKING:
    from vad.export.frames import Progress


@contextmanager
def progress(what: str) -> Iterator[Progress]:
    """Yield the function to call after each frame: it checks for signals and shows progress."""

    def obey(_done: int, _total: int) -> None:
        check_interrupt()

    with signals_held_back():
        if sys.stderr is None or not sys.stderr.isatty():
            yield obey
            return
        from rich.console import Console
        from rich.markup import escape
        from rich.progress import Progress as Bar

        with Bar(console=Console(stderr=True), transient=True) as bar:
            task = bar.add_task(escape(what), total=None)

            def move(done: int, total: int) -> None:
                obey(done, total)
                bar.update(task, completed=done, total=total)

            yield move


def say_written(path: str, details: str = "") -> None:
    """Say on a terminal which file is complete."""
    if sys.stdout is not None and sys.stdout.isatty():
        click.echo(f"wrote {path}" + (f" ({details})" if details else ""))
