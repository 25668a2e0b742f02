"""What travels: the figure upon a mechanism becomes the polygon whose shape it has.

In a film it flies from its panel to that of the polygon.  On a page each panel is a picture of its
own, which nothing can leave: there the figure turns into its place within the polygon's panel.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from vad.plan.items import FLIGHT, Item, Level
from vad.plan.marks import Flying, Growth, Leg, Mark, Turning, line
from vad.plan.reach import corners
from vad.plan.sketch import Sketch
from vad.strokes.shapes import Turned
from vad.strokes.sheet import Arrow, Panel

#: A figure that is more often as large as its polygon, or as small, is not on the same page.
MOST = 1e3


def turned_polygons(sketches: Mapping[str, Sketch], apart: bool) -> Iterator[Item]:
    """Yield what shows that a figure has the shape of a polygon, while that is finished.

    ``apart`` says whether panels are pictures of their own, which nothing can leave.
    """
    for figure in sketches.values():
        for turned in figure.setting.panel.turned:
            polygon = sketches.get(turned.panel)
            sides = list(_sides(polygon, None)) if polygon else []
            if polygon and sides:
                flight = None if apart else flying(figure, polygon, turned)
                yield from _shown(polygon, flight or turning(polygon, turned), flight is not None)


def _shown(polygon: Sketch, growth: Growth, flies: bool) -> Iterator[Item]:
    """Yield a figure on its way, and then as it lies on its polygon."""
    setting, panel = polygon.setting, polygon.setting.panel
    last = len(panel.strokes) - 1
    name = panel.full(panel.strokes[last].name)
    during, after, over = setting.during(last), setting.after(last), setting.over(last)
    moving, lying = tuple(_sides(polygon, growth)), tuple(_sides(polygon, None))
    if flies:
        inked = tuple(replace(mark, role="whole") for mark in moving)
        yield Item(name, FLIGHT, Level.GLOW, moving + inked, during, after)
        yield Item(name, panel.column, Level.GLOW, lying, after, over)
    else:
        yield Item(name, panel.column, Level.GLOW, moving, during, over)


def _sides(polygon: Sketch, growth: Growth | None) -> Iterator[Mark]:
    """Yield the sides of the figure as they lie on the polygon.

    A whole vector beside its own parts is no side of it.
    """
    for stroke in polygon.setting.panel.strokes:
        if isinstance(stroke.shape, Arrow) and stroke.part.which != "whole":
            ends = [polygon.scale(stroke.shape.start), polygon.scale(stroke.shape.end)]
            yield line(ends, "vector light", polygon.setting.row(stroke.link), growth)


def flying(figure: Sketch, polygon: Sketch, turned: Turned) -> Flying | None:
    """Return how a figure flies onto its polygon; None where it is not on the page.

    At a share s of the flight a point z of the polygon stands at ::

        f·(z − P) + P + (1 − s)·(A − P),    f = (1 + (1 − s)(k − 1))·exp(−iφ(1 − s))

    with the pole P of the polygon, the pole A of the figure, the angle φ between them, and k, how
    many times as large as the polygon the figure is.
    """
    pole, start = polygon.scale(0j), figure.scale(turned.pole)
    size = polygon.scale.factor * turned.rate
    if not figure.scale.factor < MOST * size or not size < MOST * figure.scale.factor:
        return None
    first = Leg(0.0, start - pole, figure.scale.factor / size, -turned.degrees)
    return Flying(pole, (first, Leg(1.0, 0j)))


def turning(polygon: Sketch, turned: Turned) -> Turning:
    """Return how a polygon turns about its middle into its place, so that it stays in its panel."""
    panel: Panel = polygon.setting.panel
    ends = [polygon.scale(z) for z in corners(panel)]
    across, upright = sorted(z.real for z in ends), sorted(z.imag for z in ends)
    middle = complex(across[0] + across[-1], upright[0] + upright[-1]) / 2
    return Turning(middle, ((0.0, -turned.degrees), (1.0, 0.0)))
