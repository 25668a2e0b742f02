"""How roles and rows look: a `Style` is frozen data, one file per style in this folder.

In comes the name of a style, out go colours, dashes and weights; sizes live in `SIZES`-like
constants of the modules that use them, as fractions of the frame's height.
"""

from __future__ import annotations

import importlib
import pkgutil
from dataclasses import dataclass
from functools import cache

from vad.errors import unknown


@dataclass(frozen=True, slots=True)
class Line:
    """How the strokes of one row are told apart: a factor on the width, and a dash.

    ``dash`` is in line widths, on and off in turn; empty for a solid line.
    """

    weight: float = 1.0
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Style:
    """Colours and lines of a board.

    Attributes
    ----------
    background, text, grey, hairline
        Colours as ``#RRGGBB``.
    inks
        One colour per row of the results table, in order.
    lines
        One line per row of the results table, in order.
    key
        Length of the line before a row's name, as a fraction of the frame's height.
    erase
        By how much wider than a dashed stroke the background is cleared beneath it.
    """

    name: str
    background: str
    text: str
    grey: str
    hairline: str
    inks: tuple[str, ...]
    lines: tuple[Line, ...] = (Line(),)
    key: float = 0.058
    erase: float = 0.0

    def ink(self, row: int | None) -> str:
        """Return the colour of a row; grey for the frame (None)."""
        return self.grey if row is None else self.inks[row % len(self.inks)]

    def line(self, row: int | None) -> Line:
        """Return the weight and dash of a row; solid for the frame (None)."""
        return Line() if row is None else self.lines[row % len(self.lines)]


def mix(colour: str, ground: str, share: float) -> str:
    """Return ``share`` of ``colour`` laid over ``ground``.

    Examples
    --------
    >>> mix("#000000", "#FFFFFF", 0.2)
    '#CCCCCC'
    """
    pairs = ((int(colour[i : i + 2], 16), int(ground[i : i + 2], 16)) for i in (1, 3, 5))
    return "#" + "".join(f"{round(share * a + (1 - share) * b):02X}" for a, b in pairs)


@cache
def style_names() -> tuple[str, ...]:
    """Return the names of the styles: every file in this folder is one."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


def load_style(name: str) -> Style:
    """Return the style called ``name``.

    Raises
    ------
    vad.errors.UsageError
        If there is none of that name.
    """
    names = style_names()
    if name not in names:
        raise unknown("style", name, names)
    style = importlib.import_module(f"vad.style.{name}").STYLE
    assert isinstance(style, Style)
    return style
