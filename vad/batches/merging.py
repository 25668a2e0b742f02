"""One PDF of all sheets of a batch, with bookmarks; made with pypdf, the extra ``merge``."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from vad import gate
from vad.batches.job import Done
from vad.batches.roster import in_file_name, in_title
from vad.discovery import from_extra
from vad.errors import UsageError, quoted
from vad.export.files import new_file

_KIND = ".pdf"


def check_merged(path: str | os.PathLike[str]) -> None:
    """Check, before anything is made, that a merged file can be.

    Raises
    ------
    vad.errors.UsageError
        If the path does not end in .pdf.
    vad.errors.InputError
        If pypdf is not installed.
    """
    if Path(gate.path("merge", path)).suffix.lower() != _KIND:
        raise UsageError(f"merge: must be a PDF, got {quoted(os.fspath(path))}", "as in class.pdf")
    from_extra("pypdf", "merge")


def merged(sheets: Iterable[Done], path: str | os.PathLike[str]) -> None:
    """Write the pages of all PDF files of some sheets to one file.

    First come the files of one name, such as all problems, then those of the next one.  Each name
    is a bookmark, with one for each sheet below it.

    Raises
    ------
    vad.errors.UsageError
        If none of the sheets has a PDF.
    vad.errors.ExportError
        If it cannot be written.
    """
    library: Any = from_extra("pypdf", "merge")
    found: dict[str, list[tuple[str, Path]]] = {}
    for done in sheets:
        roster = done.answers.get("roster", {})
        whose, part = in_title(roster), f"{in_file_name(roster)}-"
        title = " ".join(filter(None, (str(done.number), whose)))
        for file in done.files:
            if file.suffix.lower() == _KIND:
                name = file.name.partition("-")[2].removeprefix(part)
                found.setdefault(name, []).append((title, file))
    if not found:
        raise UsageError("merge: no sheet has a PDF", 'as in files = ["problem.pdf", "key.pdf"]')
    writer = library.PdfWriter()
    for name, files in found.items():
        above = None
        for title, file in files:
            page = len(writer.pages)
            writer.append(str(file), import_outline=False)
            above = above or writer.add_outline_item(
                title=name.removesuffix(_KIND), page_number=page
            )
            writer.add_outline_item(title=title, page_number=page, parent=above)
    with new_file(path) as stream:
        writer.write(stream)
