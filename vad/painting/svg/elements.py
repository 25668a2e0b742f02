"""Shapes become elements: in come shapes with their looks, out go elements that name classes."""

from __future__ import annotations

from typing import Protocol

from vad.painting.svg.classes import Classes, drawn, filled
from vad.painting.svg.grid import Grid, number
from vad.plan.marks import Disc, Lettering, Outline
from vad.style import Look


class TextWriter(Protocol):
    """What writes lines of text."""

    def element(self, text: Lettering, look: Look, grid: Grid) -> str:
        """Return the element of a line of text, with its halo."""


class Elements:
    """Writes the shapes of one picture."""

    def __init__(self, grid: Grid, classes: Classes, text: TextWriter) -> None:
        self._grid, self._classes, self._text = grid, classes, text

    def of(self, shape: Outline, look: Look) -> str:
        """Return the elements of a shape: a halo, if it has one, and itself."""
        if isinstance(shape, Lettering):
            return self._text.element(shape, look, self._grid)
        return "".join(f'<{self._place(shape)} class="{name}"/>\n' for name in self.classes(look))

    def classes(self, look: Look) -> list[str]:
        """Return the classes of the elements of any shape but text: of its halo, and its own."""
        unit = self._grid.unit
        own = self._classes.name(filled(look), drawn(look.pen, unit, look.alpha))
        return [self._classes.name(drawn(look.under, unit)), own] if look.under else [own]

    def _place(self, shape: Outline) -> str:
        if isinstance(shape, Disc):
            x, y = self._grid.at(shape.centre)
            return f'circle cx="{x}" cy="{y}" r="{number(shape.radius * self._grid.unit)}"'
        assert not isinstance(shape, Lettering)
        return f'path d="{self._grid.path(shape)}"'
