"""The still of a turn: hodographs and curves with twelve numbered positions.

In comes a turn, out goes a board that shows its first pose, and where all points are when the
driver has gone another twelfth of its way.
"""

from __future__ import annotations

from collections.abc import Sequence

from vad.lecture.turn import Turn
from vad.plan.format import Format
from vad.plan.items import Item, Level, curve_of
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import Placed, belongs, beside, fan
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import roman
from vad.plan.marks import Mark, disc
from vad.plan.sketch import Sketch
from vad.plan.turning.hodographs import Hodographs
from vad.plan.turning.turn_board import TurnBoard
from vad.plan.turning.turn_panel import TurnPanel
from vad.strokes.diagram import Spot

POSITIONS = 12
NUMERAL = 0.024
DOT = 0.0048
GAPS = (0.006, 0.012, 0.020, 0.030)  # from a position to its number
CLEAR = 0.003  # between a number and a stroke
APART = 0.009 + 0.004j  # between numbers and letters, aside and above: "1 2" is not "12"
DIRECTIONS, ON_ONE_SIDE = 16, 5  # tried about a position; of a straight way
_STEP = 1e-3  # of the cycle: so far on, a way shows its direction
_AT_REST = 1e-5  # on the page, in that time

#: A point, the number of a position and its place.
Numbered = tuple[Spot, int, complex]


class NumberedTurn(TurnBoard):
    """A turn that stands still; position 1 is where the driver passes 0°."""

    tick_rows = 2

    def __init__(self, turn: Turn, form: Format | None = None) -> None:
        super().__init__(turn, form)
        shares = [number / POSITIONS for number in range(POSITIONS)]
        items = [*self.unmoved]
        for panel in turn.sheet.panels:
            halves = [(self.panels[half.name], half) for half in panel.halves]
            pairs = [(moving.pose(half, 0.0), moving) for moving, half in halves]
            _number(pairs, shares)
            items += [item for sketch, _ in pairs for item in sketch.items]
            if panel.picture != "vectors" and self.clock:
                items.append(self.item(panel.name, self.clock.marks()))
        ticks = [(share, f"{number}") for number, share in enumerate([*shares, 1.0], 1)]
        ticks[-1] = (1.0, "1")
        for name, chart in self.charts.items():
            marks = [*chart.numbered([*shares, 1.0]), *chart.heading(), *chart.scale(ticks)]
            items.append(self.item(curve_of(name), marks))
        self._shown = self.sorted(items)

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
    """Add the positions, and return the point of each, its number and its place.

    A point that is seen twice is numbered in its first view.
    """
    ways, room, obstacles = moving.hodographs, sketch.setting.room, sketch.obstacles
    spots = [
        (point, number, ways.at(point, share))
        for point in sorted(
            (each for each in ways.drawn if not each.view), key=lambda each: each in ways.straight
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
