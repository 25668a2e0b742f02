"""What a class is to get: in comes the path of a TOML or CSV file, out go its jobs."""

from __future__ import annotations

import os
from pathlib import Path

from vad.batches.sheets_csv import Rows, read_csv
from vad.batches.sheets_toml import read_toml
from vad.errors import UsageError, shown
from vad.files.tables import text_of

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
    text = text_of(file, _LONGEST)
    return read_csv(text, file) if kind == ".csv" else Rows(read_toml(text, file))
