"""Pixels: shapes go to matplotlib's Agg, the one drawing library that paints here."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.painting.shapes import outline
from vad.plan.format import Format
from vad.plan.items import Item
from vad.plan.marks import Mark, Outline
from vad.style import Look, Pen

Colour = tuple[float, float, float, float]
#: How many paths are kept: enough for all marks that a film repaints in a frame.
KEPT = 400


class AggPainter:
    """A painter with a buffer of pixels.

    Attributes
    ----------
    pixels
        RGBA, shape (height, width, 4), uint8.
    words
        The same, one 32-bit word per pixel: four times fewer elements to copy and compare.
    """

    def __init__(self, form: Format) -> None:
        from matplotlib.backends.backend_agg import RendererAgg
        from matplotlib.path import Path
        from matplotlib.transforms import Affine2D

        width, height = round(form.width * form.unit), round(form.height * form.unit)
        self._renderer = RendererAgg(width, height, 72.0)
        self._unit, self._path = form.unit, Path
        self._scale = Affine2D().scale(form.unit)
        self._contexts: dict[tuple[Pen | None, float], Any] = {}
        self._colours: dict[str, Colour] = {}
        self._paths: dict[int, tuple[Outline, Any]] = {}
        self.pixels: NDArray[np.uint8] = np.asarray(self._renderer.buffer_rgba())
        self.words: NDArray[np.uint32] = self.pixels.view(np.uint32)[..., 0]

    def begin(self, form: Format, background: str) -> None:
        """Fill the buffer with the background."""
        self.words[:] = self.word(background)

    def group(self, item: Item) -> None:
        """Do nothing: pixels have no groups."""

    def end(self) -> None:
        """Do nothing: the pixels are complete."""

    def paint(self, mark: Mark, look: Look) -> None:
        """Paint one mark."""
        path = self.path(mark.shape)
        if not len(path.vertices):
            return
        if look.under:
            self._renderer.draw_path(self._context(look.under, 1.0), path, self._scale, None)
        face = self._colour(look.fill) if look.fill else None
        self._renderer.draw_path(self._context(look.pen, look.alpha), path, self._scale, face)

    def path(self, shape: Outline) -> Any:
        """Return a shape as a path of matplotlib, in page units; the latest ones are kept."""
        known = self._paths.get(id(shape))
        if known is None:
            path = self._path(*outline(shape))
            path.should_simplify = False
            if len(self._paths) == KEPT:
                self._paths.clear()
            # The shape is kept beside its path, so that no other shape can get the same id.
            known = self._paths[id(shape)] = shape, path
        return known[1]

    def word(self, colour: str) -> np.uint32:
        """Return a colour as the word of a pixel."""
        parts = [round(255 * part) for part in self._colour(colour)]
        return np.uint32(np.array(parts, dtype=np.uint8).view(np.uint32)[0])

    def _context(self, pen: Pen | None, alpha: float) -> Any:
        context = self._contexts.get((pen, alpha))
        if context is None:
            context = self._renderer.new_gc()
            context.set_snap(False)
            context.set_antialiased(True)
            context.set_linewidth(pen.width * self._unit if pen else 0.0)
            if pen:
                context.set_foreground(self._colour(pen.colour), isRGBA=True)
                context.set_capstyle("butt" if pen.cap == "butt" else "round")
                context.set_joinstyle(pen.join)
                context.set_dashes(0.0, [part * self._unit for part in pen.dash] or None)
            context.set_alpha(alpha)
            self._contexts[pen, alpha] = context
        return context

    def _colour(self, name: str) -> Colour:
        colour = self._colours.get(name)
        if colour is None:
            red, green, blue = (int(name[i : i + 2], 16) / 255 for i in (1, 3, 5))
            colour = self._colours[name] = (red, green, blue, 1.0)
        return colour
