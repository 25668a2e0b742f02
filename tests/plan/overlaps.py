"""Counting what no reader should see: labels on strokes, close to each other, or off the panel.

In comes a sheet as it would be painted, out go sentences, none if all is well.
"""

from __future__ import annotations

from collections import deque
from itertools import combinations

from vad.plan.board import Plan, plan
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import together
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import LETTER
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Sheet
from vad.strokes.travels import travels

KEY = 0.058


#: The plans that were asked for last, each with its sheet: tests that look at equal sheets make
#: their plan once.
_MADE: deque[tuple[tuple[object, ...], Sheet, Plan]] = deque(maxlen=128)


def planned(
    sheet: Sheet, size: tuple[int, int] = (1280, 720), lesson: bool = False, flying: bool = False
) -> Plan:
    """Return the plan of a sheet on a screen, with the keys of most styles."""
    asked = size, lesson, flying, sheet.source is None
    for made in _MADE:
        if made[0] == asked and (made[1] is sheet or made[1] == sheet):
            _MADE.remove(made)
            break
    else:
        flights = travels(sheet) if flying else None
        made = asked, sheet, plan(sheet, screen(size), KEY, lesson, travels=flights)
    _MADE.append(made)  # the last one that was asked for
    return made[2]


def overlaps(sheet: Sheet, size: tuple[int, int] = (1280, 720), lesson: bool = False) -> list[str]:
    """Return one line for each label on a stroke, across an edge or too near another label."""
    found: list[str] = []
    for name, sketch in planned(sheet, size, lesson).sketches.items():
        found += [f"{name}: {text}" for text in _in_panel(sketch)]
    return found


def _in_panel(sketch: Sketch) -> list[str]:
    found: list[str] = []
    edge = sketch.obstacles.edge
    for tag in sketch.tags:
        strokes = Obstacles(edge, sketch.obstacles.during(tag.span).lines)
        if not _inside(tag.box, edge):
            found.append(f"{tag.text} beyond the edge")
        elif not strokes.free([tag.box.centre], tag.box.width, tag.box.height, 0.0)[0]:
            found.append(f"{tag.text} on a stroke")
    for one, other in combinations(sketch.tags, 2):
        if _close(one, other):
            found.append(f"{one.text} runs into {other.text}")
    return found


def _inside(box: Rect, edge: Rect) -> bool:
    return (
        box.left >= edge.left
        and box.right <= edge.right
        and box.bottom >= edge.bottom
        and box.top <= edge.top
    )


def _close(one: Tag, other: Tag) -> bool:
    """Tell whether less than half an em is between labels aside, and a quarter above."""
    a, b = one.box, other.box
    aside = max(a.left - b.right, b.left - a.right)
    above = max(a.bottom - b.top, b.bottom - a.top)
    near = aside < LETTER / 2 - 1e-9 and above < LETTER / 4 - 1e-9
    return together(one.span, other.span) and near
