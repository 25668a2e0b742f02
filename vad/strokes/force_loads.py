"""The loads of a mechanism at their points, in its position diagram.

Where three forces on a member meet, the lines that meet there are drawn, too.
"""

from __future__ import annotations

import cmath
from typing import TYPE_CHECKING

from vad.strokes.force_captions import ForceCaptions
from vad.strokes.sheet import LOADS, Arrow, Dot, Line, Stroke, StrokePart
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.statics.dyads import DyadForces, Load
    from vad.strokes.scene import Scene
    from vad.strokes.three_forces import ThreeForces

#: The length of every arrow, as a share of the mechanism's.
LENGTH = 0.22


class _AtPoints:
    """The strokes of loads in a position diagram, drawn and left out."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.names = scene, scene.force_names
        self.words = ForceCaptions(scene, self.names)
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []
        places = [scene.at(point) for point in scene.members.points]
        across, up = [z.real for z in places], [z.imag for z in places]
        size = abs(complex(max(across) - min(across), max(up) - min(up)))
        self.length = LENGTH * size

    def draw(self) -> None:
        """Draw the loads, then the lines of members with three forces, the last dyad first."""
        largest = max((abs(load.force) for load in self.names.loads), default=0.0)
        for load in self.names.loads:
            self._load(load, abs(load.force) > NOTHING * largest)
        for dyad in self.names.dyads:
            self._lines(dyad, self.names.meetings.get(dyad.number))

    def _load(self, load: Load, shown: bool) -> None:
        """Draw a load with its head at its point, a weight with its tail."""
        at, arrow = self.scene.at(load.point), cmath.rect(self.length, cmath.phase(load.force))
        ends = (at, at + arrow) if load.kind == "weight" else (at - arrow, at)
        symbol, part = self.names.load(load), StrokePart(self.names.plain_load(load), "load")
        if shown:
            shape, said = Arrow(*ends, "", ""), self.words.load(symbol, load)
            self.strokes.append(Stroke("known", symbol, shape, said, LOADS, "load", part=part))
        else:
            shape = Arrow(at, at, "", "")
            self.zeros.append(Stroke("known", symbol, shape, "", LOADS, "load", part=part))

    def _lines(self, dyad: DyadForces, meeting: ThreeForces | None) -> None:
        """Draw the two known lines of a member with three forces, and the one that they give."""
        of = f"dyad{dyad.number + 1}"
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
        self._line(of, "load line", self.scene.at(load.point), at, row, "force line", action)
        force = names.force(other.outer.one, other.outer.other)
        joint, row = self.scene.at(meeting.joint), names.row(other.bodies[-1])
        self._line(of, "known line", joint, at, row, "force line", force)
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
        self._line(of, "line", self.scene.at(pin), at, row, "force three", force, pin, letter)

    def _line(
        self,
        of: str,
        which: str,
        start: complex,
        at: complex,
        row: str,
        phrase: str,
        force: str,
        point: str = "",
        letter: str = "",
    ) -> None:
        """Draw a line of action from a point to the one in which three lines meet."""
        away, part = at - start, StrokePart(of, which)
        said = self.scene.say(phrase, label=force, point=point, meeting=letter)
        shown = abs(away) > NOTHING * self.length
        line = Line(start, away / abs(away) if shown else 1.0 + 0j, at)
        stroke = Stroke("construction", "", line, said if shown else "", row, "action", part=part)
        (self.strokes if shown else self.zeros).append(stroke)


def loads_at_points(scene: Scene) -> tuple[list[Stroke], list[Stroke]]:
    """Return the strokes of loads, and those that are left out in this pose.

    All arrows are of one length: their sizes stand in the results.
    """
    if scene.forces is None:
        return [], []
    drawn = _AtPoints(scene)
    drawn.draw()
    return drawn.strokes, drawn.zeros
