"""The kinds of loops, by what is unknown in them."""

from __future__ import annotations

from vad.kinematics.closing.loop import LoopSolver
from vad.kinematics.closing.parallelogram import ParallelLoop
from vad.kinematics.closing.sliding import AngleAndLengthLoop, SlotLoop, TwoLengthsLoop
from vad.kinematics.closing.two_bars import StrutLoop, TwoAnglesLoop
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Loop, Scalar, length_of, scalar_of


def loop_solver(
    frame: ReferenceFrame, side: float, loop: Loop, unknowns: tuple[Scalar, ...]
) -> LoopSolver:
    """Return the solver of a loop, by what is unknown in it."""
    steps = {scalar_of(step): step for _, step in loop.steps() if scalar_of(step) in unknowns}
    bars = [step for step in steps.values() if isinstance(step, Bar)]
    lengths = {length_of(bar.length) for bar in bars if isinstance(bar.length, str)}
    kind: type[LoopSolver]
    if len(bars) == 2:
        strut = frame.linkage.driver in lengths
        kind = StrutLoop if strut else ParallelLoop if loop.parallel else TwoAnglesLoop
    elif not bars:
        kind = TwoLengthsLoop
    else:
        kind = SlotLoop if lengths & set(unknowns) else AngleAndLengthLoop
    return kind(frame, side, loop, unknowns)
