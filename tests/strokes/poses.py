"""Sheets of every mechanism: with rods, in both assemblies, over whole turns, at rest."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

import vad
from tests.kinds import SPACE
from vad.kinematics.reach import closing_range
from vad.strokes.sheet import Sheet

RAMS = {
    "crank-slotted-lever": {"rod": 100.0, "ram_height": 180.0},
    "whitworth": {"rod": 300.0},
}
#: Mechanisms by an id: each kind, and those that can have a ram with it.
MECHANISMS: dict[str, Any] = {
    f"{name}{' with ram' if lengths else ''}{'' if assembly == 'open' else ' crossed'}": cls(
        assembly=assembly, **lengths
    )
    for name, cls in vad.MECHANISMS.items()
    for lengths in ({}, *([RAMS[name]] if name in RAMS else []))
    for assembly in ("open", "crossed")
}
#: Those of them that move in space.
IN_SPACE = {key: each for key, each in MECHANISMS.items() if each.name in SPACE}
#: First and second rate of the driver, as multiples of the mechanism's own first.
RATES = ((1.0, 0.0), (-1.0, 2.5), (0.0, 1.0), (0.0, 0.0))


@cache
def sheets(mechanism: Any, steps: int = 5, **options: Any) -> tuple[Sheet, ...]:
    """Return the sheets of a turn, or of the whole range of a slide, for all `RATES`."""
    return tuple(_drawn(mechanism, steps, options))


def _drawn(mechanism: Any, steps: int, options: Any) -> Iterator[Sheet]:
    place, *rates = mechanism.inputs
    for low, high in closing_range(mechanism):
        for step in range(steps):
            at = low + (high - low) * step / steps
            for given in RATES:
                own = [share * mechanism.inputs[rates[0]] for share in given]
                inputs = {place: at, **dict(zip(rates, own, strict=True))}
                try:
                    yield vad.draw(vad.solve(mechanism, **inputs), **options)
                except vad.DeadCentreError:
                    continue
