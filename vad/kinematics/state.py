"""What the solver passes on: a pose, its rates, and the components of one step's motion."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from vad.kinematics import chunks
from vad.kinematics.linkage import Scalar, angle_of, length_of
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

    ``sine`` holds, loop by loop, the sine of the angle at which its construction lines cross.
    ``leaning`` holds the unit vectors of bars as seen along the guides on which they end, where
    those are turned against the frame: their angles lose no digit by turning there and back.
    """

    unit: dict[str, Number]
    length: dict[str, Number]
    sine: list[Number]
    leaning: dict[str, Number] = field(default_factory=dict)

    def flat(self) -> dict[Any, Number]:
        """Return all values in one dictionary."""
        units = {angle_of(name): value for name, value in self.unit.items()}
        lengths = {length_of(name): value for name, value in self.length.items()}
        leaning = {Scalar("leaning", name): value for name, value in self.leaning.items()}
        return units | lengths | leaning | dict(enumerate(self.sine))

    @classmethod
    def of(cls, values: dict[Any, Number]) -> Pose:
        """Return the pose whose `flat` is ``values``."""
        pose = cls({}, {}, [])
        kinds = {"angle": pose.unit, "length": pose.length, "leaning": pose.leaning}
        for key, value in values.items():
            if isinstance(key, Scalar):
                kinds[key.kind][key.name] = value
            else:
                pose.sine.append(value)
        return pose

    def cut(self, part: slice) -> Pose:
        """Return the poses in ``part``."""
        sines = chunks.cut(dict(enumerate(self.sine)), part)
        return Pose(
            chunks.cut(self.unit, part),
            chunks.cut(self.length, part),
            list(sines.values()),
            chunks.cut(self.leaning, part),
        )


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

    def flat(self) -> dict[Scalar, Number]:
        """Return all values in one dictionary."""
        turning = {angle_of(name): value for name, value in self.turning.items()}
        return turning | {length_of(name): value for name, value in self.sliding.items()}

    @classmethod
    def of(cls, values: dict[Scalar, Number]) -> Rates:
        """Return the rates whose `flat` is ``values``."""
        rates = cls({}, {})
        for key, value in values.items():
            (rates.turning if key.kind == "angle" else rates.sliding)[key.name] = value
        return rates

    def cut(self, part: slice) -> Rates:
        """Return the rates of the poses in ``part``."""
        return Rates(chunks.cut(self.turning, part), chunks.cut(self.sliding, part))
