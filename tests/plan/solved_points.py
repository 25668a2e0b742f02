"""Where the points of a sheet are, worked out from `vad.solve` alone, not from the sheet.

A letter of the mechanism's panel is a solved point, one of a polygon a solved velocity or
acceleration.  Vertices between two of those, as cₙ, follow from the vector that leads there: ω²·r,
α·r, 2ω·v or the rate of a slide.
"""

from __future__ import annotations

import cmath
import math

from vad.kinematics.motion import Motion
from vad.strokes.sheet import Arrow, Block, Dot, Panel, Plate, Sheet, Stroke

#: Of a vector so short that its direction is lost in rounding, as a share of the largest.
LOST = 1e-7


class SolvedPoints:
    """The points of one panel of a mechanism in the plane."""

    def __init__(self, motion: Motion, sheet: Sheet, panel: Panel) -> None:
        self.motion, self.panel = motion, panel
        blocks = [s for s in sheet.panel("position").strokes if isinstance(s.shape, Block)]
        self.carriers = {s.link: s.shape.on for s in blocks if isinstance(s.shape, Block)}
        self.order = {"position": 0, "velocity": 1, "acceleration": 2}[panel.column]
        self.strokes = {stroke.name: stroke for stroke in (*panel.zeros, *panel.strokes)}
        self.letters: dict[str, complex] = {}
        for stroke in self.strokes.values():
            for letter in letters_of(stroke):
                found = 0j if stroke.kind == "pole" and self.order else self.plain(letter)
                if found is not None:
                    self.letters[letter] = found
        arrows = [s for s in self.strokes.values() if isinstance(s.shape, Arrow)] * 3
        for stroke in arrows if self.order else ():
            self.follow(stroke)

    def plain(self, letter: str) -> complex | None:
        """Return what a letter that names a point of the mechanism stands for."""
        bare = letter.rstrip("′")
        name = bare if self.order == 0 else bare.upper()
        if len(letter) - len(bare) not in ((0,), (0,), (1,))[self.order]:
            return None
        if name not in self.motion.points:
            return 0j if name == "O" else None  # where two guides meet
        point = self.motion.point(name)
        return complex((point.position, point.velocity, point.acceleration)[self.order])

    def follow(self, stroke: Stroke) -> None:
        """Find one end of a vector from the other."""
        shape = stroke.shape
        assert isinstance(shape, Arrow)
        known = shape.tail in self.letters, shape.head in self.letters
        vector = self.vector(stroke) if known in ((True, False), (False, True)) else None
        if vector is not None and known[0]:
            self.letters[shape.head] = self.letters[shape.tail] + vector
        elif vector is not None:
            self.letters[shape.tail] = self.letters[shape.head] - vector

    def vector(self, stroke: Stroke) -> complex | None:
        """Return a vector of a polygon; None where it is known by its ends alone."""
        motion, link = self.motion, stroke.link
        # Of a strut, whose rod and cylinder share an imagined point, the arm is all of it.
        names = points_in(motion, stroke.part.of)
        if len(names) < 2 and link in motion.mechanism.links:
            names = points_in(motion, motion.mechanism.links[link])
        ends = [motion.point(letter).position for letter in names]
        arm = complex(ends[1] - ends[0]) if len(ends) == 2 else None
        if stroke.component == "normal" and arm is not None:
            return -(motion.link(link).omega ** 2) * arm
        if stroke.component == "tangential" and arm is not None:
            turning = motion.link(link)
            return 1j * (turning.omega if self.order == 1 else turning.alpha) * arm
        if stroke.component == "sliding" and self.order == 1:
            return self.slipping(stroke)
        if stroke.component == "sliding" and len(points_in(motion, stroke.part.of)) < 2:
            strut = str(link)
            return complex(motion.slide(strut).acceleration * self.along(strut))
        if stroke.component == "coriolis":
            carrier = self.carriers.get(link, link)
            return 2j * complex(motion.link(carrier).omega) * self.slipping(stroke)
        return None

    def slipping(self, stroke: Stroke) -> complex:
        """Return the velocity of what slides relative to what it slides on."""
        ends = points_in(self.motion, stroke.part.of)
        if len(ends) == 2:
            tail, head = (self.motion.point(letter).velocity for letter in ends)
            return complex(head - tail)
        strut = str(stroke.link)  # whose rod slides in its cylinder
        return complex(self.motion.slide(strut).velocity * self.along(strut))

    def along(self, link: str) -> complex:
        """Return the direction of a link."""
        return cmath.rect(1.0, math.radians(self.motion.link(link).angle))


def points_in(motion: Motion, names: str) -> list[str]:
    """Return the points of a step: A and B of AB, O2 and A of O2A."""
    found, rest = [], names
    while rest:
        name = max((n for n in motion.points if rest.startswith(n)), key=len, default=None)
        if name is None:
            return []
        found.append(name)
        rest = rest.removeprefix(name)
    return found


def letters_of(stroke: Stroke) -> list[str]:
    """Return the letters of a stroke's points."""
    shape = stroke.shape
    if isinstance(shape, Arrow):
        return [shape.tail, shape.head]
    if isinstance(shape, Plate):
        return list(shape.letters)
    return (
        [each.strip() for each in stroke.label.split(",")] if isinstance(shape, Dot | Block) else []
    )
