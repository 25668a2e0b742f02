"""The loads of a mechanism: forces as arrows at their points, couples as curved arrows."""

from __future__ import annotations

import math
from collections.abc import Sequence

from vad.plan.anchors import RIGHT, Anchor, Arch, Area, Hung
from vad.plan.geometry import direction_of
from vad.plan.items import Level
from vad.plan.labels.choices import RATE
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import Placed, Wish, place
from vad.plan.labels.vertices import leader_of, text_beside
from vad.plan.lettering.glyphs import ink_size
from vad.plan.lettering.runs import symbols
from vad.plan.marks import Trimming
from vad.plan.pictures import angles
from vad.plan.pictures.vectors import PlacedVector
from vad.plan.reach import is_curved_arrow
from vad.plan.scale import Scale
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arc, Arrow, Panel

#: The largest radius of a couple.
NEAR = 0.09
#: Half of the width of a curved arrow.
LINE = 0.004
#: How far the name of a couple may stand from it without a leader.
NAME_NEAR = (0.010, 0.018, 0.028)
#: The place of a couple about which nothing is known.
CALM = angles.SensePlace(0.062, 78.0, 60.0)


def add_load(sketch: Sketch, index: int) -> None:
    """Add one load to the picture of a mechanism."""
    setting = sketch.setting
    stroke = setting.panel.strokes[index]
    assert isinstance(stroke.shape, Arrow)
    start, end = sketch.scale(stroke.shape.start), sketch.scale(stroke.shape.end)
    seen = start, Anchor.of(stroke.name, "start")
    placed = PlacedVector(stroke.name, start, end, seen, False, setting.row(stroke.link))
    during = setting.during(index)
    if not sketch.finished:
        sketch.add(stroke, Level.STROKE, during, [placed.light()], setting.over(index))
    sketch.add(stroke, Level.STROKE, during, placed.marks(sketch.solved, not sketch.finished))
    placed.block(sketch.obstacles, during)


def free_couple(sketch: Sketch, index: int) -> tuple[angles.SensePlace, Placed]:
    """Return the places of a curved arrow about its centre, and of its name.

    They are clear of everything if they can be.  Else the arrow crosses as little as possible, and
    its name stands where there is room.
    """
    stroke, obstacles = sketch.setting.panel.strokes[index], sketch.obstacles
    shape = stroke.shape
    assert isinstance(shape, Arc)
    centre, sense = sketch.scale(shape.centre), math.copysign(1.0, shape.sweep)
    found = angles.free_place(obstacles, centre, shape.start, sense, stroke.label, NEAR)
    if found:
        return found, found.letter(centre, stroke.label)
    arrow = angles.least_crossing(obstacles, centre, shape.start, sense)
    line, crowd = arrow.line(centre), obstacles.copy()
    crowd.line(line, LINE)
    middle = line[len(line) // 2]
    size = ink_size(symbols(stroke.label), RATE)
    return arrow, place(crowd, Wish(middle, direction_of(centre, middle), *size, near=NAME_NEAR))


def calm_couples(
    poses: Sequence[Panel], crowds: Sequence[Obstacles], scale: Scale
) -> dict[str, angles.SensePlace]:
    """Return a place for each curved arrow in all poses, by the names of their strokes.

    There it meets strokes, and those before it, in the fewest poses.
    """
    found: dict[str, angles.SensePlace] = {}
    taken = [each.copy() for each in crowds]
    strokes = {s.name: s for pose in poses for s in pose.strokes if is_curved_arrow(s)}
    for name, stroke in strokes.items():
        seen = [
            (scale(each.shape.centre), crowd)
            for pose, crowd in zip(poses, taken, strict=True)
            for each in pose.strokes
            if each.name == name and isinstance(each.shape, Arc)
        ]
        arrow = found[name] = angles.calm_place(seen, stroke.label)
        for centre, crowd in seen:
            crowd.line(arrow.line(centre), LINE)
            crowd.box(arrow.letter(centre, stroke.label).box)
    return found


def add_couple(
    sketch: Sketch, index: int, arrow: angles.SensePlace, letter: Placed | None = None
) -> None:
    """Add one couple as a curved arrow, at a place about its centre, with its name.

    Its name stands beside its middle, if it has no other place.
    """
    setting, stroke = sketch.setting, sketch.setting.panel.strokes[index]
    shape = stroke.shape
    assert isinstance(shape, Arc)
    if not shape.sweep:
        return
    centre, row = Anchor.of(stroke.name, "centre"), setting.row(stroke.link)
    at = sketch.solved.place(centre)
    bow, head = angles.curved_arrow(
        arrow.radius, arrow.middle, math.copysign(arrow.span, shape.sweep)
    )
    role = "couple" if stroke.component == "couple" else "sense"
    arch = Arch(centre, bow.radius, bow.start, bow.sweep)
    sketch.hang(index, Level.BLOCK, [Hung(arch, role, row, Trimming())])
    letter, runs = letter or arrow.letter(at, stroke.label), symbols(stroke.label)
    marks = [Hung(Area(tuple(centre + RIGHT * corner for corner in head)), "head", row)]
    sketch.hang(index, Level.BLOCK, marks, since="after")
    name = text_beside(centre, at, runs, letter.centre, RATE, "tag", row)
    leader = [leader_of(centre, at, letter.leader)] if letter.leader else []
    sketch.add(stroke, Level.LABEL, setting.after(index), [*leader, name])
    sketch.tags.append(Tag(stroke.label, letter.box))
    sketch.obstacles.box(letter.box)
    sketch.obstacles.line(arrow.line(at), LINE)
