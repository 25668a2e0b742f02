"""Placement of labels by their ink boxes: pure geometry.

Boxes get positions at which they touch no obstacle: first beside the dot along the outward
bisector, then in other directions, then farther off with a leader.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.numbers import minimum, not_below
from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, Span
from vad.plan.labels.obstacles import PIXEL, Bools, Complexes, Obstacles, Reals

GAP = 0.014
CLEARANCE = 0.006
#: Between labels, aside and above: half an em, so that "A" beside "C" never reads "AC".
APART = 0.020 + 0.010j
#: The same where nothing else is left.
TIGHT = 0.006 + 0j
LEADER = 0.06
WAYS = 32  # about a dot
MOST_LEADERS = 160  # tried at each distance
#: So many places for a label far from its dot are looked at together.
_AT_ONCE = 64
#: The places that are tried all over a panel are so far apart.
STEP = 0.008
LENGTH_COUNTS = 0.5  # of a leader, beside how much of it lies on strokes
#: That much longer a leader may be, so counted, if it crosses nothing.
SPARED = 0.06
#: A label far from its dot stands that far from every other dot, so that it does not name it.
STRANGE = 20.0 * PIXEL
#: A label is so much nearer to its own dot than to others; of one close by at least by so much of
#: the distance of the dots.
NEARER, BEYOND = 1.4, 0.5
#: So near, a label is beside its dot, whatever is on its other side; one between two dots is better
#: off with a leader that is no longer than this.
BESIDE, SHORT = 16.0 * PIXEL, 70.0 * PIXEL
#: A leader that passes another dot nearer than that may seem to end there; it counts as much as one
#: that lies so far on strokes.
PASSED, PASSING = 9.0 * PIXEL, 0.10
#: Where each leader near by passes one, the others that are tried are no longer than this.
DOUBTED = 120.0 * PIXEL
#: A leader ends so far from the rim of its dot, and on it where another dot is that near.
OFF, CLOSE_BY = 0.010, 0.035


@dataclass(frozen=True, slots=True)
class Placed:
    """Where a label's ink box goes; ``leader`` is a line to its dot where it stands far off.

    It is ``forced`` where no place was clear of everything, or each leader met another label; its
    leader ``crosses`` a stroke where every one does.  It is in ``doubt`` where it may seem to name
    another dot: it stands between both, or its leader passes that one.
    """

    centre: complex
    wide: float
    high: float
    leader: tuple[complex, complex] | None = None
    forced: bool = False
    crosses: bool = False
    doubt: bool = False

    @property
    def box(self) -> Rect:
        """The ink box."""
        x, y = self.centre.real, self.centre.imag
        w, h = self.wide / 2, self.high / 2
        return Rect(x - w, y - h, x + w, y + h)


@dataclass(frozen=True, slots=True)
class Wish:
    """A label that is to be placed.

    Attributes
    ----------
    at
        What it names.
    first
        The direction in which it would best stand.
    wide, high
        The size of its ink.
    radius
        That of the dot at ``at``.
    near
        The distances at which it needs no leader.
    rivals
        Other dots, which it must not seem to name.
    span
        The beats in which it shows.
    off
        How far from the rim of the dot a leader ends.
    """

    at: complex
    first: complex
    wide: float
    high: float
    radius: float = 0.0
    near: Sequence[float] = (GAP, 0.020)
    rivals: Sequence[complex] = ()
    span: Span = ALWAYS
    off: float = OFF

    def around(self, gap: float, count: int) -> list[complex]:
        """Return the centres of ``count`` boxes about the dot, ``gap`` away, the best first."""
        ways = self.first * _turns(count)
        with np.errstate(divide="ignore"):
            across = self.wide / 2 / np.abs(ways.real)
            upright = self.high / 2 / np.abs(ways.imag)
        centres = self.at + ways * (gap + self.radius + np.minimum(across, upright))
        found: list[complex] = centres.tolist()
        return found

    def ahead(self) -> list[complex]:
        """Return the centres of boxes in the first direction, the nearest first."""
        gaps = [gap + self.radius for gap in self.near]
        return [beside(self.at, self.first, gap, self.wide, self.high) for gap in gaps]


def beside(at: complex, way: complex, gap: float, wide: float, high: float) -> complex:
    """Return the centre of a box whose edge lies ``gap`` from ``at`` in the direction ``way``."""
    across = wide / 2 / not_below(1e-9, abs(way.real))
    upright = high / 2 / not_below(1e-9, abs(way.imag))
    centre: complex = at + way * (gap + minimum(across, upright))
    return centre


def beyond_circle(way: complex, radius: float, wide: float, high: float) -> complex:
    """Return the centre of a box in the direction ``way`` that touches a circle from outside.

    The circle is about the origin.  It meets a side of the box or, where it bends away from both
    sides, a corner.
    """
    aside, above, half_x, half_y = abs(way.real), abs(way.imag), wide / 2, high / 2
    if above * (radius + half_x) <= aside * half_y:
        return way * ((radius + half_x) / aside)
    if aside * (radius + half_y) <= above * half_x:
        return way * ((radius + half_y) / above)
    along = aside * half_x + above * half_y
    across = aside * half_y - above * half_x
    return way * (along + math.sqrt(radius * radius - across * across))


def outward(ways: Iterable[complex]) -> complex:
    """Return the unit vector away from the mean of ``ways``; up and right if they cancel."""
    all_ways = [way for way in ways if way]
    mean = sum(all_ways, 0j)
    if abs(mean) > 0.05:
        return -mean / abs(mean)
    if all_ways:
        return 1j * all_ways[0]
    return cmath.rect(1.0, math.pi / 4)


def fan(first: complex, count: int) -> list[complex]:
    """Return ``count`` directions, the nearest to ``first`` first."""
    found: list[complex] = (first * _turns(count)).tolist()
    return found


@cache
def _turns(count: int) -> NDArray[np.complex128]:
    """Return unit vectors all round, the nearest to 1 first."""
    turns = sorted(range(count), key=lambda i: (min(i, count - i), i))
    return np.exp(2j * np.pi * np.array(turns) / count)


def place_all(obstacles: Obstacles, wishes: Sequence[Wish]) -> Iterator[tuple[int, Placed]]:
    """Place labels, and yield each with its number.

    Those that have a place beside their dots come first.  The others have leaders, and take no
    place of another label.
    """
    near = {number: near_places(obstacles, wish) for number, wish in enumerate(wishes)}
    beside_dots = assigned(near)
    for number, placed in beside_dots.items():
        if names(placed, wishes[number]):
            _settle(obstacles, placed, wishes[number].span)
            yield number, placed
    for number, wish in enumerate(wishes):
        spot = beside_dots.get(number)
        if spot is None or not names(spot, wish):
            placed = _led_off(obstacles, wish, spot)
            _settle(obstacles, placed, wish.span)
            yield number, placed


def assigned(near: Mapping[int, Sequence[Placed]]) -> dict[int, Placed]:
    """Return a place of each label, as far as there are places near the dots for all.

    The label with the fewest places left comes next.  One without any takes the place of another
    that can stand elsewhere.
    """
    found: dict[int, Placed] = {}
    left = dict(near)
    # Each round places one label, or finds that it has no place.
    while left:
        number = min(left, key=lambda each: len(left[each]))
        spots = left.pop(number)
        taken = {number: spots[0]} if spots else _moved_aside(near, found, number)
        found |= taken
        for placed in taken.values():
            left = {each: [s for s in some if _apart(s, placed)] for each, some in left.items()}
    return found


def _moved_aside(
    near: Mapping[int, Sequence[Placed]], found: Mapping[int, Placed], number: int
) -> dict[int, Placed]:
    """Return a place of a label and another one of that which stood there; none if that stays."""
    for spot in near[number]:
        met = [each for each, placed in found.items() if not _apart(spot, placed)]
        if len(met) != 1:
            continue
        others = [spot, *(placed for each, placed in found.items() if each != met[0])]
        for other in near[met[0]]:
            if all(_apart(other, each) for each in others):
                return {number: spot, met[0]: other}
    return {}


def names(spot: Placed, wish: Wish) -> bool:
    """Tell whether a label beside its dot is seen to name that."""
    return distance(spot.box, wish.at) < BESIDE or belongs(spot.box, wish.at, wish.rivals)


def _led_off(obstacles: Obstacles, wish: Wish, near: Placed | None) -> Placed:
    """Return a place with a leader, or one ``near`` that may name another if none is short."""
    if near and obstacles.has_room(near.centre, wish.wide, wish.high, CLEARANCE, APART):
        led = far_off(obstacles, wish, SHORT)
        return led if is_short(led, across=True) else replace(near, doubt=True)
    return far_off(obstacles, wish)


def is_short(placed: Placed, across: bool = False) -> bool:
    """Tell whether a label has a short leader that passes no dot, and no stroke but ``across``."""
    ends = placed.leader
    clear = not (placed.forced or placed.doubt or (placed.crosses and not across))
    return ends is not None and abs(ends[0] - ends[1]) < SHORT and clear


def place(obstacles: Obstacles, wish: Wish) -> Placed:
    """Place one label and add it to the obstacles."""
    ((_, placed),) = place_all(obstacles, [wish])
    return placed


def has_place(obstacles: Obstacles, wide: float, high: float) -> bool:
    """Tell whether a label of a size has a place anywhere in its panel."""
    spots = _grid(obstacles.edge, obstacles.edge.centre, STEP)
    return bool(spots) and bool(obstacles.free(spots, wide, high, CLEARANCE, APART).any())


def near_places(obstacles: Obstacles, wish: Wish) -> list[Placed]:
    """Return where a label may stand without a leader, the best place first.

    It must stand clearly nearer to its own dot than to any other; where it cannot, it is at least
    more on its side.  Of a joint that covers its own it may stand on any side.
    """
    centres = [centre for gap in wish.near for centre in wish.around(gap, WAYS)]
    if not centres:
        return []
    free = obstacles.free(centres, wish.wide, wish.high, CLEARANCE, APART)
    found = [Placed(centres[i], wish.wide, wish.high) for i in np.flatnonzero(free)]
    clearly = [spot for spot in found if belongs(spot.box, wish.at, wish.rivals)]
    leaning = clearly or [spot for spot in found if _leans(spot, wish)]
    apart = [rival for rival in wish.rivals if abs(rival - wish.at) > wish.radius]
    return leaning or [spot for spot in found if belongs(spot.box, wish.at, apart)]


def _leans(spot: Placed, wish: Wish) -> bool:
    """Tell whether the middle of a label, and no less of its box, is nearer to its own dot."""
    off, own = abs(spot.centre - wish.at), distance(spot.box, wish.at)
    return all(
        off < abs(spot.centre - rival) and own <= distance(spot.box, rival) for rival in wish.rivals
    )


def _apart(spot: Placed, other: Placed) -> bool:
    """Tell whether a label touches neither another one nor its leader."""
    off = spot.centre - other.centre
    aside = abs(off.real) - (spot.wide + other.wide) / 2 >= APART.real
    above = abs(off.imag) - (spot.high + other.high) / 2 >= APART.imag
    return (aside or above) and not (
        other.leader and spot.box.inside(-CLEARANCE).clipped(*other.leader)
    )


def far_off(obstacles: Obstacles, wish: Wish, longest: float = math.inf) -> Placed:
    """Place a label away from its dot: its leader crosses as little as possible, and is short.

    Where every leader meets other labels, it is short; a name of a line, which has the ink of that,
    then has none.  The label is forced if its leader would be longer than the ``longest`` one.
    """
    last = Placed(wish.around(GAP, 1)[0], wish.wide, wish.high, forced=True)
    through: Placed | None = None
    least, best = math.inf, None
    alone = all(abs(rival - wish.at) > CLOSE_BY for rival in wish.rivals)
    off = wish.radius + (wish.off if alone else 0.0)
    for tight, far in _far(obstacles.edge, wish):
        if best and (tight or not best.doubt):
            return best
        clear, apart = (0.5 * PIXEL, TIGHT) if tight else (CLEARANCE, APART)
        centres = [z for z in far if abs(z - wish.at) < DOUBTED] if best else far
        tried, at_once = 0, len(centres) if best else _AT_ONCE
        for some in _free_of(obstacles, wish, centres, clear, apart, at_once):
            led = [_led(wish, spot, off) for spot in some[~_strange(some, wish)].tolist()]
            if not led:
                continue
            ends = np.array([each.leader or (wish.at, wish.at) for each in led])
            long = np.abs(ends[:, 1] - ends[:, 0])
            if long.min() > longest:
                return best or last
            if LENGTH_COUNTS * long.min() > least + SPARED:
                break
            passed = _passed(wish, *ends.T)
            costs = LENGTH_COUNTS * long + PASSING * passed
            kept = costs < least + np.where(passed, 0.0, SPARED)
            clear_of = obstacles.clear_of_labels(ends[kept], 1.5 * PIXEL)
            if not (clear_of.all() or through):
                through = replace(led[np.flatnonzero(kept)[clear_of.argmin()]], forced=True)
            kept[kept] = clear_of
            covered = obstacles.all_covered(*ends[kept].T)
            tried += len(covered)
            for number, over in zip(np.flatnonzero(kept).tolist(), covered.tolist(), strict=True):
                spot = led[number]
                if not spot.leader or not (over or passed[number]):
                    return replace(spot, forced=tight)
                if costs[number] + over < least:
                    least = costs[number] + over
                    doubt = bool(passed[number])
                    best = replace(spot, forced=tight, crosses=over > 0.0, doubt=doubt)
            if tried >= MOST_LEADERS:
                break
    if best:
        return best
    if through and not wish.near:
        return replace(through, leader=None)
    return through or last


def _free_of(
    obstacles: Obstacles,
    wish: Wish,
    centres: Sequence[complex],
    clear: float,
    apart: complex,
    at_once: int,
) -> Iterator[Complexes]:
    """Yield those of some places at which a label meets nothing, some ``at_once``."""
    first, count = 0, at_once  # one of the nearest is mostly clear
    while first < len(centres):  # each round asks of the next ones, and of more
        some = np.array(centres[first : first + count])
        free = obstacles.free(some, wish.wide, wish.high, clear, apart)
        parts = range(0, len(some), at_once)
        kept = (some[i : i + at_once][free[i : i + at_once]] for i in parts)
        yield from (each for each in kept if each.size)
        first, count = first + count, 4 * count


def _passed(wish: Wish, starts: Complexes, ends: Complexes) -> Reals:
    """Return how many other dots each leader passes so near that it may seem to end there.

    One that it runs through counts twice.  What counts of a dot close to its own is how much nearer
    than that the leader comes.
    """
    others = np.array([z for z in wish.rivals if abs(z - wish.at) > wish.radius], np.complex128)
    near = np.minimum(PASSED, np.abs(others - wish.at))[:, None]
    ways = ends - starts
    long = np.maximum(np.abs(ways), 1e-9)
    off = (others[:, None] - starts) * (ways / long).conj()
    away = np.abs(off - np.clip(off.real, 0.0, long))
    count: Reals = np.where(away < 0.99 * near, 2.0 - away / near, 0.0).sum(axis=0)
    return count


def _strange(centres: Complexes, wish: Wish) -> Bools:
    """Tell which places are beside another dot than the own one, so that a label names that."""
    dots = np.array([wish.at, *wish.rivals], dtype=np.complex128)
    away = centres[:, None] - dots
    aside = np.maximum(np.abs(away.real) - wish.wide / 2, 0.0)
    above = np.maximum(np.abs(away.imag) - wish.high / 2, 0.0)
    off = np.hypot(aside, above)
    return np.asarray((off[:, 1:] < np.minimum(STRANGE, off[:, :1])).any(axis=1))


def _far(edge: Rect, wish: Wish) -> Iterator[tuple[bool, list[complex]]]:
    """Yield places farther and farther off; then the whole panel, and at last without clearance."""
    gaps = [LEADER * 1.35**growth for growth in range(-2, 5)]
    yield False, [spot for gap in gaps for spot in wish.around(gap, WAYS)]
    grid = _grid(edge, wish.at, STEP)
    yield False, grid
    yield True, grid


def _grid(edge: Rect, at: complex, step: float) -> list[complex]:
    """Return points all over ``edge``, the nearest to ``at`` first."""
    across = edge.left + step * np.arange(1, int(edge.width / step))
    upright = edge.bottom + step * np.arange(1, int(edge.height / step))
    points = (across[:, None] + 1j * upright).ravel()
    nearest: list[complex] = points[np.argsort(np.abs(points - at), kind="stable")].tolist()
    return nearest


def belongs(box: Rect, at: complex, rivals: Iterable[complex]) -> bool:
    """Tell whether a label stands clearly nearer to its dot than to any rival.

    Of a rival close by it stands on the other side of its dot.
    """
    own, left, right = distance(box, at), box.left, box.right
    near = NEARER * own
    for rival in rivals:
        x = rival.real
        if left - x > near or x - right > near:
            continue  # far to one side, as most are
        if distance(box, rival) <= min(near, own + BEYOND * abs(rival - at)):
            return False
    return True


def distance(box: Rect, point: complex) -> float:
    """Return how far a point is from a box."""
    aside = max(box.left - point.real, point.real - box.right, 0.0)
    above = max(box.bottom - point.imag, point.imag - box.top, 0.0)
    return math.hypot(aside, above)


def _led(wish: Wish, centre: complex, off: float) -> Placed:
    """Return a label with a leader from so far ``off`` the dot to its box, if not close by.

    Beside its dot it ends at a corner of the box: a level one would be read as a minus sign.
    """
    at, half_x, half_y = wish.at, wish.wide / 2, wish.high / 2
    nearest = complex(
        min(max(at.real, centre.real - half_x), centre.real + half_x),
        min(max(at.imag, centre.imag - half_y), centre.imag + half_y),
    )
    bare = Placed(centre, wish.wide, wish.high)
    if abs(nearest - at) < wish.radius + 0.025 and belongs(bare.box, at, wish.rivals):
        return bare
    if abs(at.imag - centre.imag) < half_y:
        nearest += 1j * (centre.imag - at.imag - math.copysign(half_y, at.imag - centre.imag))
    way = (nearest - at) / abs(nearest - at)
    return Placed(centre, wish.wide, wish.high, (at + way * off, nearest - way * 0.005))


def _settle(obstacles: Obstacles, placed: Placed, span: Span) -> None:
    obstacles.box(placed.box, span)
    if placed.leader:
        obstacles.line(placed.leader, PIXEL, span)
