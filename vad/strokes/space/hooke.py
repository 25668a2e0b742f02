"""Hooke's joint: its rows, its two views and its polygons."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.sheet import Cell
from vad.strokes.space import hooke_polygons, hooke_views
from vad.strokes.space.body_rates import BodyRates
from vad.strokes.space.body_words import TURNED
from vad.strokes.space.hooke_views import swings
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import subscript

_UNITS = {"position": "", "velocity": "rad/s", "acceleration": "rad/s²"}
#: What α₄₂ grows by along OT.
GROWN = "α" + subscript(42) + "ₜ"


class HookeScene(SceneInSpace):
    """One pose of Hooke's joint."""

    output = "driven"
    headings: Mapping[str, str] = {"driving": "2", "cross": "3", "driven": "4"}

    @cached_property
    def rates(self) -> BodyRates:
        """How its bodies turn."""
        return hooke_polygons.joint_rates(self.motion)

    def drawing(self, diagram: Diagram) -> Drawing:
        """Return the views, or a polygon."""
        order = _ORDERS.get(diagram.name)
        if not order:
            return hooke_views.views(self)
        return hooke_polygons.polygon(self, self.rates, order)

    def unit_of(self, diagram: Diagram) -> str:
        """Return the unit of a diagram's coordinates: none in the views."""
        return _UNITS[diagram.name]

    def tracks(self, diagram: Diagram) -> Mapping[str, Any]:
        """Return where the lettered points of a diagram are."""
        order = _ORDERS.get(diagram.name)
        return hooke_polygons.tracks(self.rates, order) if order else hooke_views.tracks(self)

    def cells(self, diagram: Diagram, key: str) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row."""
        if key == "cross":
            return _CROSS[diagram.name](self)
        quantity, letter = _QUANTITIES[diagram.name]
        value = getattr(self.motion.link(key), quantity)
        unit, given = _UNITS[diagram.name] or "°", key == "driving"
        return (Cell(letter + subscript(int(self.headings[key])), value, unit, given),)


_QUANTITIES = {
    "position": ("angle", "θ"),
    "velocity": ("omega", "ω"),
    "acceleration": ("alpha", "α"),
}


def _cross_position(scene: HookeScene) -> tuple[Cell, ...]:
    at_p, at_q = swings(scene)
    return Cell("ψ_P", at_p, "°"), Cell("ψ_Q", at_q, "°")


def _cross_velocity(scene: HookeScene) -> tuple[Cell, ...]:
    motion = scene.motion
    size = np.linalg.norm(motion.link("cross").omega, axis=-1)
    values = {32: motion.joint("P").omega, 34: motion.joint("Q").omega, 3: size}
    return tuple(Cell("ω" + subscript(n), value, "rad/s") for n, value in values.items())


def _cross_acceleration(scene: HookeScene) -> tuple[Cell, ...]:
    along, across = scene.rates.relative(2)
    return Cell(GROWN, along, "rad/s²"), Cell(TURNED, across, "rad/s²")


_ORDERS = {"velocity": 1, "acceleration": 2}
_CROSS: Mapping[str, Callable[[HookeScene], tuple[Cell, ...]]] = {
    "position": _cross_position,
    "velocity": _cross_velocity,
    "acceleration": _cross_acceleration,
}
