"""What a mechanism in the plane is made of, and how it is called: the same in all its poses."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, TypeGuard

from vad.kinematics.linkage import Bar, Slide, Step, points_of, scalar_of
from vad.strokes.sentences import Noun, Sentence
from vad.written import subscript

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.mechanisms.mechanism import Mechanism


@lru_cache(maxsize=64)
def members_of(mechanism: Mechanism) -> Members:
    """Return the members of a mechanism in the plane, found once."""
    from vad.kinematics.motion import solve

    return Members(solve(mechanism))  # any motion tells


class Members:
    """The links, slides and points of a mechanism.

    Attributes
    ----------
    unit
        The unit of lengths.
    frame, linkage
        What is solved.
    driver
        The scalar that drives it.
    points, links, slides
        The names of what is reported.
    fixed
        The fixed points by name, in the solver's unit and frame.
    bars, sliding
        All bars, and all slides of the loops.
    guides
        Those that slide on a line of the frame.
    """

    def __init__(self, motion: Motion) -> None:
        self.unit = motion.mechanism.length_unit
        self.frame, self.linkage = motion.frame, motion.linkage
        self.driver = self.linkage.driver
        self.points, self.links, self.slides = motion.points, motion.links, motion.slides
        self.fixed = self.frame.fixed
        steps = self.frame.steps
        self.bars = [step for step in steps if isinstance(step, Bar)]
        self.sliding = [step for step in dict.fromkeys(steps) if isinstance(step, Slide)]
        self.guides = [step for step in self.sliding if self.is_guide(step)]
        self._ends = motion.mechanism.links
        looped = (step for loop in self.linkage.loops for _, step in loop.steps())
        self._bases: dict[str, Bar] = {}
        for step in looped:
            if isinstance(step, Bar):
                self._bases.setdefault(step.link, step)
        self._numbers = self._numbered()

    def _numbered(self) -> dict[str, str]:
        """Return the numbers of the bodies, as textbooks have them: 1 the frame, 2 the driver."""
        names = [self.driver.name]
        for loop, unknowns in zip(self.linkage.loops, self.linkage.unknowns, strict=True):
            for chain in (loop.first, loop.second):
                names += [scalar_of(step).name for step in chain if scalar_of(step) in unknowns]
        return {name: subscript(k) for k, name in enumerate(dict.fromkeys(names), start=2)}

    def points_on(self, link: str) -> list[str]:
        """Return the points of a link that keep their places on it, those of its base first."""
        rigid = [bar for bar in self.bars if bar.link == link and isinstance(bar.length, float)]
        return list(dict.fromkeys(end for bar in rigid for end in (bar.tail, bar.head)))

    def base(self, link: str) -> Bar:
        """Return the bar of a link that its loop finds: both its ends are known before others."""
        return self._bases[link]

    def pivot(self, link: str) -> str:
        """Return the fixed point on which a link turns, or else that of the mechanism."""
        ends = (end for bar in self.bars if bar.link == link for end in (bar.tail, bar.head))
        return next((end for end in ends if end in self.fixed), self.linkage.pivot)

    def letters(self, step: Step) -> str:
        """Return the letters of a step as a reader knows them: a strut's own ends for its parts."""
        return self._ends[step.link] if self.is_strut(step) else step.ends

    def ends(self, step: Step) -> tuple[str, str]:
        """Return the two points of `letters`."""
        return points_of(self.letters(step))

    def is_strut(self, step: Step) -> TypeGuard[Bar]:
        """Tell whether a step is a link whose length changes: it begins at its sliding part."""
        return isinstance(step, Bar) and step.tail not in self.points

    def is_guide(self, step: Step) -> TypeGuard[Slide]:
        """Tell whether a step slides on a line of the frame."""
        return isinstance(step, Slide) and isinstance(step.along, float) and step.tail in self.fixed

    def drives(self, step: Step) -> bool:
        """Tell whether the driver alone moves a step."""
        return scalar_of(step) == self.driver

    def slider(self, slide: Slide) -> Noun:
        """Name what slides: in a link whose length changes, its piston."""
        name = "piston" if slide.name in self.links else slide.name.split("_")[0]
        return Noun(name, generic="slider")

    def line(self, slide: Slide) -> Noun:
        """Name the line of a slide: lever, slot, guide, or guide of A where there are several."""
        if isinstance(slide.along, str):
            return Noun(slide.along)
        if not self.is_guide(slide):
            return Noun("slot")
        several = len({guide.ends for guide in self.guides}) > 1
        return Noun("guide", of=Sentence("of point", {"head": slide.head}) if several else None)

    def symbol(self, letter: str, name: str) -> str:
        """Return a quantity with its body's number: ω₃."""
        return letter + self._numbers[name]

    def slide_symbol(self, name: str) -> str:
        """Return the symbol of a slide's position.

        That is x or y along an axis of the frame, l for a link that grows, and else s.
        """
        if name in self.links:
            return "l"
        slide = next(step for step in self.sliding if step.name == name)
        if self.is_guide(slide) and slide.along in (0.0, 90.0):
            return "x" if slide.along == 0.0 else "y"
        return "s"
