"""The sense of the given ω in a turn: an arrow that stands still while the crank goes round."""

from __future__ import annotations

import math
from collections.abc import Sequence

from vad.plan.items import Level
from vad.plan.labels.choices import RATE
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.vertices import text_at
from vad.plan.lettering.runs import symbols
from vad.plan.pictures.angles import (
    SENSE_SIZES,
    WIDER,
    free_place,
    rate_of,
    sense_arrow,
)
from vad.plan.sketch import Sketch, Tag
from vad.strokes.sheet import Arc, Panel

#: Where a place for it is looked for first, in degrees: it is above its pivot.
FIRST = 27.0


def add_standing_sense(
    still: Sketch, poses: Sequence[Panel], sketches: Sequence[Sketch], ways: Obstacles
) -> None:
    """Add the arrow of the given ω about a pivot that stands still, where no pose meets it.

    Where every place meets some pose, it is the one that does the least; without a place whose
    letter is free there is none.

    Parameters
    ----------
    still
        What stands still.
    poses, sketches
        All poses, and what each of them shows: it keeps clear of the arrow from here on.
    ways
        The paths that are drawn.
    """
    driver, row = still.setting.sheet.driver, still.setting.row(still.setting.sheet.driver.row)
    angles = [pose.find(driver.angle) for pose in poses]
    shapes = [pose.strokes[n].shape for pose, n in zip(poses, angles, strict=True) if n is not None]
    centres = {shape.centre for shape in shapes if isinstance(shape, Arc)}
    if not driver.omega or len(centres) != 1:
        return
    centre, name = still.scale(centres.pop()), rate_of(still)
    met = [line for each in (still, *sketches) for line in each.obstacles.lines] + ways.lines
    every = Obstacles(ways.edge, list(dict.fromkeys(met)))
    sense = math.copysign(1.0, driver.omega)
    place = free_place(every, centre, FIRST, sense, name, sizes=(*SENSE_SIZES, *WIDER))
    if place is None:
        return
    letter, runs = place.letter(centre, name), symbols(name)
    arrow = sense_arrow(centre, place.radius, place.middle, place.span * sense, row)
    text = text_at(runs, runs, letter.centre, RATE, "tag", row)
    still.add(None, Level.GROUND, 0, [*arrow, text])
    still.tags.append(Tag(name, letter.box))
    for each in (still, *sketches):
        each.obstacles.line(place.line(centre), 0.004)
        each.obstacles.block(letter.box)
