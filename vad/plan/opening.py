"""The opening shot: the mechanism stands large while it is drawn, then glides into its panel.

In come the items of a page, out go those that show while one panel has the page to itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from vad.plan.geometry import Rect
from vad.plan.growth import Wandering
from vad.plan.items import CAPTION, FOREVER, OPENING, TITLE, Item
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Bow, Disc, Lettering, Outline, Polygon, Polyline

#: What stays in its place meanwhile.
STAYING = (TITLE, CAPTION)
#: A panel grows by so much at most; one that is smaller than usual further, to the usual size.
LARGEST = 1.7
USUAL = 0.87 + 0.62j
MARGIN = 0.02
#: How far strokes are drawn where their reach is measured, if they are elsewhere meanwhile.
SHARES = [part / 8 for part in range(9)]


@dataclass(frozen=True, slots=True)
class Opening:
    """A panel that stands large.

    Attributes
    ----------
    panel
        Its name.
    factor, shift
        A point z of the panel stands at ``factor * z + shift``.
    large
        Its items, each with itself as it stands large.
    """

    panel: str
    factor: float
    shift: complex
    large: Mapping[Item, Item]

    def shown(self, items: Iterable[Item], near: float) -> list[Item]:
        """Return what shows of ``items``; at ``near`` 1 the panel is large, at 0 in its place."""
        staying = [item for item in items if item.region in STAYING]
        panel = [item for item in items if item.region == self.panel]
        if near == 1.0:
            return [self.large[item] for item in panel] + staying
        factor, shift = 1.0 + near * (self.factor - 1.0), near * self.shift
        return [_mapped(item, factor, shift) for item in panel] + staying


def opening(items: Sequence[Item], panel: str, area: Rect) -> Opening:
    """Return how a panel opens a lesson: as large as ``area`` holds all that it ever shows.

    What stays of it stands in the middle, as far as the rest lets it.
    """
    own, room = [item for item in items if item.region == panel], area.inside(MARGIN)
    whole, staying = reach(own), reach(item for item in own if item.until == FOREVER)
    usual = min(USUAL.real / whole.width, USUAL.imag / whole.height)
    factor = min(max(LARGEST, usual), room.width / whole.width, room.height / whole.height)
    low = complex(room.left, room.bottom) - factor * complex(whole.left, whole.bottom)
    high = complex(room.right, room.top) - factor * complex(whole.right, whole.top)
    ideal = room.centre - factor * staying.centre
    shift = complex(
        min(max(ideal.real, low.real), high.real), min(max(ideal.imag, low.imag), high.imag)
    )
    return Opening(panel, factor, shift, {item: _mapped(item, factor, shift) for item in own})


def _mapped(item: Item, factor: float, shift: complex) -> Item:
    marks = tuple(mark.mapped(factor, shift) for mark in item.marks)
    return replace(item, region=OPENING, marks=marks)


def reach(items: Iterable[Item]) -> Rect:
    """Return how far items reach, while they are drawn, too."""
    points: list[complex] = []
    for mark in (mark for item in items for mark in item.marks):
        shares = SHARES if isinstance(mark.growth, Wandering) else SHARES[-1:]
        for grown in (mark.at(share) for share in shares):
            points += _outermost(grown.shape) if grown else ()
    xs, ys = [point.real for point in points], [point.imag for point in points]
    return Rect(min(xs), min(ys), max(xs), max(ys))


def _outermost(shape: Outline) -> Sequence[complex]:
    """Return points between which all of a shape lies."""
    match shape:
        case Polyline(pieces):
            return [point for piece in pieces for point in piece]
        case Polygon(rings):
            return rings[0]
        case Disc(centre, radius):
            return [centre - radius * (1 + 1j), centre + radius * (1 + 1j)]
        case Bow():
            return shape.curve()
        case Lettering(runs, at, size):
            ink = typeset(runs)
            low, high = complex(ink.left, ink.bottom), complex(ink.right, ink.top)
            return [at + size * low, at + size * high]
