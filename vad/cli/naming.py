"""What NAME stands for: in comes a mechanism's name or a file's, out goes its class."""

from __future__ import annotations

from pathlib import Path

from vad.errors import UsageError
from vad.files.examples import EXTENSION, example_names
from vad.mechanisms import Mechanism, mechanism_named


def kind_of(name: str) -> type[Mechanism]:
    """Return the class of the mechanism that is called ``name`` or stands in a file of that name.

    Raises
    ------
    vad.errors.UsageError
        For a name that no mechanism has.
    vad.errors.InputError
        For a file that describes none.
    """
    if name.endswith(EXTENSION):
        from vad.files.loading import load

        return load(name)
    try:
        return mechanism_named(name)
    except UsageError as wrong:
        if Path(name + EXTENSION).is_file():
            wrong.hint = f"{name}{EXTENSION} is a file"
        elif name in example_names():
            wrong.hint = f"vad example {name} > {name}{EXTENSION}"
        raise
