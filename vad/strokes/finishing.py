"""The last step of a sheet: labels get their numbers, and rounding noise becomes zero.

All numbers become ones that JSON can hold: Python's own, and never a negative zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, replace
from functools import cache
from math import copysign
from operator import attrgetter, is_not
from types import NoneType
from typing import Any

from vad.kinematics.symbol import Symbol, is_symbolic
from vad.strokes.sentences import Text, Voice
from vad.strokes.sheet import Cell, Equation, Panel, Row, Stroke, Term
from vad.strokes.vector_equations import NOTHING

#: The kinds of pieces of a label that depend on how numbers are written.
_COUNTED = ("figure", "unit")


def finished(panel: Panel, voice: Voice) -> Panel:
    """Return a panel with the numbers in its labels and equations, as canonical data.

    Parameters
    ----------
    panel
        The panel as it was drawn.
    voice
        The voice of its labels, which knows by now how many digits their numbers need.
    """

    def fill(label: str) -> str:
        if isinstance(label, Text) and any(kind in _COUNTED for _, kind in label.pieces):
            return Text.of(label.said, voice)
        return label

    def stroke(raw: Stroke) -> Stroke:
        label = fill(raw.label)
        shape = canonical(raw.shape)
        if label is raw.label and shape is raw.shape:
            return raw
        more = raw.link, raw.component, raw.image, raw.reveals, raw.part
        return Stroke(raw.kind, label, shape, raw.said, *more)

    def term(raw: Term) -> Term:
        label = fill(raw.label)
        return raw if label is raw.label else replace(raw, label=label)

    def terms(raw: tuple[Term, ...]) -> tuple[Term, ...]:
        return tuple(map(term, raw))

    return replace(
        panel,
        strokes=tuple(map(stroke, panel.strokes)),
        zeros=tuple(map(stroke, panel.zeros)),
        equations=tuple(Equation(terms(each.left), terms(each.right)) for each in panel.equations),
        inset=canonical(panel.inset),
        triangles=canonical(panel.triangles),
        notes=canonical(panel.notes),
        below=panel.below and finished(panel.below, voice),
    )


def without_noise(rows: Sequence[Row], largest: Mapping[str, float]) -> tuple[Row, ...]:
    """Return rows in which values that are only rounding noise are zero.

    A value is noise if it is very small beside the ``largest`` one of the same unit.
    """

    def cleaned(cell: Cell) -> Cell:
        noise = abs(cell.value) < NOTHING * largest[cell.unit]
        return replace(cell, value=0.0) if noise and not cell.given else canonical(cell)

    return tuple(
        replace(
            row,
            cells={
                name: tuple([cleaned(cell) for cell in cells]) for name, cells in row.cells.items()
            },
        )
        for row in rows
    )


#: The types of fields that need no change, as they are declared: they hold no float.
_WORDS = {"str", "str | None", "bool", "int", "tuple[str, ...]"}


def canonical(value: Any) -> Any:
    """Return data in which every number is a ``float`` or ``complex`` without −0.0.

    Data that are canonical already are returned unchanged.

    Examples
    --------
    >>> canonical((-0.0, complex(-0.0, 2.0), "−0"))
    (0.0, 2j, '−0')
    """
    return _canonical_form(value.__class__)(value)


@cache
def _canonical_form(cls: Any) -> Callable[[Any], Any]:
    """Return the function that makes data of a type canonical."""
    if issubclass(cls, str | int | NoneType):
        return lambda value: value
    if issubclass(cls, complex):
        return _complex
    if issubclass(cls, float):
        return _float
    if issubclass(cls, tuple):
        return _tuple
    if issubclass(cls, Mapping):
        return lambda value: {key: canonical(each) for key, each in value.items()}
    return _record(cls)


def _float(value: float) -> float:
    if isinstance(value, Symbol):
        return value
    if type(value) is float and (value or copysign(1.0, value) > 0.0):
        return value
    return float(value) + 0.0


def _complex(value: complex) -> complex:
    if is_symbolic(value):
        return value
    x, y = value.real, value.imag
    if type(value) is complex and (x or copysign(1.0, x) > 0.0) and (y or copysign(1.0, y) > 0.0):
        return value
    return complex(x + 0.0, y + 0.0)


def _tuple(value: tuple[Any, ...]) -> tuple[Any, ...]:
    new = tuple([_canonical_form(each.__class__)(each) for each in value])
    return new if any(map(is_not, new, value)) else value


def _record(cls: Any) -> Callable[[Any], Any]:
    """Return the function that makes a dataclass canonical; it copies only what changes."""
    every = attrgetter(*[field.name for field in fields(cls)], "__class__")
    numbers = attrgetter(*[f.name for f in fields(cls) if f.type not in _WORDS], "__class__")

    def record(value: Any) -> Any:
        for held in numbers(value)[:-1]:
            if held is not None and _canonical_form(held.__class__)(held) is not held:
                return cls(*map(canonical, every(value)[:-1]))
        return value

    return record
