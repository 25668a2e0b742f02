"""Numbers that remember how they came about.

The solver's code runs on them once, as it runs on floats; what it did is then known operation by
operation, and a `vad.kinematics.program.Program` does it again, for one pose or for many.
"""

from __future__ import annotations

from typing import Any

from vad.kinematics.operations import OPERATIONS

# A recorded number, or a float that is the same in every pose.
Operand = Any


class Tape:
    """All that is recorded of a solver, each operation once."""

    def __init__(self) -> None:
        self._numbers: dict[tuple[str | float, ...], Recorded] = {}

    def input(self, name: str) -> Recorded:
        """Return the number that is given under a name."""
        return Recorded(self, name, "", ())

    def note(self, operation: str, *operands: Operand) -> Operand:
        """Return what an operation makes of its operands: a float, if they all are floats."""
        if not any(isinstance(operand, Recorded) for operand in operands):
            return OPERATIONS[operation].on_floats(*operands)
        key = (operation, *(x.name if isinstance(x, Recorded) else x for x in operands))
        if key not in self._numbers:
            name = f"t{len(self._numbers)}"
            self._numbers[key] = Recorded(self, name, operation, operands)
        return self._numbers[key]


class Recorded:
    """A real number, or a truth, made by an operation on others; an input is made by none.

    It stands where a float can stand.  Code that decides by it must use `select`.
    """

    __array_ufunc__ = None  # numpy's numbers leave their operations to this class
    __slots__ = ("name", "operands", "operation", "tape")

    def __init__(
        self, tape: Tape, name: str, operation: str, operands: tuple[Operand, ...]
    ) -> None:
        self.tape = tape
        self.name = name
        self.operation = operation
        self.operands = operands

    def __str__(self) -> str:
        return self.name

    def __bool__(self) -> bool:
        raise TypeError("a recorded number is not known yet: use select")

    # A minus is carried outward, until a sum takes it in: that changes no bit.

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


# What its arithmetic knows; vectors and dual numbers, made of several, have their own.
_REAL = (float, int, Recorded)


class RecordedVector:
    """A plane vector of recorded numbers; it stands where a complex number can stand."""

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


def _is_negative(value: Operand) -> bool:
    return isinstance(value, Recorded) and value.operation == "negative"


def _is(value: Operand, wanted: float) -> bool:
    return not isinstance(value, Recorded) and value == wanted
