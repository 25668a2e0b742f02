"""Counting the texts that something crosses on its way from panel to panel, without pixels.

``python -m tests.plan.crossed_texts`` counts them over all mechanisms and examples, in about two
minutes.  With names it counts those of some, and says what crosses what.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import vad
from tests.plan.overlaps import KEY
from vad.files.examples import example_names, example_path
from vad.lecture.moment import Moment
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import CAPTION, FLIGHT, HEAD, TITLE, Item
from vad.plan.lettering.runs import plain
from vad.plan.making_way import FAINT
from vad.plan.marks import Bending, Bow, Flying, Lettering, Mark, Outline, Polygon, Polyline
from vad.plan.page.changing import SAID
from vad.plan.page.free_places import box_of, meet
from vad.plan.scene_layout import WORK
from vad.plan.stage import Stage
from vad.strokes.travels import travels

#: At so many moments of a flight is looked.
MOMENTS = 40
#: A text with more ink does not make way.
PALE = SAID + 0.1
#: So wide is what belongs to a number: the comma behind it.
SPACE = 0.012


class Crossing(NamedTuple):
    """What crosses which text.

    Attributes
    ----------
    stroke
        With which stroke it flies.
    flies
        What it is: a vector, an image or a number.
    kind, text
        What it crosses: a heading, an equation, a row, a caption or a label, and its words.
    pale
        Whether that makes way.
    """

    stroke: str
    flies: str
    kind: str
    text: str
    pale: bool


def kind_of(name: str) -> type:
    """Return the class of a mechanism or of an example."""
    return vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))


@lru_cache(maxsize=32)
def stage_of(name: str, size: tuple[int, int] = (1280, 720), language: str = "en") -> Stage:
    """Return the stage of the lecture of a mechanism or an example, as it is without options."""
    sheet = vad.draw(vad.solve(kind_of(name)()), language=language)
    return Stage(sheet, screen(size), KEY, travels(sheet))


def flights(stage: Stage) -> Iterator[tuple[int, Item]]:
    """Yield the number of a scene with what flies in it."""
    for scene in range(stage.count):
        plan, large = stage.scene(scene), stage.sheet.panel(stage.layout(scene).large)
        settings = [plan.sketches[half.name].setting for half in large.halves]
        first = min(each.during(0) for each in settings)
        last = max(each.over(len(each.panel.strokes) - 1) for each in settings)
        for item in plan.items:
            if item.region == FLIGHT and first <= item.since < last:
                yield scene, item


def crossings(stage: Stage, scene: int, item: Item) -> list[Crossing]:
    """Return what a flight crosses."""
    moving = [mark for mark in item.marks if isinstance(mark.growth, Flying | Bending)]
    flies = _what(moving)
    inks: dict[tuple[str, str], float] = {}
    for share in ((number + 0.5) / MOMENTS for number in range(MOMENTS)):
        now = [at.shape for mark in moving if (at := mark.at(share)) and at.alpha > FAINT]
        for each in stage.at(Moment(item.since, share, scene)):
            for text in each.at(share) if each.since == item.since else each.marks:
                if not isinstance(text.shape, Lettering) or _comes_from(each, item, flies):
                    continue
                boxes = [box_of(replace(text, growth=None))]
                if flies == "number" and each.region == CAPTION and each.stroke == item.stroke:
                    boxes = _beside(boxes[0], moving)
                if any(_meets(shape, box) for shape in now for box in boxes):
                    key = _kind(each, text), plain(text.shape.runs)
                    inks[key] = max(text.alpha, inks.get(key, 0.0))
    return [Crossing(item.stroke, flies, *key, ink < PALE) for key, ink in inks.items()]


def _what(moving: list[Mark]) -> str:
    if any(isinstance(mark.shape, Lettering) for mark in moving):
        return "number"
    return "image" if any(mark.role == "plate" for mark in moving) else "vector"


def _comes_from(text: Item, item: Item, flies: str) -> bool:
    """Tell whether something flies itself, or a number comes to its row or is not yet said."""
    own = text.stroke == item.stroke and text.region != CAPTION and text.grows
    unsaid = not text.words[0] <= item.words[0] < text.words[1]
    return text.region == FLIGHT or (flies == "number" and own) or unsaid


def _beside(line: Rect, moving: list[Mark]) -> list[Rect]:
    """Return the parts of a line of a caption beside the number that leaves it."""
    [number] = [mark for mark in moving if isinstance(mark.shape, Lettering)]
    own = box_of(replace(number, growth=None))
    if own.top < line.bottom or line.top < own.bottom:
        return [line]
    parts = replace(line, right=own.left - SPACE), replace(line, left=own.right + SPACE)
    return [part for part in parts if part.left < part.right]


def _kind(item: Item, text: Mark) -> str:
    place = item.region.rpartition(":")[2]
    if place == WORK:
        return "equation" if "term" in text.role else "row"
    if place == TITLE or place.endswith(HEAD):
        return "heading"
    return "caption" if place == CAPTION else "label"


def _meets(shape: Outline, box: Rect) -> bool:
    match shape:
        case Polyline(lines):
            pass
        case Polygon(rings):
            lines = tuple((*ring, ring[0]) for ring in rings)
        case Bow():
            lines = (tuple(shape.curve()),)
        case _:
            return meet(box_of(Mark(shape, "words")), box)
    return any(box.clipped(*each) for line in lines for each in pairwise(line))


def _print(names: list[str]) -> None:
    flown, texts = 0, Counter[tuple[str, str]]()
    crossing, dark = Counter[tuple[str, str]](), Counter[tuple[str, str]]()
    for name in names or [*vad.MECHANISMS, *example_names()]:
        stage = stage_of(name)
        for scene, item in flights(stage):
            found = crossings(stage, scene, item)
            flown += 1
            texts.update((each.flies, each.kind) for each in found)
            crossing.update({(each.flies, each.kind) for each in found})
            dark.update({(each.flies, each.kind) for each in found if not each.pale})
            for each in found if names else ():
                print(name, *each)
    print(f"{flown} flights")
    for key, count in sorted(crossing.items()):
        print(*key, f"{count} flights cross {texts[key]} texts; in {dark[key]} they are not pale")


if __name__ == "__main__":
    _print(sys.argv[1:])
