"""A recorded calculation, without what nobody asked for, and three ways to run it.

One pose is calculated by a Python function.  Many poses are calculated by numpy, on blocks that
stay in the cache of the processor: straight through arrays of a million poses every intermediate
result would travel to memory and back.  Where numba is installed, very many poses are calculated
by one compiled loop.  All three do the same operations in the same order and give the same bits.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.recording import OPERATIONS, Operand, Recorded, function_of, key_of

Array = NDArray[Any]
# An operation, the places of its operands, and the place of its result.
Move = tuple[str, list[int], int]

BLOCK = 8192  # poses
# From this number of poses on it pays to write the moves as the text of a function.
LONG = 30 * BLOCK
# Up to here an angle can be folded without the loop that a remainder needs.
LARGEST_ANGLE = 1e15

# To compile a program takes about as long as numpy needs for so many poses.
OFTEN = 10_000_000


class Program:
    """The operations that lead from some recorded numbers to others.

    Parameters
    ----------
    inputs
        What is given.
    outputs
        What is wanted: recorded numbers, or floats that are the same in every pose.

    Attributes
    ----------
    steps
        The recorded numbers that are needed between them, each after its operands.
    """

    def __init__(self, inputs: Sequence[Recorded], outputs: Sequence[Operand]) -> None:
        self.inputs = inputs
        self.outputs = outputs
        self.steps = _needed(inputs, outputs)
        self._played = 0

    @cached_property
    def one(self) -> Callable[..., tuple[float, ...]]:
        """The function from the inputs of one pose to its outputs, without a branch or a loop."""
        lines = [f"return ({''.join(f'{x}, ' for x in self.outputs)})"]
        names = vars(math) | {"arctan2": np.arctan2}
        return function_of([x.name for x in self.inputs], self.lines + lines, names)

    @property
    def lines(self) -> list[str]:
        """Every step as a line of Python."""
        texts = (OPERATIONS[x.operation].text.format(*x.operands) for x in self.steps)
        return [f"{x.name} = {text}" for x, text in zip(self.steps, texts, strict=True)]

    def play(self, inputs: Sequence[Array | float], outputs: Sequence[Array]) -> None:
        """Write the outputs of many poses; an input that is the same in all may be a float."""
        self._played += len(outputs[0])
        compiled = self.compiled if self._played > OFTEN else None
        if compiled and compiled.knows(inputs):
            compiled.play(inputs, outputs)
        else:
            self.blocks.play(inputs, outputs)

    def many(self, inputs: Sequence[Array | float], size: int) -> list[Array]:
        """Return the outputs of many poses in new arrays; all outputs must be recorded numbers."""
        kinds = (OPERATIONS[x.operation].kind for x in self.outputs)
        outputs: list[Array] = [np.empty(size, kind) for kind in kinds]
        if outputs:
            self.play(inputs, outputs)
        return outputs

    @cached_property
    def blocks(self) -> Blocks:
        """The program for numpy, block by block."""
        return Blocks(self)

    @cached_property
    def compiled(self) -> Compiled | None:
        """The program as one compiled loop; None where it cannot be compiled."""
        return Compiled.of(self)


def _needed(inputs: Sequence[Recorded], outputs: Sequence[Operand]) -> list[Recorded]:
    """Return the recorded numbers between inputs and outputs, each after its operands."""
    done = {number.name for number in inputs}
    steps: list[Recorded] = []
    waiting = [number for number in reversed(outputs) if isinstance(number, Recorded)]
    while waiting:
        number = waiting[-1]
        missing = [x for x in number.operands if isinstance(x, Recorded) and x.name not in done]
        if number.name in done:
            waiting.pop()
        elif missing:
            waiting += missing
        else:
            done.add(waiting.pop().name)
            steps.append(number)
    return steps


class Blocks:
    """A program for numpy: its operations, and the rows of memory in which it writes.

    Every number of a block has a place.  First come the places of inputs, constants and outputs,
    then those of the rows.  A number that is no longer needed leaves its row to another one: the
    fewer rows there are, the more of them stay in the cache.
    """

    def __init__(self, program: Program) -> None:
        inputs, outputs, steps = program.inputs, program.outputs, program.steps
        operands = [x for step in steps for x in step.operands] + list(outputs)
        constants = list({key_of(x): x for x in operands if not isinstance(x, Recorded)}.values())
        self._constants = [np.array(x) for x in constants]
        self._kinds: list[type] = []
        self._free: dict[type, list[int]] = defaultdict(list)
        standing = [key_of(x) for x in (*inputs, *constants, *outputs)]
        self._first_row = len(standing)
        self._place: dict[str, int] = {}
        for place, key in enumerate(standing):
            self._place.setdefault(key, place)
        self._moves = self._arranged(steps)
        for place, key in enumerate(standing):  # an output may be an input or a constant
            if self._place[key] != place:
                self._moves.append(("copy", [self._place[key]], place))

    def play(self, inputs: Sequence[NDArray[Any] | float], outputs: Sequence[NDArray[Any]]) -> None:
        """Write the outputs, block by block."""
        size = len(outputs[0])
        play = self._play_fast if size > LONG else self._play_block
        rows: list[NDArray[Any]] = [np.empty(min(size, BLOCK), kind) for kind in self._kinds]
        with np.errstate(all="ignore"):  # a result that does not exist is NaN
            for start in range(0, size, BLOCK):
                part = slice(start, min(start + BLOCK, size))
                play(
                    *(x[part] if isinstance(x, np.ndarray) else x for x in inputs),
                    *self._constants,
                    *(x[part] for x in outputs),
                    *(row[: part.stop - part.start] for row in rows),
                )

    def _play_block(self, *cells: NDArray[Any] | float) -> None:
        for operation, places, place in self._moves:
            OPERATIONS[operation].on_blocks(*[cells[i] for i in places], out=cells[place])

    @cached_property
    def _play_fast(self) -> Callable[..., None]:
        """A function that does what `_play_block` does, one line for each operation."""
        names = [f"c{place}" for place in range(self._first_row + len(self._kinds))]
        lines = [
            f"{operation}({', '.join(names[i] for i in places)}, out={names[place]})"
            for operation, places, place in self._moves
        ]
        operations = {name: operation.on_blocks for name, operation in OPERATIONS.items()}
        return function_of(names, lines or ["pass"], operations)

    def _arranged(self, steps: list[Recorded]) -> list[Move]:
        """Return every step as a move, and give each number its place."""
        last = {key_of(x): step for step in steps for x in step.operands}
        moves: list[Move] = []
        for step in steps:
            places = [self._place[key_of(x)] for x in step.operands]
            pairs = zip(step.operands, places, strict=True)
            done = {place for x, place in pairs if last[key_of(x)] is step}
            early = done - {places[number] for number in OPERATIONS[step.operation].kept}
            self._leave(early)
            if step.name not in self._place:
                self._place[step.name] = self._row(OPERATIONS[step.operation].kind)
            self._leave(done - early)
            moves.append((step.operation, places, self._place[step.name]))
        return moves

    def _leave(self, places: set[int]) -> None:
        for place in places:
            if place >= self._first_row:
                self._free[self._kinds[place - self._first_row]].append(place)

    def _row(self, kind: type) -> int:
        if not self._free[kind]:
            self._free[kind].append(self._first_row + len(self._kinds))
            self._kinds.append(kind)
        return self._free[kind].pop()


class Compiled:
    """A program as one compiled loop over all poses; made by `of`.

    Compilers may not join or reorder its operations, so that the bits are the same.
    """

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
        """Return the loop of a program; None without numba, or if it has an arc tangent.

        The last bit of an arc tangent of numpy is not that of compiled code.
        """
        try:
            import numba  # type: ignore[import-not-found,import-untyped,unused-ignore]
        except ImportError:
            return None
        if any(step.operation == "arctan2" for step in program.steps):
            return None
        return cls(program, numba.njit(error_model="numpy"))

    def knows(self, inputs: Sequence[NDArray[Any] | float]) -> bool:
        """Tell whether all angles are small enough to be folded in compiled code."""
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
    """Return the same as `math.remainder`, for an angle within `LARGEST_ANGLE`."""
    folded = degrees - turn * np.rint(degrees / turn)
    return folded - math.copysign(turn, folded) if abs(folded) > 0.5 * turn else folded
