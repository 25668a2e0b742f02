"""A small lesson and a painter of frames that needs no fonts: what the encoders are tested with."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.lecture.lesson import Lesson, LessonStep
from vad.painting.film import EMPTY, Frame
from vad.strokes.sheet import Arc, Arrow, Block, Dot, Guide, Line, Panel, Sheet, Stroke
from vad.style import load_style

Bytes = NDArray[np.uint8]
INKS = np.array([list(bytes.fromhex(ink[1:])) for ink in load_style("paper").inks[:4]])
TEXT = np.array([26, 26, 26])

POSITION = Panel(
    "position",
    "mm",
    (
        Stroke("fixed", "A", Dot(0), "Fix A."),
        Stroke("guide", "guide", Guide(0 + 0j, 1 + 0j, -1j), "The guide."),
        Stroke("guide", "slot", Guide(0 + 0j, 1j), "The slot."),
        Stroke("angle", "60°", Arc(0, 60.0, 0.0, 60.0), "The angle."),
        Stroke(
            "construction", "BC", Arc(30 + 52j, 140.0, 270.0, 65.0, 160 + 0j), "Compass.", "rod"
        ),
        Stroke("result", "AB", Arrow(0, 30 + 52j, "A", "B"), "The crank.", "crank", "link"),
        Stroke("result", "C", Block(160 + 0j, 1 + 0j), "The block.", "slider"),
    ),
    title="Position",
    picture="skeleton",
)
VELOCITY = Panel(
    "velocity",
    "mm/s",
    (
        Stroke("pole", "a,d", Dot(complex(0.0, -0.0)), "Choose a pole."),
        Stroke(
            "known",
            "ab",
            Arrow(0, -519.6152422706632 + 300j, "a", "b"),
            "ab = ω₂·AB = 10 × 60 = 600 mm/s, ⟂ AB",
            "crank",
            "tangential",
        ),
        Stroke(
            "construction",
            "⟂ BC",
            Line(-519.6152422706632 + 300j, 0.6 + 0.8j, 5j, "BC"),
            "Perpendicular to BC: a < b & c.",
            "rod",
        ),
        Stroke("intersection", "c", Dot(-600 + 0j), "They meet in c."),
    ),
    title="Velocity",
)
SHEET = Sheet("slider-crank", "Slider-crank", (("crank", 60.0, "mm"),), (), (POSITION, VELOCITY))


def lesson(
    *,
    steps: int = 4,
    grow: int = 3,
    hold: int = 4,
    fps: float = 30.0,
    size: tuple[int, int] = (96, 64),
    style: str = "paper",
) -> Lesson:
    """Return a lesson that goes round the strokes of `SHEET`."""
    places = [(panel, i) for panel in SHEET.panels for i in range(len(panel.strokes))]
    chosen = [places[-1 - k % len(places)] for k in range(steps)]
    return Lesson(
        SHEET, tuple(LessonStep(*place, grow, hold) for place in chosen), 5, 7, fps, size, style
    )


def frames(lesson: Lesson) -> Iterator[Frame]:
    """Paint growing antialiased lines and blocks of ragged "text", as the real painter does."""
    width, height = lesson.size
    random = np.random.default_rng(1)
    buffer = np.full((height, width, 4), 255, np.uint8)
    _write_text(buffer, (2, 2), random)
    yield Frame(buffer, (0, 0, width, height), lesson.opening)
    for number, step in enumerate(lesson.steps):
        start, end = (complex(*random.uniform(0.1, 0.9, 2) * lesson.size) for _ in range(2))
        box = _box(start, end, lesson.size)
        base = buffer[box[1] : box[3], box[0] : box[2]].copy()
        for grown in range(1, step.grow + 1):
            tip = start + (end - start) * grown / step.grow
            buffer[box[1] : box[3], box[0] : box[2]] = base
            _draw_line(buffer, box, start, tip, INKS[number % len(INKS)])
            yield Frame(buffer, box, 1)
        place = tuple(random.integers(0, np.array(lesson.size) - 10))
        _write_text(buffer, place, random)
        yield Frame(buffer, (place[0], place[1], place[0] + 9, place[1] + 7), 1)
        yield Frame(buffer, EMPTY, step.hold - 1)
    yield Frame(buffer, EMPTY, lesson.closing)


def pictures(lesson: Lesson) -> list[Bytes]:
    """Return every frame of the constant rate as RGB."""
    return [
        picture
        for frame in frames(lesson)
        for picture in [frame.pixels[..., :3].copy()] * frame.repeats
    ]


def filmed(source: Any = frames) -> Any:
    """Return a function that stands for ``vad.painting.film.filmed``."""
    return lambda film, most=math.inf: source(film)


def _box(start: complex, end: complex, size: tuple[int, int]) -> tuple[int, int, int, int]:
    xs, ys = sorted((start.real, end.real)), sorted((start.imag, end.imag))
    return (
        max(0, math.floor(xs[0]) - 3),
        max(0, math.floor(ys[0]) - 3),
        min(size[0], math.ceil(xs[1]) + 3),
        min(size[1], math.ceil(ys[1]) + 3),
    )


def _draw_line(buffer: Bytes, box: Any, start: complex, tip: complex, ink: Any) -> None:
    rows, columns = np.mgrid[box[1] : box[3], box[0] : box[2]] + 0.5
    pixels = columns + 1j * rows - start
    along = tip - start
    share = np.clip((pixels * along.conjugate()).real / abs(along) ** 2, 0, 1)
    cover = np.clip(2.0 - abs(pixels - share * along), 0, 1)[..., None]
    window = buffer[box[1] : box[3], box[0] : box[2], :3]
    window[...] = np.round(window * (1 - cover) + ink * cover)


def _write_text(buffer: Bytes, place: Any, random: Any) -> None:
    shade = random.choice([0.0, 0.3, 0.7, 1.0], (7, 9, 1))
    window = buffer[place[1] : place[1] + 7, place[0] : place[0] + 9, :3]
    window[...] = np.round(255 + shade * (TEXT - 255))
