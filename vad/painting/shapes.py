"""Shapes as paths, and lines of text in stretches, for the painters of every medium.

The shapes of a plan become vertices with codes, in page units.  Its texts become stretches of
letters, each of which a medium with fonts of its own can set as a whole.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise

import numpy as np

from vad.plan.lettering.glyphs import CLOSE, CURVE, LINE, MOVE, Codes, Letter, Points, typeset
from vad.plan.lettering.runs import Runs
from vad.plan.marks import Bow, Disc, Lettering, Outline, Polygon, Polyline

LetterStretch = tuple[Letter, ...]


def outline(shape: Outline) -> tuple[Points, Codes]:
    """Return the path of a shape: vertices of shape (n, 2) and their codes."""
    match shape:
        case Polyline(pieces):
            codes = [code for piece in pieces for code in (MOVE, *[LINE] * (len(piece) - 1))]
            return _points([z for piece in pieces for z in piece]), _codes(codes)
        case Polygon(rings):
            codes = [code for ring in rings for code in (MOVE, *[LINE] * (len(ring) - 1), CLOSE)]
            return _points([z for ring in rings for z in (*ring, ring[0])]), _codes(codes)
        case Disc(centre, radius):
            curve = Bow(centre, radius, 0.0, 360.0).curve()
            codes = [MOVE, *[CURVE] * (len(curve) - 1), CLOSE]
            return _points([*curve, curve[0]]), _codes(codes)
        case Bow():
            curve = shape.curve()
            return _points(curve), _codes([MOVE, *[CURVE] * (len(curve) - 1)])
        case Lettering(runs, at, size):
            letters = typeset(runs)
            vertices = letters.vertices * size + (at.real, at.imag)
            if len(vertices):
                vertices[letters.codes == CLOSE] = vertices[0]
            return vertices, letters.codes


def _points(points: list[complex]) -> Points:
    return np.array(points, dtype=np.complex128).view(np.float64).reshape(-1, 2)


def _codes(codes: list[int]) -> Codes:
    return np.array(codes, dtype=np.uint8)


@lru_cache(maxsize=1024)
def stretches(runs: Runs) -> tuple[LetterStretch, ...]:
    """Return the letters of a line, broken wherever the face, the size or the way changes."""
    letters = typeset(runs).letters
    breaks = [number for number, pair in enumerate(pairwise(letters), 1) if not _follows(*pair)]
    ends = [0, *breaks, len(letters)]
    return tuple(letters[start:end] for start, end in pairwise(ends) if end > start)


def _follows(before: Letter, letter: Letter) -> bool:
    """Tell whether a letter is the next one of the same stretch."""
    pen = before.at + before.size * before.advance
    alike = (letter.face, letter.size) == (before.face, before.size)
    return alike and abs(letter.at - pen) < 1e-6
