"""Joined labels of lessons: each part of one names its dot, from the stroke that brings it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import pytest

import vad
from tests.plan.crossed_texts import stage_of
from tests.plan.knots import distance
from vad.files.examples import example_names
from vad.plan.anchors import Beside
from vad.plan.items import Item
from vad.plan.labels.obstacles import PIXEL
from vad.plan.labels.vertices import LETTER
from vad.plan.lens import Seen
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering, Mark
from vad.plan.page.free_places import box_of
from vad.plan.sketch import Sketch
from vad.plan.stage import Stage

#: By so much the tail of a Q makes the whole label taller than a part without it.
TAIL = 0.2 * LETTER


def parts(sketch: Sketch) -> Iterator[list[tuple[Item, float]]]:
    """Yield the parts of each label, the whole at last, with how far each is from its dot.

    A label in a lens is another one than that of the same dot beside it.
    """
    found: dict[tuple[Beside | object, ...], list[tuple[Item, float]]] = defaultdict(list)
    for item in sketch.items:
        rows = [(mark, hung) for mark in item.marks if (hung := _hung(mark))]
        if rows:
            off = min(distance(box_of(mark), _dot(mark, hung)) for mark, hung in rows)
            key = rows[0][1].anchor, isinstance(rows[0][0].hangs, Seen)
            found[key].append((item, off))
    yield from (sorted(each, key=lambda part: part[0].since) for each in found.values())


def _hung(mark: Mark) -> Beside | None:
    """Return on what a letter of a dot hangs; None for other marks."""
    hangs = mark.hangs.shape if isinstance(mark.hangs, Seen) else mark.hangs
    return hangs if mark.role == "letter" and isinstance(hangs, Beside) else None


def _dot(mark: Mark, hung: Beside) -> complex:
    """Return where the dot is on the page, which shows its panel larger than it was laid out."""
    assert isinstance(mark.shape, Lettering)
    return mark.shape.at - hung.offset * (mark.shape.size / hung.size)


def large_panels(stage: Stage) -> Iterator[tuple[int, Sketch]]:
    """Yield the panels in work, each with the number of its scene."""
    for scene in range(stage.count):
        for half in stage.sheet.panel(stage.layout(scene).large).halves:
            yield scene, stage.scene(scene).sketches[half.name]


def said(item: Item) -> str:
    """Return what an item says."""
    return "; ".join(plain(m.shape.runs) for m in item.marks if isinstance(m.shape, Lettering))


def strays(stage: Stage) -> list[str]:
    """Return one line for each part of a label that is farther from its dot than the whole."""
    return [
        f"scene {scene}: {said(item)}, {(off - whole) / PIXEL:.0f} px too far off"
        for scene, sketch in large_panels(stage)
        for *some, (_, whole) in parts(sketch)
        for item, off in some
        if off > whole + TAIL
    ]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_each_part_of_a_joined_label_is_seen_to_name_its_dot(name: str):
    assert not strays(stage_of(name))
