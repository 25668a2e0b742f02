"""The sentence that goes with every stroke of a polygon: symbol, numbers, result, unit."""

from __future__ import annotations

from vad.kinematics.linkage import Bar, Slide, Step, length_of
from vad.strokes.arithmetic import Figure, product
from vad.strokes.loops import StepVector
from vad.strokes.scene import Scene, image_letter, point_of
from vad.strokes.sentences import Listed, Noun, Sentence, SentencePart, Unit
from vad.strokes.vector_equations import Part


class Captions:
    """The captions of the velocity (order 1) or acceleration (order 2) panel."""

    def __init__(self, scene: Scene, order: int) -> None:
        self._scene, self._say = scene, scene.say
        self._order = order
        self._panel = "velocity" if order == 1 else "acceleration"
        self._unit = scene.rate_unit(order)
        self._written_unit = Unit(self._unit)

    def pole(self, letters: list[str]) -> Sentence:
        """Say which points lie at the pole."""
        points = self._scene.members.points
        *named, last = [
            letter
            if point_of(letter) in points
            else self._say("on the guide", letter=letter, point=point_of(letter))
            for letter in letters
        ]
        if not named:
            point = point_of(letters[0])
            return self._say(f"pole {self._panel} one", point=point, letters=last)
        both = self._say("and", first=Listed(tuple(named), ", "), last=last)
        return self._say(f"pole {self._panel}", letters=both)

    def still(self) -> Sentence:
        """Say that nothing moves."""
        return self._say("still")

    def known(self, label: str, part: Part[StepVector]) -> Sentence:
        """Work out a component that is known before the crossing."""
        if isinstance(part.of.step, Slide):
            return self._known_slide(label, part, part.of.step)
        scene, bar = self._scene, part.of.step
        normal = part.name == "normal"
        rate = scene.spin(bar.link, 1 if normal else self._order, power=2 if normal else 1)
        tail, head = scene.members.ends(bar)
        whole = label == "".join(image_letter(end, self._order) for end in (bar.tail, bar.head))
        return self._say(
            ("normal" if normal else f"tangential {self._panel}") + (" whole" if whole else ""),
            product("value", "rate", "size"),
            label=label,
            bar=tail + head,
            omega=scene.members.symbol("ω", bar.link),
            alpha=scene.members.symbol("α", bar.link),
            rate=rate,
            size=scene.length(bar, self._unit),
            value=self._size(part),
            unit=self._written_unit,
            head=head,
            tail=tail,
            whose=self._whose(bar) if whole else "",
        )

    def _known_slide(self, label: str, part: Part[StepVector], slide: Slide) -> Sentence:
        scene = self._scene
        common: dict[str, SentencePart] = {"label": label, "unit": self._written_unit}
        if part.name != "coriolis":
            given = scene.figure(length_of(slide.name), abs(part.vector), self._unit)
            line, way = scene.line(slide), self._way(part.vector)
            return self._say(f"sliding {self._panel}", line=line, way=way, value=given, **common)
        sliding = abs(scene.speed(slide.name, 1))
        return self._say(
            "coriolis",
            product("value", 2.0, "rate", "speed"),
            omega=scene.members.symbol("ω", str(slide.along)),
            rate=scene.spin(str(slide.along), 1),
            speed=scene.figure(length_of(slide.name), sliding, scene.rate_unit(1)),
            value=self._size(part),
            **common,
        )

    def line(self, part: Part[StepVector], point: str, meeting: str) -> Sentence:
        """Say why the next vertex must lie on a construction line."""
        scene, step = self._scene, part.of.step
        fixed = {image_letter(letter, self._order) for letter in scene.members.fixed}
        place = self._say("the pole") if point in fixed else point
        if isinstance(step, Slide):
            return self._say(
                self._along(step),
                point=place,
                line=scene.line(step),
                slide=scene.members.slider(step),
                head=self._sliding_point(step),
                meeting=meeting,
            )
        tail, head = scene.members.ends(step)
        strut = " strut" if self._order == 1 and scene.members.is_strut(step) else ""
        return self._say(
            f"across {self._panel}{strut}",
            point=place,
            bar=tail + head,
            tail=tail,
            head=head,
            alpha=scene.members.symbol("α", step.link),
            meeting=meeting,
        )

    def across(self, tail: str, head: str) -> Sentence:
        """Say that a further point of a link moves across its line to a known one."""
        return self._say(
            f"across {self._panel}",
            point=image_letter(tail, self._order),
            bar=tail + head,
            tail=tail,
            head=head,
            meeting=image_letter(head, self._order),
        )

    def absolute(self, label: str, point: str, size: float) -> Sentence:
        """Measure the vector of a point from the pole."""
        value, whose = Figure(size, self._unit), self._say(f"{self._panel} of", head=point)
        return self._say("whole", label=label, value=value, unit=self._written_unit, whose=whose)

    def crossing(
        self, letter: str, pole: bool, zeros: list[tuple[Part[StepVector], str]]
    ) -> Sentence:
        """Say what lies where the two lines cross, and which results are zero there."""
        if pole:
            return self._say("pole crossing", letter=letter, point=point_of(letter))
        found = tuple(
            self._say("zero", point=vertex, symbol=self._rate_symbol(part.of.step))
            for part, vertex in zeros
        )
        if found:
            return self._say("crossing zero", letter=letter, found=Listed(found, "; "))
        return self._say("crossing", letter=letter)

    def measured(self, label: str, part: Part[StepVector]) -> Sentence:
        """Measure a result off the polygon."""
        scene, step = self._scene, part.of.step
        common: dict[str, SentencePart] = {"label": label, "unit": self._written_unit}
        if isinstance(step, Slide):
            return self._say(
                f"measured sliding {self._panel}",
                slide=scene.members.slider(step),
                head=self._sliding_point(step),
                line=scene.line(step),
                way=self._way(part.vector),
                symbol=self._rate_symbol(step),
                rate=Figure(scene.speed(step.name, self._order), self._unit),
                value=self._size(part),
                **common,
            )
        tail, head = scene.members.ends(step)
        turning = scene.rate(step.link, self._order)
        return self._say(
            f"measured omega{self._seen(step)}" if self._order == 1 else "measured alpha",
            product("rate", "value", "size"),
            omega=scene.members.symbol("ω", step.link),
            alpha=scene.members.symbol("α", step.link),
            bar=tail + head,
            tail=tail,
            head=head,
            value=self._size(part),
            size=scene.length(step, self._unit, power=-1),
            rate=scene.spin(step.link, self._order),
            sense=self._say("counter-clockwise" if turning > 0 else "clockwise"),
            way=self._way(part.vector),
            **common,
        )

    def whole(self, label: str, size: float, vector: StepVector) -> Sentence:
        """Measure a whole vector beside its parts."""
        return self._say(
            "whole",
            label=label,
            value=Figure(size, self._unit),
            unit=self._written_unit,
            whose=self._whose(vector.step),
        )

    def image(self, bar: Bar, base: Bar, label: str, sizes: tuple[float, float, float]) -> Sentence:
        """Find a further point of a link by proportion.

        ``sizes`` are those of the vectors of ``base``, of ``bar`` and from the pole.
        """
        scene, against = self._scene, self._scene.against(bar)
        known, own, found = (Figure(size, self._unit) for size in sizes)
        part, whole = (
            "".join(image_letter(letter, self._order) for letter in (each.tail, each.head))
            for each in (bar, base)
        )
        also: list[SentencePart] = []
        if part != label:
            parts: dict[str, SentencePart] = {
                "value": found,
                "unit": self._written_unit,
                "label": label,
            }
            also.append(self._say("image other", **parts))
        if not against:  # else it would take three lines
            whose = self._say(f"{self._panel} of", head=bar.head)
            also.append(self._say("image whose", whose=whose))
        return self._say(
            "image against" if against else "image",
            product("own", "known", "size", "length"),
            letter=image_letter(bar.head, self._order),
            image=self._say(f"image {self._panel}"),
            link=Noun(bar.link),
            part=part,
            whole=whole,
            bar=bar.ends,
            base=base.ends,
            known=known,
            size=scene.length(bar, self._unit),
            length=scene.length(base, self._unit, power=-1),
            own=own,
            unit=self._written_unit,
            also=Listed(tuple(also), ""),
        )

    def _size(self, part: Part[StepVector]) -> Figure:
        """Return the length of a vector's part."""
        return Figure(abs(part.vector), self._unit)

    def _rate_symbol(self, step: Step) -> str:
        """Return the symbol of what a step's unknown part measures: ω₃, α₃, v or a."""
        if isinstance(step, Slide):
            return "va"[self._order - 1]
        return self._scene.members.symbol("ωα"[self._order - 1], step.link)

    def _whose(self, bar: Step) -> Sentence:
        """Say whose velocity or acceleration the whole vector of a bar is."""
        fixed = bar.tail in self._scene.members.fixed
        phrase = f"{self._panel} of" + ("" if fixed else " relative")
        return self._say(phrase, head=bar.head, tail=bar.tail)

    def _seen(self, bar: Bar) -> str:
        """Return from where the motion of a bar's head is seen."""
        if self._scene.members.is_strut(bar):
            return " strut"
        return " absolute" if bar.tail in self._scene.members.fixed else ""

    def _sliding_point(self, slide: Slide) -> str:
        return self._scene.motion.mechanism.slides[slide.name]

    def _along(self, slide: Slide) -> str:
        """Return the phrase for the line along which a block slides."""
        if isinstance(slide.along, str):
            inside = "slot" if slide.name == slide.along else "link"
            return f"along velocity {inside}" if self._order == 1 else "along acceleration"
        return "along velocity" if self._scene.members.is_guide(slide) else "along velocity slot"

    def _way(self, vector: complex) -> Sentence:
        if abs(vector.real) >= abs(vector.imag):
            return self._say("right" if vector.real > 0 else "left")
        return self._say("up" if vector.imag > 0 else "down")
