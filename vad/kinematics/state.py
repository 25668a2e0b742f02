"""A pose, its rates, and the components of the motion of one bar or slide."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, NamedTuple

from vad.kinematics.numbers import Number

ComponentName = Literal["normal", "tangential", "coriolis", "sliding"]


#: The frame as a link: it lies along the x axis and stands still, but seen from another link it
#: turns.
GROUND = "ground"


class MotionComponent(NamedTuple):
    """One component of a velocity or acceleration: ``amount`` along the unit vector ``direction``.

    Its ``name`` is normal, tangential, coriolis or sliding.  The ``amount`` of an unknown component
    is None; only its direction is known.
    """

    name: ComponentName
    direction: Number
    amount: Number | None


@dataclass(slots=True)
class Pose:
    """Where everything is.

    Attributes
    ----------
    unit
        The unit vector of each link and of the ground.  It points along the bar by which the link
        is found; `vad.kinematics.frame.ReferenceFrame.unit` gives that of the link itself.
    length
        The length of each slide.
    sine
        For each loop, the sine of the angle at which its construction lines cross.
    leaning
        The unit vectors of bars that end on a guide which is turned against the frame, in the axes
        of that guide.  An angle read from them has no rounding from turning there and back.
    parts_of_unit, parts_of_length
        A unit vector or a length as a part of few digits and a rest, where more digits of it are
        known than a double holds.
    """

    unit: dict[str, Number]
    length: dict[str, Number]
    sine: list[Number]
    leaning: dict[str, Number] = field(default_factory=dict)
    parts_of_unit: dict[str, tuple[Number, Number]] = field(default_factory=dict)
    parts_of_length: dict[str, tuple[Number, Number]] = field(default_factory=dict)

    def all(self) -> list[Number]:
        """Return all that it holds."""
        return [
            *self.unit.values(),
            *self.length.values(),
            *self.leaning.values(),
            *self.sine,
            *(x for parts in self.parts_of_unit.values() for x in parts),
            *(x for parts in self.parts_of_length.values() for x in parts),
        ]


@dataclass(slots=True)
class Rates:
    """First or second derivatives of the angle of every link and the length of every slide.

    Attributes
    ----------
    turning
        The rate of each link.
    sliding
        The rate of each slide.
    against
        The rates that were found as seen from another link: by link, that other link and the rate.
        Links that turn almost as one have digits here that a difference of their rates has lost.
    """

    turning: dict[str, Number]
    sliding: dict[str, Number]
    against: dict[str, tuple[str, Number]] = field(default_factory=dict)

    def between(self, link: str, other: str) -> Number:
        """Return the rate of a link as seen from another one."""
        rates: dict[str, Number] = {link: 0.0}  # of the first link, seen from those on its way
        # Each round goes on to another body; every one is seen from an earlier one.
        while link in self.against:
            seen_from, rate = self.against[link]
            rates[seen_from] = rates[link] + rate
            link = seen_from
        back, end = 0.0, other
        # Each round goes on to another body, too.
        while end not in rates and end in self.against:
            end, rate = self.against[end]
            back = back + rate
        if end in rates:
            return rates[end] - back
        first = next(iter(rates))
        return self.turning[first] - self.turning[other]

    def seen_from(self, link: str) -> Rates:
        """Return the rates as seen from a link; from there the ground turns the other way."""
        turning = {name: self.between(name, link) for name in self.turning if name != link}
        return Rates({**turning, link: 0.0, GROUND: -self.turning[link]}, self.sliding)

    def all(self) -> list[Number]:
        """Return all that it holds."""
        seen = [rate for _, rate in self.against.values()]
        return [*self.turning.values(), *self.sliding.values(), *seen]
