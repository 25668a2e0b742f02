"""The stage of a lesson: the panel in work is large, and the panels move from scene to scene.

A lesson with several panels is a row of scenes (`vad.lecture.scenes`), each of them a `Plan` of the
same sheet in a layout of its own.  After the last scene comes the sheet as it is drawn as a still,
a little smaller, so that the answer stands below it.
Between two of them every panel moves from its place in one to its place in the other
(`vad.plan.moving`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from vad.lecture.answer import answer
from vad.lecture.chapters import Chapter
from vad.lecture.moment import Moment, drawing, finished
from vad.lecture.scenes import scenes
from vad.plan.board import Plan, arrange, column, pictures, plan, reach, regions_of
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import CAPTION, FLIGHT, TITLE, Item, Level, head_of, in_painting_order
from vad.plan.labels.obstacles import Obstacles
from vad.plan.layout import MARGIN, Page
from vad.plan.lettering.glyphs import fitted
from vad.plan.lettering.runs import bold, roman
from vad.plan.making_way import made_way
from vad.plan.marks import Lettering, Mark, line
from vad.plan.moving import Move
from vad.plan.page.changing import (
    caption_lines,
    captions,
    lines_at_last,
    numbers_said,
    said_at_last,
)
from vad.plan.page.chapters import CHAPTERS, chapter_marks
from vad.plan.page.free_places import box_of
from vad.plan.page.heads import head, pale, title_marks
from vad.plan.page.work import in_work
from vad.plan.pictures.dimming import dimmings
from vad.plan.pictures.roomless import roomless
from vad.plan.pictures.senses import found_senses
from vad.plan.pictures.sent import sent, to_rows
from vad.plan.reach import corners, extent
from vad.plan.scene_layout import SceneLayout, lay_out_scene
from vad.plan.sketch import Sketch
from vad.strokes.sheet import Arc, Curve, Panel, Sheet
from vad.strokes.travel import Travel

#: The regions in which panels move: between scenes above the caption, at last on the whole page.
MOVING, LAST_MOVE = "moving", "last move"
#: The region of the answer below the whole sheet, and the gap above it.
ANSWER, ABOVE_ANSWER = "answer", 0.02
#: The regions that all scenes have in common.
SHARED = (TITLE, CAPTION, CHAPTERS, FLIGHT)
SMALL_TITLE, LEAST_SMALL_TITLE = 0.030, 0.020
#: In a thumbnail less wide than this, views have letters alone: values of angles and names of lines
#: would stand far off.
FULL_VIEWS = 0.20
SLACK = 0.012  # of a drawing: so far the pencil may reach beyond it


class Stage:
    """The board of a lesson with several panels.

    Attributes
    ----------
    sheet
        What is drawn.
    form
        The shape of the page.
    regions
        The parts of the page that change on their own, those of all scenes, in painting order.
    """

    def __init__(
        self,
        sheet: Sheet,
        form: Format,
        key: float,
        travels: Mapping[str, Travel] | None = None,
        chapters: Sequence[Chapter] = (),
    ) -> None:
        self.sheet, self.form, self._key, self._travels = sheet, form, key, travels
        self._names, self._answer = scenes(sheet), answer(sheet)
        lines = caption_lines(sheet, form.width - 2 * MARGIN)
        shapes = {panel.name: _shape(panel) for panel in sheet.panels}
        self._layouts = [lay_out_scene(form, shapes, name, lines) for name in self._names]
        self._drawn: dict[tuple[str, float, float], dict[str, Sketch]] = {}
        self._made: dict[int, Plan] = {}
        self._moves: dict[tuple[int, int], Move] = {}
        self._pale: dict[tuple[int, int], dict[Item, Item]] = {}
        self._told: list[Item] = []
        strokes = sum(len(half.strokes) for half in sheet.halves)
        self._chapters = [*chapter_marks(chapters, strokes, self._layouts[0].page)]
        first = self._layouts[0].regions
        low, top = first[CAPTION].top, first[TITLE].bottom
        self.regions: dict[str, Rect] = {TITLE: first[TITLE]}
        for number, layout in enumerate(self._layouts):
            self._add(number, layout.regions)
        answered = regions_of(self._answered_page)[CAPTION]
        self._add(self.count, {**self.scene(self.count).regions, ANSWER: answered})
        self.regions[MOVING] = Rect(0.0, low, form.width, top)
        self.regions[LAST_MOVE] = Rect(0.0, 0.0, form.width, top)
        self.regions |= {name: first[name] for name in (CAPTION, CHAPTERS)}
        self.regions[FLIGHT] = Rect(0.0, 0.0, form.width, form.height)

    def _add(self, number: int, regions: Mapping[str, Rect]) -> None:
        own = {_of(number, name): area for name, area in regions.items() if name not in SHARED}
        self.regions |= own

    @property
    def count(self) -> int:
        """The number of scenes, without the whole sheet at the end."""
        return len(self._layouts)

    @property
    def finished(self) -> int:
        """The beat at which all strokes are done and the tools put away."""
        return finished(sum(len(half.strokes) for half in self.sheet.halves))

    @cached_property
    def whole(self) -> Plan:
        """The sheet, as a still shows it."""
        return plan(self.sheet, self.form, self._key)

    @cached_property
    def _answered_page(self) -> Page:
        """The page of the sheet with room for the answer."""
        lines = lines_at_last(self._answer, self.form.width - 2 * MARGIN)
        return arrange(self.sheet, self.form, lines)[0]

    def at(self, moment: Moment) -> Sequence[Item]:
        """Return the items that show at a moment, in painting order; see `Board`."""
        number, share = divmod(moment.scene, 1.0)
        now = int(number)
        own = self._move(now, moment.beat).at(share) if share else self.scene(now).at(moment)
        # Title, caption and chapters are the same in all scenes.
        shown = [*self._title, *own]
        if moment.scene <= self.count - 1:
            said, told = self._captions(self.scene(0).sketches), moment.beat if moment.said else 0
            shown += [each for each in said if _shows(each, moment.beat)]
            shown += [each for each in self._chapters if _shows(each, told)]
        if not share:
            shown = self._made_way(shown, now, moment.beat)
        return sorted(shown, key=lambda item: item.region == FLIGHT)

    def _made_way(self, shown: Sequence[Item], scene: int, beat: int) -> list[Item]:
        """Return what shows in a scene, where text makes way: the same items in all frames."""
        if (scene, beat) not in self._pale:
            ways = zip(shown, made_way(shown, beat), strict=True)
            self._pale = {(scene, beat): {each: pale for each, pale in ways if pale is not each}}
        pale = self._pale[scene, beat]
        return [pale.get(item, item) for item in shown]

    def scene(self, number: int) -> Plan:
        """Return the plan of a scene without title and caption; after the last that of the sheet.

        Its regions are those of the stage.
        """
        if number not in self._made:
            made = self._last() if number == self.count else self._scene(number)
            self._made[number] = made
        return self._made[number]

    def layout(self, number: int) -> SceneLayout:
        """Return the layout of a scene."""
        return self._layouts[number]

    def _last(self) -> Plan:
        """Return the still, as much smaller as the answer below it needs."""
        whole, items = self.whole, [i for i in self.whole.items if i.region != TITLE]
        top, low = whole.regions[TITLE].bottom, reach(items).bottom
        answered = regions_of(self._answered_page)[CAPTION].top + ABOVE_ANSWER
        factor = min(1.0, (top - answered) / (top - low)) if self._answer else 1.0
        shift = (1.0 - factor) * complex(self.form.width / 2, top)
        items = [
            replace(each, marks=tuple([mark.mapped(factor, shift) for mark in each.marks]))
            for each in items
        ]
        shown = [*_in_scene(items, self.count), *self._answered(self._answered_page)]
        regions = {name: area.mapped(factor, shift) for name, area in whole.regions.items()}
        return replace(whole, items=tuple(shown), regions=regions)

    def _answered(self, page: Page) -> list[Item]:
        """Return the answer on a page; in the last move, its caption goes to its place."""
        told = [said_at_last(self._answer, page, self.finished)] if self._answer else []
        return [replace(each, region=_of(self.count, ANSWER)) for each in told]

    def _scene(self, number: int) -> Plan:
        layout, sheet = self._layouts[number], self.sheet
        page, large = layout.page, sheet.panel(layout.large)
        sketches: dict[str, Sketch] = {}
        for panel in sheet.panels:
            sketches |= self._placed(panel, page.panels[panel.name].drawing, layout)
        flies = self._travels is not None
        drawn = list(pictures(sketches, self._travels))
        own = [item for item in drawn if item.region == large.name]
        factor, shift = _fitted(own, page.panels[large.name].drawing)
        if (factor, shift) != (1.0, 0j):
            for half in large.halves:
                sketches[half.name] = sketches[half.name].mapped(factor, shift)
        senses, heads = list(found_senses(sketches)), list(self._heads(layout, sketches))
        turns = {**self.whole.turns, **roomless(sketches, [*drawn, *senses])}
        work = list(in_work(sheet, large, sketches, layout.work, self._key, flies, turns))
        words = self._words([*self._title, *heads, *work])
        others = self._words([*senses, *(each for each in drawn if each.level == Level.LENS)])
        others.boxes += [each for sketch in sketches.values() for each in sketch.obstacles.boxes]
        drawn = list(pictures(sketches, self._travels, words))
        if flies:
            numbers, shown = numbers_said(sheet, self._captions(sketches)), senses
            texts = words, others
            senses = [*sent(shown, numbers, *texts), *to_rows(work, shown, numbers, *texts)]
        items = [*drawn, *senses, *heads, *work]
        regions = layout.regions
        ordered = _in_scene(in_painting_order(items, regions), number)
        dimmed = {
            beat: replace(each, region=_of(number, each.region))
            for beat, each in dimmings(drawn, sketches, self._travels).items()
        }
        return Plan(sheet, self.form, page, regions, tuple(ordered), sketches, dimmed, turns)

    def _words(self, items: Iterable[Item]) -> Obstacles:
        """Return words and scale bars beside the panels, which flights avoid, within their room.

        That is above the caption, which is read meanwhile.
        """
        low = self.regions[CAPTION].top
        words = Obstacles(Rect(0.0, low, self.form.width, self.form.height))
        for item in items:
            for mark in item.marks:
                if isinstance(mark.shape, Lettering) or mark.role == "scale bar":
                    words.box(box_of(replace(mark, growth=None)), (item.since, item.until))
        return words

    def _placed(self, panel: Panel, drawing: Rect, layout: SceneLayout) -> dict[str, Sketch]:
        """Return the sketches of a panel in a place, with lines and letters of its own size.

        It is laid out in a room of its own, and from there shifted and scaled to its place, so that
        thumbnails of one size are laid out once.
        """
        zoom = layout.zooms[panel.name]
        size = drawing.width / zoom, drawing.height / zoom
        key = panel.name, round(size[0], 9), round(size[1], 9)
        if key not in self._drawn:
            large = panel.name == layout.large
            bare = panel if large else _thumbnail(panel, drawing.width)
            room = Rect(0.0, 0.0, *size)
            self._drawn[key] = column(self.sheet, bare, room, self.form, lenses=large)
        shift = complex(drawing.left, drawing.bottom)
        return {name: each.mapped(zoom, shift) for name, each in self._drawn[key].items()}

    def _heads(self, layout: SceneLayout, sketches: Mapping[str, Sketch]) -> Iterator[Item]:
        """Yield the heads of the panels, faint until they are begun; thumbnails state no scale."""
        for panel in self.sheet.panels:
            place, sketch = layout.page.panels[panel.name], sketches[panel.name]
            begun, region = drawing(sketch.setting.first), head_of(panel.name)
            if panel.name == layout.large:
                full = head(panel, place, sketch.scale, None, self.sheet.notation)
            else:
                left, right = place.drawing.left, place.drawing.right
                title = bold(roman(panel.title))
                size = fitted(title, SMALL_TITLE, LEAST_SMALL_TITLE, right - left)
                full = [
                    line([complex(left, place.rule), complex(right, place.rule)], "hairline"),
                    Mark(Lettering(title, complex(left, place.title), size), "words"),
                ]
            yield Item("", region, Level.GROUND, tuple(pale(full)), 0, begun)
            yield Item("", region, Level.GROUND, tuple(full), begun)

    def _move(self, number: int, beat: int) -> Move:
        """Return the move from a scene to the next one."""
        if (number, beat) not in self._moves:
            before, after = (self.scene(each).shown(beat) for each in (number, number + 1))
            if number == self.count - 1:
                before += self._answered(self._layouts[number].page)
            region = LAST_MOVE if number == self.count - 1 else MOVING
            panels = [panel.name for panel in self.sheet.panels]
            area = region, self.regions[region]
            self._moves = {(number, beat): Move.between(before, after, panels, *area)}
        return self._moves[number, beat]

    @cached_property
    def _title(self) -> list[Item]:
        marks = title_marks(self.sheet, self._layouts[0].page)
        return [Item("", TITLE, Level.GROUND, tuple(marks))]

    def _captions(self, sketches: Mapping[str, Sketch]) -> list[Item]:
        """Return the captions, which are the same in all scenes."""
        if not self._told:
            page = self._layouts[0].page
            self._told = list(captions(self.sheet, page, sketches, self._answer))
        return self._told


def _fitted(items: Sequence[Item], area: Rect) -> tuple[float, complex]:
    """Return factor and shift with which all that a panel ever shows stays in its place.

    The hinge of a pair of compasses may stand farther out than what is drawn with it, and a polygon
    that turns may need more room than it has in the end.
    """
    whole = reach(items) if items else area
    ends = complex(whole.left, whole.bottom), complex(whole.right, whole.top)
    if all(area.holds(end, SLACK) for end in ends):
        return 1.0, 0j
    factor = min(1.0, area.width / whole.width, area.height / whole.height)
    low = complex(area.left, area.bottom) - factor * ends[0]
    high = complex(area.right, area.top) - factor * ends[1]
    ideal = (1.0 - factor) * area.centre
    return factor, complex(
        min(max(ideal.real, low.real), high.real), min(max(ideal.imag, low.imag), high.imag)
    )


def _shape(panel: Panel) -> complex:
    """Return the width and the height of what is drawn in a panel, as real and imaginary part."""
    return extent(point for half in panel.halves for point in corners(half))


def _thumbnail(panel: Panel, wide: float) -> Panel:
    """Return a panel as a thumbnail has room for it."""
    below, strokes = panel.below and replace(panel.below, notes=(), inset=None), panel.strokes
    if panel.picture == "views" and wide < FULL_VIEWS:
        strokes = tuple(
            replace(each, label="") if isinstance(each.shape, Arc | Curve) else each
            for each in strokes
        )
    return replace(panel, notes=(), inset=None, below=below, strokes=strokes)


def _of(number: int, region: str) -> str:
    """Return the name of a region of a scene among those of the stage."""
    return region if region in SHARED else f"{number}:{region}"


def _in_scene(items: Sequence[Item] | Iterator[Item], number: int) -> list[Item]:
    return [replace(item, region=_of(number, item.region)) for item in items]


def _shows(item: Item, beat: int) -> bool:
    return item.since <= beat < item.until
