"""The pen that draws the views of a mechanism in space, stroke after stroke."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar

from vad.strokes.arithmetic import Calculation, Figure
from vad.strokes.diagram import Drawing
from vad.strokes.sentences import SentencePart, Text, Unit
from vad.strokes.sheet import Component, Ellipse, Equation, Kind, Note, Shape, Stroke, StrokePart

if TYPE_CHECKING:
    from vad.strokes.space.scene_in_space import SceneInSpace


class ViewsPen:
    """The strokes of the views of one pose so far.

    Attributes
    ----------
    topic
        What the phrases of its mechanism begin with.
    sizes
        The parameters of the mechanism.
    """

    topic: ClassVar[str]

    def __init__(self, scene: SceneInSpace) -> None:
        self.scene = scene
        self.sizes = scene.motion.mechanism.parameters()
        self.strokes: list[Stroke] = []
        self.zeros: list[Stroke] = []

    def draw(
        self,
        name: str,
        kind: Kind,
        label: str,
        shape: Shape,
        phrase: str,
        link: str | None = None,
        body: bool = False,
        reveals: tuple[str, ...] = (),
        calculations: tuple[Calculation, ...] = (),
        **parts: SentencePart,
    ) -> None:
        """Draw a stroke, a ``body`` as thick as links are; ``parts`` fill in its phrase."""
        unit = Unit(self.scene.unit)
        said = self.scene.say(f"{self.topic} {phrase}", *calculations, unit=unit, **parts)
        component: Component | None = "link" if body else None
        part = StrokePart.named(name)
        self.strokes.append(
            Stroke(kind, label, shape, said, link, component, reveals=reveals, part=part)
        )

    def leave_out(self) -> None:
        """Keep the last stroke among those that are not drawn in this pose."""
        self.zeros.append(replace(self.strokes.pop(), said="", reveals=()))

    def finished(self, equation: Equation, notes: Sequence[Note]) -> Drawing:
        """Return all strokes, with the equation below them and what stands beside the views."""
        strokes, zeros = tuple(self.strokes), tuple(self.zeros)
        return Drawing(strokes, zeros, (equation,), picture="views", notes=tuple(notes))

    def given(self, value: float, unit: str = "°") -> Figure:
        """Return a number that is given."""
        return Figure(value, unit, given=True)

    def length(self, name: str) -> Figure:
        """Return a parameter that is a length."""
        return self.given(self.sizes[name], self.scene.unit)

    def angle(self, name: str) -> Figure:
        """Return a parameter that is an angle."""
        return self.given(self.sizes[name])

    def degrees(self, angle: Figure) -> Text:
        """Write an angle beside its arc."""
        return self.scene.write("degrees", angle=angle)


def circle(centre: complex, radius: float, start: float = 0.0, sweep: float = 360.0) -> Ellipse:
    """Return a circle that is seen along its axis, or an arc of it from ``start`` on."""
    return Ellipse(centre, complex(radius), 1j * radius, start, sweep)
