"""One picture of a film, as the painter hands it to an encoder."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Box = tuple[int, int, int, int]
EMPTY: Box = (0, 0, 0, 0)


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
