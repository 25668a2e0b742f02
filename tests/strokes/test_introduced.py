"""A caption uses no letter and no symbol that was not drawn or said before, or is in that step."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest

import vad
from tests.kinds import KINDS
from vad.lecture.telling import told, told_together
from vad.strokes.sheet import Arrow, Panel, Sheet, Stroke
from vad.words import text_of

#: A letter with its marks: A, O2, b′, c″ₙ, 4ₙ, θ₄, ω₄₂, τ̇₃, ψ_P.
_SYMBOL = re.compile(r"[^\W\d_][\u0307\u0308]?(?:_[A-Z]|[₀-₉]|[0-9])*[′″]*[ₙₜ]?[₀-₉]*")
#: The axis from which angles are measured, and those of the page.
AXES = {"x", "y"}
#: What a polygon measures of a body has its index, and begins so.
RATES = {"θ": "ωα", "ω": "α", "τ": "", "s": "", "x": "va", "y": "va", "l": "va", "v": "a"}


def symbols(text: str) -> list[str]:
    """Return the symbols in a run of letters: of ω₄₂·AH three."""
    return _SYMBOL.findall(text.replace("\u1e23", "h\u0307").replace("\u1e61", "s\u0307"))


def steps(sheet: Sheet) -> Iterator[tuple[Panel, tuple[Stroke, ...], str, list[str]]]:
    """Yield each step of a lecture: panel, strokes, what is said, and the symbols in it.

    The ends of a link stand in the table.
    """
    links = {row.letters for row in sheet.rows if len(row.letters) > 1}
    for panel in sheet.halves:
        for first, last in told_together(panel):
            pieces = told(panel, first, last)
            runs = [piece.text for piece in pieces if piece.kind == "symbol"]
            used = [each for run in runs if run not in links for each in symbols(run)]
            yield panel, panel.strokes[first : last + 1], text_of(pieces), used


def drawn(stroke: Stroke) -> set[str]:
    """Return the letters that a stroke writes, and those at its ends."""
    found = set(symbols(stroke.label))
    if isinstance(stroke.shape, Arrow):
        found.update(symbols(f"{stroke.shape.tail} {stroke.shape.head}"))
    return found


#: The ways to say what a symbol is: s = 5 mm, "turns at τ̇", "the direction of α₄₂ₜ", "Q, the pin".
_SAYS = re.compile(
    r"(\S+) = |(?:at|direction of|of the rocker,) ([^\s,.;]+)|: (v) turned|"
    r"(\S+) of (?:shaft|the c)|(\S+), the pin|(\S+) slides along this guide|"
    r"Below, (\S+) is|Again ([^\s,]+)|over (\S+) and ([^\s;]+);|"
    r"The \S+ (\S+) stands at"
)


def said(text: str) -> set[str]:
    """Return the symbols of which a caption says what they are."""
    return {each for ways in _SAYS.findall(text) for run in ways for each in symbols(run)}


@pytest.mark.exhaustive(32)
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_no_letter_is_used_before_it_is_drawn_or_said(kind: Any):
    sheet = vad.draw(vad.solve(kind()))
    known = set(AXES)
    for row in sheet.rows:
        known |= {cell.symbol for cells in row.cells.values() for cell in cells if cell.given}
    for panel, strokes, text, used in steps(sheet):
        known = known.union(said(text), *map(drawn, strokes))
        for symbol in used:
            assert symbol in known or follows(symbol, known, panel), (symbol, text)


def follows(symbol: str, known: set[str], panel: Panel) -> bool:
    """Tell whether a symbol follows from known ones: b′ in a polygon from B, α₃ from θ₃."""
    letter, index = symbol[0], symbol[1:].strip("\u0307\u0308ₜ")
    if panel.picture == "vectors" and letter.upper() + index.strip("′″ₙ") in known:
        return True
    return any(f"{each}{index}" in known for each, rates in RATES.items() if letter in rates)
