"""A full turn of the driver, pose by pose; the polygons change with the pose.

A `Turn` is made from a mechanism or a pose, in whole frames; each frame is a sheet of `draw`.  The
solver is imported only when a turn is made, because `vad.save` needs the class alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from vad.displayed import Displayed
from vad.errors import DeadCentreError
from vad.lecture.lesson import checked
from vad.strokes.sheet import Sheet

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.lecture.cycle import Course, Cycle
    from vad.lecture.followed import Followed
    from vad.mechanisms.mechanism import Mechanism
    from vad.statics.burden import Burden
    from vad.statics.forces import Forces
    from vad.strokes.draw import AnyScene

SECONDS = 8.0
#: A pose that has no rates is replaced by the one at this phase later: 1.6 ms of the 8 s of a turn.
_LATER = 2e-4


@dataclass(frozen=True, slots=True, repr=False)
class Turn(Displayed):
    """One turn as a film that begins again where it ends.

    With a ``burden`` its sheets have forces, too, whose polygons keep their ``poles``; the arrows
    on the driven body are measured by the ``largest`` force on it.  With centres they have the
    centrodes of a body, which ``centrode`` names.  A title and a subtitle of one's own are
    ``titles``.  Its polygons show the vectors of the point
    that is ``followed`` alone; if that is a foot, share 0 of its cycle is where it touches down.
    """

    mechanism: Mechanism
    course: Course
    frames: int
    fps: float
    size: tuple[int, int]
    style: str
    panels: tuple[str, ...]
    language: str
    burden: Burden | None = None
    poles: Mapping[int, complex] = field(default_factory=dict)
    largest: float = 0.0
    centrode: str | None = None
    titles: Mapping[str, Any] = field(default_factory=dict)
    followed: Followed | None = None

    def __repr__(self) -> str:
        """Return a line: what turns, and how long that takes."""
        width, height = self.size
        film = f"{self.duration:.1f} s, {self.fps:g} frames per second, {width}x{height}"
        return f"<Turn of {self.mechanism.name}: {film}>"

    @property
    def duration(self) -> float:
        """The running time in seconds."""
        return self.frames / self.fps

    @property
    def sheet(self) -> Sheet:
        """The sheet of the first frame."""
        return self.pose(0)

    @property
    def given(self) -> Sheet:
        """The sheet of the pose that was given, with its rates."""
        from vad.strokes.draw import draw

        inputs: dict[str, Any] = dict(zip(self.course.names, self.course.given, strict=True))
        more: dict[str, Any] = {"centrode": self.centrode, **self.titles}
        return draw(self._solved(inputs), self.panels, self.language, **more)

    @property
    def cycle(self) -> Cycle:
        """The whole turn solved at once: the paths of its points, and the motion of its output."""
        from vad.lecture.cycle import cycle_of

        return cycle_of(self, _LATER)

    @property
    def opening(self) -> float:
        """The phase of share 0: where the driver passes 0°, or a foot touches down."""
        stance = self.followed.stance if self.followed else None
        return (self.course.opening + (stance.touch_down if stance else 0.0)) % 1.0

    def share(self, frame: int) -> float:
        """Return the share of the cycle at a frame."""
        return (frame / self.frames - self.opening) % 1.0

    def pose(self, frame: int) -> Sheet:
        """Return the sheet of one frame."""
        return self.at(frame / self.frames)

    def at(self, phase: float) -> Sheet:
        """Return the sheet at a phase of the turn, 0 to 1.

        A swing keeps away from its dead centres, but a crank that goes round can stand exactly at
        one: a parallelogram that folds flat, a crank as long as its rod at 90°, a pin on the
        lever's pivot.  As it does so for an instant only, the pose a very short time later is drawn
        instead.

        Raises
        ------
        vad.errors.DeadCentreError
            If that pose has no rates either.
        """
        try:
            return self._draw(phase)
        except DeadCentreError:
            return self._draw(phase + _LATER)

    def scene(self, inputs: Mapping[str, Any]) -> AnyScene:
        """Return the scene of one motion of the driver, or of arrays of them."""
        from vad.strokes.draw import parted, scene_of
        from vad.words import Language

        motion, forces = parted(self._solved(inputs))
        at: dict[str, Any] = {"poles": self.poles, "largest": self.largest}
        return scene_of(motion, Language(self.language), forces, **at, centrode=self.centrode)

    def _solved(self, inputs: Mapping[str, Any]) -> Any:
        """Return a motion, or the forces in it."""
        from vad.kinematics.motion import solve
        from vad.strokes.draw import with_forces

        return with_forces(solve(self.mechanism, **inputs), self.burden)

    def _draw(self, phase: float) -> Sheet:
        from vad.strokes.draw import sheet_of

        sheet = sheet_of(self.scene(self.course.inputs(phase)), self.panels)
        sheet = replace(sheet, **self.titles)
        sheet = self.followed.shown(sheet) if self.followed else sheet
        if self.course.swing is None:
            return sheet
        # The rates of a swinging driver are the given ones at one instant only.
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
        return replace(sheet, rows=rows, driver=replace(sheet.driver, rate=0.0))


def turn(
    mechanism: Mechanism | Motion | Forces[Any, Any, Any],
    fps: float = 30,
    size: tuple[int, int] = (1280, 720),
    speed: float = 1.0,
    style: str = "paper",
    panels: Sequence[str] | str | None = None,
    language: str = "en",
    centrode: str | None = None,
    title: str | None = None,
    subtitle: str | None = None,
    follow: str | None = None,
) -> Turn:
    """Return the film in which a mechanism runs through a full turn of its crank.

    The turn begins with the pose that is given.  A driver that cannot go round, as a slide or the
    crank of a double rocker, swings to and fro between its dead centres, and passes the given
    place at the given rate.

    Parameters
    ----------
    mechanism
        A mechanism, which moves as is usual for it, one pose of `vad.solve`, or the forces in one,
        whose loads and masses act all through the turn.
    fps
        Frames per second, 1 to 240.
    size
        Width and height in pixels, 320×240 to 7680×4320.
    speed
        Divides the time of 8 s that a turn takes.
    style
        The name of a style.
    panels
        As for `vad.draw`; the usual ones if None.
    language
        The language of the words on the page, as a two-letter code.
    centrode
        The body whose centrodes the panel "centres" shows, as for `vad.draw`; that of the coupler
        or the connecting rod if None.
    title, subtitle
        As for `vad.draw`.
    follow
        The point whose path, velocity and acceleration are shown instead of those of all points;
        "all" for all of them.  If it is None, the point that the mechanism's file names, or the
        foot of a leg.

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
    from vad.lecture.cycle import course, whole_turn
    from vad.lecture.followed import followed
    from vad.lecture.poles import largest_on_driver, poles_of
    from vad.strokes.centrodes import centrode_of
    from vad.strokes.draw import chosen, started, turning
    from vad.strokes.titling import own_titles
    from vad.words import Language

    titles = own_titles(title, subtitle)
    fps, size, speed = checked(fps, size, speed, style)
    motion, forces = started(mechanism, "a turn begins with one pose")
    if motion.mechanism.is_rotor:
        panels = turning(panels, motion)
    names = chosen(panels, motion, forces)
    rolls = centrode_of(motion, centrode, names)
    Language(language)
    bare = Turn(
        motion.mechanism,
        course(motion),
        max(2, round(SECONDS / speed * fps)),
        fps,
        size,
        style,
        names,
        language,
        forces.burden if forces else None,
        centrode=rolls,
        titles=titles,
    )
    made = replace(bare, followed=followed(bare, follow))
    found = whole_turn(made).forces if forces else None
    if not found:
        return made
    return replace(made, poles=poles_of(found), largest=largest_on_driver(found))
