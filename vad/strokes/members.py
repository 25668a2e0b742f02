"""The members of a mechanism in the plane: its links, slides and points, with their symbols.

They are the same in all poses, so they are found once.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, TypeGuard

from vad.errors import InputError
from vad.kinematics.linkage import (
    Bar,
    Linkage,
    Slide,
    Step,
    angle_of,
    points_of,
    scalar_of,
    scalars_of,
)
from vad.strokes.sentences import Noun, Sentence
from vad.written import LOW, numbered, subscript

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.mechanisms.mechanism import Mechanism
    from vad.strokes.diagram import Order


def _check_drawable(linkage: Linkage) -> None:
    """Refuse a known vector that a chain reaches over one that the loop has yet to find.

    The polygons begin with what is known, and the lines of the unknown vectors cross at the end.

    Raises
    ------
    vad.errors.InputError
        For such a vector; it names the link or slide.
    """
    known = {linkage.driver}
    for number, (loop, unknowns) in enumerate(
        zip(linkage.loops, linkage.unknowns, strict=True), start=1
    ):
        for chain in (loop.first, loop.second):
            beyond = ""
            for step in chain:
                name = step.link if isinstance(step, Bar) else step.name
                found = scalars_of(step) <= known
                if beyond and (found or (isinstance(step, Bar) and angle_of(step.link) in known)):
                    raise InputError(
                        f"loop {number}: {name} is known, but hangs on {beyond}, which is not: "
                        "such a loop is solved, but cannot be drawn yet",
                        hint="drive a link or a slide of the frame",
                    )
                beyond = beyond or ("" if found else name)
        known.update(unknowns)
    steps = [step for loop in linkage.loops for _, step in loop.steps()]
    carried = {step.head for step in steps if isinstance(step, Slide)}
    moved = {step.head for step in steps} - set(linkage.fixed)
    for step in steps:
        if not isinstance(step, Slide) or isinstance(step.along, str):
            continue
        if step.tail in moved and step.tail not in carried:
            raise InputError(
                f"{step.name}: its line hangs on {step.tail}, which does not slide: such a line "
                "is solved, but cannot be drawn yet",
                hint="let the line begin at a slider, or turn with a link",
            )


@lru_cache(maxsize=64)
def members_of(mechanism: Mechanism) -> Members:
    """Return the members of a mechanism in the plane, found once."""
    from vad.kinematics.motion import solve

    return Members(solve(mechanism))  # they are the same in any motion


class Members:
    """The links, slides and points of a mechanism.

    Attributes
    ----------
    unit, names
        The unit of lengths, and the names that the mechanism brings in other languages.
    frame, linkage
        What is solved.
    driver
        The scalar that drives it.
    points, links, slides
        The names of the points, links and slides of the results.
    fixed
        The fixed points by name, in the solver's unit and frame.
    bars, sliding
        All bars, and all slides of the loops.
    guides
        The slides along a line of the frame.
    """

    def __init__(self, motion: Motion) -> None:
        _check_drawable(motion.linkage)
        self.unit, self.names = motion.mechanism.length_unit, motion.mechanism.own_names
        self.frame, self.linkage = motion.frame, motion.linkage
        self.driver = self.linkage.driver
        self.points, self.links, self.slides = motion.points, motion.links, motion.slides
        self.fixed = self.frame.fixed
        steps = self.frame.steps
        self.bars = [step for step in steps if isinstance(step, Bar)]
        self.sliding = [step for step in dict.fromkeys(steps) if isinstance(step, Slide)]
        self.guides = [step for step in self.sliding if self.is_guide(step)]
        self._ends = motion.mechanism.links
        self._points = motion.mechanism.slides
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
        """Return the bar by which a loop finds a link: its ends are known before other points."""
        return self._bases[link]

    def pivot(self, link: str) -> str:
        """Return the fixed point about which a link turns, else the pivot of the linkage."""
        ends = (end for bar in self.bars if bar.link == link for end in (bar.tail, bar.head))
        return next((end for end in ends if end in self.fixed), self.linkage.pivot)

    def letters(self, step: Step) -> str:
        """Return the letters of a step for readers: those of the strut for its parts."""
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

    def number(self, name: str) -> int:
        """Return the number of a body; 0 for one that the results do not number."""
        return int(numbered(self.symbol("F", name))[1]) if name in self._numbers else 0

    def slide_symbol(self, name: str) -> str:
        """Return the symbol of a slide's position.

        That is x or y along an axis of the frame, l for a link that grows, and else s.  Where
        several slides would have the same one, it has the point as its index: x_B.
        """
        letters = {slide: self.slide_letter(slide) for slide in self.slides}
        alike = [slide for slide in letters if letters[slide] == letters[name]]
        return letters[name] + (self._index(name) if len(alike) > 1 else "")

    def slide_letter(self, name: str) -> str:
        """Return the letter of a slide's position: x, y, l or s."""
        if name in self.links:
            return "l"
        slide = next(step for step in self.sliding if step.name == name)
        if self.is_guide(slide) and slide.along in (0.0, 90.0):
            return "x" if slide.along == 0.0 else "y"
        return "s"

    def rate_symbol(self, name: str, order: Order) -> str:
        """Return the symbol of a slide's velocity or acceleration: v, or v_A where A is not alone.

        What slides on a moving link has v without an index, as in 2ωv, if it is the only one.
        """
        guided = {guide.name for guide in self.guides}
        alike = [each for each in self.slides if each not in guided]
        alone = len(self.slides) == 1 or (name not in guided and len(alike) == 1)
        return order.sliding + ("" if alone else self._index(name))

    def _index(self, name: str) -> str:
        """Return what tells the symbol of a slide from others: its point, standing low."""
        point = self._points.get(name) or points_of(self._ends[name])[-1]
        return f"_{point[0]}" + point[1:].translate(LOW)
