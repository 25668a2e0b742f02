"""The spatial four-bar: its rows, its pictorial view and its polygons, two in a column."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

from vad.strokes.diagram import Drawing, Order, Spot
from vad.strokes.sheet import Cell
from vad.strokes.space import spatial_polygons, spatial_views
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.strokes.space.screw_rates import ScrewRates
from vad.strokes.space.spatial_places import points
from vad.strokes.space.spatial_polygons import ALONG_D, ALONG_I, RELATIVE
from vad.written import subscript

_BODIES = {"crank": 2, "rocker": 4}


class SpatialScene(SceneInSpace):
    """One pose of the spatial four-bar."""

    output = "rocker"
    headings: Mapping[str, str] = {"crank": "A", "axis": "I", "rocker": "D"}

    @cached_property
    def rates(self) -> ScrewRates:
        """How the rocker moves against the crank."""
        return ScrewRates(self.motion)

    def drawing(self, order: Order) -> Drawing:
        """Return the pictorial view, or two polygons."""
        if not order.number:
            return spatial_views.views(self, self.rates)
        return spatial_polygons.polygons(self, self.rates, order.number)

    def unit_of(self, order: Order) -> str:
        """Return the unit of a diagram's coordinates: of a polygon that of the upper one."""
        return order.unit if order.number else self.unit

    def tracks(self, order: Order) -> Mapping[Spot, Any]:
        """Return where the lettered points of a diagram are."""
        if order.number:
            return self.rates.tracks(order.number)
        return {Spot(letter): at for letter, at in points(self.rates).items()}

    def cells(self, order: Order, key: str, slides: bool = False) -> tuple[Cell, ...]:
        """Return how a row turns, and how it slides."""
        if key == "axis":
            return self._axis(order)
        value = getattr(self.motion.link(key), order.rate)
        symbol = order.symbol + subscript(_BODIES[key])
        turning = Cell(symbol, value, order.unit, key == "crank")
        if key == "crank":
            return (turning,)
        slid = getattr(self.motion.slide("slide_d"), order.panel)
        symbol = ALONG_D[order.number] if order.number else "s_D"
        return turning, Cell(symbol, slid, order.unit_of(self.unit))

    def _axis(self, order: Order) -> tuple[Cell, ...]:
        """Return where I is, or what turns about it and slides along it."""
        rates, number, unit = self.rates, order.number, order.unit_of(self.unit)
        if not number:
            return Cell("τ", rates.axis.tau, "°"), Cell("AH", rates.height, unit)
        turning, sliding = rates.about_i(number)[0], rates.of_a(number)[0]
        return Cell(RELATIVE[number], turning, order.unit), Cell(ALONG_I[number], sliding, unit)
