"""Where force polygons stand over a turn: each has a pole that is the same in all poses.

Under a hand that changes the rates, too, the poles move apart as far as inertia forces grow.  The
arrows on the driven body are measured by one force in all poses, which grows in the same way.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.motion import solve
from vad.kinematics.reach import closing_range
from vad.strokes.draw import parted, with_forces
from vad.strokes.force_tracks import ways_of
from vad.strokes.packing import Box, in_lines, shifts

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism
    from vad.statics.burden import Burden
    from vad.statics.forces import Forces

#: In how many poses a mechanism is solved, in each range in which it closes.
SAMPLES = 181
#: If the largest of all poses is very much larger than three in four, these decide.
USUAL, DWARFED, ABOUT = 75.0, 2.2, 1.15
#: So many times that of three poses in four is the largest force on the driven body.
BEYOND = 5.0


def usual_limit(sizes: Any, dwarfed: float = DWARFED) -> float:
    """Return the size beyond which a few poses may leave the room that is made for all others.

    They may if the largest is more than ``dwarfed`` times as large as three in four.

    Examples
    --------
    >>> usual_limit([1.0, 2.0, 2.0, 3.0]), usual_limit([1.0, 2.0, 2.0, 2.0, 90.0])
    (3.0, 2.3)
    """
    usual, most = float(np.percentile(sizes, USUAL)), float(max(sizes))
    return ABOUT * usual if most > dwarfed * usual else most


def poles_of(found: Forces[Any, Any, Any]) -> dict[int, complex]:
    """Return a pole for each dyad, in lines, so that the polygons of many poses keep apart.

    A few poses near a dead centre, in which forces are very large, do not count.

    Parameters
    ----------
    found
        The forces over a turn.
    """
    boxes: dict[int, Box] = {}
    for number, vertices in ways_of(found).items():
        each = [np.broadcast_to(np.asarray(z, complex), found.shape) for z in vertices.values()]
        places = np.array([*each, np.zeros(found.shape)])
        places = places[:, np.isfinite(places).all(axis=0)]
        if not places.size:
            places = np.zeros((1, 1), complex)
        sizes = np.abs(places).max(axis=0)
        usual = places[:, sizes <= usual_limit(sizes)]
        low, high = (complex(end(usual.real), end(usual.imag)) for end in (np.min, np.max))
        boxes[number] = low, high
    acted = [number for number, (low, high) in boxes.items() if high != low]
    moved = shifts(in_lines([boxes[number] for number in acted]))
    return dict.fromkeys(boxes, 0j) | dict(zip(acted, moved, strict=True))


def largest_on_driver(found: Forces[Any, Any, Any]) -> float:
    """Return the largest force on the driven body over a turn: its arrows are measured by it.

    Near a dead centre forces are larger still, and are drawn as long as this one.
    """
    driver = found.bodies.driver.name
    forces = [each.force for each in found.joints if driver in (each.one, each.other)]
    forces += [
        found.acts(n) for n, each in enumerate(found.acting) if each.body == driver and each.point
    ]
    sizes = np.array([np.broadcast_to(np.abs(each), found.shape) for each in forces]).max(axis=0)
    sizes = sizes[np.isfinite(sizes)]
    return (
        min(float(sizes.max()), BEYOND * float(np.percentile(sizes, USUAL))) if sizes.size else 0.0
    )


@dataclass(frozen=True)
class HandPoles:
    """The poles of a mechanism under a hand.

    Attributes
    ----------
    poles
        Those with the usual rates.
    largest
        The largest force on the driven body, with these rates.
    inertia
        The share of inertia forces in the largest sum of all that acts.
    rates
        What these grow with, at the usual rates.
    """

    poles: Mapping[int, complex]
    largest: float
    inertia: float
    rates: float

    def traced(self, inputs: Mapping[str, float]) -> dict[str, Any]:
        """Return the poles and the largest force at other rates, which may be traced.

        They have the names that they have in a scene.
        """
        if not self.inertia:
            return {"poles": self.poles, "largest": self.largest}
        factor = 1.0 - self.inertia + self.inertia / self.rates * _growth(inputs)
        poles = {number: factor * pole for number, pole in self.poles.items()}
        return {"poles": poles, "largest": factor * self.largest}


def _growth(inputs: Mapping[str, float]) -> float:
    """Return what inertia forces grow with: the square of the rate, and the second rate."""
    _, rate, second = inputs.values()
    return rate * rate + abs(second)


def hand_poles(mechanism: Mechanism, burden: Burden | None) -> HandPoles | None:
    """Return the poles of a mechanism at its usual rates, over the whole range of its driver.

    Where nothing loads it there are none.
    """
    place, rate, second = mechanism.inputs
    usual = {rate: mechanism.inputs[rate] or 1.0, second: mechanism.inputs[second]}
    ranges = closing_range(mechanism)
    places = np.concatenate([np.linspace(low, high, SAMPLES) for low, high in ranges])
    given: Any = {place: places, **usual}
    _, found = parted(with_forces(solve(mechanism, **given), burden))
    if found is None:
        return None
    sizes = {True: np.zeros(places.shape), False: np.zeros(places.shape)}
    for number, each in enumerate(found.acting):
        if each.point:
            sizes[each.kind == "inertia"] += np.abs(found.acts(number))
    both = float(np.nanmax(sizes[True] + sizes[False])) or 1.0
    inertia = float(np.nanmax(sizes[True])) / both
    share, rates = min(inertia, 1.0), _growth({place: 0.0, **usual})
    return HandPoles(poles_of(found), largest_on_driver(found), share, rates)
