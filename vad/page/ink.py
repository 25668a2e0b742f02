"""The drawings of a page: the panels of a plan as SVG, and how their strokes grow.

A group has the beat from which it is visible, ``data-s="9"``, or the beats at which it appears and
disappears in turn, ``data-b="3 5 7 9"``.  A mark that grows in the first of them names its growth,
``data-g``: a list of its kind, its knots (a share, then numbers) and what else it needs, in
pixels::

    ["trim", knots]                                 a line, the part of its length
    ["bow", knots, x, y, radius, start, sweep]      an arc, the part of its sweep
    [… , sweep, degrees, narrow]                    of an ellipse, its axis clockwise and its ratio
    ["slide", knots]                                how far it is from its place, right and down
    ["lead", knots, right, down, whole]             a head, from its tip to where it starts, and
                                                    the part of its way in which it grows
    ["turn", knots, x, y]                           degrees clockwise to its place, about a point
    ["scale", knots, x, y]                          its factor, about a point
    ["swing", knots, x, y, degrees]                 its factor, across an axis through the point
    ["fade", knots]                                 its alpha
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable
from itertools import groupby
from typing import Any

from vad.page.themed import Inks
from vad.painting.svg_elements import Classes, Elements, Grid, number
from vad.painting.svg_text import Faces, SetText
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER, Item, Level, Span
from vad.plan.marks import Bending, Bow, Fading, Flying, Mark, Scaling, Sliding, Trimming, Turning


class Inker:
    """Draws the panels of one page.

    Attributes
    ----------
    classes
        The classes of the looks so far.
    inks
        Their looks, and the style that names their colours.
    growths
        The growth of each mark that grows: see `grown`.
    """

    def __init__(self, form: Format, inks: Inks, faces: Faces, *, alone: bool = False) -> None:
        self.classes = Classes(alone=alone)
        self.inks = inks
        self.growths: list[list[Any]] = []
        self._grid = Grid(form)
        self._elements = Elements(self._grid, self.classes, SetText(self.classes, faces, ""))

    def groups(self, items: Iterable[Item]) -> str:
        """Return the groups of a panel's items, which are in painting order."""
        groups: dict[tuple[Level, str], dict[Span, None]] = {}
        for item in items:
            # A group that is visible several times, as a highlighted link is, is written once.
            key = item.level, "".join(map(self._mark, item.marks))
            groups.setdefault(key, {})[item.since, item.until] = None
        beats = groupby(groups.items(), key=lambda group: when(group[1]))
        return "".join(
            f"<g{span}>{''.join(marks for (_, marks), _ in run)}</g>" for span, run in beats
        )

    def mark(self, mark: Mark) -> str:
        """Return a mark in its final state."""
        return self._elements.of(mark.shape, self.inks(mark)).replace("\n", "")

    def name(self, mark: Mark) -> str:
        """Return the class of a mark that is no text."""
        return self._elements.classes(self.inks(mark))[-1]

    @property
    def frame(self) -> list[float]:
        """What makes pixels of page units: pixels to the unit, and the left and the upper edge."""
        return self._grid.frame

    def pixels(self, z: complex) -> tuple[float, float]:
        """Return how far a place is to the right and down in the views, in pixels."""
        unit, left, top = self._grid.frame
        return (z.real - left) * unit, (top - z.imag) * unit

    def view(self, area: Rect) -> str:
        """Return the view of an area of the page."""
        corner, unit = self._grid.at(complex(area.left, area.top)), self._grid.unit
        return " ".join((*corner, number(area.width * unit), number(area.height * unit)))

    def _mark(self, mark: Mark) -> str:
        if not mark.growth:
            return self.mark(mark)
        growth = grown(mark, self._grid)
        if growth not in self.growths:
            self.growths.append(growth)
        return attributed(self.mark(mark), f' data-g="{self.growths.index(growth)}"')


def attributed(elements: str, attribute: str) -> str:
    """Return elements with an attribute: a single one has it itself, several in a group.

    Examples
    --------
    >>> attributed('<path class="A"/>', " data-m")
    '<path data-m class="A"/>'
    >>> attributed('<use/><text>a</text>', " data-m")
    '<g data-m><use/><text>a</text></g>'
    """
    if elements.count("<") > 1:  # with a halo, or a text
        elements = f"<g>{elements}</g>"
    return re.sub(r"(?<=^<)\w+", rf"\g<0>{attribute}", elements)


def when(spans: Iterable[Span]) -> str:
    """Return the attribute of a group that is visible in these spans of beats.

    Examples
    --------
    >>> when([(9, FOREVER)]), when([(3, 5), (7, 9)]), when([(0, FOREVER)])
    (' data-s="9"', ' data-b="3 5 7 9"', '')
    """
    beats = [beat for span in spans for beat in span if beat != FOREVER]
    if beats == [0]:
        return ""
    return f' data-{"b" if len(beats) % 2 == 0 else "s"}="{" ".join(map(str, beats))}"'


def grown(mark: Mark, grid: Grid) -> list[Any]:
    """Return the growth of a mark as the player reads it; see the head of this file."""
    growth = mark.growth
    match growth:
        case Trimming(knots):
            if isinstance(mark.shape, Bow):
                bow = mark.shape
                place = [*_at(bow.centre, grid), round(bow.radius * grid.unit, 2)]
                aside = [_clockwise(bow.axis), _short(bow.narrow)] if bow.narrow < 1.0 else []
                turn = round(bow.start, 2), round(bow.sweep, 2)
                return ["bow", _knots(knots), *place, *turn, *aside]
            return ["trim", _knots(knots)]
        case Sliding(offsets):
            return ["slide", [[_short(share), *_by(offset, grid)] for share, offset in offsets]]
        case Turning(centre, knots):
            return ["turn", _knots((s, -degrees) for s, degrees in knots), *_at(centre, grid)]
        case Scaling(centre, knots, axis):
            if axis is None:
                return ["scale", _knots(knots), *_at(centre, grid)]
            return ["swing", _knots(knots), *_at(centre, grid), _clockwise(axis)]
        case Fading(knots):
            return ["fade", _knots(knots)]
        case Flying(_, legs, None):  # the head of a vector, which does not turn
            way, whole = _by(legs[0].offset, grid), _short(legs[-2].share or 1.0)
            return ["lead", [[0, 0], [1, 1]], *way, whole]
        case Flying() | Bending() | None:  # nothing leaves a panel of a page
            raise TypeError("the mark does not grow within its panel")


def _knots(knots: Any) -> list[list[float]]:
    return [[_short(share), _short(value)] for share, value in knots]


def _short(value: float) -> float:
    """Return a number with four decimals, as an int if it is whole."""
    rounded = round(value, 4)
    return int(rounded) if rounded == int(rounded) else rounded


def _clockwise(axis: complex) -> float:
    return round(-math.degrees(cmath.phase(axis)), 2)


def _by(offset: complex, grid: Grid) -> list[float]:
    return [round(offset.real * grid.unit, 1), round(-offset.imag * grid.unit, 1)]


def _at(z: complex, grid: Grid) -> list[float]:
    return [steps / grid.fine for steps in grid.steps(z)]
