"""Captions as they are read out: signs that a screen reader drops become words.

Letters of points and vectors are spelt one by one: "b prime n", "omega 2 squared".  The name of a
load that has three letters or more is a word: "gas times v B".
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping

from vad.plan.lettering.runs import Run, roman, said
from vad.strokes.sheet import LOADS, Sheet
from vad.words import Language, TextPiece

#: What stands at the end of a word, without a space before it.
_MARKS = ",.;:"
#: A name of a load that is a word.
_WORD = re.compile(r"[A-Za-zÀ-ÖØ-öø-ÿ]{3,}")


def names_of_loads(sheet: Sheet) -> frozenset[str]:
    """Return the names of loads that are read as words."""
    halves = (half for panel in sheet.panels for half in panel.halves)
    labels = (stroke.label for half in halves for stroke in half.strokes if stroke.link == LOADS)
    return frozenset(found[0] for found in map(_WORD.match, labels) if found)


def spoken(pieces: tuple[TextPiece, ...], code: str, names: Collection[str] = frozenset()) -> str:
    """Return what pieces say in words of the language ``code``; ``names`` are not spelt.

    Examples
    --------
    >>> from vad.strokes.sentences import Sentence, Unit
    >>> spoken(Sentence("whole", {"label": "b′c", "value": "5", "unit": Unit("mm/s²"),
    ...     "whose": Sentence("acceleration of", {"head": "C"})}).pieces, "en")
    'b prime c equals 5 mm per second squared, the acceleration of C.'
    """
    signs = Language(code).page("SPOKEN")
    words = "".join([part for piece in pieces for part in _read(piece, signs, names)])
    text = " ".join(words.split()) + " "
    for mark in _MARKS:
        text = text.replace(f" {mark} ", f"{mark} ")
    return text.strip()


def spelled(symbol: str, code: str, names: Collection[str] = frozenset()) -> str:
    """Return what a symbol says in words of the language ``code``; ``names`` are not spelt.

    Examples
    --------
    >>> spelled("b′ₙ", "en")
    'b prime n'
    >>> spelled("gas·v_B", "en", {"gas"})
    'gas times v B'
    """
    return spoken((TextPiece(symbol, "symbol"),), code, names)


def _read(piece: TextPiece, signs: Mapping[str, str], names: Collection[str]) -> Iterator[str]:
    """Yield the words for a piece, by what it is."""
    whole = re.compile("|".join([*map(re.escape, names), "."]), re.DOTALL)
    if piece.kind == "unit":
        length, per_second, power = piece.text.partition("/s")
        yield length + (signs["/s"] if per_second else "")
        runs = roman(power)
    else:
        runs = said((piece,))
    for run in runs:
        letters = [signs.get(letter, letter) for letter in whole.findall(run.text)]
        if run.script > 0:
            yield f" {_power(''.join(letters), signs)} "
        elif _is_spelt(run, piece):
            yield f" {' '.join(letters)} "
        else:
            yield "".join(letters)


def _is_spelt(run: Run, piece: TextPiece) -> bool:
    """Tell whether letters are read one by one: those of symbols are, and Greek ones."""
    return piece.kind == "symbol" or run.face == "italic"


def _power(exponent: str, signs: Mapping[str, str]) -> str:
    return signs.get(f"^{exponent}") or signs["^"].format(exponent)
