"""A sheet that is drawn stroke by stroke: how long each grows and rests, and the page at one step.

A `Lesson` is made from a sheet, and its times are whole frames.  Only `vad.plan` knows how a frame
looks.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import accumulate, pairwise
from typing import Any

from vad import gate
from vad.discovery import names_in, one_of_all
from vad.displayed import Displayed
from vad.errors import InputError, UsageError, quoted
from vad.lecture.answer import answer
from vad.lecture.moment import Moment, done, drawing
from vad.lecture.pace import AFTER_ANSWER, CLOSING, GLIDE, OPENING, SETTLE, SHEET, scripted, times
from vad.lecture.scenes import is_staged, scene_numbers
from vad.lecture.script import Script, script_of, step_number
from vad.lecture.telling import reading, share_caption
from vad.strokes.reveals import measurer
from vad.strokes.sentences import Sentence
from vad.strokes.sheet import Panel, Row, Sheet, Stroke, driver_of
from vad.strokes.telling import telling
from vad.strokes.travel import Travel
from vad.strokes.travels import travels


@dataclass(frozen=True, slots=True)
class LessonStep:
    """One stroke in time: it grows for ``grow`` frames and then rests for ``hold``.

    It belongs to a ``scene`` (`vad.lecture.scenes`).  After the last stroke of a scene the panels
    glide to their places in the next one for ``glide``, and rest there for ``settle``.  After
    ``beats`` frames the second beat of its caption is said, then the third.  A stroke that is
    ``there`` is not drawn: it is on the board when its panel begins.  The ``chapter`` is the panel
    with which it is told.  Where a vector flies, a ``pencil`` would draw it in so many frames.
    While it rests, ``sent`` says, an ω or α that it finds flies to its link: from which frame of
    the step on, and for how many.
    """

    panel: Panel
    index: int
    grow: int
    hold: int
    glide: int = 0
    settle: int = 0
    beats: tuple[int, ...] = field(default=(), kw_only=True)
    there: bool = field(default=False, kw_only=True)
    chapter: str = field(default="", kw_only=True)
    scene: int = field(default=0, kw_only=True)
    pencil: int = field(default=0, kw_only=True)
    sent: tuple[int, int] = field(default=(0, 0), kw_only=True)

    @property
    def frames(self) -> int:
        """The number of frames."""
        return self.grow + self.hold + self.glide + self.settle

    @property
    def stroke(self) -> Stroke:
        """The stroke that is drawn in this step."""
        return self.panel.strokes[self.index]

    @property
    def repeats(self) -> bool:
        """Whether the same is said of the stroke before it."""
        return self.index > 0 and share_caption(self.panel.strokes, self.index - 1)

    @property
    def has_page(self) -> bool:
        """Whether it has a page or a slide: what is drawn has one for each caption."""
        return not self.there and not share_caption(self.panel.strokes, self.index)


@dataclass(frozen=True, slots=True, repr=False)
class Lesson(Displayed):
    """A sheet that is drawn stroke by stroke.

    ``opening`` frames show what is drawn first, as it will be (`opens`), and how it fades before it
    is drawn; ``closing`` frames show the finished page with the ``answer`` in words, if it has one.
    Where there are scenes, they bring the panels to their places in the sheet for ``glide``, and
    show it for ``settle``.
    ``travels`` says what flies from panel to panel, by the full names of strokes
    (`vad.strokes.travels`); None where nothing does.
    """

    sheet: Sheet
    steps: tuple[LessonStep, ...]
    opening: int
    closing: int
    fps: float
    size: tuple[int, int]
    style: str = "paper"
    answer: Sentence | None = None
    glide: int = 0
    settle: int = 0
    travels: Mapping[str, Travel] | None = None

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

    @property
    def opens(self) -> int:
        """How many strokes are seen before the first is drawn: those of the first scene.

        So a film and a page begin with the mechanism.  Where strokes are on the board already, it
        is those.
        """
        return self.begun or sum(step.scene == 0 for step in self.steps)

    def place(self, step: LessonStep) -> int:
        """Return the number of a step in its chapter, from 1; a polygon above counts, too."""
        mine = [each for each in self.steps if each.chapter == step.chapter]
        return mine.index(step) + 1

    @property
    def duration(self) -> float:
        """The running time in seconds."""
        return self.frames / self.fps


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
    script: Script | Mapping[str, Any] | str | os.PathLike[str] | None = None,
    plain: bool = False,
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
    script
        Captions of one's own, pauses and markers, by the names of strokes or their steps: a file in
        TOML, or a mapping with the tables ``captions``, ``pauses`` and ``markers``.
    plain
        Whether a pencil draws every vector.  Otherwise, in films, a vector that is known leaves the
        link or the velocity that it comes from, turns, and flies to its polygon.

    Raises
    ------
    vad.errors.UsageError
        If a value is out of its range, or the style unknown; for a stroke in the script that is
        none, or a marker before which the strokes cannot be drawn.
    vad.errors.InputError
        For a script that cannot be read.

    Examples
    --------
    >>> import vad
    >>> sheet = vad.draw(vad.solve(vad.SliderCrank()))
    >>> usual = vad.animate(sheet)
    >>> slower = vad.animate(sheet, script={"pauses": {"velocity:C.crossing": 3}})
    >>> round(slower.duration - usual.duration, 1)
    3.0
    """
    if not isinstance(sheet, Sheet):
        raise UsageError(f"sheet: must be what vad.draw returns, got {quoted(sheet)}")
    loop = _loop(sheet, loop)
    fps, size, speed = checked(fps, size, speed, style)

    script = script_of(script)
    sheet, opening = script.told(sheet), OPENING / speed
    flown = None if gate.flag("plain", plain) else travels(sheet)
    found = [each.faster(speed) for each in times(sheet, loop, flown)]
    if script.pauses or script.markers:
        found, opening = scripted(found, script, sheet, opening)
    steps: list[LessonStep] = []
    clock = 0.0
    told = zip(telling(sheet), found, scene_numbers(sheet), strict=True)
    for (panel, index, chapter), each, scene in told:
        # Whole frames are counted from the start, so that roundings do not add up.
        parts = each.grow, each.hold, each.glide, each.settle
        clocks = list(accumulate(parts, initial=clock))
        ends = [round(each * fps) for each in clocks]
        lasts = (end - start for start, end in pairwise(ends))
        beats = tuple(round((clock + beat) * fps) - ends[0] for beat in each.beats)
        more: dict[str, Any] = {"beats": beats, "there": each.there}
        more |= {"chapter": chapter, "scene": scene}
        more["pencil"] = round((clock + each.pencil) * fps) - ends[0]
        more["sent"] = tuple(round(seconds * fps) for seconds in each.rate)
        steps.append(LessonStep(panel, index, *lasts, **more))
        clock = clocks[-1]
    said = answer(sheet)
    said_for = reading(said.pieces) + AFTER_ANSWER if said else 0.0
    moved = (SETTLE, GLIDE, SHEET) if is_staged(sheet) else (CLOSING, 0.0, 0.0)
    stands, glide, settle = (round(each / speed * fps) for each in moved)
    stands, last = max(stands, 1), round(max(sum(moved), said_for) / speed * fps)
    first, last = max(1, round(opening * fps)), max(last, stands + glide + bool(moved[-1]))
    settle = last - stands - glide if is_staged(sheet) else 0
    return Lesson(sheet, tuple(steps), first, last, fps, size, style, said, glide, settle, flown)


def _loop(sheet: Sheet, loop: object) -> int:
    """Return the number of a loop, after checking that a sheet has it."""
    count = max(len(panel.loops) for panel in sheet.panels)
    found = gate.index(loop)
    if found is None or not 1 <= found <= max(count, 1):
        hint = "this mechanism has one loop" if count < 2 else f"try 2, of its {count} loops"
        raise UsageError(f"loop: must be between 1 and {max(count, 1)}, got {quoted(loop)}", hint)
    return found


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
        step = self.lesson.steps[self.step - 1]
        if step.stroke.kind == "construction":
            return Moment(drawing(self.step - 1), AT_WORK, step.scene)
        return Moment(done(self.step), scene=step.scene)

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
    drawn = {
        half.full(stroke.name)
        for panel in panels
        for half in panel.halves
        for stroke in half.strokes
    }

    def known(half: Panel, row: Row) -> bool:
        found = measurer(sheet, half, row)
        return found is not None and found[0].full(found[1].name) in drawn

    rows = []
    for row in sheet.rows:
        cells = {
            panel.name: tuple(
                cell
                for half, measured in sheet.panel(panel.name).measures(row)
                for cell in measured
                if cell.given or known(half, row)
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
        Its number, from 1, over the whole lesson; ``"velocity:4"``, the fourth of a panel; or the
        name of its stroke, ``"velocity:BC.line"``.

    Raises
    ------
    vad.errors.UsageError
        If there is no such step.
    """
    if not isinstance(lesson, Lesson):
        raise UsageError(f"lesson: must be what vad.animate returns, got {quoted(lesson)}")
    return Still(lesson, step_number(lesson.sheet, step) + 1)
