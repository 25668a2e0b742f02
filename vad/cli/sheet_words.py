"""The file of a sheet in the place of NAME: what it says, as words of a command line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from vad.cli.options import flag, option_name
from vad.files.sheet_file import sheet_in, sheet_of
from vad.files.tables import text_of
from vad.mechanisms import MECHANISMS


def with_sheet(args: Sequence[str], moved: bool = False) -> list[str]:
    """Return the words of a command line, the first of which names the mechanism.

    Where that is the file of a sheet, its mechanism and its numbers stand in its place.  Options
    that follow replace them.

    Parameters
    ----------
    args
        The words; the first one is the name of a file.
    moved
        Whether the driver moves, so that the place where the file has it is left out.

    Raises
    ------
    vad.errors.InputError
        For a file that cannot be read; with its line, for a sheet of more than one pose.
    """
    name, *rest = args
    source = sheet_in(text_of(name), Path(name).name)
    if source is None:
        return [*args]
    mechanism, given = sheet_of(source, MECHANISMS)
    if moved:
        given.pop(next(iter(MECHANISMS[mechanism].inputs)), None)
    return [mechanism, *_words(given), *rest]


def _words(given: Mapping[str, Any]) -> Iterator[str]:
    for name, value in given.items():
        if name == "points":
            for point, (link, distance, angle) in value.items():
                yield f"--point={point} on {link} {distance!r} at {angle!r}"
        else:
            option = "length_unit" if name == "unit" else option_name(name)
            yield f"{flag(option)}={value}"
