"""A recorded calculation as one function in JavaScript.

A page plays it while a mechanism is turned by hand.  It does the same operations in the same order
as `vad.kinematics.program.Program`, and gives the same bits but for the arc tangent.  Every page
carries such a text, so that it is short: a result that is used once is calculated where it is used,
variables are used again, and numbers are written with as few signs as tell all their bits.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from heapq import heappop, heappush
from math import isfinite, isnan
from string import ascii_letters
from typing import NamedTuple

from vad.kinematics.program import Program, needed
from vad.kinematics.recording import OPERATIONS, Operand, Recorded

# How strongly an operator binds its operands; what is no operator is as strong as a name.
_STRENGTHS = {"?": 0, "|": 1, "&": 2, "=": 3, "<": 4, ">": 4, "+": 5, "-": 5, "*": 6, "/": 6}
_NAME = 7
# A number stands in a statement as {t7}, {place} or {.5} until it is known which variable holds it.
_GAP = re.compile(r"\{(.*?)\}")


class _Statement(NamedTuple):
    """A text, at which places of the output its value stands, and which recorded number it is."""

    text: str
    places: Sequence[int] = ()
    name: str = ""

    @property
    def taken(self) -> list[str]:
        """The numbers in the text, each as often as it stands there."""
        return _GAP.findall(self.text)


def script(program: Program, fixed: int = 0) -> str:
    """Return a program as the text of a function ``(inputs…, out, upto) => …``.

    The function writes the outputs to ``out``, an array of floats, in their order; a truth value
    becomes 1 or 0.  Beside it must stand the functions of ``vad/page/solver.js``.

    Parameters
    ----------
    program
        What is calculated.
    fixed
        How many of the inputs, the last ones, do not move: dimensions.  Each of the others, the
        driver's place and its rates, begins a stage, in which all outputs are found that depend on
        no later one.  The function ends with the stage ``upto``: 0 are positions, 1 velocities, 2
        accelerations.

    Examples
    --------
    >>> from vad.kinematics.recording import Tape
    >>> tape = Tape()
    >>> place, rate = tape.input("place"), tape.input("rate")
    >>> print(script(Program([place, rate], [2.0 * place * (1.0 - rate), place + 0.5])))
    (a,b,c,d)=>{
    c[1]=a+.5
    if(d<1)return
    c[0]=a*2*(1-b)}
    """
    inputs = [each.name for each in program.inputs]
    count = len(inputs) + 2
    *_, out, upto = parameters = [_variable(number) for number in range(count)]
    statements = list(_statements(program, len(inputs) - fixed, upto))
    constants = {text: _variable(count + n) for n, text in enumerate(_worth_a_name(statements))}
    count += len(constants)
    lines, size = _lines(statements, out, inputs, constants, count)
    variables = [f"{name}={text}" for text, name in constants.items()]
    variables += [_variable(number) for number in range(count, size)]
    declared = f"let {','.join(variables)}" if variables else ""
    return "\n".join([f"({','.join(parameters)})=>{{{declared}", *lines]) + "}"


def _statements(program: Program, moving: int, upto: str) -> Iterator[_Statement]:
    """Yield what is done, stage by stage."""
    stages = {each.name: n if n < moving else 0 for n, each in enumerate(program.inputs)}
    uses: Counter[str] = Counter()
    for step in program.steps:
        form = OPERATIONS[step.operation].script
        operands = {n: x.name for n, x in enumerate(step.operands) if isinstance(x, Recorded)}
        stages[step.name] = max(stages[name] for name in operands.values())
        for place, name in operands.items():
            uses[name] += form.count(f"{{{place}}}") or 1  # without a number it stands once
    places: dict[str, list[int]] = {}
    for place, output in enumerate(program.outputs):
        places.setdefault(_key(output), []).append(place)
    known = list(program.inputs)
    nested: dict[str, tuple[str, int]] = {}
    for stage in range(max(moving, 1)):
        wanted = {_key(x): x for x in program.outputs if stages.get(_key(x), 0) == stage}
        if stage and wanted:
            yield _Statement(f"if({upto}<{stage})return")
        steps = needed(known, list(wanted.values()))
        known += steps
        made = {step.name for step in steps}
        yield from (_Statement(f"{{{key}}}", places[key]) for key in wanted if key not in made)
        for step in steps:
            text, strength = _written(step, nested)
            if uses[step.name] == 1 and step.name not in places:
                nested[step.name] = text, strength
            else:
                name = step.name if uses[step.name] else ""
                yield _Statement(text, places.get(step.name, ()), name)


def _written(step: Recorded, nested: dict[str, tuple[str, int]]) -> tuple[str, int]:
    """Return a step as a text, and how strongly that binds; it takes what is nested in it."""
    form = OPERATIONS[step.operation].script
    signs = [_STRENGTHS[sign] for sign in form if sign in _STRENGTHS]
    strength = min(signs, default=_NAME if form.endswith(")") else 0)
    texts: list[str | list[str]] = []
    for place, operand in enumerate(step.operands):
        if isinstance(operand, tuple):
            texts.append([f"{{{_key(number)}}}" for number in operand])
            continue
        text, own = nested.pop(_key(operand), (f"{{{_key(operand)}}}", _NAME))
        first = place == 0 and form.startswith("{")
        # The parts of a choice and of a call need no brackets: no truth value is itself a choice.
        stands = own > strength or (own == strength and first) or strength in (0, _NAME)
        texts.append(text if stands else f"({text})")
    return form.format(*texts), strength


def _lines(
    statements: Sequence[_Statement],
    out: str,
    inputs: Sequence[str],
    constants: Mapping[str, str],
    size: int,
) -> tuple[list[str], int]:
    """Return the statements with their variables, and how many variables there are.

    A number that is no longer needed leaves its variable to another one.
    """
    last = {key: number for number, each in enumerate(statements) for key in each.taken}
    held = {name: number for number, name in enumerate(inputs)}
    free: list[int] = []
    lines = []

    def variable(gap: re.Match[str]) -> str:
        return _variable(held[gap[1]]) if gap[1] in held else constants.get(gap[1], gap[1])

    for number, each in enumerate(statements):
        text = _GAP.sub(variable, each.text)
        for key in {*each.taken} & held.keys():
            if last[key] == number:
                heappush(free, held.pop(key))
        targets = [f"{out}[{place}]" for place in each.places]
        if each.name:
            if not free:
                free, size = [size], size + 1
            held[each.name] = heappop(free)
            targets.append(_variable(held[each.name]))
        lines.append("=".join([*targets, text]).replace("--", "- -"))
    return lines, size


def _worth_a_name(statements: Sequence[_Statement]) -> list[str]:
    """Return the constants that are written so often that variables make the text shorter."""
    uses = Counter(key for each in statements for key in each.taken if not key.isidentifier())
    return [text for text, times in uses.items() if (times - 1) * (len(text) - 1) > len(",a=")]


def _variable(number: int) -> str:
    """Return a name: one of 52 letters, then one with a digit, and so on."""
    round_, place = divmod(number, len(ascii_letters))
    return ascii_letters[place] + (str(round_) if round_ else "")


def _key(operand: Operand) -> str:
    """Return the name of a recorded number, or a constant in the shortest text that is exact."""
    if isinstance(operand, Recorded):
        return operand.name
    if not isfinite(operand):
        return "NaN" if isnan(operand) else "Infinity" if operand > 0.0 else "-Infinity"
    sign, digits, exponent = (exact := Decimal(repr(float(operand))).normalize()).as_tuple()
    plain = f"{abs(exact):f}".lstrip("0") or "0"
    power = f"{''.join(map(str, digits))}e{exponent}"
    return "-" * sign + min(plain, power, key=len)
