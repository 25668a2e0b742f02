"""How a notebook displays sheets, lessons and turns.

A thing is given in several forms, and a viewer takes the best one that it knows: SVG for drawings,
HTML for lessons and films, and for other viewers a PNG and words.  All outputs of a notebook are on
one page; therefore the names in a drawing are unique, and a lesson has a frame of its own.
"""

from __future__ import annotations

import io
import sys
from base64 import b64encode
from collections.abc import Callable, Container
from dataclasses import replace
from functools import cache
from hashlib import sha256
from html import escape
from typing import Any

from vad.displayed import Displayed
from vad.export import picture_png, save
from vad.export.files import temporary_folder
from vad.lecture.lesson import SMALLEST, Lesson, Still
from vad.lecture.turn import Turn
from vad.page.document import document
from vad.painting.posed import Posed, posed
from vad.painting.svg_painter import SvgPainter
from vad.strokes.description import describe, title
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet

Thing = Sheet | Lesson | Turn | Still | Multiples

#: A film in a cell: its width in pixels, as that of a column of text; the most bytes that it may
#: add to the notebook; and the most pictures, beyond which it would have more bytes.
_WIDTH, _HEAVIEST, _LONGEST = 960, 1_000_000, 400


def bundle(
    thing: Displayed, include: Container[str] | None = None, exclude: Container[str] | None = None
) -> dict[str, str]:
    """Return a thing in every form that a viewer may know, by its MIME type; pixels in base64.

    ``include`` names the only types that are wanted, ``exclude`` those that are not.  A shell in a
    terminal gets words alone.
    """
    assert isinstance(thing, Thing)
    page = Still(thing, len(thing.steps)) if isinstance(thing, Lesson) else thing
    picture = cache(lambda: posed(page))
    forms: dict[str, Callable[[], str]] = {
        "text/plain": lambda: _words(thing),
        "image/png": lambda: _pixels(picture()),
    }
    if isinstance(thing, Lesson):
        forms["text/html"] = lambda: _framed(thing)
    elif isinstance(thing, Turn):
        forms["text/html"] = lambda: _film(thing, lambda: _pixels(picture()))
    else:
        forms["image/svg+xml"] = lambda: _drawing(thing, picture())
    if _shell() and not in_notebook():
        include = {"text/plain"}
    return {
        kind: form()
        for kind, form in forms.items()
        if (include is None or kind in include) and (exclude is None or kind not in exclude)
    }


def _shell() -> Any:
    """Return the interactive shell that runs this program, if one does."""
    python = sys.modules.get("IPython")
    return python and python.get_ipython()


def in_notebook() -> bool:
    """Tell whether this program runs in a notebook rather than in a terminal."""
    return getattr(_shell(), "kernel", None) is not None


def _words(thing: Thing) -> str:
    match thing:
        case Multiples():
            sheets = thing.sheets
        case Still():
            sheets = (thing.drawn,)
        case Sheet():
            sheets = (thing,)
        case _:
            sheets = (thing.sheet,)
    return "\n".join((title(sheets[0]), *map(describe, sheets)))


def _pixels(picture: Posed) -> str:
    target = io.BytesIO()
    picture_png.encode(picture, target)
    return b64encode(target.getvalue()).decode()


def _drawing(thing: Thing, picture: Posed) -> str:
    """Return a drawing whose text is shapes: many viewers load no fonts out of a page."""
    scope = "v" + sha256(repr(thing).encode()).hexdigest()[:12]
    painter = SvgPainter(picture.sheet, "glyphs", picture.description, scope)
    picture.play(painter)
    return painter.svg


def _framed(lesson: Lesson) -> str:
    """Return a page in a frame that has no access to the notebook."""
    return (
        f'<iframe sandbox="allow-scripts" allow="fullscreen" title="{escape(title(lesson.sheet))}" '
        'style="width:100%;aspect-ratio:1280/835;border:0" '
        f'srcdoc="{escape(document(lesson))}"></iframe>'
    )


def _film(turn: Turn, pixels: Callable[[], str]) -> str:
    """Return a small film that repeats, or a picture if the film would have too many bytes."""
    name = f'style="width:100%" aria-label="{escape(title(turn.sheet))}"'
    film = _small(turn) if turn.frames <= _LONGEST else b""
    if film and len(film) <= _HEAVIEST:
        src = f"data:video/mp4;base64,{b64encode(film).decode()}"
        return f'<video controls loop muted playsinline {name} src="{src}"></video>'
    picture = f'<img role="img" {name} src="data:image/png;base64,{pixels()}">'
    return picture + '<p>The film is long: <code>vad.save(turn, "turn.mp4")</code></p>'


def _small(turn: Turn) -> bytes:
    """Return a turn as a film no wider than a column of text."""
    width, height = turn.size
    scale = min(1.0, max(_WIDTH / width, SMALLEST[1] / height))
    size = 2 * round(scale * width / 2), 2 * round(scale * height / 2)
    with temporary_folder() as folder:
        path = folder / "turn.mp4"
        save(replace(turn, size=size), path)
        return path.read_bytes()
