"""Laying a sheet out in time: how long each stroke grows, and how long it rests.

In comes a sheet, out goes a `Lesson` in whole frames.
"""

from __future__ import annotations

import math

from vad.errors import UsageError
from vad.lecture.lesson import Lesson, Step
from vad.strokes.sheet import Arc, Arrow, Line, Panel, Sheet, Stroke

GROWTH = {
    "fixed": 0.20,
    "guide": 0.35,
    "pole": 0.20,
    "angle": 0.40,
    "known": 0.50,
    "construction": 0.60,
    "intersection": 0.15,
    "result": 0.50,
}
SHORT = 0.7  # of the time for a vector under a quarter of the panel's longest
# With the stroke's growth a caption stands long enough to be read at five words a second.
REST = 0.50
REST_PER_WORD = 0.18
OPENING = 0.8
CLOSING = 4.0

FPS = (1.0, 240.0)
SPEED = (0.01, 1000.0)
SMALLEST = (320, 240)
LARGEST = (7680, 4320)


def animate(
    sheet: Sheet,
    fps: float = 30,
    size: tuple[int, int] = (1280, 720),
    speed: float = 1.0,
    style: str = "paper",
) -> Lesson:
    """Return the lesson in which ``sheet`` is drawn stroke by stroke.

    Parameters
    ----------
    sheet
        What is drawn.
    fps
        Frames per second, 1 to 240.
    size
        Width and height in pixels, 320×240 to 7680×4320.
    speed
        Divides all times: 2 is twice as fast.
    style
        The name of a style.

    Raises
    ------
    vad.errors.UsageError
        If a value is out of its range.
    """
    if not isinstance(sheet, Sheet):
        raise UsageError(f"sheet: must be what vad.draw returns, got {sheet!r}")
    check(fps, size, speed)

    def count(seconds: float) -> int:
        return max(1, round(seconds / speed * fps))

    steps: list[Step] = []
    clock = 0.0
    for panel in sheet.panels:
        longest = max((_length(stroke) for stroke in panel.strokes), default=0.0)
        for index, stroke in enumerate(panel.strokes):
            grow, hold = growth(stroke, longest), rest(stroke)
            # Whole frames are counted from the start, so that roundings do not add up.
            first = round(clock / speed * fps)
            grown = round((clock + grow) / speed * fps)
            clock += grow + hold
            last = round(clock / speed * fps)
            steps.append(_step(panel, index, first, grown, last))
    return Lesson(
        sheet, tuple(steps), count(OPENING), count(CLOSING), fps, (size[0], size[1]), style
    )


def _step(panel: Panel, index: int, first: int, grown: int, last: int) -> Step:
    return Step(panel, index, grow=max(grown - first, 0), hold=max(last - grown, 0))


def growth(stroke: Stroke, longest: float) -> float:
    """Return how many seconds a stroke takes to draw; a short vector takes less."""
    seconds = GROWTH[stroke.kind]
    short = isinstance(stroke.shape, Arrow) and _length(stroke) < 0.25 * longest
    return seconds * (SHORT if short else 1.0)


def rest(stroke: Stroke) -> float:
    """Return how many seconds a stroke rests: the longer its caption, the longer."""
    return REST + REST_PER_WORD * len(stroke.caption.split())


def _length(stroke: Stroke) -> float:
    shape = stroke.shape
    if isinstance(shape, Arrow):
        return abs(shape.end - shape.start)
    if isinstance(shape, Line):
        return abs(shape.until - shape.through)
    if isinstance(shape, Arc):
        return abs(math.radians(shape.sweep)) * shape.radius
    return 0.0


def check(fps: float, size: tuple[int, int], speed: float) -> None:
    """Raise `vad.errors.UsageError` for a film that cannot be."""
    _check_number("fps", fps, FPS, "try --fps 30")
    _check_number("speed", speed, SPEED, "try --speed 1")
    check_size(size)


def _check_number(name: str, value: float, ends: tuple[float, float], hint: str) -> None:
    """Raise an error for what is no number, or out of its range; NaN is out of every range."""
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not (number and ends[0] <= value <= ends[1]):
        shown = f"{value:g}" if number else repr(value)
        raise UsageError(
            f"{name}: must be between {ends[0]:g} and {ends[1]:g}, got {shown}", hint=hint
        )


def check_size(size: tuple[int, int]) -> None:
    """Raise `vad.errors.UsageError` for a size that no picture can have."""
    try:
        whole = len(size) == 2 and all(side == int(side) for side in size)
    except (TypeError, ValueError, OverflowError):
        whole = False
    if not whole:
        raise UsageError(
            f"size: must be a width and a height in pixels, got {size}", hint="try 1280x720"
        )
    if not all(
        low <= side <= high for low, side, high in zip(SMALLEST, size, LARGEST, strict=True)
    ):
        raise UsageError(
            f"size: must be between {SMALLEST[0]}x{SMALLEST[1]} and "
            f"{LARGEST[0]}x{LARGEST[1]}, got {size[0]}x{size[1]}",
            hint="try 1280x720",
        )
