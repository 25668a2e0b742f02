"""The ball-jointed four-bar: its rows, its views and its polygons."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np

from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.sheet import Cell
from vad.strokes.space import balls_polygons, balls_views
from vad.strokes.space.balls_said import BODIES
from vad.strokes.space.balls_seen import Seen
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import per_second, subscript

_QUANTITIES = {
    "position": ("angle", "θ", "°"),
    "velocity": ("omega", "ω", "rad/s"),
    "acceleration": ("alpha", "α", "rad/s²"),
}


class BallScene(SceneInSpace):
    """One pose of the ball-jointed four-bar."""

    output = "rocker"
    headings: Mapping[str, str] = {"crank": "AB", "coupler": "BC", "rocker": "DC"}

    def drawing(self, diagram: Diagram) -> Drawing:
        """Return the views, or a polygon."""
        if diagram.name == "position":
            return balls_views.views(self, self.seen)
        return balls_polygons.polygon(self, self.seen, _order(diagram))

    @cached_property
    def seen(self) -> Seen:
        """From where it is seen."""
        return Seen(self.motion)

    def unit_of(self, diagram: Diagram) -> str:
        """Return the unit of a diagram's coordinates."""
        order = _order(diagram)
        return per_second(self.unit, order) if order else self.unit

    def tracks(self, diagram: Diagram) -> Mapping[str, Any]:
        """Return where the lettered points of a diagram are."""
        order = _order(diagram)
        return balls_polygons.tracks(self.seen, order) if order else balls_views.tracks(self.seen)

    def cells(self, diagram: Diagram, key: str) -> tuple[Cell, ...]:
        """Return what a diagram adds to a row; the coupler has rates without its idle spin."""
        quantity, letter, unit = _QUANTITIES[diagram.name]
        if key == "coupler" and quantity == "angle":
            return ()
        value = getattr(self.motion.link(key), quantity)
        if key == "coupler":
            value = _size(value)
        cell = Cell(letter + subscript(BODIES[key]), value, unit, key == "crank")
        if quantity != "omega" or key == "crank":
            return (cell,)
        return cell, Cell("v", self._speed(key), per_second(self.unit, 1))

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


def _order(diagram: Diagram) -> int:
    return tuple(_QUANTITIES).index(diagram.name)
