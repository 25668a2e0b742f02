"""Labels: they touch no stroke, no other label and no edge, by two independent counts."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from functools import lru_cache
from itertools import combinations

import numpy as np
import pytest

import vad
from tests.plan.overlaps import overlaps, planned
from tests.plan.sheets import slider_crank
from vad.errors import VadError
from vad.files.examples import example_names, example_path
from vad.mechanisms.mechanism import Mechanism
from vad.painting.agg_painter import AggPainter
from vad.painting.painter import Looks
from vad.plan.items import Level, together
from vad.plan.lettering.runs import plain
from vad.plan.marks import Lettering
from vad.plan.reach import corners
from vad.strokes.sheet import Arrow, Dot, Sheet
from vad.style import load_style, style_names

pytestmark = pytest.mark.exhaustive


@pytest.mark.parametrize("degrees", range(0, 360, 45))
def test_a_full_turn_of_a_slider_crank(degrees: int):
    sheet = slider_crank(degrees + 0.01)
    assert overlaps(sheet) == []
    assert overlaps(sheet, lesson=True) == []
    assert overlaps(sheet, (1024, 768)) == []


RAMS = {
    "crank-slotted-lever": {"rod": 100, "ram_height": 180},
    "whitworth": {"rod": 300},
}


@lru_cache(maxsize=64)
def still(name: str, step: int) -> list[Sheet]:
    """Return the sheet of one of twelve steps of a turn; none beyond the reach of a slide."""
    mechanism = (vad.MECHANISMS.get(name) or vad.load(example_path(name)))(**RAMS.get(name, {}))
    return turn(mechanism, 12, [step])


def turn(mechanism: Mechanism, steps: int, some: Iterable[int] = ()) -> list[Sheet]:
    """Return the sheets of ``some`` steps of a turn in so many; every other step has an α."""
    sheets = []
    for step in some or range(steps):
        inputs = dict(mechanism.inputs)
        if "angle" in inputs:
            inputs.update(angle=360 / steps * step + 5, alpha=20 * (step % 2))
        else:
            inputs["position"] *= 0.9 + step / (5 * steps)
        try:
            sheets.append(vad.draw(vad.solve(mechanism, **inputs)))
        except VadError:
            continue  # beyond the reach of a driven slide
    return sheets


def test_the_name_of_a_vector_meets_only_what_shows_after_its_stroke():
    """Before, the letters of a pole stand there, which go into a lens two beats earlier."""
    (sheet,) = still("excavator-bucket", 8)
    sketch = planned(sheet, (1024, 768)).sketches["acceleration"]
    spans = [tag.span for tag in sketch.tags if tag.text == "2ωv"]
    (item,) = (
        item
        for item in sketch.items
        if item.stroke == "acceleration:OS.coriolis" and item.level == Level.LABEL
        if any(mark.role == "tag" for mark in item.marks)
    )
    assert (item.since, item.until) in spans
    assert overlaps(sheet, (1024, 768)) == []


@pytest.mark.parametrize("name", sorted(vad.MECHANISMS))
def test_a_full_turn_of_every_mechanism(name: str):
    sheets = turn(vad.MECHANISMS[name](), steps=6)
    assert len(sheets) > 3
    for sheet in sheets:
        assert overlaps(sheet) == []


@pytest.mark.parametrize("step", range(4))
@pytest.mark.parametrize("name", sorted(vad.MECHANISMS))
def test_the_other_assembly_and_shape_of_page(name: str, step: int):
    mechanism = vad.MECHANISMS[name](assembly="crossed", **RAMS.get(name, {}))
    for sheet in turn(mechanism, 4, [step]):
        assert overlaps(sheet, (1280, 720) if step % 2 else (1024, 768)) == []


def test_the_letter_of_a_given_velocity_keeps_off_those_of_the_points():
    sheet = vad.draw(vad.solve(vad.DoubleSlider(), position=600))
    assert overlaps(sheet, (960, 720), lesson=True) == []


def test_a_point_never_stands_in_two_labels():
    sheet = vad.draw(vad.solve(vad.FourBar(crank=1), angle=130, omega=100))
    for sketch in planned(sheet).sketches.values():
        named = [(letter, tag.span) for tag in sketch.tags for letter in tag.text.split(", ")]
        for (one, first), (other, second) in combinations(named, 2):
            assert one != other or not together(first, second)  # a lens takes a letter over


@pytest.mark.exhaustive(128)
@pytest.mark.parametrize("lesson", [False, True])
@pytest.mark.parametrize(
    ("name", "place"),
    [
        ("shaper", 180),  # names of lines where letters come later
        ("shaper", 350.85),
        ("landing-gear", 378),  # the given velocity beside B
        ("pin-on-rocker", 245.85),  # v beside ω in the inset
    ],
)
def test_narrow_places_of_the_examples(name: str, place: float, lesson: bool):
    mechanism = vad.load(example_path(name))()
    driven = next(iter(mechanism.inputs))
    sheet = vad.draw(vad.solve(mechanism, **{driven: place}))
    assert overlaps(sheet, lesson=lesson) == []


def test_many_letters_of_one_point_stand_in_lines():
    sheet = slider_crank()
    panel = sheet.panel("acceleration")
    pole = replace(panel.strokes[0], label="a′, d′, g′, k′, l′")
    many = replace(panel, strokes=(pole, *panel.strokes[1:]))
    panels = tuple(many if each is panel else each for each in sheet.panels)
    board = planned(replace(sheet, panels=panels))
    marks = [mark.shape for item in board.shown(board.finished) for mark in item.marks]
    texts = {plain(shape.runs): shape for shape in marks if isinstance(shape, Lettering)}
    first, second = texts["a′, d′, g′"], texts["k′, l′"]
    assert first.at.imag - second.at.imag > first.size


@pytest.mark.exhaustive(192)
@pytest.mark.parametrize("first", range(0, 72, 9))
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_letters_are_joined_where_points_are_equal(name: str, first: int, exhaustive: bool):
    """Where two points look alike but differ, two labels name them: a comma says they are equal.

    In a usual run one pose in nine is looked at.
    """
    mechanism = (vad.MECHANISMS.get(name) or vad.load(example_path(name)))(**RAMS.get(name, {}))
    every = 1 if exhaustive else 9
    for sheet in turn(mechanism, steps=72, some=range(first, first + 9, every)):
        for sketch in planned(sheet).sketches.values():
            panel = sketch.setting.panel
            longest = max((abs(z) for z in corners(panel)), default=0.0)
            places: dict[str, list[complex]] = {}
            for stroke in panel.strokes:
                match stroke.shape:
                    case Arrow(start, end, tail, head):
                        places.setdefault(tail, []).append(start)
                        places.setdefault(head, []).append(end)
                    case Dot(at):
                        for letter in stroke.label.split(","):
                            places.setdefault(letter.strip(), []).append(at)
            for tag in sketch.tags:
                if tag.text[0] in "ωα":
                    continue  # two rates in one sense
                first, *others = tag.text.split(", ")
                for other in others:
                    near = min(abs(a - b) for a in places[first] for b in places[other])
                    assert near <= 1e-9 * longest, (tag.text, near)


@pytest.mark.parametrize("style", style_names())
def test_finished_labels_cover_only_background(style: str):
    """Paint the panels without their letters: where these would stand, all is background."""
    look = load_style(style)
    looks = Looks(look)
    for degrees in (20.0, 75.0, 160.0, 250.0):
        board = planned(slider_crank(degrees))
        painter = AggPainter(board.form)
        painter.begin(board.form, look.background)
        for item in board.shown(board.finished):
            if item.region in board.sketches and item.level < Level.LABEL:
                for mark in item.marks:
                    painter.paint(mark, looks(mark))
        for sketch in board.sketches.values():
            for tag in sketch.tags:
                if tag.span[1] <= board.finished:
                    continue
                box = [720 * side for side in (tag.box.bottom, tag.box.top, tag.box.left)]
                rows = slice(720 - math.ceil(box[1]), 720 - math.floor(box[0]))
                columns = slice(math.floor(box[2]), math.ceil(720 * tag.box.right))
                area = painter.words[rows, columns]
                assert np.all(area == painter.word(look.background)), (degrees, tag.text)
