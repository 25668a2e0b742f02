"""How a found ω or α goes to its link in a film: its number leaves the caption, and bends.

A copy of the number flies from the caption to the link, with a straight arrow beneath it.  There
the number fades, and the arrow bends to that of the sense of ω or α, which stays.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from vad.lecture.moment import smooth
from vad.plan.items import FLIGHT, FOREVER, Item
from vad.plan.labels.obstacles import Bools, Obstacles, Reals
from vad.plan.lettering.glyphs import width
from vad.plan.marks import (
    Bending,
    Bow,
    Fading,
    Flying,
    Leg,
    Lettering,
    Mark,
    Polygon,
    bent,
)
from vad.plan.page.quarter import without_turn

#: When the number leaves, when it arrives, and when the arrow is bent: shares of the whole.
LEAVES, ARRIVES, BENT = 0.06, 0.55, 0.92
#: When the arrow below the number is there; when the number fades; when the name comes.
ARROW, FADES, NAMED = (0.20, 0.32), (0.70, 0.90), (0.80, 0.95)
#: When a number has risen off its caption, and when it flies on, a little before: shares of the
#: time of its flight.
RISES, FLIES_ON = 0.30, 0.24
#: How far the arrow is bent that looks straight, in degrees.
STRAIGHT = 3.0
#: From the baseline of a number to the arrow below it, in its size.
BELOW = 0.5
#: How far letters reach below their baseline, in their size.
DESCENT = 0.25
#: How high a number flies, of its way, to either side, and how much later than in the middle it is
#: highest: the first of those that cross least.
ARCHES = tuple(
    (side * high, late)
    for high, late in (
        (0.10, 0),
        (0.25, 0),
        (0.25, 1),
        (0.25, -1),
        (0.40, 0),
        (0.40, 1),
        (0.40, -1),
    )
    for side in (1, -1)
)
PARTS = 32
#: To be over something at one more of so many moments is as bad as to cross so much of another.
HOVERS = 0.3


class Way(NamedTuple):
    """The way of a number, on which it rises first from what is said beside it.

    Attributes
    ----------
    start, end
        Where it begins and ends.
    off
        The height to which it rises first.
    arch, late
        How high it flies then, of its way, and when: 0 if it is highest in the middle, 1 or -1 if
        later or earlier.
    """

    start: complex
    end: complex
    off: float
    arch: float
    late: int

    def at(self, time: float) -> complex:
        """Return where it is at a share of its time."""
        start, end = self.start, self.end
        high = complex(start.real, max(start.imag, min(self.off, end.imag)))
        risen, flown = _part(time, 0.0, RISES), _part(time, FLIES_ON, 1.0)
        way = end - high
        tilt = {0: 4.0, 1: 6.75 * flown, -1: 6.75 * (1.0 - flown)}[self.late]
        arched = flown * way + tilt * flown * (1.0 - flown) * self.arch * 1j * way
        return start + risen * (high - start) + complex(arched.real, max(arched.imag, 0.0))


def sent(
    senses: Iterable[Item],
    numbers: Mapping[str, tuple[Lettering, int]],
    words: Obstacles,
    letters: Obstacles,
) -> Iterator[Item]:
    """Yield the senses of rates with their flights, which take place while their stroke rests.

    Parameters
    ----------
    senses
        Their items, as a still has them: an arrow with its name, or a further name beside it.
    numbers
        For the full name of a stroke the number in its caption that flies, and the beat in which it
        is said.
    words, letters
        What it should not cross: the words beside the panels, and then the letters and lenses in
        them.
    """
    for item in senses:
        number = numbers.get(item.stroke)
        if number is None:
            yield item
            continue
        span = item.since, item.since + 1
        texts = words.during(span), letters.during(span)
        marks, said = tuple(_flying(item.marks, number[0], *texts)), (number[1], FOREVER)
        yield Item(item.stroke, FLIGHT, item.level, marks, *span, said)
        yield replace(item, since=item.since + 1)


def to_rows(
    rows: Iterable[Item],
    senses: Iterable[Item],
    numbers: Mapping[str, tuple[Lettering, int]],
    words: Obstacles,
    letters: Obstacles,
) -> Iterator[Item]:
    """Yield the flights of numbers to rows of the results, where a link has no room for an arrow.

    Parameters
    ----------
    rows
        What stands there; what a stroke has just found grows.
    senses, numbers, words, letters
        As for `sent`.
    """
    done = {item.stroke for item in senses}
    for item in rows:
        mark = item.marks[0]
        if not item.grows or item.stroke not in numbers.keys() - done:
            continue
        assert isinstance(mark.shape, Lettering)
        done.add(item.stroke)
        (number, said), goal = numbers[item.stroke], mark.shape
        size, wide = goal.size / number.size, width(number.runs, number.size)
        # The middle of the number flies so that it ends where the row ends.
        start = number.at + wide / 2
        end = goal.at + width(without_turn(goal.runs), goal.size) - size * wide / 2
        span = item.since, item.since + 1
        way = _way(number, (start, end), size, words.during(span), letters.during(span))
        legs = []
        for share in _shares():
            part, time = _part(share, LEAVES, BENT), _time(share, LEAVES, BENT)
            spot, ink = way.at(time), 1.0 - _part(share, BENT, 1.0)
            legs.append(Leg(share, spot - start, 1.0 + (size - 1.0) * part, 0.0, ink))
        flies = Mark(number, "letter", growth=Flying(start, tuple(legs)))
        yield Item(item.stroke, FLIGHT, item.level, (flies,), *span, (said, FOREVER))


def _flying(
    marks: Iterable[Mark], number: Lettering, words: Obstacles, letters: Obstacles
) -> Iterator[Mark]:
    """Yield the marks of a sense on their way, and the number that comes with them."""
    *arrow, name = marks
    goal = name.shape
    assert isinstance(goal, Lettering)
    yield replace(name, growth=Fading(((NAMED[0], 0.0), (NAMED[1], 1.0))))
    size = goal.size / number.size
    wide = width(number.runs, number.size)
    # The middle of the number flies to that of the name.
    start, end = number.at + wide / 2, goal.at + width(goal.runs, goal.size) / 2
    flown = _way(number, (start, end), size, words, letters)
    times = [(share, _time(share, LEAVES, ARRIVES)) for share in _shares()]
    way = [(share, flown.at(time)) for share, time in times]
    legs = [
        Leg(
            share,
            spot - start,
            1.0 + (size - 1.0) * _part(share, LEAVES, ARRIVES),
            0.0,
            1.0 - _part(share, *FADES),
        )
        for share, spot in way
    ]
    yield Mark(number, "numeral", name.row, Flying(start, tuple(legs)))
    for mark in arrow:
        if isinstance(mark.shape, Bow):
            bow, own = mark.shape, list(_bending(mark.shape, way, number.size, goal.size))
            yield replace(mark, growth=Bending(tuple(own)))
        elif isinstance(mark.shape, Polygon):
            yield replace(mark, growth=_at_end(bow, own))
        else:  # a leader comes with the name
            yield replace(mark, growth=Fading(((NAMED[0], 0.0), (NAMED[1], 1.0))))


def _bending(
    bow: Bow, way: Iterable[tuple[float, complex]], first: float, last: float
) -> Iterator[Leg]:
    """Yield how an arrow flies below a number, of a first and a last size, and bends at last."""
    middle = bow.start + bow.sweep / 2
    place = bow.centre + cmath.rect(bow.radius, math.radians(middle))
    straight = STRAIGHT / max(abs(bow.sweep), STRAIGHT)
    level = math.remainder(-(middle + math.copysign(90.0, bow.sweep)), 360.0)
    for share, spot in way:
        flown, done = _part(share, LEAVES, ARRIVES), _part(share, ARRIVES, BENT)
        below = spot - 1j * BELOW * (first + (last - first) * flown) - place
        factor = straight + (1.0 - straight) * done
        yield Leg(share, (1.0 - done) * below, factor, (1.0 - done) * level, _part(share, *ARROW))


def _at_end(bow: Bow, legs: Iterable[Leg]) -> Flying:
    """Return how the head of an arrow stays at the end of its arc."""

    def end(arc: Bow) -> complex:
        return arc.centre + cmath.rect(arc.radius, math.radians(arc.start + arc.sweep))

    found = []
    for leg in legs:
        arc = bent(bow, leg)
        turned = arc.start + arc.sweep - bow.start - bow.sweep
        found.append(Leg(leg.share, end(arc) - end(bow), 1.0, turned, leg.ink))
    return Flying(end(bow), tuple(found))


def _shares() -> Iterator[float]:
    return (part / PARTS for part in range(PARTS + 1))


def _part(share: float, start: float, end: float) -> float:
    """Return how much of what takes place between two shares is done."""
    return smooth(_time(share, start, end))


def _time(share: float, start: float, end: float) -> float:
    """Return how much of the time between two shares is over."""
    return min(max((share - start) / (end - start), 0.0), 1.0)


def _way(
    number: Lettering,
    ends: tuple[complex, complex],
    size: float,
    words: Obstacles,
    letters: Obstacles,
) -> Way:
    """Return how the middle of a number flies: on the page, past most words, letters and lenses.

    ``size`` says how many times as large it is in the end.
    """
    wide, room = width(number.runs, number.size) / 2, words.edge
    low, high = BELOW * number.size, (BELOW + DESCENT) * number.size  # with the arrow below it
    times = np.array([*_shares()])
    sizes = 1.0 + (size - 1.0) * times
    half, below, above = (each * sizes[:, None] for each in (wide, low, high))

    def met(x: Reals, y: Reals, others: Obstacles) -> Bools:
        sides = [(each.left, each.right, each.bottom, each.top) for each, _ in others.boxes]
        left, right, bottom, top = np.array(sides).reshape(-1, 4).T
        return (x - half < right) & (x + half > left) & (y - below < top) & (y + above > bottom)

    def cost(way: Way) -> tuple[bool, int, float]:
        spots = np.array([way.at(time) for time in times])[:, None]
        x, y = spots.real, spots.imag
        strays = bool((x - half < room.left).any() or (x + half > room.right).any())
        crossed, hidden = met(x, y, words), met(x, y, letters)
        own = hidden.any(axis=0).sum() + HOVERS * hidden.sum()
        return strays, int(crossed.any(axis=0).sum()), float(own)

    return min((Way(*ends, room.bottom + high, *arch) for arch in ARCHES), key=cost)
