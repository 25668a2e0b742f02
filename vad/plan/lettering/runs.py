"""Lines of text as runs of one face each: what is italic, what stands high or low.

The pieces of a sentence, or plain strings (``b′ₙ``, ``338.2°``), become `Run` tuples.  The letters
of symbols are italic; words, digits, units and primes are upright.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal
from unicodedata import normalize

from vad.strokes.sentences import Text
from vad.words import TextPiece

Face = Literal["roman", "italic", "bold", "bolditalic"]

_BOLD: dict[Face, Face] = {"roman": "bold", "italic": "bolditalic"}
_SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑᵢₙₚₛₜₓ", "0123456789aeinpstx", strict=True))
_SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789−", strict=True))
_LOW, _HIGH = (
    {sign: each for each, sign in signs.items()} for signs in (_SUBSCRIPTS, _SUPERSCRIPTS)
)
_TOKEN = re.compile(r"_[A-Z]+|[A-Za-zÀ-ÖØ-öø-ÿ]+|[0-9]+|[\s=.,:;()/+×·°′″-]+|.", re.DOTALL)
#: Letters with a dot above or below, which fonts do not have: ṡ.
_DOTTED = re.compile(r"[Ḁ-ỿ]")
#: One and two dots above what stands before them.
DOTS = "\N{COMBINING DOT ABOVE}\N{COMBINING DIAERESIS}"
_CAPITALS = re.compile(r"[A-Z]+")
_GREEK = re.compile(r"[α-ωΑ-Ω]")


@dataclass(frozen=True, slots=True)
class Run:
    """A stretch of one face; ``script`` is −1 for a subscript, +1 for a superscript.

    A run that is not ``shown`` still takes up its room.
    """

    text: str
    face: Face = "roman"
    script: int = 0
    shown: bool = True


Runs = tuple[Run, ...]


@lru_cache(maxsize=1024)
def roman(text: str) -> Runs:
    """Return ``text`` upright, with Greek letters in italics."""
    return _joined(_tokens(text, lambda _: False))


@lru_cache(maxsize=2048)
def said(pieces: tuple[TextPiece, ...]) -> Runs:
    """Return the pieces of a sentence: the letters of symbols are italic.

    Examples
    --------
    >>> words = TextPiece("Through "), TextPiece(": 3 ")
    >>> said((words[0], TextPiece("b", "symbol"), words[1], TextPiece("mm", "unit")))
    (Run(text='Through ', ...), Run(text='b', face='italic', ...), Run(text=': 3 mm', ...))
    """
    runs: list[Run] = []
    for text, kind in pieces:
        runs += _tokens(text, lambda _: True) if kind == "symbol" else roman(text)
    return _joined(runs)


def _tokens(text: str, italic: Callable[[str], bool]) -> list[Run]:
    """Return the tokens of a text, with Greek letters italic, and what ``italic`` picks out.

    Capitals stand low behind ``_``, as there are no signs for them: s_D, v_CB.
    """
    runs: list[Run] = []
    apart = _DOTTED.sub(lambda found: normalize("NFD", found.group()), text)
    for token in _TOKEN.findall(apart):
        runs.append(_run(token, italic, runs[-1] if runs else None))
    return runs


def _joined(runs: list[Run]) -> Runs:
    """Return runs of which no two neighbours look alike."""
    found: list[Run] = []
    for run in runs:
        last = found[-1] if found else None
        if last and (last.face, last.script) == (run.face, run.script):
            found[-1] = Run(last.text + run.text, run.face, run.script)
        else:
            found.append(run)
    return tuple(found)


def _run(token: str, italic: Callable[[str], bool], before: Run | None) -> Run:
    """Return a token as it is set after the run ``before`` it."""
    if token in DOTS and before:
        return Run(token, "roman", before.script)
    if token[0] == "_" and len(token) > 1:
        return Run(token[1:], "italic", -1)
    if token in _SUBSCRIPTS:
        letter = _SUBSCRIPTS[token]
        return Run(letter, "italic" if letter.isalpha() else "roman", -1)
    if token in _SUPERSCRIPTS:
        return Run(_SUPERSCRIPTS[token], "roman", 1)
    if _GREEK.match(token) or (token[0].isalpha() and italic(token)):
        return Run(token, "italic")
    if token.isdecimal() and before and (before.face, before.script) == ("italic", 0):
        return Run(token, "roman", -1)  # of a point: O2
    return Run(token)


def symbols(text: str) -> Runs:
    """Return a label: points and quantities italic, words upright.

    A plain string that names a line has its letters in capitals, ``⟂ BC``; in any other one, a
    word has three letters or more.
    """
    return said(text.pieces) if isinstance(text, Text) else _symbols(text)


@lru_cache(maxsize=1024)
def _symbols(text: str) -> Runs:
    if text[:1] in "∥⟂∠":
        return _joined(_tokens(text, str.isupper))
    return _joined(_tokens(text, lambda token: len(token) <= 2))


def plain(runs: Runs) -> str:
    """Return the text of runs, as it was before it was set: b′cₙ, mm/s².

    Examples
    --------
    >>> plain(roman("3005 mm/s²"))
    '3005 mm/s²'
    >>> plain(symbols("v_CB"))
    'v_CB'
    """
    text = "".join(_signs(run) for run in runs if run.shown)
    return normalize("NFC", text)


def _signs(run: Run) -> str:
    """Return the text of a run in one line, as it was before it was set."""
    text = _CAPITALS.sub(r"_\g<0>", run.text) if run.script == -1 else run.text
    signs = {-1: _LOW, 0: {}, 1: _HIGH}[run.script]
    return "".join(signs.get(letter, letter) for letter in text)


def bold(runs: Runs) -> Runs:
    """Return the same runs in bold."""
    return tuple(Run(r.text, _BOLD.get(r.face, r.face), r.script, r.shown) for r in runs)
