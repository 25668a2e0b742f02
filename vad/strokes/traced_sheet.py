"""A sheet whose numbers know how they follow from its inputs.

One pose is drawn with traced numbers (`vad.kinematics.traced`).  Each coordinate of its strokes and
each value of its table is then an output of a program, which finds it for any other pose: a page
plays this program while its reader turns the crank.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from vad.kinematics.motion import Motion, MotionInSpace
from vad.kinematics.program import Program
from vad.kinematics.recording import Tape
from vad.kinematics.solver import Solver, solver_of
from vad.kinematics.traced import Traced, made_of
from vad.strokes.draw import draw
from vad.strokes.sheet import Sheet

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism


@dataclass(frozen=True)
class TracedSheet:
    """A sheet of one pose with traced numbers.

    Attributes
    ----------
    sheet
        The sheet.  What is drawn of a mechanism and of its vectors is traced; of a lesson's
        captions and of the tools of a construction the numbers of this one pose remain.
    inputs
        The traced inputs, by name.
    """

    sheet: Sheet
    inputs: dict[str, Traced]
    tape: Tape

    def input(self, name: str, value: float) -> Traced:
        """Add an input, for what follows from the sheet and from something else."""
        self.inputs[name] = Traced.input(self.tape, f"i{len(self.inputs)}", value)
        return self.inputs[name]

    def program(self, numbers: Iterable[float]) -> Program:
        """Return the program from the inputs to some numbers of the sheet, in their order."""
        outputs = [made_of(number) for number in numbers]
        made: list[Any] = [given.made for given in self.inputs.values()]
        return Program(made, outputs, len(outputs))


def traced_sheet(
    mechanism: Mechanism,
    inputs: Mapping[str, float],
    panels: Sequence[str] | None = None,
    language: str = "en",
) -> TracedSheet:
    """Return the sheet of a pose with numbers that follow from the motion of the driver.

    Parameters
    ----------
    mechanism
        The mechanism.
    inputs
        All inputs of `vad.solve`, by name.  Where a rate is zero, vectors vanish, and how they
        follow from it is not known: choose rates that are not.
    panels, language
        As for `vad.draw`.

    Raises
    ------
    vad.errors.VadError
        For a pose that cannot be drawn.
    """
    tape = Tape()
    given = {
        name: Traced.input(tape, f"i{number}", value)
        for number, (name, value) in enumerate(inputs.items())
    }
    # A solver of its own: the usual one answers from what it has calculated before.
    solver: Any = solver_of.__wrapped__(mechanism)
    kind = Motion if isinstance(solver, Solver) else MotionInSpace
    return TracedSheet(draw(kind(mechanism, solver, dict(given)), panels, language), given, tape)
