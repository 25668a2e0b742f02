"""What the solver passes on: a pose, its rates, and the components of one step's motion."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from vad.kinematics.numbers import Number

ComponentName = Literal["normal", "tangential", "coriolis", "sliding"]


#: The link that stands still, along the frame's x axis; seen from another link it turns.
GROUND = "ground"


class Component(NamedTuple):
    """One part of a step's velocity or acceleration: ``amount`` along the unit ``direction``.

    ``name`` is the textbook's: normal, tangential, coriolis or sliding.  An ``amount`` of None
    stands for the unknown one, of which only the direction is known yet.
    """

    name: ComponentName
    direction: Number
    amount: Number | None


@dataclass(slots=True)
class Pose:
    """Where everything is: unit vectors of links (and of the ground), lengths of slides.

    That of a link runs along the bar by which it is found: `ReferenceFrame.unit` is the link's own.
    ``sine`` holds, loop by loop, the sine of the angle at which its construction lines cross.
    ``leaning`` holds the unit vectors of bars as seen along the guides on which they end, where
    those are turned against the frame: their angles lose no digit by turning there and back.
    """

    unit: dict[str, Number]
    length: dict[str, Number]
    sine: list[Number]
    leaning: dict[str, Number] = field(default_factory=dict)

    def all(self) -> list[Number]:
        """Return all that it holds."""
        return [
            *self.unit.values(),
            *self.length.values(),
            *self.leaning.values(),
            *self.sine,
        ]


@dataclass(slots=True)
class Rates:
    """First or second derivatives: of every link's angle and of every slide's length."""

    turning: dict[str, Number]
    sliding: dict[str, Number]

    def seen_from(self, link: str) -> Rates:
        """Return the rates as seen from a link, about which the ground turns the other way."""
        spin = self.turning[link]
        turning = {name: rate - spin for name, rate in self.turning.items() if name != link}
        return Rates({**turning, link: 0.0, GROUND: -spin}, self.sliding)

    def all(self) -> list[Number]:
        """Return all that it holds."""
        return [*self.turning.values(), *self.sliding.values()]
