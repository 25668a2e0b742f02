"""Hooke's joint: its rows, its two views and its polygons."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from vad.strokes.diagram import Drawing, Order, Spot
from vad.strokes.sheet import Cell
from vad.strokes.space import hooke_polygons, hooke_views
from vad.strokes.space.body_rates import BodyRates
from vad.strokes.space.body_words import TURNED
from vad.strokes.space.hooke_views import swings
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import subscript

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

    def drawing(self, order: Order) -> Drawing:
        """Return the views, or a polygon."""
        if not order.number:
            return hooke_views.views(self)
        return hooke_polygons.polygon(self, self.rates, order.number)

    def unit_of(self, order: Order) -> str:
        """Return the unit of a diagram's coordinates: none in the views."""
        return order.unit if order.number else ""

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points of a diagram are."""
        if not order.number:
            return hooke_views.tracks(self)
        return hooke_polygons.tracks(self.rates, order.number)

    def cells(self, order: Order, key: str, slides: bool = False) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row."""
        if key == "cross":
            return _CROSS[order.number](self)
        value = getattr(self.motion.link(key), order.rate)
        symbol = order.symbol + subscript(int(self.headings[key]))
        return (Cell(symbol, value, order.unit, key == "driving"),)


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


#: What is measured of the cross, by the number of the order.
_CROSS: tuple[Callable[[HookeScene], tuple[Cell, ...]], ...] = (
    _cross_position,
    _cross_velocity,
    _cross_acceleration,
)
