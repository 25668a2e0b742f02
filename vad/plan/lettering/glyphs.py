"""The outlines of letters in STIX, measured by their ink.

Runs become `Typeset` lines in units of the type size.  This is the only place of the plan that uses
matplotlib: it has the glyphs of the fonts.
"""

from __future__ import annotations

import os
import threading
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.plan.lettering.runs import DOTS, Face, Runs
from vad.written import THIN_SPACE

Points = NDArray[np.float64]
Codes = NDArray[np.uint8]

MOVE, LINE, QUADRATIC, CURVE, CLOSE = 1, 2, 3, 4, 79  # the codes of matplotlib.path.Path

FILES: dict[Face, str] = {
    "roman": "STIXGeneral.ttf",
    "italic": "STIXGeneralItalic.ttf",
    "bold": "STIXGeneralBol.ttf",
    "bolditalic": "STIXGeneralBolIta.ttf",
}
SCRIPT_SIZE = 0.7
SUBSCRIPT_DROP = -0.16
SUPERSCRIPT_RISE = 0.38
PRIME_GAP = 0.03  # an italic letter leans into the prime that follows it
SLANT, DOT_GAP = 0.05, 0.06  # of dots above a letter
THIN = 0.15  # what parts thousands; the fonts have no such letter
_EM = 100.0


@dataclass(slots=True, eq=False)  # a frozen one takes several times as long to make
class Letter:
    """One letter of a line: its outline and advance, and where it stands, all in ems.

    ``text`` says which letter it is and ``face`` where its outline was found, which is upright
    for a sign that has no italic; ``size`` is less than 1 for a small one.  ``ink`` are
    the lower left and the upper right corner of what is inked.
    """

    face: Face
    text: str
    vertices: Points
    codes: Codes
    advance: float
    ink: tuple[complex, complex]
    at: complex
    size: float


@dataclass(frozen=True, eq=False)
class Typeset:
    """Glyphs of one line, in units of the type size, with the baseline's start at 0.

    ``left``, ``bottom``, ``right``, ``top`` bound the ink; ``advance`` is the pen's way.
    """

    letters: tuple[Letter, ...]
    advance: float
    left: float
    bottom: float
    right: float
    top: float

    @cached_property
    def vertices(self) -> Points:
        """The points of all outlines, which a text that is only measured does not need."""
        pieces = (each.vertices * each.size + (each.at.real, each.at.imag) for each in self._inked)
        return np.concatenate([np.zeros((0, 2)), *pieces])

    @cached_property
    def codes(self) -> Codes:
        """What each of the points is."""
        return np.concatenate([np.zeros(0, np.uint8), *(each.codes for each in self._inked)])

    @property
    def _inked(self) -> list[Letter]:
        return [each for each in self.letters if len(each.vertices)]


def font_file(face: Face) -> str:
    """Return the path of a face's font."""
    import matplotlib

    return os.path.join(matplotlib.get_data_path(), "fonts", "ttf", FILES[face])


_of_thread = threading.local()


def _font(face: Face) -> Any:
    """Return the font of a face; each thread has its own, which holds the letter loaded last."""
    from matplotlib.ft2font import FT2Font

    fonts: dict[str, Any] = _of_thread.__dict__
    if face not in fonts:
        font = FT2Font(font_file(face))
        font.set_size(_EM, 72)
        fonts[face] = font
    return fonts[face]


@lru_cache(maxsize=1024)
def _glyph(face: Face, letter: str) -> tuple[Face, Points, Codes, float, tuple[complex, complex]]:
    """Return the face that has a letter, and what a `Letter` tells of its shape there."""
    from matplotlib.ft2font import LoadFlags

    font = _font(face)
    if not font.get_char_index(ord(letter)):
        upright: Face = "bold" if face == "bolditalic" else "roman"
        return _glyph(upright, letter) if face != upright else _glyph("roman", "?")
    glyph = font.load_char(ord(letter), flags=LoadFlags.NO_HINTING)
    vertices, codes = font.get_path()
    advance = glyph.linearHoriAdvance / 65536 / _EM
    outline, kinds = np.asarray(vertices, dtype=float) / _EM, np.asarray(codes, dtype=np.uint8)
    ink = outline[kinds != CLOSE]  # a closing point carries no position
    low, high = (ink.min(axis=0), ink.max(axis=0)) if len(ink) else ((0.0, 0.0), (0.0, 0.0))
    return face, outline, kinds, advance, (complex(*low), complex(*high))


@lru_cache(maxsize=4096)
def typeset(runs: Runs) -> Typeset:
    """Return the glyph outlines of one line of text."""
    letters: list[Letter] = []
    pen = 0.0
    slanted = False
    for run in runs:
        size = SCRIPT_SIZE if run.script else 1.0
        rise = {-1: SUBSCRIPT_DROP, 0: 0.0, 1: SUPERSCRIPT_RISE}[run.script]
        for sign in run.text:
            if sign == THIN_SPACE:
                pen += THIN * size
                continue
            if sign in "′″" and slanted:
                pen += PRIME_GAP
            face, shape, kinds, advance, ink = _glyph(run.face, sign)
            letter = Letter(face, sign, shape, kinds, advance, ink, complex(pen, rise), size)
            if sign in DOTS and letters:
                letter = replace(letter, at=letter.at + _above(letter, letters[-1]))
            if run.shown:
                letters.append(letter)
            pen += letter.advance * size
            slanted = run.face in ("italic", "bolditalic")
    corners = [
        letter.at + letter.size * corner
        for letter in letters
        if len(letter.vertices)
        for corner in letter.ink
    ]
    if not corners:
        return Typeset((), pen, 0.0, 0.0, pen, 0.0)
    x, y = [corner.real for corner in corners], [corner.imag for corner in corners]
    return Typeset(tuple(letters), pen, min(x), min(y), max(x), max(y))


def _above(dots: Letter, letter: Letter) -> complex:
    """Return how far dots move that stand above a letter: aside if it slants, and clear of it."""
    if not len(letter.vertices):
        return 0j
    aside = SLANT * dots.size if letter.face in ("italic", "bolditalic") else 0.0
    low, top = dots.ink[0].imag * dots.size, letter.ink[1].imag * letter.size
    return complex(aside, max(0.0, top + DOT_GAP * dots.size - low))


def width(runs: Runs, size: float) -> float:
    """Return the advance of a line of text set in ``size``."""
    return typeset(runs).advance * size


def ink_size(runs: Runs, size: float) -> tuple[float, float]:
    """Return the width and height of the ink of a line of text."""
    shape = typeset(runs)
    return (shape.right - shape.left) * size, (shape.top - shape.bottom) * size


def fitted(runs: Runs, size: float, least: float, room: float) -> float:
    """Return the largest size between ``least`` and ``size`` at which the line fits ``room``."""
    return min(size, max(least, room / max(typeset(runs).advance, 1e-9)))
