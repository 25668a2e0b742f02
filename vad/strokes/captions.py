"""The sentence that goes with every stroke of a polygon: symbol, numbers, result, unit."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import reduce

from vad.kinematics.linkage import Bar, Slide, Step, angle_of, length_of, points_of
from vad.strokes.arithmetic import Calculation, Figure, product
from vad.strokes.diagram import ORDERS
from vad.strokes.loops import StepVector
from vad.strokes.notation import typed_unit
from vad.strokes.player import PencilCaptions
from vad.strokes.scene import Scene, image_letter, point_of
from vad.strokes.sentences import CaptionedMotion, Listed, Noun, Sentence, SentencePart, Unit
from vad.strokes.vector_equations import NOTHING, Part, V

#: The unit of the number of turns in a time, and the mark of a vertex that is found in two ways.
RPM, DOUBLE_PRIME = "rpm", "″"


class PolygonCaptions(PencilCaptions[V], ABC):
    """The captions of a velocity polygon (order 1) or an acceleration polygon (order 2).

    The ones here are the same for mechanisms in the plane and in space.

    Attributes
    ----------
    say
        The method that makes a sentence and records its calculations: see
        `vad.strokes.sentences.CaptionedMotion.say`.
    order, panel
        The order of the polygon, and the name of its panel.
    unit
        The unit of its vectors.
    """

    def __init__(self, scene: CaptionedMotion, order: int, unit: str) -> None:
        self.say = scene.say
        self.order, self.panel = order, ORDERS[order].panel
        self.unit = unit

    @abstractmethod
    def measures(self, part: Part[V]) -> str:
        """Return the symbol of what an unknown part measures: ω₃, α₃, v or a."""

    def is_zero(self, part: Part[V]) -> bool:
        """Tell whether a component of length zero means that the quantity it measures is zero."""
        return True

    def still(self) -> Sentence:
        """Say that nothing moves."""
        return self.say("still")

    def at_pole(self, letters: Sequence[SentencePart]) -> Sentence:
        """Say which of several points lie at the pole."""
        *named, last = letters
        both = self.say("and", first=Listed(tuple(named), ", "), last=last)
        return self.say(f"pole {self.panel}", letters=both)

    def quantity(
        self,
        phrase: str,
        *calculations: Calculation,
        label: str,
        value: Figure,
        **parts: SentencePart,
    ) -> Sentence:
        """Say how long a vector is, in the unit of the polygon."""
        parts |= {"label": label, "value": value, "unit": Unit(self.unit)}
        return self.say(phrase, *calculations, **parts)

    def place(self, point: str, at_pole: bool) -> SentencePart:
        """Return a vertex through which a line runs, or the pole."""
        return self.say("the pole") if at_pole else point

    def crossing(self, letter: str, pole: bool, zeros: list[tuple[Part[V], str]]) -> Sentence:
        """Say what lies where the two lines cross, and which results are zero there."""
        if pole:
            return self.say("pole crossing", letter=letter, point=point_of(letter))
        found = [
            self.say("zero", point=vertex, symbol=self.measures(part))
            for part, vertex in zeros
            if self.is_zero(part)
        ]
        if found:
            both = reduce(lambda one, other: self.say("zeros", one=one, other=other), found)
            return self.say("crossing zero", letter=letter, found=both)
        return self.say("crossing", letter=letter)

    def sense(self, rate: float) -> Sentence:
        """Say in which sense a body turns."""
        return self.say("counter-clockwise" if rate > 0 else "clockwise")

    def size(self, part: Part[V]) -> Figure:
        """Return the length of a component."""
        return Figure(abs(part.vector), self.unit)


class Captions(PolygonCaptions[StepVector]):
    """The captions of a polygon in the plane."""

    def __init__(self, scene: Scene, order: int) -> None:
        super().__init__(scene, order, scene.rate_unit(order))
        self._scene = scene
        self._doubled, self._singles = False, list[str]()

    def pole(self, letters: list[str]) -> Sentence:
        """Say which points lie at the pole."""
        points = self._scene.members.points
        named: list[SentencePart] = [
            letter
            if point_of(letter) in points
            else self.say("on the guide", letter=letter, point=point_of(letter))
            for letter in letters
        ]
        point = point_of(letters[0])
        one = self.say(f"pole {self.panel} one", point=point, letters=named[0])
        return self._turning(self._steady(one if len(named) == 1 else self.at_pole(named)))

    def _turning(self, said: Sentence) -> Sentence:
        """Say at the pole of velocities, too, how large ω is where it was typed in rpm."""
        scene, driver = self._scene, self._scene.driver
        if self.order > 1 or driver != angle_of(driver.name):
            return said
        rate = scene.spin(driver.name, 1)
        factor, unit = typed_unit(rate.value, rate.unit)
        if unit != RPM:
            return said
        return self.say(
            "pole turning",
            product("rate", 1.0 / factor, "count"),
            said=said,
            count=Figure(factor * rate.value, unit, given=True),
            omega=scene.members.symbol("ω", driver.name),
            rate=rate,
        )

    def _steady(self, said: Sentence) -> Sentence:
        """Say at the pole, too, that the driver gives a line no acceleration, if that is so."""
        members = self._scene.members
        driving = (slide for slide in members.sliding if members.drives(slide))
        slide = next(driving, None)
        if slide is None or self._scene.speed(slide.name, self.order):
            return said
        return self.say(
            "pole steady point" if members.is_guide(slide) else "pole steady",
            said=said,
            line=self._scene.line(slide),
            symbol=members.rate_symbol(slide.name, ORDERS[self.order]),
            letter=image_letter(slide.head, self.order),
        )

    def known(self, label: str, part: Part[StepVector]) -> Sentence:
        """Calculate a component that is known before the lines cross."""
        if isinstance(part.of.step, Slide):
            return self._known_slide(label, part, part.of.step)
        scene, bar = self._scene, part.of.step
        normal = part.name == "normal"
        rate = scene.spin(bar.link, 1 if normal else self.order, power=2 if normal else 1)
        tail, head = scene.members.ends(bar)
        whole = label == "".join(image_letter(end, self.order) for end in (bar.tail, bar.head))
        return self.quantity(
            ("normal" if normal else f"tangential {self.panel}") + (" whole" if whole else ""),
            product("value", "rate", "size"),
            label=label,
            bar=tail + head,
            omega=scene.members.symbol("ω", bar.link),
            alpha=scene.members.symbol("α", bar.link),
            rate=rate,
            size=scene.length(bar, self.unit),
            value=self.size(part),
            head=head,
            tail=tail,
            whose=self._whose(bar) if whole else "",
            also=self._double(label),
        )

    def _double(self, label: str) -> Sentence | Listed:
        """Say why a vertex has a double prime: of the first beside which there is a single one."""
        place = label.find(DOUBLE_PRIME) - 1
        other, one = label[place:], label[place:].replace(DOUBLE_PRIME, "")
        self._singles.append(label)
        if place < 0 or self._doubled or not any(each.endswith(one) for each in self._singles):
            return Listed((), "")
        self._doubled = True
        return self.say("double prime", other=other, one=one)

    def _known_slide(self, label: str, part: Part[StepVector], slide: Slide) -> Sentence:
        scene = self._scene
        if part.name != "coriolis":
            value, unit = (
                Figure(abs(part.vector), self.unit, typed=True),
                Unit(self.unit, typed=True),
            )
            line, way = scene.line(slide), self._driven_way(slide, part.vector)
            ends = scene.motion.mechanism.links.get(slide.name, "")
            turns = self.order == 1 and ends[:1] in scene.members.fixed  # about a fixed pivot
            phrase = f"sliding {self.panel}" + (" strut" if turns else "")
            said: dict[str, SentencePart] = {"line": line, "way": way, "bar": ends}
            return self.say(phrase, label=label, value=value, unit=unit, **said)
        sliding = abs(scene.speed(slide.name, 1))
        return self.quantity(
            "coriolis",
            product("value", 2.0, "rate", "speed"),
            label=label,
            omega=scene.members.symbol("ω", str(slide.along)),
            rate=scene.spin(str(slide.along), 1),
            speed=scene.figure(length_of(slide.name), sliding, scene.rate_unit(1)),
            value=self.size(part),
        )

    def line(self, part: Part[StepVector], point: str, meeting: str) -> Sentence:
        """Say why the next vertex must lie on a construction line."""
        scene, step = self._scene, part.of.step
        fixed = {image_letter(letter, self.order) for letter in scene.members.fixed}
        place = self.place(point, point in fixed)
        if isinstance(step, Slide):
            return self.say(
                self._along(step),
                point=place,
                line=scene.line(step),
                slide=scene.members.slider(step),
                head=self._sliding_point(step),
                meeting=meeting,
            )
        tail, head = scene.members.ends(step)
        strut = " strut" if self.order == 1 and scene.members.is_strut(step) else ""
        return self.say(
            f"across {self.panel}{strut}",
            point=place,
            bar=tail + head,
            tail=tail,
            head=head,
            alpha=scene.members.symbol("α", step.link),
            meeting=meeting,
        )

    def without(self, part: Part[StepVector], said: Sentence) -> Sentence:
        """Say before what is said of a line why a normal or Coriolis component is zero."""
        scene, step = self._scene, part.of.step
        if part.name not in ("normal", "coriolis"):
            return said
        link = step.link if isinstance(step, Bar) else str(step.along)
        rates = [abs(rate) for rate in scene.orders(1)[-1].turning.values()]
        turns = abs(scene.rate(link, 1)) > NOTHING * max(rates)
        zero = scene.members.symbol("ω", link)
        if turns and isinstance(step, Slide):
            zero = scene.members.rate_symbol(step.name, ORDERS[1])
        return self.say(f"without {part.name}", zero=zero, said=said)

    def across(self, tail: str, head: str) -> Sentence:
        """Say that a further point of a link moves perpendicular to its line to a known point."""
        return self.say(
            f"across {self.panel}",
            point=image_letter(tail, self.order),
            bar=tail + head,
            tail=tail,
            head=head,
            meeting=image_letter(head, self.order),
        )

    def absolute(self, label: str, point: str, size: float) -> Sentence:
        """Measure the vector of a point from the pole."""
        value, whose = Figure(size, self.unit), self.say(f"{self.panel} of", head=point)
        return self.quantity("whole", label=label, value=value, whose=whose)

    def measured(self, label: str, part: Part[StepVector]) -> Sentence:
        """Measure a result off the polygon."""
        scene, step = self._scene, part.of.step
        if isinstance(step, Slide):
            return self.quantity(
                f"measured sliding {self.panel}",
                label=label,
                slide=scene.members.slider(step),
                head=self._sliding_point(step),
                line=scene.line(step),
                way=self._direction(part.vector),
                symbol=self.measures(part),
                rate=Figure(scene.speed(step.name, self.order), self.unit),
                value=self.size(part),
            )
        tail, head = scene.members.ends(step)
        return self.quantity(
            f"measured omega{self._kind_of_motion(step)}" if self.order == 1 else "measured alpha",
            product("rate", "value", "size"),
            label=label,
            omega=scene.members.symbol("ω", step.link),
            alpha=scene.members.symbol("α", step.link),
            bar=tail + head,
            tail=tail,
            head=head,
            value=self.size(part),
            size=scene.length(step, self.unit, power=-1),
            rate=scene.spin(step.link, self.order),
            sense=self.sense(scene.rate(step.link, self.order)),
            way=self._direction(part.vector),
        )

    def whole(self, label: str, size: float, vector: StepVector) -> Sentence:
        """State the length of a whole vector, whose components are drawn already."""
        value, whose = Figure(size, self.unit), self._whose(vector.step)
        return self.quantity("whole", label=label, value=value, whose=whose)

    def image(self, bar: Bar, base: Bar, label: str, sizes: tuple[float, float, float]) -> Sentence:
        """Find a further point of a link by proportion.

        ``sizes`` are the lengths of the vectors of ``base``, of ``bar`` and from the pole.
        """
        scene, against = self._scene, self._scene.against(bar)
        known, own, found = (Figure(size, self.unit) for size in sizes)
        part, whole = (
            "".join(image_letter(letter, self.order) for letter in (each.tail, each.head))
            for each in (bar, base)
        )
        also: list[SentencePart] = []
        if part != label:
            also.append(self.quantity("image other", label=label, value=found))
        if not against:  # otherwise the caption would have three lines
            whose = self.say(f"{self.panel} of", head=bar.head)
            also.append(self.say("image whose", whose=whose))
        return self.say(
            "image against" if against else "image",
            product("own", "known", "size", "length"),
            letter=image_letter(bar.head, self.order),
            tail=image_letter(bar.tail, self.order),
            image=self.say(f"image {self.panel}"),
            link=Noun(bar.link),
            part=part,
            whole=whole,
            bar=bar.ends,
            base=base.ends,
            known=known,
            size=scene.length(bar),
            length=scene.length(base, power=-1),
            own=own,
            unit=Unit(self.unit),
            also=Listed(tuple(also), ""),
        )

    def measures(self, part: Part[StepVector]) -> str:
        """Return the symbol of what a step's unknown part measures: ω₃, α₃, v or a."""
        step = part.of.step
        if isinstance(step, Slide):
            return self._scene.members.rate_symbol(step.name, ORDERS[self.order])
        return self._scene.members.symbol("ωα"[self.order - 1], step.link)

    def _whose(self, bar: Step) -> Sentence:
        """Say whose velocity or acceleration the whole vector of a bar is."""
        fixed = bar.tail in self._scene.members.fixed
        phrase = f"{self.panel} of" + ("" if fixed else " relative")
        return self.say(phrase, head=bar.head, tail=bar.tail)

    def _kind_of_motion(self, bar: Bar) -> str:
        """Return the ending of the phrase: for a strut, an absolute or a relative motion."""
        if self._scene.members.is_strut(bar):
            return " strut"
        return " absolute" if bar.tail in self._scene.members.fixed else ""

    def _sliding_point(self, slide: Slide) -> str:
        return self._scene.motion.mechanism.slides[slide.name]

    def _along(self, slide: Slide) -> str:
        """Return the phrase for the line along which a block slides."""
        if isinstance(slide.along, str):
            inside = "slot" if slide.name == slide.along else "link"
            return f"along velocity {inside}" if self.order == 1 else "along acceleration"
        return "along velocity" if self._scene.members.is_guide(slide) else "along velocity slot"

    def _driven_way(self, slide: Slide, vector: complex) -> Sentence:
        """Say which way a given vector points: in a cylinder, from which end to which."""
        ends = self._scene.motion.mechanism.links.get(slide.name)
        if not ends:
            return self._direction(vector)
        tail, head = points_of(ends)
        span = self._scene.at(head) - self._scene.at(tail)
        ahead = (vector * span.conjugate()).real > 0
        pair = ("extending", "retracting") if self.order == 1 else ("outwards", "inwards")
        return self.say(pair[0] if ahead else pair[1], tail=tail, head=head)

    def _direction(self, vector: complex) -> Sentence:
        if abs(vector.real) >= abs(vector.imag):
            return self.say("right" if vector.real > 0 else "left")
        return self.say("up" if vector.imag > 0 else "down")
