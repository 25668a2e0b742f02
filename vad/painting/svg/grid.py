"""Page units become pixels, y down, with no more digits than an eye can tell.

In come a format and shapes, out go numbers and the data of paths.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from functools import cache, lru_cache
from itertools import pairwise

from vad.plan.format import Format
from vad.plan.marks import Bow, Polygon, Polyline

#: Steps of the grid to a page unit, at least: a tenth of a pixel at 1280×720.
_STEPS = 7200
_QUARTER = 90.0  # a longer arc is sensitive to how its ends are rounded


class Grid:
    """The pixels of one page, with ``fine`` steps to each: ten or a hundred."""

    def __init__(self, form: Format) -> None:
        self.unit = form.unit
        self.width, self.height = (
            (side + 2.0 * form.edge) * form.unit for side in (form.width, form.height)
        )
        self._corner = complex(-form.edge, form.height + form.edge)
        self.fine = 10 ** max(0, math.ceil(math.log10(_STEPS / form.unit)))
        self._length = _lengths(self.fine)
        self._scale = self.unit * self.fine

    def at(self, z: complex) -> tuple[str, str]:
        """Return x and y of a point."""
        x, y = self.steps(z)
        return self._length(x), self._length(y)

    def path(self, shape: Polyline | Polygon | Bow) -> str:
        """Return the data of a path, each step as the difference to the point before."""
        match shape:
            case Polyline(pieces):
                return "".join(self._line(piece) for piece in pieces)
            case Polygon(rings):
                return "".join(self._line(ring) + "z" for ring in rings)
            case Bow():
                return self._arc(shape) if shape.narrow == 1.0 else self._curve(shape)

    def _line(self, points: Sequence[complex]) -> str:
        places = list(map(self.steps, points))
        ways = [each for (x, y), (u, v) in pairwise(places) for each in (u - x, v - y)]
        return f"M{self._listed(places[0])}" + (f"l{self._listed(ways)}" if ways else "")

    def _curve(self, bow: Bow) -> str:
        """Return Bézier curves: of a narrow arc, whose middle hangs on how its ends are rounded."""
        (x, y), *places = map(self.steps, bow.curve())
        data = f"M{self._listed((x, y))}c"
        ways: list[int] = []
        for number, (u, v) in enumerate(places, 1):
            ways += [u - x, v - y]
            if number % 3 == 0:
                x, y = u, v
        return data + self._listed(ways)

    def _arc(self, bow: Bow) -> str:
        pieces = max(1, math.ceil(abs(bow.sweep) / _QUARTER))
        angles = [math.radians(bow.start + bow.sweep * k / pieces) for k in range(pieces + 1)]
        places = [self.steps(bow.centre + cmath.rect(bow.radius, angle)) for angle in angles]
        radius, turn = number(bow.radius * self.unit), int(bow.sweep < 0.0)
        arcs = [
            f"a{radius} {radius} 0 0 {turn} {self._listed((u - x, v - y))}"
            for (x, y), (u, v) in pairwise(places)
        ]
        return f"M{self._listed(places[0])}" + "".join(arcs)

    def steps(self, z: complex) -> tuple[int, int]:
        """Return x and y of a point in steps of the grid."""
        away = (z - self._corner) * self._scale
        return round(away.real), -round(away.imag)

    def _listed(self, steps: Iterable[int]) -> str:
        """Return lengths one after the other; a minus sign parts them as well as a blank."""
        return " ".join(map(self._length, steps)).replace(" -", "-")


@cache
def _lengths(fine: int) -> Callable[[int], str]:
    """Return what writes steps of the grid as `number` writes them.

    What was written is kept: a picture has hundreds of them, again and again.
    """

    @lru_cache(maxsize=1 << 15)
    def length(steps: int) -> str:
        text = f"{steps / fine:.12g}"
        return text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text

    return length


def number(value: float, digits: int = 2) -> str:
    """Return a number as short as it can be.

    Examples
    --------
    >>> number(0.25), number(-3.0), number(-0.001)
    ('.25', '-3', '0')
    """
    text = f"{value:.{digits}f}"
    if "." in text:
        text = text.rstrip("0").removesuffix(".")
    if text in ("0", "-0", ""):
        return "0"
    return text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text
