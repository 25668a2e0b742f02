"""What a class is to get: in comes the path of a TOML or CSV file, out go its jobs."""

from __future__ import annotations

import os
from pathlib import Path

from vad.batches.sheets_csv import Rows, read_csv
from vad.batches.sheets_toml import read_toml
from vad.errors import InputError, UsageError, shown

#: No class is so large.
_LONGEST = 10_000_000
_HINT = "as in sheets.toml, or sheets.csv with one row a sheet"


def read_sheets(path: str | os.PathLike[str]) -> Rows:
    """Return the jobs of a file, and the sheets that cannot be made.

    Raises
    ------
    vad.errors.UsageError
        For another kind of file.
    vad.errors.InputError
        For a file that cannot be read, or with its line for what in it cannot be.
    """
    if not isinstance(path, str | os.PathLike):
        raise UsageError(f"path: must be the name of a file, got {shown(path)}", _HINT)
    file = Path(path)
    kind = file.suffix.lower()
    if kind not in (".toml", ".csv"):
        raise UsageError(f"sheets cannot be read from {shown(str(path))}", _HINT)
    text = _text(file)
    return read_csv(text, file) if kind == ".csv" else Rows(read_toml(text, file))


def _text(file: Path) -> str:
    try:
        with file.open("rb") as stream:
            data = stream.read(_LONGEST + 1)
        text = data.decode("utf-8-sig")
    except (OSError, ValueError) as error:
        if isinstance(error, UnicodeDecodeError):
            raise InputError(f"{file.name}: is no text in UTF-8") from None
        said = getattr(error, "strerror", None) or str(error)
        raise InputError(f"{file.name}: {said.lower()}") from None
    if len(data) > _LONGEST:
        raise InputError(f"{file.name}: is longer than {_LONGEST} bytes")
    return text.replace("\r\n", "\n")
