"""A film's few colours: inks, their blends with the background, and the map from RGBA to them.

The table has at most 255 colours.  It is made from a style and the number of inks in use, before
the first frame is painted; every pixel gets the index of the nearest colour.  Index 0 is left free:
it stands for "as before".
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from vad.style import Style, load_style

Bytes = NDArray[np.uint8]
ColourArray = NDArray[np.float64]

#: The shares of ink in the tints of the board (glow, blocks, set square) and in its pale lines.
#: The antialiased edges of lines and letters need no further shares.
_TINTS = (0.16, 0.43)
#: Tints that are nearer than this to each other share a colour.
_APART = 10.0
#: An ink that is this near the blends of a stronger one, as grey is to those of black, has no
#: blends of its own.
_BESIDE = 8.0
#: Finer steps between ink and background than this are not seen.
_FINEST = 6.0
_MOST = 255


class Palette:
    """A table of RGB colours, given as floats of shape (n, 3), and the index of each colour in it.

    Attributes
    ----------
    colours
        RGB, shape (n + 1, 3), uint8; row 0 is the one that is never looked up.

    Examples
    --------
    >>> palette = Palette([[255, 255, 255], [0, 0, 255]])
    >>> palette.indices(np.array([[[0, 0, 250, 255], [255, 254, 255, 255]]], np.uint8)).tolist()
    [[2, 1]]
    """

    def __init__(self, colours: Sequence[Sequence[float]] | NDArray[np.float64]) -> None:
        self.colours: Bytes = np.vstack([np.zeros(3), colours]).astype(np.uint8)
        # From 0xBBGGRR to an index, 0 where a colour has not been met: only what is used of these
        # 16 MB is ever given memory by the system.
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


def coarse(style: str, rows: int = 0) -> Palette:
    """Return the fewest colours that show a style: its inks and two tints of each.

    ``rows`` is how many of the inks of links are there; 0 stands for all.

    Of the GIF's bytes, each further step between ink and background costs a twentieth.
    """
    background, (text, hairline, *inks) = _colours(load_style(style), rows)
    chosen = [background, text, hairline, *inks]
    for share in _TINTS:
        for ink in inks:  # text and rules find enough greys among theirs
            tint = background + share * (ink - background)
            if all(math.dist(tint, other) > _APART for other in chosen):
                chosen.append(tint)
    return Palette(_distinct(chosen)[:_MOST])


def fine(style: str, rows: int = 0) -> Palette:
    """Return as many blends of a style's inks with its background as a table can hold.

    All but the crossings of two inks are within a few units of their true colour.  ``rows`` is how
    many of the inks of links are there; 0 stands for all.
    """
    background, inks = _colours(load_style(style), rows)
    blended: list[ColourArray] = []
    for ink in sorted(inks, key=lambda ink: -math.dist(ink, background)):
        if all(_distance(ink, background, other) > _BESIDE for other in blended):
            blended.append(ink)
    lengths = [math.dist(ink, background) for ink in blended]
    room = _MOST - len(_distinct([background, *inks]))
    blends = []
    for ink, length in zip(blended, lengths, strict=True):
        count = int(min(room * length / sum(lengths), length / _FINEST))
        share = np.arange(1, count + 1)[:, None] / (count + 1)
        blends.append(background + share * (ink - background))
    return Palette(_distinct([background, *inks, *blends]))


def _colours(style: Style, rows: int) -> tuple[ColourArray, list[ColourArray]]:
    """Return the background, and the inks: of text, of rules, of the frame, of the links."""
    inks = [style.text, style.hairline, style.grey, *style.inks[: rows or None]]
    return _rgb(style.background), [_rgb(ink) for ink in inks]


def _distinct(colours: list[ColourArray]) -> NDArray[np.float64]:
    """Return the different ones of ``colours`` (or of tables of colours) in their order."""
    table = np.vstack(colours).round()
    first = np.unique(table, axis=0, return_index=True)[1]
    return table[np.sort(first)]


def _distance(point: ColourArray, start: ColourArray, end: ColourArray) -> float:
    """Return how far ``point`` is from the segment between two colours."""
    along = end - start
    share = float((point - start) @ along) / max(float(along @ along), 1.0)
    return math.dist(point, start + min(max(share, 0.0), 1.0) * along)


def _rgb(colour: str) -> ColourArray:
    return np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)], np.float64)
