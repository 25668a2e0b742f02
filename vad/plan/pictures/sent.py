"""How a found ω or α goes to its link in a film: its number leaves the caption, and bends.

A copy of the number flies from the caption to the link, with a straight arrow beneath it.  There
the number fades, and the arrow bends to that of the sense of ω or α, which stays.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from vad.lecture.moment import smooth
from vad.plan.items import FLIGHT, FOREVER, Item
from vad.plan.labels.obstacles import Obstacles
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
from vad.plan.pictures.traces import swept

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
#: How high a number flies, of its way, to either side: the first of those that cross least text.
ARCHES = (0.10, -0.10, 0.25, -0.25, 0.40, -0.40)
PARTS = 24


def sent(
    senses: Iterable[Item], numbers: Mapping[str, tuple[Lettering, int]], words: Obstacles
) -> Iterator[Item]:
    """Yield the senses of rates with their flights, which take place while their stroke rests.

    Parameters
    ----------
    senses
        Their items, as a still has them: an arrow with its name, or a further name beside it.
    numbers
        For the full name of a stroke the number in its caption that flies, and the beat in which it
        is said.
    words
        What it should not cross.
    """
    for item in senses:
        number = numbers.get(item.stroke)
        if number is None:
            yield item
            continue
        texts = words.during((item.since, item.since + 1))
        marks, said = tuple(_flying(item.marks, number[0], texts)), (number[1], FOREVER)
        yield Item(item.stroke, FLIGHT, item.level, marks, item.since, item.since + 1, said)
        yield replace(item, since=item.since + 1)


def to_rows(
    rows: Iterable[Item],
    senses: Iterable[Item],
    numbers: Mapping[str, tuple[Lettering, int]],
    words: Obstacles,
) -> Iterator[Item]:
    """Yield the flights of numbers to rows of the results, where a link has no room for an arrow.

    Parameters
    ----------
    rows
        What stands there; what a stroke has just found grows.
    senses, numbers, words
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
        size = goal.size / number.size
        end = goal.at + width(without_turn(goal.runs), goal.size) - width(number.runs, goal.size)
        texts = words.during((item.since, item.since + 1))
        arch, off = _arch(number, number.at, end, texts), _off(number, texts)
        legs = []
        for share in _shares():
            part, time = _part(share, LEAVES, BENT), _time(share, LEAVES, BENT)
            spot, ink = _between(number.at, end, time, arch, off), 1.0 - _part(share, BENT, 1.0)
            legs.append(Leg(share, spot - number.at, 1.0 + (size - 1.0) * part, 0.0, ink))
        flies = Mark(number, "letter", growth=Flying(number.at, tuple(legs)))
        span = item.since, item.since + 1
        yield Item(item.stroke, FLIGHT, item.level, (flies,), *span, (said, FOREVER))


def _flying(marks: Iterable[Mark], number: Lettering, words: Obstacles) -> Iterator[Mark]:
    """Yield the marks of a sense on their way, and the number that comes with them."""
    *arrow, name = marks
    goal = name.shape
    assert isinstance(goal, Lettering)
    yield replace(name, growth=Fading(((NAMED[0], 0.0), (NAMED[1], 1.0))))
    size = goal.size / number.size
    wide = width(number.runs, number.size)
    # The middle of the number flies to that of the name.
    start, end = number.at + wide / 2, goal.at + width(goal.runs, goal.size) / 2
    arch, off = _arch(number, start, end, words), _off(number, words)
    times = [(share, _time(share, LEAVES, ARRIVES)) for share in _shares()]
    way = [(share, _between(start, end, time, arch, off)) for share, time in times]
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


def _arch(number: Lettering, start: complex, end: complex, words: Obstacles) -> float:
    """Return how high a number flies on its way: so that it stays on the page, past most words."""
    wide, room, off = width(number.runs, number.size), words.edge, _off(number, words)
    boxes = [each for each, _ in words.boxes]

    def cost(arch: float) -> tuple[bool, int]:
        ways = (_between(start, end, time, arch, off) for time in _shares())
        path = [number.at + spot - start for spot in ways]
        strays = any(z.real < room.left or z.real + wide > room.right for z in path)
        return strays, swept([path, [z + wide for z in path]], boxes)

    return min(ARCHES, key=cost)


def _off(number: Lettering, words: Obstacles) -> float:
    """Return the height at which a number and what is below it are clear of the caption."""
    return words.edge.bottom + (BELOW + DESCENT) * number.size


def _between(start: complex, end: complex, time: float, arch: float, off: float) -> complex:
    """Return a place on an arch, to which a number rises first from what is said beside it."""
    high = complex(start.real, max(start.imag, min(off, end.imag)))
    risen, flown = _part(time, 0.0, RISES), _part(time, FLIES_ON, 1.0)
    way = end - high
    arched = flown * way + 4.0 * flown * (1.0 - flown) * arch * 1j * way
    return start + risen * (high - start) + complex(arched.real, max(arched.imag, 0.0))
