"""What travels on a page: vectors that come from a link or from a velocity, as in films.

A page says little of each: what it is to its source, where both are in their panels, and by how
much it turns.  The browser knows how large the panels are, and where they stand.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from vad.lecture.lesson import Lesson
from vad.lecture.pace import LANDED, PHASES
from vad.page.ink import Inker
from vad.page.large import Large
from vad.plan.board import Plan
from vad.plan.geometry import Rect, direction_of
from vad.plan.labels.obstacles import Obstacles
from vad.plan.pictures.flights import Flight
from vad.plan.pictures.traces import RING, path, ring
from vad.plan.sketch import Sketch


def page_flights(
    lesson: Lesson, board: Plan, inker: Inker, large: Mapping[str, Large]
) -> dict[int, list[Any]]:
    """Return what flies, by the number of its stroke in the lesson.

    Each is a list: for how many seconds it flies, what it is to its source, the seconds of its
    phases, the number of the panel that it leaves; by how many degrees it is turned clockwise
    there; how far it lifts off a link beside which it stays, to the left, in pixels.  Then where
    its tail and its head are there, and in its own panel: to the right and down, in pixels of a
    page 1280 wide.  If the page draws panels ``large``, too, the same follows for the panels as
    they are then.
    """
    numbers = {s.panel.full(s.stroke.name): number for number, s in enumerate(lesson.steps)}
    columns = [panel.name for panel in lesson.sheet.panels]
    page = Rect(0.0, 0.0, board.form.width, board.form.height)
    found = {}
    for name, travel in (lesson.travels or {}).items():
        flight = Flight.of(name, travel, board.sketches, (page, [page], Obstacles(page)))
        if flight is None:
            continue
        number, panel = numbers[name], flight.polygon.setting.panel
        source = board.sketches[travel.source].setting.panel.column
        places: list[float] = []
        for shown in (board, large) if large else (board,):
            there, here = (_sketches(shown, each) for each in (source, panel.column))
            scales = there[travel.source].scale, here[panel.name].scale
            ends = (travel.tail, travel.head), (travel.start, travel.end)
            for scale, pair in zip(scales, ends, strict=True):
                places += [round(each, 2) for z in pair for each in inker.pixels(scale(z))]
        phases, kind = PHASES[travel.kind], travel.kind if flight.is_vector else "area"
        stays = kind in ("normal", "axial")
        up = (flight.lift / direction_of(*flight.source)).imag if stays else 0.0
        turns = (travel.turn, up * inker.frame[0])
        share = sum(phases) / (sum(phases) + LANDED)
        seconds = round(share * lesson.steps[number].grow / lesson.fps, 3)
        if kind == "coriolis" and not flight.docks:
            kind = "turned"  # which flies in the same way, to where its tail will be
        looks = [round(each, 2) + 0.0 for each in turns]
        found[number] = [seconds, kind, phases, columns.index(source), *looks, *places]
    return found


def trails(inker: Inker) -> list[Any]:
    """Return the classes of the dotted path of a flight, and of the ring in which a head docks.

    Then follows the radius of the ring in pixels.
    """
    marks = path([0j, 1.0 + 0j], 0.0, 1.0), ring(0j, 0.0, 1.0)
    looks = [inker.name(replace(mark, growth=None)) for mark in marks]
    return [*looks, round(RING * inker.frame[0], 2)]


def _sketches(shown: Plan | Mapping[str, Large], column: str) -> Mapping[str, Sketch]:
    """Return the sketches of a column on the board, or where it is large."""
    return shown.sketches if isinstance(shown, Plan) else shown[column].sketches
