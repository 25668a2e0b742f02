"""Films: each frame paints only what has changed since the one before.

A lesson or a turn, or a board and its moments, become `Frame` objects for an encoder.  `redraw`
paints one moment from nothing: every incremental frame must equal that.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, moments
from vad.lecture.turn import Turn
from vad.painting.agg_painter import AggPainter
from vad.painting.painter import Looks, play
from vad.painting.posed import board_of
from vad.plan.board import Board, seen
from vad.plan.geometry import Rect
from vad.plan.items import FLIGHT, Item
from vad.plan.marks import Mark
from vad.style import Style, load_style

Box = tuple[int, int, int, int]
EMPTY: Box = (0, 0, 0, 0)
PixelWords = NDArray[np.uint32]  # one per pixel
Pixels = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class Frame:
    """A picture that stands for ``repeats`` frames of the film's constant rate.

    Attributes
    ----------
    pixels
        RGBA, shape (height, width, 4), uint8: a view of the painter's one buffer, which the
        next frame overwrites.
    changed
        (left, top, right, bottom) of all that differs from the frame before, in pixels from
        the top left corner; the whole frame for the first one, ``EMPTY`` where nothing does.
    repeats
        How many frames of the constant rate this picture stands for: a pause is one frame.
    """

    pixels: NDArray[np.uint8]
    changed: Box
    repeats: int


def window(box: Box) -> tuple[slice, slice]:
    """Return the rows and columns of a box."""
    return slice(box[1], box[3]), slice(box[0], box[2])


def touching(one: Box, other: Box) -> bool:
    """Tell whether two boxes have a pixel in common."""
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def union(one: Box, other: Box) -> Box:
    """Return the smallest box that holds two; an empty one holds nothing."""
    if one[0] >= one[2] or one[1] >= one[3]:
        return other
    if other[0] >= other[2] or other[1] >= other[3]:
        return one
    return (
        min(one[0], other[0]),
        min(one[1], other[1]),
        max(one[2], other[2]),
        max(one[3], other[3]),
    )


def difference(before: PixelWords, now: PixelWords, box: Box) -> Box:
    """Return the smallest box in which two pictures of ``box`` differ."""
    differs = before != now
    rows = np.flatnonzero(differs.any(axis=1))
    if not len(rows):
        return EMPTY
    columns = np.flatnonzero(differs.any(axis=0))
    left, top = box[:2]
    return (
        left + int(columns[0]),
        top + int(rows[0]),
        left + int(columns[-1]) + 1,
        top + int(rows[-1]) + 1,
    )


def filmed(film: Lesson | Turn, most: float = math.inf) -> Iterator[Frame]:
    """Yield the pictures of a film; see `Frame` for what each says about itself.

    A movement of a lesson has at most ``most`` pictures per second.
    """
    style = load_style(film.style)
    if isinstance(film, Lesson):
        return frames(board_of(film), moments(film, most), style)
    from vad.plan.turn_board import TurnBoard

    states = ((Moment(number), 1) for number in range(film.frames))
    return frames(TurnBoard(film), states, style)


def frames(board: Board, moments: Iterable[tuple[Moment, int]], style: Style) -> Iterator[Frame]:
    """Yield the pictures of a film; see `Frame` for what each says about itself."""
    painter = _Incremental(board, style)
    for moment, repeats in moments:
        changed = painter.show(moment)
        yield Frame(painter.pixels, changed, repeats)


def redraw(board: Board, moment: Moment, style: Style) -> Pixels:
    """Return one moment painted from nothing: the reference for `frames`."""
    painter = AggPainter(board.form)
    play(board, moment, style, painter)
    return painter.pixels


class _Incremental:
    """Holds the pixels of the frame, and of the base: what lies beneath the marks that grow.

    While a stroke is drawn, the base holds all that lies beneath it; what grows and what lies
    above it is painted in each frame, as far as it is touched.
    """

    def __init__(self, board: Board, style: Style) -> None:
        self._board, self._looks = board, Looks(style)
        self._painter = AggPainter(board.form)
        self._painter.begin(board.form, style.background)
        self._ground = self._painter.word(style.background)
        self._words = self._painter.words
        self._base = self._words.copy()
        self._shown: dict[str, list[Item]] = {}
        #: The marks above the base, in painting order: without a box those that grow, the others
        #: with the box of their pixels.
        self._top: list[tuple[Mark, Box | None]] = []
        self._beat: int | None = None
        #: Beat, scene, and words of the caption, as they were painted last.
        self._state: tuple[int, float, int] | None = None
        self._dirty: Box = EMPTY
        #: For each region the items that it began with when it last changed, and their pixels.
        self._beneath: dict[str, tuple[list[Item], PixelWords]] = {}
        self.pixels = self._painter.pixels

    def show(self, moment: Moment) -> Box:
        """Paint a moment and return the box of all that differs from the one before."""
        first, box = self._beat is None, EMPTY
        regions: dict[str, list[Item]] = {}
        top = self._top
        state = moment.beat, moment.scene, moment.said
        turned = state != self._state
        if turned:
            regions = self._changed(moment)
            box = self._dirty
            for region in regions.keys() - {FLIGHT}:
                box = union(box, self._pixels_of(self._board.regions[region]))
            top = self._split(regions, moment.beat)
        now = self._at(top, moment.share)
        box = union(box, self._reach(now))
        before = self._cut(box).copy()
        if turned:
            self._commit(regions, top, moment.beat)
            self._beat, self._state, self._top = moment.beat, state, top
        self._lay(now)
        if first:
            return 0, 0, self.pixels.shape[1], self.pixels.shape[0]
        return difference(before, self._cut(box), box)

    def _changed(self, moment: Moment) -> dict[str, list[Item]]:
        """Return the regions that look different at a moment, with what they show."""
        beat = moment.beat
        shown: dict[str, list[Item]] = {region: [] for region in self._board.regions}
        for item in seen(self._board, moment):
            shown[item.region].append(item)
        changed = {
            region: items
            for region, items in shown.items()
            if items != self._shown.get(region)
            or any(_growing(item, beat) or _growing(item, self._beat) for item in items)
        }
        self._shown = shown
        # What a scene leaves is empty before anything of the next one is painted there.
        empty = [region for region in changed if not shown[region]]
        return {region: shown[region] for region in (*empty, *changed) if region in changed}

    def _split(self, regions: dict[str, list[Item]], beat: int) -> list[tuple[Mark, Box | None]]:
        """Return what grows and what lies above it, in painting order."""
        top: list[tuple[Mark, Box | None]] = []
        for items in regions.values():
            for item in items[_first_growing(items, beat) :]:
                grows = _growing(item, beat)
                top += [(mark, None if grows else self._box(mark)) for mark in item.marks]
        return top

    def _commit(
        self, regions: dict[str, list[Item]], top: list[tuple[Mark, Box | None]], beat: int
    ) -> None:
        """Repaint the regions that look different, and make what lies beneath ``top`` the base."""
        self._cut(self._dirty)[:] = self._base[window(self._dirty)]
        for region, items in regions.items():
            if region != FLIGHT:  # nothing of it ever belongs to the base
                self._repaint(region, items[: _first_growing(items, beat)])
        self._base[:] = self._words
        self._dirty = EMPTY
        for mark, spot in top:
            if spot is not None:
                self._painter.paint(mark, self._looks(mark))

    def _repaint(self, region: str, items: list[Item]) -> None:
        """Paint a region; the items with which it began the last time, too, come from pixels."""
        area = self._cut(self._pixels_of(self._board.regions[region]))
        if not items:
            area[:] = self._ground
            self._beneath.pop(region, None)
            return
        before, picture = self._beneath.get(region, ([], None))
        kept = _shared(before, items)
        if picture is not None and kept == len(before):
            area[:] = picture
        else:
            area[:] = self._ground
            self._paint(items[:kept])
            self._beneath[region] = items[:kept], area.copy()
        self._paint(items[kept:])
        if picture is None:
            self._beneath[region] = items, area.copy()

    def _paint(self, items: list[Item]) -> None:
        for item in items:
            for mark in item.marks:
                self._painter.paint(mark, self._looks(mark))

    def _at(self, top: list[tuple[Mark, Box | None]], share: float) -> list[tuple[Mark, Box, bool]]:
        """Return the top as it is at a share: marks, their boxes, and whether they grow."""
        now: list[tuple[Mark, Box, bool]] = []
        for mark, spot in top:
            if spot is not None:
                now.append((mark, spot, False))
            elif grown := mark.at(share):
                now.append((grown, self._box(grown), True))
        return now

    def _lay(self, now: list[tuple[Mark, Box, bool]]) -> None:
        """Paint what grows on the base, and everything else that it touches."""
        if not self._top:
            return
        box = self._reach(now)
        self._cut(box)[:] = self._base[window(box)]
        for mark, spot, grows in now:
            if grows or touching(spot, box):
                self._painter.paint(mark, self._looks(mark))
        self._dirty = box

    def _reach(self, now: list[tuple[Mark, Box, bool]]) -> Box:
        """Return the box that painting the top touches.

        It holds what grows, what the frame before has painted, and in turn what lies above.
        """
        box = self._dirty
        for _, spot, grows in now:
            if grows:
                box = union(box, spot)
        for _ in now:  # each round takes one more in, at least
            wider = box
            for _, spot, grows in now:
                if not grows and touching(spot, wider):
                    wider = union(wider, spot)
            if wider == box:
                break
            box = wider
        return box

    def _cut(self, box: Box) -> PixelWords:
        return self._words[window(box)]

    def _box(self, mark: Mark) -> Box:
        """Return the pixels that a mark can touch."""
        vertices = self._painter.path(mark.shape).vertices
        if not len(vertices):
            return EMPTY
        look, unit = self._looks(mark), self._board.form.unit
        pad = 2.0 / unit + max(pen.width if pen else 0.0 for pen in (look.pen, look.under))
        (left, bottom), (right, top) = vertices.min(axis=0), vertices.max(axis=0)
        return self._pixels_of(Rect(left, bottom, right, top).inside(-pad))

    def _pixels_of(self, area: Rect) -> Box:
        """Return an area as a pixel box, rows counted from the top, inside the frame."""
        (height, width), unit = self.pixels.shape[:2], self._board.form.unit
        return (
            min(max(math.floor(area.left * unit), 0), width),
            min(max(height - math.ceil(area.top * unit), 0), height),
            min(max(math.ceil(area.right * unit), 0), width),
            min(max(height - math.floor(area.bottom * unit), 0), height),
        )


def _shared(one: list[Item], other: list[Item]) -> int:
    """Return how many items two lists begin with alike."""
    alike = (first is second for first, second in zip(one, other, strict=False))
    return next(
        (number for number, same in enumerate(alike) if not same), min(len(one), len(other))
    )


def _growing(item: Item, beat: int | None) -> bool:
    return item.since == beat and item.grows


def _first_growing(items: list[Item], beat: int) -> int:
    numbers = (number for number, item in enumerate(items) if _growing(item, beat))
    return next(numbers, len(items))
