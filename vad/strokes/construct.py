"""The mechanism as compasses and set square construct it: the strokes of the position diagram."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from vad.kinematics.linkage import Bar, Loop, Scalar, Slide, angle_of, scalar_of
from vad.strokes.diagram import Drawing
from vad.strokes.equations import of_position
from vad.strokes.figures import Figure, Unit
from vad.strokes.scene import Scene
from vad.strokes.sheet import (
    Arc,
    Arrow,
    Block,
    Dot,
    Guide,
    Line,
    Shape,
    Stroke,
)
from vad.written import with_unit

#: A compass arc shows this much on either side of the point that it is after, in degrees.
COMPASS = 14.0


def construct(scene: Scene) -> Drawing:
    """Return the construction of a pose."""
    return _Construction(scene).drawing()


class _Construction:
    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.motion = scene.motion
        self.frame = scene.motion.frame
        self.linkage = scene.motion.linkage
        self.strokes: list[Stroke] = []
        self.found: set[str] = set(self.frame.fixed)

    def at(self, letter: str) -> complex:
        """Return where a point is, in the user's frame and unit."""
        return complex(self.motion.read(("point", letter, "position")))

    def drawing(self) -> Drawing:
        self._frame()
        self._driver()
        known = {self.scene.driver}
        equations = []
        for loop, unknowns in zip(self.linkage.loops, self.linkage.unknowns, strict=True):
            self._construct(loop, unknowns)
            self._ink(loop, unknowns)
            known.update(unknowns)
            self._images(known)
            equations.append(of_position(self.scene, loop))
        return Drawing(tuple(self.strokes), equations=tuple(equations))

    def _draw(
        self,
        name: str,
        kind: str,
        label: str,
        shape: Shape,
        phrase: str,
        parts: Mapping[str, object],
        **more: object,
    ) -> None:
        caption = self.scene.say(phrase, **parts)
        stroke = Stroke(kind, label, shape, caption, name=name, **more)  # type: ignore[arg-type]
        self.strokes.append(stroke)

    # --- what is given ------------------------------------------------------------------------

    def _frame(self) -> None:
        """Draw the fixed pivots and the guides of the frame."""
        bars = "".join(step.ends for step in self.frame.steps if isinstance(step, Bar))
        for letter in self.motion.points:
            if letter in self.frame.fixed:
                pivot = letter in bars or letter in "".join(self.motion.mechanism.links.values())
                kind, phrase = ("fixed", "fixed") if pivot else ("pole", self._point(letter))
                parts = {"letter": letter}
                self._draw(f"{letter}.fixed", kind, letter, Dot(self.at(letter)), phrase, parts)
        for slide in self._slides():
            if self.scene.is_guide(slide):
                self._guide(slide)

    def _point(self, letter: str) -> str:
        """Return the phrase for a fixed point that is no pivot."""
        guides = [slide for slide in self._slides() if self.scene.is_guide(slide)]
        lines = {slide.along for slide in guides if slide.ends[0] == letter}
        return "guides cross" if len(lines) > 1 else "fixed point"

    def _slides(self) -> list[Slide]:
        return [step for step in self.frame.steps if isinstance(step, Slide)]

    def _guide(self, slide: Slide) -> None:
        line = self.scene.heading(self.frame.line(slide, self.motion.pose))
        origin = self.at(slide.ends[0]) + self.scene.outward(self.frame.shift(slide))
        guide = Guide(origin, line, self._away(slide.ends[1], line))
        head, tail = slide.ends[1], slide.ends[0]
        known = tail in self.motion.points
        label, phrase = ("", "guide") if known else (tail, "guide point")
        parts = {"head": head, "tail": tail}
        name = f"{slide.ends}.guide"
        self._draw(name, "guide", label, guide, phrase, parts, link=slide.name)

    def _away(self, letter: str, line: complex) -> complex:
        """Return the unit vector across a guide, on the side away from the rod."""
        normal = -1j * line
        if normal.imag > 0 or (normal.imag == 0 and normal.real < 0):
            normal = -normal
        for step in self.frame.steps:
            if isinstance(step, Bar) and letter in step.ends:
                other = step.ends.replace(letter, "")
                height = (normal.conjugate() * (self.at(other) - self.at(letter))).real
                if abs(height) > 1e-9 * self.scene.size(step):
                    return normal if height < 0 else -normal
        return normal

    def _driver(self) -> None:
        """Draw what the driver dictates: a bar at its angle, or a block in its place."""
        driver = self.scene.driver
        for step in self.frame.steps:
            if scalar_of(step) != driver:
                continue
            if isinstance(step, Bar):
                self._bar(step, "known", "driven bar")
                tail, head = (self.at(letter) for letter in step.ends)
                sweep = self.motion.link(step.link).angle
                arc = Arc(tail, abs(head - tail), 0.0, sweep)
                angle = Figure(sweep, "°", given=True)
                label = with_unit(self.scene.figures.place(angle), "°")
                name, parts = f"{step.ends}.angle", {"link": step.link}
                self._draw(name, "angle", label, arc, "angle", parts, link=step.link)
                self.found.update(step.ends)
            elif isinstance(step.along, float):
                self._block(step, "known", "driven slide")
                self.found.add(step.ends[1])
            return

    # --- what is found ------------------------------------------------------------------------

    def _construct(self, loop: Loop, unknowns: tuple[Scalar, ...]) -> None:
        """Draw the arcs and lines that fix the point at which both chains end."""
        end = loop.first[-1].ends[0 if loop.first[-1].reverse else 1]
        if end in self.found:
            return
        phrase: tuple[str, dict[str, object]] = ("found", {"letter": end})
        arcs = 0
        for step in (*loop.first, *loop.second):
            if isinstance(step, Bar) and scalar_of(step) in unknowns:
                if any(
                    scalar_of(other) in unknowns and other.name == step.length
                    for other in loop.first
                    if isinstance(other, Slide)
                ):
                    phrase = self._lever_line(step, end)
                else:
                    self._compass(step, end)
                    arcs += 1
            elif isinstance(step, Slide) and isinstance(step.along, float):
                if not self.scene.is_guide(step):
                    self._slot_line(step)
                    phrase = ("on slot", {"letter": end})
                elif phrase[0] == "found" and arcs:
                    phrase = ("on guide", {"letter": end})
        if arcs > 1:
            phrase = ("arcs cross", {"letter": end})
        self._draw(f"{end}.found", "intersection", end, Dot(self.at(end)), *phrase)
        self.found.add(end)

    def _compass(self, bar: Bar, end: str) -> None:
        letters = self.scene.letters(bar)
        centre, point = self.at(letters[0]), self.at(end)
        angle = math.degrees(cmath.phase(point - centre))
        arc = Arc(centre, self.scene.size(bar), angle - COMPASS, 2 * COMPASS, through=point)
        parts: dict[str, object] = {"head": end, "tail": letters[0], "bar": letters}
        parts |= {"unit": Unit(self.scene.unit), "link": bar.link}
        parts["size"] = self.scene.length(bar, self.scene.unit)
        name, phrase = f"{bar.ends}.compass", "compass"
        if self.scene.is_strut(bar):
            phrase = "compass strut"
        self._draw(name, "construction", letters, arc, phrase, parts, link=bar.link)

    def _lever_line(self, bar: Bar, end: str) -> tuple[str, dict[str, object]]:
        tail, point = self.at(bar.ends[0]), self.at(end)
        pin = next(hop for hop in self._slides() if end in hop.ends).ends.replace(end, "")
        unit = self.frame.unit(bar.link, self.motion.pose, bar.turn)
        line = Line(tail, self.scene.heading(unit), point)
        parts: dict[str, object] = {"link": bar.link, "tail": bar.ends[0], "pin": pin}
        name, label = f"{bar.ends}.line", bar.ends[0] + pin
        self._draw(name, "construction", label, line, "lever line", parts, link=bar.link)
        return "on lever", {"letter": end, "link": bar.link, "pin": pin}

    def _slot_line(self, slide: Slide) -> None:
        head, tail = slide.ends[1], slide.ends[0]
        towards = self.at(tail) - self.at(head)
        line = self.scene.heading(self.frame.line(slide, self.motion.pose))
        if (line.conjugate() * towards).real < 0:
            line = -line
        shape = Line(self.at(head), line, self.at(tail))
        parts: dict[str, object] = {"head": tail, "pin": head, "link": self._owner(slide)}
        name = f"{slide.ends}.line"
        label = self.scene.say("parallel", line=self.scene.line(slide))
        self._draw(name, "construction", label, shape, "slot line", parts, link=slide.name)

    def _ink(self, loop: Loop, unknowns: tuple[Scalar, ...]) -> None:
        for step in (*loop.first, *loop.second):
            if scalar_of(step) in unknowns and isinstance(step, Bar):
                self._bar(step, "result", "bar")
        for step in (*loop.first, *loop.second):
            if scalar_of(step) in unknowns and isinstance(step, Slide):
                if isinstance(step.along, str) and not step.reverse:
                    continue  # a strut has no block
                if not self.scene.is_guide(step) and isinstance(step.along, float):
                    self._slot(step)
                self._block(step, "result", "block")

    def _slot(self, slide: Slide) -> None:
        owner = self._owner(slide)
        line = self.scene.heading(self.frame.line(slide, self.motion.pose))
        guide = Guide(self.at(slide.ends[0]), line)
        parts: dict[str, object] = {"head": slide.ends[1], "link": owner}
        self._draw(f"{slide.ends}.slot", "guide", "", guide, "slot", parts, link=owner)

    def _owner(self, slide: Slide) -> str:
        """Return what bears the slot along which a block slides."""
        return next(other for other in self._slides() if other.ends[1] == slide.ends[0]).name

    def _images(self, known: set[Scalar]) -> None:
        for bar in self.linkage.images:
            if bar.ends[1] not in self.found and angle_of(bar.link) in known:
                self.found.add(bar.ends[1])
                self._bar(bar, "result", "tip against" if bar.against else "tip", image=True)

    def _bar(self, bar: Bar, kind: str, phrase: str, image: bool = False) -> None:
        letters = self.scene.letters(bar)
        tail, head = letters[0], letters[1]
        arrow = Arrow(self.at(tail), self.at(head), tail, head, self.scene.cylinder(bar))
        angle = self.motion.link(bar.link).angle
        driven = angle_of(bar.link) == self.scene.driver
        parts: dict[str, object] = {"link": bar.link, "bar": letters}
        parts |= {"size": self.scene.length(bar, self.scene.unit), "unit": Unit(self.scene.unit)}
        parts |= {"angle": Figure(angle, "°", driven), "symbol": self.scene.symbol("θ", bar.link)}
        parts |= {"letter": head, "tail": tail}
        reveals = () if driven or image else (bar.link,)
        self._draw(
            f"{bar.ends}.bar",
            kind,
            letters,
            arrow,
            phrase,
            parts,
            link=bar.link,
            component="link",
            image=image,
            reveals=reveals,
        )

    def _block(self, slide: Slide, kind: str, phrase: str) -> None:
        letter = slide.ends[1]
        line = self.scene.heading(self.frame.line(slide, self.motion.pose))
        on = slide.along if isinstance(slide.along, str) else None
        driven = scalar_of(slide) == self.scene.driver
        symbol = self.scene.slide_symbol(slide.name)
        parts: dict[str, object] = {
            "slide": slide.name.split("_")[0],
            "head": letter,
            "symbol": symbol,
            "value": Figure(self.motion.slide(slide.name).position, self.scene.unit, driven),
            "unit": Unit(self.scene.unit),
            "tail": self._measured_from(slide),
        }
        if symbol == "s":
            phrase += " from"
        self._draw(
            f"{slide.ends}.block",
            kind,
            letter,
            Block(self.at(letter), line, on, self.scene.travel(slide.name)),
            phrase,
            parts,
            link=slide.name,
            component="link",
            reveals=() if driven else (slide.name,),
        )

    def _measured_from(self, slide: Slide) -> str:
        """Return the point from which a slide's position counts: a lever's pivot, a line's tail."""
        bars = (step for step in self.frame.steps if isinstance(step, Bar))
        pivots = (bar.ends[0] for bar in bars if bar.length == slide.name)
        return next(pivots, slide.ends[0])
