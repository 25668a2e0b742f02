"""The spatial four-bar: its rows, its pictorial view and its polygons, two in a column."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.sheet import Cell
from vad.strokes.space import spatial_polygons, spatial_views
from vad.strokes.space.scene_in_space import SceneInSpace
from vad.strokes.space.screw_rates import ScrewRates
from vad.strokes.space.spatial_places import points
from vad.strokes.space.spatial_polygons import ALONG_D, ALONG_I, RELATIVE
from vad.written import per_second, subscript

_ORDERS = {"position": 0, "velocity": 1, "acceleration": 2}
_TURNING = "°", "rad/s", "rad/s²"
#: Of crank and rocker, by their order.
_SYMBOLS, _QUANTITIES = "θωα", ("angle", "omega", "alpha")
_BODIES = {"crank": 2, "rocker": 4}
_SLIDING = "position", "velocity", "acceleration"


class SpatialScene(SceneInSpace):
    """One pose of the spatial four-bar."""

    output = "rocker"
    headings: Mapping[str, str] = {"crank": "A", "axis": "I", "rocker": "D"}

    @cached_property
    def rates(self) -> ScrewRates:
        """How the rocker moves against the crank."""
        return ScrewRates(self.motion)

    def drawing(self, diagram: Diagram) -> Drawing:
        """Return the pictorial view, or two polygons."""
        order = _ORDERS[diagram.name]
        if not order:
            return spatial_views.views(self, self.rates)
        return spatial_polygons.polygons(self, self.rates, order)

    def unit_of(self, diagram: Diagram) -> str:
        """Return the unit of a diagram's coordinates: of a polygon that of the upper one."""
        order = _ORDERS[diagram.name]
        return _TURNING[order] if order else self.unit

    def tracks(self, diagram: Diagram) -> Mapping[str, Any]:
        """Return where the lettered points of a diagram are."""
        order = _ORDERS[diagram.name]
        return self.rates.tracks(order) if order else points(self.rates)

    def cells(self, diagram: Diagram, key: str) -> tuple[Cell, ...]:
        """Return how a row turns, and how it slides."""
        order = _ORDERS[diagram.name]
        unit = per_second(self.unit, order)
        if key == "axis":
            return self._axis(order, unit)
        value = getattr(self.motion.link(key), _QUANTITIES[order])
        symbol = _SYMBOLS[order] + subscript(_BODIES[key])
        turning = Cell(symbol, value, _TURNING[order], key == "crank")
        if key == "crank":
            return (turning,)
        slid = getattr(self.motion.slide("slide_d"), _SLIDING[order])
        return turning, Cell(ALONG_D[order] if order else "s_D", slid, unit)

    def _axis(self, order: int, unit: str) -> tuple[Cell, ...]:
        """Return where I is, or what turns about it and slides along it."""
        rates = self.rates
        if not order:
            return Cell("τ", rates.axis.tau, "°"), Cell("AH", rates.height, unit)
        turning, sliding = rates.about_i(order)[0], rates.of_a(order)[0]
        return Cell(RELATIVE[order], turning, _TURNING[order]), Cell(ALONG_I[order], sliding, unit)
