"""A yoke: its shaft, and the guide of the frame in which the shaft runs.

In come the place of the yoke and how far it gets, out go marks and obstacles.  The slot is that of
`vad.plan.pictures.guides`.
"""

from __future__ import annotations

from dataclasses import dataclass

from vad.plan.carriers import ends_of_travel
from vad.plan.growth import Growth
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.marks import Mark
from vad.plan.pictures import machine
from vad.plan.roles import BLOCK_RIM
from vad.plan.scale import Scale
from vad.strokes.sheet import Block

GAP = 0.012  # between the slot, farthest ahead, and the guide
HELD = 0.035  # of the shaft, farthest back
GUIDE = 0.085


@dataclass(frozen=True, slots=True)
class Yoke:
    """The parts of a yoke that are no slot: a shaft, and a bush that stands still.

    ``way`` is the direction from the slot to the bush, ``size`` that of all parts.
    """

    shaft: tuple[complex, complex]
    bush: tuple[complex, complex]
    way: complex
    size: float

    def outline(self) -> list[complex]:
        """Return the corners of the shaft."""
        return machine.bar_corners(*self.shaft, machine.SHAFT * self.size)

    def bush_marks(self, growth: Growth | None = None) -> list[Mark]:
        """Return the guide: two ground lines, hatched away from the shaft."""
        return [
            mark
            for side in (1j * self.way, -1j * self.way)
            for mark in machine.rail(*self._rail(side), side, growth, self.size)
        ]

    def block_bush(self, obstacles: Obstacles) -> None:
        """Add the guide to what labels keep clear of."""
        for side in (1j * self.way, -1j * self.way):
            thick = machine.TICK_DEPTH * self.size / 2
            start, end = (end + thick * side for end in self._rail(side))
            obstacles.line([start - 0.006 * self.way, end + 0.006 * self.way], thick + PIXEL)

    def _rail(self, side: complex) -> tuple[complex, complex]:
        away = (machine.SHAFT / 2 * self.size + BLOCK_RIM) * side
        return self.bush[0] + away, self.bush[1] + away


def yoke_of(block: Block, scale: Scale, size: float) -> Yoke:
    """Return the yoke that slides as ``block`` does; its guide is ahead of all its places."""
    way, at = block.direction, scale(block.at)
    back, ahead = (scale(end) for end in ends_of_travel(block))
    half = machine.slot_width(size) / 2
    bush = ahead + (half + GAP) * way
    shaft = at + half * way, at + (ahead - back) + (half + GAP + HELD) * way
    return Yoke(shaft, (bush, bush + GUIDE * size * way), way, size)
