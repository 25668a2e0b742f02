"""A film's few colours: inks, their blends with the background, and the map from RGBA to them.

In come the colours of a style, out goes a table of at most 255 colours, and the index of the
nearest of them for every pixel.  Index 0 is left free: it stands for "as before".
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from vad.rendering.style import load_style

Bytes = NDArray[np.uint8]
Colour = NDArray[np.float64]

#: An ink this near the blends of a stronger one needs none of its own (a grey beside black).
_NEAR = 16.0
#: Finer steps between ink and background than this are not seen at an antialiased edge.
_FINEST = 6.0


class Palette:
    """The colours ``#RRGGBB`` of a background and of inks that blend into it at their edges.

    ``limit`` is the largest number of colours; the blends are as fine as it allows.

    Attributes
    ----------
    colours
        RGB, shape (n, 3), uint8; row 0 is the one that is never looked up.

    Examples
    --------
    >>> palette = Palette("#FFFFFF", ["#0000FF"], limit=3)
    >>> palette.colours[1:].tolist()
    [[255, 255, 255], [128, 128, 255], [0, 0, 255]]
    >>> palette.indices(np.array([[[0, 0, 250, 255], [255, 254, 255, 255]]], np.uint8)).tolist()
    [[3, 1]]
    """

    def __init__(self, background: str, inks: Iterable[str], limit: int = 255) -> None:
        colours = _blends(_rgb(background), [_rgb(ink) for ink in inks], limit)
        self.colours: Bytes = np.vstack([np.zeros(3), colours]).astype(np.uint8)
        # From 0xBBGGRR to an index, 0 where a colour has not been met: only what is used of
        # these 16 MB is ever given memory by the system.
        self._known: Bytes = np.zeros(1 << 24, np.uint8)

    def indices(self, pixels: Bytes) -> Bytes:
        """Return the index of the nearest colour, shape (h, w), for RGBA of shape (h, w, 4)."""
        keys = np.ascontiguousarray(pixels).view("<u4")[..., 0] & 0xFFFFFF
        found: Bytes = self._known[keys]
        new = keys[found == 0]
        if new.size:
            new = np.unique(new)
            self._known[new] = self._nearest(np.stack([new, new >> 8, new >> 16], -1) & 0xFF)
            found = self._known[keys]
        return found

    def _nearest(self, colours: NDArray[np.integer]) -> NDArray[np.intp]:
        # |c - p|² = |c|² - 2 c·p + |p|², and |c|² is the same for all p.
        table = self.colours[1:].astype(np.float32)
        distance = (table**2).sum(-1) - 2.0 * (colours.astype(np.float32) @ table.T)
        nearest: NDArray[np.intp] = distance.argmin(-1) + 1
        return nearest


def film_palette(style: str, limit: int = 255) -> Palette:
    """Return the palette of the style called ``style``."""
    look = load_style(style)
    inks = [look.text, look.grey, look.hairline, *look.inks]
    return Palette(look.background, inks, limit)


def _blends(background: Colour, inks: list[Colour], limit: int) -> NDArray[np.float64]:
    """Return the background, blends of it with the inks as fine as ``limit`` allows, the inks."""
    blended: list[Colour] = []
    for ink in sorted(inks, key=lambda ink: -math.dist(ink, background)):
        if all(_distance(ink, background, other) > _NEAR for other in blended):
            blended.append(ink)
    lengths = [math.dist(ink, background) for ink in blended]
    room = limit - len(_distinct([background, *inks]))
    blends = []
    for ink, length in zip(blended, lengths, strict=True):
        count = int(min(room * length / max(sum(lengths), 1.0), length / _FINEST))
        share = np.arange(1, count + 1)[:, None] / (count + 1)
        blends.append(background + share * (ink - background))
    return _distinct([background, *blends, *inks])


def _distinct(colours: list[Colour]) -> NDArray[np.float64]:
    """Return the different ones of ``colours`` (or of tables of colours) in their order."""
    table = np.vstack(colours).round()
    first = np.unique(table, axis=0, return_index=True)[1]
    return table[np.sort(first)]


def _distance(point: Colour, start: Colour, end: Colour) -> float:
    """Return how far ``point`` is from the segment between two colours."""
    along = end - start
    share = float((point - start) @ along) / max(float(along @ along), 1.0)
    return math.dist(point, start + min(max(share, 0.0), 1.0) * along)


def _rgb(colour: str) -> Colour:
    return np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)], np.float64)
