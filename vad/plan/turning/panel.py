"""Panels in motion: one panel of a turn, with what stands still, and any pose of the rest.

In come the panel's poses over the turn and its place, out go marks; the scale, the supports and
the orbits of the labels are chosen once for all poses.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from vad.plan.arrows import vector_of
from vad.plan.art import FOREVER, Level, Look, PanelArt
from vad.plan.labels import Obstacles
from vad.plan.marks import Mark
from vad.plan.page import Rect
from vad.plan.polygon import DOT, DOT_RIM, dot
from vad.plan.scale import fill
from vad.plan.text import symbols
from vad.plan.turning.orbits import Orbit, find_orbit, stand
from vad.plan.turning.seats import Seat, letter_size, seats
from vad.plan.turning.skeleton import Skeleton
from vad.plan.turning.spots import CORIOLIS, groups, spots
from vad.plan.vectors import along, clipped, vector
from vad.plan.vertices import corners, halo, text_at
from vad.strokes.sheet import Arrow, Panel

#: A polygon this much larger than at most times may leave the panel for a while.
_RARE, _LARGE = 80.0, 2.2
CLIPPED = 0.010  # from the panel's edge, a vector that leaves it ends


@dataclass(frozen=True, slots=True)
class Name:
    """A label in motion: the letters at its dot, as they are written, and the dot's radius."""

    text: str
    size: float
    ink: str
    radius: float
    orbit: Orbit


class MovingPanel:
    """One panel of a turn.

    ``poses`` are evenly spaced over it, ``rates`` are those of the driver as shares of the
    greatest.
    """

    def __init__(
        self, poses: Sequence[Panel], rates: Sequence[float], drawing: Rect, look: Look
    ) -> None:
        self._drawing, self._look = drawing, look
        first = poses[0]
        position = first.name == "position"
        points = [point for pose in _usual(poses, position) for point in corners(pose)]
        self.scale = fill(points, drawing, look.unit, position)
        self._skeleton = Skeleton(poses, self.scale, drawing, look) if position else None
        if self._skeleton:
            self._skeleton.settle(poses, rates)
        strokes = [self._art(*each).obstacles for each in zip(poses, rates, strict=True)]
        self._names = self._place(poses, strokes)

    def still(self) -> list[Mark]:
        """Return the marks that are the same in all poses."""
        return self._skeleton.still() if self._skeleton else []

    def marks(self, panel: Panel, phase: float, rate: float) -> list[Mark]:
        """Return the marks of one pose; ``rate`` is the driver's, as a share of its greatest."""
        art = self._art(panel, rate)
        for name, box in self.labels(panel, phase):
            runs = symbols(name.text)
            marks = text_at(runs, runs, box.centre, name.size, name.ink, halo(self._look))
            art.add(Level.LABEL, 0, marks)
        return art.split(FOREVER - 1)[0]

    def labels(self, panel: Panel, phase: float) -> list[tuple[Name, Rect]]:
        """Return the labels of one pose with their ink boxes."""
        unit, found, taken = self._look.unit, [], Obstacles(self._drawing)
        here = self._seats(panel)
        for name, seat in zip(self._names, here, strict=True):
            placed = seat and stand(name.orbit, phase, seat, taken, unit, name.radius)
            if seat and placed:
                taken.box(placed.box)
                found.append((replace(name, text=seat.text), placed.box))
        return found

    def obstacles(self, panel: Panel, rate: float) -> Obstacles:
        """Return the strokes of one pose, which labels keep clear of."""
        return self._art(panel, rate).obstacles

    def _art(self, panel: Panel, rate: float) -> PanelArt:
        if self._skeleton:
            return self._skeleton.art(panel, rate)
        art = PanelArt(self.scale, Obstacles(self._drawing))
        for index, stroke in enumerate(panel.strokes):
            if isinstance(stroke.shape, Arrow):
                self._vector(art, panel, index)
        unit = self._look.unit
        for letter, spot in spots(panel, self.scale).items():
            if letter != CORIOLIS and self._drawing.holds(spot.at):
                art.add(Level.DOT, 0, [dot(self._look, spot.at)])
                art.obstacles.disc(spot.at, (DOT + DOT_RIM) * unit)
        return art

    def _vector(self, art: PanelArt, panel: Panel, index: int) -> None:
        """Add a vector as far as it lies in the panel; its head shows if its end does."""
        look, whole = self._look, vector_of(panel, index, self.scale, self._look)
        if self._drawing.holds(whole.end) and self._drawing.holds(whole.start):
            art.add(Level.STROKE, 0, whole.marks())
            whole.block(art.obstacles, 0)
            return
        if whole.seen is None:
            return
        ends = clipped(whole.seen, whole.end, self._drawing.inside(CLIPPED * look.unit))
        if ends is None:
            return
        line, ink = look.line(whole.link), look.ink(whole.link)
        if self._drawing.holds(whole.end):
            marks = vector(look.style, line, ink, *ends, look.unit, whole.whole)
        else:
            marks = along(look.style, line, ink, whole.width, *ends, "butt")
        art.add(Level.STROKE, 0, marks)
        art.obstacles.line(ends, whole.width / 2)

    def _place(self, poses: Sequence[Panel], strokes: Sequence[Obstacles]) -> list[Name]:
        look, names = self._look, []
        placed = [Obstacles(self._drawing) for _ in poses]
        # A vector that vanishes for an instant keeps its letters; one that is never there has none.
        self._letters = {letter for pose in poses for letter in spots(pose, self.scale)}
        found = groups([spots(pose, self.scale, self._letters) for pose in poses], look.unit)
        self._groups = sorted(found, key=lambda letters: CORIOLIS in letters)  # points come first
        here = [self._seats(pose) for pose in poses]
        for index, letters in enumerate(self._groups):
            text, ink = ", ".join(letters), look.style.text
            radius = self._skeleton.radius if self._skeleton else 0.0
            if text == CORIOLIS:
                ink, radius = self._coriolis_ink(poses), 0.0
            orbit = find_orbit([pose[index] for pose in here], strokes, placed, look.unit, radius)
            names.append(Name(text, letter_size(text, look.unit), ink, radius, orbit))
        return names

    def _seats(self, panel: Panel) -> list[Seat | None]:
        unit, here = self._look.unit, spots(panel, self.scale, self._letters)
        radius = self._skeleton.radius if self._skeleton else (DOT + DOT_RIM) * unit
        return seats(here, self._groups, self._drawing, unit, radius)

    def _coriolis_ink(self, poses: Sequence[Panel]) -> str:
        links = [s.link for pose in poses for s in pose.strokes if s.component == "coriolis"]
        return self._look.ink(links[0])


def _usual(poses: Sequence[Panel], position: bool) -> list[Panel]:
    """Return the poses whose polygons are not much larger than most."""
    if position:
        return list(poses)
    sizes = np.array([max(abs(point) for point in corners(pose)) for pose in poses])
    limit = _LARGE * np.percentile(sizes, _RARE)
    return [pose for pose, size in zip(poses, sizes, strict=True) if size <= limit]
