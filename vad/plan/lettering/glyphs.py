"""The outlines of letters in STIX, measured by their ink.

In come runs, out go `Typeset` lines in units of the type size.  This is the one place of the plan
that asks matplotlib: for the glyphs of its fonts.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from functools import lru_cache
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


@dataclass(frozen=True, slots=True, eq=False)
class Letter:
    """One letter of a line: its outline and advance, and where it stands, all in ems.

    ``text`` says which letter it is and ``face`` where its outline was found, which is upright
    for a sign that has no italic; ``size`` is less than 1 for a small one.
    """

    face: Face
    text: str
    vertices: Points
    codes: Codes
    advance: float
    at: complex
    size: float


@dataclass(frozen=True, slots=True, eq=False)
class Typeset:
    """Glyphs of one line, in units of the type size, with the baseline's start at 0.

    ``left``, ``bottom``, ``right``, ``top`` bound the ink; ``advance`` is the pen's way.
    """

    vertices: Points
    codes: Codes
    advance: float
    left: float
    bottom: float
    right: float
    top: float
    letters: tuple[Letter, ...] = ()


def font_file(face: Face) -> str:
    """Return the path of a face's font."""
    import matplotlib

    return os.path.join(matplotlib.get_data_path(), "fonts", "ttf", FILES[face])


@lru_cache(maxsize=4)
def _font(face: Face) -> Any:
    from matplotlib.ft2font import FT2Font

    font = FT2Font(font_file(face))
    font.set_size(_EM, 72)
    return font


@lru_cache(maxsize=1024)
def _glyph(face: Face, letter: str) -> tuple[Face, Points, Codes, float]:
    """Return the face that has a letter, and its vertices, codes and advance there, in ems."""
    from matplotlib.ft2font import LoadFlags

    font = _font(face)
    if not font.get_char_index(ord(letter)):
        upright: Face = "bold" if face == "bolditalic" else "roman"
        return _glyph(upright, letter) if face != upright else _glyph("roman", "?")
    glyph = font.load_char(ord(letter), flags=LoadFlags.NO_HINTING)
    vertices, codes = font.get_path()
    advance = glyph.linearHoriAdvance / 65536 / _EM
    outline = np.asarray(vertices, dtype=float) / _EM
    return face, outline, np.asarray(codes, dtype=np.uint8), advance


@lru_cache(maxsize=4096)
def typeset(runs: Runs) -> Typeset:
    """Return the glyph outlines of one line of text."""
    vertices: list[Points] = []
    codes: list[Codes] = []
    letters: list[Letter] = []
    pen = 0.0
    slanted = False
    for run in runs:
        size = SCRIPT_SIZE if run.script else 1.0
        rise = {-1: SUBSCRIPT_DROP, 0: 0.0, 1: SUPERSCRIPT_RISE}[run.script]
        for letter in run.text:
            if letter == THIN_SPACE:
                pen += THIN * size
                continue
            if letter in "′″" and slanted:
                pen += PRIME_GAP
            face, shape, kind, advance = _glyph(run.face, letter)
            at = complex(pen, rise)
            if letter in DOTS:
                at += _above(shape, kind, letters[-1] if letters else None, size)
            if run.shown:
                letters.append(Letter(face, letter, shape, kind, advance, at, size))
            if len(shape) and run.shown:
                vertices.append(shape * size + (at.real, at.imag))
                codes.append(kind)
            pen += advance * size
            slanted = run.face in ("italic", "bolditalic")
    if not vertices:
        return Typeset(np.zeros((0, 2)), np.zeros(0, np.uint8), pen, 0.0, 0.0, pen, 0.0)
    whole = np.concatenate(vertices)
    kinds = np.concatenate(codes)
    ink = whole[kinds != 79]  # a closing point carries no position
    (left, bottom), (right, top) = ink.min(axis=0), ink.max(axis=0)
    return Typeset(whole, kinds, pen, left, bottom, right, top, tuple(letters))


def _above(dots: Points, codes: Codes, letter: Letter | None, size: float) -> complex:
    """Return how far dots move that stand above a letter: aside if it slants, and clear of it."""
    if letter is None or not len(letter.vertices):
        return 0j
    low = dots[codes != CLOSE][:, 1].min() * size
    top = letter.vertices[letter.codes != CLOSE][:, 1].max() * letter.size
    aside = SLANT * size if letter.face in ("italic", "bolditalic") else 0.0
    return complex(aside, max(0.0, top + DOT_GAP * size - low))


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
