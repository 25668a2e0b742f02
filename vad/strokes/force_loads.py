"""The loads of a mechanism at their points, in its position diagram."""

from __future__ import annotations

import cmath
from typing import TYPE_CHECKING

from vad.strokes.force_captions import ForceCaptions
from vad.strokes.force_names import ForceNames
from vad.strokes.sheet import LOADS, Arrow, Stroke, StrokePart
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.strokes.scene import Scene

#: The length of every arrow, as a share of the mechanism's.
LENGTH = 0.22


def loads_at_points(scene: Scene) -> list[Stroke]:
    """Return the arrows of all loads: each has its head at its point, a weight its tail.

    All are of one length: their sizes stand in the results.
    """
    if scene.forces is None:
        return []
    names = ForceNames(scene)
    words = ForceCaptions(scene, names)
    places = [scene.at(point) for point in scene.members.points]
    across = [place.real for place in places]
    up = [place.imag for place in places]
    length = LENGTH * abs(complex(max(across) - min(across), max(up) - min(up)))
    largest = max((abs(load.force) for load in names.loads), default=0.0)
    found = []
    for load in names.loads:
        if abs(load.force) <= NOTHING * largest:
            continue
        at, arrow = scene.at(load.point), cmath.rect(length, cmath.phase(load.force))
        ends = (at, at + arrow) if load.kind == "weight" else (at - arrow, at)
        symbol, part = names.load(load), StrokePart(names.plain_load(load), "load")
        shape, said = Arrow(*ends, "", ""), words.load(symbol, load)
        found.append(Stroke("known", symbol, shape, said, LOADS, "load", part=part))
    return found
