"""A recorded calculation, without what nobody asked for, and the ways to run it on many poses.

numpy works on blocks that stay in the cache of the processor: straight through arrays of a million
poses every intermediate result would travel to memory and back.  Where llvmlite is installed, very
many poses are calculated by a compiled loop (`vad.kinematics.compiled`).  Both do the same
operations in the same order as `Program.one` does for one pose, and give the same bits.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.recording import (
    OPERATIONS,
    Operand,
    Recorded,
    function_of,
    key_of,
    kind_of,
)

if TYPE_CHECKING:
    from vad.kinematics.compiled import Compiled
    from vad.kinematics.threads import Work

Array = NDArray[Any]
# An operation, the places of its operands, and the place of its result.
Move = tuple[str, list[int], int]

# Poses: in shorter blocks the calls of numpy take longer than the arithmetic, and longer ones leave
# the cache.
BLOCK = 12_288
# From this number of poses on it pays to write the moves as the text of a function.
LONG = 20 * BLOCK
CACHE_LINE = 64  # bytes, or a part of one; and the size of the largest vector registers

# From this number of poses on it pays to compile a program.  Of the four results of a four-bar,
# loading the compiler takes 20 ms and compiling 17 ms; a pose then takes 26 ns less than by numpy.
# Both grow with the program.
OFTEN = 1_500_000
# A compiled loop calculates so many poses at a time: twice what the largest registers hold, so that
# no operation waits for the one before it.
LANES = 16


def _nothing(part: slice) -> None:
    """Do nothing with a block that is finished."""


class Program:
    """The operations that lead from some recorded numbers to others.

    Parameters
    ----------
    inputs
        What is given.
    outputs
        What is wanted: recorded numbers, or floats that are the same in every pose.
    columns
        How many of the outputs, the last ones, are the columns of one table.

    Attributes
    ----------
    steps
        The recorded numbers that are needed between them, each after its operands.
    """

    def __init__(
        self, inputs: Sequence[Recorded], outputs: Sequence[Operand], columns: int = 0
    ) -> None:
        self.inputs = inputs
        self.outputs = outputs
        self.columns = columns
        self.steps = needed(inputs, outputs)
        self._played = 0
        self._blocks: dict[tuple[bool, ...], Blocks] = {}
        self._compiled: dict[tuple[bool, ...], Compiled | None] = {}

    def listing(self) -> dict[str, Any]:
        """Return the program as data that JSON can hold, for a player in another language.

        Returns
        -------
        dict
            ``inputs``: their names.  ``operations``: for each its name, what it does (a key of
            `vad.kinematics.recording.OPERATIONS`), and its operands, in an order in which they can
            be done.  ``outputs``.  An operand or an output is a name, a truth value, a number, a
            list of numbers to choose from, or None, which stands for NaN.

        Examples
        --------
        >>> from vad.kinematics.recording import Tape
        >>> x = Tape().input("x")
        >>> Program([x], [2.0 * x + 1.0]).listing()["operations"]
        [['t0', 'multiply', 'x', 2.0], ['t1', 'add', 't0', 1.0]]
        """
        return {
            "inputs": [number.name for number in self.inputs],
            "operations": [
                [step.name, step.operation, *map(_listed, step.operands)] for step in self.steps
            ],
            "outputs": [_listed(output) for output in self.outputs],
        }

    @property
    def kept(self) -> Sequence[Operand]:
        """The outputs that are no columns of the table."""
        return self.outputs[: len(self.outputs) - self.columns]

    def arrays(self, size: int) -> list[Array]:
        """Return new arrays for the outputs that are no columns of the table.

        All numbers are in one piece of memory: the system gives it in fewer and larger pages.
        """
        kinds = [*map(kind_of, self.kept)]
        count, width = kinds.count(float), size + -size % (CACHE_LINE // 8)
        rows = iter(aligned(count * width).reshape(count, width))
        return [next(rows)[:size] if kind is float else np.empty(size, kind) for kind in kinds]

    def play(
        self,
        inputs: Sequence[Array | float],
        outputs: Sequence[Array],
        finish: Callable[[slice], None] = _nothing,
    ) -> None:
        """Write the outputs of many poses; an input that is the same in all may be a float.

        Each block of poses that is written is given to ``finish``.
        """
        if not outputs:
            return
        self._played += len(outputs[0])
        many = tuple(isinstance(x, np.ndarray) for x in inputs)
        if self._played > OFTEN and len(outputs[0]) >= LANES:
            loop = self._compiled_for(many)
            if loop:
                loop.play(inputs, outputs, finish)
                return
        self._blocks_for(many).play(inputs, outputs, finish)

    def many(self, inputs: Sequence[Array | float], size: int) -> list[Array]:
        """Return the outputs of many poses in new arrays."""
        table = np.empty((size, self.columns))
        outputs = [*self.arrays(size), *table.T]
        self.play(inputs, outputs)
        return outputs

    def _blocks_for(self, many: tuple[bool, ...]) -> Blocks:
        if many not in self._blocks:
            self._blocks[many] = Blocks(self, many)
        return self._blocks[many]

    def _compiled_for(self, many: tuple[bool, ...]) -> Compiled | None:
        if many not in self._compiled:
            from vad.kinematics.compiled import compiled  # short sweeps do not need it

            parts = self.inputs, self.steps, self.outputs, self.columns
            self._compiled[many] = compiled(*parts, many)
        return self._compiled[many]


def _listed(operand: Operand) -> Any:
    if isinstance(operand, Recorded):
        return operand.name
    if isinstance(operand, tuple):
        return list(map(_listed, operand))
    return None if operand != operand else operand


def needed(inputs: Sequence[Recorded], outputs: Sequence[Operand]) -> list[Recorded]:
    """Return the recorded numbers between inputs and outputs, each after its operands."""
    done = {number.name for number in inputs}
    steps: list[Recorded] = []
    waiting = [number for number in reversed(outputs) if isinstance(number, Recorded)]
    # Each round ends a number, or goes on to one that was recorded before it.
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
    """A program for numpy: its operations, and the memory in which it writes.

    Every number has a place.  First come the places of inputs, of constants, of numbers that are
    the same in all poses, and of outputs, then those of rows, each with a number of every pose of a
    block.  A number that is no longer needed leaves its row to another one: the fewer rows
    there are, the more of them stay in the cache.

    Parameters
    ----------
    program
        The program.
    many
        For each input whether it differs from pose to pose.
    """

    def __init__(self, program: Program, many: Sequence[bool]) -> None:
        inputs, outputs, steps = program.inputs, program.outputs, program.steps
        operands = [x for step in steps for x in step.operands] + list(outputs)
        constants = list({key_of(x): x for x in operands if not isinstance(x, Recorded)}.values())
        self._constants = [np.array(x) for x in constants]
        single = {x.name for x, each in zip(inputs, many, strict=True) if not each}
        single |= {key_of(x) for x in constants}
        once = []
        for step in steps:
            if single.issuperset(map(key_of, step.operands)):
                single.add(step.name)
                once.append(step)
        standing = [key_of(x) for x in (*inputs, *constants, *once, *outputs)]
        self._place: dict[str, int] = {}
        for place, key in enumerate(standing):
            self._place.setdefault(key, place)
        self._once = [self._move(step) for step in once]
        self._singles = [kind_of(step) for step in once]
        self._first_row = len(standing)
        self._kinds: list[type] = []
        self._free: dict[type, list[int]] = defaultdict(list)
        self._moves = self._arranged([step for step in steps if step.name not in single])
        for place, key in enumerate(standing):  # an output may be known without an operation
            if self._place[key] != place:
                self._moves.append(("copy", [self._place[key]], place))

    def play(
        self,
        inputs: Sequence[Array | float],
        outputs: Sequence[Array],
        finish: Callable[[slice], None] = _nothing,
    ) -> None:
        """Write the outputs, block by block; each block that is written is given to ``finish``."""
        from vad.kinematics.threads import in_blocks  # one pose does not need it

        size = len(outputs[0])
        play = self._play_fast if size > LONG else self._play_block
        singles: list[Array] = [np.empty((), kind) for kind in self._singles]

        def thread(block: int) -> Work:
            rows = [aligned(block, kind) for kind in self._kinds]

            def work(part: slice) -> None:
                play(
                    *(x[part] if isinstance(x, np.ndarray) else x for x in inputs),
                    *self._constants,
                    *singles,
                    *(x[part] for x in outputs),
                    *(row[: part.stop - part.start] for row in rows),
                )
                finish(part)

            return work

        with np.errstate(all="ignore"):  # a result that does not exist is NaN
            cells = [*inputs, *self._constants, *singles]
            for operation, places, place in self._once:
                OPERATIONS[operation].on_blocks(*[cells[i] for i in places], cells[place])
            in_blocks(size, BLOCK, thread)

    def _play_block(self, *cells: Array | float) -> None:
        for operation, places, place in self._moves:
            OPERATIONS[operation].on_blocks(*[cells[i] for i in places], cells[place])

    @cached_property
    def _play_fast(self) -> Callable[..., None]:
        """A function that does what `_play_block` does, one line for each operation."""
        names = [f"c{place}" for place in range(self._first_row + len(self._kinds))]
        lines = [
            f"{operation}({', '.join(names[i] for i in (*places, place))})"
            for operation, places, place in self._moves
        ]
        operations = {name: operation.on_blocks for name, operation in OPERATIONS.items()}
        return function_of(names, lines or ["pass"], operations)

    def _move(self, step: Recorded) -> Move:
        places = [self._place[key_of(x)] for x in step.operands]
        return step.operation, places, self._place[step.name]

    def _arranged(self, steps: list[Recorded]) -> list[Move]:
        """Return every step as a move, and give each number its place."""
        keys = [[*map(key_of, step.operands)] for step in steps]
        last = {key: step for step, each in zip(steps, keys, strict=True) for key in each}
        moves: list[Move] = []
        for step, names in zip(steps, keys, strict=True):
            places = [self._place[name] for name in names]
            done = {self._place[name] for name in names if last[name] is step}
            early = done - {places[number] for number in OPERATIONS[step.operation].kept}
            self._leave(early)
            if step.name not in self._place:
                self._place[step.name] = self._row(kind_of(step))
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


def aligned(size: int, kind: type = float) -> Array:
    """Return new memory that begins where a line of the processor's cache begins.

    numpy's own begins anywhere, and a vector register would often be filled from two lines: that
    takes twice as long.
    """
    length = size * np.dtype(kind).itemsize
    memory = np.empty(length + CACHE_LINE, np.uint8)
    start = -memory.ctypes.data % CACHE_LINE
    return memory[start : start + length].view(kind)
