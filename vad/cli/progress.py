"""What a terminal sees while a film is written, and when a file is done; a pipe sees nothing."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from vad.export.source import Progress


@contextmanager
def progress(what: str) -> Iterator[Progress | None]:
    """Show a bar on stderr if that is a terminal; yield what moves it, or None."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import Progress as Bar

    with Bar(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(what, total=None)
        yield lambda done, total: bar.update(task, completed=done, total=total)


def written(path: str, details: str = "") -> None:
    """Say on a terminal which file is done."""
    if sys.stdout is not None and sys.stdout.isatty():
        click.echo(f"wrote {path}" + (f" ({details})" if details else ""))
