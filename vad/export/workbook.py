"""Workbooks of Excel: sheets with bold heads that stay in sight, made by XlsxWriter."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from datetime import datetime
from typing import Any, BinaryIO

from vad.discovery import from_extra
from vad.export.files import temporary_folder

#: The least and the most characters that a column is wide.
_NARROW, _WIDE = 10, 40
#: The same workbook is the same file at any time.
_MADE = datetime(2000, 1, 1)


@contextmanager
def workbook(target: BinaryIO, title: str) -> Iterator[Workbook]:
    """Yield a workbook that is written to a binary file when the block ends without error.

    Its lines wait in a temporary folder, so that a long sheet takes no more memory than a short
    one.

    Raises
    ------
    vad.errors.InputError
        If XlsxWriter, the extra ``excel``, is not installed.
    """
    library = from_extra("xlsxwriter", "excel")
    with temporary_folder() as folder:
        book = library.Workbook(target, {"constant_memory": True, "tmpdir": str(folder)})
        book.set_properties({"title": title, "created": _MADE})
        yield Workbook(book)
        book.close()


class Workbook:
    """A workbook to which sheets are added; made by `workbook`."""

    def __init__(self, book: Any) -> None:
        self._book = book
        self._bold = book.add_format({"bold": True})

    def sheet(self, name: str, heads: Sequence[str], rows: Iterable[Iterable[object]]) -> None:
        """Add a sheet: a number as a number, NaN and None as an empty cell, all others as text.

        Texts stay texts, whatever they begin with: nothing from outside is a formula or a link.
        """
        sheet = self._book.add_worksheet(name)
        for column, head in enumerate(heads):
            sheet.set_column(column, column, min(max(len(head) + 2, _NARROW), _WIDE))
            sheet.write_string(0, column, head, self._bold)
        for line, row in enumerate(rows, start=1):
            for column, value in enumerate(row):
                if isinstance(value, int | float):
                    if math.isfinite(value):
                        sheet.write_number(line, column, value)
                elif value is not None:
                    sheet.write_string(line, column, str(value))
        sheet.freeze_panes(1, 0)
