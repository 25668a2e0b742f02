"""Files of sheets as a lecturer writes them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

#: A class whose sheets are made in a moment.
CLASS = """\
[sheet]
mechanism = "four-bar"
count     = 10
seed      = 2026
files     = ["key.json"]
[vary]
crank = { share = 0.25 }
coupler = { share = 0.25 }
angle = { from = 0, to = 355, step = 5 }
omega = ["60 rpm", "90 rpm", "120 rpm"]
[keep]
sine = 0.35
"""


@pytest.fixture
def written(tmp_path: Path) -> Callable[[str, str], Path]:
    """Write a file of sheets and return its path."""

    def write(text: str = CLASS, name: str = "sheets.toml") -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.fixture
def contents() -> Callable[[Path], dict[str, bytes]]:
    """Return the bytes of every file in a folder."""
    return lambda folder: {path.name: path.read_bytes() for path in folder.iterdir()}
