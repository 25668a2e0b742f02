"""What the captions of a polygon calculate: noted down, so that the digits of its figures agree."""

from __future__ import annotations

from vad.kinematics.linkage import Bar, Slide, length_of
from vad.strokes.chains import StepVector
from vad.strokes.figures import Figure
from vad.strokes.scene import Scene
from vad.strokes.vector_equations import Part


class Calculations:
    """The calculations of the velocity (order 1) or acceleration (order 2) panel, without a word.

    It takes the place of captions in a sketch.
    """

    def __init__(self, scene: Scene, order: int) -> None:
        self._scene = scene
        self._order = order
        self._unit = scene.rate_unit(order)

    # --- what is said -------------------------------------------------------------------------

    def pole(self, letters: list[str]) -> str:
        """Say which points lie at the pole."""
        return ""

    def still(self) -> str:
        """Say that nothing moves."""
        return ""

    def known(self, label: str, part: Part[StepVector]) -> str:
        """Work out a component that is known before the crossing."""
        step = part.of.step
        if isinstance(step, Bar):
            self.turned(part, step)
        elif part.name == "coriolis":
            self.twisted(part, step)
        return ""

    def line(self, part: Part[StepVector], point: str, meeting: str) -> str:
        """Say why the next vertex must lie on a construction line."""
        return ""

    def across(self, tail: str, head: str) -> str:
        """Say that a further point of a link moves across its line to a known one."""
        return ""

    def absolute(self, label: str, point: str, size: float) -> str:
        """Measure the vector of a point from the pole."""
        return ""

    def crossing(self, letter: str, pole: bool, zeros: list[tuple[Part[StepVector], str]]) -> str:
        """Say what lies where the two lines cross, and which results are zero there."""
        return ""

    def measured(self, label: str, part: Part[StepVector]) -> str:
        """Measure a result off the polygon."""
        if isinstance(part.of.step, Bar):
            self.divided(part, part.of.step)
        return ""

    def whole(self, label: str, size: float, vector: StepVector) -> str:
        """Measure a whole vector beside its parts."""
        return ""

    def image(self, bar: Bar, base: Bar, label: str, sizes: tuple[float, float, float]) -> str:
        """Find a further point of a link by proportion.

        ``sizes`` are those of the vectors of ``base``, of ``bar`` and from the pole.
        """
        self.proportion(bar, base, *sizes[:2])
        return ""

    # --- what is calculated -------------------------------------------------------------------

    def turned(self, part: Part[StepVector], bar: Bar) -> tuple[Figure, Figure, Figure]:
        """Return a part of a bar that turns, which is the product of a rate and a length."""
        scene, normal = self._scene, part.name == "normal"
        rate = scene.spin(bar.link, 1 if normal else self._order, power=2 if normal else 1)
        size, value = scene.length(bar, self._unit), self._size(part)
        scene.figures.product(value, rate, size)
        return value, rate, size

    def twisted(self, part: Part[StepVector], slide: Slide) -> tuple[Figure, Figure, Figure]:
        """Return a Coriolis part, which is twice the product of a rate and a speed."""
        scene, value = self._scene, self._size(part)
        rate = scene.spin(str(slide.along), 1)
        sliding = abs(scene.speed(slide.name, 1))
        speed = scene.figure(length_of(slide.name), sliding, scene.rate_unit(1))
        scene.figures.product(value, Figure(2.0, given=True), rate, speed)
        return value, rate, speed

    def divided(self, part: Part[StepVector], bar: Bar) -> tuple[Figure, Figure, Figure]:
        """Return what was measured of a bar with the rate that follows, and the bar's length."""
        scene, value = self._scene, self._size(part)
        rate, size = scene.spin(bar.link, self._order), scene.length(bar, self._unit, power=-1)
        scene.figures.product(rate, value, size)
        return value, rate, size

    def proportion(
        self, bar: Bar, base: Bar, known: float, own: float
    ) -> tuple[Figure, Figure, Figure, Figure]:
        """Return a part of an image, the whole, and the lengths that are in the same ratio."""
        scene, figures = self._scene, (Figure(own, self._unit), Figure(known, self._unit))
        size, length = scene.length(bar, self._unit), scene.length(base, self._unit, power=-1)
        scene.figures.product(*figures, size, length)
        return *figures, size, length

    def _size(self, part: Part[StepVector]) -> Figure:
        return Figure(abs(part.vector), self._unit)
