"""Hooke's joint: its rows, its two views and its polygons."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.sheet import Cell
from vad.strokes.space import hooke_polygons, hooke_views
from vad.strokes.space.hooke_polygons import GROWN, TURNED, JointAccelerations, turning
from vad.strokes.space.hooke_views import swings
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import subscript

_UNITS = {"position": "", "velocity": "rad/s", "acceleration": "rad/s²"}


class HookeScene(SceneInSpace):
    """One pose of Hooke's joint."""

    output = "driven"
    headings: Mapping[str, str] = {"driving": "2", "cross": "3", "driven": "4"}

    def drawing(self, diagram: Diagram) -> Drawing:
        """Return the views, or a polygon."""
        return _DRAWINGS[diagram.name](self)

    def unit_of(self, diagram: Diagram) -> str:
        """Return the unit of a diagram's coordinates: none in the views."""
        return _UNITS[diagram.name]

    def tracks(self, diagram: Diagram) -> Mapping[str, Any]:
        """Return where the lettered points of a diagram are."""
        return _TRACKS[diagram.name](self)

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


def _cross_position(scene: SceneInSpace) -> tuple[Cell, ...]:
    at_p, at_q = swings(scene)
    return Cell("ψ", at_p, "°"), Cell("ψ", at_q, "°")


def _cross_velocity(scene: SceneInSpace) -> tuple[Cell, ...]:
    motion = scene.motion
    size = np.linalg.norm(motion.link("cross").omega, axis=-1)
    values = {32: motion.joint("P").omega, 34: motion.joint("Q").omega, 3: size}
    return tuple(Cell(turning("ω", bodies), value, "rad/s") for bodies, value in values.items())


def _cross_acceleration(scene: SceneInSpace) -> tuple[Cell, ...]:
    rates = JointAccelerations(scene)
    turned = Cell(TURNED, rates.turning, "rad/s²")
    return turned, Cell(GROWN, rates.alpha42, "rad/s²")


_DRAWINGS: Mapping[str, Callable[[SceneInSpace], Drawing]] = {
    "position": hooke_views.views,
    "velocity": hooke_polygons.velocity,
    "acceleration": hooke_polygons.acceleration,
}
_TRACKS: Mapping[str, Callable[[SceneInSpace], Mapping[str, Any]]] = {
    "position": hooke_views.tracks,
    "velocity": hooke_polygons.velocity_tracks,
    "acceleration": hooke_polygons.acceleration_tracks,
}
_CROSS: Mapping[str, Callable[[SceneInSpace], tuple[Cell, ...]]] = {
    "position": _cross_position,
    "velocity": _cross_velocity,
    "acceleration": _cross_acceleration,
}
