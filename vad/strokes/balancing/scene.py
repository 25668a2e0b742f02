"""The scene of a shaft or an engine: what is balanced, the rows of its table, and a pencil."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vad.balancing.balance import Balance
from vad.balancing.engine import Engine
from vad.balancing.inertia import rays
from vad.kinematics.linkage import Scalar
from vad.kinematics.numbers import ray
from vad.strokes.arithmetic import Calculation
from vad.strokes.balancing.drawings import RESULTANT
from vad.strokes.diagram import POSITION, Drawing, Order, Spot
from vad.strokes.sentences import CaptionedMotion, SentencePart
from vad.strokes.sheet import Cell, Component, Kind, Row, Shape, Stroke, StrokePart

if TYPE_CHECKING:
    from vad.strokes.balancing.drawings import Drawings
    from vad.strokes.diagram import Diagram


@dataclass(frozen=True)
class BalancingScene(CaptionedMotion):
    """A motion of a shaft or an engine, and the language of its captions."""

    forces: None = field(default=None, kw_only=True)

    @cached_property
    def subject(self) -> Balance | Engine:
        """What is balanced."""
        found: Balance | Engine = self.motion.mechanism.balancing(self.motion)
        return found

    @cached_property
    def crank(self) -> Any:
        """The direction of the first line of the shaft, in the pose or in each of the poses."""
        angle = self.motion.inputs["angle"]
        return rays(angle) if self.motion.many else ray(angle)

    @property
    def place(self) -> Cell:
        """The angle of the shaft."""
        return Cell("θ", self.motion.inputs["angle"], "°", True)

    @cached_property
    def drawings(self) -> Drawings:
        """What draws it."""
        from vad.strokes.balancing.engine import EngineDrawings
        from vad.strokes.balancing.locomotive import LocomotiveDrawings
        from vad.strokes.balancing.shaft import ShaftDrawings

        subject = self.subject
        if isinstance(subject, Balance):
            return ShaftDrawings(self, subject.found, subject.given)
        if subject.locomotive:
            return LocomotiveDrawings(self, subject.locomotive)
        return EngineDrawings(self, subject)

    @property
    def unit(self) -> str:
        """The unit of lengths."""
        unit: str = self.motion.mechanism.length_unit
        return unit

    @property
    def driver(self) -> Scalar:
        """The angle that is turned."""
        driver: Scalar = self.motion.solver.driver
        return driver

    @property
    def output(self) -> str:
        """The row of the resultant."""
        return RESULTANT

    def rows(self, diagrams: Sequence[Diagram]) -> list[Row]:
        """Return the rows of the results: those of which a diagram states anything.

        The angle of the shaft stands with the first diagram.
        """
        driver, first = self.driver.name, diagrams[0].name
        found = []
        for key, (title, letters) in self.drawings.rows.items():
            cells = {each.name: each.cells(self, key, False) for each in diagrams}
            if key == driver:
                cells[first] = (self.place,)
            if any(cells.values()):
                found.append(Row(key, self.name(title), letters, cells))
        return found

    def cells(self, order: Order, key: str, slides: bool) -> tuple[Cell, ...]:
        """Return the angle of the shaft; its diagrams are of no order."""
        return (self.place,) if order is POSITION and key == self.driver.name else ()

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return nothing, likewise."""
        return {}

    def unit_of(self, order: Order) -> str:
        """Return the unit of lengths."""
        return self.unit

    def drawing(self, order: Order) -> Drawing:
        """Return nothing, likewise."""
        return Drawing(())


class Pen:
    """Draws strokes with the sentences that go with them."""

    def __init__(self, scene: BalancingScene) -> None:
        self.scene = scene
        self.strokes: list[Stroke] = []

    def draw(
        self,
        kind: Kind,
        name: str,
        shape: Shape,
        phrase: str,
        *calculations: Calculation,
        link: str | None = None,
        label: str = "",
        component: Component | None = None,
        reveals: tuple[str, ...] = (),
        **parts: SentencePart,
    ) -> None:
        """Draw a stroke; its phrase takes the parts that it needs."""
        said = self.scene.say(phrase, *calculations, **parts)
        part = StrokePart.named(name)
        self.strokes.append(
            Stroke(kind, label, shape, said, link, component, reveals=reveals, part=part)
        )
