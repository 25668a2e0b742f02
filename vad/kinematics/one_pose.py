"""One pose that is often asked for: a function that runs only as far as its results are asked for.

It is written in Python from the recorded solver.  What it has found stays in its local variables,
where the next result finds it without being handed over.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import NamedTuple

from vad.kinematics.program import needed
from vad.kinematics.recording import Operand, Recorded, function_of, line_of

# It gives whether the links close, and then the parts of each result whose number it is sent.
Steps = Generator[tuple[float, ...], int, None]


class Order(NamedTuple):
    """An order of derivatives: all that it finds, and the parts of its results."""

    numbers: Sequence[Recorded]
    results: Sequence[Sequence[Operand]]


def pose_function(
    inputs: Sequence[Recorded], closes: Recorded, orders: Sequence[Order]
) -> Callable[..., Steps]:
    """Return the function of a pose; results are numbered from the first order to the last.

    A result of an order costs nothing of a higher order, and nothing that belongs to another result
    alone.
    """
    wanted = [part for order in orders for parts in order.results for part in parts]
    used = {step.name for step in needed(inputs, wanted)}
    found = list(inputs)
    lines: list[str] = []
    known: list[Sequence[Operand]] = []
    for number, order in enumerate(orders):
        state = [x for x in order.numbers if x.name in used]
        steps = needed(found, state if number else [closes, *state])
        lines += map(line_of, steps)
        found += steps
        if not number:
            lines.append(f"asked = yield {closes},")
        known += order.results
        if known:
            lines.append(f"while asked < {len(known)}:")
        for place, parts in enumerate(known):
            lines += [
                f"    {'elif' if place else 'if'} asked == {place}:",
                *(f"        {line_of(step)}" for step in needed(found, parts)),
                f"        asked = yield {''.join(f'{part}, ' for part in parts)}",
            ]
    return function_of([x.name for x in inputs], lines)
