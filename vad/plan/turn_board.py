"""The board of a turn: everything is chosen once, for all of its poses.

`TurnBoard` is a board like that of a sheet, on which a beat is a frame.  `NumberedTurn` stands
still, with twelve numbered positions on its hodographs and curves.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from vad.kinematics.linkage import points_of
from vad.lecture.moment import Moment
from vad.lecture.turn import Turn
from vad.plan.board import rows_of
from vad.plan.chart import HEIGHT as LINE
from vad.plan.chart import Chart, Clock, dial, ticks_of, time_of, work_lines
from vad.plan.format import Format, screen
from vad.plan.geometry import Rect
from vad.plan.hodographs import Hodographs
from vad.plan.items import TITLE, Item, Level, curve_of, head_of, in_painting_order
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import Placed, belongs, beside, fan
from vad.plan.labels.springs import POSES
from vad.plan.labels.vertices import text_at
from vad.plan.layout import beside as beside_mechanism
from vad.plan.layout import rooms
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import roman
from vad.plan.marks import Lettering, Mark, disc, lines
from vad.plan.page.heads import TITLE as TITLE_SIZE
from vad.plan.page.heads import head, title_marks
from vad.plan.pictures import over_turn
from vad.plan.sketch import Setting, Sketch
from vad.plan.turn_layout import lay_out_turn
from vad.plan.turn_lens import FADE
from vad.plan.turn_panel import TurnPanel
from vad.strokes.diagram import ACCELERATION, VELOCITY, Spot
from vad.strokes.notation import Notation, typed_unit
from vad.strokes.sheet import Panel, Sheet

POSITIONS = 12
NUMERAL = 0.024
DOT = 0.0048
GAPS = (0.006, 0.012, 0.020, 0.030)  # from a position to its number
CLEAR = 0.003  # between a number and a stroke
APART = 0.009 + 0.004j  # between numbers and letters, aside and above: "1 2" is not "12"
DIRECTIONS, ON_ONE_SIDE = 16, 5  # tried about a position; of a straight way
_STEP = 1e-3  # of the cycle: a path has the direction to the point at this share later
_AT_REST = 1e-5  # on the page, in that time

#: A point, the number of a position and its place.
Numbered = tuple[Spot, int, complex]


class TurnBoard:
    """A turn laid out on a page; ``form`` is that of its size unless another is given."""

    #: Rows of words below each curve.
    tick_rows = 1
    #: Whether lenses show small vectors while they are small.
    lenses = True

    def __init__(self, turn: Turn, form: Format | None = None) -> None:
        self.turn = turn
        self.form: Format = form or screen(turn.size)
        self.cycle = turn.cycle
        self._poses = {number / POSES: turn.at(number / POSES) for number in range(POSES)}
        poses = list(self._poses.values())
        # Nobody could follow units that change from pose to pose.
        metres = any(pose.notation.metres for pose in poses)
        notation = Notation(poses[0].notation.point, metres)
        sheet = replace(poses[0], notation=notation)
        if turn.course.swing:  # then it has no one rate
            sheet = replace(sheet, driver=replace(sheet.driver, rate=0.0))
        else:
            sheet = replace(sheet, parameters=(*_given_rates(sheet), *sheet.parameters))
        self.sheet = sheet
        names = [panel.name for panel in sheet.panels]
        layout = lay_out_turn(self.form, names)
        self.page = layout.page
        self.regions: Mapping[str, Rect] = layout.regions
        self.panels: dict[str, TurnPanel] = {}
        self.clock: Clock | None = None
        rows = rows_of(sheet)
        for panel in sheet.panels:
            drawing = self.page.panels[panel.name].drawing
            if panel is sheet.panels[0] and panel.picture != "vectors":
                self.clock = Clock(self.cycle, turn.course, sheet, drawing)
                top = drawing.top - self.clock.height
                drawing = Rect(drawing.left, drawing.bottom, drawing.right, top)
            elif panel.name == "drive" and self.cycle.work:
                top = drawing.top - 2 * LINE
                drawing = Rect(drawing.left, drawing.bottom, drawing.right, top)
            for setting in self._settings(panel, drawing, poses, rows):
                half = setting.panel
                same = [pose.panel(half.name) for pose in poses]
                motion = self.cycle, turn.opening, FADE / turn.duration
                self.panels[half.name] = TurnPanel(setting, same, *motion)
        self.charts = self._charts(sheet, layout.charts)
        self.ticks = ticks_of(turn.course, self.cycle, notation)
        marks = self._still(sheet)
        self.unmoved = [Item("", name, Level.GROUND, tuple(each)) for name, each in marks if each]
        for moving in self.panels.values():
            self.unmoved += moving.still()

    def _settings(
        self, panel: Panel, drawing: Rect, poses: Sequence[Sheet], rows: Mapping[str, int]
    ) -> list[Setting]:
        """Return the halves of a panel in their rooms.

        Two polygons stand one above the other or side by side, as they are larger over the turn.
        """
        aside, centimetre = beside_mechanism(panel, drawing), self.form.centimetre
        bare = Setting(
            self.sheet, panel, drawing, rows, (), centimetre, beside=aside, lenses=self.lenses
        )

        def placed(across: bool) -> list[Setting]:
            halves = rooms(panel, drawing, across=across)
            return [replace(bare, panel=half, room=room) for half, room in halves]

        def size(settings: Sequence[Setting]) -> float:
            same = ((each, [pose.panel(each.panel.name) for pose in poses]) for each in settings)
            return math.prod(over_turn(each, halves).scale.factor for each, halves in same)

        if panel.below is None:
            return placed(False)
        return max(placed(False), placed(True), key=size)

    def at(self, moment: Moment) -> list[Item]:
        """Return the items of a moment, in painting order; its beat is a frame."""
        return self.shown(moment.beat)

    def shown(self, beat: int) -> list[Item]:
        """Return the items of one frame, in painting order."""
        phase, share = beat / self.turn.frames, self.turn.share(beat)
        sheet = self._poses.get(phase) or self.turn.at(phase)
        items = [*self.unmoved]
        for panel in sheet.halves:
            items += self.panels[panel.name].items(panel, phase)
            if panel.name == self.sheet.panels[0].name and self.clock:
                items.append(self.item(panel.name, self.clock.marks(share)))
        for name, chart in self.charts.items():
            items.append(self.item(curve_of(name), [*chart.moving(share), *chart.words(share)]))
        return in_painting_order(items, self.regions)

    def item(self, region: str, marks: list[Mark]) -> Item:
        """Return marks that stand above all else in a region."""
        return Item("", region, Level.LABEL, tuple(marks))

    def _charts(self, sheet: Sheet, places: Mapping[str, Rect]) -> dict[str, Chart]:
        charts: dict[str, Chart] = {}
        cycle = self.cycle
        driver = time_of(sheet, cycle)
        for name, curve in cycle.curves.items():
            output = dial(sheet, curve)
            first = not charts
            charts[name] = Chart(cycle, output, driver, places[name], first, self.tick_rows)
        size = min((chart.size for chart in charts.values()), default=0.0)
        for chart in charts.values():
            chart.size = size  # that of the one with the least room
        return charts

    def _still(self, sheet: Sheet) -> Iterator[tuple[str, list[Mark]]]:
        """Yield what never changes: title, heads, and the curves with their ticks."""
        yield TITLE, title_marks(sheet, self.page)
        texts = (mark.shape for panel in sheet.panels for mark in self._head(panel)[1:2])
        size = min(text.size for text in texts if isinstance(text, Lettering))
        for panel in sheet.panels:
            moving, place = self.panels[panel.name], self.page.panels[panel.name]
            yield head_of(panel.name), self._head(panel, size)
            if panel.name == "position":
                yield panel.name, self._return_way(moving)
            elif panel.name == "drive":
                yield panel.name, work_lines(self.cycle, sheet, place.drawing)
        for name, chart in self.charts.items():
            ticks = chart.scale(self.ticks, self.tick_rows - 1)
            yield curve_of(name), [*chart.still(), *ticks]

    def _head(self, panel: Panel, most: float = TITLE_SIZE) -> list[Mark]:
        place, scale = self.page.panels[panel.name], self.panels[panel.name].scale
        return head(panel, place, scale, self.form.centimetre, self.sheet.notation, most)

    def _return_way(self, moving: TurnPanel) -> list[Mark]:
        """Return the part of the crank pin's way in which the output returns."""
        cycle, links = self.cycle, self.turn.mechanism.links
        ends = links.get(cycle.driver, "")
        if cycle.back is None or len(ends) < 2:
            return []
        pin = Spot(points_of(ends)[1])
        if pin not in moving.ways:
            return []
        return [lines([moving.hodographs.stretch(pin, *cycle.back).tolist()], "return way")]


def _given_rates(sheet: Sheet) -> list[tuple[str, float, str]]:
    """Return the given ω, and α if there is one, as parameters: all curves depend on them.

    They are the same in every pose, and stand there as they were typed.
    """
    rows = [row for row in sheet.rows if row.key == sheet.driver.row]
    cells = [cell for row in rows for cell in row.cells.get(VELOCITY.panel, ())]
    more = [cell for row in rows for cell in row.cells.get(ACCELERATION.panel, ()) if cell.value]
    found = []
    for cell in (each for each in (*cells, *more) if each.given):
        factor, unit = typed_unit(cell.value, cell.unit)
        found.append((cell.symbol, factor * cell.value, unit))
    return found


class NumberedTurn(TurnBoard):
    """A turn that stands still; position 1 is where the driver passes 0°."""

    tick_rows = 2
    lenses = False

    def __init__(self, turn: Turn, form: Format | None = None) -> None:
        super().__init__(turn, form)
        shares = [number / POSITIONS for number in range(POSITIONS)]
        items = [*self.unmoved]
        for panel in turn.sheet.panels:
            halves = [(self.panels[half.name], half) for half in panel.halves]
            pairs = [(moving.pose(half, 0.0), moving) for moving, half in halves]
            _number(pairs, shares)
            items += [item for sketch, _ in pairs for item in sketch.items]
            if panel.name == self.sheet.panels[0].name and self.clock:
                items.append(self.item(panel.name, self.clock.marks()))
        ticks = [(share, f"{number}") for number, share in enumerate([*shares, 1.0], 1)]
        ticks[-1] = (1.0, "1")
        for name, chart in self.charts.items():
            marks = [*chart.numbered([*shares, 1.0]), *chart.heading(), *chart.scale(ticks)]
            items.append(self.item(curve_of(name), marks))
        self._shown = in_painting_order(items, self.regions)

    def shown(self, beat: int) -> list[Item]:
        """Return all items: nothing moves."""
        return self._shown


def _number(column: Sequence[tuple[Sketch, TurnPanel]], shares: Sequence[float]) -> None:
    """Add the positions of all points that move, each with its number where there is room.

    Of two polygons in a column, each keeps clear of the other.
    """
    first = column[0][0].obstacles
    for sketch, _ in column[1:]:
        first.lines += sketch.obstacles.lines
        first.boxes += sketch.obstacles.boxes
        sketch.obstacles = Obstacles(sketch.obstacles.edge, first.lines, first.boxes)
    dotted = [_add_dots(sketch, moving, shares) for sketch, moving in column]
    for (sketch, moving), spots in zip(column, dotted, strict=True):
        _add_numerals(sketch, moving.hodographs, shares, spots)


def _add_dots(sketch: Sketch, moving: TurnPanel, shares: Sequence[float]) -> list[Numbered]:
    """Add the positions, and return the point of each, its number and its place."""
    ways, room, obstacles = moving.hodographs, sketch.setting.room, sketch.obstacles
    spots = [
        (point, number, ways.at(point, share))
        for point in sorted(
            (each for each in ways.drawn if _is_numbered(each)),
            key=lambda each: each in ways.straight,
        )
        for number, share in enumerate(shares, 1)
    ]
    spots = [spot for spot in spots if room.holds(spot[2])]
    for mark in ways.still(moving.ways):
        for piece in mark.shape.pieces:  # type: ignore[union-attr]
            obstacles.line(piece, 0.0)
    for _, _, at in spots:
        obstacles.disc(at, DOT)
    dots = [disc(at, DOT, "position", ways.row(point)) for point, _, at in spots]
    sketch.add(None, Level.GLOW, 0, dots)
    return spots


def _is_numbered(point: Spot) -> bool:
    """Tell whether the positions of a point are numbered; one in two views is so in the first."""
    return point.path != "bare" and not point.view and (point.lettered or bool(point.row))


def _add_numerals(
    sketch: Sketch, ways: Hodographs, shares: Sequence[float], spots: Sequence[Numbered]
) -> None:
    obstacles, numerals = sketch.obstacles, list[Mark]()
    for point, number, at in spots:
        runs = roman(str(number))
        box = ink_size(runs, NUMERAL)
        aside = _aside(ways, point, shares[number - 1])
        fanned = fan(aside, DIRECTIONS)[: ON_ONE_SIDE if point in ways.straight else DIRECTIONS]
        others = [z for name, _, z in spots if name == point and abs(z - at) > PIXEL]
        centres = [
            centre
            for gap in GAPS
            for centre in (beside(at, way, DOT + gap, *box) for way in fanned)
            if belongs(Placed(centre, *box).box, at, others)
        ]
        free = obstacles.free(centres, *box, CLEAR, APART)
        if free.any():
            centre = centres[int(free.argmax())]
            obstacles.box(Placed(centre, *box).box)
            numerals.append(text_at(runs, runs, centre, NUMERAL, "numeral", ways.row(point)))
    sketch.add(None, Level.LABEL, 0, numerals)


def _aside(ways: Hodographs, point: Spot, share: float) -> complex:
    """Return the direction from a position to its number: out of a loop.

    Of a straight way it is the side to the left of the motion, so that numbers there and back
    stand on either side; where the motion turns back it is beyond the end.
    """
    ahead = ways.at(point, share + _STEP) - ways.at(point, share - _STEP)
    away = ways.at(point, share) - complex(ways.tracks[point].mean())
    across = 1j * ahead if abs(ahead) > _AT_REST else away
    across = across / abs(across) if across else 1j
    inward = point not in ways.straight and (away * across.conjugate()).real < 0
    return -across if inward else across
