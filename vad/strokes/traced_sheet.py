"""A sheet whose numbers know how they follow from its inputs.

One pose is drawn with traced numbers (`vad.kinematics.traced`).  Each coordinate of its strokes and
each value of its table is then an output of a program, which finds it for any other pose, and for
other dimensions: a page plays this program while its reader turns the crank.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from vad.kinematics.motion import Motion, MotionInSpace
from vad.kinematics.program import Program, needed
from vad.kinematics.reach import slide_travels
from vad.kinematics.recording import Recorded
from vad.kinematics.solver import Solver
from vad.kinematics.traced import Guard, Traced, TracedTape, made_of
from vad.strokes.draw import NO_PINS, chosen, parted, scene_of, sheet_of, with_forces
from vad.strokes.sheet import Sheet
from vad.strokes.traced_dimensions import traced_dimensions, traced_motion
from vad.words import Language

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism
    from vad.statics.burden import Burden
    from vad.strokes.draw import AnyScene


@dataclass(frozen=True)
class TracedSheet:
    """A sheet of one pose with traced numbers.

    Attributes
    ----------
    sheet
        The sheet.  What is drawn of a mechanism and of its vectors is traced; of a lesson's
        captions, of the tools of a construction and of how far a slide travels the numbers of this
        one pose remain.
    inputs
        The traced inputs, by name: first those of the driver, then the dimensions.
    tape
        The record.
    scene
        The motion that is drawn, and the forces in it: their results are traced, too.
    guards
        The program is right for other dimensions if each of these decisions is made alike.
    """

    sheet: Sheet
    inputs: dict[str, Traced]
    tape: TracedTape
    scene: AnyScene
    guards: tuple[Guard, ...] = ()

    @property
    def motion(self) -> Any:
        """The motion that is drawn."""
        return self.scene.motion

    @property
    def forces(self) -> Any:
        """The forces in it; None without any."""
        return self.scene.forces

    def input(self, name: str, value: float) -> Traced:
        """Add an input, for what follows from the sheet and from something else."""
        self.inputs[name] = Traced.input(self.tape, f"i{len(self.inputs)}", value)
        return self.inputs[name]

    def moves(self, number: float) -> bool:
        """Tell whether a number follows from the motion of the driver."""
        made = made_of(number)
        if not isinstance(made, Recorded):
            return False
        driver = {self.inputs[name].made.name for name in self.motion.inputs}
        return any(step.name in driver for step in needed([], [made]))

    def program(self, numbers: Iterable[float]) -> Program:
        """Return the program from the inputs to some numbers of the sheet, in their order.

        The columns of its table are these numbers.  Before them come the truth values of the
        guards.
        """
        outputs = [made_of(number) for number in numbers]
        made: list[Any] = [given.made for given in self.inputs.values()]
        return Program(made, [*(guard.made for guard in self.guards), *outputs], len(outputs))


def nothing_held(inputs: Mapping[str, Traced]) -> Mapping[str, Any]:
    """Return nothing: all that a pose shows is its own."""
    return {}


def traced_sheet(
    mechanism: Mechanism,
    inputs: Mapping[str, float],
    panels: Sequence[str] | None = None,
    language: str = "en",
    dimensions: Sequence[str] = (),
    burden: Burden | None = None,
    held: Callable[[Mapping[str, Traced]], Mapping[str, Any]] = nothing_held,
    pins: Mapping[str, Any] = NO_PINS,
) -> TracedSheet:
    """Return the sheet of a pose with numbers that follow from the driver and from dimensions.

    Parameters
    ----------
    mechanism
        The mechanism.
    inputs
        All inputs of `vad.solve`, by name.  Where a rate is zero, vectors vanish, and how they
        follow from it is not known: choose rates that are not.
    panels, language
        As for `vad.draw`.
    dimensions
        The names of those dimensions of a mechanism in the plane that are traced, of all that
        ``mechanism.dimensions()`` has.  One of which the code of the mechanism makes a constant is
        not among the inputs of what is returned.  In the sheet a dimension may differ from that of
        the mechanism in its last digits.
    burden
        What the mechanism bears beside its own, if there are forces.
    held
        The function from the traced inputs to what is the same over a whole turn, by its name in a
        scene: the poles of the force polygons, and the largest force on the driven body.
    pins
        The diameters of pins by their points, which are the same for all dimensions.

    Raises
    ------
    vad.errors.VadError
        For a pose that cannot be drawn.
    """
    traced = (
        traced_dimensions(mechanism, inputs, dimensions)
        if dimensions
        else traced_motion(mechanism, inputs)
    )
    solver: Any = traced.solver
    kind = Motion if isinstance(solver, Solver) else MotionInSpace
    motion = kind(traced.mechanism, solver, dict(traced.inputs))
    if solver.slides:
        motion.travels = slide_travels(mechanism)
    given = {**traced.inputs, **traced.sizes}
    _, forces = parted(with_forces(motion, burden))
    scene = scene_of(motion, Language(language), forces, **held(traced.inputs), pins=pins)
    sheet = sheet_of(scene, chosen(panels, motion, forces))
    return TracedSheet(sheet, given, traced.tape, scene, traced.guards)
