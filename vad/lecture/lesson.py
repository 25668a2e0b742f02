"""A sheet that is drawn stroke by stroke: how long each grows and rests, and the page at one step.

A `Lesson` is made from a sheet, and its times are whole frames.  Only `vad.plan` knows how a frame
looks.
"""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import accumulate, pairwise
from typing import Any

from vad import gate
from vad.discovery import names_in, one_of_all
from vad.displayed import Displayed
from vad.errors import InputError, UsageError, one_of, quoted
from vad.lecture.moment import Moment, done, drawing
from vad.strokes.reveals import revealed
from vad.strokes.sheet import Arrow, Fold, Panel, Sheet, Stroke, driver_of


@dataclass(frozen=True, slots=True)
class LessonStep:
    """One stroke in time: it grows for ``grow`` frames and then rests for ``hold``.

    After the last stroke of a panel that stood large, this glides into its place for ``glide``, and
    the page that comes with it rests for ``settle``.  A stroke that is ``there`` is not drawn: it
    is on the board when its panel begins.
    """

    panel: Panel
    index: int
    grow: int
    hold: int
    glide: int = 0
    settle: int = 0
    there: bool = field(default=False, kw_only=True)

    @property
    def frames(self) -> int:
        """The number of frames."""
        return self.grow + self.hold + self.glide + self.settle

    @property
    def stroke(self) -> Stroke:
        """The stroke that is drawn in this step."""
        return self.panel.strokes[self.index]


@dataclass(frozen=True, slots=True, repr=False)
class Lesson(Displayed):
    """A sheet that is drawn stroke by stroke.

    ``opening`` frames show the empty page, ``closing`` frames the finished one.
    """

    sheet: Sheet
    steps: tuple[LessonStep, ...]
    opening: int
    closing: int
    fps: float
    size: tuple[int, int]
    style: str = "paper"

    def __repr__(self) -> str:
        """Return a line: what is drawn, in how many steps, and how long that takes."""
        width, height = self.size
        film = f"{self.duration:.1f} s, {self.fps:g} frames per second, {width}x{height}"
        return f"<Lesson of {self.sheet.mechanism}: {len(self.steps)} steps, {film}>"

    @property
    def frames(self) -> int:
        """The number of frames."""
        return self.opening + self.closing + sum(step.frames for step in self.steps)

    @property
    def begun(self) -> int:
        """The number of strokes that are on the board before the first is drawn."""
        return next((i for i, step in enumerate(self.steps) if not step.there), len(self.steps))

    def place(self, step: LessonStep) -> int:
        """Return the number of a step in its panel, from 1; a polygon above counts, too."""
        column = self.sheet.panel(step.panel.column)
        return step.index + 1 + (0 if step.panel is column else len(column.strokes))

    @property
    def duration(self) -> float:
        """The running time in seconds."""
        return self.frames / self.fps


#: Seconds in which each kind of stroke grows.  A vector takes as long if it is the longest one of
#: its panel.
GROWTH = {
    "fixed": 0.4,
    "guide": 0.8,
    "pole": 0.3,
    "angle": 0.8,
    "known": 1.2,
    "construction": 1.5,
    "intersection": 0.3,
    "result": 1.2,
}
FOLD = 1.0  # a plane that is rotated into the paper
SHORT = 0.75  # share of that time for a vector of length zero
WORDS_PER_SECOND = 5.0
BREATH = 0.3  # after a caption has been read
LEAST_REST = 0.5
GLIDE = 0.8
SETTLE = 0.8
OPENING = 0.8
CLOSING = 4.0
LOOK = 1.5  # seconds to look at what is on the board already

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
    loop: int = 1,
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
    loop
        The number of the loop, and so of the dyad, at which drawing starts.  In every panel the
        loops before it are on the board already.

    Raises
    ------
    vad.errors.UsageError
        If a value is out of its range, or the style unknown.
    """
    if not isinstance(sheet, Sheet):
        raise UsageError(f"sheet: must be what vad.draw returns, got {quoted(sheet)}")
    loop = _loop(sheet, loop)
    fps, size, speed = checked(fps, size, speed, style)

    def count(seconds: float) -> int:
        return max(1, round(seconds / speed * fps))

    steps: list[LessonStep] = []
    clock = 0.0
    for panel in sheet.halves:
        longest = max(map(_length, panel.strokes), default=0.0)
        for index, stroke in enumerate(panel.strokes):
            last = index + 1 == len(panel.strokes)
            begun = panel.loops[loop - 1] if 1 < loop <= len(panel.loops) else panel.given
            glide, settle = (GLIDE, SETTLE) if last and opens(sheet, panel) else (0.0, 0.0)
            if index < begun:
                grow, hold = 0.0, LOOK if index + 1 == begun else 0.0
            else:
                grow = growth(stroke, longest)
                hold = rest(stroke, grow)
            times = grow, hold, glide, settle
            # Whole frames are counted from the start, so that roundings do not add up.
            seconds = list(accumulate(times, initial=clock))
            ends = [round(second / speed * fps) for second in seconds]
            lasts = (end - start for start, end in pairwise(ends))
            steps.append(LessonStep(panel, index, *lasts, there=index < begun))
            clock = seconds[-1]
    return Lesson(sheet, tuple(steps), count(OPENING), count(CLOSING), fps, size, style)


def _loop(sheet: Sheet, loop: object) -> int:
    """Return the number of a loop, after checking that a sheet has it."""
    count = max(len(panel.loops) for panel in sheet.panels)
    found = gate.index(loop)
    if found is None or not 1 <= found <= max(count, 1):
        hint = "this mechanism has one loop" if count < 2 else f"try 2, of its {count} loops"
        raise UsageError(f"loop: must be between 1 and {max(count, 1)}, got {quoted(loop)}", hint)
    return found


def opens(sheet: Sheet, panel: Panel) -> bool:
    """Tell whether a panel stands large while it is drawn: a mechanism before its polygons."""
    return panel is sheet.panels[0] and panel.picture != "vectors" and len(sheet.panels) > 1


def growth(stroke: Stroke, longest: float) -> float:
    """Return how many seconds a stroke takes to draw; the ``longest`` vector takes most."""
    seconds = FOLD if isinstance(stroke.shape, Fold) else GROWTH[stroke.kind]
    if not isinstance(stroke.shape, Arrow) or not longest:
        return seconds
    return seconds * (SHORT + (1.0 - SHORT) * _length(stroke) / longest)


def rest(stroke: Stroke, grown: float) -> float:
    """Return how many seconds a stroke rests that has grown for ``grown`` seconds.

    Both times together are long enough to read its caption.
    """
    reading = len(stroke.caption.split()) / WORDS_PER_SECOND
    return max(reading + BREATH - grown, LEAST_REST)


def _length(stroke: Stroke) -> float:
    """Return the length of a vector, 0 for another stroke."""
    shape = stroke.shape
    return abs(shape.end - shape.start) if isinstance(shape, Arrow) else 0.0


def checked(
    fps: float, size: tuple[int, int], speed: float, style: str
) -> tuple[float, tuple[int, int], float]:
    """Return rate, size and speed of a film as plain numbers.

    Raises
    ------
    vad.errors.UsageError
        For a value that no film can have, or an unknown style.
    """
    one_of_all("style", style, names_in("style"), "vad.styles")
    return (
        _number("fps", fps, FPS, "try --fps 30"),
        check_size(size),
        _number("speed", speed, SPEED, "try --speed 1"),
    )


def _number(name: str, value: object, ends: tuple[float, float], hint: str) -> float:
    """Return a number in its range; NaN is out of every range."""
    with contextlib.suppress(InputError):
        number = gate.number(name, value)
        if ends[0] <= number <= ends[1]:
            return number
    got = quoted(value)
    raise UsageError(f"{name}: must be between {ends[0]:g} and {ends[1]:g}, got {got}", hint)


def check_size(size: tuple[int, int]) -> tuple[int, int]:
    """Return width and height as whole numbers.

    Raises
    ------
    vad.errors.UsageError
        For a size that no picture can have.
    """
    wanted, hint = "a width and a height in pixels", "try 1280x720"
    try:
        sides = [gate.number("size", each) for each in gate.several("size", size, wanted)]
        width, height = map(int, sides)
        whole = [width, height] == sides
    except (InputError, ValueError):
        whole = False
    if not whole:
        raise UsageError(f"size: must be {wanted}, got {quoted(size)}", hint)
    ends = zip(SMALLEST, (width, height), LARGEST, strict=True)
    if not all(low <= side <= high for low, side, high in ends):
        smallest, largest, got = (
            "x".join(map(quoted, each)) for each in (SMALLEST, LARGEST, (width, height))
        )
        raise UsageError(f"size: must be between {smallest} and {largest}, got {got}", hint)
    return width, height


#: How much of a construction is drawn while it stands still.
AT_WORK = 0.7
#: A longer number is larger than any step, and Python refuses to read a very long one.
_DIGITS = 9


@dataclass(frozen=True, slots=True, repr=False)
class Still(Displayed):
    """The page of a lesson at a step, which is counted from 1.

    A construction line is shown while it is drawn, with its tool; everything before is complete.
    """

    lesson: Lesson
    step: int

    def __repr__(self) -> str:
        """Return a line: which step of which lesson it is."""
        steps = len(self.lesson.steps)
        return f"<Still of {self.lesson.sheet.mechanism}: step {self.step} of {steps}>"

    @property
    def moment(self) -> Moment:
        """The state of the board."""
        if self.lesson.steps[self.step - 1].stroke.kind == "construction":
            return Moment(drawing(self.step - 1), AT_WORK)
        return Moment(done(self.step))

    @property
    def drawn(self) -> Sheet:
        """The sheet as far as it is drawn, with the results that are known by then."""
        strokes: dict[str, tuple[Stroke, ...]] = {}
        for step in self.lesson.steps[: self.step]:
            strokes[step.panel.name] = (*strokes.get(step.panel.name, ()), step.stroke)
        return drawn_so_far(self.lesson.sheet, strokes)


def drawn_so_far(sheet: Sheet, strokes: Mapping[str, tuple[Stroke, ...]]) -> Sheet:
    """Return a sheet as far as it is drawn.

    ``strokes`` holds the strokes that are drawn, by the name of their panel.  Panels without any
    are left out, and so are values that have not been measured yet.
    """
    panels = tuple(filter(None, (_panel_so_far(panel, strokes) for panel in sheet.panels)))
    known = {
        found
        for panel in panels
        for half in panel.halves
        for stroke in half.strokes
        for found in revealed(half, stroke)
    }
    rows = []
    for row in sheet.rows:
        cells = {
            panel.name: tuple(
                cell
                for half, measured in sheet.panel(panel.name).measures(row)
                for cell in measured
                if cell.given or (half.name, row.key) in known
            )
            for panel in panels
        }
        if any(cells.values()):
            rows.append(replace(row, cells=cells))
    driver = driver_of(sheet.driver.row, sheet.driver.turns, rows, panels)
    return replace(sheet, panels=panels, rows=tuple(rows), driver=driver)


def _panel_so_far(panel: Panel | None, strokes: Mapping[str, tuple[Stroke, ...]]) -> Panel | None:
    """Return a panel as far as it is drawn, or None if nothing of it is."""
    if panel is None or not strokes.get(panel.name):
        return None
    return replace(panel, strokes=strokes[panel.name], below=_panel_so_far(panel.below, strokes))


def still(lesson: Lesson, step: int | str) -> Still:
    """Return the page of a lesson at one step.

    Parameters
    ----------
    lesson
        The lesson.
    step
        Its number, from 1, over the whole lesson; or ``"velocity:4"``, the fourth of a panel.

    Raises
    ------
    vad.errors.UsageError
        If there is no such step.
    """
    if not isinstance(lesson, Lesson):
        raise UsageError(f"lesson: must be what vad.animate returns, got {quoted(lesson)}")
    panel, colon, number = step.rpartition(":") if isinstance(step, str) else ("", "", step)
    places: dict[str, list[int]] = {
        name: [i for i, each in enumerate(lesson.steps, 1) if each.panel.column == name]
        for name in (each.name for each in lesson.sheet.panels)
    }
    steps = places[one_of("panel", panel, places)] if colon else range(1, len(lesson.steps) + 1)
    where = f"the {panel} panel" if colon else "the lesson"
    place = _place(number)
    if place is None:
        raise UsageError(f"{quoted(step)} is not a step", hint="as in 4 or velocity:4")
    if not 1 <= place <= len(steps):
        got = quoted(number).strip("'")
        raise UsageError(f"there is no step {got}: {where} has {len(steps)}, from 1 on")
    return Still(lesson, steps[place - 1])


def _place(number: Any) -> int | None:
    """Return the number of a step, or None if this is no such number."""
    if isinstance(number, str):
        return int(number.strip()[:_DIGITS]) if number.strip().isdecimal() else None
    return gate.index(number)
