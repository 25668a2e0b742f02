"""What recorded and traced numbers have in common, and how ordinary numbers are told from them."""

from __future__ import annotations

from typing import Any


class Symbol:
    """A number that notes what is done with it."""

    __slots__ = ()

    def note(self, operation: str, *operands: Any) -> Any:
        """Do an operation on numbers, of which this is one, and remember it."""
        raise NotImplementedError

    def vector(self, x: Any, y: Any) -> Any:
        """Return the plane vector of two numbers, of which this is one."""
        raise NotImplementedError


def is_symbolic(number: Any) -> bool:
    """Tell whether a number, or a coordinate of a vector, notes what is done with it."""
    return (
        isinstance(number, Symbol)
        or isinstance(number.real, Symbol)
        or isinstance(number.imag, Symbol)
    )


def is_zero(number: Any) -> bool:
    """Tell whether a number is an ordinary zero; by another nothing is decided."""
    return not isinstance(number, Symbol) and bool(number == 0.0)


def as_float(number: Any) -> float:
    """Return a real number as a float; a traced one stays as it is."""
    return number if isinstance(number, Symbol) else float(number)  # type: ignore[return-value]


def as_complex(number: Any) -> complex:
    """Return a number as a complex one; one that is traced, or has a traced part, stays so."""
    vector: complex = number if is_symbolic(number) else complex(number)
    return vector
