"""What stands on a page, and when: items that come and go with the strokes.

An item is visible while ``since`` ≤ beat < ``until``, in the beats of `vad.lecture.moment`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import IntEnum

from vad.plan.marks import Mark

FOREVER = 1_000_000

#: The regions of a page that belong to no panel; that of a panel's drawing is the panel's name.
TITLE, RESULTS, CAPTION = "title", "results", "caption"
#: How the name of a region above a panel's drawing ends.
HEAD = " head"
#: The whole page of a problem sheet, for the task and the lines for name and class.
TASK = "task"
#: The whole page, over everything else: what flies from one panel to another while a stroke is
#: drawn.  Each of its items grows, and is gone at the next beat.
FLIGHT = "flight"

#: An item is visible from the first beat on, until the second.
Span = tuple[int, int]
ALWAYS: Span = (0, FOREVER)


class Level(IntEnum):
    """Painting order within a region, lowest first."""

    GROUND = 0
    GLOW = 1
    CONSTRUCTION = 2
    CARRIER = 3
    BLOCK = 4
    STROKE = 5
    DOT = 6
    LABEL = 7
    LENS = 8


@dataclass(frozen=True, slots=True, eq=False)
class Item:
    """Marks that belong together.

    Attributes
    ----------
    stroke
        The full name of the stroke that they draw, as ``velocity:BC.line``; empty for the page.
    region
        The part of the page that they stand in.
    level
        Their place in the painting order of the region.
    marks
        In painting order; those with a growth come about while the stroke is drawn.
    since, until
        The beats between which they show.
    words
        How many beats of the caption have been said while they show: from the first number on,
        until the second.
    """

    stroke: str
    region: str
    level: Level
    marks: tuple[Mark, ...]
    since: int = 0
    until: int = FOREVER
    words: Span = ALWAYS

    @property
    def grows(self) -> bool:
        """Whether any of the marks comes about while the stroke is drawn."""
        return any(mark.growth for mark in self.marks)

    def at(self, share: float) -> list[Mark]:
        """Return the marks that show when ``share`` of the stroke is drawn."""
        return [shown for mark in self.marks if (shown := mark.at(share))]


def head_of(panel: str) -> str:
    """Return the region above a panel's drawing: its title and its scale."""
    return panel + HEAD


def foot_of(panel: str) -> str:
    """Return the region below a panel's drawing: its equations."""
    return f"{panel} foot"


def curve_of(panel: str) -> str:
    """Return the region of the output over a turn, below a panel's drawing."""
    return f"{panel} curve"


def in_painting_order(items: Iterable[Item], regions: Iterable[str]) -> list[Item]:
    """Return items by the order of their regions, and there by their levels, lowest first."""
    order = {name: number for number, name in enumerate(regions)}
    return sorted(items, key=lambda item: (order[item.region], item.level))


def together(one: Span, other: Span) -> bool:
    """Tell whether two spans have a beat in common."""
    return one[0] < other[1] and other[0] < one[1]
