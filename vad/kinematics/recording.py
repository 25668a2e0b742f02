"""Numbers that remember how they were calculated, and the operations that they remember.

The code of a solver runs once on such numbers, as it runs on floats.  Then every operation is
known, and a `vad.kinematics.program.Program` can repeat them for one pose or for many.  Each
operation has four forms: as Python writes it, as JavaScript does, on floats, and on blocks of some
thousand poses.  All give the same bits; only the arc tangent of a browser may differ in the last.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from itertools import count
from typing import Any, NamedTuple

import numpy as np

from vad.kinematics.symbol import Symbol


class Operation(NamedTuple):
    """One operation: its texts in two languages, and its functions for floats and for blocks.

    In JavaScript ``fold`` and ``copysign`` are those of ``vad/page/solver.js``.
    A function for blocks writes to the array that is its last argument: by place, because numpy
    takes longer to find a name.  This may be the array of an operand, unless that is one of the
    operands that are ``kept``.  ``kind`` is the type of the result.
    """

    text: str
    script: str
    on_floats: Callable[..., Any]
    on_blocks: Callable[..., Any]
    kind: type = float
    kept: tuple[int, ...] = ()


def _select(condition: Any, rare: Any, usual: Any, out: Any) -> None:
    if out is not usual:
        np.copyto(out, usual)
    if np.count_nonzero(condition):
        np.putmask(out, condition, rare)


def prepared(degrees: Any) -> Any:
    """Return an angle, or angles, that can be folded without the loop that a remainder needs.

    Beyond 1e15, 360·k is no longer exact, but fmod is; with 720 it can still be told which of +180
    and -180 is meant.
    """
    degrees = np.asarray(degrees)
    if degrees.size and not (degrees.min() >= -1e15 and degrees.max() <= 1e15):
        return np.where(np.abs(degrees) > 1e15, np.fmod(degrees, 720.0), degrees)
    return degrees


def _fold(degrees: Any, out: Any) -> None:
    degrees = prepared(degrees)
    np.divide(degrees, 360.0, out)
    np.rint(out, out)
    np.multiply(out, 360.0, out)
    np.subtract(degrees, out, out)
    if not (out.min() >= -180.0 and out.max() <= 180.0):  # a quotient was rounded onto one half
        beyond = np.abs(out) > 180.0
        out[beyond] -= np.copysign(360.0, out[beyond])


def _place(number: Any, out: Any) -> None:
    np.copyto(out, number, casting="unsafe")


def _choose(place: Any, constants: Any, out: Any) -> None:
    constants.take(place, None, out, "clip")  # five times as fast as numpy.where


def _minimum(x: Any, y: Any, out: Any) -> None:
    np.minimum(x, y, out=out)  # this function of numpy wants the name


def _maximum(x: Any, y: Any, out: Any) -> None:
    equal = np.equal(x, y)
    np.fmax(x, y, out)
    if np.count_nonzero(equal):  # of 0.0 and -0.0 it takes either, by their place in the array
        np.copyto(out, y, where=equal)


def _either(condition: bool, rare: float, usual: float) -> float:
    return rare if condition else usual


# Longer texts are not nested in each other.
LONGEST_TEXT = 400

OPERATIONS = {
    "fold": Operation(  # no zero is negative
        "remainder({}, 360.0) + 0.0",
        "fold({})",
        lambda x: math.remainder(x, 360.0) + 0.0,
        _fold,
        kept=(0,),
    ),
    "add": Operation("{} + {}", "{}+{}", operator.add, np.add),
    "subtract": Operation("{} - {}", "{}-{}", operator.sub, np.subtract),
    "multiply": Operation("{} * {}", "{}*{}", operator.mul, np.multiply),
    "divide": Operation("{} / {}", "{}/{}", operator.truediv, np.divide),
    "negative": Operation("-{}", "-{}", operator.neg, np.negative),
    "absolute": Operation("abs({})", "abs({})", abs, np.absolute),
    "copy": Operation("{}", "{}", float, _place),
    "minimum": Operation(
        "{0} if {0} < {1} else {1}",
        "{0}<{1}?{0}:{1}",
        lambda x, y: y if y <= x else x,
        _minimum,
    ),
    "maximum": Operation(
        "{0} if {0} > {1} else {1}",
        "{0}>{1}?{0}:{1}",
        lambda x, y: x if x > y else y,
        _maximum,
        kept=(1,),
    ),
    "sqrt": Operation("sqrt({})", "sqrt({})", math.sqrt, np.sqrt),
    "copysign": Operation("copysign({}, {})", "copysign({},{})", math.copysign, np.copysign),
    # numpy's for one pose too: its last bit is not always that of the C library.
    "arctan2": Operation(
        "float(arctan2({}, {}))", "atan2({},{})", lambda y, x: float(np.arctan2(y, x)), np.arctan2
    ),
    "round": Operation(  # of a number within ±1
        "1.0 if {0} > 0.5 else -1.0 if {0} < -0.5 else 0.0",
        "{0}>.5?1:{0}<-.5?-1:0",
        lambda x: float(round(x)),
        np.rint,
    ),
    "place": Operation("{}", "{}", int, _place, np.intp),
    "choose": Operation(
        "{1[0]} if {0} < 0.5 else {1[2]} if {0} > 1.5 else {1[1]}",
        "{0}<.5?{1[0]}:{0}>1.5?{1[2]}:{1[1]}",
        lambda i, of: of[int(i)],
        _choose,
    ),
    "less": Operation("{} < {}", "{}<{}", operator.lt, np.less, bool),
    "greater": Operation("{} > {}", "{}>{}", operator.gt, np.greater, bool),
    "equal": Operation("{} == {}", "{}=={}", operator.eq, np.equal, bool),
    "both": Operation("{} & {}", "{}&&{}", operator.and_, np.logical_and, bool),
    "either": Operation("{} | {}", "{}||{}", operator.or_, np.logical_or, bool),
    "select": Operation("{1} if {0} else {2}", "{0}?{1}:{2}", _either, _select, kept=(0, 1)),
}


def function_of(
    arguments: list[str], lines: list[str], names: Mapping[str, Any] | None = None
) -> Callable[..., Any]:
    """Return the function with this text; every word of the text is written by this program."""
    space = vars(math) | {"arctan2": np.arctan2} if names is None else dict(names)
    exec("\n    ".join([f"def program({', '.join(arguments)}):", *lines]), space)
    function: Callable[..., Any] = space["program"]
    return function


# A recorded number, or a float that is the same in every pose.
Operand = Any


class Tape:
    """The record of a solver, with each operation once, though several threads write on it."""

    def __init__(self) -> None:
        self._numbers: dict[tuple[str, ...], Recorded] = {}
        self._count = count()

    def input(self, name: str) -> Recorded:
        """Return an input with a name: a recorded number that no operation makes."""
        return Recorded(self, name, "", ())

    def note(self, operation: str, *operands: Operand) -> Operand:
        """Record an operation and return its result; of floats alone it is a float."""
        if not any(isinstance(operand, Recorded) for operand in operands):
            return OPERATIONS[operation].on_floats(*operands)
        key = (operation, *map(key_of, operands))
        found = self._numbers.get(key)
        if found is None:
            new = Recorded(self, f"t{next(self._count)}", operation, operands)
            found = self._numbers.setdefault(key, new)
        return found


class Recorded(Symbol):
    """A real number or a truth value that an operation makes of others, or an input.

    It can stand wherever a float can stand.  Code that decides by it must use `select`.
    """

    __array_ufunc__ = None  # numpy leaves operations with its own numbers to this class
    __slots__ = ("name", "operands", "operation", "tape")

    def __init__(
        self, tape: Tape, name: str, operation: str, operands: tuple[Operand, ...]
    ) -> None:
        self.tape = tape
        self.name = name
        self.operation = operation
        self.operands = operands

    def note(self, operation: str, *operands: Operand) -> Operand:
        """Record an operation."""
        return self.tape.note(operation, *operands)

    def vector(self, x: Operand, y: Operand) -> RecordedVector:
        """Return a vector of recorded numbers."""
        return RecordedVector(x, y)

    def __str__(self) -> str:
        return self.name

    def __bool__(self) -> bool:
        raise TypeError("a recorded number is not known yet: use select")

    # A minus sign moves outward until a sum or a difference takes it up: this changes no bit.

    def __add__(self, other: Operand) -> Operand:
        if not isinstance(other, _REAL):
            return NotImplemented
        if _is(other, 0.0):
            return self
        if _is_negative(other):
            return self - -other
        return other - -self if _is_negative(self) else self.tape.note("add", self, other)

    __radd__ = __add__

    def __sub__(self, other: Operand) -> Operand:
        if not isinstance(other, _REAL):
            return NotImplemented
        if _is(other, 0.0):
            return self
        if _is_negative(other):
            return self + -other
        if _is_negative(self):
            return -(-self + other)
        return self.tape.note("subtract", self, other)

    def __rsub__(self, other: Operand) -> Operand:
        if not isinstance(other, _REAL):
            return NotImplemented
        if _is(other, 0.0):
            return -self
        return other + -self if _is_negative(self) else self.tape.note("subtract", other, self)

    def __mul__(self, other: Operand) -> Operand:
        if isinstance(other, complex):
            return RecordedVector(self * other.real, self * other.imag)
        if not isinstance(other, _REAL):
            return NotImplemented
        if _is(other, 1.0) or _is(other, -1.0):
            return self if other > 0.0 else -self
        if _is_negative(self) or _is_negative(other):
            return -(-self * other) if _is_negative(self) else -(self * -other)
        return self.tape.note("multiply", self, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Operand) -> Operand:
        if not isinstance(other, _REAL):
            return NotImplemented
        if _is_negative(self) or _is_negative(other):
            return -(-self / other) if _is_negative(self) else -(self / -other)
        return self if _is(other, 1.0) else self.tape.note("divide", self, other)

    def __rtruediv__(self, other: Operand) -> Operand:
        return self.tape.note("divide", other, self)

    def __neg__(self) -> Operand:
        if self.operation == "negative":
            return self.operands[0]
        return self.tape.note("negative", self)

    def __abs__(self) -> Operand:
        return self.tape.note("absolute", self)

    def __lt__(self, other: Operand) -> Operand:
        return self.tape.note("less", self, other)

    def __gt__(self, other: Operand) -> Operand:
        return self.tape.note("greater", self, other)

    def __eq__(self, other: object) -> Operand:
        return self.tape.note("equal", self, other)

    def __and__(self, other: Operand) -> Operand:
        if isinstance(other, bool):
            return self if other else False
        return self.tape.note("both", self, other)

    __rand__ = __and__

    def __or__(self, other: Operand) -> Operand:
        return self.tape.note("either", self, other)

    __hash__ = None  # type: ignore[assignment]


# The operands that this arithmetic knows; vectors and dual numbers have their own.
_REAL = (float, int, Recorded)


class RecordedVector:
    """A plane vector of recorded numbers; it can stand wherever a complex number can stand."""

    __array_ufunc__ = None
    __slots__ = ("imag", "real")

    def __init__(self, real: Operand, imag: Operand) -> None:
        self.real = real
        self.imag = imag

    def __add__(self, other: Any) -> RecordedVector:
        return RecordedVector(self.real + other.real, self.imag + other.imag)

    __radd__ = __add__

    def __sub__(self, other: Any) -> RecordedVector:
        return RecordedVector(self.real - other.real, self.imag - other.imag)

    def __rsub__(self, other: Any) -> RecordedVector:
        return RecordedVector(other.real - self.real, other.imag - self.imag)

    def __neg__(self) -> RecordedVector:
        return RecordedVector(-self.real, -self.imag)

    def __mul__(self, length: Operand) -> RecordedVector:
        return RecordedVector(self.real * length, self.imag * length)

    __rmul__ = __mul__


def lines_of(steps: Sequence[Recorded], uses: Mapping[str, int]) -> list[str]:
    """Return operations as lines of Python.

    An operation whose result is used once, by a later one of them, is written where it is used:
    nothing is then stored.  ``uses`` tells how often each is used here and elsewhere.
    """
    written_once = {
        operand.name
        for step in steps
        for place, operand in enumerate(step.operands)
        if isinstance(operand, Recorded)
        and OPERATIONS[step.operation].text.count(f"{{{place}}}") < 2
        and uses[operand.name] == 1
    }
    nested: dict[str, str] = {}
    lines = []
    for step in steps:
        texts = [nested.pop(key_of(x), x) for x in step.operands]
        text = OPERATIONS[step.operation].text.format(*texts)
        if step.name in written_once and len(text) < LONGEST_TEXT:
            nested[step.name] = f"({text})"
        else:
            lines.append(f"{step.name} = {text}")
    return lines


def key_of(operand: Operand) -> str:
    """Return the name of a recorded number, or the text of a constant.

    0.0, -0.0 and False are equal, and so are 1.0 and True; as texts they are not.
    """
    return operand.name if isinstance(operand, Recorded) else repr(operand)


def kind_of(operand: Operand) -> type:
    """Return the type of a number: float, or that of a truth value or a whole number."""
    is_step = isinstance(operand, Recorded) and operand.operation
    return OPERATIONS[operand.operation].kind if is_step else float


def _is_negative(value: Operand) -> bool:
    return isinstance(value, Recorded) and value.operation == "negative"


def _is(value: Operand, wanted: float) -> bool:
    return not isinstance(value, Recorded) and value == wanted
