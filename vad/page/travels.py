"""What travels on a page: vectors that come from a link or from a velocity, as in films.

A page says little of each: what it is to its source, where both are in their panels, and by how
much it turns.  The browser knows how large the panels are, and where they stand.
"""

from __future__ import annotations

import cmath
import math
from typing import Any

from vad.lecture.lesson import Lesson
from vad.lecture.pace import LANDED, PHASES
from vad.page.ink import Inker
from vad.plan.board import Plan
from vad.plan.geometry import Rect
from vad.plan.pictures.flights import Flight


def page_flights(lesson: Lesson, board: Plan, inker: Inker) -> dict[int, list[Any]]:
    """Return what flies, by the number of its stroke in the lesson.

    Each is a list: for how many seconds it flies, what it is to its source, the seconds of its
    phases, the number of the panel that it leaves; by how many degrees it is turned clockwise
    there, and by how many when it has turned and is stretched, and how long it then is, as a
    multiple of how it lands: it may leave a view from another side.  Then where its tail and its
    head are there, and in its own panel: to the right and down, in pixels of a page 1280 wide.
    """
    numbers = {s.panel.full(s.stroke.name): number for number, s in enumerate(lesson.steps)}
    columns = [panel.name for panel in lesson.sheet.panels]
    page = Rect(0.0, 0.0, board.form.width, board.form.height)
    unit, left, top = inker.frame
    found = {}
    for name, travel in (lesson.travels or {}).items():
        flight = Flight.of(name, travel, board.sketches, (page, page))
        if flight is None:
            continue
        scale, number = flight.polygon.scale, numbers[name]
        ends = *flight.source, scale(travel.start), scale(travel.end)
        pixels = (((z.real - left) * unit, (top - z.imag) * unit) for z in ends)
        places = [round(each, 2) for z in pixels for each in z]
        source = columns.index(board.sketches[travel.source].setting.panel.column)
        tilt = math.degrees(cmath.phase(travel.oblique))
        turns = (travel.turn - tilt, -tilt, abs(travel.oblique))
        phases = PHASES[travel.kind]
        share = sum(phases) / (sum(phases) + LANDED)
        seconds = round(share * lesson.steps[number].grow / lesson.fps, 3)
        kind = travel.kind if flight.is_vector else "area"
        looks = [round(each, 2) + 0.0 for each in turns]
        found[number] = [seconds, kind, phases, source, *looks, *places]
    return found
