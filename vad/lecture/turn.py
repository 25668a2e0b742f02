"""A full turn of the driver, pose by pose, while the polygons live with it.

In comes a mechanism or a pose, out goes a `Turn` in whole frames; each frame is a sheet of `draw`.
The solver is loaded when a turn is made: to know that turns can be saved takes no numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from vad.errors import DeadCentreError, InputError
from vad.lecture.timeline import check
from vad.strokes.sheet import PANELS, Sheet

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.lecture.course import Course
    from vad.mechanisms.mechanism import Mechanism

SECONDS = 8.0
#: Phases at which no vector of a usual mechanism happens to vanish.
_GENERIC = (0.0137, 0.1571, 0.2963, 0.4289, 0.5711, 0.6947, 0.8311, 0.9613)
#: Where a vector vanishes for an instant, a pose so much later is shown in its place.
_ASIDE = (0.0, 2e-4, -2e-4, 1e-3)


@dataclass(frozen=True, slots=True)
class Turn:
    """One turn as a film that begins again where it ends.

    ``whole`` is the number of strokes of each panel when no vector vanishes.
    """

    mechanism: Mechanism
    course: Course
    frames: int
    fps: float
    size: tuple[int, int]
    style: str
    panels: tuple[str, ...]
    language: str
    whole: tuple[int, ...] = ()

    @property
    def duration(self) -> float:
        """The running time in seconds."""
        return self.frames / self.fps

    @property
    def sheet(self) -> Sheet:
        """The sheet of the first frame."""
        return self.pose(0)

    def pose(self, frame: int) -> Sheet:
        """Return the sheet of one frame."""
        return self.at(frame / self.frames)

    def at(self, phase: float) -> Sheet:
        """Return the sheet at a phase of the turn, 0 to 1.

        A vector that vanishes takes letters with it; as it does so for an instant only, the
        nearest pose with all of them is drawn instead, which the eye cannot tell apart.

        Raises
        ------
        vad.errors.DeadCentreError
            If this pose and those beside it have no rates.
        """
        found: list[Sheet] = []
        for aside in _ASIDE:
            try:
                sheet = self._draw(phase + aside)
            except DeadCentreError:
                if aside == _ASIDE[-1] and not found:
                    raise
                continue
            if all(n >= most for n, most in zip(_counts(sheet), self.whole, strict=False)):
                return sheet
            found.append(sheet)
        return found[0]

    def _draw(self, phase: float) -> Sheet:
        from vad.kinematics.motion import solve
        from vad.strokes.draw import draw

        motion = solve(self.mechanism, **self.course.inputs(phase))
        sheet = draw(motion, self.panels, self.language)
        if self.course.swing is None:
            return sheet
        # What a driver does that swings is not as given, but for one instant.
        rows = tuple(
            replace(
                row,
                cells={
                    name: tuple(replace(cell, given=False) for cell in cells)
                    for name, cells in row.cells.items()
                },
            )
            for row in sheet.rows
        )
        return replace(sheet, rows=rows)


def turn(
    mechanism: Mechanism | Motion,
    fps: float = 30,
    size: tuple[int, int] = (1280, 720),
    speed: float = 1.0,
    style: str = "paper",
    panels: Sequence[str] | str = PANELS,
    language: str = "en",
) -> Turn:
    """Return the film in which a mechanism runs through a full turn of its crank.

    The turn begins with the pose that is given.  A driver that cannot go round, as a slide or the
    crank of a double rocker, swings to and fro between its dead centres, and passes the given
    place at the given rate.

    Parameters
    ----------
    mechanism
        A mechanism, which moves as is usual for it, or one pose of `vad.solve`.
    fps
        Frames per second, 1 to 240.
    size
        Width and height in pixels, 320×240 to 7680×4320.
    speed
        Divides the time of 8 s that a turn takes.
    style
        The name of a style.
    panels
        Which of "position", "velocity" and "acceleration".
    language
        The language of the words on the page, as a two-letter code.

    Raises
    ------
    vad.errors.UsageError
        If a value is out of its range, or unknown.
    vad.errors.InputError
        For a motion of many poses.
    vad.errors.AssemblyError
        If the links close nowhere.

    Examples
    --------
    >>> import vad
    >>> film = vad.turn(vad.FourBar(), fps=25)
    >>> film.frames, film.duration
    (200, 8.0)
    """
    from vad.kinematics.motion import Motion, solve
    from vad.lecture.course import course

    check(fps, size, speed)
    motion = mechanism if isinstance(mechanism, Motion) else solve(mechanism)
    if motion.many:
        raise InputError("motion: a turn begins with one pose, got arrays of poses")
    names = (panels,) if isinstance(panels, str) else tuple(panels)
    frames = max(2, round(SECONDS / speed * fps))
    film = Turn(
        motion.mechanism,
        course(motion),
        frames,
        fps,
        (size[0], size[1]),
        style,
        names,
        language,
    )
    counts = [_counts(film.at(phase)) for phase in _GENERIC]
    return replace(film, whole=tuple(map(max, zip(*counts, strict=True))))


def _counts(sheet: Sheet) -> tuple[int, ...]:
    return tuple(len(panel.strokes) for panel in sheet.panels)
