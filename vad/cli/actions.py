"""What each verb does with a mechanism, its input and the verb's own options.

While a film is written, a bar moves on a terminal; when a file is done, its name is said there.  A
pipe sees neither.
"""

from __future__ import annotations

import math
import sys
import webbrowser
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import click

import vad
from vad.cli.process import check_interrupt, signals_held_back, wait_for_signal
from vad.errors import AssemblyError, UsageError, VadError
from vad.export import FOLDER, FORMATS, format_of, own_options
from vad.lecture.lesson import Lesson, Still
from vad.lecture.turn import Turn
from vad.mechanisms import Mechanism
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from vad.export.frames import Progress

Inputs = dict[str, Any]
#: The files that lie beside a film with ``--subtitles``, and the films that take them.
SUBTITLES = (".srt", ".vtt")
_SUBTITLED = (".mp4", ".gif", FOLDER)
#: The most poses of a sweep.
LARGEST = 1_000_000


@contextmanager
def progress(what: str) -> Iterator[Progress]:
    """Yield the function to call after each frame: it heeds signals and moves a progress bar."""

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
    """Write on stderr which change points lie in a range of the driver.

    At a change point the mechanism can go on in two ways.
    """
    from vad.kinematics.reach import change_points
    from vad.kinematics.results import place_unit

    turns = "angle" in mechanism.inputs
    for change in change_points(mechanism):
        turned = turns and low > -math.inf  # the same angle, not below the range
        place = low + (change.place - low) % 360.0 if turned else change.place
        if low <= place <= high:
            click.echo(f"note: {change.words(place_unit(mechanism))}", err=True)


def places(
    mechanism: Mechanism, start: float | None = None, stop: float | None = None, steps: int = 361
) -> NDArray[np.float64]:
    """Return ``steps`` places of the driver, evenly spaced from ``start`` to ``stop``.

    What is left out is a whole turn of a driven link, or the widest range in which a driven
    slide closes.

    Raises
    ------
    UsageError
        If the number of steps or the ends make no range.
    AssemblyError
        If the mechanism closes nowhere.
    """
    import numpy as np

    if not 2 <= steps <= LARGEST:
        raise UsageError(f"--steps: must be from 2 to {LARGEST}, got {steps}")
    if "angle" in mechanism.inputs:
        first, last = 0.0, 360.0
    elif start is None or stop is None:
        first, last = _widest(mechanism)
    first = first if start is None else start
    last = last if stop is None else stop
    if not math.isfinite(last - first) or first == last:
        raise UsageError(f"--from, --to: {first:g} to {last:g} is no range")
    return np.linspace(first, last, steps)


def _widest(mechanism: Mechanism) -> tuple[float, float]:
    """Return the widest range of the driver that closes, the greater one of two equal ones."""
    from vad.kinematics.reach import closing_range

    ranges = closing_range(mechanism)
    if not ranges:
        raise AssemblyError("with these lengths the links close nowhere")
    widest = max(ranges, key=lambda ends: (float(f"{ends[1] - ends[0]:.6g}"), ends[1]))
    if widest[0] == widest[1]:
        raise AssemblyError(f"with these lengths the links close only at {widest[0]:g}")
    return widest


def draw(
    mechanism: Mechanism, inputs: Inputs, output: str, turn: bool = False, **options: Any
) -> None:
    """Write a pose as a picture, or its strokes as data; or a few poses, or a whole turn."""
    at = options.pop("at", None)
    if turn and at is not None:
        raise UsageError("--turn and --at: choose one of them")
    if turn and "blank" in options:
        raise UsageError("--blank is for one pose, not for a turn")
    made = Turn if turn else Sheet if at is None else Multiples
    kind = format_of(Sheet, output)  # before anything is worked out
    format_of(made, output)
    if "paper" in options and kind != ".pdf":
        raise UsageError(f"--paper is for PDF, not for '{output}'", hint="as in -o sheet.pdf")
    if "blank" in options and kind == ".json":
        raise UsageError(
            f"--blank is for pictures, not for '{output}'", hint="as in -o problem.pdf"
        )
    look = _pop(options, "style", "size", "paper", "blank", *own_options([FORMATS[made][kind]]))
    drawn: Sheet | Multiples | Turn
    if at is not None:
        drawn = _multiples(mechanism, inputs, at, **options)
    else:
        motion = vad.solve(mechanism, **inputs)
        drawn = (vad.turn if turn else vad.draw)(motion, **options)
    vad.save(drawn, output, **look)
    written(output)
    if turn:
        passed(mechanism)


def _multiples(mechanism: Mechanism, inputs: Inputs, at: list[float], **options: Any) -> Multiples:
    """Draw a few poses; what is wrong with their places is said of the option."""
    driven = next(iter(mechanism.inputs))
    if driven in inputs:
        raise UsageError(f"--at: takes the place of --{driven}", hint=f"leave out --{driven}")
    try:
        return vad.multiples(vad.solve(mechanism, **inputs), at, **options)
    except VadError as error:
        raise type(error)(f"--at: {str(error).removeprefix('at: ')}", error.hint) from None


def animate(
    mechanism: Mechanism,
    inputs: Inputs,
    output: str,
    still: str | None = None,
    subtitles: bool = False,
    turn: bool = False,
    **options: Any,
) -> None:
    """Write the film in which one pose is drawn stroke by stroke, one step of it, or a turn."""
    if turn:
        of_strokes = {"--still": still is not None, "--subtitles": subtitles}
        for name, given in (of_strokes | {"--loop": "loop" in options}).items():
            if given:
                why = "which draws no strokes one by one"
                raise UsageError(f"{name} does not go with --turn, {why}")
        _turn(mechanism, inputs, output, **options)
        return
    thing = Lesson if still is None else Still
    kind = format_of(thing, output)
    if subtitles and (still is not None or kind not in _SUBTITLED):
        hint = "as in -o lecture.mp4 --subtitles; or -o lecture.srt alone"
        raise UsageError(f"--subtitles go beside a film, not beside '{output}'", hint)
    own = _pop(options, *own_options([FORMATS[thing][kind]]))
    timing = _pop(options, "fps", "size", "speed", "style", "loop")
    sheet = vad.draw(vad.solve(mechanism, **inputs), **options)
    lesson = vad.animate(sheet, **timing)
    if still is not None:
        vad.save(_still(lesson, still), output, **own)
        written(output)
        return
    with progress(output) as moved:
        vad.save(lesson, output, beside=SUBTITLES if subtitles else (), progress=moved, **own)
    written(output, f"{lesson.duration:.1f} s, {lesson.frames} frames")


def _still(lesson: Lesson, step: str) -> Still:
    """Return one step; what is wrong with its name is said of the option."""
    try:
        return vad.still(lesson, step)
    except UsageError as error:
        raise UsageError(f"--still: {error}", error.hint) from None


def _turn(mechanism: Mechanism, inputs: Inputs, output: str, **options: Any) -> None:
    """Write the film in which the mechanism runs through a full turn."""
    own = _pop(options, *own_options([FORMATS[Turn][format_of(Turn, output)]]))
    film = vad.turn(vad.solve(mechanism, **inputs), **options)
    with progress(output) as moved:
        vad.save(film, output, progress=moved, **own)
    written(output, f"{film.duration:.1f} s, {film.frames} frames")
    passed(mechanism)


def sweep(mechanism: Mechanism, inputs: Inputs, output: str, **ends: Any) -> None:
    """Write the results over a range of the input, as a table or a plot."""
    from vad.export.sweep import save_sweep

    driven = next(iter(mechanism.inputs))
    swept = places(mechanism, **ends)
    save_sweep(vad.solve(mechanism, **{driven: swept}, **inputs), output)
    written(output)
    passed(mechanism, float(swept.min()), float(swept.max()))


def gui(
    mechanism: Mechanism,
    inputs: Inputs,
    port: int = 0,
    no_browser: bool = False,
    **options: Any,
) -> None:
    """Serve the page until the process is asked to stop; its address is the only line printed."""
    from vad.gui.messages import ExportQuestion
    from vad.gui.server import served

    start = ExportQuestion.of(mechanism, inputs, **options)
    with signals_held_back(), served(start, port) as address:
        click.echo(address)
        if not no_browser:
            webbrowser.open(address)
        wait_for_signal()


def _pop(options: dict[str, Any], *names: str) -> dict[str, Any]:
    """Take from ``options`` those of ``names`` that are there."""
    return {name: options.pop(name) for name in names if name in options}
