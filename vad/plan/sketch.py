"""A panel while it is laid out: its scale, its items and labels so far, and its obstacles.

Every drawing function of this folder adds to a `Sketch`; nothing moves later.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

from vad.lecture.moment import done, drawing
from vad.plan.anchors import Anchor, Hung, Solved, Strip
from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, FOREVER, Item, Level, Span
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.lens import Lens
from vad.plan.marks import Mark, Polyline
from vad.plan.roles import BLOCK_RIM
from vad.plan.scale import Scale
from vad.strokes.sheet import Panel, Sheet, Stroke

if TYPE_CHECKING:
    from vad.plan.labels.vertices import Vertex


@dataclass(frozen=True, slots=True)
class Tag:
    """A placed label: its text, its ink box, and the beats in which it shows."""

    text: str
    box: Rect
    span: Span = ALWAYS


@dataclass(frozen=True, slots=True)
class Close:
    """A place where vertices that are not equal stand so close that they need a lens.

    Attributes
    ----------
    members
        The vertices that the lens shows, by their numbers.
    middle, reach
        The circle about them.
    factor
        How many times as large the lens shows them.
    stroke, since
        The number of the stroke with which the need for it arises, and the beat from which that is
        drawn.
    needed
        So many of the members, the first ones, are shown for the lens's sake; others are near.
    """

    members: tuple[int, ...]
    middle: complex
    reach: float
    factor: float
    stroke: int
    since: int
    needed: int = 2


@dataclass(frozen=True, slots=True)
class Setting:
    """The input of a picture: a panel, the room for it, and its place in the lesson.

    Attributes
    ----------
    sheet, panel
        What is drawn, and the panel of it.
    room
        Where.
    rows
        The row of the results whose ink a link or slide takes.
    numbers
        The numbers of the panel's strokes in the lesson; none where it is the only panel.
    centimetre
        Its length on paper, where scales are round; None on a screen.
    scale
        That of a picture beside others; None where it fills its room.
    taken
        The obstacles that are in the same room already: the polygon above.
    beside
        The room of the circle of bodies; None for a panel without one.
    lenses
        Whether a lens shows points that cannot be told apart.
    """

    sheet: Sheet
    panel: Panel
    room: Rect
    rows: Mapping[str, int]
    numbers: Sequence[int] = ()
    centimetre: float | None = None
    scale: Scale | None = None
    taken: Obstacles | None = None
    beside: Rect | None = None
    lenses: bool = True

    def clear(self) -> Obstacles:
        """Return what there is to keep clear of before anything is drawn."""
        if self.taken is None:
            return Obstacles(self.room)
        return replace(self.taken.copy(), edge=self.room)

    def row(self, link: str | None) -> int | None:
        """Return the row of a link or slide; None for the frame of the mechanism."""
        return self.rows.get(link or "")

    @property
    def first(self) -> int:
        """The number of the panel's first stroke in the lesson."""
        return self.number(0)

    def number(self, index: int) -> int:
        """Return the number of stroke ``index`` of the panel in the lesson."""
        return self.numbers[index] if self.numbers else index

    def during(self, index: int) -> int:
        """Return the beat in which stroke ``index`` of the panel is drawn."""
        return drawing(self.number(index))

    def after(self, index: int) -> int:
        """Return the beat at which stroke ``index`` of the panel is done."""
        return done(self.number(index) + 1)

    def over(self, index: int) -> int:
        """Return the beat that takes tools and lights of stroke ``index`` away: the next one."""
        return drawing(self.number(index) + 1)

    @property
    def end(self) -> int:
        """The beat at which the panel is finished, or left for another: what stays is there."""
        numbers = self.numbers or range(len(self.panel.strokes))
        jump = (n for n, (one, next_one) in enumerate(pairwise(numbers)) if next_one > one + 1)
        return self.over(next(jump, len(numbers) - 1))


#: When marks of a stroke come and go: while it is drawn, when it is done, when the next one is
#: begun, when the panel is finished.
When = Literal["during", "after", "over", "end", "never"]


@dataclass(frozen=True, slots=True)
class Part:
    """Marks of one stroke that come and go together."""

    level: Level
    marks: tuple[Hung, ...]
    since: When = "during"
    until: When = "never"


@dataclass(frozen=True, slots=True)
class Piece:
    """One stroke on the page, with its anchors for all poses.

    Attributes
    ----------
    parts
        Its marks.
    blocks
        The obstacles of labels: lines through anchors with their half widths, and dots, which are
        lines with one anchor.
    light
        The light beneath it while a vector of its link is drawn elsewhere.
    slot
        A slot whose edges and middle labels keep clear of.
    """

    parts: tuple[Part, ...]
    blocks: tuple[tuple[tuple[Anchor, ...], float], ...] = ()
    light: Hung | None = None
    slot: Strip | None = None

    def block(self, obstacles: Obstacles, solved: Solved, span: Span = ALWAYS) -> None:
        """Add it to what labels keep clear of, as it hangs in a pose."""
        for anchors, half in self.blocks:
            places = solved.places(anchors)
            if len(places) == 1:
                obstacles.disc(places[0], half, span)
            else:
                obstacles.line(places, half, span)
        edges = self.slot.posed(solved) if self.slot else None
        if self.slot and isinstance(edges, Polyline):
            obstacles.line(edges.pieces[0], BLOCK_RIM / 2, span)
            obstacles.line(self.slot.ends(solved), 2.0 * PIXEL, span)


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
        The items so far, and the labels among them.
    lights
        The light beneath each link or slide, for when a vector of it is drawn elsewhere.
    finished
        True for one pose of a turn, or one set by hand: only the final state of each stroke is
        drawn.
    vertices
        The points that bear letters.
    unnamed
        Joints that bear none: no letter may seem to name one.
    close, lenses
        The places where points cannot be told apart, and the lenses that show some of them.
    astray
        How far from its best place a note stands, at most; infinite if one has no free place.
    """

    setting: Setting
    scale: Scale
    obstacles: Obstacles
    items: list[Item] = field(default_factory=list)
    tags: list[Tag] = field(default_factory=list)
    lights: dict[str, list[Mark]] = field(default_factory=dict)
    finished: bool = False
    vertices: Sequence[Vertex] = ()
    unnamed: list[complex] = field(default_factory=list)
    close: list[Close] = field(default_factory=list)
    lenses: list[Lens] = field(default_factory=list)
    astray: float = 0.0

    @cached_property
    def solved(self) -> Solved:
        """The solved points and directions of the panel, on which its marks hang."""
        return Solved(self.setting.panel, self.scale)

    def add(
        self,
        stroke: Stroke | None,
        level: Level,
        since: int,
        marks: Iterable[Mark],
        until: int = FOREVER,
    ) -> None:
        """Add what ``stroke`` draws; None for what belongs to no stroke."""
        if self.finished:
            if until != FOREVER and until <= self.setting.end:
                return
            since = 0
            marks = [replace(mark, growth=None) if mark.growth else mark for mark in marks]
        shown = tuple(marks)
        if shown:
            panel = self.setting.panel
            name = panel.full(stroke.name) if stroke else ""
            self.items.append(Item(name, panel.column, level, shown, since, until))

    def hang(
        self,
        index: int,
        level: Level,
        marks: Iterable[Hung],
        since: When = "during",
        until: When = "never",
    ) -> None:
        """Add what stroke number ``index`` draws, as it hangs in this pose."""
        if self.finished and until != "never":
            return
        solved, grows = self.solved, not self.finished
        shown = [each for mark in marks if (each := mark.posed(solved, grows))]
        stroke = self.setting.panel.strokes[index]
        first, last = (self._beat(since, index), self._beat(until, index)) if grows else ALWAYS
        self.add(stroke, level, first, shown, last)

    def put(self, index: int, piece: Piece, spanned: bool = False) -> None:
        """Add stroke number ``index`` with its obstacles, which come with it where ``spanned``."""
        for part in piece.parts:
            self.hang(index, part.level, part.marks, part.since, part.until)
        span = (self.setting.during(index), FOREVER) if spanned else ALWAYS
        piece.block(self.obstacles, self.solved, span)
        if piece.light and not self.finished:
            light = piece.light.posed(self.solved)
            link = self.setting.panel.strokes[index].link
            self.lights.setdefault(link or "", []).extend([light] if light else [])

    def mapped(self, factor: float, shift: complex) -> Sketch:
        """Return it ``factor`` times as large with all its type and lines, and shifted."""
        setting, scale, obstacles = self.setting, self.scale, self.obstacles
        aside = setting.beside and setting.beside.mapped(factor, shift)
        room = setting.room.mapped(factor, shift)
        lines = [
            (factor * start + shift, factor * end + shift, factor * half, span)
            for start, end, half, span in obstacles.lines
        ]
        boxes = [(box.mapped(factor, shift), span) for box, span in obstacles.boxes]
        return Sketch(
            replace(setting, room=room, beside=aside, taken=None),
            replace(scale, origin=factor * scale.origin + shift, factor=factor * scale.factor),
            Obstacles(obstacles.edge.mapped(factor, shift), lines, boxes),
            [
                replace(item, marks=tuple(mark.mapped(factor, shift) for mark in item.marks))
                for item in self.items
            ],
            [replace(tag, box=tag.box.mapped(factor, shift)) for tag in self.tags],
            {
                link: [mark.mapped(factor, shift) for mark in marks]
                for link, marks in self.lights.items()
            },
            self.finished,
            lenses=[lens.mapped(factor, shift) for lens in self.lenses],
        )

    def _beat(self, when: When, index: int) -> int:
        """Return a beat of stroke number ``index``."""
        setting = self.setting
        match when:
            case "during":
                return setting.during(index)
            case "after":
                return setting.after(index)
            case "over":
                return setting.over(index)
            case "end":
                return setting.end
            case "never":
                return FOREVER
