"""The only place that paints: marks go to a matplotlib renderer, whatever its output.

In come marks in pixels, out go pixels (Agg), SVG or PDF.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.plan.marks import Mark, Pen

Colour = tuple[float, float, float, float]


class Canvas:
    """Paints marks on one matplotlib renderer, whose unit is the pixel (72 dpi)."""

    def __init__(self, renderer: Any) -> None:
        from matplotlib.path import Path
        from matplotlib.transforms import IdentityTransform

        self._renderer = renderer
        self._path = Path
        self._identity = IdentityTransform()
        self._contexts: dict[tuple[Pen | None, float], Any] = {}
        self._colours: dict[str, Colour] = {}

    def paint(self, marks: Iterable[Mark]) -> None:
        """Paint ``marks`` in their order."""
        for mark in marks:
            path = self._path(mark.vertices, mark.codes)
            path.should_simplify = False
            face = self._colour(mark.fill) if mark.fill else None
            context = self._context(mark.pen, mark.alpha)
            self._renderer.draw_path(context, path, self._identity, face)

    def _context(self, pen: Pen | None, alpha: float) -> Any:
        context = self._contexts.get((pen, alpha))
        if context is None:
            context = self._renderer.new_gc()
            context.set_snap(False)
            context.set_antialiased(True)
            context.set_linewidth(pen.width if pen else 0.0)
            if pen:
                context.set_foreground(self._colour(pen.ink), isRGBA=True)
                context.set_capstyle("butt" if pen.cap == "butt" else "round")
                context.set_joinstyle(pen.join)
                context.set_dashes(0.0, list(pen.dash) or None)
            context.set_alpha(alpha)
            self._contexts[pen, alpha] = context
        return context

    def _colour(self, name: str) -> Colour:
        colour = self._colours.get(name)
        if colour is None:
            red, green, blue = (int(name[i : i + 2], 16) / 255 for i in (1, 3, 5))
            colour = self._colours[name] = (red, green, blue, 1.0)
        return colour


class AggCanvas(Canvas):
    """A canvas with a buffer of pixels, painted by matplotlib's Agg."""

    def __init__(self, size: tuple[int, int], background: str) -> None:
        from matplotlib.backends.backend_agg import RendererAgg

        renderer = RendererAgg(size[0], size[1], 72.0)
        super().__init__(renderer)
        self.pixels: NDArray[np.uint8] = np.asarray(renderer.buffer_rgba())
        # One 32-bit word per pixel: four times fewer elements to copy and compare.
        self.words: NDArray[np.uint32] = self.pixels.view(np.uint32)[..., 0]
        colour = [round(255 * part) for part in self._colour(background)]
        self.background = np.array(colour, dtype=np.uint8).view(np.uint32)[0]
        self.words[:] = self.background
