"""A format that nobody has: what `tests/export/test_formats.py` adds to the others."""

from __future__ import annotations

from typing import Annotated, BinaryIO

from vad.strokes.sheet import Sheet


def write(
    sheet: Sheet,
    target: BinaryIO,
    style: str | None = None,
    whole: Annotated[bool, "a whole document"] = False,
    wide: Annotated[float, "its width in cm"] = 12.0,
    head: Annotated[str, "its first line"] = "none",
    copies: Annotated[int, "how often it is there"] = 1,
) -> None:
    """Write the options."""
    target.write(repr((len(sheet.panels), style, whole, wide, head, copies)).encode())
