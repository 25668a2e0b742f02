"""One pose that is often asked for: a function that runs only as far as its results are asked for.

It is written in Python from the recorded solver.  What it has found stays in its local variables,
where the next result finds it without being handed over.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator, Sequence
from typing import Any, NamedTuple

from vad.kinematics.program import needed
from vad.kinematics.recording import Operand, Recorded, function_of, key_of, lines_of

# It gives whether the links close, and then each result whose number it is sent: a number, a plane
# vector, or the coordinates of a vector in space.
Steps = Generator[Any, int, None]
_FORMS = {1: "{}", 2: "complex({}, {})", 3: "({}, {}, {})"}


class Order(NamedTuple):
    """An order of derivatives: all that it finds, and the parts of its results."""

    numbers: Sequence[Recorded]
    results: Sequence[Sequence[Operand]]


def pose_function(
    inputs: Sequence[Recorded], closes: Recorded, orders: Sequence[Order]
) -> Callable[..., Steps]:
    """Return the function of a pose; results are numbered from the first order to the last.

    A result costs nothing of a higher order.  Of its own order all is found that any of the results
    needs, but not what belongs to another result alone.
    """
    wanted = [part for order in orders for parts in order.results for part in parts]
    used = {step.name for step in needed(inputs, wanted)}
    found = list(inputs)
    known: list[Sequence[Operand]] = []
    # For each order its own steps, and those of each result that is known by then.
    blocks: list[tuple[list[Recorded], list[list[Recorded]]]] = []
    for number, order in enumerate(orders):
        state = [x for x in order.numbers if x.name in used]
        steps = needed(found, state if number else [closes, *state])
        found += steps
        known += order.results
        blocks.append((steps, [needed(found, parts) for parts in known]))
    steps = [step for own, others in blocks for each in (own, *others) for step in each]
    operands = [operand for step in steps for operand in step.operands]
    uses = Counter(map(key_of, [*operands, *wanted, *wanted, closes, closes]))
    lines: list[str] = []
    for number, (own, others) in enumerate(blocks):
        lines += lines_of(own, uses)
        if not number:
            lines.append(f"asked = yield {closes}")
        if others:
            lines.append(f"while asked < {len(others)}:")
        for place, (steps, parts) in enumerate(zip(others, known, strict=False)):
            lines += [
                f"    {'elif' if place else 'if'} asked == {place}:",
                *(f"        {line}" for line in lines_of(steps, uses)),
                f"        asked = yield {_FORMS[len(parts)].format(*parts)}",
            ]
    return function_of([x.name for x in inputs], lines)
