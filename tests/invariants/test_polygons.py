"""What is true of every sheet in the plane: polygons close, lines cross, images are similar."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given

import vad
from tests.invariants.test_motion import drawn, in_the_plane, motions
from tests.strokes.crossings import crossings_lie_on_lines, size
from vad.errors import DeadCentreError
from vad.kinematics.linkage import Bar, Slide
from vad.strokes.sheet import Arrow, Dot, Panel, Sheet, Stroke

ORDERS = {"velocity": 1, "acceleration": 2}


def sheets(name: str) -> Any:
    """Draw the sheets of a mechanism's poses that have rates."""

    def sheet_of(drawn_motion: tuple[Any, dict[str, float]]) -> tuple[vad.Motion, Sheet] | None:
        mechanism, inputs = drawn_motion
        motion = vad.solve(mechanism, **inputs)
        try:
            return motion, vad.draw(motion)
        except DeadCentreError:
            return None

    return motions(name).map(sheet_of).filter(lambda found: found is not None)


def rates(sheet: Sheet) -> Iterator[Panel]:
    return (panel for panel in sheet.panels if panel.name in ORDERS)


def arrows(panel: Panel) -> Iterator[tuple[Stroke, Arrow]]:
    return ((s, s.shape) for s in panel.strokes if isinstance(s.shape, Arrow))


def every_vertex_has_one_place(motion: vad.Motion, sheet: Sheet) -> None:
    for panel in rates(sheet):
        places: dict[str, complex] = {}
        for stroke in panel.strokes:
            if isinstance(stroke.shape, Dot):
                ends = [(letter, stroke.shape.at) for letter in stroke.label.split(",")]
            elif isinstance(stroke.shape, Arrow):
                arrow = stroke.shape
                ends = [(arrow.tail, arrow.start), (arrow.head, arrow.end)]
                assert stroke.label == arrow.tail + arrow.head
            else:
                continue
            for letter, at in ends:
                assert abs(places.setdefault(letter, at) - at) <= 1e-12 * size(panel)


def the_equation_under_a_panel_holds(motion: vad.Motion, sheet: Sheet) -> None:
    for panel in rates(sheet):
        for equation in panel.equations:
            total = 0j
            for sign, terms in ((1, equation.left), (-1, equation.right)):
                for term in terms:
                    if term.stroke is not None:
                        stroke = panel.strokes[panel.number(term.stroke)]
                        shape = stroke.shape
                        assert isinstance(shape, Arrow)
                        assert stroke.label == term.label
                        total += sign * (shape.end - shape.start)
            assert abs(total) <= 1e-11 * size(panel)


def crossings_lie_on_their_lines(motion: vad.Motion, sheet: Sheet) -> None:
    for panel in rates(sheet):
        crossings_lie_on_lines(panel)


def images_of_links_are_similar(motion: vad.Motion, sheet: Sheet) -> None:
    """Every link's image is the link, turned and stretched by iω, or by iα - ω²."""
    for panel in rates(sheet):
        at = {
            letter: point
            for _, arrow in arrows(panel)
            for letter, point in ((arrow.tail, arrow.start), (arrow.head, arrow.end))
        }
        for step in motion.frame.steps:
            image = [letter.lower() + "′" * (ORDERS[panel.name] - 1) for letter in step.ends]
            if not isinstance(step, Bar) or not set(image) <= set(at):
                continue
            if not set(step.ends) <= set(motion.points):
                continue  # a strut is no rigid link
            link = motion.link(step.link)
            factor = 1j * link.omega
            if panel.name == "acceleration":
                factor = 1j * link.alpha - link.omega**2
            tail, head = (motion.point(letter).position for letter in step.ends)
            expected = factor * (head - tail)
            assert abs(at[image[1]] - at[image[0]] - expected) <= 1e-9 * size(panel)


def components_have_the_textbook_size_and_direction(motion: vad.Motion, sheet: Sheet) -> None:
    for panel in rates(sheet):
        for stroke, arrow in arrows(panel):
            vector, link = arrow.end - arrow.start, str(stroke.link)
            if stroke.component == "coriolis":
                _check_coriolis(motion, link, vector)
            elif stroke.component in ("normal", "tangential"):
                bar = _bar_of(motion, stroke)
                omega, alpha = motion.link(link).omega, motion.link(link).alpha
                rate = omega if panel.name == "velocity" else alpha
                factor = -(omega**2) if stroke.component == "normal" else 1j * rate
                assert abs(vector - factor * bar) <= 1e-9 * max(size(panel), abs(vector))


def _bar_of(motion: vad.Motion, stroke: Stroke) -> complex:
    """Return the bar whose end the head of a normal or tangential arrow bears."""
    assert isinstance(stroke.shape, Arrow)
    letters = (stroke.shape.head[0] + stroke.shape.tail[0]).upper()
    for step in motion.frame.steps:
        if isinstance(step, Bar) and step.link == stroke.link and step.ends[1] in letters + "BSZ":
            ends = step.ends
            if ends[0] not in motion.points:
                ends = motion.mechanism.links[step.link]
            tail, head = (motion.point(letter).position for letter in ends)
            return complex(head - tail)
    raise AssertionError(stroke)


def _check_coriolis(motion: vad.Motion, name: str, vector: complex) -> None:
    slide = next(s for s in motion.frame.steps if isinstance(s, Slide) and s.name == name)
    link = motion.link(str(slide.along))
    along = cmath.rect(motion.slide(name).velocity, cmath.pi * link.angle / 180)
    assert abs(vector - 2j * link.omega * along) <= 1e-12 * abs(vector)
    assert motion.slide(name).coriolis == pytest.approx(abs(vector), rel=1e-12)


def every_result_is_measured_once(motion: vad.Motion, sheet: Sheet) -> None:
    wanted = sorted(
        row.key for row in sheet.rows if not all(cell.given for cell in row.cells["position"])
    )
    names = {row.key for row in sheet.rows}
    for panel in sheet.panels:
        revealed = [key for stroke in panel.strokes for key in stroke.reveals]
        assert sorted(set(revealed)) == sorted(set(wanted))
        assert len(revealed) == len(set(revealed))
        assert all(stroke.link in names or stroke.link is None for stroke in panel.strokes)
        assert all(stroke.caption for stroke in panel.strokes)


def nothing_of_length_zero_is_drawn(motion: vad.Motion, sheet: Sheet) -> None:
    for panel in rates(sheet):
        for _, arrow in arrows(panel):
            assert abs(arrow.end - arrow.start) > 1e-13 * size(panel)


CHECKS = [
    every_vertex_has_one_place,
    the_equation_under_a_panel_holds,
    crossings_lie_on_their_lines,
    images_of_links_are_similar,
    components_have_the_textbook_size_and_direction,
    every_result_is_measured_once,
    nothing_of_length_zero_is_drawn,
]


@pytest.mark.exhaustive(4)
@in_the_plane
def test_polygons_are_as_they_should(name: str) -> None:
    """A sheet is drawn once, and asked everything."""

    @drawn
    @given(sheets(name))
    def check(found: tuple[vad.Motion, Sheet]) -> None:
        for each in CHECKS:
            each(*found)

    check()
