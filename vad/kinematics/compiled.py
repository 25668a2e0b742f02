"""A program for many poses as one compiled loop, where numba is installed.

It does the same operations in the same order, and compilers may not join or reorder them: the bits
are those of the other ways.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.blocks import BLOCK
from vad.kinematics.operations import function_of

if TYPE_CHECKING:
    from vad.kinematics.program import Program

# Up to here an angle is folded without a remainder's loop.
LARGEST_ANGLE = 1e15


class Compiled:
    """The loop over all poses; made by `of`."""

    def __init__(self, program: Program, compile: Callable[..., Any]) -> None:
        inputs = [x.name for x in program.inputs]
        self._folded = [
            inputs.index(x.operands[0].name) for x in program.steps if x.operation == "fold"
        ]
        results = [f"result_{number}" for number in range(len(program.outputs))]
        body = [
            *(f"{name} = many_{name}[i]" for name in inputs),
            *program.lines,
            *(f"{name}[i] = {x}" for name, x in zip(results, program.outputs, strict=True)),
        ]
        names = {
            "remainder": compile(_remainder),
            "sqrt": math.sqrt,
            "copysign": math.copysign,
            "nan": math.nan,
        }
        lines = ["for i in range(len(result_0)):", *(f"    {line}" for line in body)]
        self._loop = compile(function_of([*(f"many_{x}" for x in inputs), *results], lines, names))

    @classmethod
    def of(cls, program: Program) -> Compiled | None:
        """Return a program's loop; None without numba, or if it needs numpy's own arc tangent."""
        try:
            import numba  # type: ignore[import-not-found,import-untyped,unused-ignore]
        except ImportError:
            return None
        if any(step.operation == "arctan2" for step in program.steps):
            return None
        return cls(program, numba.njit(error_model="numpy"))

    def knows(self, inputs: Sequence[NDArray[Any] | float]) -> bool:
        """Tell whether all angles are so small that they can be folded."""
        largest = (np.fmax.reduce(np.abs(inputs[i]), axis=None) for i in self._folded)
        return not any(angle > LARGEST_ANGLE for angle in largest)

    def play(self, inputs: Sequence[NDArray[Any] | float], outputs: Sequence[NDArray[Any]]) -> None:
        """Write the outputs, block by block."""
        size = len(outputs[0])
        for start in range(0, size, BLOCK):
            part = slice(start, min(start + BLOCK, size))
            self._loop(
                *(
                    x[part] if isinstance(x, np.ndarray) else np.full(part.stop - start, x)
                    for x in inputs
                ),
                *(x[part] for x in outputs),
            )


def _remainder(degrees: float, turn: float) -> float:
    """Return what `math.remainder` does, of an angle within `LARGEST_ANGLE`."""
    folded = degrees - turn * np.rint(degrees / turn)
    return folded - math.copysign(turn, folded) if abs(folded) > 0.5 * turn else folded
