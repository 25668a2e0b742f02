"""Labels in motion: the letters and names of a picture over a whole turn.

A label is found once for all poses.  In each it stands beside its dot, is led to it from farther
away, or is absent.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import compress
from typing import Any

import numpy as np

from vad.plan.anchors import Anchor, Solved
from vad.plan.hodographs import Complexes, Hodographs
from vad.plan.items import Level
from vad.plan.labels.obstacles import PIXEL
from vad.plan.labels.placing import Placed
from vad.plan.labels.springs import LED, Ballast, Box, Spring, find_spring
from vad.plan.labels.vertices import LETTER, SMALL_SIZE, lettered, text_beside
from vad.plan.lens import Lens
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.marks import Mark, line
from vad.plan.pictures.polygon import CORIOLIS, name_of, principal
from vad.plan.reach import UPON
from vad.plan.scale import Scale
from vad.plan.sketch import Setting, Sketch
from vad.strokes.diagram import Spot
from vad.strokes.sheet import Arrow, Panel, Stroke

FADING = 0.025  # so far from the edge a label goes, and where a vector is twice as short
#: A label shows in full from this share of its ink on, and else not at all.
SHOWN = 0.5
#: Over that distance the line of a label appears, which is led to its dot; how far it ends from it.
LEADER_APPEARS, LEADER_GAP = 4.0 * PIXEL, 5.0 * PIXEL
#: A label that stands farther from its dot has the line in full ink.
FAR = LED + LEADER_APPEARS
#: How often the place of each label is looked for, the last times among all others.
SWEEPS = 2
#: The components of vectors that have a name of their own.
NAMED = ("coriolis", "force", *UPON)

#: How far inside the window in which a picture is seen a place is at a phase; less than 0 outside.
Inside = Callable[[complex, float], float]
#: Text, letters, vector and row of a `Name`.
Wanted = tuple[str, tuple[Spot, ...], str, int | None]


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


class TurnLabels:
    """The labels of a picture that is seen in a window: its panel, or a lens over it.

    Attributes
    ----------
    names
        The labels.
    """

    def __init__(
        self,
        setting: Setting,
        scale: Scale,
        ways: Hodographs,
        opening: float,
        inside: Inside,
        lens: Lens | None = None,
        letter: float = LETTER,
    ) -> None:
        self._setting, self._ways, self._opening = setting, ways, opening
        self._lens, self._inside, self._letter = lens, inside, letter
        self._scale = lens.scale(scale) if lens else scale
        self._radius = 0.0
        self.names: list[Name] = []

    def place(
        self, groups: Sequence[tuple[Spot, ...]], poses: Sequence[Panel], among: Ballast
    ) -> None:
        """Find where the letters of ``groups``, and the names of vectors, stand in all poses."""
        self._radius = among.radius
        phases = [number / len(poses) for number in range(len(poses))]
        wanted: list[Wanted] = [
            (", ".join(spot.letter for spot in group), group, "", None) for group in groups
        ]
        wanted += [
            (name_of(stroke), (), stroke.name, self._setting.row(stroke.link))
            for stroke in _named(poses)
        ]
        dots = []
        for _, letters, vector, _ in wanted:
            places = [self._spot(letters, vector, *at) for at in zip(poses, phases, strict=True)]
            dots.append(np.array([at if alpha > 0.0 else np.nan for at, alpha in places]))
        springs = self._springs(wanted, dots, among)
        for (text, letters, vector, row), own, spring in zip(wanted, dots, springs, strict=True):
            if spring is None:
                continue
            anchor = Anchor(((vector, "start"), (vector, "end")))
            if not vector:
                seen = [not is_far(letters[0], pose) for pose in poses]
                first = int((np.isfinite(own) & seen).argmax())
                solved = Solved(poses[first], self._scale)
                anchor = self._anchor(letters, complex(own[first]), solved)
            self.names.append(Name(text, letters, vector, row, spring, anchor))

    def _springs(
        self, wanted: Sequence[Wanted], dots: Sequence[Complexes], among: Ballast
    ) -> list[Spring | None]:
        """Return how each label moves; None of one whose dot is never to be seen.

        Each makes way for those before it, and then again for all others.
        """
        found = list[Spring | None]([None] * len(wanted))
        boxes: dict[int, Box] = {}
        of_letters = [not vector for _, _, vector, _ in wanted]
        for number in [*range(len(wanted))] * SWEEPS:
            (text, _, vector, _), own = wanted[number], dots[number]
            if not np.isfinite(own).any():
                continue
            # A vector's name belongs to no dot.
            rivals = [] if vector else [at for at in compress(dots, of_letters) if at is not own]
            placed = [box for other, box in boxes.items() if other != number]
            spring = find_spring(own, self._size(text, vector), rivals, among, placed)
            boxes[number] = (
                np.where(spring.shown, own + spring.offsets, np.nan),
                self._size(text, vector),
            )
            found[number] = spring
        return found

    def _size(self, text: str, vector: str) -> tuple[float, float]:
        return ink_size(symbols(text), SMALL_SIZE if vector else self._letter)

    def at(self, panel: Panel, phase: float) -> list[tuple[Name, Placed]]:
        """Return the labels that show at a phase, and where they stand."""
        found = []
        for name in self.names:
            dot, alpha = self._spot(name.letters, name.vector, panel, phase)
            offset = name.spring.at(phase)
            if offset is not None and alpha >= SHOWN:
                found.append((name, Placed(dot + offset, *self._size(name.text, name.vector))))
        return found

    def dot(self, name: Name, panel: Panel, phase: float) -> complex:
        """Return what a label stands beside: its dot, or the middle of its vector."""
        return self._spot(name.letters, name.vector, panel, phase)[0]

    def add(self, sketch: Sketch, panel: Panel, phase: float, level: Level = Level.LABEL) -> None:
        """Add the labels of one pose to its sketch."""
        solved = Solved(panel, self._scale)
        for name, placed in self.at(panel, phase):
            runs, role = symbols(name.text), "letter" if name.row is None else "tag"
            size = SMALL_SIZE if name.vector else self._letter
            far = bool(name.letters) and is_far(name.letters[0], panel)
            arrow = name.letters[0].arrow if far else ""
            anchor = Anchor(((arrow, "start"), (arrow, "end"))) if arrow else name.anchor
            hung = anchor, solved.place(anchor)
            text = text_beside(*hung, runs, placed.centre, size, role, name.row)
            leader = self._leader(name, self.dot(name, panel, phase), placed)
            sketch.add(None, level, 0, [*leader, text])
            sketch.obstacles.box(placed.box)

    def _leader(self, name: Name, dot: complex, placed: Placed) -> Iterator[Mark]:
        """Yield the line from a label to its dot, if it stands far from it."""
        if name.vector:
            return
        away = dot - placed.centre
        aside, above = abs(away.real) - placed.wide / 2, abs(away.imag) - placed.high / 2
        gap = math.hypot(max(aside, 0.0), max(above, 0.0)) - self._radius
        ink = min(max((gap - FAR) / LEADER_APPEARS + 1.0, 0.0), 1.0)
        if not ink:
            return
        edge = placed.centre + complex(
            min(max(away.real, -placed.wide / 2), placed.wide / 2),
            min(max(away.imag, -placed.high / 2), placed.high / 2),
        )
        way = (dot - edge) / abs(dot - edge)
        ends = edge + LEADER_GAP * way, dot - (self._radius + LEADER_GAP / 2) * way
        yield replace(line(ends, "leader"), alpha=ink)

    def _anchor(self, letters: tuple[Spot, ...], dot: complex, solved: Solved) -> Anchor:
        """Return the anchor of letters; a point in two views has it in the view that it names."""
        found = [Anchor((point,)) for point in lettered(solved.panel)[letters[0].letter]]
        return min(found, key=lambda anchor: abs(solved.place(anchor) - dot))

    def _spot(
        self, letters: tuple[Spot, ...], vector: str, panel: Panel, phase: float
    ) -> tuple[complex, float]:
        """Return the dot of a label, or the middle of its vector, and the label's share of ink."""
        alpha, scale = 1.0, self._scale
        if vector:
            stroke = vectors_of(panel).get(vector)
            if stroke is None:
                return complex("nan"), 0.0
            shape: Any = stroke.shape
            start, end = scale(shape.start), scale(shape.end)
            at = (start + end) / 2
            alpha = min(max(abs(end - start) / FADING - 1.0, 0.0), 1.0)
        elif is_far(letters[0], panel):
            arrow = _arrow(letters[0], panel)
            if arrow is None:
                return complex("nan"), 0.0
            at = (scale(arrow.start) + scale(arrow.end)) / 2
        else:
            at = self._ways.at(letters[0], phase - self._opening)
            at = self._lens(at) if self._lens else at
        near = self._inside(at, phase)
        return at, min(alpha, max(near, 0.0) / FADING)


def grouped(ways: Hodographs, drawn: Sequence[Spot]) -> list[tuple[Spot, ...]]:
    """Return the letters in groups that share a dot in all poses, the calmest group first.

    Last are those of which no path is drawn.
    """
    tracks, found = ways.tracks, list[list[Spot]]()
    for letter, way in tracks.items():
        if not letter.lettered:
            continue
        same = [group for group in found if _apart(tracks[group[0]], way) < PIXEL]
        if not same:
            found.append([letter])
        elif letter.row or not np.ptp(way):  # the lever's point under a pin needs no letter
            same[0].append(letter)
    ranked = sorted(found, key=lambda group: (group[0].path == "none", group[0] in drawn))
    return [tuple(group) for group in ranked]


def is_far(spot: Spot, panel: Panel) -> bool:
    """Tell whether a point is too far away to be drawn in a pose: a centre may be."""
    return spot.path in ("numbered", "none") and spot.letter not in lettered(panel)


def _arrow(spot: Spot, panel: Panel) -> Arrow | None:
    """Return the arrow that leads to a point in a pose, if there is one."""
    shapes = (stroke.shape for stroke in panel.strokes if stroke.name == spot.arrow)
    return next((shape for shape in shapes if isinstance(shape, Arrow)), None)


def _named(poses: Sequence[Panel]) -> list[Stroke]:
    """Return the vectors that have a name, each once, of those of Coriolis the first alone."""
    found: dict[str, Stroke] = {}
    for pose in poses:
        for stroke in vectors_of(pose).values():
            twist = stroke.component == "coriolis"
            found.setdefault(CORIOLIS if twist else stroke.name, stroke)
    return list(found.values())


def vectors_of(panel: Panel) -> dict[str, Stroke]:
    """Return the vectors with a name that are drawn in a pose, by the names of their strokes."""
    named = {s.name for s in (*panel.strokes, *panel.zeros) if s.component in NAMED}
    strokes = principal(panel).strokes
    return {s.name: s for s in strokes if s.name in named and name_of(s)}


def _apart(one: Complexes, other: Complexes) -> float:
    return float(np.nanmax(np.abs(one - other)))
