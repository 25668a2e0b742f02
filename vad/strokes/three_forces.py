"""Members with three forces: in equilibrium their lines meet in one point.

One load acts on a dyad, and the body that bears it hangs by a pin.  The other half then has two
forces only, and the line of these is known.  It meets the line of the load in a point O, through
which the force in the pin must pass, too (S. S. Rattan, Theory of Machines, static force analysis).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from vad.kinematics.numbers import cross
from vad.strokes.vector_equations import NOTHING

if TYPE_CHECKING:
    from vad.statics.dyads import DyadForces, Half, Load
    from vad.strokes.force_names import ForceNames

#: The letters of the points, those that are no point of the mechanism.
LETTERS = "OSKUVXYZ"
#: The sine of the angle of two lines that are too nearly parallel to be crossed with a pencil.
PARALLEL = 0.02
#: How far such a point may lie outside the mechanism, as a share of the mechanism's size.
FAR = 1.0


@dataclass(frozen=True)
class ThreeForces:
    """The point in which the three forces on a member meet.

    Attributes
    ----------
    load
        The load.
    held, other
        The half of the dyad that bears the load, and the one with two forces only.
    joint
        A point of the line of the force between both.
    start
        A point of the line of the load: that at which it acts, or with a couple on its body the
        place at which the load alone has the moment of both.
    at
        The point in which the lines meet, in the user's unit.
    """

    load: Load
    held: Half
    other: Half
    joint: str
    start: complex
    at: complex


def three_forces(dyad: DyadForces, names: ForceNames) -> ThreeForces | None:
    """Return the point of a dyad in which three forces meet; None where there is no such point.

    There is none with more than one load, with a couple on another body, if the loaded body hangs
    on a guide, or if the lines meet too far away to be drawn.
    """
    largest = max(abs(half.outer.force) for half in (dyad.first, dyad.second))
    loaded = [
        (half, other, load)
        for half, other in ((dyad.first, dyad.second), (dyad.second, dyad.first))
        for load in half.loads
        if abs(load.force) > NOTHING * largest
    ]
    if len(loaded) != 1 or loaded[0][1].couples:
        return None
    ((held, other, load),) = loaded
    alone = len(held.bodies) == 1 and names.inner(held)
    if not alone or abs(held.known) <= NOTHING * largest or abs(other.known) > NOTHING * largest:
        return None
    scene, joint = names.scene, dyad.inner.point
    start, pin, through = (scene.at(point) for point in (load.point, held.outer.point, joint))
    moved = names.arm(load)
    if held.couples and not moved:
        return None
    start += moved[1] if moved else 0j
    way = load.force / abs(load.force)
    sine = cross(way, other.direction)
    if abs(sine) < PARALLEL:
        return None
    at = start + way * (cross(through - start, other.direction) / sine)
    places = [scene.at(point) for point in scene.members.points]
    xs, ys = [place.real for place in places], [place.imag for place in places]
    reach = FAR * abs(complex(max(xs) - min(xs), max(ys) - min(ys)))
    near = min(xs) - reach <= at.real <= max(xs) + reach
    near = near and min(ys) - reach <= at.imag <= max(ys) + reach
    if not near or abs(at - pin) <= PARALLEL * reach:
        return None
    return ThreeForces(load, held, other, joint, start, complex(at))


def directed(dyad: DyadForces, found: ThreeForces, names: ForceNames) -> DyadForces:
    """Return a dyad whose force in the loaded half's pin is unknown along one line alone."""
    away = found.at - names.scene.at(found.held.outer.point)
    force, none = found.held.outer.force, 0j
    held = replace(found.held, known=none, unknown=force, direction=away / abs(away))
    if dyad.first is found.held:
        return replace(dyad, first=held)
    return replace(dyad, second=held)
