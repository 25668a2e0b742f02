"""Boxes: they hold all that changed, and leave out what lies between."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from vad.export.frames import bands, with_boxes
from vad.painting.film import EMPTY, Frame

SIZE = (60, 200)


def frames() -> Iterator[Frame]:
    """A board on which a mark at the top and a word at the bottom appear together."""
    pixels = np.full((200, 60, 4), 255, np.uint8)
    yield Frame(pixels, (0, 0, *SIZE), 1)
    pixels[10:20, 5:9] = 0
    pixels[180:190, 30:50] = 0
    yield Frame(pixels, (5, 10, 50, 190), 1)
    yield Frame(pixels, EMPTY, 3)


def test_a_mark_and_a_word_are_two_boxes():
    boxes = [boxes for _, boxes in with_boxes(frames(), SIZE)]
    assert boxes == [[(0, 0, 60, 200)], [(30, 180, 50, 190), (5, 10, 9, 20)], []]


def test_boxes_hold_all_that_differs():
    random = np.random.default_rng(1)
    for _ in range(50):
        now = (random.random((200, 60)) < 2e-3).astype(np.uint8)
        copy = np.zeros_like(now)
        boxes = bands(now, copy, (0, 0, *SIZE), 3)
        assert len(boxes) <= 3
        for left, top, right, bottom in boxes:
            copy[top:bottom, left:right] = now[top:bottom, left:right]
        assert (copy == now).all()
