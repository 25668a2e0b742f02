"""How a notebook displays sheets, lessons and turns.

A thing is given in several forms, and a viewer takes the best one that it knows: SVG for drawings,
HTML for lessons and turns, and for other viewers a PNG and words.  All outputs of a notebook are on
one page; therefore the names in a drawing are unique, and lessons and turns have a frame each.
"""

from __future__ import annotations

import io
import sys
from base64 import b64encode
from collections.abc import Callable, Container
from functools import cache
from hashlib import sha256
from html import escape
from typing import Any

from vad.displayed import Displayed
from vad.export import picture_png
from vad.lecture.lesson import Lesson, Still, animate
from vad.lecture.turn import Turn
from vad.page.document import document
from vad.painting.posed import Posed, posed
from vad.painting.svg_painter import SvgPainter
from vad.strokes.description import describe, title
from vad.strokes.multiples import Multiples
from vad.strokes.sheet import Sheet

Thing = Sheet | Lesson | Turn | Still | Multiples


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
        forms["text/html"] = lambda: _framed(animate(thing.given, style=thing.style), True)
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
    told = (type(thing), picture.description, picture.style, picture.board.form, picture.moment)
    scope = "v" + sha256(repr(told).encode()).hexdigest()[:12]
    painter = SvgPainter(picture.sheet, "glyphs", picture.description, scope)
    picture.play(painter)
    return painter.svg


def _framed(lesson: Lesson, turning: bool = False) -> str:
    """Return a page in a frame that has no access to the notebook."""
    page = document(lesson, len(lesson.steps) if turning else 0, turning=turning)
    return (
        f'<iframe sandbox="allow-scripts" allow="fullscreen" title="{escape(title(lesson.sheet))}" '
        'style="width:100%;aspect-ratio:1280/835;border:0" '
        f'srcdoc="{escape(page)}"></iframe>'
    )
