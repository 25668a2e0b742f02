"""How SVG writes shapes and looks: numbers, paths, classes and elements.

Page units become pixels, y down, with no more digits than an eye can tell.  A look becomes a class,
which is written once and named by what it says, so that two pictures on one page of a browser never
disturb each other.  In a picture with a scope, which stands among others on a page, rules reach no
further than that element, and names that the whole page shares begin with the scope.
"""

from __future__ import annotations

import cmath
import math
from base64 import urlsafe_b64encode
from collections.abc import Callable, Collection, Iterable, Sequence
from functools import cache, lru_cache
from itertools import pairwise
from typing import Protocol
from zlib import crc32

from vad.plan.format import Format
from vad.plan.marks import Bow, Disc, Lettering, Outline, Polygon, Polyline
from vad.style import Look, Pen

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

    @property
    def frame(self) -> list[float]:
        """Pixels to the page unit, and the left and the upper edge in page units."""
        return [self.unit, self._corner.real, self._corner.imag]

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
        """Return Bézier curves for an arc of an ellipse.

        As an SVG arc its middle would depend on how its ends are rounded.
        """
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
        """Return lengths one after the other, with a space between them unless a minus sign is."""
        return " ".join(map(self._length, steps)).replace(" -", "-")


@cache
def _lengths(fine: int) -> Callable[[int], str]:
    """Return a function that writes steps of the grid as `number` would write them in pixels.

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


class Classes:
    """The classes of one picture.

    Those of a picture that is ``alone`` in its file are numbered, and so have shorter names.
    """

    def __init__(self, scope: str = "", *, alone: bool = False) -> None:
        self.scope = scope
        self._alone = alone
        self._rules: dict[str, str] = {}
        self._names: dict[str, str] = {}

    def name(self, *declarations: str) -> str:
        """Return the class that says ``declarations``; an empty one says nothing."""
        says = ";".join(each for each in declarations if each)
        if says not in self._names:
            name = numbered(len(self._names)) if self._alone else named("c", says)
            self._names[says], self._rules[name] = name, says
        return self._names[says]

    def sheet(self, known: Collection[str] = ()) -> str:
        """Return all classes but the known ones."""
        within = f"#{self.scope} " if self.scope else ""
        fresh = ((name, says) for name, says in self._rules.items() if name not in known)
        return "".join(f"{within}.{name}{{{says}}}\n" for name, says in fresh)

    def shared(self, name: str) -> str:
        """Return a name that no other picture on the page has: of an element, or of a font."""
        return f"{self.scope}-{name}" if self.scope else name


def numbered(number: int) -> str:
    """Return the short name of a number; it begins with a capital.

    Examples
    --------
    >>> numbered(0), numbered(25), numbered(26), numbered(52)
    ('A', 'Z', 'Aa', 'Ab')
    """
    more, first = divmod(number, 26)
    return chr(65 + first) + (chr(96 + more) if more else "")


@lru_cache(maxsize=1024)
def named(initial: str, content: str) -> str:
    """Return a short name that is computed from its content.

    Examples
    --------
    >>> named("c", "fill:#000000"), named("c", "fill:#000001")
    ('cc_mF', 'cdMkT')
    """
    digest = crc32(content.encode()).to_bytes(4, "big")[1:]
    return initial + urlsafe_b64encode(digest).decode()


@lru_cache(maxsize=256)
def filled(look: Look) -> str:
    """Return the declarations of the area of a look."""
    if not look.fill:
        return ""
    return f"fill:{look.fill}" + _opacity("fill", look.alpha)


@lru_cache(maxsize=256)
def drawn(pen: Pen | None, unit: float, alpha: float = 1.0) -> str:
    """Return the declarations of a line; ``unit`` is the length of a page unit."""
    if not pen:
        return ""
    dash = " ".join(number(part * unit) for part in pen.dash)
    says = [f"stroke:{pen.colour}", f"stroke-width:{number(pen.width * unit)}"]
    says += [f"stroke-dasharray:{dash}"] if dash else []
    says += [f"stroke-linecap:{pen.cap}"] if pen.cap != "butt" else []
    says += [f"stroke-linejoin:{pen.join}"] if pen.join != "miter" else []
    return ";".join(says) + _opacity("stroke", alpha)


def _opacity(what: str, alpha: float) -> str:
    return f";{what}-opacity:{number(alpha, 3)}" if alpha != 1.0 else ""


class TextWriter(Protocol):
    """What writes lines of text."""

    def element(self, text: Lettering, look: Look, grid: Grid) -> str:
        """Return the element of a line of text, with its halo."""


class Elements:
    """Writes the shapes of one picture."""

    def __init__(self, grid: Grid, classes: Classes, text: TextWriter) -> None:
        self._grid, self._classes, self._text = grid, classes, text

    def of(self, shape: Outline, look: Look) -> str:
        """Return the elements of a shape: a halo, if it has one, and itself."""
        if isinstance(shape, Lettering):
            return self._text.element(shape, look, self._grid)
        return "".join(f'<{self._place(shape)} class="{name}"/>\n' for name in self.classes(look))

    def classes(self, look: Look) -> list[str]:
        """Return the classes of the elements of any shape but text: of its halo, and its own."""
        unit = self._grid.unit
        own = self._classes.name(filled(look), drawn(look.pen, unit, look.alpha))
        return [self._classes.name(drawn(look.under, unit)), own] if look.under else [own]

    def _place(self, shape: Outline) -> str:
        if isinstance(shape, Disc):
            x, y = self._grid.at(shape.centre)
            return f'circle cx="{x}" cy="{y}" r="{number(shape.radius * self._grid.unit)}"'
        assert not isinstance(shape, Lettering)
        return f'path d="{self._grid.path(shape)}"'
