"""Counting what no reader should see: labels on strokes, on each other, or off the panel.

In comes a sheet as it would be painted, out go sentences, none if all is well.
"""

from __future__ import annotations

from itertools import combinations

from vad.plan.art import PanelArt, Tag
from vad.plan.board import Board
from vad.plan.labels import Obstacles, together
from vad.plan.page import Rect
from vad.strokes.sheet import Sheet


def overlaps(
    sheet: Sheet,
    size: tuple[int, int] = (1280, 720),
    style: str = "paper",
    lesson: bool = False,
) -> list[str]:
    """Return one line for each overlap of a label with a stroke, a label or an edge."""
    board = Board(sheet, size, style, lesson)
    found: list[str] = []
    for name, art in board.arts.items():
        found += [f"{name}: {text}" for text in _in_panel(art)]
    return found


def _in_panel(art: PanelArt) -> list[str]:
    found: list[str] = []
    for tag in art.tags:
        strokes = Obstacles(art.obstacles.edge, art.obstacles.during(tag.span).lines)
        if not _inside(tag.box, art.obstacles.edge):
            found.append(f"{tag.text} beyond the edge")
        elif not strokes.free([tag.box.centre], tag.box.width, tag.box.height, 0.0)[0]:
            found.append(f"{tag.text} on a stroke")
    for one, other in combinations(art.tags, 2):
        if _meet(one, other):
            found.append(f"{one.text} on {other.text}")
    return found


def _inside(box: Rect, edge: Rect) -> bool:
    return (
        box.left >= edge.left
        and box.right <= edge.right
        and box.bottom >= edge.bottom
        and box.top <= edge.top
    )


def _meet(one: Tag, other: Tag) -> bool:
    a, b = one.box, other.box
    return together(one.span, other.span) and (
        a.left < b.right and b.left < a.right and a.bottom < b.top and b.bottom < a.top
    )
