"""The loads of a mechanism at their points, in its position diagram, and couples as arcs.

An inertia force is moved by the couple of its body.  Where three forces on a member meet, the
lines that meet there are drawn, too.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from vad.kinematics.linkage import points_of
from vad.strokes.force_captions import ForceCaptions
from vad.strokes.sheet import LOADS, Arc, Arrow, Dot, Line, Stroke, StrokePart
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.statics.dyads import DyadForces, Load
    from vad.strokes.force_names import Couple
    from vad.strokes.scene import Scene
    from vad.strokes.sentences import Sentence
    from vad.strokes.three_forces import ThreeForces

#: The length of every arrow, as a share of the mechanism's.
LENGTH = 0.22
#: The arc of a couple, in degrees.
START, SWEEP = 30.0, 270.0
#: How far a force may be moved by a couple, in such lengths, so that its line is drawn.
FAR = 3.0


class _AtPoints:
    """The strokes of loads in a position diagram, drawn and left out."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.names = scene, scene.force_names
        self.words = ForceCaptions(scene, self.names)
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []
        self.resumes = 0
        places = [scene.at(point) for point in scene.members.points] + _ends_of_yokes(scene)
        across, up = [z.real for z in places], [z.imag for z in places]
        size = abs(complex(max(across) - min(across), max(up) - min(up)))
        self.length = LENGTH * size

    def draw(self) -> None:
        """Draw the loads, what follows from the accelerations, and the lines of three forces.

        Of these lines those on the last dyad come first.
        """
        largest = max((abs(load.force) for load in self.names.loads), default=0.0)
        for moving in (False, True):
            for load in self.names.loads:
                if (load.kind == "inertia") is moving:
                    self._load(load, abs(load.force) > NOTHING * largest)
            for couple in self.names.couples:
                if (couple.kind == "spin") is moving:
                    self._couple(couple)
            if not moving:
                self.resumes = len(self.strokes)
        for load in self.names.loads:
            if load.kind == "inertia":
                self._moved(load, abs(load.force) > NOTHING * largest)
        for names in [each for _, each in self.scene.force_parts] or [self.names]:
            self.names = names
            for dyad in names.dyads:
                self._lines(dyad, names.meetings.get(dyad.number))

    def _load(self, load: Load, shown: bool) -> None:
        """Draw a load with its head at its point, a weight with its tail."""
        at = self.scene.at(load.point)
        arrow = load.force * (self.length / abs(load.force)) if shown else 0j
        ends = (at, at + arrow) if load.kind == "weight" else (at - arrow, at)
        symbol, part = self.names.load(load), StrokePart(self.names.plain_load(load), "load")
        if shown:
            shape, said = Arrow(*ends, "", ""), self.words.load(symbol, load)
            self.strokes.append(Stroke("known", symbol, shape, said, LOADS, "load", part=part))
        else:
            shape = Arrow(at, at, "", "")
            self.zeros.append(Stroke("known", symbol, shape, "", LOADS, "load", part=part))

    def _couple(self, couple: Couple) -> None:
        """Draw a couple as an arc about the middle of its link, that of an inertia about its mass.

        Its radius is chosen where it is painted.
        """
        centre = self._middle(couple)
        symbol = self.names.couple(couple)
        sweep = math.copysign(SWEEP, couple.value) if couple.value else 0.0
        arc = Arc(centre, self.length / 2, START, sweep)
        part = StrokePart(self.names.plain_couple(couple), "couple")
        said = self.words.couple(symbol, couple) if couple.value else ""
        stroke = Stroke("known", symbol, arc, said, LOADS, "couple", part=part)
        (self.strokes if couple.value else self.zeros).append(stroke)

    def _middle(self, couple: Couple) -> complex:
        acting = (each for each in self.names.forces.acting if each.body == couple.body)
        masses = (each.point for each in acting if each.kind == "inertia")
        if couple.kind == "spin":
            return self.scene.at(next(masses))
        link = str(self.names.bodies[couple.body].link)
        ends = points_of(self.scene.motion.mechanism.links[link])
        return sum(map(self.scene.at, ends), 0j) / 2

    def _moved(self, load: Load, shown: bool) -> None:
        """Draw the line on which an inertia force alone has the moment of its couple, too."""
        part = StrokePart(self.names.plain_load(load), "moved")
        arm = self.names.arm(load) if shown else None
        meeting = any(each.load == load for each in self.names.meetings.values())
        if not arm or arm[0].kind != "spin" or meeting or abs(arm[1]) > FAR * self.length:
            at = self.scene.at(load.point)
            self.zeros.append(Stroke("construction", "", Line(at, 1.0, at), "", part=part))
            return
        foot, way = self.scene.at(load.point) + arm[1], load.force / abs(load.force)
        line = Line(foot - self.length * way, way, foot)
        said = self.words.moved(self.names.load(load), load, *arm)
        self.strokes.append(Stroke("construction", "", line, said, LOADS, "action", part=part))

    def _lines(self, dyad: DyadForces, meeting: ThreeForces | None) -> None:
        """Draw the two known lines of a member with three forces, and the one that they give."""
        of = f"dyad{dyad.number + 1}{self.names.alone}"
        if meeting is None:
            at = self.scene.at(dyad.inner.point)
            for which in ("load line", "known line", "line"):
                part = StrokePart(of, which)
                stroke = Stroke("construction", "", Line(at, 1.0, at), "", part=part)
                self.zeros.append(stroke)
            part = StrokePart(of, "meeting")
            self.zeros.append(Stroke("intersection", "", Dot(at), "", part=part))
            return
        names, at = self.names, meeting.at
        letter = names.letter_of(meeting)
        load, other, held = meeting.load, meeting.other, meeting.held
        action = names.load(load)
        row = LOADS if load.kind != "joint" else names.row(load.name)
        arm = names.arm(load)
        said = (
            self.words.moved(action, load, *arm)
            if arm
            else self.scene.say("force line", label=action)
        )
        self._line(of, "load line", meeting.start, at, row, said)
        force = names.force(other.outer.one, other.outer.other)
        joint, row = self.scene.at(meeting.joint), names.row(other.bodies[-1])
        said = self.scene.say("force line", label=force)
        self._line(of, "known line", joint, at, row, said)
        between = names.force(other.bodies[-1], held.bodies[-1])
        said = self.scene.say(
            "force meeting",
            link=names.noun(held.bodies[-1]),
            label=action,
            force=between,
            letter=letter,
        )
        part = StrokePart(of, "meeting")
        self.strokes.append(Stroke("intersection", letter, Dot(at), said, part=part))
        force, row = names.force(held.outer.one, held.outer.other), names.row(held.bodies[-1])
        pin = held.outer.point
        said = self.scene.say("force three", label=force, point=pin, meeting=letter)
        self._line(of, "line", self.scene.at(pin), at, row, said)

    def _line(
        self,
        of: str,
        which: str,
        start: complex,
        at: complex,
        row: str,
        said: Sentence,
    ) -> None:
        """Draw a line of action from a point to the one in which three lines meet."""
        away, part = at - start, StrokePart(of, which)
        shown = abs(away) > NOTHING * self.length
        line = Line(start, away / abs(away) if shown else 1.0 + 0j, at)
        stroke = Stroke("construction", "", line, said if shown else "", row, "action", part=part)
        (self.strokes if shown else self.zeros).append(stroke)


def _ends_of_yokes(scene: Scene) -> list[complex]:
    """Return how far yokes get, as a mechanism with one is larger than its points tell."""
    found, sliding = [], scene.members.sliding
    for yoke in sliding:
        if any(block.tail == yoke.head for block in sliding):
            way = scene.heading(scene.members.frame.line(yoke, scene.pose))
            found += [scene.at(yoke.head) + by * way for by in scene.travel(yoke.name)]
    return found


def loads_at_points(scene: Scene) -> tuple[list[Stroke], list[Stroke], str]:
    """Return the strokes of loads, and those that are left out in this pose.

    All arrows are of one length: their sizes stand in the results.  The name is that of the first
    stroke that needs accelerations; it is empty where none does.
    """
    if scene.forces is None:
        return [], [], ""
    drawn = _AtPoints(scene)
    drawn.draw()
    moving = any(each.kind == "inertia" for each in drawn.names.forces.acting)
    first = drawn.strokes[drawn.resumes :][:1] if moving else []
    return drawn.strokes, drawn.zeros, first[0].name if first else ""
