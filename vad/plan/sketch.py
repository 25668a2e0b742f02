"""A panel in the making: its scale, its items and labels so far, and what they keep clear of.

Every drawing function of this folder adds to a `Sketch`; nothing moves later.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from vad.lecture.moment import done, drawing
from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, FOREVER, Item, Level, Span
from vad.plan.labels.obstacles import Obstacles
from vad.plan.marks import Mark
from vad.plan.scale import Scale
from vad.strokes.sheet import Panel, Sheet, Stroke


@dataclass(frozen=True, slots=True)
class Tag:
    """A placed label: its text, its ink box, and the beats in which it shows."""

    text: str
    box: Rect
    span: Span = ALWAYS


@dataclass(frozen=True, slots=True)
class Setting:
    """What a picture is given: a panel, the room for it, and its place in the lesson.

    Attributes
    ----------
    sheet, panel
        What is drawn, and the panel of it.
    room
        Where.
    rows
        The row of the results whose ink a link or slide takes.
    first
        The number of the panel's first stroke in the lesson.
    centimetre
        Its length on paper, where scales are round; None on a screen.
    scale
        That of a picture beside others; None where it fills its room.
    taken
        What stands in the same room already: the polygon above.
    """

    sheet: Sheet
    panel: Panel
    room: Rect
    rows: Mapping[str, int]
    first: int = 0
    centimetre: float | None = None
    scale: Scale | None = None
    taken: Obstacles | None = None

    def clear(self) -> Obstacles:
        """Return what there is to keep clear of before anything is drawn."""
        if self.taken is None:
            return Obstacles(self.room)
        return Obstacles(self.room, [*self.taken.lines], [*self.taken.boxes])

    def row(self, link: str | None) -> int | None:
        """Return the row of a link or slide; None for the frame of the mechanism."""
        return self.rows.get(link or "")

    def during(self, index: int) -> int:
        """Return the beat in which stroke ``index`` of the panel is drawn."""
        return drawing(self.first + index)

    def after(self, index: int) -> int:
        """Return the beat at which stroke ``index`` of the panel is done."""
        return done(self.first + index + 1)

    def over(self, index: int) -> int:
        """Return the beat that takes tools and lights of stroke ``index`` away: the next one."""
        return drawing(self.first + index + 1)

    @property
    def end(self) -> int:
        """The beat at which the panel is finished: only what stays is there."""
        return self.over(len(self.panel.strokes) - 1)


@dataclass
class Sketch:
    """Everything that one panel can show.

    Attributes
    ----------
    setting
        What the picture was given.
    scale
        From the panel's coordinates to the page.
    obstacles
        All strokes, at their finished length, and the boxes of the labels.
    items, tags
        What stands there, and the labels among it.
    lights
        The light beneath each link or slide, for when a vector of it is drawn elsewhere.
    """

    setting: Setting
    scale: Scale
    obstacles: Obstacles
    items: list[Item] = field(default_factory=list)
    tags: list[Tag] = field(default_factory=list)
    lights: dict[str, list[Mark]] = field(default_factory=dict)

    def add(
        self,
        stroke: Stroke | None,
        level: Level,
        since: int,
        marks: Iterable[Mark],
        until: int = FOREVER,
    ) -> None:
        """Add what ``stroke`` draws; None for what belongs to no stroke."""
        shown = tuple(marks)
        if shown:
            panel = self.setting.panel
            name = panel.full(stroke.name) if stroke else ""
            self.items.append(Item(name, panel.column, level, shown, since, until))
