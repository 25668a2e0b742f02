"""Panels in motion: one panel of a turn, with what stands still, and any pose of the rest.

The scale, the supports and the motions of the labels are chosen once for all poses.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import numpy as np

from vad.lecture.cycle import Cycle, Reals
from vad.plan.chart import BASELINE, HEIGHT, LEAST, SIZE
from vad.plan.hodographs import Complexes, Hodographs, within
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.springs import Ballast, Crowd
from vad.plan.lettering.glyphs import fitted
from vad.plan.lettering.runs import roman
from vad.plan.marks import Lettering, Mark, line, lines
from vad.plan.pictures import over_turn
from vad.plan.pictures.machine import TICK, TICK_PITCH
from vad.plan.pictures.polygon import Polygon, principal
from vad.plan.sketch import Setting, Sketch
from vad.plan.turn_labels import TurnLabels, grouped
from vad.plan.turn_lens import TurnLens, find_lens, with_lens
from vad.plan.turn_sense import add_standing_sense
from vad.strokes.diagram import ACCELERATION, VELOCITY, Spot
from vad.strokes.sheet import Arrow, Block, Dot, Panel
from vad.words import Language

#: The share of ink of links that have nothing to do with the point that is followed.
FAINT = 0.38
#: So many hodographs can be told apart.
MOST_WAYS = 4
#: So far the ground reaches beyond the path of a foot, and lies below it.
GROUND, GROUND_BELOW = 0.05, 0.010


class TurnPanel:
    """One panel of a turn; ``poses`` are evenly spaced over it, from the one that is given.

    ``fade`` is the share of the turn in which a lens comes.
    """

    def __init__(
        self,
        setting: Setting,
        poses: Sequence[Panel],
        cycle: Cycle,
        opening: float,
        fade: float = 0.0,
    ) -> None:
        picture = over_turn(setting, poses)
        if isinstance(picture, Polygon) and any(map(picture.breaks, poses)):
            below = replace(setting.room, top=setting.room.top - HEIGHT)
            setting = replace(setting, room=below)
            picture = over_turn(setting, poses)
        self._setting, self._opening, self.picture = setting, opening, picture
        self.room = setting.room
        tracks = cycle.tracks.get(setting.panel.name, {})  # of a balanced polygon none
        if setting.panel.name in (VELOCITY.panel, ACCELERATION.panel):
            tracks = {**tracks, **_corners(poses, tracks, cycle.shares + opening)}
        fixed = {spot.letter for spot, way in tracks.items() if not spot.view and np.ptp(way) == 0}
        rows = {
            spot: setting.row(spot.row or owner_of(spot.letter, fixed, poses)) for spot in tracks
        }
        self.hodographs = Hodographs(tracks, rows, self.picture.scale, setting.room)
        found = None
        if isinstance(self.picture, Polygon) and setting.lenses:
            found = find_lens(self.picture, self.hodographs, opening, fade)
            if found and found.shift:
                self.picture = self.picture.moved(found.shift)
                self.hodographs = Hodographs(tracks, rows, self.picture.scale, setting.room)
        self.scale = self.picture.scale
        drawn, straight = self.hodographs.drawn, self.hodographs.straight
        is_place = setting.panel.picture != "vectors"
        #: The letters whose path is drawn.  In a mechanism the path of a block is not drawn: it is
        #: its guide.
        self.ways = [
            each
            for each in drawn
            if each.path in ("drawn", "bare") and not (is_place and each in straight)
        ]
        self._whole = self._followable(cycle, is_place, poses[0])
        self._stance = self._stands(cycle, is_place)
        self._faint = _unconcerned(setting, cycle) if is_place else frozenset()
        groups = grouped(self.hodographs, self.ways)
        sketches = [self.picture.pose(pose) for pose in poses]
        ground = (mark for mark in self._stance if mark.role == "hatching")
        for piece in (piece for mark in ground for piece in mark.shape.pieces):  # type: ignore[union-attr]
            for sketch in (self.picture.still, *sketches):
                sketch.obstacles.line(piece, 0.0)
        add_standing_sense(self.picture.still, poses, sketches, self._lines())
        self.lens: TurnLens | None = None
        if found and isinstance(self.picture, Polygon):
            self.lens = with_lens(self.picture, found, self.hodographs, poses, groups, opening)
        self.labels = TurnLabels(setting, self.scale, self.hodographs, opening, self._inside)
        self.labels.place(groups, poses, self._crowd(sketches))

    def still(self) -> list[Item]:
        """Return the items that are the same in all poses."""
        ways = [*self.hodographs.still(self._whole), *self._stance]
        region = self._setting.panel.column
        found = [Item("", region, Level.GROUND, tuple(ways))] if ways else []
        return [*found, *self.picture.still.items]

    def items(self, panel: Panel, phase: float) -> list[Item]:
        """Return the items of one pose at a phase from the one that is given."""
        sketch = self.pose(panel, phase)
        sketch.add(None, Level.GLOW, 0, self.hodographs.tails(self.ways, phase - self._opening))
        return [*sketch.items, *(self.lens.items(panel, phase) if self.lens else ())]

    def pose(self, panel: Panel, phase: float) -> Sketch:
        """Return one pose with its labels."""
        sketch = self.picture.pose(panel)
        sketch.items[:] = [self._inked(item) for item in sketch.items]
        self.labels.add(sketch, panel, phase)
        if isinstance(self.picture, Polygon) and self.picture.breaks(panel):
            sketch.add(None, Level.LABEL, 0, [self._note()])
        return sketch

    def _inked(self, item: Item) -> Item:
        """Return an item of a pose, pale if the point that is followed does not move with it."""
        if item.stroke not in self._faint or item.level == Level.DOT:
            return item
        return replace(item, marks=tuple(replace(m, alpha=FAINT * m.alpha) for m in item.marks))

    def _followable(self, cycle: Cycle, is_place: bool, pose: Panel) -> list[Spot]:
        """Return the letters whose whole path is drawn; of the others a film has the last part.

        Of many hodographs those of the driver and the output are drawn: nobody could follow more.
        """
        if is_place or not self._setting.lenses or len(self.ways) <= MOST_WAYS:
            return self.ways
        kept, shown = {cycle.driver, cycle.output}, (*pose.strokes, *pose.zeros)
        heads = {s.shape.head for s in shown if isinstance(s.shape, Arrow) and s.link in kept}
        return [spot for spot in self.ways if spot.letter in heads]

    def _stands(self, cycle: Cycle, is_place: bool) -> list[Mark]:
        """Return the part of a path in which a foot stands, and the ground below it."""
        marks: list[Mark] = []
        if cycle.stance is None:
            return marks
        for spot in self.ways:
            stands = self.hodographs.stretch(spot, 0.0, cycle.stance.part).tolist()
            marks.append(lines(within(self.room, stands), "return way"))
            if is_place:
                marks += _ground(self.hodographs.tracks[spot])
        return marks

    def _inside(self, at: complex, phase: float) -> float:
        """Return how far inside the panel a place is; what a lens shows has its letters there."""
        room = self.room
        if self.lens and self.lens.has(at, phase):
            return -1.0
        beside = min(at.real - room.left, room.right - at.real)
        return min(beside, at.imag - room.bottom, room.top - at.imag)

    def _note(self) -> Mark:
        """Return what is said in a line above the room while a vector of a pose is broken."""
        room = self.room
        runs = roman(Language(self._setting.sheet.language).say("broken vectors"))
        size = fitted(runs, SIZE, LEAST, room.width)
        return Mark(
            Lettering(runs, complex(room.left, room.top + HEIGHT - BASELINE), size), "notes"
        )

    def _lines(self) -> Obstacles:
        """Return the paths that are drawn, as strokes."""
        ways = Obstacles(self.room)
        for mark in [*self.hodographs.still(self._whole), *self._stance]:
            for piece in mark.shape.pieces:  # type: ignore[union-attr]
                ways.line(piece, 0.0)
        return ways

    def _crowd(self, sketches: Sequence[Sketch]) -> Ballast:
        """Return what labels keep clear of in all poses."""
        obstacles = [sketch.obstacles for sketch in sketches]
        if self.lens:
            for number, each in enumerate(obstacles):
                self.lens.block(each, number / len(obstacles))
        crowd = Crowd(self.room, obstacles)
        ways, texts = self._lines(), [tag.box for tag in self.picture.still.tags]
        return Ballast(self.room, crowd, Crowd(self.room, [ways]), self.picture.radius, texts=texts)


def _ground(way: Complexes) -> list[Mark]:
    """Return the hatched ground on which a foot walks."""
    left, right = float(way.real.min()) - GROUND, float(way.real.max()) + GROUND
    level = float(way.imag.min()) - GROUND_BELOW
    tick, pitch = TICK * cmath.exp(-0.75j * math.pi), TICK_PITCH
    feet = [complex(right - number * pitch, level) for number in range(int((right - left) / pitch))]
    rail = line((complex(left, level), complex(right, level)), "rail")
    return [rail, lines([(foot, foot + tick) for foot in feet], "hatching")]


def _corners(
    poses: Sequence[Panel], tracks: Mapping[Spot, Complexes], phases: Reals
) -> dict[Spot, Complexes]:
    """Return where those ends of vectors are that are the image of no point, as s, sₙ and z.

    Where a vector has no length they are between their places before and after.
    """
    found: dict[str, dict[float, complex]] = {}
    for number, pose in enumerate(poses):
        for stroke in principal(pose).strokes:
            if isinstance(stroke.shape, Arrow):
                ends = (
                    (stroke.shape.tail, stroke.shape.start),
                    (stroke.shape.head, stroke.shape.end),
                )
                for letter, at in ends:
                    found.setdefault(letter, {})[number / len(poses)] = at
    known = {"", *(spot.letter for spot in tracks)}
    return {
        Spot(letter, path="none"): np.interp(phases, [*places], [*places.values()], period=1.0)
        for letter, places in found.items()
        if letter not in known and tracks
    }


def _unconcerned(setting: Setting, cycle: Cycle) -> frozenset[str]:
    """Return the full names of the strokes of links that neither drive nor have the output point.

    Where no point is followed there are none.
    """
    if cycle.followed is None:
        return frozenset()
    kept, panel = {cycle.driver, cycle.followed.row, None}, setting.panel
    return frozenset(panel.full(each.name) for each in panel.strokes if each.link not in kept)


def owner_of(letter: str, fixed: Collection[str], poses: Sequence[Panel]) -> str | None:
    """Return the link or slide whose colour a point's path has: its vector ends there."""
    strokes = [stroke for pose in poses[:2] for stroke in (*pose.strokes, *pose.zeros)]
    blocks = [s for s in strokes if isinstance(s.shape, Block) and s.label == letter]
    arrows = [s for s in strokes if isinstance(s.shape, Arrow) and s.shape.head == letter]
    direct = [s for s in arrows if isinstance(s.shape, Arrow) and s.shape.tail in fixed]
    dots = [s for s in strokes if isinstance(s.shape, Dot) and s.label == letter]
    return next((stroke.link for stroke in (*direct, *blocks, *arrows, *dots)), None)
