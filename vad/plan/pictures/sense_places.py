"""Where the arc arrows of ω and α of a link stand: about one end of it, on nothing.

An arrow runs across its link, or lies near the end about which it turns.  Two arrows of opposite
senses stand side by side about one end, so that they point opposite ways.  A name is nearer to its
own arrow than to any other.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import NamedTuple

import numpy as np

from vad.plan.labels.obstacles import PIXEL, Bools, Complexes, Integers, Obstacles, Reals
from vad.plan.labels.placing import APART, CLEARANCE, Placed
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols

Bar = tuple[complex, complex]

#: The radii of an arrow that runs across its link, the best first, and how long it may be.
ACROSS = (0.094, 0.078, 0.064, 0.110, 0.052, 0.130, 0.042, 0.155, 0.185, 0.220, 0.260, 0.300)
LENGTHS = (0.092, 0.068, 0.050, 0.042)
#: Its longest span in degrees, and its shortest: less looks straight.
WIDEST, CURVED = 100.0, 30.0
#: Radius and span of an arrow beside its link, which must not be far off.
BESIDE = (
    (0.058, 66.0),
    (0.050, 72.0),
    (0.042, 80.0),
    (0.034, 90.0),
    (0.028, 100.0),
    (0.066, 56.0),
    (0.074, 50.0),
    (0.058, 46.0),
    (0.050, 54.0),
    (0.042, 62.0),
    (0.074, 36.0),
    (0.110, 46.0),
    (0.130, 38.0),
    (0.155, 32.0),
    (0.185, 30.0),
    (0.028, 80.0),
    (0.034, 70.0),
    (0.092, 50.0),
    (0.092, 36.0),
    (0.066, 40.0),
    (0.022, 110.0),
    (0.022, 90.0),
)
#: How far beyond the other end of the link one runs that turns about both.
PAST = (0.030, 0.042, 0.054)
#: The cosine between the directions to an arrow from its centre and from its pivot, at least.
ALIKE = 0.87
#: From the link to the middle of an arrow, of its span where it is across it, else in degrees.
ON, OFF = (0.0, 0.12, -0.12, 0.24, -0.24), tuple(range(-180, 180, 12))
#: Where an arrow is tried, as shares of its span from its middle: 8° apart at most.
SHARES = np.linspace(-0.5, 0.5, 13)
#: The sizes of a name.
LETTERS = (0.030, 0.028)
#: From an arrow to its name, to other strokes, and to the names of others.
NAMED, CLEAR, STRANGERS = (0.007, 0.010), 0.007, 0.013
#: The places of a name: where on the arrow, as a share of its span from its middle, ahead by the
#: sign of its sense; to which side of it, the outside being 1 and ahead 1j; and how far from it.
NAME_SHARES, NAME_WAYS, NAME_GAPS = map(
    np.array,
    zip(
        *(
            (share, side, gap)
            for gap in NAMED
            for side in (1.0, -1.0)
            for share in (0.0, -0.4, 0.4, -0.2, 0.2)
        ),
        *((0.5 * end, 1j * end, gap) for end in (-1.0, 1.0) for gap in NAMED),
        strict=True,
    ),
)
#: An arrow ends at least so far from its own link, and its middle lies at most so far from it.
ENDS, FARTHEST = 0.012, 0.075
#: The cosine between two directions that are seen to be opposite.
AGAINST = -0.85
#: How much worse an arrow is beside its link, beyond both ends, about an end that is no anchor, and
#: with small letters.
ASIDE, FAR_END, LOOSE, SMALL = 1.0, 1.5, 1.5, 0.3
#: So many arrows are looked at together, and so many of one sense are tried with one of the other.
AT_ONCE, MOST_PAIRS = 16, 40
#: What lies so near the axis of a link belongs to it.
_OWN = 0.004


@dataclass(frozen=True, slots=True)
class SensePlace:
    """Where an arrow stands: its centre, radius, span and middle, and its name."""

    centre: complex
    radius: float
    span: float
    middle: float
    name: Placed
    letter: float
    cost: float

    @property
    def line(self) -> list[complex]:
        """Points along the arrow."""
        turns = np.radians(self.middle + self.span * SHARES)
        points: list[complex] = (self.centre + self.radius * np.exp(1j * turns)).tolist()
        return points

    def way(self, sign: float) -> complex:
        """Return where it points at its middle, with the ``sign`` of its sense."""
        return sign * 1j * np.exp(1j * math.radians(self.middle))  # type: ignore[no-any-return]

    def block(self, obstacles: Obstacles) -> None:
        """Let what is placed later keep clear of the arrow and of its name."""
        obstacles.box(self.name.box.inside(CLEAR - STRANGERS))
        obstacles.line(self.line, 2.0 * PIXEL)


class _Arrows(NamedTuple):
    """All arrows of a link, as arrays: a row for each, whatever its sense.

    Attributes
    ----------
    centres, radii
        The ends about which they stand, and how far from these.
    spans, middles
        How long they are, and where their middles are, in degrees.
    sides
        On which side of the link they lie: 1 on the left, 0 across it.
    costs
        How bad they are by themselves.
    """

    centres: Complexes
    radii: Reals
    spans: Reals
    middles: Reals
    sides: Reals
    costs: Reals


@dataclass(frozen=True)
class Places:
    """All places for the arrows of one link.

    Attributes
    ----------
    drawn
        The mechanism and its letters, which they keep clear of.
    bars, others
        The bars of the link, and those of other links, to which no arrow is to seem to belong.
    pivots, joints, ends
        Its fixed pivots, its joints, and all of its lettered points.  An arrow stands about an
        anchor, or beyond another joint, where both see it turn alike.  Its middle is nearer to its
        centre than to any of them outside of its circle.
    seen_from
        The joint from which captions see a link turn that has no pivot.  About another one an
        arrow would point against what they say.
    farthest
        How far from the link the middle of an arrow lies at most.
    """

    drawn: Obstacles
    bars: Sequence[Bar]
    others: Sequence[Bar]
    pivots: Sequence[complex]
    joints: Sequence[complex]
    ends: Sequence[complex]
    seen_from: complex | None = None
    farthest: float = FARTHEST

    def find(
        self, taken: Obstacles, senses: Sequence[tuple[float, str]]
    ) -> list[SensePlace | None]:
        """Return the places of one or two arrows, given by sign and name; None without room.

        By now there is what is ``taken``: first what was ``drawn``, then what came later.
        """
        if len(senses) != 2:
            return [next(self.of(taken, *sense), None) for sense in senses]
        one, other = senses
        firsts, again = itertools.tee(itertools.islice(self.of(taken, *one), MOST_PAIRS))
        pairs = itertools.chain(
            zip(itertools.repeat(True), firsts), zip(itertools.repeat(False), again)
        )
        alone: SensePlace | None = None
        clear: Bools | None = None
        for together, first in pairs:
            alone = alone or first
            crowd = taken.copy()
            first.block(crowd)
            way = first.way(one[0])
            second = self._against(crowd, (first.centre, way), other, together, clear)
            if second:
                return [first, second]
            if clear is None:  # what meets something now does so beside all the others, too
                clear = np.zeros(len(self.apt), bool)
                clear[[*self._clear_of(taken, np.flatnonzero(self.apt))]] = True
        return [alone, None] if alone else [None, next(self.of(taken, *other), None)]

    def _against(
        self,
        taken: Obstacles,
        there: tuple[complex, complex],
        sense: tuple[float, str],
        together: bool,
        clear: Bools | None = None,
    ) -> SensePlace | None:
        """Return the best place of an arrow that points against one that is there.

        Both stand about one end if they are to be ``together``.  Where it is known, ``clear`` tells
        which arrows meet nothing.
        """
        centre, way = there
        ways = sense[0] * 1j * np.exp(1j * np.radians(self._arrows.middles))
        good: Bools = (ways * way.conjugate()).real < AGAINST
        if together:
            good &= np.abs(self._arrows.centres - centre) < PIXEL
        if clear is not None:
            good &= clear
        return next(self.of(taken, *sense, good), None)

    def of(
        self, taken: Obstacles, sign: float, name: str, good: Bools | None = None
    ) -> Iterator[SensePlace]:
        """Yield the places of an arrow and its name, the best first."""
        costs = self._arrows.costs + 0.1 * (self._arrows.sides * sign < 0.0)
        left = np.flatnonzero(self.apt if good is None else self.apt & good)
        order = left[np.argsort(costs[left], kind="stable")]
        for number in self._clear_of(taken, order):
            found = self._named(taken, number, sign, name, float(costs[number]))
            if found:
                yield found

    def _clear_of(self, taken: Obstacles, order: Integers) -> Iterator[int]:
        """Yield those of some arrows that meet nothing, and no label."""
        new = self._placed(taken)
        first, count = 0, AT_ONCE
        while first < len(order):  # each round looks at the next ones
            some = order[first : first + count]
            first, count = first + count, 2 * count  # most often one of the first ones suffices
            some = some[self._free(some)]
            lines = self.lines[some]
            strokes = np.stack([lines[:, :-1], lines[:, 1:]], axis=-1)
            bare = taken.clear_of_labels(strokes, CLEAR).reshape(strokes.shape[:2])
            clear: Bools = np.asarray(bare.all(axis=1))
            clear[clear] = _all_free(new, lines[clear], CLEAR + 2.0 * PIXEL)
            yield from some[clear].tolist()

    def _free(self, some: Integers) -> Bools:
        """Tell which of some arrows meet nothing that is drawn but their own link."""
        asked, free = self._told
        new = some[~asked[some]]
        asked[new] = True
        for step in (len(SHARES) - 1, 1):  # most meet something at an end
            new = new[_all_free(self._foreign, self.lines[new, ::step], CLEAR)]
        free[new] = True
        return free[some]

    def _named(
        self, taken: Obstacles, number: int, sign: float, name: str, cost: float
    ) -> SensePlace | None:
        own, others = Obstacles(taken.edge), self._placed(taken)
        own.line(self.lines[number].tolist(), 2.0 * PIXEL)
        for letter in LETTERS:
            wide, high = ink_size(symbols(name), letter)
            spots = self._spots(number, sign, wide, high)
            clear = taken.free(spots, wide, high, CLEARANCE, APART)
            for lines, margin in ((own, 2.0 * PIXEL), (others, STRANGERS)):
                if clear.any():
                    clear &= lines.free(spots, wide, high, margin)
            if clear.any():
                placed = Placed(complex(spots[clear.argmax()]), wide, high)
                return self._place(number, placed, letter, cost + SMALL * (letter < LETTERS[0]))
        return None

    def _placed(self, taken: Obstacles) -> Obstacles:
        """Return the arrows that were placed after what was ``drawn``."""
        return Obstacles(taken.edge, taken.lines[len(self.drawn.lines) :])

    def _spots(self, number: int, sign: float, wide: float, high: float) -> Complexes:
        """Return places of a name: outside of the arrow, inside, behind its tail, before its tip.

        They are as `beside` has them, all at once.
        """
        at, radius, span, middle = (column[number] for column in self._arrows[:4])
        outs = np.exp(1j * np.radians(middle + sign * span * NAME_SHARES))
        ways = outs * (NAME_WAYS if sign > 0.0 else NAME_WAYS.conjugate())
        aside, above = (np.maximum(np.abs(part), 1e-9) for part in (ways.real, ways.imag))
        reach = np.minimum(wide / 2 / aside, high / 2 / above)
        spots: Complexes = at + radius * outs + ways * (NAME_GAPS + reach)
        return spots

    def _place(self, number: int, name: Placed, letter: float, cost: float) -> SensePlace:
        return SensePlace(
            complex(self._arrows.centres[number]),
            float(self._arrows.radii[number]),
            float(self._arrows.spans[number]),
            float(self._arrows.middles[number]),
            name,
            letter,
            cost,
        )

    # --- arrays: one row for each arrow, whatever its sense ---

    @property
    def anchors(self) -> Sequence[complex]:
        """The pivots of the link; where it has none, the joint from which captions see it turn."""
        return self.pivots or ([] if self.seen_from is None else [self.seen_from])

    @cached_property
    def _arrows(self) -> _Arrows:
        centres, tables = [np.empty(0, complex)], [np.empty((5, 0))]
        for at, to in (each for start, end in self.bars for each in ((start, end), (end, start))):
            if _among(at, self.joints):
                ahead, length = math.degrees(np.angle(to - at)), abs(to - at)
                across = _across()
                table = np.hstack([across[:, across[0] < 0.92 * length], _beside(), _past(length)])
                table[2] += ahead
                if self.anchors:
                    table[4] += LOOSE * (not _among(at, self.anchors))
                tables.append(table)
                centres.append(np.full(table.shape[1], at))
        return _Arrows(np.concatenate(centres), *np.hstack(tables))

    @cached_property
    def lines(self) -> Complexes:
        """Points along the arrows."""
        turns = np.radians(self._arrows.middles[:, None] + self._arrows.spans[:, None] * SHARES)
        points: Complexes = self._arrows.centres[:, None] + self._arrows.radii[:, None] * np.exp(
            1j * turns
        )
        return points

    @cached_property
    def apt(self) -> Bools:
        """Which of them lie near enough to their own link, nearest to it, and end beside it."""
        lines = self.lines
        middles = lines[:, len(SHARES) // 2]
        off = distances(middles, self.bars)
        apt = np.asarray((off < self.farthest) & (off <= distances(middles, self.others) + PIXEL))
        if self.anchors:
            outs = np.exp(1j * np.radians(self._arrows.middles))
            seen = (middles[:, None] - np.array(self.anchors)) * outs[:, None].conjugate()
            apt &= (seen.real > ALIKE * np.abs(seen)).any(axis=1)
        for end in self.ends:  # those within its circle it turns about as well
            within = np.abs(self._arrows.centres - end) < self._arrows.radii
            apt &= within | (np.abs(middles - end) > self._arrows.radii)
        for end in (0, -1):
            apt[apt] = distances(lines[apt, end], self.bars) > ENDS
        aside = np.flatnonzero(apt & (self._arrows.sides != 0.0))
        apt[aside] = distances(lines[aside], self.bars).min(axis=1) >= ENDS
        return apt

    @cached_property
    def _foreign(self) -> Obstacles:
        """What is drawn and is not their own link."""
        kept = self.drawn.lines
        starts, ends = (np.array([each[end] for each in kept], complex) for end in (0, 1))
        own = np.zeros(len(kept), bool)
        for bar in self.bars:  # a stroke along it, or a joint at one of its ends
            own |= (distances(starts, [bar]) < _OWN) & (distances(ends, [bar]) < _OWN)
        return Obstacles(self.drawn.edge, [*itertools.compress(kept, ~own)])

    @cached_property
    def _told(self) -> tuple[Bools, Bools]:
        """Of which arrows it is known whether they are free, and which of them are."""
        return np.zeros(len(self.apt), bool), np.zeros(len(self.apt), bool)


@cache
def _across() -> Reals:
    """Return what `Places` has of arrows across a link that points to the right."""
    found = []
    for (rank, radius), (less, long), share in itertools.product(
        enumerate(ACROSS), enumerate(LENGTHS), ON
    ):
        span = math.degrees(long / radius)
        if span < CURVED and not less:
            span = CURVED
        if CURVED <= span < WIDEST:
            cost = 0.08 * rank + 0.3 * less + 0.6 * abs(share)
            found.append((radius, span, share * span, 0.0, cost))
    return np.array(found).T


@cache
def _beside() -> Reals:
    """Return the same of arrows beside it."""
    found = []
    for (rank, (radius, span)), off in itertools.product(enumerate(BESIDE), OFF):
        cost = ASIDE + 0.12 * rank + 0.004 * abs(off)
        found.append((radius, span, off, float(np.sign(off)), cost))
    return np.array(found).T


def _past(length: float) -> Reals:
    """Return the same of arrows beyond the other end of a link of a length."""
    found = []
    for (rank, past), off in itertools.product(enumerate(PAST), (0, 12, -12, 24, -24)):
        radius = length + past
        span = max(CURVED, math.degrees(LENGTHS[1] / radius))
        if radius <= ACROSS[-1] and span < WIDEST:
            cost = ASIDE + FAR_END + 0.12 * rank + 0.02 * abs(off)
            found.append((radius, span, off, 1.0, cost))
    return np.array(found).reshape(-1, 5).T


def _among(at: complex, some: Sequence[complex]) -> bool:
    """Tell whether a place is one of some."""
    return any(abs(at - each) < _OWN for each in some)


def _all_free(obstacles: Obstacles, lines: Complexes, clear: float) -> Bools:
    """Tell for which rows every point is so far from all obstacles."""
    free = obstacles.free(lines.ravel(), 0.0, 0.0, clear).reshape(lines.shape)
    return np.asarray(free.all(axis=1))


def distances(spots: Complexes, bars: Sequence[Bar]) -> Reals:
    """Return how far places are from the nearest of some bars."""
    found = np.full(spots.shape, np.inf)
    for start, end in bars:
        way = end - start
        square = max(abs(way), 1e-9) ** 2  # a bar may be as short as a point
        along = np.clip(((spots - start) * way.conjugate()).real / square, 0.0, 1.0)
        found = np.minimum(found, np.abs(spots - start - along * way))
    return found
