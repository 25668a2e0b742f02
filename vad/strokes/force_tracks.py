"""Over a turn: the ways of the vertices of force polygons, each about a pole that stands still.

The loads of a dyad begin at its pole.  So the vertex in which its polygon closes runs on the polar
diagram of the force in the first outer joint, and that of the second one where the loads stay as
they are.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.strokes.diagram import Spot
from vad.strokes.force_names import ForceNames
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.statics.forces import Forces


def ways_of(found: Forces[Any, Any, Any]) -> dict[int, dict[str, Any]]:
    """Return the vertices of each dyad, about its pole, by the names that the vectors have.

    Returns
    -------
    dict
        By the number of the dyad: "X", in which the polygon closes, and the heads of loads, "1",
        "2" … in their order.  Complex numbers in newtons, or arrays of many poses.
    """
    from vad.statics.dyads import chains_of  # most drawings have no forces

    ways: dict[int, dict[str, Any]] = {}
    dyads = [dyad.loop for dyad in reversed(found.bodies.dyads)]
    for number, (outer, loads) in zip(dyads, chains_of(found), strict=True):
        tip: Any = 0j
        ways[number] = {"X": -outer.force}
        for place, load in enumerate(loads, start=1):
            tip = tip + load.force
            ways[number][str(place)] = tip
    return ways


def _most(way: Any) -> float:
    """Return the largest size of a force over a turn; 0 where it is nowhere a number."""
    sizes = np.abs(np.atleast_1d(way))
    return float(sizes[np.isfinite(sizes)].max(initial=0.0))


def force_tracks(scene: Any) -> Mapping[Spot, Any]:
    """Return where the vertices of force polygons are; none has a letter."""
    names = ForceNames(scene)
    spots: dict[Spot, Any] = {}
    bodies = names.forces.bodies
    owners = {dyad.loop: bodies.bodies[dyad.first.bodies[0]].name for dyad in bodies.dyads}
    ways = ways_of(names.forces)
    sizes = {number: max(map(_most, vertices.values())) for number, vertices in ways.items()}
    for number, vertices in ways.items():
        if sizes[number] <= NOTHING * max(sizes.values()):
            continue  # nothing acts on the dyad: it has no polygon
        for vertex, way in vertices.items():
            row = names.row(owners[number]) if vertex == "X" else None
            spot = Spot(f"{number}:{vertex}", lettered=False, row=row)
            spots[spot] = scene.poles.get(number, 0j) + way
    return spots
