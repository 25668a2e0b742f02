"""How roles look: a `Style` is frozen data, one file per style in this folder.

A role and a row of the results give colours, widths and dashes.
"""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Literal

from vad.discovery import from_packages, names_in, one_of_all
from vad.errors import InputError, quoted
from vad.plan.roles import GHOSTS, ROLES, Ink

#: The entry points under which other packages bring their styles.
GROUP = "vad.styles"
#: How much ink is in the tint of a block, and in the words of a panel that is not begun.
TINT, PALE = 0.12, 0.55
#: Width and dash of rows beyond those that have an ink or a line of their own.
THINNER, DASH = 0.7, (8.0, 1.6)


@dataclass(frozen=True, slots=True)
class LineStyle:
    """How the strokes of one row are told apart: a factor on the width, and a dash.

    ``dash`` is in line widths, on and off in turn; empty for a solid line.
    """

    weight: float = 1.0
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Pen:
    """The line along a path; ``width`` and ``dash`` are in page units."""

    colour: str
    width: float
    dash: tuple[float, ...] = ()
    cap: Literal["butt", "round"] = "butt"
    join: Literal["miter", "round"] = "miter"


@dataclass(frozen=True, slots=True)
class Look:
    """How a mark is painted: ``under`` it a line of background, then its fill and its pen."""

    fill: str | None = None
    pen: Pen | None = None
    under: Pen | None = None
    alpha: float = 1.0


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
        Length of the line before a row's name, in page units: a dash has to show in it.
    erase
        By how much wider than a dashed stroke the background is cleared beneath it.
    """

    name: str
    background: str
    text: str
    grey: str
    hairline: str
    inks: tuple[str, ...]
    lines: tuple[LineStyle, ...] = (LineStyle(),)
    key: float = 0.058
    erase: float = 0.0

    def colour(self, ink: Ink, row: int | None) -> str:
        """Return the colour of an ink; a row of None is the frame, in grey."""
        link = self.grey if row is None else self.inks[row % len(self.inks)]
        match ink:
            case "row":
                return link
            case "tint":
                return mix(link, self.background, TINT)
            case "pale":
                return mix(self.grey, self.background, PALE)
            case "ground":
                return self.background
            case "text" | "grey" | "hairline":
                return str(getattr(self, ink))

    def line(self, row: int) -> LineStyle:
        """Return the line of a row: a thinner, dashed one where all inks and lines are in use."""
        again, place = divmod(row, max(len(self.inks), len(self.lines)))
        line = self.lines[place % len(self.lines)]
        return LineStyle(THINNER * line.weight, line.dash or DASH) if again else line

    @property
    def is_plain(self) -> bool:
        """Whether it has one ink alone: pale ink would be taken for another grey."""
        return len(self.inks) == 1

    def strength(self, role: str, alpha: float) -> float:
        """Return how much ink a mark has: ghosts are pale, or outlined where there is one ink."""
        return 1.0 if self.is_plain and role in GHOSTS else alpha

    def look(self, role: str, row: int | None, width: float = 1.0) -> Look:
        """Return how a mark of a role looks, its line ``width`` times as wide as usual."""
        part = ROLES[GHOSTS.get(role, role) if self.is_plain else role]
        fill = self.colour(part.fill, row) if part.fill else None
        under = Pen(self.background, part.halo, (), "round", "round") if part.halo else None
        if part.line is None:
            return Look(fill, None, under, part.alpha)
        line = self.line(row) if part.linked and row is not None else LineStyle()
        wide = part.width * width * line.weight
        dash = line.dash or part.dash
        cap = "butt" if line.dash else part.cap
        pen = Pen(self.colour(part.line, row), wide, tuple(p * wide for p in dash), cap, part.join)
        if line.dash and self.erase:
            under = Pen(self.background, wide + self.erase)
        return Look(fill, pen, under, part.alpha)


def mix(colour: str, ground: str, share: float) -> str:
    """Return ``share`` of ``colour`` laid over ``ground``.

    Examples
    --------
    >>> mix("#000000", "#FFFFFF", 0.2)
    '#CCCCCC'
    """
    pairs = ((int(colour[i : i + 2], 16), int(ground[i : i + 2], 16)) for i in (1, 3, 5))
    return "#" + "".join(f"{round(share * a + (1 - share) * b):02X}" for a, b in pairs)


def style_names() -> tuple[str, ...]:
    """Return the names of this package's own styles: every file in this folder is one."""
    return names_in("style")


def load_style(name: str) -> Style:
    """Return the style called ``name``: one of this folder, or one that another package brings.

    Raises
    ------
    vad.errors.UsageError
        If there is no style of that name.
    vad.errors.InputError
        If what another package has under that name is no style.
    """
    if one_of_all("style", name, style_names(), GROUP) in style_names():
        style = importlib.import_module(f"vad.style.{name}").STYLE
    else:
        style = from_packages(GROUP)[name]
        style = getattr(style, "STYLE", style)  # a module that is made as those of this folder
    if not isinstance(style, Style):
        raise InputError(f"style '{name}': must be a Style, got {quoted(style)}")
    return style
