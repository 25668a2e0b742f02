"""Panels in motion: one panel of a turn, with what stands still, and any pose of the rest.

The scale, the supports and the motions of the labels are chosen once for all poses.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from vad.lecture.cycle import Cycle
from vad.plan.anchors import Anchor, Solved
from vad.plan.hodographs import Complexes, Hodographs, within
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.placing import Placed
from vad.plan.labels.springs import Ballast, Boxes, Crowd, Spring, find_spring
from vad.plan.labels.vertices import LETTER, SMALL_SIZE, lettered, text_beside
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.marks import Mark, line, lines
from vad.plan.pictures import over_turn
from vad.plan.pictures.machine import TICK, TICK_PITCH
from vad.plan.pictures.polygon import CORIOLIS, name_of, principal
from vad.plan.sketch import Setting, Sketch
from vad.strokes.diagram import Spot
from vad.strokes.sheet import Arrow, Block, Dot, Panel, Stroke

FADING = 0.025  # so far from the edge a label goes, and where a vector is twice as short
#: A label shows in full from this share of its ink on, and else not at all.
SHOWN = 0.5
#: A label that stands farther from its dot is led to it by a line; from there on the line appears.
FAR, LEADER_APPEARS, LEADER_GAP = 20.0 * PIXEL, 4.0 * PIXEL, 5.0 * PIXEL

#: The share of ink of links that have nothing to do with the point that is followed.
FAINT = 0.38
#: So far the ground reaches beyond the path of a foot, and lies below it.
GROUND, GROUND_BELOW = 0.05, 0.010

#: The components of vectors that have a name of their own.
NAMED = ("coriolis", "force", "load", "couple", "action")


@dataclass(frozen=True, slots=True)
class Name:
    """A label in motion: the letters at a dot, or the name of a vector.

    Attributes
    ----------
    text
        What is written.
    letters
        The points at the dot, none of a vector.
    vector
        The name of the vector's stroke, empty for a dot.
    row
        The row of the vector; None for a dot.
    spring
        Where it stands.
    anchor
        On what it hangs.
    """

    text: str
    letters: tuple[Spot, ...]
    vector: str
    row: int | None
    spring: Spring
    anchor: Anchor

    @property
    def size(self) -> float:
        """The size of its type."""
        return SMALL_SIZE if self.vector else LETTER


class TurnPanel:
    """One panel of a turn; ``poses`` are evenly spaced over it, from the one that is given."""

    def __init__(self, setting: Setting, poses: Sequence[Panel], cycle: Cycle, opening: float):
        self._setting, self._opening = setting, opening
        self.room = setting.room
        tracks = cycle.tracks.get(setting.panel.name, {})  # of a balanced polygon none
        self.picture = over_turn(setting, poses)
        self.scale = scale = self.picture.scale
        fixed = {spot.letter for spot, way in tracks.items() if not spot.view and np.ptp(way) == 0}
        rows = {
            spot: setting.row(spot.row or owner_of(spot.letter, fixed, poses)) for spot in tracks
        }
        self.hodographs = Hodographs(tracks, rows, scale, setting.room)
        drawn, straight = self.hodographs.drawn, self.hodographs.straight
        is_place = setting.panel.picture != "vectors"
        #: The letters whose path is drawn.  In a mechanism the path of a block is not drawn: it is
        #: its guide.
        self.ways = [
            each
            for each in drawn
            if each.path in ("drawn", "bare") and not (is_place and each in straight)
        ]
        self._stance = self._stands(cycle, is_place)
        self._faint = _unconcerned(setting, cycle) if is_place else frozenset()
        self.names = self._place(poses)

    def still(self) -> list[Item]:
        """Return the items that are the same in all poses."""
        ways = [*self.hodographs.still(self.ways), *self._stance]
        region = self._setting.panel.column
        found = [Item("", region, Level.GROUND, tuple(ways))] if ways else []
        return [*found, *self.picture.still.items]

    def items(self, panel: Panel, phase: float) -> list[Item]:
        """Return the items of one pose at a phase from the one that is given."""
        sketch = self.pose(panel, phase)
        sketch.add(None, Level.GLOW, 0, self.hodographs.tails(self.ways, phase - self._opening))
        return sketch.items

    def pose(self, panel: Panel, phase: float) -> Sketch:
        """Return one pose with its labels."""
        sketch = self.picture.pose(panel)
        sketch.items[:] = [self._inked(item) for item in sketch.items]
        solved = Solved(panel, self.scale)
        for name, placed in self.labels(panel, phase):
            runs, role = symbols(name.text), "letter" if name.row is None else "tag"
            far = bool(name.letters) and self._is_far(name.letters[0], panel)
            arrow = name.letters[0].arrow if far else ""
            anchor = Anchor(((arrow, "start"), (arrow, "end"))) if arrow else name.anchor
            hung = anchor, solved.place(anchor)
            text = text_beside(*hung, runs, placed.centre, name.size, role, name.row)
            sketch.add(
                None,
                Level.LABEL,
                0,
                [*self._leader(name, self.dot(name, panel, phase), placed), text],
            )
            sketch.obstacles.box(placed.box)
        return sketch

    def _inked(self, item: Item) -> Item:
        """Return an item of a pose, pale if the point that is followed does not move with it."""
        if item.stroke not in self._faint or item.level == Level.DOT:
            return item
        return replace(item, marks=tuple(replace(m, alpha=FAINT * m.alpha) for m in item.marks))

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

    def _leader(self, name: Name, dot: complex, placed: Placed) -> list[Mark]:
        """Return the line from a label to its dot, if it stands far from it."""
        if name.vector:
            return []
        away = dot - placed.centre
        aside, above = abs(away.real) - placed.wide / 2, abs(away.imag) - placed.high / 2
        gap = math.hypot(max(aside, 0.0), max(above, 0.0)) - self.picture.radius
        ink = min(max((gap - FAR) / LEADER_APPEARS + 1.0, 0.0), 1.0)
        if not ink:
            return []
        edge = placed.centre + complex(
            min(max(away.real, -placed.wide / 2), placed.wide / 2),
            min(max(away.imag, -placed.high / 2), placed.high / 2),
        )
        way = (dot - edge) / abs(dot - edge)
        ends = edge + LEADER_GAP * way, dot - (self.picture.radius + LEADER_GAP / 2) * way
        return [replace(line(ends, "leader"), alpha=ink)]

    def labels(self, panel: Panel, phase: float) -> list[tuple[Name, Placed]]:
        """Return the labels that show at a phase, and where they stand."""
        found = []
        for name in self.names:
            dot, alpha = self._spot(name.letters, name.vector, panel, phase)
            offset = name.spring.at(phase)
            if offset is not None and alpha >= SHOWN:
                size = ink_size(symbols(name.text), name.size)
                found.append((name, Placed(dot + offset, *size)))
        return found

    def dot(self, name: Name, panel: Panel, phase: float) -> complex:
        """Return what a label stands beside: its dot, or the middle of its vector."""
        return self._spot(name.letters, name.vector, panel, phase)[0]

    @staticmethod
    def _is_far(spot: Spot, panel: Panel) -> bool:
        """Tell whether a point is too far away to be drawn in a pose: a centre may be."""
        return spot.path in ("numbered", "none") and spot.letter not in lettered(panel)

    def _anchor(self, letters: tuple[Spot, ...], dot: complex, solved: Solved) -> Anchor:
        """Return the anchor of letters; a point in two views has it in the view that it names."""
        found = [Anchor((point,)) for point in lettered(solved.panel)[letters[0].letter]]
        return min(found, key=lambda anchor: abs(solved.place(anchor) - dot))

    def _spot(
        self, letters: tuple[Spot, ...], vector: str, panel: Panel, phase: float
    ) -> tuple[complex, float]:
        """Return the dot of a label, or the middle of its vector, and the label's share of ink."""
        alpha, room = 1.0, self._setting.room
        if vector:
            stroke = _vectors(panel).get(vector)
            if stroke is None:
                return complex("nan"), 0.0
            shape: Any = stroke.shape
            start, end = self.scale(shape.start), self.scale(shape.end)
            at = (start + end) / 2
            alpha = min(max(abs(end - start) / FADING - 1.0, 0.0), 1.0)
        elif self._is_far(letters[0], panel):
            arrow = _arrow(letters[0], panel)
            if arrow is None:
                return complex("nan"), 0.0
            at = (self.scale(arrow.start) + self.scale(arrow.end)) / 2
        else:
            at = self.hodographs.at(letters[0], phase - self._opening)
        near = min(at.real - room.left, room.right - at.real, at.imag - room.bottom)
        near = min(near, room.top - at.imag)
        return (at, min(alpha, max(near, 0.0) / FADING)) if near > 0.0 else (at, 0.0)

    def _place(self, poses: Sequence[Panel]) -> list[Name]:
        phases = [number / len(poses) for number in range(len(poses))]
        room = self._setting.room
        sketches = [self.picture.pose(pose) for pose in poses]
        ways = Obstacles(room)
        for mark in [*self.hodographs.still(self.ways), *self._stance]:
            for piece in mark.shape.pieces:  # type: ignore[union-attr]
                ways.line(piece, 0.0)
        strokes = Crowd(room, [sketch.obstacles for sketch in sketches])
        among = Ballast(room, strokes, Crowd(room, [ways]), self.picture.radius)
        wanted: list[tuple[str, tuple[Spot, ...], str, int | None]] = [
            (", ".join(spot.letter for spot in group), group, "", None) for group in self._groups()
        ]
        wanted += [
            (name_of(stroke), (), stroke.name, self._setting.row(stroke.link))
            for stroke in _named(poses)
        ]
        dots = []
        for _, letters, vector, _ in wanted:
            places = [
                self._spot(letters, vector, *each) for each in zip(poses, phases, strict=True)
            ]
            dots.append(np.array([at if alpha > 0.0 else np.nan for at, alpha in places]))
        placed: Boxes = []
        names = []
        for (text, letters, vector, row), own in zip(wanted, dots, strict=True):
            # A vector's name belongs to no dot.
            others = zip(wanted, dots, strict=True)
            rivals = (
                [] if vector else [at for (_, _, v, _), at in others if not v and at is not own]
            )
            size = ink_size(symbols(text), SMALL_SIZE if vector else LETTER)
            spring = find_spring(own, size, rivals, among, placed)
            anchor = Anchor(((vector, "start"), (vector, "end")))
            if not vector:
                seen = [not self._is_far(letters[0], pose) for pose in poses]
                first = int((np.isfinite(own) & seen).argmax())
                anchor = self._anchor(
                    letters, complex(own[first]), Solved(poses[first], self.scale)
                )
            names.append(Name(text, letters, vector, row, spring, anchor))
        return names

    def _groups(self) -> list[tuple[Spot, ...]]:
        """Return the letters in groups that share a dot in all poses, the calmest group first."""
        tracks = self.hodographs.tracks
        found: list[list[Spot]] = []
        for letter, way in tracks.items():
            if not letter.lettered:
                continue
            same = [group for group in found if _apart(tracks[group[0]], way) < PIXEL]
            if not same:
                found.append([letter])
            elif letter.row or not np.ptp(way):  # the lever's point under a pin needs no letter
                same[0].append(letter)
        return [tuple(group) for group in sorted(found, key=lambda g: g[0] in self.ways)]


def _ground(way: Complexes) -> list[Mark]:
    """Return the hatched ground on which a foot walks."""
    left, right = float(way.real.min()) - GROUND, float(way.real.max()) + GROUND
    level = float(way.imag.min()) - GROUND_BELOW
    tick, pitch = TICK * cmath.exp(-0.75j * math.pi), TICK_PITCH
    feet = [complex(right - number * pitch, level) for number in range(int((right - left) / pitch))]
    rail = line((complex(left, level), complex(right, level)), "rail")
    return [rail, lines([(foot, foot + tick) for foot in feet], "hatching")]


def _unconcerned(setting: Setting, cycle: Cycle) -> frozenset[str]:
    """Return the full names of the strokes of links that neither drive nor have the output point.

    Where no point is followed there are none.
    """
    if cycle.followed is None:
        return frozenset()
    kept, panel = {cycle.driver, cycle.followed.row, None}, setting.panel
    return frozenset(panel.full(each.name) for each in panel.strokes if each.link not in kept)


def _arrow(spot: Spot, panel: Panel) -> Arrow | None:
    """Return the arrow that leads to a point in a pose, if there is one."""
    shapes = (stroke.shape for stroke in panel.strokes if stroke.name == spot.arrow)
    return next((shape for shape in shapes if isinstance(shape, Arrow)), None)


def _all(panel: Panel) -> tuple[Stroke, ...]:
    """Return all strokes of a panel, with those that are not drawn in this pose."""
    return (*panel.zeros, *panel.strokes)


def owner_of(letter: str, fixed: Collection[str], poses: Sequence[Panel]) -> str | None:
    """Return the link or slide whose colour a point's path has: its vector ends there."""
    strokes = [stroke for pose in poses[:2] for stroke in (*pose.strokes, *pose.zeros)]
    blocks = [s for s in strokes if isinstance(s.shape, Block) and s.label == letter]
    arrows = [s for s in strokes if isinstance(s.shape, Arrow) and s.shape.head == letter]
    direct = [s for s in arrows if isinstance(s.shape, Arrow) and s.shape.tail in fixed]
    dots = [s for s in strokes if isinstance(s.shape, Dot) and s.label == letter]
    return next((stroke.link for stroke in (*direct, *blocks, *arrows, *dots)), None)


def _named(poses: Sequence[Panel]) -> list[Stroke]:
    """Return the vectors that have a name, each once, of those of Coriolis the first alone."""
    found: dict[str, Stroke] = {}
    for pose in poses:
        for stroke in _vectors(pose).values():
            twist = stroke.component == "coriolis"
            found.setdefault(CORIOLIS if twist else stroke.name, stroke)
    return list(found.values())


def _vectors(panel: Panel) -> dict[str, Stroke]:
    """Return the vectors with a name that are drawn in a pose, by the names of their strokes."""
    named = {s.name for s in (*panel.strokes, *panel.zeros) if s.component in NAMED}
    strokes = principal(panel).strokes
    return {s.name: s for s in strokes if s.name in named and name_of(s)}


def _apart(one: Complexes, other: Complexes) -> float:
    return float(np.nanmax(np.abs(one - other)))
