"""The window as a page: in comes what is set when it opens, out goes HTML with all it needs."""

from __future__ import annotations

import json
import string
from collections.abc import Mapping
from functools import cache
from html import escape
from importlib.resources import files
from string import Template

from vad.gui.messages import ExportQuestion
from vad.gui.saving import MEDIA
from vad.gui.settable import entry
from vad.page.document import asset, colours, player
from vad.page.themed import themes
from vad.painting.svg_text import FACES, Faces
from vad.strokes.diagrams import DIAGRAMS
from vad.strokes.draw import chosen
from vad.style import load_style
from vad.words import Language, languages

#: The parts of its script, in order.
SCRIPTS = (
    "window.js",
    "controls.js",
    "questions.js",
    "stage.js",
    "hand.js",
    "address.js",
    "buttons.js",
)
#: What may be written of mechanisms that are yet to be set.
_LETTERS = string.digits + string.ascii_letters + string.punctuation + " \u00a0"
_SIGNS = "ÄÖÜäöüßÀÉàâçéèêëîïôùûœ’«»−×·°′″⟂∥²³→…–₀₁₂₃₄₅₆₇₈₉αβγδθλμπρφψωΔΩ"


def window(start: ExportQuestion, nonce: str, head: str = "") -> str:
    """Return the page of the window; its script bears the ``nonce`` without which it would not run.

    ``head`` is what else stands in its head.

    Raises
    ------
    vad.errors.UsageError
        For a language, style or panel that there is not.
    """
    code, say = start.language, Language(start.language)
    texts, own = say.page("WINDOW"), say.page("PLAYER")
    inks = len(load_style(start.style).inks)
    titles = [say.name(DIAGRAMS[name].title) for name in chosen(start.panels or None)]
    opening = {name: value for name, value in vars(start).items() if name != "kinds"}
    entries = {name: entry(kind, code) for name, kind in start.kinds.items()}
    data = {"start": opening, "catalogue": entries, "words": texts}
    return Template(_file("window.html")).substitute(
        {name: escape(text) for name, text in texts.items()},
        lang=code,
        nonce=nonce,
        head=head,
        style=start.style,
        themes=" ".join(style.name for style in themes(load_style(start.style))),
        rules=_faces() + asset("player.css") + _file("window.css") + colours(start.style, inks),
        player=player(code, titles),
        strokes=escape(own["strokes"]),
        mechanisms=_options({name: each["title"] for name, each in entries.items()}),
        languages=_options({each: each.upper() for each in languages()}),
        formats="".join(_button(extension) for extension in MEDIA),
        data=json.dumps(data, ensure_ascii=False).replace("<", "\\u003c"),
        script=asset("player.js") + "".join(map(_file, SCRIPTS)),
    )


def _options(names: Mapping[str, str]) -> str:
    return "".join(
        f'<option value="{escape(name)}">{escape(text)}</option>' for name, text in names.items()
    )


def _button(extension: str) -> str:
    return f'<button type="button" data-save="{extension}">{extension.upper()}</button>'


@cache
def _faces() -> str:
    """Return the rules of the fonts."""
    faces = Faces()
    for face in FACES:
        faces.add(face, _LETTERS + _SIGNS)
    return faces.rules()


def _file(name: str) -> str:
    return (files(__package__) / name).read_text("utf-8")
