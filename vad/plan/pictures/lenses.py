"""Where a lens stands in its panel: its frame, its words, and the search for a free place."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise, product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.labels.close import LEAST_RING
from vad.plan.labels.obstacles import PIXEL, Obstacles, crossed
from vad.plan.labels.placing import APART, Placed
from vad.plan.labels.vertices import text_at
from vad.plan.lens import BAND, Lens, circle
from vad.plan.lettering.glyphs import ink_size, width
from vad.plan.lettering.runs import Runs, roman
from vad.plan.marks import Mark, Polyline, disc
from vad.plan.roles import ROLES
from vad.plan.scale import SCALE_GAP, Scale, bar_marks, scale_bar
from vad.plan.sketch import Close, Setting

STEP = 0.012  # from one place that is tried to the next
#: So far may a lens reach into the gutter, and so far where there is little room.
BESIDE, FAR_BESIDE = 0.008, 0.022
TRIED = 24  # of the best places
CLEAR = 0.004  # between the band about a lens and all other ink
#: From a dot to the band about a lens: room for the letter of the dot.
ROOMY = 0.045
#: The price of a place per page unit: from its place, and away from the sides of its room.
INWARD = 0.8
WORDS = 0.027  # the size of the words below a lens
#: The longest bar below a lens, and one where its unit has no room otherwise.
LONGEST_BAR, SHORT_BAR = 0.060, 0.026
BELOW = 0.014  # from the rim to the words
#: How far words with a unit may stand aside from the middle.
ASIDE = (0.0, 0.02, -0.02, 0.04, -0.04, 0.06, -0.06)
#: At so many of the places, the ends of a leader are turned by so much, where it lies on strokes.
TURNED = 4
TURNS = [
    (cmath.rect(1.0, math.radians(out)), cmath.rect(1.0, math.radians(into)))
    for out, into in product((0, 30, -30, 60, -60), (0, 30, -30))
]
WORTH = 2.5 * PIXEL  # so much less does a leader lie on strokes that is turned for it
STEEP = 0.6  # the sine of the least angle at which it meets the circles
#: On either side of a stroke, a leader is broken that crosses it at more than an angle: its sine.
GAP, ACROSS = 3.0 * PIXEL, 0.4
OFF_RING = 4.0 * PIXEL  # from the circle about the place, what a leader lies on counts

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]


class Words(NamedTuple):
    """The words below a lens: its factor, a bar, and what that stands for.

    Where a picture states no scale, the factor stands alone.
    """

    factor: Runs
    length: float = 0.0
    value: Runs = ()

    @property
    def wide(self) -> float:
        """Their width."""
        sides = width(self.factor, WORDS) + width(self.value, WORDS)
        return sides + (2 * SCALE_GAP + self.length if self.value else 0.0)

    @property
    def high(self) -> float:
        """Their height."""
        return ink_size(self.value or self.factor, WORDS)[1]

    def marks(self, middle: complex) -> Iterator[Mark]:
        """Yield them about the middle of their place."""
        start = middle - complex(self.wide, self.high) / 2
        centre = start + complex(*ink_size(self.factor, WORDS)) / 2
        yield text_at(self.factor, self.factor, centre, WORDS, "notes")
        if self.value:
            bar = start + width(self.factor, WORDS) + SCALE_GAP
            yield from bar_marks(self.length, self.value, bar, WORDS)

    def box(self, middle: complex) -> Rect:
        """Return their box about the middle of their place."""
        return Placed(middle, self.wide, self.high).box


@dataclass(frozen=True, slots=True)
class Spot:
    """Where a lens stands, the middle of its words, and how much its leader lies on strokes."""

    lens: Lens
    words: Words
    middle: complex
    covered: float = 0.0

    def frame(self, drawn: Obstacles | None = None) -> Iterator[Mark]:
        """Yield its rim over a band, the circle about its place, and its leader.

        The leader runs behind what is ``drawn``: it is broken where it crosses a stroke, but
        always meets both circles.
        """
        lens, ends = self.lens, self.lens.leader
        pieces = drawn.between_strokes(*ends, GAP, ACROSS) if drawn else [ends]
        pieces[0] = ends[0], pieces[0][1]
        pieces[-1] = pieces[-1][0], ends[1]
        yield disc(lens.at, lens.radius + BAND / 2, "lens band")
        yield disc(lens.at, lens.radius, "lens rim")
        yield disc(lens.place, lens.ring, "lens place")
        yield Mark(Polyline(tuple(pieces)), "leader")

    def stated(self, words: Words, obstacles: Obstacles) -> Spot | None:
        """Return it with other words; None where they have no room beside all that is there."""
        lens, box, inner = self.lens, words.box(0j), obstacles.edge.inside(CLEAR)
        own = {self.words.box(self.middle), *lens.slabs}
        others = replace(obstacles, boxes=[each for each in obstacles.boxes if each[0] not in own])
        far = lens.radius + BELOW
        offs = [side * far + 1j * side.imag * words.high / 2 for side in (-1j, 1j)]
        offs = [off + aside for aside in ASIDE for off in offs]
        offs += [side * (far + words.wide / 2) for side in (1.0, -1.0)]
        middles = [lens.at + off for off in offs]
        free = others.free(middles, words.wide, words.high, CLEAR, APART)
        for middle in (at for at, is_free in zip(middles, free.tolist(), strict=True) if is_free):
            if _are_clear(box.moved(middle), lens, lens.leader, inner):
                return replace(self, words=words, middle=middle)
        return None

    def block(self, obstacles: Obstacles, since: int) -> None:
        """Add it to what other ink keeps clear of."""
        span = since, FOREVER
        for slab in self.lens.slabs:
            obstacles.box(slab, span)
        obstacles.box(self.words.box(self.middle), span)
        obstacles.line(self.lens.leader, PIXEL, span)
        ring = circle(self.lens.place, self.lens.ring)
        obstacles.line(ring, ROLES["lens place"].width, span)


def whole_words_of(setting: Setting, scale: Scale, enlarged: float) -> Iterator[Words]:
    """Yield the words below a lens with the unit of what the bar stands for, the bar shorter."""
    times, factor = roman(f"×{enlarged:g}"), enlarged * scale.factor
    for longest in (LONGEST_BAR, SHORT_BAR):
        value = scale_bar(factor, longest)
        said = setting.sheet.notation.quantity(value, setting.panel.unit, given=True)
        yield Words(times, value * factor, roman(said))


def words_of(setting: Setting, scale: Scale, enlarged: float, few: bool = False) -> Words:
    """Return the words below a lens that shows a picture of a scale so many times ``enlarged``.

    ``few`` are the factor alone.
    """
    times = roman(f"×{enlarged:g}")
    if few or scale.bare:
        return Words(times)
    factor = enlarged * scale.factor
    value = scale_bar(factor, LONGEST_BAR)
    number = setting.sheet.notation.number(value, setting.panel.unit, given=True)
    return Words(times, value * factor, roman(number))


@dataclass(frozen=True)
class Field:
    """All places of a room, and how far each is from what a lens keeps clear of.

    ``clear`` is how far each is from ink, ``roomy`` how far from what it leaves room for if it can:
    letters of dots, and faint lines; ``obstacles`` are what its words and its leader keep clear of.
    The ``leaders`` of other lenses are crossed by no leader: which is whose could not be told.
    """

    room: Rect
    grid: Complexes
    clear: Reals
    roomy: Reals
    obstacles: Obstacles
    leaders: tuple[tuple[complex, complex], ...] = ()

    @classmethod
    def of(cls, room: Rect, obstacles: Obstacles, soft: Obstacles) -> Field:
        """Return the field of a room with obstacles, and others that may be covered."""
        across = np.arange(room.left, room.right, STEP)
        upright = np.arange(room.bottom, room.top, STEP)
        grid = (across[:, None] + 1j * upright).ravel()
        clear, roomy = clearance(obstacles, grid), clearance(soft, grid)
        return cls(room, grid, clear, np.minimum(clear, roomy), obstacles)

    @cached_property
    def largest(self) -> float:
        """The radius of the largest lens that has room, where there is little."""
        aside, above = self._off_edges
        beyond = np.minimum(aside + FAR_BESIDE, above)
        return float(np.minimum(self.clear - CLEAR, beyond).max()) - BAND

    @property
    def _off_edges(self) -> tuple[Reals, Reals]:
        """How far all places are from the edges of the room: aside, and above or below."""
        room, grid = self.room, self.grid
        aside = np.minimum(grid.real - room.left, room.right - grid.real)
        return aside, np.minimum(grid.imag - room.bottom, room.top - grid.imag)

    def beside(self, spot: Spot) -> Field:
        """Return the field with a lens that stands there."""
        other = Obstacles(self.obstacles.edge)
        spot.block(other, 0)
        return replace(self.less(other), leaders=(*self.leaders, spot.lens.leader))

    def less(self, other: Obstacles) -> Field:
        """Return the field with more obstacles."""
        off, obstacles = clearance(other, self.grid), self.obstacles.copy()
        obstacles.lines += other.lines
        obstacles.boxes += other.boxes
        clear, roomy = np.minimum(self.clear, off), np.minimum(self.roomy, off)
        return Field(self.room, self.grid, clear, roomy, obstacles, self.leaders)

    def places(
        self,
        setting: Setting,
        scale: Scale,
        close: Close,
        radii: Sequence[float],
        little: bool = False,
    ) -> Iterator[Spot]:
        """Yield the best place of a lens of each of the ``radii`` that has one.

        Those that leave room for letters come first, and of them those whose leaders lie on no
        stroke; see `_best`.  Where there is ``little`` room, a lens reaches farther into the
        gutter, and has no bar.
        """
        words, grid = words_of(setting, scale, close.factor, little), self.grid
        aside, above = self._off_edges
        beyond = np.minimum(aside + (FAR_BESIDE if little else BESIDE), above)
        cost = np.abs(grid - close.middle) + INWARD * (aside + above)
        crossing: list[Spot] = []
        tried: set[float] = set()
        for clear in (self.roomy, self.clear):
            for radius in radii:
                lens = Lens(
                    close.middle, max(LEAST_RING, radius / close.factor), close.factor, 0j, radius
                )
                if radius in tried or not self._is_clear(lens):
                    continue
                room_for = radius + BAND
                apart = np.abs(grid - lens.place) >= room_for + lens.ring
                fits = np.flatnonzero((clear >= room_for + CLEAR) & (beyond >= room_for) & apart)
                spot = self._best(lens, words, grid[fits[np.argsort(cost[fits], kind="stable")]])
                if spot is None:
                    continue
                tried.add(radius)
                if spot.covered:
                    crossing.append(spot)
                else:
                    yield spot
        yield from sorted(crossing, key=lambda spot: spot.covered)

    def _with_words(self, lens: Lens, words: Words, places: list[complex]) -> list[Spot]:
        """Return the lens at some of the places, with its words below it or else above it."""
        box, inner = words.box(0j), self.room.inside(CLEAR)
        found: dict[complex, Spot] = {}
        for side in (-1j, 1j, 1.0 + 0j, -1.0 + 0j):
            half = abs(side.real) * words.wide / 2 + abs(side.imag) * words.high / 2
            off = side * (lens.radius + BELOW + half)
            middles = [at + off for at in places]
            free = self.obstacles.free(middles, words.wide, words.high, CLEAR, APART)
            for at, middle, is_free in zip(places, middles, free.tolist(), strict=True):
                line = lens.place, at
                if is_free and _are_clear(box.moved(middle), lens, line, inner):
                    found.setdefault(at, Spot(replace(lens, at=at), words, middle))
        return [found[at] for at in places if at in found]

    def _best(self, lens: Lens, words: Words, places: Complexes) -> Spot | None:
        """Return the lens at the first of the places at which its leader lies on least.

        Where it lies on a stroke at all of the first, others are tried, and then leaders that do
        not point to the middles of both circles.
        """
        spots = self._with_words(lens, words, places[:TRIED].tolist())
        best = self._least_covered(spots)
        if best and not best.covered:
            return best
        rest = places[TRIED :: max(1, (len(places) - TRIED) // TRIED)]
        others = self._with_words(lens, words, rest.tolist())
        best = _clearer(best, self._least_covered(others))
        if best and not best.covered:
            return best
        spots += others
        turned = [
            replace(spot, lens=lens)
            for spot in spots[:: max(1, len(spots) // TURNED)]
            for ends in TURNS
            if (lens := replace(spot.lens, turned=ends)).leaves(STEEP)
            if not words.box(spot.middle).inside(-CLEAR).clipped(*lens.leader)
        ]
        return _clearer(best, self._least_covered(turned))

    def _least_covered(self, spots: list[Spot]) -> Spot | None:
        """Return the first lens whose leader lies on least; it lies on no words."""
        if not spots:
            return None
        leaders = np.array([spot.lens.leader for spot in spots])
        starts, ends = leaders.T
        ways = ends - starts
        covered = self.obstacles.all_covered(starts + OFF_RING * ways / np.abs(ways), ends)
        free = self.obstacles.clear_of_labels(leaders, 2.0 * PIXEL)
        for first, last in self.leaders:
            free &= ~crossed(starts, ends, first, last)
        covered[~free] = np.inf
        best = int(covered.argmin())
        return replace(spots[best], covered=float(covered[best])) if free[best] else None

    def _is_clear(self, lens: Lens) -> bool:
        """Tell whether no words stand on the circle about the place."""
        around = list(pairwise(circle(lens.place, lens.ring)))
        return bool(self.obstacles.clear_of_labels(around, CLEAR).all())


def _clearer(usual: Spot | None, other: Spot | None) -> Spot | None:
    """Return the usual place of a lens, or another whose leader lies on clearly less."""
    if usual and other:
        return other if other.covered < usual.covered - WORTH else usual
    return usual or other


def _are_clear(there: Rect, lens: Lens, line: tuple[complex, complex], inner: Rect) -> bool:
    """Tell whether words in a box are off the circle about the place and off a line, and inside."""
    past = beyond(there, lens.place) > lens.ring + CLEAR
    corners = complex(there.left, there.bottom), complex(there.right, there.top)
    return past and not there.inside(-CLEAR).clipped(*line) and all(map(inner.holds, corners))


def beyond(box: Rect, at: complex) -> float:
    """Return how far a box is from a place."""
    off = at - box.centre
    aside, above = abs(off.real) - box.width / 2, abs(off.imag) - box.height / 2
    return float(np.hypot(max(aside, 0.0), max(above, 0.0)))


def clearance(obstacles: Obstacles, spots: Complexes) -> Reals:
    """Return how far each spot is from all ink."""
    clear = np.full(len(spots), np.inf)
    for start, end, half, _ in obstacles.lines:
        way = end - start
        if way:
            share = np.clip(((spots - start) * np.conj(way)).real / abs(way) ** 2, 0.0, 1.0)
            off = np.abs(spots - start - share * way)
        else:
            off = np.abs(spots - start)
        np.minimum(clear, off - half, out=clear)
    for box, _ in obstacles.boxes:
        off = spots - box.centre
        aside = np.maximum(np.abs(off.real) - box.width / 2, 0.0)
        above = np.maximum(np.abs(off.imag) - box.height / 2, 0.0)
        np.minimum(clear, np.hypot(aside, above), out=clear)
    return clear
