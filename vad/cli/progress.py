"""What is said while a film is written, and when a file is done.

Progress and the name of a file are for a terminal; a pipe sees neither.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import click

from vad.cli.process import check_interrupt, signals_held_back

if TYPE_CHECKING:
    from vad.export.frames import Progress
    from vad.mechanisms import Mechanism


@contextmanager
def progress(what: str) -> Iterator[Progress]:
    """Yield what a film calls after each frame: it obeys signals, and on a terminal moves a bar."""

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


def written(path: str, details: str = "") -> None:
    """Say on a terminal which file is done."""
    if sys.stdout is not None and sys.stdout.isatty():
        click.echo(f"wrote {path}" + (f" ({details})" if details else ""))


def passed(mechanism: Mechanism, low: float = -math.inf, high: float = math.inf) -> None:
    """Say on stderr which change points lie in a range of the driver: there, two motions go on."""
    from vad.kinematics.reach import change_points
    from vad.kinematics.results import place_unit

    turns = "angle" in mechanism.inputs
    for change in change_points(mechanism):
        turned = turns and low > -math.inf  # the same angle, not below the range
        place = low + (change.place - low) % 360.0 if turned else change.place
        if low <= place <= high:
            click.echo(f"note: {change.words(place_unit(mechanism))}", err=True)
