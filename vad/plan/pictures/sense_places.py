"""Where the arc arrows of ω and α of a link stand: about one end of it, on nothing.

An arrow runs across its link, or lies near the end about which it turns.  Two arrows of opposite
senses stand side by side about one end, so that they point opposite ways.  A name far from its
arrow has a leader.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vad.plan.labels.obstacles import PIXEL, Bools, Complexes, Obstacles, Reals
from vad.plan.labels.placing import APART, CLEARANCE, Placed, beside
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols

Bar = tuple[complex, complex]

#: The radii of an arrow that runs across its link, the best first, and how long it may be.
ACROSS = (0.094, 0.078, 0.064, 0.110, 0.052, 0.130, 0.042, 0.155, 0.185, 0.220, 0.260, 0.300)
LENGTHS = (0.092, 0.068, 0.050, 0.042)
#: Its longest span in degrees.
WIDEST = 100.0
#: Radius and span of an arrow beside its link, which must not be far off.
BESIDE = (
    (0.058, 66.0),
    (0.050, 72.0),
    (0.042, 80.0),
    (0.034, 90.0),
    (0.028, 100.0),
    (0.066, 56.0),
    (0.110, 46.0),
    (0.130, 38.0),
    (0.155, 32.0),
    (0.185, 27.0),
)
#: From the link to the middle of an arrow, of its span where it is across it, else in degrees.
ON, OFF = (0.0, 0.12, -0.12, 0.24, -0.24), tuple(range(-180, 180, 12))
#: Where an arrow is tried, as shares of its span from its middle: 8° apart at most.
SHARES = np.linspace(-0.5, 0.5, 13)
#: The sizes of a name.
LETTERS = (0.030, 0.028)
#: From the arrow to its name, and to other strokes; less where there is no room else.
NAMED, CLEAR, NEAR = (0.007, 0.014), 0.007, 0.003
#: Between labels where there is no room else.
TIGHT = 0.010 + 0.005j
#: An arrow ends at least so far from its own link, and its middle lies at most so far from it.
ENDS, FARTHEST = 0.011, 0.066
#: A stroke with a smaller half width is a thin grey one: an axis, an arc, a leader.
THIN = 0.0015
#: The cosine between two directions that are seen to be opposite.
AGAINST = -0.85
#: How much worse an arrow is beside its link, nearer to another one, about an end that is not
#: fixed where the other one is, with small letters, and with a leader.
ASIDE, STRANGE, LOOSE, SMALL, LED = 1.0, 4.0, 1.5, 0.3, 3.0
#: Of a leader: its lengths, its directions, from the arrow to its start, from its end to the name,
#: and to how many arrows one is tried.
LEADERS, FAN = (0.025, 0.045, 0.070, 0.100, 0.130), np.exp(2j * np.pi * np.arange(16) / 16)
START, GAP, LED_ARROWS = 0.008, 0.005, 24
#: So much of a leader lies at most on the stroke that it crosses, where every one crosses some.
ONE_STROKE = 0.016
#: So many arrows of one sense are tried with one of the other.
MOST_PAIRS = 40
#: What lies so near the axis of a link belongs to it.
_OWN = 0.004


@dataclass(frozen=True, slots=True)
class SensePlace:
    """Where an arrow stands: its centre, radius, span and middle, its name, and a leader to it."""

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
        """Let what is placed later keep clear of the arrow, its name and its leader."""
        obstacles.box(self.name.box)
        obstacles.line(self.line, 2.0 * PIXEL)
        if self.name.leader:
            obstacles.line(self.name.leader, PIXEL)


@dataclass(frozen=True)
class Places:
    """All places for the arrows of one link.

    Attributes
    ----------
    drawn
        The mechanism and its letters, which they keep clear of.
    bars, others
        The bars of the link, and those of other links, to which no arrow is to seem to belong.
    pivots
        The fixed pivots: about one of them a link turns.
    thin
        Arrows may cross strokes with smaller half widths; if there are such, they may stand nearer
        to what else there is.
    farthest
        How far from the link the middle of an arrow lies at most.
    """

    drawn: Obstacles
    bars: Sequence[Bar]
    others: Sequence[Bar]
    pivots: Sequence[complex]
    thin: float = 0.0
    farthest: float = FARTHEST

    def find(
        self,
        taken: Obstacles,
        senses: Sequence[tuple[float, str]],
        there: tuple[complex, complex] | None = None,
    ) -> list[SensePlace | None]:
        """Return the places of one or two arrows, given by sign and name; None without room.

        Parameters
        ----------
        taken
            What is drawn by now: first what was ``drawn``, then what came later.
        senses
            The arrows.
        there
            The centre and the direction of an arrow of the link that stands already, of the other
            sense.
        """
        if len(senses) == 1 and there:
            (sense,) = senses
            for together in (True, False):
                found = self._against(taken, there, sense, together)
                if found:
                    return [found]
        if len(senses) != 2:
            return [next(self.of(taken, *sense), None) for sense in senses]
        one, other = senses
        firsts = [*itertools.islice(self.of(taken, *one), MOST_PAIRS)]
        for together, first in itertools.product((True, False), firsts):
            crowd = taken.copy()
            first.block(crowd)
            second = self._against(crowd, (first.centre, first.way(one[0])), other, together)
            if second:
                return [first, second]
        return [firsts[0], None] if firsts else [None, next(self.of(taken, *other), None)]

    def _against(
        self,
        taken: Obstacles,
        there: tuple[complex, complex],
        sense: tuple[float, str],
        together: bool,
    ) -> SensePlace | None:
        """Return the best place of an arrow that points against one that is there.

        Both stand about one end if they are to be ``together``.
        """
        centre, way = there
        ways = sense[0] * 1j * np.exp(1j * np.radians(self.middles))
        good: Bools = (ways * way.conjugate()).real < AGAINST
        if together:
            good &= np.abs(self.centres - centre) < PIXEL
        return next(self.of(taken, *sense, good), None)

    @property
    def _clear(self) -> float:
        return NEAR if self.thin else CLEAR

    @property
    def _margin(self) -> float:
        return NEAR if self.thin else CLEARANCE

    @property
    def _apart(self) -> complex:
        return TIGHT if self.thin else APART

    def of(
        self, taken: Obstacles, sign: float, name: str, good: Bools | None = None
    ) -> Iterator[SensePlace]:
        """Yield the places of an arrow and its name, the best first, those with a leader last."""
        costs = self.costs + 0.1 * (self.sides * sign < 0.0)
        free = self.free if good is None else self.free & good
        order = [each for each in np.argsort(costs, kind="stable").tolist() if free[each]]
        new = Obstacles(taken.edge, taken.lines[len(self.drawn.lines) :])
        bare = []
        for number in order:
            line = self.lines[number].tolist()
            if not taken.clear_of_labels([*itertools.pairwise(line)], self._clear).all():
                continue
            if not new.free(line, 0.0, 0.0, self._clear + 2.0 * PIXEL).all():
                continue
            found = self._named(taken, number, sign, name, float(costs[number]))
            if found:
                yield found
            else:
                bare.append(number)
        led = [self._led(taken, each, name, float(costs[each])) for each in bare[:LED_ARROWS]]
        yield from sorted((each for each in led if each), key=lambda each: each.cost)

    def _named(
        self, taken: Obstacles, number: int, sign: float, name: str, cost: float
    ) -> SensePlace | None:
        own = Obstacles(taken.edge)
        own.line(self.lines[number].tolist(), 2.0 * PIXEL)
        for letter in LETTERS:
            wide, high = ink_size(symbols(name), letter)
            spots = list(self._spots(number, sign, wide, high))
            clear = taken.free(spots, wide, high, self._margin, self._apart)
            clear &= own.free(spots, wide, high, 2.0 * PIXEL)
            if clear.any():
                placed = Placed(spots[int(clear.argmax())], wide, high)
                return self._place(number, placed, letter, cost + SMALL * (letter < LETTERS[0]))
        return None

    def _spots(self, number: int, sign: float, wide: float, high: float) -> Iterator[complex]:
        """Yield places of a name: outside of the arrow, inside, and behind its tail."""
        at, radius = complex(self.centres[number]), float(self.radii[number])
        middle, span = float(self.middles[number]), float(self.spans[number])
        for gap, side, turn in itertools.product(NAMED, (1, -1), (0.0, -0.4, 0.4, -0.2, 0.2)):
            out = _ray(middle + sign * turn * span)
            yield beside(at + radius * out, side * out, gap, wide, high)
        tail = _ray(middle - sign * 0.5 * span)
        for gap in NAMED:
            yield beside(at + radius * tail, -sign * 1j * tail, gap, wide, high)

    def _led(self, taken: Obstacles, number: int, name: str, cost: float) -> SensePlace | None:
        """Return an arrow whose name stands far off, with a leader that crosses nothing."""
        wide, high = ink_size(symbols(name), LETTERS[0])
        line = self.lines[number]
        own = Obstacles(taken.edge)
        own.line(line.tolist(), 2.0 * PIXEL)
        starts = line[[2, -3, len(line) // 2]]
        # Rows are leaders, by length, start and direction: the shortest first.
        ways = np.tile(FAN, len(LEADERS) * len(starts))
        feet = np.tile(np.repeat(starts, len(FAN)), len(LEADERS)) + START * ways
        ends = feet + np.repeat(LEADERS, len(starts) * len(FAN)) * ways
        spots = [beside(end, way, GAP, wide, high) for end, way in zip(ends, ways, strict=True)]
        free = taken.free(spots, wide, high, self._margin, self._apart)
        free &= own.free(spots, wide, high, CLEARANCE)
        crossing = None
        for each in np.flatnonzero(free).tolist():
            foot, end = complex(feet[each]), complex(ends[each])
            if not taken.clear_of_labels([(foot, end)], CLEARANCE).all():
                continue
            if own.covered(foot, end):
                continue
            spot = Placed(complex(spots[each]), wide, high, (foot, end))
            covered = taken.covered(foot, end)
            if not covered:
                return self._place(number, spot, LETTERS[0], cost + LED)
            if covered < ONE_STROKE and crossing is None:
                crossing = self._place(number, spot, LETTERS[0], cost + 2.0 * LED)
        return crossing

    def _place(self, number: int, name: Placed, letter: float, cost: float) -> SensePlace:
        return SensePlace(
            complex(self.centres[number]),
            float(self.radii[number]),
            float(self.spans[number]),
            float(self.middles[number]),
            name,
            letter,
            cost,
        )

    # --- arrays: one row for each arrow, whatever its sense ---

    @cached_property
    def _table(self) -> list[tuple[complex, float, float, float, float, float]]:
        """Centre, radius, span, middle, side and cost of all arrows."""
        ends = [each for start, end in self.bars for each in ((start, end), (end, start))]
        fixed = [at for at, _ in ends if any(abs(at - each) < _OWN for each in self.pivots)]
        found = []
        for at, to in ends:
            ahead, length = math.degrees(np.angle(to - at)), abs(to - at)
            loose = bool(fixed) and at not in fixed
            if not loose:
                for (rank, radius), (less, long), share in itertools.product(
                    enumerate(ACROSS), enumerate(LENGTHS), ON
                ):
                    span = math.degrees(long / radius)
                    if radius < 0.92 * length and span < WIDEST:
                        cost = 0.08 * rank + 0.3 * less + 0.6 * abs(share)
                        found.append((at, radius, span, ahead + share * span, 0.0, cost))
            for (rank, (radius, span)), off in itertools.product(enumerate(BESIDE), OFF):
                if not loose or abs(off) >= 90:
                    cost = ASIDE + LOOSE * loose + 0.12 * rank + 0.004 * abs(off)
                    found.append((at, radius, span, ahead + off, float(np.sign(off)), cost))
        return found

    @cached_property
    def centres(self) -> Complexes:
        """The ends about which the arrows stand."""
        return np.array([each[0] for each in self._table])

    @cached_property
    def radii(self) -> Reals:
        """Their radii."""
        return np.array([each[1] for each in self._table])

    @cached_property
    def spans(self) -> Reals:
        """How long they are, in degrees."""
        return np.array([each[2] for each in self._table])

    @cached_property
    def middles(self) -> Reals:
        """Where their middles are, in degrees."""
        return np.array([each[3] for each in self._table])

    @cached_property
    def sides(self) -> Reals:
        """On which side of the link they lie: 1 on the left, 0 across it."""
        return np.array([each[4] for each in self._table])

    @cached_property
    def lines(self) -> Complexes:
        """Points along the arrows."""
        turns = np.radians(self.middles[:, None] + self.spans[:, None] * SHARES)
        points: Complexes = self.centres[:, None] + self.radii[:, None] * np.exp(1j * turns)
        return points

    @cached_property
    def costs(self) -> Reals:
        """How bad each of them is."""
        own = np.array([each[5] for each in self._table])
        middle = self.lines[:, len(SHARES) // 2]
        strange = distances(middle, self.others) < distances(middle, self.bars)
        costs: Reals = own + STRANGE * strange
        return costs

    @cached_property
    def free(self) -> Bools:
        """Which of them meet nothing but their own link, and that not with an end."""
        lines = self.lines
        foreign = Obstacles(
            self.drawn.edge,
            [
                each
                for each in self.drawn.lines
                if each[2] >= self.thin and not any(_along(each, bar) for bar in self.bars)
            ],
        )
        clear = distances(lines[:, len(SHARES) // 2], self.bars) < self.farthest
        for end in (0, -1):
            clear &= distances(lines[:, end], self.bars) > ENDS
        for some in (lines[:, :: len(SHARES) - 1], lines):  # most meet something at an end
            left = np.flatnonzero(clear)
            free = foreign.free(some[left].ravel().tolist(), 0.0, 0.0, self._clear)
            clear[left] = free.reshape(len(left), -1).all(axis=1)
        aside = self.sides != 0.0
        near = distances(lines.ravel(), self.bars).reshape(lines.shape).min(axis=1) < ENDS
        found: Bools = clear & ~(aside & near)
        return found


def distances(spots: Complexes, bars: Sequence[Bar]) -> Reals:
    """Return how far places are from the nearest of some bars."""
    found = np.full(spots.shape, np.inf)
    for start, end in bars:
        way = end - start
        along = np.clip(((spots - start) * way.conjugate()).real / abs(way) ** 2, 0.0, 1.0)
        found = np.minimum(found, np.abs(spots - start - along * way))
    return found


def _along(line: tuple[complex, complex, float, object], bar: Bar) -> bool:
    """Tell whether a stroke lies along a bar, or is a joint at one of its ends."""
    ends = np.array(line[:2])
    return bool((distances(ends, [bar]) < _OWN).all())


def _ray(degrees: float) -> complex:
    return complex(math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
