"""A found ω or α leaves its caption, flies to its link, and bends to the arrow of its sense."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest

import vad
from tests.plan.overlaps import KEY
from tests.plan.test_flights import moving
from vad.files.examples import example_path
from vad.lecture.moment import moments
from vad.plan.format import screen
from vad.plan.geometry import Rect
from vad.plan.items import ALWAYS, CAPTION, FLIGHT, Item
from vad.plan.labels.obstacles import Obstacles
from vad.plan.lettering.glyphs import width
from vad.plan.lettering.runs import plain, roman
from vad.plan.marks import Bending, Bow, Flying, Leg, Lettering, Mark, bent
from vad.plan.page.quarter import without_turn
from vad.plan.pictures.sent import Way, _way
from vad.plan.roles import HALO, ROLES
from vad.plan.stage import Stage
from vad.strokes.travels import found_rates, travels


def stage_of(name: str, size: tuple[int, int] = (1280, 720)) -> Stage:
    _, sheet = moving(name)
    return Stage(sheet, screen(size), KEY, travels(sheet))


def sent_of(stage: Stage, scene: int) -> list[Item]:
    """Return the flights of rates: those that begin while the board rests."""
    return [i for i in stage.scene(scene).items if i.region == FLIGHT and i.since % 2 == 0]


def only(marks: list[Mark], kind: type) -> Mark:
    [found] = [mark for mark in marks if isinstance(mark.growth, kind) and mark.role != "head"]
    return found


@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("scene", [1, 2])
@pytest.mark.parametrize("name", ["four-bar", "slider-crank", "whitworth with ram"])
def test_a_number_leaves_its_caption_and_its_arrow_stays(name: str, scene: int):
    stage = stage_of(name)
    plan = stage.scene(scene)
    found = sent_of(stage, scene)
    assert found
    assert {item.stroke for item in found} <= found_rates(stage.sheet)
    for item in found:
        said = stage._captions(plan.sketches)
        caption = next(i for i in said if i.stroke == item.stroke and i.words[0] == item.words[0])
        [line] = [m.shape for m in caption.marks if m.alpha == 1.0 and m.role == "words"]
        number = only(list(item.marks), Flying)
        assert 0.0 < ROLES[number.role].halo < HALO  # it covers little of its link
        shown = number.at(0.0)
        assert shown and isinstance(shown.shape, Lettering) and isinstance(line, Lettering)
        before, _, _ = plain(line.runs).partition(plain(shown.shape.runs))
        assert before != plain(line.runs)
        assert shown.shape.size == line.size and shown.shape.at.imag == line.at.imag
        assert line.at.real < shown.shape.at.real < line.at.real + width(line.runs, line.size)
        assert number.at(1.0) is None
        # What is there at the end of the flight is what stays.
        stays = next(i for i in plan.items if i.stroke == item.stroke and i.since == item.since + 1)
        ends = [mark.at(1.0) for mark in item.marks]
        names = [m.shape for m in ends if m and isinstance(m.shape, Lettering)]
        assert names == [m.shape for m in stays.marks if isinstance(m.shape, Lettering)]
        for mark in (each for each in item.marks if isinstance(each.growth, Bending)):
            end = mark.at(1.0)
            assert end and isinstance(end.shape, Bow) and isinstance(mark.shape, Bow)
            assert end.shape.centre == pytest.approx(mark.shape.centre)
            assert end.shape.sweep == pytest.approx(mark.shape.sweep)
            assert mark.shape in [each.shape for each in stays.marks]


def test_a_number_without_room_at_its_link_flies_to_its_row():
    sheet = vad.draw(vad.solve(vad.load(example_path("watt-1"))()))
    stage = Stage(sheet, screen((1024, 768)), KEY, travels(sheet))
    plan = stage.scene(2)
    crowded = [i for i in sent_of(stage, 2) if len(i.marks) == 1 and i.marks[0].role == "letter"]
    assert {item.stroke for item in crowded} & found_rates(sheet)
    for item in crowded:
        [mark] = item.marks
        rows = [i.marks[0].shape for i in plan.items if i.stroke == item.stroke and i.grows]
        row = next(each for each in rows if isinstance(each, Lettering) and each != mark.shape)
        near = mark.at(23 / 24)
        assert near and isinstance(near.shape, Lettering)
        assert near.shape.size == pytest.approx(row.size)
        both = (near.shape, replace(row, runs=without_turn(row.runs)))
        ends = [each.at.real + width(each.runs, each.size) for each in both]
        assert ends[0] == pytest.approx(ends[1])
        assert near.shape.at.imag == pytest.approx(row.at.imag)
        assert mark.at(1.0) is None


@pytest.mark.exhaustive(12)
@pytest.mark.parametrize("name", ["watt-1", "beam-engine", "shaper", "jansen-leg", "stephenson-3"])
def test_no_number_flies_again_when_its_row_comes_back(name: str):
    sheet = vad.draw(vad.solve(vad.load(example_path(name))()))
    stage, begun = Stage(sheet, screen((1280, 720)), KEY, travels(sheet)), []
    for scene in range(stage.count):
        plan, large = stage.scene(scene), stage.layout(scene).large
        first = plan.sketches[large].setting.during(0)
        flights = (item for item in plan.items if item.region == FLIGHT)
        late = {item.stroke for item in flights if item.since >= first}
        assert not {stroke for stroke in late if stroke.startswith(tuple(begun))}
        begun.append(large)


def test_a_row_of_the_work_says_the_senses_that_the_whole_table_says():
    motion = vad.solve(vad.load(example_path("peaucellier"))(), angle=30.0, alpha=20.0)
    stage = Stage(vad.draw(motion), screen((1280, 720)), KEY)
    signs = {"↺": 1.0, "↻": -1.0, "": 0.0}
    told: dict[str, float] = {}
    for item in stage.scene(2).items:
        for text in (mark.shape for mark in item.marks if item.region.endswith("work")):
            said = plain(text.runs) if isinstance(text, Lettering) else ""
            symbol, equals, value = said.partition(" = ")
            if equals and not value.endswith("°"):
                told[symbol] = signs[value.partition("\N{NO-BREAK SPACE}")[2]]
    turns = stage.scene(2).turns
    assert {*stage.whole.turns.items()} <= {*turns.items()}
    assert told.keys() & turns.keys()
    assert told == {symbol: turns.get(symbol, 0.0) for symbol in told}


def test_an_arrow_keeps_its_length_and_its_head():
    item = next(i for i in sent_of(stage_of("four-bar"), 1) if len(i.marks) == 4)
    arc = only(list(item.marks), Bending)
    head = next(mark for mark in item.marks if mark.role == "head")
    assert isinstance(arc.shape, Bow)
    off = []
    for share in (1.0, 0.35, 0.5, 0.6, 0.75, 0.875):
        bow, tip = arc.at(share), head.at(share)
        assert bow and tip and isinstance(bow.shape, Bow)
        assert bow.shape.length == pytest.approx(arc.shape.length)
        turn = math.radians(bow.shape.start + bow.shape.sweep)
        end = bow.shape.centre + cmath.rect(bow.shape.radius, turn)
        off.append((tip.shape.rings[0][0] - end) / cmath.exp(1j * turn))
    assert all(abs(each - off[0]) < 1e-3 for each in off)
    straight = arc.at(0.35)
    assert straight and isinstance(straight.shape, Bow) and abs(straight.shape.sweep) < 5.0
    middle = straight.shape.start + straight.shape.sweep / 2
    assert math.cos(math.radians(middle)) == pytest.approx(0.0, abs=1e-9)  # it lies level


def test_a_bent_arc_is_itself_at_the_end():
    bow = Bow(1 + 2j, 0.5, 30.0, -50.0)
    same = bent(bow, Leg(1.0, 0j))
    assert same.centre == pytest.approx(bow.centre)
    assert (same.radius, same.start, same.sweep) == pytest.approx((0.5, 30.0, -50.0))


@pytest.mark.parametrize("speed", [0.5, 1.0, 3.0])
def test_a_rate_flies_when_its_number_is_said_and_its_row_waits(speed: float):
    sheet = moving("four-bar")[1]
    lesson = vad.animate(sheet, speed=speed)
    rates, senders = found_rates(sheet), []
    for step in lesson.steps:
        begins, lasts = step.sent
        assert bool(lasts) == (step.panel.full(step.stroke.name) in rates)
        if lasts:
            senders.append(step)
            assert begins >= max(step.grow, step.beats[-1])
            assert begins + lasts <= step.grow + step.hold
            assert 0.8 <= lasts / lesson.fps * speed <= 1.7
    assert len(senders) == 4
    shares = [
        m.share for m, _ in moments(lesson) if m.beat % 2 == 0 and m.scene == senders[0].scene
    ]
    assert shares.count(0.0) >= 2
    assert any(0.0 < share < 1.0 for share in shares)
    assert not any(step.sent[1] for step in vad.animate(sheet, plain=True).steps)
    stage = Stage(sheet, screen((1280, 720)), KEY, travels(sheet))
    new = [i for i in stage.scene(1).items if i.grows and i.region.endswith("work")]
    own = {i.stroke for i in sent_of(stage, 1) if i.stroke.startswith("velocity")}
    assert own and {i.stroke for i in new} >= own
    assert all(item.at(0.5) == [] and len(item.at(1.0)) == 1 for item in new)
    assert not any(i.region == CAPTION for i in new)


def test_a_number_flies_past_letters_where_it_crosses_no_words():
    """Its arrow flies below it; beside words it would rather cross a letter."""
    number, page = Lettering(roman("4.607"), 0.3 + 0.1j, 0.04), Rect(0.0, 0.1, 1.78, 1.0)
    ends, nothing = (0.35 + 0.1j, 1.3 + 0.7j), Obstacles(page)
    usual = _way(number, ends, 0.6, nothing, nothing)

    def crosses(way: Way, box: Rect) -> bool:
        return any(box.inside(-0.012).holds(way.at(part / 100)) for part in range(101))

    middle = usual.at(0.6)
    box = Rect(middle.real - 0.03, middle.imag - 0.02, middle.real + 0.03, middle.imag + 0.02)
    assert crosses(usual, box)
    letter = Obstacles(page, [], [(box, ALWAYS)])
    past = _way(number, ends, 0.6, nothing, letter)
    assert not crosses(past, box)
    assert _way(number, ends, 0.6, letter, nothing) == past
    both = Obstacles(page, [], [(past_box(past), ALWAYS)])
    assert not crosses(_way(number, ends, 0.6, both, letter), past_box(past))


def past_box(way: Way) -> Rect:
    """Return a box in the middle of a way."""
    middle = way.at(0.6)
    return Rect(middle.real - 0.02, middle.imag - 0.02, middle.real + 0.02, middle.imag + 0.02)
