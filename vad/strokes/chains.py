"""The vectors of one polygon, chain by chain, in the order in which they are laid tip to tail."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import cast

from vad.kinematics.linkage import Bar, Scalar, Slide, Step, scalar_of
from vad.strokes.scene import Scene
from vad.strokes.sheet import Component

#: Vectors shorter than this share of the longest one of a panel are zero.
NOTHING = 1e-12


@dataclass(frozen=True, slots=True)
class Part:
    """One component of one step: ``vector`` runs with the step, in the user's units.

    ``unknown`` marks the one whose length the crossing has to find.
    """

    step: Step
    name: Component
    vector: complex
    direction: complex
    unknown: bool

    @property
    def stroke_name(self) -> str:
        """What the stroke that draws it is called: ``AB.normal``."""
        return f"{self.step.ends}.{self.name}"

    @property
    def reverse(self) -> bool:
        """Whether its chain runs through it from head to tail."""
        return self.step.reverse


class Chain:
    """One side of a loop equation of a given order."""

    def __init__(
        self, scene: Scene, steps: tuple[Step, ...], unknowns: tuple[Scalar, ...], order: int
    ) -> None:
        self.steps = steps
        self.start, self.end = steps[0].start, steps[-1].end
        parts = [part for step in steps for part in _parts(scene, step, unknowns, order)]
        self.known = _coriolis_last([part for part in parts if not part.unknown])
        self.unknown = next((part for part in parts if part.unknown), None)
        self.longest = max((abs(part.vector) for part in parts), default=0.0)

    def wholly_known(self, step: Step) -> bool:
        """Tell whether every component of a step is known beforehand."""
        return self.unknown is None or self.unknown.step is not step


def _parts(scene: Scene, step: Step, unknowns: tuple[Scalar, ...], order: int) -> Iterator[Part]:
    pose = scene.motion.pose
    for component in scene.motion.frame.components(step, pose, scene.orders(order)):
        direction = scene.heading(component.direction)
        amount = float(cast(float, component.amount)) * scene.motion.frame.scale
        found = component.name in ("tangential", "sliding") and scalar_of(step) in unknowns
        yield Part(step, component.name, amount * direction, direction, found)


def _coriolis_last(parts: list[Part]) -> list[Part]:
    """Put the Coriolis part of a strut behind the normal part of the bar that has its length."""
    struts = {
        part.step.name
        for part in parts
        if part.name == "coriolis" and isinstance(part.step, Slide) and not part.reverse
    }
    late = [part for part in parts if part.name == "coriolis" and not part.reverse]
    if not any(isinstance(part.step, Bar) and part.step.length in struts for part in parts):
        return parts
    return [part for part in parts if part not in late] + late
