"""How PDF writes numbers, colours, pens and paths: in come values and shapes, out goes text."""

from __future__ import annotations

from collections.abc import Iterator

from vad.plan.lettering.glyphs import CLOSE, CURVE, LINE, MOVE, QUADRATIC, Codes, Points
from vad.style import Pen

#: A thousandth of a point is 0.35 µm; fewer digits save little.
_DIGITS = 3
_OPERATORS = {MOVE: "m", LINE: "l", CURVE: "c"}

_ESCAPED = str.maketrans({letter: f"\\{letter}" for letter in "()\\"} | {"\r": "\\r"})

#: Left, bottom, right and top, in points.
Area = tuple[float, float, float, float]


def number(value: float) -> str:
    """Return a number as PDF reads it, which knows no exponents.

    Examples
    --------
    >>> number(2.5), number(-0.0001), number(100.0)
    ('2.5', '0', '100')
    """
    text = f"{value:.{_DIGITS}f}".rstrip("0").removesuffix(".")
    return "0" if text == "-0" else text


def colour(name: str) -> str:
    """Return ``#RRGGBB`` as three numbers from 0 to 1."""
    return " ".join(number(int(name[i : i + 2], 16) / 255) for i in (1, 3, 5))


def box(area: Area) -> str:
    """Return a rectangle."""
    return f"[{' '.join(map(number, area))}]"


def string(text: str) -> str:
    r"""Return any text as a string of a document's properties: two bytes a letter.

    Examples
    --------
    >>> string("ω (")
    '(þÿ\x03É\x00 \x00\\()'
    """
    data = f"\N{BYTE ORDER MARK}{text}".encode("utf-16-be").decode("latin-1")
    return f"({data.translate(_ESCAPED)})"


def take(pen: Pen, unit: float) -> str:
    """Return the operators that take up a pen, whose page unit is ``unit`` points."""
    dash = " ".join(number(part * unit) for part in pen.dash)
    cap, join = int(pen.cap == "round"), int(pen.join == "round")
    return f"{colour(pen.colour)} RG {number(pen.width * unit)} w {cap} J {join} j [{dash}] 0 d"


def path(vertices: Points, codes: Codes) -> Iterator[str]:
    """Yield the operators of a path; a quadratic curve becomes the cubic one that it is."""
    points, kinds = vertices.tolist(), codes.tolist()
    place = 0
    while place < len(kinds):
        kind = kinds[place]
        if kind == CLOSE:
            yield "h"
            place += 1
            continue
        if kind == QUADRATIC:
            (x0, y0), (x1, y1), (x2, y2) = points[place - 1 : place + 2]
            curve = ((x0 + 2 * x1) / 3, (y0 + 2 * y1) / 3, (x2 + 2 * x1) / 3, (y2 + 2 * y1) / 3)
            yield f"{' '.join(map(number, (*curve, x2, y2)))} c"
            place += 2
            continue
        count = 3 if kind == CURVE else 1
        values = [value for point in points[place : place + count] for value in point]
        yield f"{' '.join(map(number, values))} {_OPERATORS[kind]}"
        place += count
