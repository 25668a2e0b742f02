"""Lines of text as runs of one face each: what is italic, what stands high or low.

In come plain strings (``b′ₙ``, ``338.2°``, a caption), out go `Run` tuples.  Points and
quantities are italic; words, digits, units and primes are upright.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from string import ascii_uppercase
from typing import Literal
from unicodedata import normalize

Face = Literal["roman", "italic", "bold", "bolditalic"]

_BOLD: dict[Face, Face] = {"roman": "bold", "italic": "bolditalic"}
_SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉ₐₑₙₚₛₜₓ", "0123456789aenpstx", strict=True))
_SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789−", strict=True))
_LOW, _HIGH = (
    {sign: each for each, sign in signs.items()} for signs in (_SUBSCRIPTS, _SUPERSCRIPTS)
)
_TOKEN = re.compile(r"_[A-Z]|[A-Za-zÀ-ÖØ-öø-ÿ]+|[0-9]+|[\s=.,:;()/+×·°′″-]+|.", re.DOTALL)
#: Letters with a dot above or below, which fonts do not have: ṡ.
_DOTTED = re.compile(r"[Ḁ-ỿ]")
#: One and two dots above what stands before them.
DOTS = "\N{COMBINING DOT ABOVE}\N{COMBINING DIAERESIS}"
_GREEK = re.compile(r"[α-ωΑ-Ω]")


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


@lru_cache(maxsize=1024)
def roman(text: str) -> Runs:
    """Return ``text`` upright, but for Greek letters."""
    return slanted(text, lambda _: False)


def slanted(text: str, italic: Callable[[str], bool]) -> Runs:
    """Return ``text`` with Greek letters italic, and what ``italic`` picks out.

    A capital stands low behind ``_``, which there is no sign for: s_D.
    """
    runs: list[Run] = []
    apart = _DOTTED.sub(lambda found: normalize("NFD", found.group()), text)
    for token in _TOKEN.findall(apart):
        run = _run(token, italic, runs[-1] if runs else None)
        if runs and (runs[-1].face, runs[-1].script) == (run.face, run.script):
            runs[-1] = Run(runs[-1].text + run.text, run.face, run.script)
        else:
            runs.append(run)
    return tuple(runs)


def _run(token: str, italic: Callable[[str], bool], before: Run | None) -> Run:
    """Return a token as it is set behind the run ``before`` it."""
    if token in DOTS and before:
        return Run(token, "roman", before.script)
    if token[0] == "_" and len(token) == 2:
        return Run(token[1], "italic", -1)
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


@lru_cache(maxsize=1024)
def symbols(text: str) -> Runs:
    """Return a label: points and quantities italic, words upright.

    A word has three letters or more, or small letters behind a sign: "of" in "∥ guide of A".
    """
    if text[:1] in "∥⟂∠":
        return slanted(text, str.isupper)
    return slanted(text, lambda token: len(token) <= 2)


def sentence(text: str, names: Iterable[str], words: str = "") -> Runs:
    """Return a caption, in which the ``names`` of points, vectors and quantities are italic.

    Units after a number or a stroke (m/s) stay upright, and so do the ``words`` of a language
    that are also names, by a pattern: "a" before a word, in English.
    """
    known = set(names)
    upright = r"(?<=/)s(?![A-Za-z])|(?<=[0-9⁰-⁹¹²³] )(?:mm|cm|ft|in|m)\b"
    if words:
        upright += rf"|\b(?:{words})"
    pieces: list[Run] = []
    start = 0
    for found in re.finditer(upright, text):
        pieces += slanted(text[start : found.start()], known.__contains__)
        pieces.append(Run(found.group()))
        start = found.end()
    pieces += slanted(text[start:], known.__contains__)
    return tuple(pieces)


def plain(runs: Runs) -> str:
    """Return what runs spell, as it was before it was set: b′cₙ, mm/s².

    Examples
    --------
    >>> plain(roman("3005 mm/s²"))
    '3005 mm/s²'
    """
    signs = {-1: _LOW | {letter: f"_{letter}" for letter in ascii_uppercase}, 0: {}, 1: _HIGH}
    text = "".join(
        signs[run.script].get(letter, letter) for run in runs if run.shown for letter in run.text
    )
    return normalize("NFC", text)


def bold(runs: Runs) -> Runs:
    """Return the same runs in bold."""
    return tuple(Run(r.text, _BOLD.get(r.face, r.face), r.script, r.shown) for r in runs)
