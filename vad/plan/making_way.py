"""Text makes way for what flies across it: meanwhile it has the ink of what has been said before.

A vector in flight may have to cross a heading, an equation, a row of the results or a letter, and
so may a number that flies to its link.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from vad.plan.geometry import Rect
from vad.plan.items import FLIGHT, Item
from vad.plan.labels.obstacles import Obstacles, Reals
from vad.plan.lens import block
from vad.plan.marks import Bending, Fading, Flying, Lettering, Mark
from vad.plan.page.changing import SAID
from vad.plan.page.free_places import box_of
from vad.plan.roles import ROLES

#: After each such share of a flight it is looked where everything is.
MOMENT = 1 / 100
#: The share of a flight in which a text fades, and in which it comes out again.
FADES = 0.06
#: What has less ink covers nothing.
FAINT = 0.3


def made_way(items: Sequence[Item], beat: int) -> list[Item]:
    """Return the items of a beat, in which texts that something crosses are pale meanwhile.

    A text on which something lies when its flight begins stays: it is the one that it comes from.
    """
    flights = [item for item in items if item.region == FLIGHT and item.since == beat]
    flying = [m for item in flights for m in item.marks if isinstance(m.growth, Flying | Bending)]
    if not flying:
        return [*items]
    now = [item if item.since == beat else _grown(item) for item in items]
    others = [mark for item in now if item.region != FLIGHT for mark in item.marks]
    still = [mark for mark in others if isinstance(mark.shape, Lettering) and not mark.growth]
    pale = _pale(still, flying)
    return [
        _with(each, pale, beat) if any(mark in pale for mark in each.marks) else item
        for item, each in zip(items, now, strict=True)
    ]


def _grown(item: Item) -> Item:
    """Return an item whose marks have grown."""
    return replace(item, marks=tuple(replace(mark, growth=None) for mark in item.marks))


def _pale(texts: Sequence[Mark], flying: Sequence[Mark]) -> dict[Mark, Fading]:
    """Return when the texts are pale that something crosses."""
    if not texts:
        return {}
    boxes = [box_of(mark) for mark in texts]
    ways, moments = _ways(flying)
    found = {}
    for mark, crossed in zip(texts, ways.under(boxes), strict=True):
        shares = moments[crossed]
        if shares.size and shares.min() > 0.0 and mark.alpha > SAID:
            found[mark] = _fading(shares.min() - MOMENT, shares.max() + MOMENT, SAID / mark.alpha)
    return found


def _ways(flying: Sequence[Mark]) -> tuple[Obstacles, Reals]:
    """Return what flies at all moments of a flight, as strokes, and the moment of each."""
    ways, moments = Obstacles(Rect(0.0, 0.0, 0.0, 0.0)), list[float]()
    for share in np.arange(0.0, 1.0, MOMENT).tolist():
        for now in (mark.at(share) for mark in flying):
            if now is None or now.alpha < FAINT:
                continue
            if isinstance(now.shape, Lettering):
                ways.block(box_of(replace(now, growth=None)))
            else:
                block(ways, now.shape, now.width * ROLES[now.role].width / 2)
        moments += [share] * (len(ways.lines) - len(moments))
    return ways, np.array(moments)


def _fading(first: float, last: float, ink: float) -> Fading:
    """Return how something has little ink from one share to another, and all of it at the end."""
    knots = [(first - FADES, 1.0), (first, ink), (last, ink), (last + FADES, 1.0)]
    if last + FADES > 1.0:
        knots[2:] = [(min(last, 1.0 - FADES), ink), (1.0, 1.0)]
    return Fading(tuple(knots))


def _with(item: Item, pale: Mapping[Mark, Fading], beat: int) -> Item:
    """Return an item with what is pale in a beat."""
    marks = (replace(mark, growth=pale.get(mark, mark.growth)) for mark in item.marks)
    return replace(item, since=beat, until=beat + 1, marks=tuple(marks))
