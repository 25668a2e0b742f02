"""What flies crosses few texts, and those that it crosses are pale meanwhile."""

from __future__ import annotations

import pytest

import vad
from tests.plan.crossed_texts import crossings, flights, stage_of
from vad.files.examples import example_names
from vad.lecture.moment import Moment
from vad.plan.board import seen
from vad.plan.items import CAPTION, FLIGHT, TITLE, Item, Level, head_of
from vad.plan.lettering.runs import roman
from vad.plan.making_way import FADES, MOMENT, made_way
from vad.plan.marks import Fading, Flying, Leg, Lettering, Mark, Polyline, line
from vad.plan.page.changing import SAID


@pytest.mark.parametrize(
    ("name", "most"),
    [
        # A crank whose copy turns about its pin, at the top of the page.
        ("elliptical-trammel", {"heading": 1}),
        ("whitworth", {}),
        ("gate-actuator", {}),
    ],
)
def test_few_words_beside_the_panels_are_crossed_and_those_are_pale(name: str, most: dict):
    stage = stage_of(name)
    met = [each for flight in flights(stage) for each in crossings(stage, *flight)]
    words = [each.kind for each in met if each.kind != "label"]
    assert {kind: words.count(kind) for kind in words} == most
    assert all(each.pale for each in met)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_no_number_passes_through_its_caption(name: str):
    stage = stage_of(name)
    met = [each for flight in flights(stage) for each in crossings(stage, *flight)]
    assert not [each for each in met if (each.flies, each.kind) == ("number", "caption")]


def beat_of(*others: Mark, since: int = 3) -> list[Item]:
    """Return what shows while a stroke of length 2 flies from 0 to 10 to the right."""
    flying = Flying(10 + 0j, (Leg(0.0, -10 + 0j), Leg(1.0, 0j)))
    stroke = Item(
        "s", FLIGHT, Level.STROKE, (line([10 - 1j, 10 + 1j], "vector", None, flying),), 3, 4
    )
    return [Item("", TITLE, Level.GROUND, others, since), stroke]


def text(x: float, y: float = 0.0, alpha: float = 1.0) -> Mark:
    return Mark(Lettering(roman("I"), complex(x, y), 0.1), "words", alpha=alpha)


def test_a_text_is_pale_while_it_is_crossed_and_dark_again_at_the_end():
    items = beat_of(text(4.0), text(4.0, 3.0), text(9.9))
    title, stroke = made_way(items, 3)
    assert stroke is items[1]
    assert (title.since, title.until) == (3, 4)
    crossed, beside, last = title.marks
    assert beside == items[0].marks[1]
    inks = {share: crossed.at(share).alpha for share in (0.0, 0.4, 0.41, 0.6, 1.0)}
    assert inks == pytest.approx({0.0: 1.0, 0.4: SAID, 0.41: SAID, 0.6: 1.0, 1.0: 1.0})
    assert 0.39 - MOMENT - FADES < crossed.growth.knots[0][0] < 0.4
    assert last.at(0.99).alpha < 1.0 == last.at(1.0).alpha


def test_a_text_from_which_something_leaves_stays_and_so_does_a_pale_one():
    items = beat_of(text(-0.01), text(4.0, alpha=SAID))
    assert made_way(items, 3) == items
    assert made_way(items, 4) == items  # there it does not fly


def test_what_has_grown_before_does_not_grow_again():
    grown = Mark(text(4.0).shape, "words", growth=Fading())
    title, _ = made_way(beat_of(grown, since=1), 3)
    assert title.marks[0].at(0.0).alpha == 1.0
    growing = beat_of(grown)
    assert made_way(growing, 3) == growing


def test_a_heading_makes_way_and_items_stay_the_same_in_a_beat():
    stage = stage_of("elliptical-trammel")
    scene, flight = next(f for f in flights(stage) if f[1].stroke == "velocity:AB.tangential")
    moments = [Moment(flight.since, share, scene) for share in (0.1, 0.5, 0.9)]
    shown = [seen(stage, moment) for moment in moments]
    assert all(a is b for a, b in zip(shown[0], shown[2], strict=True))
    heads = [item for item in shown[1] if item.region.endswith(head_of("position"))]
    inks = [[mark.alpha for item in heads for mark in item.at(each.share)] for each in moments]
    assert min(inks[1]) == pytest.approx(SAID) and min(inks[2]) == 1.0
    # It stays above the caption, which is read meanwhile.
    low = stage.regions[CAPTION].top
    for mark in (mark for mark in flight.marks if isinstance(mark.growth, Flying)):
        for share in (0.1, 0.3, 0.5, 0.7, 0.9):
            shape = mark.at(share).shape
            assert not isinstance(shape, Polyline) or min(z.imag for z in shape.pieces[0]) >= low
