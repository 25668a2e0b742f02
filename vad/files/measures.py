"""Which of a file's free dimensions are lengths, as their uses tell.

A dimension such as ``u = 20`` may be a length or a mere number.  Where it is used as ``4*u`` for a
length, it is one; in ``ratio*a`` beside a length ``a`` it is a number.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping, Sequence
from itertools import product

from vad.files.description import Expression

#: The power of length that each quantity has.
_POWERS = {"length": 1.0, "angle": 0.0}
#: With more dimensions than so many, nothing is told.
_MOST = 10
#: Functions whose value has the power of their arguments.
_SAME = ("abs", "hypot")


class _MixedError(Exception):
    """A length and a number are added."""


def lengths(names: Sequence[str], uses: Iterable[tuple[Expression, str]]) -> set[str]:
    """Return the dimensions that can only be lengths.

    Parameters
    ----------
    names
        The dimensions.
    uses
        The expressions, each with the quantity for which it is written.

    Examples
    --------
    >>> uses = [(Expression.of(text, ["a", "n"]), "length") for text in ("a", "(n - 1)*a")]
    >>> lengths(["a", "n"], uses)
    {'a'}
    """
    wanted = [(each, _POWERS[quantity]) for each, quantity in uses if quantity in _POWERS]
    if len(names) > _MOST:
        return set()
    ways = (dict(zip(names, way, strict=True)) for way in product((0.0, 1.0), repeat=len(names)))
    fitting = [way for way in ways if all(_fits(each, way, power) for each, power in wanted)]
    return {name for name in names if fitting and all(way[name] for way in fitting)}


def _fits(expression: Expression, kinds: Mapping[str, float], wanted: float) -> bool:
    try:
        return _power(expression.tree, kinds) in (None, wanted)
    except _MixedError:
        return False


def _power(node: ast.expr, kinds: Mapping[str, float]) -> float | None:
    """Return the power of length that a value has; None for a number, which has any in a sum."""
    match node:
        case ast.Name(id=name):
            return kinds.get(name)
        case ast.UnaryOp(operand=operand):
            return _power(operand, kinds)
        case ast.BinOp(op=ast.Mult() | ast.Div() as op, left=left, right=right):
            one, other = _power(left, kinds), _power(right, kinds)
            if one is None and other is None:
                return None
            return (one or 0.0) + (other or 0.0) * (1.0 if isinstance(op, ast.Mult) else -1.0)
        case ast.BinOp(op=ast.Pow(), left=left, right=right):
            base = _power(left, kinds)
            if not base:
                return base
            if isinstance(right, ast.Constant) and isinstance(right.value, int | float):
                return base * right.value
            raise _MixedError
        case ast.BinOp(left=left, right=right):
            return _alike([left, right], kinds)
        case ast.Call(func=ast.Name(id=name), args=args):
            inner = _alike(args, kinds)
            if name == "sqrt":
                return inner and inner / 2.0
            if name in _SAME:
                return inner
            if name != "atan2" and inner:
                raise _MixedError
            return 0.0 if inner is not None else None
    return None


def _alike(nodes: Iterable[ast.expr], kinds: Mapping[str, float]) -> float | None:
    """Return the one power that all of several values have."""
    found = {power for node in nodes if (power := _power(node, kinds)) is not None}
    if len(found) > 1:
        raise _MixedError
    return next(iter(found), None)
