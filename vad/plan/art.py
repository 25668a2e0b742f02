"""What a panel consists of: items that come and go with the strokes, and strokes that grow.

In comes the number of strokes done, out go marks in painting order.  Nothing here knows time.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntEnum

from vad.plan.labels import ALWAYS, Obstacles, Span
from vad.plan.marks import Mark
from vad.plan.page import Rect
from vad.plan.scale import Scale
from vad.strokes.sheet import Sheet
from vad.style import Line, Style

FOREVER = 1_000_000


class Level(IntEnum):
    """Painting order within a panel, lowest first."""

    GROUND = 0
    GLOW = 1
    CONSTRUCTION = 2
    CARRIER = 3
    BLOCK = 4
    STROKE = 5
    DOT = 6
    LABEL = 7


@dataclass(frozen=True, slots=True)
class Look:
    """The style as one sheet uses it: its unit in pixels, and a row for every link.

    ``centimetre`` is there on paper, where scales are round and stated.
    """

    style: Style
    unit: float
    rows: dict[str, int]
    centimetre: float | None = None

    @classmethod
    def of(cls, sheet: Sheet, style: Style, unit: float, centimetre: float | None = None) -> Look:
        """Return the look of ``sheet``: rows take their inks in order."""
        rows: dict[str, int] = {}
        for index, row in enumerate(sheet.rows):
            rows.setdefault(row.key, index)  # an actuator is a link and a slide: one ink
        return cls(style, unit, rows, centimetre)

    def ink(self, link: str | None) -> str:
        """Return the colour of a link or slide; grey for the frame."""
        return self.style.ink(self.rows.get(link or ""))

    def line(self, link: str | None) -> Line:
        """Return the weight and dash of a link or slide."""
        return self.style.line(self.rows.get(link or ""))


@dataclass(frozen=True, slots=True)
class Item:
    """Marks that show while ``since`` ≤ strokes done < ``until``."""

    level: Level
    since: int
    marks: list[Mark]
    until: int = FOREVER


@dataclass(frozen=True, slots=True)
class Growth:
    """A stroke being drawn: marks for the share of it that is there, 0 to 1."""

    level: Level
    draw: Callable[[float], list[Mark]]


@dataclass(frozen=True, slots=True)
class Tag:
    """A placed label as the overlap count sees it, and the strokes done while it shows."""

    text: str
    box: Rect
    span: Span = ALWAYS


@dataclass
class PanelArt:
    """Everything that one panel can show.

    Attributes
    ----------
    obstacles
        All strokes, at their finished length, and the boxes of the labels.
    items
        What is there after a number of strokes.
    growths
        One per stroke of the panel.
    glow
        The underlay of each link or slide while a vector of it is drawn elsewhere.
    tags
        The labels, for counting overlaps.
    """

    scale: Scale
    obstacles: Obstacles
    items: list[Item] = field(default_factory=list)
    growths: list[Growth] = field(default_factory=list)
    glow: dict[str, list[Mark]] = field(default_factory=dict)
    tags: list[Tag] = field(default_factory=list)

    def add(self, level: Level, since: int, marks: list[Mark], until: int = FOREVER) -> None:
        """Add an item."""
        self.items.append(Item(level, since, marks, until))

    def split(
        self, done: int, level: Level = Level.LABEL, lit: str | None = None
    ) -> tuple[list[Mark], list[Mark]]:
        """Return the marks up to ``level`` and those above it, in painting order.

        ``lit`` is the link whose glow shows.
        """
        shown = [item for item in self.items if item.since <= done < item.until]
        if lit in self.glow:
            shown.append(Item(Level.GLOW, 0, self.glow[lit or ""]))
        shown.sort(key=lambda item: item.level)
        under = [mark for item in shown if item.level <= level for mark in item.marks]
        over = [mark for item in shown if item.level > level for mark in item.marks]
        return under, over
