"""Shapes as paths: in come the shapes of a plan, out go vertices and codes in page units."""

from __future__ import annotations

import numpy as np

from vad.plan.lettering.glyphs import CLOSE, CURVE, LINE, MOVE, Codes, Points, typeset
from vad.plan.marks import Bow, Disc, Lettering, Outline, Polygon, Polyline


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
