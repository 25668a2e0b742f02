"""Type: strings become glyph outlines in STIX, measured by their ink.

In come plain strings (``b′ₙ``, ``338.2°``, a caption), out go `Run` tuples, and from these
`Outline` objects in units of the type size and marks on the page.  Points and quantities are
italic; words, digits, units and primes are upright.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Literal

import numpy as np

from vad.plan.marks import Codes, Letter, Mark, Pen, Points, Setting

Face = Literal["roman", "italic", "bold", "bolditalic"]
Align = Literal["left", "centre", "right"]

_FILES: dict[Face, str] = {
    "roman": "STIXGeneral.ttf",
    "italic": "STIXGeneralItalic.ttf",
    "bold": "STIXGeneralBol.ttf",
    "bolditalic": "STIXGeneralBolIta.ttf",
}
_BOLD: dict[Face, Face] = {"roman": "bold", "italic": "bolditalic"}
_SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑₙₚₛₜₓ", "0123456789aenpstx", strict=True))
_SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789−", strict=True))
_TOKEN = re.compile(r"[A-Za-zÀ-ÖØ-öø-ÿ]+|.", re.DOTALL)
# Words part at a space, unless it stands between a number and its unit.
_BREAK = re.compile(r"(?<![0-9⁰¹²³⁴⁵⁶⁷⁸⁹]) | (?!(?:mm|cm|km|m|in|ft|yd|rad)\b)")
_GREEK = re.compile(r"[α-ωΑ-Ω]")

SCRIPT_SIZE = 0.7
SUBSCRIPT_DROP = -0.16
SUPERSCRIPT_RISE = 0.38
PRIME_GAP = 0.03  # an italic letter leans into the prime that follows it
_EM = 100.0


@dataclass(frozen=True, slots=True)
class Run:
    """A stretch of one face; ``script`` is −1 for a subscript, +1 for a superscript.

    What is not ``shown`` takes up its room all the same.
    """

    text: str
    face: Face = "roman"
    script: int = 0
    shown: bool = True


Runs = tuple[Run, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Outline:
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


def roman(text: str, italic: Callable[[str], bool] = lambda _: False) -> Runs:
    """Return ``text`` upright, but for Greek letters and what ``italic`` picks out."""
    runs: list[Run] = []
    for token in _TOKEN.findall(text):
        if token in _SUBSCRIPTS:
            letter = _SUBSCRIPTS[token]
            runs.append(Run(letter, "italic" if letter.isalpha() else "roman", -1))
        elif token in _SUPERSCRIPTS:
            runs.append(Run(_SUPERSCRIPTS[token], "roman", 1))
        elif _GREEK.match(token) or (token[0].isalpha() and italic(token)):
            runs.append(Run(token, "italic"))
        else:
            runs.append(Run(token))
    return tuple(runs)


def symbols(text: str) -> Runs:
    """Return a label: points and quantities italic, words upright.

    A word has three letters or more, or small letters behind a sign: "of" in "∥ guide of A".
    """
    if text[:1] in "∥⟂":
        return roman(text, str.isupper)
    return roman(text, lambda token: len(token) <= 2)


def sentence(text: str, names: Iterable[str], article: str = "") -> Runs:
    """Return a caption, in which the ``names`` of points, vectors and quantities are italic.

    Units after a stroke (mm/s) stay upright, and so does the ``article`` of a language that is
    also the name of a point: "a" before a word, in English.
    """
    known = set(names)
    upright = r"(?<=/)s(?![A-Za-z])"
    if article:
        upright += rf"|\b{article}(?= [a-zà-ÿ]{{3,}})"
    pieces: list[Run] = []
    start = 0
    for found in re.finditer(upright, text):
        pieces += roman(text[start : found.start()], known.__contains__)
        pieces.append(Run(found.group()))
        start = found.end()
    pieces += roman(text[start:], known.__contains__)
    return tuple(pieces)


def bold(runs: Runs) -> Runs:
    """Return the same runs in bold."""
    return tuple(replace(r, face=_BOLD.get(r.face, r.face)) for r in runs)


@lru_cache(maxsize=4)
def _font(face: Face) -> Any:
    import matplotlib
    from matplotlib.ft2font import FT2Font

    font = FT2Font(os.path.join(matplotlib.get_data_path(), "fonts", "ttf", _FILES[face]))
    font.set_size(_EM, 72)
    return font


@lru_cache(maxsize=1024)
def _glyph(face: Face, letter: str) -> tuple[Points, Codes, float]:
    """Return vertices, codes and advance of one letter, in units of the type size."""
    from matplotlib.ft2font import LoadFlags

    font = _font(face)
    if not font.get_char_index(ord(letter)):
        upright: Face = "bold" if face == "bolditalic" else "roman"
        return _glyph(upright, letter) if face != upright else _glyph("roman", "?")
    glyph = font.load_char(ord(letter), flags=LoadFlags.NO_HINTING)
    vertices, codes = font.get_path()
    advance = glyph.linearHoriAdvance / 65536 / _EM
    return np.asarray(vertices, dtype=float) / _EM, np.asarray(codes, dtype=np.uint8), advance


@lru_cache(maxsize=4096)
def outline(runs: Runs) -> Outline:
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
            if letter in "′″" and slanted:
                pen += PRIME_GAP
            shape, kind, advance = _glyph(run.face, letter)
            if run.shown:
                at = complex(pen, rise)
                letters.append(Letter(run.face, letter, shape, kind, advance, at, size))
            if len(shape) and run.shown:
                vertices.append(shape * size + (pen, rise))
                codes.append(kind)
            pen += advance * size
            slanted = run.face in ("italic", "bolditalic")
    if not vertices:
        return Outline(np.zeros((0, 2)), np.zeros(0, np.uint8), pen, 0.0, 0.0, pen, 0.0)
    whole = np.concatenate(vertices)
    kinds = np.concatenate(codes)
    ink = whole[kinds != 79]  # a closing point carries no position
    (left, bottom), (right, top) = ink.min(axis=0), ink.max(axis=0)
    return Outline(whole, kinds, pen, left, bottom, right, top, tuple(letters))


def width(runs: Runs, size: float) -> float:
    """Return the advance of a line of text set in ``size`` pixels."""
    return outline(runs).advance * size


def write(
    runs: Runs,
    at: complex,
    size: float,
    ink: str,
    align: Align = "left",
    alpha: float = 1.0,
    halo: Pen | None = None,
) -> list[Mark]:
    """Return the marks of a line of text whose baseline starts, is centred or ends at ``at``."""
    shape = outline(runs)
    if not len(shape.vertices):
        return []
    shift = {"left": 0.0, "centre": 0.5, "right": 1.0}[align] * shape.advance * size
    start = at - shift
    vertices = shape.vertices * size + (start.real, start.imag)
    vertices[shape.codes == 79] = vertices[0]
    text = Setting(shape.letters, start, size)
    marks = [Mark(vertices, shape.codes, None, ink, alpha, text)]
    if halo:
        marks.insert(0, Mark(vertices, shape.codes, halo, None, 1.0))
    return marks


def fitted(runs: Runs, size: float, least: float, room: float) -> float:
    """Return the largest size between ``least`` and ``size`` at which the line fits ``room``."""
    return min(size, max(least, room / max(outline(runs).advance, 1e-9)))


def wrap(text: str, setter: Callable[[str], Runs], size: float, room: float) -> list[Runs]:
    """Break ``text`` between words into as few lines as fit ``room``, evenly filled.

    A number stays with its unit.
    """
    words = _BREAK.split(text)
    widths = [width(setter(word), size) for word in words]
    space = 0.25 * size
    total = sum(widths) + space * (len(words) - 1)
    if total <= room:
        return [setter(text)]
    fewest = len(_filled(words, widths, space, room))
    goals = [min(room, filled * total / fewest) for filled in (1.12, 1.2, 1.3, 1.4)]
    for goal in (*goals, room):
        lines = _filled(words, widths, space, goal)
        if len(lines) == fewest:
            break
    return [setter(" ".join(line)) for line in lines]


def _filled(words: list[str], widths: list[float], space: float, goal: float) -> list[list[str]]:
    """Return the words in lines, each as long as ``goal`` allows."""
    lines: list[list[str]] = [[]]
    used = 0.0
    for word, wide in zip(words, widths, strict=True):
        if lines[-1] and used + space + wide > goal:
            lines.append([])
            used = 0.0
        used += wide + (space if lines[-1] else 0.0)
        lines[-1].append(word)
    return lines
