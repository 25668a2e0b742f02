"""What each verb does with a mechanism, its input and the verb's own options."""

from __future__ import annotations

import json
from typing import Any

import click

import vad
from vad.cli.progress import progress, written
from vad.diagrams.strokes import Sheet
from vad.errors import UsageError
from vad.export import FOLDER, format_of
from vad.lecture.lesson import Lesson
from vad.lecture.still import Still
from vad.mechanisms import Mechanism

Inputs = dict[str, Any]
#: The files that lie beside a film with ``--subtitles``, and the films that take them.
SUBTITLES = (".srt", ".vtt")
_SUBTITLED = (".mp4", ".gif", FOLDER)


def solve(mechanism: Mechanism, inputs: Inputs, as_json: bool = False) -> None:
    """Print the numbers of one pose."""
    motion = vad.solve(mechanism, **inputs)
    click.echo(json.dumps(motion.to_dict(), ensure_ascii=False) if as_json else motion.table())


def draw(mechanism: Mechanism, inputs: Inputs, output: str, **options: Any) -> None:
    """Write one pose as a picture, or its strokes as data."""
    format_of(Sheet, output)  # before anything is worked out
    look = _pop(options, "style", "size")
    sheet = vad.draw(vad.solve(mechanism, **inputs), **options)
    vad.save(sheet, output, **look)
    written(output)


def animate(
    mechanism: Mechanism,
    inputs: Inputs,
    output: str,
    still: str | None = None,
    subtitles: bool = False,
    **options: Any,
) -> None:
    """Write the film in which one pose is drawn stroke by stroke, or one step of it."""
    kind = format_of(Lesson if still is None else Still, output)
    if subtitles and (still is not None or kind not in _SUBTITLED):
        hint = "as in -o lecture.mp4 --subtitles; or -o lecture.srt alone"
        raise UsageError(f"--subtitles go beside a film, not beside '{output}'", hint)
    timing = _pop(options, "fps", "size", "speed", "style")
    sheet = vad.draw(vad.solve(mechanism, **inputs), **options)
    lesson = vad.animate(sheet, **timing)
    if still is not None:
        vad.save(vad.still(lesson, still), output)
        written(output)
        return
    with progress(output) as moved:
        vad.save(lesson, output, beside=SUBTITLES if subtitles else (), progress=moved)
    written(output, f"{lesson.duration:.1f} s, {lesson.frames} frames")


def sweep(mechanism: Mechanism, inputs: Inputs, output: str, **ends: Any) -> None:
    """Write the results over a range of the input, as a table or a plot."""
    from vad.cli.span import places
    from vad.export.sweep import save_sweep

    driven = next(iter(mechanism.inputs))
    save_sweep(vad.solve(mechanism, **{driven: places(mechanism, **ends)}, **inputs), output)
    written(output)


def _pop(options: dict[str, Any], *names: str) -> dict[str, Any]:
    """Take from ``options`` those of ``names`` that are there."""
    return {name: options.pop(name) for name in names if name in options}
