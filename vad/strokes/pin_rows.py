"""The rows of the results table that say how fast pins rub in their holes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from vad.kinematics.bodies import bodies_of
from vad.strokes.body_names import BodyNames
from vad.strokes.diagram import VELOCITY, Diagram
from vad.strokes.sheet import Cell, Panel, Row
from vad.written import subscript

if TYPE_CHECKING:
    from vad.merits.pins import Rubbing
    from vad.strokes.scene import Scene


def pin_rows(scene: Scene, diagrams: Sequence[Diagram]) -> list[Row]:
    """Return a row for each pair of bodies that a pin joins, where velocities are drawn.

    The symbol v₂₃ has the numbers of both bodies: 1 is the frame.
    """
    names = [diagram.name for diagram in diagrams]
    if not scene.pins or VELOCITY.panel not in names:
        return []
    bodies: Any = bodies_of(scene.motion.solver.plane).bodies
    numbers, rows = BodyNames(scene, bodies).numbers, []
    for place, each in enumerate(scene.rubs):
        pair = "".join(subscript(numbers[name]) for name in (each.one, each.other))
        cell = Cell(f"v{pair}", each.velocity, scene.unit_of(VELOCITY))
        cells: dict[str, tuple[Cell, ...]] = dict.fromkeys(names, ()) | {VELOCITY.panel: (cell,)}
        rows.append(Row(_key(place), scene.name("pin"), each.pin, cells, inked=False))
    return rows


def with_pins(panel: Panel, rubs: Sequence[Rubbing]) -> Panel:
    """Return the velocity polygon in which the rubbing of a pin is known with its bodies' rates.

    Its value shows after the stroke by which the last of both rates is measured.
    """
    if panel.name != VELOCITY.panel:
        return panel
    strokes = list(panel.strokes)
    for place, each in enumerate(rubs):
        measured = [i for i, s in enumerate(strokes) if {each.one, each.other} & {*s.reveals}]
        last = max(measured, default=len(strokes) - 1)
        strokes[last] = replace(strokes[last], reveals=(*strokes[last].reveals, _key(place)))
    return replace(panel, strokes=tuple(strokes))


def _key(place: int) -> str:
    return f"pin {place + 1}"
