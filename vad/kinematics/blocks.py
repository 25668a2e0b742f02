"""A program for many poses: numpy's operations on blocks that stay in the processor's cache.

Straight through arrays of a million poses every intermediate result would travel to memory and
back.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.operations import OPERATIONS, function_of
from vad.kinematics.recording import Operand, Recorded

if TYPE_CHECKING:
    from vad.kinematics.program import Program

BLOCK = 8192
# For so many poses it pays to write the moves out as a function.
LONG = 30 * BLOCK

# An operation, the places of its operands, and the place of what it makes.
Move = tuple[str, list[int], int]


class Blocks:
    """The operations of a program, and the rows on which it writes.

    Every number of a block has a place: first inputs, constants and outputs, then rows for the
    rest.  A number that is no longer needed leaves its row to another, for the fewer there are the
    nearer they stay.
    """

    def __init__(self, program: Program) -> None:
        inputs, outputs, steps = program.inputs, program.outputs, program.steps
        operands = [x for step in steps for x in step.operands] + list(outputs)
        constants = list(dict.fromkeys(x for x in operands if not isinstance(x, Recorded)))
        self._constants = [np.array(x) for x in constants]
        self._kinds: list[type] = []
        self._free: dict[type, list[int]] = defaultdict(list)
        standing = [_key(x) for x in (*inputs, *constants, *outputs)]
        self._first_row = len(standing)
        self._place: dict[Any, int] = {}
        for place, key in enumerate(standing):
            self._place.setdefault(key, place)
        self._moves = self._arranged(steps)
        for place, key in enumerate(standing):  # an input or constant that is wanted, too
            if self._place[key] != place:
                self._moves.append(("copy", [self._place[key]], place))

    def play(self, inputs: Sequence[NDArray[Any] | float], outputs: Sequence[NDArray[Any]]) -> None:
        """Write the outputs, block by block."""
        size = len(outputs[0])
        play = self._play_fast if size > LONG else self._play_block
        rows: list[NDArray[Any]] = [np.empty(min(size, BLOCK), kind) for kind in self._kinds]
        with np.errstate(all="ignore"):  # what does not exist is NaN
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
        """What `_play_block` does, written out."""
        names = [f"c{place}" for place in range(self._first_row + len(self._kinds))]
        lines = [
            f"{operation}({', '.join(names[i] for i in places)}, out={names[place]})"
            for operation, places, place in self._moves
        ]
        operations = {name: operation.on_blocks for name, operation in OPERATIONS.items()}
        return function_of(names, lines or ["pass"], operations)

    def _arranged(self, steps: list[Recorded]) -> list[Move]:
        """Return every step with the places of its operands and its own."""
        last = {_key(x): step for step in steps for x in step.operands}
        moves: list[Move] = []
        for step in steps:
            places = [self._place[_key(x)] for x in step.operands]
            pairs = zip(step.operands, places, strict=True)
            done = {place for x, place in pairs if last[_key(x)] is step}
            # A select begins with its usual value: that alone may stand where the result will.
            early = done & {places[-1]} if step.operation == "select" else done
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


def _key(number: Operand) -> Any:
    return number.name if isinstance(number, Recorded) else number
