"""One pose of a mechanism in space as the board sees it: words, numbers, and what is drawn."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from vad.kinematics.linkage import Scalar
from vad.strokes.sentences import Saying
from vad.strokes.sheet import Cell, Row

if TYPE_CHECKING:
    from vad.kinematics.motion import MotionInSpace
    from vad.strokes.diagram import Diagram, Drawing, Order, Spot


@dataclass(frozen=True)
class SceneInSpace(Saying, ABC):
    """A motion in space, the language of its captions, and what its mechanism draws of it."""

    motion: MotionInSpace[Any, Any]

    @property
    def unit(self) -> str:
        """The unit of lengths."""
        return self.motion.mechanism.length_unit

    @property
    def driver(self) -> Scalar:
        """The scalar that drives the mechanism."""
        return self.motion.solver.driver

    @property
    @abstractmethod
    def output(self) -> str:
        """The row of what the mechanism is there for."""

    @property
    @abstractmethod
    def headings(self) -> Mapping[str, str]:
        """The letters of every row of the results, by its key."""

    @abstractmethod
    def drawing(self, order: Order) -> Drawing:
        """Return the views, or the polygon of an order."""

    @abstractmethod
    def unit_of(self, order: Order) -> str:
        """Return the unit of the coordinates in its diagram."""

    @abstractmethod
    def cells(self, order: Order, key: str, slides: bool = False) -> tuple[Cell, ...]:
        """Return what the diagram of an order adds to a row of the results."""

    @abstractmethod
    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points of a diagram are."""

    def rows(self, diagrams: Sequence[Diagram]) -> list[Row]:
        """Return the rows of the results."""
        return [
            Row(
                key,
                self.name(key),
                letters,
                {diagram.name: diagram.cells(self, key, False) for diagram in diagrams},
            )
            for key, letters in self.headings.items()
        ]
