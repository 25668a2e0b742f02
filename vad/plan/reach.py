"""How far a panel reaches: its points, and levers and yokes with the travel of their blocks.

The strokes of a panel tell which body carries which block, and which points must be on the page.
"""

from __future__ import annotations

from collections.abc import Iterable

from vad.strokes.sheet import (
    Arc,
    Arrow,
    Bearing,
    Block,
    Curve,
    Dot,
    Ellipse,
    Guide,
    KennedyCircle,
    Line,
    Panel,
    Plate,
    Shape,
    Stroke,
)

#: The components of arrows upon a mechanism: forces and their arms, and the rates of a point.
UPON = ("load", "action", "couple", "absolute")


def is_load(stroke: Stroke) -> bool:
    """Tell whether an arrow in the picture of a mechanism is a force, its arm or a rate, no bar."""
    return isinstance(stroke.shape, Arrow) and stroke.component in UPON


def is_curved_arrow(stroke: Stroke) -> bool:
    """Tell whether an arc in the picture of a mechanism is a couple, or the ω of its check."""
    return isinstance(stroke.shape, Arc) and stroke.kind in ("known", "result")


def is_figure(stroke: Stroke) -> bool:
    """Tell whether a stroke belongs to a figure upon the mechanism, which stays."""
    return stroke.component == "figure"


def is_path(stroke: Stroke) -> bool:
    """Tell whether a stroke is a path upon the mechanism, which is cut where its room ends."""
    return is_figure(stroke) and stroke.kind == "construction" and isinstance(stroke.shape, Curve)


def is_bar(stroke: Stroke) -> bool:
    """Tell whether an arrow in the picture of a mechanism is the bar of a link."""
    return isinstance(stroke.shape, Arrow) and not is_load(stroke) and not is_figure(stroke)


def kennedy_circle(panel: Panel) -> Stroke | None:
    """Return the stroke that draws the circle of bodies beside a mechanism, if there is one."""
    return next((s for s in panel.strokes if isinstance(s.shape, KennedyCircle)), None)


def carries_block(panel: Panel, stroke: Stroke) -> bool:
    """Tell whether a block slides on the link of a bar, which then lies beneath it."""
    return stroke.link is not None and bool(panel.body(stroke.link).carries)


def block_on(panel: Panel, bar: Stroke) -> Stroke | None:
    """Return the block that slides on a bar, if it is drawn and its travel is known."""
    stroke = block_along(panel, bar)
    known = stroke and isinstance(stroke.shape, Block) and any(stroke.shape.travel)
    return stroke if known else None


def is_yoke(panel: Panel, link: str | None) -> bool:
    """Tell whether what slides on a guide has a slot for another block."""
    return link is not None and any(ride.slot for ride in panel.body(link).carries)


def block_along(panel: Panel, bearer: Stroke) -> Stroke | None:
    """Return the block that slides along a bar or in a slot, if it is drawn."""
    rides = (ride for ride in panel.body(bearer.link).carries if ride.along == bearer.name)
    numbers = (panel.find(ride.block) for ride in rides)
    strokes = (panel.strokes[number] for number in numbers if number is not None)
    return next((stroke for stroke in strokes if isinstance(stroke.shape, Block)), None)


def ends_of_travel(block: Shape) -> tuple[complex, complex]:
    """Return the two places between which a block gets along its line."""
    assert isinstance(block, Block)
    back, ahead = (block.at + by * block.direction for by in block.travel)
    return back, ahead


def reached(panel: Panel) -> list[complex]:
    """Return the points that levers, slots and yokes reach over all poses, in the panel's unit.

    The shaft of a yoke is as long as the yoke's travel, and lies ahead of it.
    """
    points: list[complex] = []
    for stroke in panel.strokes:
        match stroke.shape:
            case Block(on=str()):
                points += ends_of_travel(stroke.shape)
            case Block() if is_yoke(panel, stroke.link):
                back, ahead = ends_of_travel(stroke.shape)
                points += [back, 2 * ahead - back]
            case Guide(side=None):
                block = block_along(panel, stroke)
                points += ends_of_travel(block.shape) if block else ()
    return points


def extent(points: Iterable[complex]) -> complex:
    """Return the width and the height that points take, as real and imaginary part.

    Examples
    --------
    >>> extent([1j, 3 + 2j])
    (3+1j)
    """
    found = list(points) or [0j]
    xs, ys = [z.real for z in found], [z.imag for z in found]
    return complex(max(xs) - min(xs), max(ys) - min(ys))


def corners(panel: Panel) -> list[complex]:
    """Return the points of a panel that have to be on the page, in its own unit."""
    points = reached(panel)
    for stroke in panel.strokes:
        if is_path(stroke):
            continue
        if isinstance(stroke.shape, Dot):
            points.append(stroke.shape.at)
        elif isinstance(stroke.shape, Arrow):
            points += [stroke.shape.start, stroke.shape.end]
        elif isinstance(stroke.shape, Plate):
            points += stroke.shape.corners
        elif isinstance(stroke.shape, Line):
            points += [stroke.shape.through, stroke.shape.until]
        elif isinstance(stroke.shape, Curve):
            points += stroke.shape.points
        elif isinstance(stroke.shape, Ellipse):
            points += stroke.shape.outermost
        elif isinstance(stroke.shape, Bearing):
            points.append(stroke.shape.at)
        elif isinstance(stroke.shape, Arc) and is_figure(stroke):  # a whole circle
            points += [stroke.shape.centre + stroke.shape.radius * way for way in (1, 1j, -1, -1j)]
    return points
