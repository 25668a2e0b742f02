"""The spherical four-bar: its rows, its view of the sphere and its polygons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

from vad.strokes.diagram import Diagram, Drawing, Order, Spot
from vad.strokes.sheet import Cell, Row
from vad.strokes.space import spherical_views
from vad.strokes.space.body_polygon import Bodies, polygon_of_bodies
from vad.strokes.space.body_rates import BodyRates, rates_on_sphere
from vad.strokes.space.body_words import BodyWords
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.written import subscript

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

    def drawing(self, order: Order) -> Drawing:
        """Return the view of the sphere, or a polygon."""
        if order.number:
            return polygon_of_bodies(self._bodies(order.number))
        return spherical_views.views(self, self.rates)

    @cached_property
    def rates(self) -> BodyRates:
        """How its bodies turn."""
        return rates_on_sphere(self.motion)

    def _bodies(self, order: int) -> Bodies:
        words = BodyWords(self, order, self.rates)
        remark = self.write("bodies remark")
        return Bodies(self.rates, words, _AXES, _ROWS, _MEASURED, True, remark, centre=0j)

    def unit_of(self, order: Order) -> str:
        """Return the unit of a diagram's coordinates: none on the sphere, whose radius is 1."""
        return order.unit if order.number else ""

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points of a diagram are."""
        rates, number = self.rates, order.number
        found = rates.vertices(number) if number else spherical_views.tracks(rates)
        return {Spot(letter): at for letter, at in found.items()}

    def cells(self, order: Order, key: str, slides: bool = False) -> tuple[Cell, ...]:
        """Return the angle, ω or α of a row."""
        part = self.motion.joint(key) if key in "BC" else self.motion.link(key)
        number = subscript(_BODIES[key][1]) if order.number else ""
        given = key == "crank"
        return (Cell(order.symbol + number, getattr(part, order.rate), order.unit, given),)

    def rows(self, diagrams: Sequence[Diagram]) -> list[Row]:
        """Return the rows of the results, each with its axis."""
        return [
            replace(row, title=self.name(_BODIES[row.key][0])) for row in super().rows(diagrams)
        ]
