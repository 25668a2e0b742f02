"""The problem sheet: a sheet on which some panels are left to be drawn, and their results measured.

The plan of the whole sheet is the key; it becomes a plan of the same page without the answers.
What stands on both stands at the same place, but for the letter of a pole: in an empty panel it
stands close to it.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

from vad import gate
from vad.errors import one_of
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.items import (
    FOREVER,
    RESULTS,
    TASK,
    Item,
    Level,
    foot_of,
    head_of,
    in_painting_order,
)
from vad.plan.marks import Mark, Polyline
from vad.plan.page.free_places import box_of
from vad.plan.page.table import table
from vad.plan.page.task import upon_problem
from vad.plan.pictures.senses import senses_of
from vad.strokes.diagram import POSITION
from vad.strokes.reveals import measurer
from vad.strokes.sheet import POLE, Sheet, Stroke, StrokePart
from vad.strokes.telling import BEFORE_INERTIA

#: The panel of the force polygons.
FORCES = "force"
#: From a pole to the letter beside it.
BESIDE_POLE = 0.009
#: The circle of bodies, on which a student draws what is known and what is found.
CIRCLE = StrokePart("bodies", "circle")
#: What is left to be drawn: the panels by their names, each with the strokes that it shows.
Blank = Mapping[str, tuple[Stroke, ...]]


def blank_panels(sheet: Sheet, names: Sequence[str] | str) -> Blank:
    """Return the panels of these names, with what is given: pole, fixed points, or a mechanism.

    Raises
    ------
    vad.errors.UsageError
        For a panel that the sheet does not have.
    """
    chosen = gate.several("blank", names, "names of panels")
    there = [panel.name for panel in sheet.panels]
    panels = [sheet.panel(one_of("panel", name, there)) for name in chosen]
    return {
        half.name: (*half.strokes[: half.given], *filter(_is_given, half.strokes[half.given :]))
        for panel in panels
        for half in panel.halves
    }


def _is_given(stroke: Stroke) -> bool:
    return stroke.kind in ("pole", "fixed") or stroke.part in (POLE, CIRCLE)


def problem(key: Plan, blank: Blank, line: float, task: str | None = "") -> Plan:
    """Return the plan of a problem.

    Parameters
    ----------
    key
        The plan of the whole sheet.
    blank
        What is left to be drawn.
    line
        The length of the line before a row's name, with which the key was made.
    task
        The task in words; empty for one that the sheet words itself, None for no task and no lines
        for a name.

    Raises
    ------
    vad.errors.UsageError
        If the task is too long for the page.
    """
    panels = [key.sketches[name].setting.panel for name in blank]
    answers = {panel.full(stroke.name) for panel in panels for stroke in panel.strokes}
    answers |= _given_away(key, blank)
    lost = _without_arrow(key, answers)
    items = [
        shown
        for each in key.items
        if (each.region, each.stroke) not in lost
        if (shown := _without_answer(each, key, blank, answers))
    ]
    items = list(_beside_poles(items, key, blank))
    cells = table(key.sheet, key.page, line, turns=key.turns).cells
    for name in key.page.panels:
        for index, row in enumerate(key.sheet.rows):
            by = measurer(key.sheet, key.sheet.panel(name), row)
            if name not in blank and (by is None or by[0].full(by[1].name) not in answers):
                continue
            both = zip(row.cells.get(name, ()), cells(index, row, name, False), strict=True)
            marks = [entry.marks if cell.given else entry.blank for cell, entry in both]
            if not all(cell.given for cell in row.cells.get(name, ())):  # those stand there
                items.append(Item("", RESULTS, Level.LABEL, tuple(chain(*marks))))
    if task is None:
        return replace(key, items=tuple(items))
    items += upon_problem(key, items, blank, task)
    regions = {**key.regions, TASK: Rect(0.0, 0.0, key.page.width, key.page.height)}
    return replace(key, items=tuple(in_painting_order(items, regions)), regions=regions)


def _given_away(key: Plan, blank: Blank) -> set[str]:
    """Return the names of the strokes of other panels that show what is to be found.

    These are lines on which forces act, for the force polygons, and inertia forces, for the polygon
    of the accelerations.
    """
    found: set[str] = set()
    for name in key.sketches.keys() - blank.keys():
        panel = key.sketches[name].setting.panel
        waits = panel.find(panel.resumes) if BEFORE_INERTIA in blank else None
        for number, stroke in enumerate(panel.strokes):
            line = stroke.kind == "construction" and stroke.component == "action"
            shown = FORCES in blank and (line or stroke.part.which == "meeting")
            if shown or (waits is not None and number >= waits):
                found.add(panel.full(stroke.name))
    return found


def _without_arrow(key: Plan, answers: Collection[str]) -> set[tuple[str, str]]:
    """Return the region and stroke of names that lose the arrow of a sense beside which they stand.

    The arrow of ω₃ and α₃ together comes with ω₃: where that is to be found, α₃ goes with it.
    """
    return {
        (POSITION.panel, by)
        for row in key.sheet.rows
        for sense in senses_of(key.sketches, row)
        if sense.names[0][1] in answers
        for _, by, _ in sense.names[1:]
    }


def _without_answer(item: Item, key: Plan, blank: Blank, answers: Collection[str]) -> Item | None:
    """Return an item as a problem shows it; None where it is an answer, or a part of one.

    ``answers`` are the names of the strokes that are left to be drawn.
    """
    if item.region in map(head_of, blank):
        return item if item.until == FOREVER else None
    if item.region in map(foot_of, blank):  # a remark is no answer
        return item if all(mark.role == "notes" for mark in item.marks) else None
    if item.region not in blank:
        return None if item.stroke in answers else item
    for name, strokes in blank.items():
        setting = key.sketches[name].setting
        for stroke in strokes:
            since = setting.after(setting.panel.number(stroke.name))
            own = item.stroke == setting.panel.full(stroke.name)
            # Letters may come to a point; what shines for a while is no part of a figure.
            stays = item.until == FOREVER or stroke.kind in ("pole", "fixed")
            stays = (stays and item.level != Level.GLOW) or item.level == Level.LABEL
            if own and stays and item.since <= since < item.until:
                return replace(item, since=0, until=FOREVER)  # without letters that come to it
    return None


def _beside_poles(items: Sequence[Item], key: Plan, blank: Blank) -> Iterator[Item]:
    """Yield items; in an empty panel a letter needs no leader, and stands close to its pole."""
    leaders = {
        (each.region, each.stroke): mark.shape
        for each in items
        for mark in each.marks
        if each.region in blank and mark.role == "leader"
    }
    for item in items:
        leader = leaders.get((item.region, item.stroke))
        rest = tuple(mark for mark in item.marks if mark.role != "leader")
        letters = [mark for mark in rest if mark.role == "letter"]
        if isinstance(leader, Polyline) and letters:
            room = key.sketches[item.region].setting.room
            rest = tuple(_close(letters, leader.pieces[0], room))
        if leader is None or rest:
            yield item if leader is None else replace(item, marks=rest)


def _close(letters: list[Mark], leader: Sequence[complex], room: Rect) -> Iterator[Mark]:
    """Yield letters beside the dot to which their leader runs, on its side of it."""
    box = box_of(*letters)
    pole = max(leader, key=lambda end: abs(end - box.centre))
    way = box.centre - pole
    across, up = box.width / 2 + BESIDE_POLE, box.height / 2 + BESIDE_POLE
    if not room.left < pole.real + math.copysign(2 * across, way.real) < room.right:
        across = -across
    if not room.bottom < pole.imag + math.copysign(2 * up, way.imag) < room.top:
        up = -up
    shift = complex(math.copysign(1.0, way.real) * across, math.copysign(1.0, way.imag) * up) - way
    for mark in letters:
        yield replace(mark, shape=mark.shape.mapped(1.0, shift))
