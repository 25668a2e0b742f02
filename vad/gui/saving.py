"""Files that are saved from the page: in comes a question, out come bytes and a name.

They are made in a folder of their own that is gone afterwards; no request names a path.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from threading import Event

import vad
from vad.errors import ExportError
from vad.gui.messages import ExportQuestion

#: Set when the server is to end.
Closing = Event

#: The extensions of pictures; and what any file is, by its extension.
PICTURES = ("png", "svg", "pdf")
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
    name = f"{mechanism.name}.{extension}"

    def heed(_done: int, _total: int) -> None:
        if closing.is_set():
            raise ExportError("the server is ending")

    with tempfile.TemporaryDirectory(prefix="vad-") as folder:
        path = Path(folder, name)
        if extension == "json":
            vad.save(sheet, path)
        elif extension in PICTURES:
            vad.save(sheet, path, style=question.style, size=question.size)
        else:
            film = vad.animate(sheet, question.fps, question.size, question.speed, question.style)
            vad.save(film, path, progress=heed)
        return path.read_bytes(), name
