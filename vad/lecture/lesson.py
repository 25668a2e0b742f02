"""When each stroke is drawn: a sheet laid out in time, as whole frames.

In comes a sheet, out goes a `Lesson`; how a frame looks is known only to `vad.plan`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from vad.displayed import Displayed
from vad.strokes.sheet import Panel, Sheet, Stroke


@dataclass(frozen=True, slots=True)
class Step:
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


@dataclass(frozen=True, slots=True)
class Lesson(Displayed):
    """A sheet that is drawn stroke by stroke.

    ``opening`` frames show the empty page, ``closing`` frames the finished one.
    """

    sheet: Sheet
    steps: tuple[Step, ...]
    opening: int
    closing: int
    fps: float
    size: tuple[int, int]
    style: str = "paper"

    @property
    def frames(self) -> int:
        """The number of frames."""
        return self.opening + self.closing + sum(step.frames for step in self.steps)

    @property
    def begun(self) -> int:
        """The number of strokes that are on the board before the first is drawn."""
        return next((i for i, step in enumerate(self.steps) if not step.there), len(self.steps))

    def place(self, step: Step) -> int:
        """Return the number of a step in its panel, from 1: those above it count."""
        column = self.sheet.panel(step.panel.column)
        return step.index + 1 + (0 if step.panel is column else len(column.strokes))

    @property
    def duration(self) -> float:
        """The running time in seconds."""
        return self.frames / self.fps
