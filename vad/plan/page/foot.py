"""The loop equation under a panel, each term in the ink of its link.

In come a panel's equations and the width that they may take, out go their terms in their places.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import Runs, roman, symbols
from vad.plan.lettering.wrapping import wrap
from vad.plan.marks import Lettering
from vad.strokes.sentences import pieces_of
from vad.strokes.sheet import Equation, Panel, Term

SIZE = 0.036
LEAST = 0.034  # below this a loop takes two lines
SPACE = 0.24  # about a sign, in type sizes
LOOP_SPACE = 1.3
REMARK_SIZE = 0.030


@dataclass(frozen=True, slots=True)
class Piece:
    """A term or a sign, with the space before it in type sizes, of a ``half`` of a panel."""

    runs: Runs
    term: Term | None
    space: float
    half: str


@dataclass(frozen=True, slots=True)
class Foot:
    """What stands under one panel: its remark in lines, then its equations and their type size."""

    lines: tuple[tuple[Piece, ...], ...]
    size: float
    remark: tuple[Runs, ...] = ()

    @property
    def count(self) -> int:
        """The number of all lines."""
        return len(self.remark) + len(self.lines)


def _sum(terms: Sequence[Term], half: str, sign: str = "") -> list[Piece]:
    pieces: list[Piece] = []
    for term in terms:
        if sign:
            pieces.append(Piece(roman(sign), None, SPACE, half))
        pieces.append(Piece(symbols(term.label), term, SPACE if sign else 0.0, half))
        sign = "+"
    return pieces


def _pieces(equation: Equation, half: str) -> list[Piece]:
    return _sum(equation.left, half) + _sum(equation.right, half, "=")


def _width(pieces: Sequence[Piece]) -> float:
    return sum(width(piece.runs, 1.0) + piece.space for piece in pieces)


def compose(panel: Panel, room: float) -> Foot:
    """Return the lines of a panel's foot: loops share a line if they fit ``room``.

    A loop that is too long for one line goes on with its equals sign on the next.
    """
    remark = tuple(wrap(pieces_of(panel.remark), REMARK_SIZE, room)) if panel.remark else ()
    equations = [(each, half.name) for half in panel.halves for each in half.equations]
    loops = [_pieces(*each) for each in equations]
    if not loops:
        return Foot((), SIZE, remark)
    together: list[Piece] = []
    for loop in loops:
        first = replace(loop[0], space=LOOP_SPACE if together else 0.0)
        together += [first, *loop[1:]]
    if _width(together) * SIZE <= room:
        return Foot((tuple(together),), SIZE, remark)
    lines: list[tuple[Piece, ...]] = []
    for (equation, half), loop in zip(equations, loops, strict=True):
        if _width(loop) * LEAST <= room:
            lines.append(tuple(loop))
        else:
            left = _sum(equation.left, half)
            lines += [tuple(left), tuple(loop[len(left) :])]
    widest = max(_width(line) for line in lines)
    return Foot(tuple(lines), min(SIZE, room / widest), remark)


def placed(foot: Foot, baselines: Sequence[float], middle: float) -> list[tuple[Lettering, Piece]]:
    """Return the terms and signs of the equation, centred, each with its piece."""
    found: list[tuple[Lettering, Piece]] = []
    for pieces, baseline in zip(foot.lines, baselines[len(foot.remark) :], strict=False):
        x = middle - _width(pieces) * foot.size / 2
        for piece in pieces:
            x += piece.space * foot.size
            found.append((Lettering(piece.runs, complex(x, baseline), foot.size), piece))
            x += width(piece.runs, foot.size)
    return found
