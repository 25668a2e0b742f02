"""Captions as they are read out: signs that a screen reader drops become words.

Letters of points and vectors are spelt one by one: "b prime n", "omega 2 squared".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from vad.plan.lettering.runs import Run, roman, said
from vad.words import Language, TextPiece

#: What stands at the end of a word, without a space before it.
_MARKS = ",.;:"


def spoken(pieces: tuple[TextPiece, ...], code: str) -> str:
    """Return what pieces say in words of the language ``code``.

    Examples
    --------
    >>> from vad.strokes.sentences import Sentence, Unit
    >>> spoken(Sentence("whole", {"label": "b′c", "value": "5", "unit": Unit("mm/s²"),
    ...     "whose": Sentence("acceleration of", {"head": "C"})}).pieces, "en")
    'b prime c equals 5 mm per second squared, the acceleration of C.'
    """
    signs = Language(code).page("SPOKEN")
    words = "".join([part for piece in pieces for part in _read(piece, signs)])
    text = " ".join(words.split()) + " "
    for mark in _MARKS:
        text = text.replace(f" {mark} ", f"{mark} ")
    return text.strip()


def spelled(symbol: str, code: str) -> str:
    """Return what a symbol says in words of the language ``code``.

    Examples
    --------
    >>> spelled("b′ₙ", "en")
    'b prime n'
    """
    return spoken((TextPiece(symbol, "symbol"),), code)


def _read(piece: TextPiece, signs: Mapping[str, str]) -> Iterator[str]:
    """Yield the words for a piece, by what it is."""
    if piece.kind == "unit":
        length, per_second, power = piece.text.partition("/s")
        yield length + (signs["/s"] if per_second else "")
        runs = roman(power)
    else:
        runs = said((piece,))
    for run in runs:
        letters = [signs.get(letter, letter) for letter in run.text]
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
