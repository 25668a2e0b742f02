"""A recorded calculation without what is not asked for, and the ways to play it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad.kinematics.blocks import Blocks
from vad.kinematics.compiled import Compiled
from vad.kinematics.operations import OPERATIONS, function_of
from vad.kinematics.recording import Operand, Recorded

Array = NDArray[Any]

# To compile a program takes about as long as numpy needs for that many poses.
OFTEN = 10_000_000


class Program:
    """What leads from some recorded numbers to others, operation by operation.

    Parameters
    ----------
    inputs
        What is given.
    outputs
        What is wanted: recorded numbers, or floats that are the same in every pose.

    Attributes
    ----------
    steps
        The numbers between them, each after its operands.
    """

    def __init__(self, inputs: Sequence[Recorded], outputs: Sequence[Operand]) -> None:
        self.inputs = inputs
        self.outputs = outputs
        self.steps = _needed(inputs, outputs)
        self._played = 0

    @cached_property
    def one(self) -> Callable[..., tuple[float, ...]]:
        """The function from the inputs to the outputs of one pose: no branch and no loop."""
        lines = [f"return ({''.join(f'{x}, ' for x in self.outputs)})"]
        names = vars(math) | {"arctan2": np.arctan2}
        return function_of([x.name for x in self.inputs], self.lines + lines, names)

    @property
    def lines(self) -> list[str]:
        """Every step as Python writes it."""
        texts = (OPERATIONS[x.operation].text.format(*x.operands) for x in self.steps)
        return [f"{x.name} = {text}" for x, text in zip(self.steps, texts, strict=True)]

    def play(self, inputs: Sequence[Array | float], outputs: Sequence[Array]) -> None:
        """Write the outputs of many poses; an input may be a float that is the same in all."""
        self._played += len(outputs[0])
        compiled = self.compiled if self._played > OFTEN else None
        if compiled and compiled.knows(inputs):
            compiled.play(inputs, outputs)
        else:
            self.blocks.play(inputs, outputs)

    def many(self, inputs: Sequence[Array | float], size: int) -> list[Array]:
        """Return the outputs of many poses, which are all recorded, in new arrays."""
        kinds = (OPERATIONS[x.operation].kind for x in self.outputs)
        outputs: list[Array] = [np.empty(size, kind) for kind in kinds]
        if outputs:
            self.play(inputs, outputs)
        return outputs

    @cached_property
    def blocks(self) -> Blocks:
        """The program as numpy plays it."""
        return Blocks(self)

    @cached_property
    def compiled(self) -> Compiled | None:
        """The program as one compiled loop; None where that cannot be."""
        return Compiled.of(self)


def _needed(inputs: Sequence[Recorded], outputs: Sequence[Operand]) -> list[Recorded]:
    """Return what lies between inputs and outputs, each after its operands."""
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
