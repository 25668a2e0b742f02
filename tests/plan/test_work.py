"""The rows beside the large panel of a scene: within a chapter they are only added to, or fade."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

import vad
from tests.plan.crossed_texts import stage_of
from vad.files.examples import example_names
from vad.plan.board import Plan
from vad.plan.items import FOREVER
from vad.plan.lettering.runs import plain
from vad.plan.marks import Fading, Lettering
from vad.plan.page.work import parts
from vad.plan.stage import Stage

EVERY = [*vad.MECHANISMS, *example_names()]
#: A cell with the beats between which it shows, and its growth.
Shown = tuple[str, int, int, Fading | None]


def chapters(stage: Stage) -> Iterator[list[Shown]]:
    """Yield the cells of each chapter of the polygons, all within its beats."""
    for number in range(stage.count):
        scene, panel = stage.scene(number), stage.sheet.panel(stage.layout(number).large)
        if panel.picture == "vectors":
            begun = [scene.sketches[p.half.name].setting.during(p.first) for p in parts(panel)]
            for since, until in zip(begun, [*begun[1:], FOREVER], strict=True):
                yield [
                    (symbol, max(first, since), min(last, until), growth)
                    for symbol, first, last, growth in cells(scene)
                    if first < until and since < last
                ]


def cells(scene: Plan) -> Iterator[Shown]:
    for item in (item for item in scene.items if item.region.endswith(":work")):
        for mark in item.marks:
            if isinstance(mark.shape, Lettering) and " = " in plain(mark.shape.runs):
                symbol, _, _ = plain(mark.shape.runs).partition(" = ")
                assert mark.growth is None or isinstance(mark.growth, Fading)
                yield symbol, item.since, item.until, mark.growth


@pytest.mark.exhaustive(60)
@pytest.mark.parametrize("language", ["en", "de", "fr"])
@pytest.mark.parametrize("name", EVERY)
def test_no_cell_goes_while_its_chapter_is_told(name: str, language: str):
    for shown in chapters(stage_of(name, language=language)):
        last = max((until for _, _, until, _ in shown), default=0)
        for symbol, _, until, _ in shown:
            others = (each for each in shown if each[0] == symbol)
            assert until == last or any(since == until for _, since, *_ in others), symbol


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", EVERY)
def test_a_cell_that_goes_for_want_of_room_fades(name: str):
    for shown in chapters(stage_of(name, (960, 720))):
        last = max((until for _, _, until, _ in shown), default=0)
        for symbol, _, until, growth in shown:
            others = (each for each in shown if each[0] == symbol)
            if until < last and not any(since == until for _, since, *_ in others):
                assert growth and growth.knots[-1][1] == 0.0, symbol


@pytest.mark.parametrize(
    ("language", "word"), [("en", "positive"), ("de", "positiv"), ("fr", "positif")]
)
def test_the_sense_in_which_rates_are_positive_stands_below_them(language: str, word: str):
    """It stands in the scenes of the polygons and in the whole sheet; angles alone need none."""
    stage = stage_of("slider-crank", language=language)
    for number, at_work in enumerate([0, 1, 1, 1]):
        items = [
            i for i in stage.scene(number).items if "results" in i.region or "work" in i.region
        ]
        shapes = [mark.shape for item in items for mark in item.marks]
        texts = [plain(each.runs) for each in shapes if isinstance(each, Lettering)]
        assert [each.split() for each in texts if "↺" in each] == at_work * [["↺", word]]
