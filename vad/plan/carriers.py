"""Moving links that carry a block: levers, and yokes with their slots.

In come the strokes of a position panel, out goes what carries what, and how far it reaches over all
poses.
"""

from __future__ import annotations

from vad.strokes.sheet import Arrow, Block, Guide, Panel, Stroke


def carries_block(panel: Panel, stroke: Stroke) -> bool:
    """Tell whether a block slides on the link of a bar, which then lies beneath it."""
    return any(
        isinstance(other.shape, Block) and other.shape.on == stroke.link for other in panel.strokes
    )


def block_on(panel: Panel, bar: Stroke) -> Block | None:
    """Return the block that slides on a bar, which ends there, if its way is known."""
    lever = bar.shape
    assert isinstance(lever, Arrow)
    close = 1e-9 * abs(lever.end - lever.start)
    blocks = (stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Block))
    riding = (block for block in blocks if block.on == bar.link and any(block.travel))
    return next((block for block in riding if abs(block.at - lever.end) <= close), None)


def is_yoke(panel: Panel, link: str | None) -> bool:
    """Tell whether what slides on a guide has a slot for another block."""
    return any(
        isinstance(other.shape, Guide) and other.shape.side is None and other.link == link
        for other in panel.strokes
    )


def block_in(panel: Panel, slot: str) -> Block | None:
    """Return the block of a slot by its stroke's name: ``CB.block`` in ``CB.slot``."""
    name = slot.replace(".slot", ".block")
    blocks = (s.shape for s in panel.strokes if s.name == name and isinstance(s.shape, Block))
    return next(blocks, None)


def ends_of_travel(block: Block) -> tuple[complex, complex]:
    """Return the two places between which a block gets along its line."""
    back, ahead = (block.at + by * block.direction for by in block.travel)
    return back, ahead


def reached(panel: Panel) -> list[complex]:
    """Return the points that levers, slots and yokes reach over all poses, in the panel's unit.

    A yoke's shaft is as long as its way, and runs on ahead of it.
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
                block = block_in(panel, stroke.name)
                points += ends_of_travel(block) if block else ()
    return points
