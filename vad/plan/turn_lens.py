"""The lens of a turn: while all vectors of a polygon are small, they are shown once more, larger.

Its place and its factor never change.  It comes when every point is so near to the others that it
has room for all of them, and is gone when the first one meets its rim; once in a turn, and twice if
it stays long.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from vad.plan.geometry import Rect, bar_corners
from vad.plan.hodographs import Complexes, Hodographs
from vad.plan.items import Item, Level
from vad.plan.labels.close import LARGEST_ALONE, LEAST_RING, SMALLEST
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import APART
from vad.plan.labels.springs import Ballast, Crowd
from vad.plan.lens import BAND, Lens, circle
from vad.plan.marks import area, disc
from vad.plan.pictures.lenses import (
    BELOW,
    BESIDE,
    CLEAR,
    INWARD,
    STEP,
    TRIED,
    Spot,
    Words,
    whole_words_of,
    words_of,
)
from vad.plan.pictures.polygon import Polygon
from vad.plan.sketch import Sketch
from vad.plan.turn_labels import FADING, SHOWN, TurnLabels
from vad.strokes.diagram import Spot as Letter
from vad.strokes.sheet import Panel

Reals = NDArray[np.float64]

#: A polygon is small while its longest vector from the pole is shorter; a lens is needed where it
#: is so for that share of the turn.
SMALL, PART = 45.0 * PIXEL, 0.25
#: The seconds in which it comes and goes.
FADE = 0.3
#: How many times as large it shows what is there.
FACTORS = (2.0, 3.0, 4.0, 6.0, 8.0, 20.0, 50.0, 100.0, 200.0)
#: From the rim of a lens to the dots that it has room for.
INSIDE = 0.012
#: From the rim to what else is in the panel.
OFF = 0.020
#: The size of the letters in it.
LETTER = 0.034
#: How many radii are tried.
RADII = 7
#: A polygon that is moved keeps so far from the edge of its room.
KEPT = 0.055
#: It is there for that many times the time in which it comes, at least.
LEAST_SPAN = 4.0
#: It comes a second time in a turn if it stays for that share of it both times.
LONG_SPAN = 0.2
#: It makes up for at least that share of what small vectors lack, and covers no more of the
#: hodographs than that.
LEAST_GAIN, COVERED = 0.3, 0.05
#: Of the samples of a hodograph one in so many is looked at.
THINNED = 8
#: Half the width of the ring beyond the rim, in which no letter stands.
BEYOND = 0.025


@dataclass(frozen=True, slots=True)
class Spans:
    """When a lens is there: stretches of phases, the second of each above the first."""

    ends: tuple[tuple[float, float], ...]
    fade: float

    def ink(self, phase: float) -> float:
        """Return its share of ink at a phase.

        Examples
        --------
        >>> spans = Spans(((0.75, 1.25),), 0.1)
        >>> [round(spans.ink(phase), 2) for phase in (0.7, 0.8, 0.0, 0.25, 0.3, 0.5)]
        [0.0, 0.5, 1.0, 1.0, 0.5, 0.0]
        """
        most = 0.0
        for first, last in self.ends:
            since = (phase - first) % 1.0
            if last - first >= 1.0:
                return 1.0
            over = since - (last - first)
            most = max(most, min(since / self.fade, 1.0 - max(over, 0.0) / self.fade))
        return most

    def shows(self, phase: float) -> bool:
        """Tell whether letters stand in the lens: there are no half ones."""
        return self.ink(phase) >= SHOWN


@dataclass(frozen=True, slots=True)
class TurnLens:
    """A lens over a turn: where it stands, when, and what it shows."""

    spot: Spot
    spans: Spans
    polygon: Polygon
    labels: TurnLabels

    @property
    def lens(self) -> Lens:
        """Its circle."""
        return self.spot.lens

    def has(self, at: complex, phase: float) -> bool:
        """Tell whether a place of the panel has its letters in the lens."""
        return self.spans.shows(phase) and _holds(self.lens, self.lens(at))

    def block(self, obstacles: Obstacles, phase: float) -> None:
        """Add it to what labels of the panel keep clear of, while it is there."""
        if self.spans.ink(phase):
            lens = self.lens
            obstacles.line(circle(lens.place, lens.ring), PIXEL)
            obstacles.disc(lens.at, lens.radius + BAND)
            obstacles.line(lens.leader, PIXEL)
            obstacles.block(self.spot.words.box(self.spot.middle))

    def items(self, panel: Panel, phase: float) -> Iterator[Item]:
        """Yield what it shows of one pose."""
        ink = self.spans.ink(phase)
        if not ink:
            return
        sketch = _through(self.lens, self.polygon, panel)
        drawn = sketch.items
        sketch.items = []
        self.labels.add(sketch, panel, phase, Level.LENS)
        region, lens = self.polygon.still.setting.panel.column, self.lens
        # A hodograph ends beside the words, as it does at the rim.
        words, middle = self.spot.words.box(self.spot.middle).inside(-CLEAR), self.spot.middle
        half = words.width / 2
        plate = bar_corners(middle - half, middle + half, words.height)
        blank = disc(lens.at, lens.radius, "lens"), area(plate, "lens")
        ground = Item("", region, Level.LENS, blank)
        marks = *self.spot.frame(), *self.spot.words.marks(middle)
        frame = Item("", region, Level.LENS, marks)
        for item in (ground, *drawn, frame):
            faded = (replace(mark, alpha=ink * mark.alpha) for mark in item.marks)
            yield replace(item, level=Level.LENS, marks=tuple(faded))
        yield from sketch.items


def _through(lens: Lens, polygon: Polygon, panel: Panel) -> Sketch:
    """Return a pose as a lens shows it, cut at its rim."""
    sketch = polygon.pose(panel)
    items = []
    for item in sorted(sketch.items, key=lambda item: item.level):
        cut = [(mark, lens.cut(mark.shape)) for mark in item.marks]
        marks = tuple(replace(mark, shape=shape) for mark, shape in cut if shape)
        if marks:
            items.append(replace(item, marks=marks))
    sketch.items = items
    return sketch


def _holds(lens: Lens, at: complex) -> bool:
    return abs(at - lens.at) < lens.radius - INSIDE / 2


@dataclass(frozen=True, slots=True)
class Found:
    """A place for a lens: how far the polygon makes way for it, where it stands, and when."""

    shift: complex
    spot: Spot
    spans: Spans


def find_lens(polygon: Polygon, ways: Hodographs, opening: float, fade: float) -> Found | None:
    """Return the place of a lens for a polygon over a turn; None where it needs none.

    Parameters
    ----------
    polygon
        The polygon.
    ways
        Its hodographs.
    opening
        The phase of share 0 of the cycle.
    fade
        The share of the turn in which the lens comes.
    """
    setting = polygon.still.setting
    points = np.array([way for spot, way in ways.tracks.items() if spot.lettered])
    pole = next((way[0] for way in points if not np.ptp(way)), None)
    if pole is None or not np.isfinite(points).all():
        return None
    small = np.abs(points - pole).max(axis=0) < SMALL
    if small.mean() < PART:
        return None
    near = points[:, small]
    middle = complex(near.real.min() + near.real.max(), near.imag.min() + near.imag.max()) / 2
    reach = np.abs(points - middle).max(axis=0)
    drawn = np.concatenate([ways.tracks[spot] for spot in ways.drawn])
    lengths = np.abs(points - pole).max(axis=0)[small] / SMALL
    times = opening + np.linspace(0.0, 1.0, len(small))[small]
    best: tuple[float, Found | None] = LEAST_GAIN, None
    for radius, factor in product(np.linspace(LARGEST_ALONE, SMALLEST, RADII).tolist(), FACTORS):
        limit, most = (radius - INSIDE) / factor, (radius - polygon.radius) / factor
        spans = _spans(reach, limit, most, opening, fade)
        shown = [spans.shows(time) for time in times.tolist()]
        gain = ((np.minimum(factor * lengths, 1.0) - lengths) * shown).sum() / (1.0 - lengths).sum()
        words = words_of(setting, polygon.scale, factor)
        for shift in _shifts(drawn, setting.room):
            if gain <= best[0]:
                break
            lens = Lens(middle + shift, max(LEAST_RING, radius / factor), factor, 0j, radius)
            spot, covered = _place(polygon, lens, words, drawn + shift, most)
            if spot and covered <= COVERED and gain - covered > best[0]:
                for whole in whole_words_of(setting, polygon.scale, factor):
                    other = _place(polygon, lens, whole, drawn + shift, most)
                    if other[0] and other[1] <= covered:
                        spot = other[0]
                        break
                best = float(gain) - covered, Found(shift, spot, spans)
    return best[1]


def _spans(reach: Reals, limit: float, most: float, opening: float, fade: float) -> Spans:
    """Return when a lens is there that comes at a ``limit`` of the reach, and is gone at the most.

    It fades away before that.
    """
    count = len(reach) - 1
    near, far = reach[:count] <= limit, reach[:count] > most
    if not far.any():
        return Spans(((0.0, 1.0),) if near.any() else (), fade)
    first = int(far.argmax())
    ends, since = list[tuple[float, float]](), None
    for number in range(first, first + count + 1):
        if since is None and near[number % count]:
            since = number
        elif since is not None and far[number % count]:
            last = number - 1 - fade * count
            if last - since > LEAST_SPAN * fade * count:
                ends.append((since / count + opening, last / count + opening))
            since = None
    # One that came and went often, or for a short time, would flicker.
    longest = sorted(ends, key=lambda end: end[0] - end[1])
    again = [end for end in longest[1:2] if end[1] - end[0] >= LONG_SPAN]
    return Spans((*longest[:1], *again), fade)


def _shifts(drawn: Complexes, room: Rect) -> list[complex]:
    """Return how far a polygon may be moved to the sides of its room; first not at all."""
    inner = room.inside(KEPT)
    right, left = inner.right - drawn.real.max(), inner.left - drawn.real.min()
    top, bottom = inner.top - drawn.imag.max(), inner.bottom - drawn.imag.min()
    moved = [complex(0.0, top), complex(0.0, bottom), complex(right, 0.0), complex(left, 0.0)]
    signs = (1j, -1j, 1.0 + 0j, -1.0 + 0j)
    return [0j, *(z for z, way in zip(moved, signs, strict=True) if (z * way.conjugate()).real > 0)]


def _place(
    polygon: Polygon, lens: Lens, words: Words, drawn: Complexes, reach: float
) -> tuple[Spot | None, float]:
    """Return the best place of a lens, and the share of the hodographs that it covers there.

    It keeps clear of all that lies within the ``reach`` of the middle while it is there.
    """
    room, radius = polygon.still.setting.room, lens.radius + BAND
    across = np.arange(room.left + radius - BESIDE, room.right - radius + BESIDE, STEP)
    upright = np.arange(room.bottom + radius, room.top - radius, STEP)
    grid = (across[:, None] + 1j * upright).ravel()
    grid = grid[np.abs(grid - lens.place) > radius + max(lens.ring, reach) + OFF]
    still = polygon.still.obstacles
    grid = grid[still.free(grid.tolist(), 2 * radius, 2 * radius, -BESIDE)]
    if not grid.size:
        return None, 1.0
    inward = np.minimum(grid.real - room.left, room.right - grid.real)
    inward += np.minimum(grid.imag - room.bottom, room.top - grid.imag)
    seen = drawn[::THINNED]
    covered = (np.abs(seen[:, None] - grid) < radius + CLEAR).mean(axis=0)
    away = np.abs(grid - lens.place) + INWARD * inward
    below = BELOW + words.high / 2 + lens.radius
    for number in np.lexsort((away, covered))[:TRIED].tolist():
        at = complex(grid[number])
        for side in (-1j, 1j):
            spot = Spot(replace(lens, at=at), words, at + side * below)
            near = abs(spot.middle - lens.place) < max(lens.ring, reach) + words.wide / 2
            if near or not still.free([spot.middle], words.wide, words.high, CLEAR, APART)[0]:
                continue
            box = words.box(spot.middle)
            if box.inside(-CLEAR).clipped(*spot.lens.leader):
                continue
            under = [box.holds(z, CLEAR) for z in seen.tolist()]
            return spot, float(covered[number]) + sum(under) / len(under)
    return None, 1.0


def with_lens(
    polygon: Polygon,
    found: Found,
    ways: Hodographs,
    poses: Sequence[Panel],
    groups: Sequence[tuple[Letter, ...]],
    opening: float,
) -> TurnLens:
    """Return the lens of a polygon that has made way for it, with its letters."""
    lens, spans, setting = found.spot.lens, found.spans, polygon.still.setting
    inner = Polygon(replace(setting, room=lens.box), lens.scale(polygon.scale))

    def inside(at: complex, phase: float) -> float:
        return FADING if spans.shows(phase) and _holds(lens, at) else -1.0

    labels = TurnLabels(setting, polygon.scale, ways, opening, inside, lens, LETTER)
    sketches = [_through(lens, inner, pose).obstacles for pose in poses]
    for each in sketches:
        each.line(circle(lens.at, lens.radius + BEYOND), BEYOND)
    crowd, none = Crowd(lens.box, sketches), Crowd(lens.box, [Obstacles(lens.box)])
    rim = lens.at, lens.radius
    labels.place(groups, poses, Ballast(lens.box, crowd, none, polygon.radius, rim))
    return TurnLens(found.spot, spans, inner, labels)
