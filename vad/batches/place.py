"""Where something is written: what is wrong with it is said with its file and line."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from vad.errors import InputError, VadError


@contextmanager
def written_at(place: str) -> Iterator[None]:
    """Put a place, or the name of what is wrong there, in front of every error of the block.

    Raises
    ------
    vad.errors.InputError
        For any error of this program.

    Examples
    --------
    >>> with written_at("sheets.toml, line 7"), written_at("crank"):
    ...     raise InputError("must be positive, got -4")
    Traceback (most recent call last):
    vad.errors.InputError: sheets.toml, line 7: crank: must be positive, got -4
    """
    try:
        yield
    except VadError as error:
        said = str(error).removeprefix(f"{place}: ")
        raise InputError(f"{place}: {said}", error.hint) from None
