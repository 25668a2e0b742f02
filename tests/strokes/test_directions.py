"""Every word of direction in a caption, against the vector or the sign that it speaks of."""

from __future__ import annotations

import cmath
import math
import re
from re import Match, Pattern

import pytest

import vad
from tests.strokes.motions import (
    ORDERS,
    between,
    drawn,
    everything,
    in_every_language,
    poses,
    rate,
    slide_of,
    sliding,
    strokes,
    vector,
)
from tests.strokes.wording import WORDING
from vad.files.examples import example_names, example_path
from vad.kinematics.linkage import Bar, Slide, Step
from vad.kinematics.motion import Motion
from vad.strokes.sheet import Arc, Arrow, Line, Stroke
from vad.words import Language, languages


def test_every_language_is_understood() -> None:
    assert set(WORDING) == set(languages())


def clause(pattern: Pattern[str], caption: str) -> Match[str]:
    """Return where a caption says something, which it must."""
    found = pattern.search(caption)
    assert found, (pattern.pattern, caption)
    return found


def heads(vector: complex, way: complex) -> bool:
    """Tell whether a vector goes more to one of the four sides than to any other."""
    most = max(abs(vector.real), abs(vector.imag))
    return (way.conjugate() * vector).real >= most * (1 - 1e-9)


def on_the_frame(motion: Motion, step: Step) -> bool:
    """Tell whether a step slides on a guide."""
    along = isinstance(step, Slide) and isinstance(step.along, float)
    return along and step.ends[0] in motion.frame.fixed


def same_way(one: complex, other: complex) -> bool:
    return abs(one / abs(one) - other / abs(other)) < 1e-6


def same_line(one: complex, other: complex) -> bool:
    return same_way(one, other) or same_way(one, -other)


def in_cylinder(motion: Motion, stroke: Stroke) -> bool:
    """Tell whether a stroke is the given rate of a cylinder."""
    return stroke.kind == "known" and stroke.link in motion.mechanism.links


@pytest.mark.exhaustive(8)
@in_every_language
@everything
def test_no_word_is_said_without_being_meant(name: str, code: str) -> None:
    """Where directions and senses stand; what they say is tested below."""
    for motion, panel, stroke in strokes(name, code):
        turning = stroke.kind == "result" and stroke.component == "tangential"
        along = isinstance(stroke.shape, Arrow) and slide_of(motion, stroke) is not None
        along = along and stroke.component in ("sliding", "absolute") and not stroke.image
        along = along and panel.name != "position" and stroke.kind in ("known", "result")
        along = along and not in_cylinder(motion, stroke)  # it names the two ends
        ways = along or (turning and panel.name == "velocity")
        senses = turning or stroke.kind == "angle"
        assert WORDING[code].count(stroke.caption) == (ways, senses), stroke


@pytest.mark.exhaustive(4)
@in_every_language
@everything
def test_a_block_slides_the_way_that_is_said(name: str, code: str) -> None:
    for motion, panel, stroke in strokes(name, code):
        slide = slide_of(motion, stroke)
        if slide is None or panel.name == "position" or stroke.component == "coriolis":
            continue
        if isinstance(stroke.shape, Arrow):
            truth = sliding(motion, slide, ORDERS[panel.name])
            if in_cylinder(motion, stroke):
                found = WORDING[code].towards.search(stroke.caption)
                assert found and same_way(truth, between(motion, found["tail"] + found["head"]))
                continue
            assert heads(truth, WORDING[code].way(stroke.caption)), stroke
            assert same_way(vector(stroke), truth)


@in_every_language
@everything
def test_a_link_turns_in_the_sense_that_is_said(name: str, code: str) -> None:
    for motion, panel, stroke in strokes(name, code):
        if stroke.kind != "result" or stroke.component != "tangential":
            continue
        link = motion.link(str(stroke.link))
        sense = WORDING[code].sense(stroke.caption)
        assert sense == math.copysign(1, link.omega if panel.name == "velocity" else link.alpha)
        bar = between(motion, bar_of(stroke.caption))
        assert same_way(vector(stroke), sense * 1j * bar)


def bar_of(caption: str) -> str:
    """Return the bar by which a caption divides: ω₃ = bc/BC."""
    return clause(re.compile(r"/([A-Z]{2}) ="), caption)[1]


@in_every_language
@everything
def test_a_point_moves_the_way_that_is_said(name: str, code: str) -> None:
    wording = WORDING[code]
    for motion, panel, stroke in strokes(name, code):
        if panel.name != "velocity" or stroke.component != "tangential" or stroke.kind != "result":
            continue
        sideways = wording.sideways.search(stroke.caption)
        if sideways:
            assert sideways["bar"][1] == sideways["head"]
            bar = between(motion, sideways["bar"])
            across = 1j * bar / abs(bar)
            velocity = between(motion, sideways["bar"], 1)
            velocity = across * (across.conjugate() * velocity).real
        elif bar_of(stroke.caption)[0] in motion.frame.fixed:
            own = clause(wording.own, stroke.caption)
            assert bar_of(stroke.caption)[1] == own["head"]
            velocity = rate(motion, own["head"], 1)
        else:
            seen = clause(wording.seen, stroke.caption)
            assert bar_of(stroke.caption) == seen["tail"] + seen["head"]
            velocity = between(motion, seen["tail"] + seen["head"], 1)
        assert heads(velocity, wording.way(stroke.caption)), stroke
        assert same_way(velocity, vector(stroke))


@in_every_language
@everything
def test_a_normal_part_runs_between_the_points_that_are_said(name: str, code: str) -> None:
    for motion, _, stroke in strokes(name, code):
        if stroke.component == "normal":
            said = clause(WORDING[code].towards, stroke.caption)
            assert same_way(vector(stroke), between(motion, said["tail"] + said["head"]))


@in_every_language
@everything
def test_what_is_square_to_a_bar_is_so(name: str, code: str) -> None:
    square = WORDING[code].square
    for motion, panel, stroke in strokes(name, code):
        if isinstance(stroke.shape, Line) and stroke.shape.square_to:
            bar = clause(square, stroke.caption)["bar"]
            assert (stroke.label, stroke.shape.square_to) == (f"⟂ {bar}", bar)
            assert same_line(stroke.shape.direction, 1j * between(motion, bar))
        elif stroke.kind == "known" and stroke.component == "tangential":
            bar = between(motion, clause(square, stroke.caption)["bar"])
            link = motion.link(str(stroke.link))
            letter = clause(WORDING[code].with_it, stroke.caption)["rate"]
            assert letter == ("ω" if panel.name == "velocity" else "α")
            turning = link.omega if letter == "ω" else link.alpha
            assert same_way(vector(stroke), 1j * bar * turning)
        else:
            assert "⟂" not in stroke.label + stroke.caption


@in_every_language
@everything
def test_what_is_parallel_to_a_line_is_so(name: str, code: str) -> None:
    wording = WORDING[code]
    for motion, _, stroke in strokes(name, code):
        mark, _, line = stroke.label.partition(" ")
        if mark != "∥":
            continue
        slide = slide_of(motion, stroke)
        assert slide is not None and isinstance(stroke.shape, Line), stroke
        assert stroke.kind == "construction" and line in stroke.caption
        assert same_line(stroke.shape.direction, sliding(motion, slide, 1))
        if isinstance(slide.along, str):
            assert line == Language(code).name(slide.along)
        elif slide.ends[0] in motion.frame.fixed:
            guides = {step.ends for step in motion.frame.steps if on_the_frame(motion, step)}
            letter = motion.mechanism.slides[slide.name] if len(guides) > 1 else None
            assert clause(wording.guide, line)["head"] == letter
        else:
            assert line == wording.slot


@in_every_language
@everything
def test_who_can_move_no_other_way_moves_that_way(name: str, code: str) -> None:
    wording = WORDING[code]
    for motion, panel, stroke in strokes(name, code):
        if panel.name == "position" or not isinstance(stroke.shape, Line):
            continue
        slide, bound = slide_of(motion, stroke), wording.bound.search(stroke.caption)
        if slide is not None and (panel.name == "velocity" or not isinstance(slide.along, str)):
            carried = wording.carried.search(stroke.caption)
            point = motion.mechanism.slides[slide.name]
            velocity = rate(motion, point, 1)
            if carried:
                link = slide.along if isinstance(slide.along, str) else None
                assert carried["carrier"] == (Language(code).name(link) if link else wording.slot)
                velocity -= rate(motion, slide.ends.replace(point, ""), 1)
        elif bound:
            velocity = between(motion, bound["tail"] + bound["head"], 1)
        else:
            continue
        assert same_line(velocity, stroke.shape.direction), stroke


@in_every_language
@everything
def test_a_vector_belongs_to_the_points_that_are_said(name: str, code: str) -> None:
    for motion, panel, stroke in strokes(name, code):
        plain = re.fullmatch("([a-zA-Z])′?([a-zA-Z])′?", stroke.label)
        if not isinstance(stroke.shape, Arrow) or not plain:
            continue
        letters, order = (plain[1] + plain[2]).upper(), ORDERS[panel.name]
        if {*letters} <= {*motion.points, *motion.frame.fixed}:
            truth = between(motion, letters, order)
            assert abs(vector(stroke) - truth) <= 1e-9 * abs(truth)
            whole = WORDING[code].whose.search(stroke.caption)
            # What is no component of a link's vector is said to be somebody's.
            against = WORDING[code].other_side in stroke.caption
            bare = (slide_of(motion, stroke) is None or stroke.image) and not against
            said = (WORDING[code].seen, WORDING[code].own)
            moves = [found for each in said if (found := each.search(stroke.caption))]
            assert not (order and bare) or (whole is None) == bool(moves), stroke
            if not whole and moves and "tail" not in moves[0].groupdict():
                assert letters[0] in motion.frame.fixed and letters[1] == moves[0]["head"]
            if whole and whole["tail"]:
                assert letters == whole["tail"] + whole["head"]
            elif whole:
                truth = rate(motion, whole["head"], order)
                assert abs(vector(stroke) - truth) <= 1e-9 * abs(truth)


@in_every_language
@everything
def test_coriolis_is_the_sliding_velocity_turned_with_the_link(name: str, code: str) -> None:
    for motion, _, stroke in strokes(name, code):
        if stroke.component == "coriolis":
            clause(WORDING[code].turned, stroke.caption)
            slide = slide_of(motion, stroke)
            assert slide is not None and isinstance(slide.along, str)
            sense = math.copysign(1, motion.link(slide.along).omega)
            assert same_way(vector(stroke), sense * 1j * sliding(motion, slide, 1))


@everything
def test_the_four_senses_of_the_coriolis_inset(name: str) -> None:
    for motion in poses(name):
        panel = drawn(motion, "en").panel("acceleration")
        inset = panel.inset
        assert (inset is None) == all(s.component != "coriolis" for s in panel.strokes)
        if inset is None:
            continue
        stroke = panel.strokes[panel.number(inset.stroke)]
        slide, link = slide_of(motion, stroke), motion.link(inset.link)
        assert slide is not None and (slide.name, slide.along) == (inset.slide, inset.link)
        assert same_way(inset.slot, cmath.rect(1, math.radians(link.angle)))
        assert same_way(inset.sliding, sliding(motion, slide, 1))
        assert inset.sense == math.copysign(1, link.omega)
        assert same_way(inset.coriolis, inset.sense * 1j * inset.sliding)
        assert same_way(inset.coriolis, vector(stroke))


@in_every_language
@everything
def test_sides_of_a_link_and_of_a_slot(name: str, code: str) -> None:
    wording = WORDING[code]
    for motion, _, stroke in strokes(name, code):
        if stroke.image:
            bars = (step for step in motion.frame.steps if isinstance(step, Bar))
            base = next(bar.ends for bar in bars if bar.link == stroke.link)
            tip = between(motion, base[0] + stroke.label.replace("′", "")[1].upper())
            with_it = (between(motion, base).conjugate() * tip).real > 0
            assert (wording.other_side in stroke.caption) == (not with_it)
        slotted = wording.slotted.search(stroke.caption)
        if slotted:
            apart = between(motion, slotted["tail"] + slotted["head"])
            assert abs(apart.real) < 1e-9 * abs(apart)


@in_every_language
@everything
def test_the_given_angle_is_measured_from_the_x_axis(name: str, code: str) -> None:
    for motion, _, stroke in strokes(name, code):
        if stroke.kind == "angle":
            assert isinstance(stroke.shape, Arc)
            start, sweep = stroke.shape.start, stroke.shape.sweep
            assert start == 0 and 0 <= sweep * WORDING[code].sense(stroke.caption) < 360
            bar = between(motion, motion.mechanism.links[str(stroke.link)])
            assert same_way(cmath.rect(1, math.radians(start + sweep)), bar)


@everything
def test_a_link_has_one_number(name: str) -> None:
    for motion in poses(name):
        numbers: dict[str, set[str]] = {}
        for panel in drawn(motion, "en").panels:
            for stroke in panel.strokes:
                if stroke.component in ("normal", "tangential", "coriolis"):
                    slide = slide_of(motion, stroke)
                    link = str(slide.along if slide else stroke.link)
                    found = re.findall("[ωα]([₂-₉])", stroke.caption)
                    numbers.setdefault(link, set()).update(found)
        given = motion.linkage.driver.name
        assert all(len(found) == 1 for found in numbers.values())
        assert len(set.union(*numbers.values())) == len(numbers)
        assert numbers.get(given, {"₂"}) == {"₂"}


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("name", [*example_names()[::-1], *vad.MECHANISMS])
def test_a_construction_line_is_drawn_towards_what_it_finds(name: str) -> None:
    mechanism = (vad.MECHANISMS.get(name) or vad.load(example_path(name)))()
    sheet = vad.draw(vad.solve(mechanism))
    shapes = [stroke.shape for panel in sheet.panels for stroke in panel.strokes]
    lines = [shape for shape in shapes if isinstance(shape, Line) and shape.until is not None]
    assert lines
    for line in lines:
        way = (line.until - line.through) * line.direction.conjugate()
        assert way.real >= -1e-9 * abs(way)
