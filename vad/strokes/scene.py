"""One pose as the board sees it: letters, numbers and coordinates in the user's units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeGuard

from vad.kinematics.linkage import (
    Bar,
    Scalar,
    Slide,
    Step,
    angle_of,
    length_of,
    points_of,
    scalar_of,
)
from vad.strokes.figures import Figure, Figures
from vad.strokes.language import Language, Noun
from vad.strokes.said import filled
from vad.strokes.sheet import Cell, Row
from vad.written import PRIME, per_second, subscript

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.kinematics.state import Rates
    from vad.strokes.diagram import Diagram, Drawing

#: A point so near to the line of two others, as a sine, lies on it.
IN_LINE = 1e-9
#: A link that turns no faster than this, beside the fastest, is only moved along.
STILL = 1e-9


@dataclass(frozen=True)
class Scene:
    """A motion, the language of its captions, and the names of everything in it."""

    motion: Motion
    language: Language
    figures: Figures = field(default_factory=Figures)

    @property
    def unit(self) -> str:
        """The unit of lengths."""
        return self.motion.mechanism.length_unit

    def drawing(self, diagram: Diagram) -> Drawing:
        """Return what is drawn in a kind of diagram."""
        return diagram.pose(self)

    def unit_of(self, diagram: Diagram) -> str:
        """Return the unit of a diagram's coordinates."""
        return diagram.unit(self)

    def cells(self, diagram: Diagram, key: str) -> tuple[Cell, ...]:
        """Return what a diagram measures of a slide or link."""
        return (diagram.slide if key in self.motion.slides else diagram.link)(self, key)

    def tracks(self, diagram: Diagram) -> Mapping[str, Any]:
        """Return where the lettered points of a diagram are."""
        return diagram.tracks(self)

    def rows(self, diagrams: Sequence[Diagram]) -> list[Row]:
        """Return the rows of the results: the links, then the slides."""
        motion, say = self.motion, self.language.name
        rows = []
        for name in motion.links:
            cells = {diagram.name: diagram.link(self, name) for diagram in diagrams}
            rows.append(Row(name, say(name), motion.mechanism.links[name], cells))
        for name in motion.slides:
            cells = {diagram.name: diagram.slide(self, name) for diagram in diagrams}
            strut = motion.mechanism.links.get(name)  # a link that grows has its stroke
            title = say("stroke" if strut else name.split("_", maxsplit=1)[0])
            rows.append(Row(name, title, strut or motion.mechanism.slides[name], cells))
        return rows

    @property
    def output(self) -> str:
        """The row of what the mechanism is there for.

        That is the last slide on a guide of the frame, else the last link that turns.
        """
        import numpy as np  # which a list of mechanisms need not load

        motion, driver = self.motion, self.driver.name
        guided = {step.name for step in motion.frame.steps if self.is_guide(step)}
        slides = [name for name in motion.slides if name in guided and name != driver]
        rates = {name: np.nanmax(np.abs(motion.link(name).omega)) for name in motion.links}
        turning = [name for name, rate in rates.items() if rate > STILL * max(rates.values())]
        links = [name for name in turning if name != driver]
        return (slides or links or [driver])[-1]

    def outward(self, vector: complex) -> complex:
        """Turn a vector of the solver into the user's frame and unit."""
        frame = self.motion.frame
        return complex(vector * frame.turn * frame.scale)

    def heading(self, direction: complex) -> complex:
        """Turn a unit vector of the solver into the user's frame."""
        return complex(direction * self.motion.frame.turn)

    def at(self, point: str) -> complex:
        """Return where a point is, in the user's frame and unit."""
        return complex(self.motion.read(("point", point, "position")))

    def measured(self, value: float, unit: str, power: int = 1) -> Figure:
        """Return a number of a link's shape: as given where it is short, as somebody writes it."""
        return Figure(value, unit, abs(value - float(f"{value:.6g}")) <= 1e-12 * abs(value), power)

    def span(self, point: str, other: str) -> float:
        """Return the distance of two points."""
        return abs(self.at(other) - self.at(point))

    def size(self, bar: Bar) -> float:
        """Return the length of a bar in the user's unit, without its sign."""
        frame = self.motion.frame
        return abs(float(frame.size(bar, self.motion.pose))) * frame.scale

    @property
    def slides(self) -> list[Slide]:
        """All slides of the loops."""
        steps = dict.fromkeys(self.motion.frame.steps)
        return [step for step in steps if isinstance(step, Slide)]

    def points_on(self, link: str) -> list[str]:
        """Return the points of a link that keep their places on it, those of its base first."""
        bars = [step for step in self.motion.frame.steps if isinstance(step, Bar)]
        rigid = [bar for bar in bars if bar.link == link and isinstance(bar.length, float)]
        return list(dict.fromkeys(end for bar in rigid for end in (bar.tail, bar.head)))

    def in_line(self, link: str, point: str) -> bool:
        """Tell whether a point of a link lies in line with the two that its loop finds."""
        base = self.base(link)
        one, other, third = map(self.at, (base.tail, base.head, point))
        across = ((other - one).conjugate() * (third - one)).imag
        return abs(across) <= IN_LINE * abs(other - one) * abs(third - one)

    def backward(self, bar: Bar) -> bool:
        """Tell whether a bar, whose length is a slide's position, points against its link."""
        return isinstance(bar.length, str) and self.motion.slide(bar.length).position < 0.0

    def against(self, bar: Bar) -> bool:
        """Tell whether a bar points against the one that its link is found by."""
        base = self.base(bar.link)
        known, own = (self.at(each.head) - self.at(each.tail) for each in (base, bar))
        return (own * known.conjugate()).real < 0.0

    def base(self, link: str) -> Bar:
        """Return the bar of a link that its loop finds: both its ends are known before others."""
        steps = (step for loop in self.motion.linkage.loops for _, step in loop.steps())
        return next(step for step in steps if isinstance(step, Bar) and step.link == link)

    def pivot(self, link: str) -> str:
        """Return the fixed point on which a link turns, or else that of the mechanism."""
        bars = (step for step in self.motion.frame.steps if isinstance(step, Bar))
        ends = (end for bar in bars if bar.link == link for end in (bar.tail, bar.head))
        return next(
            (end for end in ends if end in self.motion.frame.fixed), self.motion.linkage.pivot
        )

    def travel(self, name: str) -> tuple[float, float]:
        """Return how far a slide gets from where it is, back (negative) and ahead."""
        slide = self.motion.slide(name)
        least, most = (end - slide.position for end in slide.travel)
        return min(0.0, least), max(0.0, most)  # which passes over NaN

    def cylinder(self, bar: Bar) -> float:
        """Return the length of a link's cylinder, which has room for its rod; else 0."""
        if bar.length != bar.link:
            return 0.0
        _, longest = self.motion.slide(str(bar.length)).travel
        return min(0.9 * self.size(bar), longest / 2)  # which passes over NaN

    def letters(self, step: Step) -> str:
        """Return the letters of a step as a reader knows them: a strut's own ends for its parts."""
        return self.motion.mechanism.links[step.link] if self.is_strut(step) else step.ends

    def ends(self, step: Step) -> tuple[str, str]:
        """Return the two points of `letters`."""
        return points_of(self.letters(step))

    def is_strut(self, step: Step) -> TypeGuard[Bar]:
        """Tell whether a step is a link whose length changes: it begins at its sliding part."""
        return isinstance(step, Bar) and step.tail not in self.motion.points

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

    def slide_symbol(self, name: str) -> str:
        """Return the symbol of a slide's position.

        That is x or y along an axis of the frame, l for a link that grows, and else s.
        """
        if name in self.motion.links:
            return "l"
        steps = self.motion.frame.steps
        slide = next(step for step in steps if isinstance(step, Slide) and step.name == name)
        if self.is_guide(slide) and slide.along in (0.0, 90.0):
            return "x" if slide.along == 0.0 else "y"
        return "s"

    @property
    def driver(self) -> Scalar:
        """The scalar that drives the mechanism."""
        return self.motion.linkage.driver

    def drives(self, step: Step) -> bool:
        """Tell whether the driver alone moves a step."""
        return scalar_of(step) == self.driver

    def say(self, phrase: str, **parts: object) -> str:
        """Fill in a phrase, in which the places of numbers and units are kept."""
        return filled(self.language, self.figures, phrase, parts)

    def figure(self, scalar: Scalar, value: float, unit: str = "", power: int = 1) -> Figure:
        """Return a number of a scalar or its rates, which is given for the driver."""
        return Figure(value, unit, scalar == self.driver, power)

    def spin(self, link: str, order: int, power: int = 1) -> Figure:
        """Return ω (1) or α (2) of a link, without its sign."""
        return self.figure(angle_of(link), abs(self.rate(link, order)), power=power)

    def length(self, bar: Bar, unit: str, power: int = 1) -> Figure:
        """Return the length of a bar, which is given unless it is that of a slide to be found."""
        given = isinstance(bar.length, float) or length_of(bar.length) == self.driver
        return Figure(self.size(bar), unit, given, power)

    @cached_property
    def _velocity(self) -> Rates:
        return self.motion.velocity

    @cached_property
    def _acceleration(self) -> Rates:
        return self.motion.acceleration

    def orders(self, order: int) -> tuple[Rates, ...]:
        """Return the rates up to an order, solved for no further than that."""
        return (self._velocity,) if order == 1 else (self._velocity, self._acceleration)

    def rate(self, name: str, order: int) -> float:
        """Return ω or α of a link."""
        return float(self.orders(order)[-1].turning[name])

    def speed(self, name: str, order: int) -> float:
        """Return the velocity or acceleration of a slide in the user's unit."""
        return float(self.orders(order)[-1].sliding[name]) * self.motion.frame.scale

    def line(self, slide: Slide) -> Noun:
        """Name the line of a slide: lever, slot, guide, or guide of A where there are several."""
        noun = self.language.noun
        if isinstance(slide.along, str):
            return noun(slide.along)
        if not self.is_guide(slide):
            return noun("slot")
        guides = {step.ends for step in self.motion.frame.steps if self.is_guide(step)}
        of = self.language.say("of point", head=slide.head) if len(guides) > 1 else ""
        return noun("guide", of)

    def slider(self, slide: Slide) -> str:
        """Name what slides: in a link whose length changes, its piston."""
        return "piston" if slide.name in self.motion.links else slide.name.split("_")[0]

    def is_guide(self, step: Step) -> TypeGuard[Slide]:
        """Tell whether a step slides on a line of the frame."""
        return (
            isinstance(step, Slide)
            and isinstance(step.along, float)
            and step.tail in self.motion.frame.fixed
        )

    def rate_unit(self, order: int) -> str:
        """Return the unit of a velocity (1) or acceleration (2)."""
        return per_second(self.unit, order)


def image_letter(letter: str, order: int) -> str:
    """Return the letter of a point's image: b in the velocity polygon, b′ in the next."""
    return letter.lower() + PRIME * (order - 1)


def point_of(image: str) -> str:
    """Return the point whose image a vertex is: B of b′."""
    return image.rstrip(PRIME).upper()
