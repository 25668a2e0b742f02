"""Panels in motion: one panel of a turn, with what stands still, and any pose of the rest.

In come the panel's poses over the turn and its place, out go sketches; the scale, the supports
and the orbits of the labels are chosen once for all poses.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from vad.plan.geometry import Rect
from vad.plan.items import Item, Level
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import corners, text_at
from vad.plan.lettering.runs import symbols
from vad.plan.marks import line
from vad.plan.pictures import machine
from vad.plan.pictures.arrows import vector_of
from vad.plan.pictures.straight import vector
from vad.plan.pictures.vectors import DOT, dot
from vad.plan.roles import DOT_RIM, ROLES
from vad.plan.scale import fill
from vad.plan.sketch import Setting, Sketch
from vad.plan.turning.moving_skeleton import Skeleton
from vad.plan.turning.orbits import Orbit, find_orbit, stand
from vad.plan.turning.seats import Seat, letter_size, seats
from vad.plan.turning.spots import CORIOLIS, groups, spots
from vad.strokes.sheet import Arrow, Panel

#: A polygon this much larger than at most times may leave the panel for a while.
_RARE, _LARGE = 80.0, 2.2
CLIPPED = 0.010  # from the panel's edge, a vector that leaves it ends


@dataclass(frozen=True, slots=True)
class Name:
    """A label in motion: the letters at its dot, their row if they name a vector, its orbit."""

    text: str
    row: int | None
    radius: float
    orbit: Orbit


class MovingPanel:
    """One panel of a turn.

    ``poses`` are evenly spaced over it, ``rates`` are those of the driver as shares of the
    greatest.
    """

    def __init__(self, setting: Setting, poses: Sequence[Panel], rates: Sequence[float]) -> None:
        self._setting = setting
        position = setting.panel.picture == "skeleton"
        points = [point for pose in _usual(poses, position) for point in corners(pose)]
        self.scale = fill(points, setting.room, position)
        self._skeleton = Skeleton(setting, poses, self.scale) if position else None
        self._radius = machine.JOINT_REACH if position else DOT + DOT_RIM
        if self._skeleton:
            self._skeleton.settle(poses, rates)
        strokes = [self.obstacles(*each) for each in zip(poses, rates, strict=True)]
        self._names = self._place(poses, strokes)

    def still(self) -> list[Item]:
        """Return the items that are the same in all poses."""
        return self._skeleton.still.items if self._skeleton else []

    def items(self, panel: Panel, phase: float, rate: float) -> list[Item]:
        """Return the items of one pose; ``rate`` is the driver's, as a share of its greatest."""
        sketch = self._sketch(panel, rate)
        for name, box in self.labels(panel, phase):
            runs = symbols(name.text)
            role = "tag" if name.text == CORIOLIS else "letter"
            text = text_at(runs, runs, box.centre, letter_size(name.text), role, name.row)
            sketch.add(None, Level.LABEL, 0, [text])
        # What shows only while a stroke is drawn has no place in a turn.
        return [item for item in sketch.items if item.until > sketch.setting.end]

    def labels(self, panel: Panel, phase: float) -> list[tuple[Name, Rect]]:
        """Return the labels of one pose with their ink boxes."""
        found, taken = [], Obstacles(self._setting.room)
        for name, seat in zip(self._names, self._seats(panel), strict=True):
            placed = seat and stand(name.orbit, phase, seat, taken, name.radius)
            if seat and placed:
                taken.box(placed.box)
                found.append((replace(name, text=seat.text), placed.box))
        return found

    def obstacles(self, panel: Panel, rate: float) -> Obstacles:
        """Return the strokes of one pose, which labels keep clear of."""
        return self._sketch(panel, rate).obstacles

    def _sketch(self, panel: Panel, rate: float) -> Sketch:
        if self._skeleton:
            return self._skeleton.pose(panel, rate)
        room = self._setting.room
        sketch = Sketch(replace(self._setting, panel=panel), self.scale, Obstacles(room))
        for index, stroke in enumerate(panel.strokes):
            if isinstance(stroke.shape, Arrow):
                self._vector(sketch, index)
        for letter, spot in spots(panel, self.scale).items():
            if letter != CORIOLIS and room.holds(spot.at):
                sketch.add(None, Level.DOT, 0, [dot(spot.at)])
                sketch.obstacles.disc(spot.at, DOT + DOT_RIM)
        return sketch

    def _vector(self, sketch: Sketch, index: int) -> None:
        """Add a vector as far as it lies in the panel; its head shows if its end does."""
        stroke, room = sketch.setting.panel.strokes[index], sketch.setting.room
        whole = vector_of(sketch, index)
        if room.holds(whole.end) and room.holds(whole.start):
            sketch.add(stroke, Level.STROKE, 0, whole.marks())
            whole.block(sketch.obstacles, 0)
            return
        ends = whole.seen is not None and room.inside(CLIPPED).clipped(whole.seen, whole.end)
        if not ends:
            return
        if room.holds(whole.end):
            marks = vector(*ends, whole.row, whole.role, whole.whole)
        else:
            marks = [line(ends, whole.role, whole.row)]
        sketch.add(stroke, Level.STROKE, 0, marks)
        sketch.obstacles.line(ends, ROLES[whole.role].width / 2)

    def _place(self, poses: Sequence[Panel], strokes: Sequence[Obstacles]) -> list[Name]:
        placed = [Obstacles(self._setting.room) for _ in poses]
        # A vector that vanishes for an instant keeps its letters; one that is never there has none.
        self._letters = {letter for pose in poses for letter in spots(pose, self.scale)}
        found = groups([spots(pose, self.scale, self._letters) for pose in poses])
        self._groups = sorted(found, key=lambda letters: CORIOLIS in letters)  # points come first
        here = [self._seats(pose) for pose in poses]
        names = []
        for index, letters in enumerate(self._groups):
            row, radius = None, self._radius if self._skeleton else 0.0
            if CORIOLIS in letters:
                row = self._coriolis_row(poses)
            orbit = find_orbit([pose[index] for pose in here], strokes, placed, radius)
            names.append(Name(", ".join(letters), row, radius, orbit))
        return names

    def _seats(self, panel: Panel) -> list[Seat | None]:
        here = spots(panel, self.scale, self._letters)
        return seats(here, self._groups, self._setting.room, self._radius)

    def _coriolis_row(self, poses: Sequence[Panel]) -> int | None:
        links = [s.link for pose in poses for s in pose.strokes if s.component == "coriolis"]
        return self._setting.row(links[0])


def _usual(poses: Sequence[Panel], position: bool) -> list[Panel]:
    """Return the poses whose polygons are not much larger than most."""
    if position:
        return list(poses)
    sizes = np.array([max(abs(point) for point in corners(pose)) for pose in poses])
    limit = _LARGE * np.percentile(sizes, _RARE)
    return [pose for pose, size in zip(poses, sizes, strict=True) if size <= limit]
