"""Words of a page: in come runs, out goes HTML in the board's own faces."""

from __future__ import annotations

from html import escape

from vad.painting.svg_text import Faces
from vad.plan.lettering.runs import Runs, bold

_ITALIC = ("italic", "bolditalic")
_SCRIPTS = {-1: "sub", 0: "", 1: "sup"}


class Words:
    """Writes runs, and notes down the letters that their fonts need."""

    def __init__(self, faces: Faces) -> None:
        self._faces = faces

    def of(self, runs: Runs, *, light: bool = True, heavy: bool = False) -> str:
        """Return runs as HTML; ``heavy`` and ``light`` say where the page sets them bold or not."""
        for each in (*(runs if light else ()), *(bold(runs) if heavy else ())):
            self._faces.add(each.face, each.text)
        text = ""
        for run in runs:
            words = escape(run.text)
            words = f"<i>{words}</i>" if run.face in _ITALIC else words
            script = _SCRIPTS[run.script]
            text += f"<{script}>{words}</{script}>" if script else words
        return text.replace("</i><i>", "").replace("</sub><sub>", "")
