"""Counting what no reader should see: labels on strokes, close to each other, or off the panel.

In comes a sheet as it would be painted, out go sentences, none if all is well.
"""

from __future__ import annotations

from collections import OrderedDict
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


#: The plans that were asked for last, by their sheet itself: tests that look at the same sheet
#: make its plan once.
_MADE: OrderedDict[tuple[int, tuple[int, int], bool, bool], tuple[Sheet, Plan]] = OrderedDict()
_KEPT = 128


def planned(
    sheet: Sheet, size: tuple[int, int] = (1280, 720), lesson: bool = False, flying: bool = False
) -> Plan:
    """Return the plan of a sheet on a screen, with the keys of most styles."""
    # Of a sheet that is kept with its plan, so that no other has the key.
    key = id(sheet), size, lesson, flying
    if key not in _MADE:
        flights = travels(sheet) if flying else None
        _MADE[key] = sheet, plan(sheet, screen(size), KEY, lesson, travels=flights)
        if len(_MADE) > _KEPT:
            _MADE.popitem(last=False)
    _MADE.move_to_end(key)
    return _MADE[key][1]


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
