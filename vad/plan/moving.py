"""A move: the items of one layout on their way to their places in another.

The two layouts show the same panels, so most items have a counterpart: marks with the same role,
the same ink and the same form.  Such a mark grows or shrinks and moves with its panel
(`vad.plan.ways`).  What is in one layout only fades on its way, and the head of a panel, a term or
a row that changes its place fades where it is: on its way it would cross another one.  It is gone
before a panel crosses it, and comes when the panels are nearly there.  A lens and a scale bar have
other places and sizes in every layout, and their parts would come apart on the way: they, too, are
gone soon and come late.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from vad.lecture.moment import smooth
from vad.plan.board import reach
from vad.plan.geometry import Rect
from vad.plan.items import HEAD, Item, Level
from vad.plan.marks import Bow, Disc, Lettering, Mark, Outline, Polygon, Polyline
from vad.plan.scene_layout import WORK
from vad.plan.ways import Way, ways

#: Until this share of a move fades what goes, and from there on appears what comes.
HALF = 0.5
#: Until this share of a move fades a lens, a scale bar, or what stands beside the panels, after a
#: quarter of its time; another one appears in the last quarter.
SOON = smooth(0.25)
#: Ellipses whose axes and shapes differ by less are alike.
SAME = 1e-9

#: An item, and its counterpart in the other layout: None for what goes, or for what comes.
Pair = tuple[Item | None, Item | None]


@dataclass(frozen=True, slots=True)
class Move:
    """The items of two layouts, each with its counterpart, in painting order.

    The panels have ``ways`` of their own; all else moves straight.
    """

    pairs: tuple[Pair, ...]
    region: str
    ways: Mapping[str, Way]

    @classmethod
    def between(
        cls,
        before: Sequence[Item],
        after: Sequence[Item],
        panels: Collection[str],
        region: str,
        area: Rect,
    ) -> Move:
        """Return the move of panels from one layout to another, in a region and its area."""
        before, after = ([_landed(item) for item in each] for each in (before, after))
        waiting: dict[object, list[Item]] = defaultdict(list)
        for item in after:
            waiting[_key(item)].append(item)
        pairs: list[Pair] = []
        for item in before:
            same = [] if _fades_soon(item) else waiting[_key(item)]
            pairs.append((item, same.pop(0) if same else None))
        left = {id(item) for items in waiting.values() for item in items}
        pairs += [(None, item) for item in after if id(item) in left]
        return cls(tuple(pairs), region, _ways(pairs, panels, area))

    def at(self, share: float) -> list[Item]:
        """Return the items when ``share`` of the way is behind them."""
        found: list[Item] = []
        for one, other in self.pairs:
            if one and other:
                way = self.ways.get(_place(one))
                marks = tuple(
                    mark
                    for pair in zip(one.marks, other.marks, strict=True)
                    for mark in _between(*pair, share, way)
                )
                found.append(replace(other, region=self.region, marks=marks))
            elif one and share < (time := self._time(one)):
                marks = _faded(self._carried(one, share, from_start=True), 1 - share, time)
                found.append(replace(one, region=self.region, marks=marks))
            elif other and share > 1 - (time := self._time(other)):
                marks = _faded(self._carried(other, share, from_start=False), share, time)
                found.append(replace(other, region=self.region, marks=marks))
        return found

    def _time(self, item: Item) -> float:
        """Return for which share of the move an item shows that has no counterpart."""
        return SOON if _fades_soon(item) or _place(item) not in self.ways else HALF

    def _carried(self, item: Item, share: float, from_start: bool) -> Sequence[Mark]:
        """Return the marks of an item of one layout where its panel carries them."""
        way = self.ways.get(_place(item))
        if way is None:
            return item.marks
        factor, shift = way.carried(share, from_start)
        return [mark.mapped(factor, shift) for mark in item.marks]


def _ways(pairs: Sequence[Pair], panels: Collection[str], area: Rect) -> dict[str, Way]:
    """Return the ways of panels with something in both layouts."""
    both: dict[str, tuple[list[Item], list[Item]]] = defaultdict(lambda: ([], []))
    for one, other in pairs:
        if one and other and _place(one) in panels:
            both[_place(one)][0].append(one)
            both[_place(one)][1].append(other)
    return ways({name: (reach(one), reach(other)) for name, (one, other) in both.items()}, area)


def _place(item: Item) -> str:
    """Return the region of an item without the number of its scene."""
    return item.region.rpartition(":")[2]


def _fades_soon(item: Item) -> bool:
    """Tell whether an item belongs to a lens, or is a scale bar with its value in a drawing."""
    bar = any(mark.role == "scale bar" for mark in item.marks)
    return item.level == Level.LENS or (bar and not _place(item).endswith(HEAD))


def _landed(item: Item) -> Item:
    """Return an item without what is gone when it has flown to its place."""
    if not item.grows:
        return item
    return replace(item, marks=tuple(mark for mark in item.marks if mark.at(1.0)))


def _key(item: Item) -> object:
    """Return what an item has in common with its counterpart.

    Both show during the move: what has flown to its place shows a beat later than in a still.
    """
    place = _place(item)
    forms = tuple((mark.role, mark.row, type(mark.shape)) for mark in item.marks)
    stays = item.marks if place.endswith(HEAD) or place == WORK else ()
    return place, item.stroke, item.level, item.words, forms, stays


def _faded(marks: Iterable[Mark], share: float, time: float = HALF) -> tuple[Mark, ...]:
    """Return marks with all their ink at the end of a move, and none a ``time`` before."""
    ink = (share - 1.0 + time) / time
    return tuple(replace(mark, alpha=ink * mark.alpha, growth=None) for mark in marks)


def _between(one: Mark, other: Mark, share: float, way: Way | None) -> Iterable[Mark]:
    """Return a mark on its way; both of them, faded, where their forms differ."""
    size, shift = (way.size(share), way.shift(share)) if way else (share, 0j)
    shape = between_shapes(one.shape, other.shape, size)
    if shape is None:
        return _faded([one], 1 - share) if share < HALF else _faded([other], share)
    width, alpha = (
        start + size * (end - start)
        for start, end in ((one.width, other.width), (one.alpha, other.alpha))
    )
    moved = shape.mapped(1.0, shift)
    return [replace(other, shape=moved, width=width, alpha=alpha, growth=None)]


def between_shapes(one: Outline, other: Outline, share: float) -> Outline | None:
    """Return a shape between two of the same form; None where their forms differ.

    Examples
    --------
    >>> between_shapes(Disc(0j, 1.0), Disc(2 + 2j, 3.0), 0.5)
    Disc(centre=(1+1j), radius=2.0)
    """

    def way(start: complex, end: complex) -> complex:
        return start + share * (end - start)

    def size(start: float, end: float) -> float:
        return start + share * (end - start)

    match one, other:
        case Polyline(starts), Polyline(ends) if _alike(starts, ends):
            return Polyline(_along(starts, ends, share))
        case Polygon(starts), Polygon(ends) if _alike(starts, ends):
            return Polygon(_along(starts, ends, share))
        case Disc(), Disc():
            return Disc(way(one.centre, other.centre), size(one.radius, other.radius))
        case Bow(), Bow() if abs(one.axis - other.axis) + abs(one.narrow - other.narrow) < SAME:
            return replace(
                other,
                centre=way(one.centre, other.centre),
                radius=size(one.radius, other.radius),
                start=size(one.start, other.start),
                sweep=size(one.sweep, other.sweep),
            )
        case Lettering(), Lettering() if one.runs == other.runs:
            return Lettering(one.runs, way(one.at, other.at), size(one.size, other.size))
    return None


Rings = tuple[tuple[complex, ...], ...]


def _alike(one: Rings, other: Rings) -> bool:
    return list(map(len, one)) == list(map(len, other))


def _along(one: Rings, other: Rings, share: float) -> Rings:
    pairs = zip(one, other, strict=True)
    return tuple(
        tuple(a + share * (b - a) for a, b in zip(starts, ends, strict=True))
        for starts, ends in pairs
    )
