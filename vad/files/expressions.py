"""Arithmetic in a file: in comes "arm/2 + 10", out goes a function of the dimensions.

Four operators, powers, brackets and a few functions, angles in degrees; nothing is ever executed.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from vad.errors import InputError, shown, unknown
from vad.kinematics.numbers import direction, fold

#: No length needs more; a longer text would only cost time.
LONGEST = 200

_OPERATORS: dict[type[ast.AST], Callable[..., float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: math.pow,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}
_FUNCTIONS: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt,
    "hypot": math.hypot,
    "abs": abs,
    "sin": lambda angle: float(direction(fold(angle)).imag),
    "cos": lambda angle: float(direction(fold(angle)).real),
    "tan": lambda angle: float(direction(fold(angle)).imag / direction(fold(angle)).real),
    "asin": lambda ratio: math.degrees(math.asin(ratio)),
    "acos": lambda ratio: math.degrees(math.acos(ratio)),
    "atan": lambda ratio: math.degrees(math.atan(ratio)),
    "atan2": lambda y, x: math.degrees(math.atan2(y, x)),
}
_CONSTANTS = {"pi": math.pi}


@dataclass(frozen=True)
class Expression:
    """A number that may depend on dimensions.

    Attributes
    ----------
    text
        As it is written.
    names
        The dimensions in it.

    Examples
    --------
    >>> half = Expression.of("arm/2 + 10*sin(30)", ["arm"])
    >>> half({"arm": 400.0})
    205.0
    """

    text: str
    names: frozenset[str]
    _tree: ast.expr

    @classmethod
    def of(cls, text: str, dimensions: Mapping[str, object] | list[str]) -> Expression:
        """Read an expression.

        Raises
        ------
        vad.errors.InputError
            If it is none, or names what is no dimension.
        """
        wrong = InputError(
            f"{shown(text)} is no number and no expression",
            hint="write 60, '6 cm', or 'a/2' with a in [dimensions]",
        )
        if len(text) > LONGEST:
            raise wrong
        try:
            tree = ast.parse(text.strip().replace("^", "**"), mode="eval").body
            names = frozenset(_names(tree))
        except (SyntaxError, ValueError, OverflowError, RecursionError, MemoryError):
            raise wrong from None
        for name in sorted(names):
            if name not in dimensions:
                wrong = unknown("dimension", name, dimensions)
                hint = wrong.hint if dimensions else f"write {name} = 100 under [dimensions]"
                raise InputError(str(wrong), hint)
        return cls(text, names, tree)

    def __call__(self, values: Mapping[str, float]) -> float:
        """Return its value for these dimensions.

        Raises
        ------
        vad.errors.InputError
            If there is none, as for a division by zero.
        """
        try:
            value = _value(self._tree, values)
        except (ArithmeticError, ValueError):
            value = math.nan
        if not math.isfinite(value):
            raise InputError(f"{shown(self.text)} has no value")
        return value


def _names(node: ast.expr) -> set[str]:
    """Return the dimensions in an expression, and refuse all that is not arithmetic."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            float(value)  # a whole number of a thousand digits is none
            return set()
        case ast.Name(id=name):
            return set() if name in _CONSTANTS else {name}
        case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
            return _names(operand)
        case ast.BinOp(op=op, left=left, right=right) if type(op) in _OPERATORS:
            return _names(left) | _names(right)
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if name in _FUNCTIONS:
            if len(args) != (2 if name in ("hypot", "atan2") else 1):
                raise ValueError(name)
            return set().union(*map(_names, args))
    raise ValueError


def _value(node: ast.expr, values: Mapping[str, float]) -> float:
    match node:
        case ast.Constant(value=value):
            return float(str(value))
        case ast.Name(id=name):
            return _CONSTANTS[name] if name in _CONSTANTS else values[name]
        case ast.UnaryOp(op=op, operand=operand):
            return _OPERATORS[type(op)](_value(operand, values))
        case ast.BinOp(op=op, left=left, right=right):
            return _OPERATORS[type(op)](_value(left, values), _value(right, values))
        case ast.Call(func=ast.Name(id=name), args=args):
            return _FUNCTIONS[name](*(_value(each, values) for each in args))
    raise ValueError
