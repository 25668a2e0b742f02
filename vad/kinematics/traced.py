"""Numbers that have a value and remember how it was calculated.

Code that runs on floats and complex numbers runs on these unchanged: they are such numbers.  Where
it decides by them, the value decides.  So a whole drawing can be traced: afterwards it is known
how each of its coordinates follows from the inputs, and a `vad.kinematics.program.Program` finds
it for any other pose.

What makes an ordinary number of a traced one (``float()``, ``complex()``, a function of ``math``, a
power that is no product) takes it as a constant.  So code that only chooses the better of two right
ways writes ``float()``.  Where code decides what is right, the record holds for numbers for which
it would decide alike: each such decision is a `Guard`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

from vad.kinematics.recording import OPERATIONS, Operand, Recorded, Tape
from vad.kinematics.symbol import Symbol, is_zero


class Guard(NamedTuple):
    """A truth value by which code decided, and the value that it had."""

    made: Recorded
    value: bool


class TracedTape(Tape):
    """The record of traced numbers, with the guards of what was decided while it was watched."""

    def __init__(self) -> None:
        super().__init__()
        self._watched = False
        self._guards: dict[str, Guard] = {}

    @property
    def guards(self) -> tuple[Guard, ...]:
        """All guards so far, each once."""
        return tuple(self._guards.values())

    @contextmanager
    def watched(self) -> Iterator[None]:
        """Note within this block by what code decides."""
        self._watched = True
        try:
            yield
        finally:
            self._watched = False

    def decide(self, made: Recorded, value: bool) -> bool:
        """Return a truth value by which code decides."""
        if self._watched:
            self._guards.setdefault(made.name, Guard(made, value))
        return value


class Traced(float, Symbol):
    """A real number with a value, and the record of how it was ``made``."""

    __slots__ = ("made",)
    made: Operand

    @classmethod
    def input(cls, tape: TracedTape, name: str, value: float) -> Traced:
        """Return an input with a name and a value."""
        return _traced(value, tape.input(name))

    def note(self, operation: str, *operands: Any) -> Any:
        """Do an operation on numbers of which at least one is traced, and remember it."""
        made = self.tape.note(operation, *map(made_of, operands))
        kind = OPERATIONS[operation].kind
        value = OPERATIONS[operation].on_floats(*map(value_of, operands))
        return TracedTruth(bool(value), made) if kind is bool else _traced(value, made)

    def vector(self, x: Any, y: Any) -> TracedVector:
        """Return a vector of traced numbers."""
        return TracedVector(x, y)

    @property
    def tape(self) -> TracedTape:
        """The record."""
        tape: TracedTape = self.made.tape
        return tape

    def __add__(self, other: Any) -> Any:
        return _both(self, other, float.__add__, lambda x, y: x + y)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return _both(self, other, float.__sub__, lambda x, y: x - y)

    def __rsub__(self, other: Any) -> Any:
        return _both(self, other, float.__rsub__, lambda x, y: y - x)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, complex):
            return TracedVector(_product(self, other.real), _product(self, other.imag))
        if type(other) is int and not other:
            return 0.0
        return _both(self, other, float.__mul__, lambda x, y: x * y)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        return _both(self, other, float.__truediv__, lambda x, y: x / y)

    def __rtruediv__(self, other: Any) -> Any:
        return _both(self, other, float.__rtruediv__, lambda x, y: y / x)

    def __pow__(self, other: Any, modulus: None = None) -> Any:
        if type(other) is int and other > 0:
            return math.prod([self] * other)
        return float(self) ** other

    def __neg__(self) -> Any:
        return _traced(-float(self), -self.made)

    def __pos__(self) -> Any:
        return self

    def __abs__(self) -> Any:
        return _traced(abs(float(self)), abs(self.made))

    def __lt__(self, other: Any) -> Any:
        return self.note("less", self, other)

    def __gt__(self, other: Any) -> Any:
        return self.note("greater", self, other)

    def __le__(self, other: Any) -> Any:
        return (self < other) | (self == other)

    def __ge__(self, other: Any) -> Any:
        return (self > other) | (self == other)

    def __eq__(self, other: object) -> Any:
        if isinstance(other, Traced) and other.made is self.made:
            return float(self) == float(other)
        if isinstance(other, float | int):
            return self.note("equal", self, other)
        return NotImplemented

    def __ne__(self, other: object) -> bool:
        same = self.__eq__(other)
        return True if same is NotImplemented else not same

    def __bool__(self) -> bool:
        return self != 0.0

    def __hash__(self) -> int:
        """Return another hash than that of its value: no cache answers what it has for a float."""
        return hash((id(self.tape), self.made.name))

    def conjugate(self) -> Any:
        """Return the number itself."""
        return self

    @property
    def real(self) -> Any:
        """The number itself."""
        return self

    @property
    def imag(self) -> float:
        """Zero."""
        return 0.0


class TracedTruth(Symbol):
    """A truth value that follows from traced numbers; code that decides by it takes its value."""

    __slots__ = ("made", "value")

    def __init__(self, value: bool, made: Operand) -> None:
        self.value = value
        self.made = made

    def note(self, operation: str, *operands: Any) -> Any:
        """Do an operation on numbers of which at least one is traced, and remember it."""
        return Traced.note(self, operation, *operands)  # type: ignore[arg-type]

    @property
    def tape(self) -> TracedTape:
        """The record."""
        tape: TracedTape = self.made.tape
        return tape

    def __bool__(self) -> bool:
        return self.tape.decide(self.made, self.value)

    def __and__(self, other: Any) -> Any:
        return (
            self.note("both", self, other)
            if isinstance(other, TracedTruth)
            else (self if other else False)
        )

    __rand__ = __and__

    def __or__(self, other: Any) -> Any:
        return self.note("either", self, other)

    def __mul__(self, other: Any) -> Any:
        return self.note("multiply", self, other)

    __rmul__ = __mul__


class TracedVector(complex):
    """A plane vector of traced numbers."""

    __slots__ = ("_imag", "_real")
    _real: Any
    _imag: Any

    def __new__(cls, x: Any, y: Any) -> TracedVector:
        """Return the vector with two coordinates, of which at least one is traced."""
        new = complex.__new__(cls, float(x), float(y))
        new._real, new._imag = x, y
        return new

    @property
    def real(self) -> Any:
        """Its coordinate to the right."""
        return self._real

    @property
    def imag(self) -> Any:
        """Its coordinate upwards."""
        return self._imag

    def conjugate(self) -> Any:
        """Return its mirror image."""
        return TracedVector(self.real, -self.imag)

    def __add__(self, other: Any) -> Any:
        return TracedVector(self.real + other.real, self.imag + other.imag)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        return TracedVector(self.real - other.real, self.imag - other.imag)

    def __rsub__(self, other: Any) -> Any:
        return TracedVector(other.real - self.real, other.imag - self.imag)

    def __neg__(self) -> Any:
        return TracedVector(-self.real, -self.imag)

    def __mul__(self, other: Any) -> Any:
        if not isinstance(other, complex | float | int | TracedTruth):
            return NotImplemented
        x, y = self.real, self.imag
        if isinstance(other, complex):
            a, b = other.real, other.imag
            return TracedVector(_product(x, a) - _product(y, b), _product(x, b) + _product(y, a))
        return TracedVector(x * other, y * other)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, complex):
            square = other.real * other.real + other.imag * other.imag
            return self * other.conjugate() / square
        return TracedVector(self.real / other, self.imag / other)

    def __rtruediv__(self, other: Any) -> Any:
        return other * self.conjugate() / (self.real * self.real + self.imag * self.imag)

    def __abs__(self) -> Any:
        if is_zero(self.imag):
            return abs(self.real)
        square = self.real * self.real + self.imag * self.imag
        return square.note("sqrt", square) if isinstance(square, Traced) else abs(complex(square))

    def __eq__(self, other: object) -> Any:
        if isinstance(other, complex | float | int):
            return (self.real == other.real) & (self.imag == other.imag)
        return NotImplemented

    def __ne__(self, other: object) -> bool:
        same = self.__eq__(other)
        return True if same is NotImplemented else not same

    def __bool__(self) -> bool:
        return self != 0.0

    def __hash__(self) -> int:
        return hash((self.real, self.imag))


def _product(number: Any, factor: Any) -> Any:
    """Return a product, of which nothing is remembered where a constant factor is zero."""
    return 0.0 if is_zero(factor) else number * factor


def plain(value: Any) -> Any:
    """Return the ordinary value of a number or a vector, or of a tuple of such values."""
    if isinstance(value, tuple):
        return tuple(map(plain, value))
    if isinstance(value, TracedVector):
        return complex(float(value.real), float(value.imag))
    return value_of(value)


def value_of(number: Any) -> Any:
    """Return the value of a number, traced or not."""
    if isinstance(number, TracedTruth):
        return number.value
    return float(number) if isinstance(number, Traced) else number


def made_of(number: Any) -> Any:
    """Return how a number was made; one that is not traced is a constant."""
    return number.made if isinstance(number, Traced | TracedTruth) else number


def _traced(value: float, made: Operand) -> Any:
    """Return a traced number; a constant is an ordinary one."""
    if not isinstance(made, Recorded):
        return value
    new = Traced(value)
    new.made = made
    return new


def _both(one: Traced, other: Any, on_floats: Any, on_records: Any) -> Any:
    if isinstance(other, complex) or not isinstance(other, float | int | TracedTruth):
        return NotImplemented
    value = on_floats(float(one), float(value_of(other)))
    return _traced(value, on_records(one.made, made_of(other)))
