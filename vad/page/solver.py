"""A recorded calculation as data, which the script ``solver.js`` plays in a browser.

It does the same operations in the same order as `vad.kinematics.program.Program`, and gives the
same bits but for the arc tangent.  Every page carries such data, so that they are short: an operand
is written as its distance from the operation, which mostly is a single sign.  Being no code they
need no permission of a page's security policy.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from math import copysign, isfinite, isnan
from string import ascii_letters, digits
from typing import Any

from vad.kinematics.program import Program, needed
from vad.kinematics.recording import OPERATIONS, Operand, Recorded

#: The digits of numbers in the text of a program: five bits, and one that tells that more follow.
DIGITS = ascii_letters + digits + "-_"
_BITS = 5
_PLACES = re.compile(r"\{(\d)")


def solver_data(program: Program, fixed: int = 0) -> dict[str, Any]:
    """Return a program as data for JSON.

    Parameters
    ----------
    program
        What is calculated.
    fixed
        How many of the inputs, the last ones, do not move: dimensions.  Each of the others, the
        driver's place and its rates, begins a stage, in which all is found that depends on no later
        one.  A player may end with any stage: 0 are positions, 1 velocities, 2 accelerations.

    Returns
    -------
    dict
        ``inputs``: how many there are.  ``constants``: their values, of which one that is not
        finite is a text.  ``code``: for each operation its number among `OPERATIONS` and its
        operands, and ``outputs``: see `_reference`.  ``ends``: how many operations are done at the
        end of each stage.

    Examples
    --------
    >>> from vad.kinematics.recording import Tape
    >>> tape = Tape()
    >>> place, rate = tape.input("place"), tape.input("rate")
    >>> data = solver_data(Program([place, rate], [2.0 * place * (1.0 - rate), place + 0.5]))
    >>> data["constants"], data["ends"], data["code"]
    ([2.0, 0.5, 1.0], [2, 4], 'dbfbbhcjddgc')
    """
    steps, ends = _staged(program, len(program.inputs) - fixed)
    places = {each.name: number for number, each in enumerate(program.inputs)}
    constants: dict[str, float] = {}
    for value in _constants(steps, program):
        key = repr(value)
        if isinstance(value, tuple) or key not in constants:
            constants[key] = value
    listed: list[float] = []
    for key, value in constants.items():
        places[key] = len(program.inputs) + len(listed)
        listed += value if isinstance(value, tuple) else [value]
    first = len(program.inputs) + len(listed)
    numbers = {name: number for number, name in enumerate(OPERATIONS)}
    code = ""
    for at, step in enumerate(steps, first):
        code += DIGITS[numbers[step.operation]]
        code += "".join(_reference(_place(x, places), at, first) for x in step.operands)
        places[step.name] = at
    end = first + len(steps)
    outputs = "".join(_reference(_place(x, places), end, first) for x in program.outputs)
    return {
        "inputs": len(program.inputs),
        "constants": list(map(_listed, listed)),
        "code": code,
        "outputs": outputs,
        "ends": ends,
    }


@cache
def solver_script(text: str) -> str:
    """Return the text of ``solver.js`` with the operations in it.

    They become the cases of a ``switch``: the operands of number ``i`` are at the places ``a``,
    ``b`` and ``c`` of ``v``.
    """
    counts = [
        each.script.count("{}") or max(map(int, _PLACES.findall(each.script))) + 1
        for each in OPERATIONS.values()
    ]
    cases = []
    for number, operation in enumerate(OPERATIONS.values()):
        # The first place is also that of a form without numbers: "{}+{}".
        constants = ["v[b]", "v[b+1]", "v[b+2]"] if "[0]" in operation.script else "v[b]"
        done = operation.script.format("v[a]", constants, "v[c]")
        cases.append(f"case {number}:v[i]={done};break;")
    return text.replace("OPERATIONS", "".join(cases)).replace("COUNTS", str(counts))


def _staged(program: Program, moving: int) -> tuple[list[Recorded], list[int]]:
    """Return the operations stage by stage, and how many are done at the end of each."""
    stages = {each.name: n if n < moving else 0 for n, each in enumerate(program.inputs)}
    for step in program.steps:
        known = (x.name for x in step.operands if isinstance(x, Recorded))
        stages[step.name] = max((stages[name] for name in known), default=0)
    known_so_far = list(program.inputs)
    steps: list[Recorded] = []
    ends = []
    for stage in range(max(moving, 1)):
        wanted = [step for step in program.steps if stages[step.name] == stage]
        fresh = needed(known_so_far, wanted)
        steps += fresh
        known_so_far += fresh
        ends.append(len(steps))
    return steps, ends


def _constants(steps: list[Recorded], program: Program) -> Iterator[Any]:
    """Yield the constants of the steps and outputs; those of a choice stand together."""
    for step in steps:
        yield from (x for x in step.operands if not isinstance(x, Recorded))
    yield from (x for x in program.outputs if not isinstance(x, Recorded))


def _place(operand: Operand, places: dict[str, int]) -> int:
    return places[operand.name if isinstance(operand, Recorded) else repr(operand)]


def _reference(place: int, at: int, first: int) -> str:
    """Return the text of a place: twice the distance back, or of what is given 2n + 1."""
    number = 2 * (at - place) if place >= first else 2 * place + 1
    text = ""
    # Each round takes five bits.
    while number >= 1 << _BITS:
        text += DIGITS[(number & (1 << _BITS) - 1) | 1 << _BITS]
        number >>= _BITS
    return text + DIGITS[number]


def _listed(value: Any) -> float | str:
    """Return a constant as JSON can hold it."""
    number = float(value)
    if isfinite(number):
        return number
    return "NaN" if isnan(number) else "Infinity" if copysign(1.0, number) > 0.0 else "-Infinity"
