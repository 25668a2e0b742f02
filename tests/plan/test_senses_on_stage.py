"""In a film the sense of each ω and α is seen: on its link, or behind its number in its row."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import pytest

import vad
from tests.plan.crossed_texts import stage_of
from tests.plan.seen_senses import arrows
from vad.files.examples import example_names
from vad.plan.items import Item
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.pictures.senses_in_views import AXES
from vad.plan.stage import Stage
from vad.strokes.reveals import measurer
from vad.strokes.sheet import Cell

SIZES = [(1280, 720), (960, 720)]
#: The first one is in every run.
EVERY = sorted({*vad.MECHANISMS, *example_names()}, key=lambda name: (name != "watt-2", name))
SIGNS = {"↺": 1.0, "↻": -1.0}
UNITS = {"velocity": "rad/s", "acceleration": "rad/s²"}


def rates(stage: Stage) -> Iterator[tuple[Cell, str, int]]:
    """Yield what turns, as its cell, the panel that tells it, and the beat in which that finds it.

    What is given is told from the beginning.
    In space those are bodies with fixed axes: others have no sense in a view.
    """
    sheet, sketches = stage.sheet, stage.scene(0).sketches
    plane = sheet.panels[0].picture == "skeleton"
    for row in sheet.rows:
        if plane or row.key in {*AXES, sheet.driver.row}:
            for panel in UNITS.keys() & sketches.keys():
                cells = [c for c in row.cells.get(panel, ()) if c.unit == UNITS[panel] and c.value]
                for cell in cells:
                    half, since = sketches[panel].setting.panel, 0
                    if not cell.given:
                        found = measurer(sheet, half, row)
                        if found is None:
                            continue
                        half, stroke = found
                        since = sketches[half.name].setting.after(half.number(stroke.name))
                    yield cell, half.column, since


def during(items: Iterable[Item], beat: int) -> list[Item]:
    """Return the items that show in a beat."""
    return [item for item in items if item.since <= beat < item.until]


def on_links(items: list[Item]) -> dict[str, float]:
    """Return the signs of the rates whose arrows are among some items; 0 where it has no arc."""
    found = dict.fromkeys((name for item in items for name in texts(item)), 0.0)
    for arrow in arrows(iter(items)):
        for name in (each for text in arrow.names for each in text.split(", ")):
            found[name] = math.copysign(1.0, arrow.bow.sweep)
    return found


def texts(item: Item) -> Iterator[str]:
    for mark in item.marks:
        if isinstance(mark.shape, Lettering) and mark.role in ("term", "tag"):
            yield from plain(mark.shape.runs).removeprefix(", ").split(", ")


def in_rows(items: list[Item]) -> dict[str, float]:
    """Return the signs behind the numbers of rows."""
    found = {}
    for text in (mark.shape for item in items for mark in item.marks):
        said = plain(text.runs) if isinstance(text, Lettering) else ""
        symbol, _, value = said.partition(" = ")
        found |= {symbol: SIGNS[value[-1]]} if value[-1:] in SIGNS else {}
    return found


@pytest.mark.exhaustive
@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", EVERY)
def test_the_sense_of_each_rate_is_seen_when_it_is_found(name: str, size: tuple[int, int]):
    stage = stage_of(name, size)
    first = stage.sheet.panels[0].name
    large = [stage.sheet.panel(stage.layout(number).large).name for number in range(stage.count)]
    for cell, panel, since in rates(stage):
        scene, items = large.index(panel), stage.scene(large.index(panel)).items
        beats = [since] if since else sorted({item.since for item in items})
        seen = None
        for beat in beats:
            # An arrow is there when it has come to its link; a row may make room for others then.
            links = on_links([i for i in during(items, beat + 1) if i.region == f"{scene}:{first}"])
            rows = in_rows([i for i in during(items, beat) if i.region == f"{scene}:work"])
            seen = seen or links.get(cell.symbol, rows.get(cell.symbol))
        assert seen is not None, (cell, scene)
        if stage.sheet.panels[0].picture == "skeleton":  # else a view may be from behind
            assert seen * cell.value > 0.0, (cell, scene)


@pytest.mark.parametrize("name", ["atkinson-engine", "offset-lever", "peaucellier"])
def test_the_given_sense_of_a_crank_between_other_links_is_seen_from_its_stroke_on(name: str):
    """It has no place on the short crank: it turns about its pivot, on nothing."""
    stage = stage_of(name, (1280, 720))
    scene, panel = stage.scene(0), stage.sheet.panel("position")
    begun = scene.sketches["position"].setting.after(panel.find(stage.sheet.driver.stroke))
    found = on_links(during((i for i in scene.items if i.region == "0:position"), begun))
    assert found["ω₂"] == math.copysign(1.0, stage.sheet.driver.omega)
