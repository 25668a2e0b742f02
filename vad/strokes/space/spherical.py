"""The spherical four-bar: its rows, its view of the sphere and its polygons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.sheet import Cell, Row
from vad.strokes.space import spherical_views
from vad.strokes.space.body_polygon import Bodies, polygon_of_bodies
from vad.strokes.space.body_rates import BodyRates, rates_on_sphere
from vad.strokes.space.body_words import BodyWords
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import subscript

_UNITS = {"position": "", "velocity": "rad/s", "acceleration": "rad/s²"}
_QUANTITIES = {
    "position": ("angle", "θ"),
    "velocity": ("omega", "ω"),
    "acceleration": ("alpha", "α"),
}
_ORDERS = {"velocity": 1, "acceleration": 2}
#: By its row: whose motion it is, and the numbers of the bodies that turn.
_BODIES = {
    "crank": ("crank", 2),
    "B": ("coupler", 32),
    "C": ("coupler", 34),
    "rocker": ("rocker", 4),
}
#: By the bodies that turn against each other: about which axis, and in which row.
_AXES = {"12": "OA", "24": "OI", "14": "OD", "23": "OB", "43": "OC"}
_ROWS = {"12": "crank", "24": "B", "14": "rocker", "23": "B", "43": "C"}
_MEASURED = {"12", "14", "23", "43"}


class SphericalScene(SceneInSpace):
    """One pose of the spherical four-bar."""

    output = "rocker"
    headings: Mapping[str, str] = {"crank": "A", "B": "B", "C": "C", "rocker": "D"}

    def drawing(self, diagram: Diagram) -> Drawing:
        """Return the view of the sphere, or a polygon."""
        if diagram.name in _ORDERS:
            return polygon_of_bodies(self._bodies(_ORDERS[diagram.name]))
        return spherical_views.views(self, self.rates)

    @cached_property
    def rates(self) -> BodyRates:
        """How its bodies turn."""
        return rates_on_sphere(self.motion)

    def _bodies(self, order: int) -> Bodies:
        words = BodyWords(self, order, self.rates)
        remark = self.say("bodies remark")
        return Bodies(self.rates, words, _AXES, _ROWS, _MEASURED, True, remark, centre=0j)

    def unit_of(self, diagram: Diagram) -> str:
        """Return the unit of a diagram's coordinates: none on the sphere, whose radius is 1."""
        return _UNITS[diagram.name]

    def tracks(self, diagram: Diagram) -> Mapping[str, Any]:
        """Return where the lettered points of a diagram are."""
        if diagram.name in _ORDERS:
            return self.rates.vertices(_ORDERS[diagram.name])
        return spherical_views.tracks(self.rates)

    def cells(self, diagram: Diagram, key: str) -> tuple[Cell, ...]:
        """Return the angle, ω or α of a row."""
        quantity, letter = _QUANTITIES[diagram.name]
        part = self.motion.joint(key) if key in "BC" else self.motion.link(key)
        symbol = letter if quantity == "angle" else letter + subscript(_BODIES[key][1])
        unit = _UNITS[diagram.name] or "°"
        return (Cell(symbol, getattr(part, quantity), unit, key == "crank"),)

    def rows(self, diagrams: Sequence[Diagram]) -> list[Row]:
        """Return the rows of the results, each with its axis."""
        names = self.language.name
        return [replace(row, title=names(_BODIES[row.key][0])) for row in super().rows(diagrams)]
