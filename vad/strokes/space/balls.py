"""The ball-jointed four-bar: its rows, its views and its polygons."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np

from vad.strokes.diagram import VELOCITY, Drawing, Order, Spot
from vad.strokes.sheet import Cell
from vad.strokes.space import balls_polygons, balls_views
from vad.strokes.space.balls_said import BODIES
from vad.strokes.space.balls_seen import Seen
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import subscript


class BallScene(SceneInSpace):
    """One pose of the ball-jointed four-bar."""

    output = "rocker"
    headings: Mapping[str, str] = {"crank": "AB", "coupler": "BC", "rocker": "DC"}

    def drawing(self, order: Order) -> Drawing:
        """Return the views, or a polygon."""
        if not order.number:
            return balls_views.views(self, self.seen)
        return balls_polygons.polygon(self, self.seen, order.number)

    @cached_property
    def seen(self) -> Seen:
        """From where it is seen."""
        return Seen(self.motion)

    def unit_of(self, order: Order) -> str:
        """Return the unit of a diagram's coordinates."""
        return order.unit_of(self.unit)

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points of a diagram are."""
        if not order.number:
            return balls_views.tracks(self.seen)
        found = balls_polygons.tracks(self.seen, order.number)
        return {Spot(letter): at for letter, at in found.items()}

    def cells(self, order: Order, key: str, slides: bool = False) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row; the coupler has rates without its idle spin."""
        if key == "coupler" and not order.number:
            return ()
        value = getattr(self.motion.link(key), order.rate)
        if key == "coupler":
            value = _size(value)
        symbol = order.symbol + subscript(BODIES[key])
        cell = Cell(symbol, value, order.unit, key == "crank")
        if order != VELOCITY or key == "crank":
            return (cell,)
        return cell, Cell(order.sliding, self._speed(key), order.unit_of(self.unit))

    def _speed(self, key: str) -> Any:
        """Return the speed of C, relative to B for the coupler."""
        velocity = self.motion.point("C").velocity
        if key == "coupler":
            velocity = velocity - self.motion.point("B").velocity
        return _size(velocity)


def _size(vector: Any) -> Any:
    """Return the length of a vector: a number, or an array of them."""
    size = np.linalg.norm(vector, axis=-1)
    return size if size.ndim else float(size)
