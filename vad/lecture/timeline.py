"""Laying a sheet out in time: how long each stroke grows, and how long it rests.

In comes a sheet, out goes a `Lesson` in whole frames.
"""

from __future__ import annotations

import contextlib
import math
from numbers import Real

from vad.errors import UsageError, one_of, shown
from vad.found import names_in
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
        If a value is out of its range, or the style unknown.
    """
    if not isinstance(sheet, Sheet):
        raise UsageError(f"sheet: must be what vad.draw returns, got {shown(sheet)}")
    fps, size, speed = checked(fps, size, speed, style)

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
    return Lesson(sheet, tuple(steps), count(OPENING), count(CLOSING), fps, size, style)


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


def checked(
    fps: float, size: tuple[int, int], speed: float, style: str
) -> tuple[float, tuple[int, int], float]:
    """Return rate, size and speed of a film as plain numbers.

    Raises
    ------
    vad.errors.UsageError
        For a film that cannot be, or an unknown style.
    """
    one_of("style", style, names_in("style"))
    return (
        _number("fps", fps, FPS, "try --fps 30"),
        check_size(size),
        _number("speed", speed, SPEED, "try --speed 1"),
    )


def _number(name: str, value: object, ends: tuple[float, float], hint: str) -> float:
    """Return a number in its range; NaN is out of every range."""
    if isinstance(value, Real) and not isinstance(value, bool):
        with contextlib.suppress(OverflowError, TypeError):  # beyond every float; a span of time
            number = float(value)
            if ends[0] <= number <= ends[1]:
                return number
    got = shown(value)
    raise UsageError(f"{name}: must be between {ends[0]:g} and {ends[1]:g}, got {got}", hint)


def check_size(size: tuple[int, int]) -> tuple[int, int]:
    """Return width and height as whole numbers.

    Raises
    ------
    vad.errors.UsageError
        For a size that no picture can have.
    """
    hint = "try 1280x720"
    try:
        width, height = (int(side) for side in size if isinstance(side, Real))
        whole = (width, height) == tuple(size) and not isinstance(size, str | bytes)
    except (TypeError, ValueError, OverflowError):
        whole = False
    if not whole:
        message = f"size: must be a width and a height in pixels, got {shown(size)}"
        raise UsageError(message, hint)
    ends = zip(SMALLEST, (width, height), LARGEST, strict=True)
    if not all(low <= side <= high for low, side, high in ends):
        smallest, largest, got = (
            "x".join(map(shown, each)) for each in (SMALLEST, LARGEST, (width, height))
        )
        raise UsageError(f"size: must be between {smallest} and {largest}, got {got}", hint)
    return width, height
