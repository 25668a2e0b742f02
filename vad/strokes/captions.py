"""The sentence that goes with every stroke of a polygon: symbol, numbers, result, unit."""

from __future__ import annotations

from vad.kinematics.linkage import Bar, Slide, Step, angle_of, length_of
from vad.strokes.chains import Part
from vad.strokes.scene import Scene, image_letter
from vad.written import measured, squared


class Captions:
    """The captions of the velocity (order 1) or acceleration (order 2) panel."""

    def __init__(self, scene: Scene, order: int) -> None:
        self._scene = scene
        self._order = order
        self._panel = "velocity" if order == 1 else "acceleration"
        self._say = scene.language.say
        self._unit = scene.rate_unit(order)

    def pole(self, letters: list[str]) -> str:
        """Say which points lie at the pole."""
        one = "" if len(letters) > 1 else " one"
        return self._say(f"pole {self._panel}{one}", letters=", ".join(letters))

    def still(self) -> str:
        """Say that nothing moves."""
        return self._say("still")

    def known(self, label: str, part: Part) -> str:
        """Work out a component that is known before the crossing."""
        scene, step = self._scene, part.step
        value = measured(abs(part.vector))
        common = {"label": label, "value": value, "unit": self._unit}
        if isinstance(step, Slide):
            if part.name == "coriolis":
                link = str(step.along)
                return self._say(
                    "coriolis",
                    omega=scene.symbol("ω", link),
                    rate=scene.write(angle_of(link), abs(scene.rate(link, 1))),
                    speed=scene.write(length_of(step.name), abs(scene.speed(step.name, 1))),
                    **common,
                )
            common["value"] = scene.write(length_of(step.name), abs(part.vector))
            return self._say(
                f"sliding {self._panel}",
                line=scene.line_name(step),
                way=self._way(part.vector),
                **common,
            )
        common |= {"bar": scene.letters(step), "size": scene.write_size(step)}
        if part.name == "normal":
            return self._say(
                "normal",
                omega=scene.symbol("ω", step.link),
                rate=squared(scene.write(angle_of(step.link), abs(scene.rate(step.link, 1)))),
                head=scene.letters(step)[1],
                tail=scene.letters(step)[0],
                **common,
            )
        return self._say(
            f"tangential {self._panel}",
            omega=scene.symbol("ω", step.link),
            alpha=scene.symbol("α", step.link),
            rate=scene.write(angle_of(step.link), abs(scene.rate(step.link, self._order))),
            **common,
        )

    def line(self, part: Part, point: str, meeting: str) -> str:
        """Say why the next vertex must lie on a construction line."""
        scene, step = self._scene, part.step
        fixed = {image_letter(letter, self._order) for letter in scene.motion.frame.fixed}
        place = self._say("the pole") if point in fixed else point
        if isinstance(step, Slide):
            return self._say(
                self._along(step),
                point=place,
                line=scene.line_name(step),
                link=str(step.along),
                slide=step.name.split("_")[0],
                meeting=meeting,
            )
        bar = scene.letters(step)
        strut = " strut" if self._order == 1 and scene.is_strut(step) else ""
        return self._say(
            f"across {self._panel}{strut}",
            point=place,
            bar=bar,
            tail=bar[0],
            head=bar[1],
            alpha=scene.symbol("α", step.link),
            meeting=meeting,
        )

    def crossing(self, letter: str, pole: bool) -> str:
        """Say what lies where the two lines cross."""
        return self._say("pole crossing" if pole else "crossing", letter=letter)

    def measured(self, label: str, part: Part) -> str:
        """Measure a result off the polygon."""
        scene, step = self._scene, part.step
        common = {"label": label, "value": measured(abs(part.vector)), "unit": self._unit}
        if isinstance(step, Slide):
            return self._say(
                f"measured sliding {self._panel}",
                slide=step.name.split("_")[0],
                way=self._way(part.vector),
                symbol="va"[self._order - 1],
                rate=measured(scene.speed(step.name, self._order)),
                **common,
            )
        rate = scene.rate(step.link, self._order)
        bar = scene.letters(step)
        strut = " strut" if scene.is_strut(step) else ""
        return self._say(
            f"measured omega{strut}" if self._order == 1 else "measured alpha",
            omega=scene.symbol("ω", step.link),
            alpha=scene.symbol("α", step.link),
            bar=bar,
            tail=bar[0],
            head=bar[1],
            size=scene.write_size(step),
            rate=measured(abs(rate)),
            sense=self._say("counter-clockwise" if rate > 0 else "clockwise"),
            way=self._way(part.vector),
            **common,
        )

    def whole(self, label: str, vector: complex, step: Step, still: bool) -> str:
        """Measure a whole vector beside its parts."""
        return self._say(
            "whole absolute" if still else "whole relative",
            label=label,
            value=measured(abs(vector)),
            unit=self._unit,
            head=step.ends[1],
            tail=step.ends[0],
        )

    def image(self, bar: Bar, label: str, value: float) -> str:
        """Find a further point of a link by proportion."""
        scene = self._scene
        base = next(
            step
            for loop in scene.motion.linkage.loops
            for _, step in loop.steps()
            if isinstance(step, Bar) and step.link == bar.link
        )
        images = [
            "".join(image_letter(letter, self._order) for letter in b.ends) for b in (bar, base)
        ]
        return self._say(
            "image against" if bar.against else "image",
            letter=image_letter(bar.ends[1], self._order),
            part=images[0],
            whole=images[1],
            bar=bar.ends,
            base=base.ends,
            size=scene.write_size(bar),
            length=scene.write_size(base),
            label=label,
            value=measured(value),
            unit=self._unit,
        )

    def _along(self, slide: Slide) -> str:
        """Return the phrase for the line along which a block slides."""
        if isinstance(slide.along, str):
            return "along velocity link" if self._order == 1 else "along acceleration"
        return "along velocity" if self._scene.is_guide(slide) else "along velocity slot"

    def _way(self, vector: complex) -> str:
        if abs(vector.real) >= abs(vector.imag):
            return self._say("right" if vector.real > 0 else "left")
        return self._say("up" if vector.imag > 0 else "down")
