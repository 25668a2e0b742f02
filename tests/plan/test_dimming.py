"""While a vector flies in a film, the links that it does not come from are pale."""

from __future__ import annotations

import re
from importlib.resources import files

import pytest

import vad
from tests.plan.overlaps import KEY
from vad.lecture.moment import Moment
from vad.plan.format import screen
from vad.plan.items import FLIGHT, Item
from vad.plan.marks import Mark
from vad.plan.pictures.dimming import PALE
from vad.plan.stage import Stage
from vad.strokes.travels import travels

#: The machines, a stroke that flies, the scene in which it lands, and the panel that it leaves.
FLIGHTS = [
    (vad.SliderCrank, "velocity:AB.tangential", 1, "position"),
    (vad.CrankSlottedLever, "acceleration:QB.coriolis", 2, "velocity"),
    (vad.SpatialFourBar, "velocity:12", 1, "position"),
]


def staged(kind: type, flies: bool = True) -> Stage:
    sheet = vad.draw(vad.solve(kind()))
    return Stage(sheet, screen((1280, 720)), KEY, travels(sheet) if flies else None)


def shown(stage: Stage, beat: int, scene: int, panel: str) -> dict[tuple, list[Mark]]:
    """Return the marks of a panel at a beat by what they belong to."""
    found: dict[tuple, list[Mark]] = {}
    for item in stage.at(Moment(beat, 0.5, scene)):
        if item.region == f"{scene}:{panel}":
            found.setdefault((item.stroke, item.level, item.since), []).extend(item.marks)
    return found


def flight(stage: Stage, stroke: str, scene: int) -> Item:
    (item,) = (i for i in stage.scene(scene).items if i.region == FLIGHT and i.stroke == stroke)
    return item


@pytest.mark.parametrize(("kind", "stroke", "scene", "source"), FLIGHTS)
def test_what_is_not_concerned_is_pale_while_a_vector_flies(kind, stroke, scene, source):
    stage = staged(kind)
    item = flight(stage, stroke, scene)
    own = item.marks[-1].row
    for panel in ("position", "velocity", "acceleration"):
        during, after = (shown(stage, item.since + late, scene, panel) for late in (0, 1))
        inks = {
            (mark.row == own, mark.row is None): round(now.alpha / mark.alpha, 9)
            for key, marks in after.items()
            if key in during
            for mark, now in zip(marks, during[key], strict=True)
        }
        others = PALE if panel == source else 1.0
        assert inks.pop((False, False), others) == others, panel
        assert set(inks.values()) <= {1.0}, panel
        assert panel != source or set(inks) == {(True, False), (False, True)}


def test_nothing_is_pale_where_nothing_flies():
    stage = staged(vad.SliderCrank, flies=False)
    since = flight(staged(vad.SliderCrank), "velocity:AB.tangential", 1).since
    marks = [mark for each in shown(stage, since, 1, "position").values() for mark in each]
    assert {mark.alpha for mark in marks} == {1.0}


def test_items_are_the_same_ones_in_all_frames_of_a_flight():
    stage = staged(vad.SliderCrank)
    item = flight(stage, "velocity:AB.tangential", 1)
    one, other = (stage.at(Moment(item.since, share, 1)) for share in (0.2, 0.7))
    assert all(a is b for a, b in zip(one, other, strict=True))


def test_pages_have_the_same_ink():
    style = files("vad.page").joinpath("player.css").read_text(encoding="utf-8")
    (ink,) = re.findall(r"\.pale \{ opacity: (\S+); \}", style)
    assert float(ink) == PALE
