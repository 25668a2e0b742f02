"""Films: each frame paints only the growing stroke on a committed base.

In comes a lesson, out go its `Frame` objects; `redraw` paints one frame from nothing, which is
what every incremental frame must equal.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, moment, moments
from vad.painting.canvas import AggCanvas, Canvas
from vad.painting.picture import EMPTY, Box, Frame
from vad.plan.board import Board, Layer
from vad.plan.marks import Mark
from vad.plan.page import Rect

Pixels = NDArray[np.uint8]
Words = NDArray[np.uint32]  # one per pixel


def frames(lesson: Lesson) -> Iterator[Frame]:
    """Yield the pictures of a lesson; see `Frame` for what each says about itself."""
    painter = _Painter(lesson)
    for state, repeats in moments(lesson):
        changed = painter.show(state)
        yield Frame(painter.pixels, changed, repeats)


def redraw(lesson: Lesson, frame: int) -> Pixels:
    """Return one frame painted from nothing: the reference for `frames`."""
    board = Board(lesson.sheet, lesson.size, lesson.style, lesson=True)
    canvas = AggCanvas(lesson.size, board.style.background)
    paint(board, moment(lesson, frame), canvas)
    return canvas.pixels


def paint(board: Board, state: Moment, canvas: Canvas) -> None:
    """Paint the board at a moment on an empty canvas."""
    canvas.paint(board.background())
    for layer in board.layers(state):
        under, over = layer.draw()
        canvas.paint(under)
    canvas.paint(board.growing(state))
    canvas.paint(over)  # of the last layer: nothing lies above a region where nothing grows


class _Painter:
    """Holds the buffer, the committed base beneath a growing stroke, and what lies above it."""

    def __init__(self, lesson: Lesson) -> None:
        self._board = Board(lesson.sheet, lesson.size, lesson.style, lesson=True)
        self._canvas = AggCanvas(lesson.size, self._board.style.background)
        self._canvas.paint(self._board.background())
        self._words = self._canvas.words
        self._base = self._words.copy()
        self._over: list[tuple[Box, Mark]] = []
        self._keys: dict[str, object] = {}
        self._step: tuple[object, ...] | None = None
        self._dirty: Box = EMPTY
        self.pixels = self._canvas.pixels

    def show(self, state: Moment) -> Box:
        """Paint a moment and return the box of all that differs from the one before."""
        first = self._step is None
        if self._step == _step(state):
            box = self._reach(self._board.growing(state))
            before = self._cut(box).copy()
        else:
            box = self._dirty
            layers = [
                layer
                for layer in self._board.layers(state)
                if self._keys.get(layer.region, self) != layer.key
            ]
            for layer in layers:
                box = _union(box, self._pixels_of(layer.area))
            box = self._reach(self._board.growing(state), box)
            before = self._cut(box).copy()
            self._commit(layers, state.grown is not None)
            self._step = _step(state)
        self._lay(self._board.growing(state))
        if first:
            return 0, 0, self.pixels.shape[1], self.pixels.shape[0]
        return difference(before, self._cut(box), box)

    def _commit(self, layers: list[Layer], growing: bool) -> None:
        """Repaint the regions that look different now; keep what lies above a growth apart."""
        self._cut(self._dirty)[:] = self._base_cut(self._dirty)
        over: list[Mark] = []
        for layer in layers:
            self._keys[layer.region] = layer.key
            self._cut(self._pixels_of(layer.area))[:] = self._canvas.background
            beneath, above = layer.draw()
            self._canvas.paint(beneath)
            over += above
        if growing:
            self._base[:] = self._words
            self._canvas.paint(over)
        self._over = [(self._box(mark), mark) for mark in over]
        self._dirty = EMPTY

    def _lay(self, marks: list[Mark]) -> None:
        """Paint ``marks`` on the base, and above them whatever of the rest they touch."""
        if not marks:
            return
        box = self._reach(marks)
        self._cut(box)[:] = self._base_cut(box)
        self._canvas.paint(marks)
        self._canvas.paint(mark for spot, mark in self._over if _touch(spot, box))
        self._dirty = box

    def _reach(self, marks: list[Mark], also: Box = EMPTY) -> Box:
        """Return the box that painting ``marks`` touches.

        It holds theirs, that of the frame before, and in turn those of the marks above it.
        """
        box = _union(also, self._dirty)
        for mark in marks:
            box = _union(box, self._box(mark))
        while True:
            wider = box
            for spot, _ in self._over:
                if _touch(spot, wider):
                    wider = _union(wider, spot)
            if wider == box:
                return box
            box = wider

    def _cut(self, box: Box) -> Words:
        return self._words[box[1] : box[3], box[0] : box[2]]

    def _base_cut(self, box: Box) -> Words:
        return self._base[box[1] : box[3], box[0] : box[2]]

    def _box(self, mark: Mark) -> Box:
        left, bottom, right, top = mark.box
        return self._pixels_of(Rect(left, bottom, right, top))

    def _pixels_of(self, area: Rect) -> Box:
        """Return an area as a pixel box, rows counted from the top, inside the frame."""
        height, width = self.pixels.shape[:2]
        return (
            min(max(math.floor(area.left), 0), width),
            min(max(height - math.ceil(area.top), 0), height),
            min(max(math.ceil(area.right), 0), width),
            min(max(height - math.floor(area.bottom), 0), height),
        )


def _step(state: Moment) -> tuple[object, ...]:
    return state.done, state.panel, state.stroke, state.grown is None


def _touch(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _union(one: Box, other: Box) -> Box:
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


def difference(before: Words, now: Words, box: Box) -> Box:
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
