"""What is placed where, as text that a reviewer reads in a diff.

Each file shows the plan of one scene: a line for an item (its place in the painting order, the
beats in which it shows, its stroke) and a line for each of its marks (role, row, coordinates in
thousandths of the page unit, growth).  ``python -m tests.plan.snapshots`` writes them anew.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, assert_never

import vad
from tests.kinds import SPACE
from vad.lecture.lesson import Lesson
from vad.plan.board import Plan, plan
from vad.plan.format import screen
from vad.plan.items import FOREVER, Item
from vad.plan.marks import (
    Bending,
    Bow,
    Disc,
    Fading,
    Flying,
    Growth,
    Lettering,
    Mark,
    Outline,
    Polygon,
    Polyline,
    Scaling,
    Sliding,
    Trimming,
    Turning,
)
from vad.plan.turn_board import TurnBoard
from vad.strokes.sheet import Sheet
from vad.style import load_style

HERE = Path(__file__).parent
KEY = 0.058

#: Dimensions and inputs of which a scene consists; each mechanism with its defaults besides.
SCENES: dict[str, tuple[str, dict[str, Any], dict[str, float]]] = {
    **{name: (name, {}, {}) for name in vad.MECHANISMS},
    "four-bar-crossed": ("four-bar", {"assembly": "crossed"}, {"omega": -10, "alpha": 30}),
    "slider-crank-offset": ("slider-crank", {"offset": 30}, {"angle": 200, "alpha": 20}),
    "shaper": ("crank-slotted-lever", {"rod": 100, "ram_height": 180}, {"angle": 155}),
    "quick-return": ("whitworth", {"rod": 300}, {"angle": 120}),
}


def sheet(scene: str) -> Sheet:
    """Return the sheet of a scene."""
    name, dimensions, inputs = SCENES[scene]
    return vad.draw(vad.solve(vad.MECHANISMS[name](**dimensions), **inputs))


def lesson(scene: str) -> Lesson:
    """Return the lesson of a scene."""
    return vad.animate(sheet(scene))


def lesson_plan(film: Lesson) -> Plan:
    """Return all panels of a lesson side by side, with its captions."""
    return plan(film.sheet, screen(film.size), load_style(film.style).key, lesson=True)


def _lesson(scene: str) -> Iterable[str]:
    return written(lesson_plan(lesson(scene)).items)


def _still(scene: str) -> Iterable[str]:
    page = plan(sheet(scene), screen((1024, 768)), KEY)
    return written(page.shown(page.finished))


def _turn(scene: str) -> Iterable[str]:
    name, dimensions, inputs = SCENES[scene]
    motion = vad.solve(vad.MECHANISMS[name](**dimensions), **inputs)
    board = TurnBoard(vad.turn(motion, fps=10))
    for frame in (0, 29):
        yield f"frame {frame}"
        yield from written(board.shown(frame))


#: Their turns show nothing that those of others do not, and of space stills and lessons tell.
STANDING = {
    *("crank-slotted-lever", "whitworth", "four-bar-crossed", "slider-crank-offset"),
    *SPACE,
}
#: The kinds of picture; a lesson is at 16:9, a still at 4:3.
KINDS: dict[str, Callable[[str], Iterable[str]]] = {
    "lesson": _lesson,
    "still": _still,
    "turn": _turn,
}
SNAPSHOTS = [
    (scene, kind)
    for scene in SCENES
    for kind in KINDS
    if not (kind == "turn" and scene in STANDING)
]


def written(items: Iterable[Item]) -> Iterator[str]:
    """Yield the lines of a snapshot."""
    for item in items:
        until = "" if item.until >= FOREVER else str(item.until)
        span = f"{max(item.since, 0)}-{until}"
        yield f"{item.region} | {item.level.name.lower()} | {span} | {item.stroke}".rstrip(" |")
        for mark in item.marks:
            yield "  " + " ".join(part for part in _mark(mark) if part)


def _mark(mark: Mark) -> Iterator[str]:
    yield mark.role
    yield "" if mark.row is None else f"[{mark.row}]"
    yield "" if mark.width == 1.0 else f"x{mark.width:g}"
    yield "" if mark.alpha == 1.0 else f"alpha {mark.alpha:g}"
    yield _shape(mark.shape)
    yield _growth(mark.growth) if mark.growth else ""


def _shape(shape: Outline) -> str:
    match shape:
        case Polyline(pieces):
            return " / ".join(_points(piece) for piece in pieces)
        case Polygon(rings):
            return "area " + " hole ".join(_points(ring) for ring in rings)
        case Disc(centre, radius):
            return f"disc {_points([centre])} r {_number(radius)}"
        case Bow(centre, radius, start, sweep, axis, narrow):
            turn = math.degrees(cmath.phase(axis))
            aside = "" if narrow == 1.0 else f" x{narrow:.3f} across {turn:.0f}°"
            return f"arc {_points([centre])} r {_number(radius)} {start:.1f}° {sweep:+.1f}°{aside}"
        case Lettering(runs, at, size):
            text = "".join({-1: "_", 0: "", 1: "^"}[run.script] + run.text for run in runs)
            faces = "/".join(dict.fromkeys(run.face for run in runs))
            return f"«{text}» {faces} {_number(size)} at {_points([at])}"


def _growth(growth: Growth) -> str:
    match growth:
        case Trimming(knots):
            return "trim" + ("" if len(knots) == 2 else f" from {_number(knots[1][0])}")
        case Sliding(knots):
            return "slide " + " ".join(f"{_number(x)}:{_points([z])}" for x, z in knots)
        case Turning(centre, knots):
            return f"turn about {_points([centre])} from {knots[0][1]:.1f}°"
        case Flying(centre, legs):
            degrees, factor = legs[0].degrees, legs[0].factor
            return f"fly to {_points([centre])} from {degrees:.1f}° x{factor:.3f}"
        case Bending(legs):
            return f"bend from {legs[0].degrees:.1f}°"
        case Scaling(_, knots):
            return f"scale from {knots[0][1]:g}"
        case Fading(knots):
            return f"fade from {knots[0][1]:g}"
        case _:
            assert_never(growth)


def _points(points: Iterable[complex]) -> str:
    return " ".join(f"{_number(z.real)},{_number(z.imag)}" for z in points)


def _number(value: float) -> str:
    return f"{round(1000 * value)}"
