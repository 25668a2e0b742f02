"""A lesson that stands still: the page at one of its steps.

In come a lesson and the number of a step, out goes a `Still`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from operator import index
from typing import Any

from vad.displayed import Displayed
from vad.errors import UsageError, one_of, shown
from vad.lecture.lesson import Lesson
from vad.lecture.moment import Moment, done, drawing
from vad.strokes.sheet import Panel, Sheet, Stroke

#: How much of a construction is drawn while it stands still.
AT_WORK = 0.7
#: More of them are too many steps, and with very many Python makes no number of them.
_DIGITS = 9


@dataclass(frozen=True, slots=True)
class Still(Displayed):
    """The page of a lesson at a step, which is counted from 1.

    A construction is shown while it is drawn, so that its tool is seen at work; all else is done.
    """

    lesson: Lesson
    step: int

    @property
    def moment(self) -> Moment:
        """The state of the board."""
        if self.lesson.steps[self.step - 1].stroke.kind == "construction":
            return Moment(drawing(self.step - 1), AT_WORK)
        return Moment(done(self.step))

    @property
    def drawn(self) -> Sheet:
        """The strokes that are there, and the rows with what is given or has been measured."""
        strokes: dict[str, tuple[Stroke, ...]] = {}
        for step in self.lesson.steps[: self.step]:
            strokes[step.panel.name] = (*strokes.get(step.panel.name, ()), step.stroke)
        return part(self.lesson.sheet, strokes)


def part(sheet: Sheet, strokes: Mapping[str, tuple[Stroke, ...]]) -> Sheet:
    """Return what there is of a sheet when of each panel some strokes are drawn, by its name.

    Panels without any are left out, and so are values that have not been measured yet.
    """
    panels = tuple(filter(None, (_part(panel, strokes) for panel in sheet.panels)))
    known = {
        (half.name, key)
        for panel in panels
        for half in panel.halves
        for stroke in half.strokes
        for key in stroke.reveals
    }
    rows = []
    for row in sheet.rows:
        cells = {
            panel.name: tuple(
                cell
                for half, measured in sheet.panel(panel.name).measures(row)
                for cell in measured
                if cell.given or (half.name, row.key) in known
            )
            for panel in panels
        }
        if any(cells.values()):
            rows.append(replace(row, cells=cells))
    rate = sheet.driver.rate if any(panel.name == "velocity" for panel in panels) else 0.0
    driver = replace(sheet.driver, rate=rate)
    return replace(sheet, panels=panels, rows=tuple(rows), driver=driver)


def _part(panel: Panel | None, strokes: Mapping[str, tuple[Stroke, ...]]) -> Panel | None:
    """Return what there is of a panel, None for nothing."""
    if panel is None or not strokes.get(panel.name):
        return None
    return replace(panel, strokes=strokes[panel.name], below=_part(panel.below, strokes))


def still(lesson: Lesson, step: int | str) -> Still:
    """Return the page of a lesson at one step.

    Parameters
    ----------
    lesson
        The lesson.
    step
        Its number, from 1, over the whole lesson; or ``"velocity:4"``, the fourth of a panel.

    Raises
    ------
    vad.errors.UsageError
        If there is no such step.
    """
    if not isinstance(lesson, Lesson):
        raise UsageError(f"lesson: must be what vad.animate returns, got {shown(lesson)}")
    panel, colon, number = step.rpartition(":") if isinstance(step, str) else ("", "", step)
    places: dict[str, list[int]] = {
        name: [i for i, each in enumerate(lesson.steps, 1) if each.panel.column == name]
        for name in (each.name for each in lesson.sheet.panels)
    }
    steps = places[one_of("panel", panel, places)] if colon else range(1, len(lesson.steps) + 1)
    where = f"the {panel} panel" if colon else "the lesson"
    place = _place(number)
    if place is None:
        raise UsageError(f"{shown(step)} is not a step", hint="as in 4 or velocity:4")
    if not 1 <= place <= len(steps):
        got = shown(number).strip("'")
        raise UsageError(f"there is no step {got}: {where} has {len(steps)}, from 1 on")
    return Still(lesson, steps[place - 1])


def _place(number: Any) -> int | None:
    """Return the number of a step, or None for what is none."""
    if isinstance(number, str):
        return int(number.strip()[:_DIGITS]) if number.strip().isdecimal() else None
    try:
        return None if isinstance(number, bool) else index(number)
    except TypeError:
        return None
