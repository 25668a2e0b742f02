"""Files that are saved from the page: in comes a question, out come bytes and a name.

They are made in a folder of their own that is gone afterwards; no request names a path.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from threading import Event

import vad
from vad.errors import ExportError
from vad.export import FORMATS
from vad.gui.messages import ExportQuestion
from vad.strokes.sheet import Sheet

#: Set when the server is to end.
Closing = Event

#: What a file is, by its extension.
MEDIA = {
    "png": "image/png",
    "svg": "image/svg+xml",
    "pdf": "application/pdf",
    "json": "application/json",
    "mp4": "video/mp4",
    "gif": "image/gif",
    "html": "text/html",
}


def saved(question: ExportQuestion, extension: str, closing: Closing) -> tuple[bytes, str]:
    """Return the bytes of a file, and what it is called.

    Raises
    ------
    vad.errors.VadError
        For what cannot be drawn or saved.
    """
    mechanism, inputs = question.build()
    panels = question.panels or None
    sheet = vad.draw(vad.solve(mechanism, **inputs), panels, question.language)
    name = f"{question.mechanism}.{extension}"

    def heed(_done: int, _total: int) -> None:
        if closing.is_set():
            raise ExportError("the server is ending")

    with tempfile.TemporaryDirectory(prefix="vad-") as folder:
        path = Path(folder, name)
        if f".{extension}" in FORMATS[Sheet] and extension != "html":
            vad.save(sheet, path, **({} if extension == "json" else question.look))
        else:
            lesson = vad.animate(sheet, fps=question.fps, speed=question.speed, **question.look)
            vad.save(lesson, path, **({} if extension == "html" else {"progress": heed}))
        return path.read_bytes(), name
