"""The options of a lecturer's script: ``--script talk.toml``, ``--pause velocity:4=3``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from vad.cli.options import pauses
from vad.errors import UsageError

if TYPE_CHECKING:
    from vad.lecture.script import Script

SCRIPT = click.Option(
    ["--script"],
    metavar="FILE",
    help="captions, pauses and markers by the names of strokes, as in talk.toml",
)
PAUSE = click.Option(
    ["--pause"],
    callback=pauses(),
    multiple=True,
    metavar="STEP=SECONDS",
    help="a step rests longer: velocity:4=3, velocity:BC.line=3",
)


def script_in(options: dict[str, Any], several: bool) -> Script:
    """Take the script out of the options of a verb.

    Raises
    ------
    vad.errors.UsageError
        If there is one where ``several`` poses are drawn, as in a turn.
    """
    from vad.lecture.script import Script, script_of  # a turn needs none

    path, extra = options.pop("script", None), options.pop("pause", None)
    for name, given in (("--script", path), ("--pause", extra)):
        if several and given:
            raise UsageError(f"{name} is for one pose, whose strokes are drawn one by one")
    script = script_of(path)
    return Script(script.captions, {**script.pauses, **(extra or {})}, script.markers)
