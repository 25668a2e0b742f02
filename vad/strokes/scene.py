"""One pose as the board sees it: letters, numbers and coordinates in the user's units."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, TypeGuard

from vad.kinematics.linkage import Bar, Scalar, Slide, Step, length_of, scalar_of
from vad.strokes.language import Language
from vad.written import PRIME, number, per_second, subscript

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.kinematics.state import Rates


@dataclass(frozen=True)
class Scene:
    """A motion, the language of its captions, and the names of everything in it."""

    motion: Motion
    language: Language

    @property
    def unit(self) -> str:
        """The unit of lengths."""
        return self.motion.mechanism.length_unit

    def outward(self, vector: complex) -> complex:
        """Turn a vector of the solver into the user's frame and unit."""
        frame = self.motion.frame
        return complex(vector * frame.turn * frame.scale)

    def heading(self, direction: complex) -> complex:
        """Turn a unit vector of the solver into the user's frame."""
        return complex(direction * self.motion.frame.turn)

    def size(self, bar: Bar) -> float:
        """Return the length of a bar in the user's unit, without its sign."""
        frame = self.motion.frame
        return abs(float(frame.size(bar, self.motion.pose))) * frame.scale

    def travel(self, name: str) -> tuple[float, float]:
        """Return how far a slide gets from where it is, back (negative) and ahead."""
        slide = self.motion.slide(name)
        least, most = (end - slide.position for end in slide.travel)
        return min(0.0, least), max(0.0, most)  # which passes over NaN

    def cylinder(self, bar: Bar) -> float:
        """Return the length of a strut's cylinder, which has room for its rod; else 0."""
        if not self.is_strut(bar):
            return 0.0
        _, longest = self.motion.slide(str(bar.length)).travel
        return min(0.9 * self.size(bar), longest / 2)  # which passes over NaN

    def letters(self, step: Step) -> str:
        """Return the letters of a step as a reader knows them: a strut's own ends for its parts."""
        return self.motion.mechanism.links[step.link] if self.is_strut(step) else step.ends

    def is_strut(self, step: Step) -> TypeGuard[Bar]:
        """Tell whether a step is a link whose length changes: it begins at its sliding part."""
        return isinstance(step, Bar) and step.ends[0] not in self.motion.points

    @cached_property
    def _numbers(self) -> dict[str, int]:
        """Number the bodies as textbooks do: 1 is the frame, 2 the driver."""
        linkage = self.motion.linkage
        names = [linkage.driver.name]
        for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True):
            for chain in (loop.first, loop.second):
                names += [scalar_of(step).name for step in chain if scalar_of(step) in unknowns]
        return {name: number for number, name in enumerate(dict.fromkeys(names), start=2)}

    def symbol(self, letter: str, name: str) -> str:
        """Return a quantity with its body's number: ω₃."""
        return letter + subscript(self._numbers[name])

    @property
    def driver(self) -> Scalar:
        """The scalar that drives the mechanism."""
        return self.motion.linkage.driver

    def drives(self, step: Step) -> bool:
        """Tell whether the driver alone moves a step."""
        return scalar_of(step) == self.driver

    def write(self, scalar: Scalar, value: float) -> str:
        """Write a number: as it was given for the driver, with four digits for the rest."""
        return number(value, given=scalar == self.driver)

    def write_size(self, bar: Bar) -> str:
        """Write the length of a bar, which is given unless it is that of a slide to be found."""
        is_given = isinstance(bar.length, float) or length_of(bar.length) == self.driver
        return number(self.size(bar), given=is_given)

    def orders(self, order: int) -> tuple[Rates, ...]:
        """Return the rates up to an order, solved for no further than that."""
        motion = self.motion
        return (motion.velocity,) if order == 1 else (motion.velocity, motion.acceleration)

    def rate(self, name: str, order: int) -> float:
        """Return ω or α of a link."""
        return float(self.orders(order)[-1].turning[name])

    def speed(self, name: str, order: int) -> float:
        """Return the velocity or acceleration of a slide in the user's unit."""
        return float(self.orders(order)[-1].sliding[name]) * self.motion.frame.scale

    def line_name(self, slide: Slide) -> str:
        """Name the line of a slide in a sentence: the guide, the lever, the slot."""
        return self._line("the ", slide)

    def line_label(self, slide: Slide) -> str:
        """Name the line of a slide beside its construction line: ∥ guide."""
        return self._line("∥ ", slide)

    def _line(self, start: str, slide: Slide) -> str:
        say = self.language.say
        if isinstance(slide.along, str):
            return say(f"{start}link", link=slide.along)
        if not self.is_guide(slide):
            return say(f"{start}slot")
        guides = {step.ends for step in self.motion.frame.steps if self.is_guide(step)}
        if len(guides) > 1:
            return say(f"{start}guide of", head=slide.ends[1])
        return say(f"{start}guide")

    def is_guide(self, step: Step) -> bool:
        """Tell whether a step slides on a line of the frame."""
        return (
            isinstance(step, Slide)
            and isinstance(step.along, float)
            and step.ends[0] in self.motion.frame.fixed
        )

    def rate_unit(self, order: int) -> str:
        """Return the unit of a velocity (1) or acceleration (2)."""
        return per_second(self.unit, order)


def image_letter(letter: str, order: int) -> str:
    """Return the letter of a point's image: b in the velocity polygon, b′ in the next."""
    return letter.lower() + PRIME * (order - 1)
