"""From what was drawn to what stands on a sheet: numbers are written, and what is noise is zero.

All numbers become such as JSON can hold: Python's own, and never a negative zero.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, replace
from functools import cache
from math import copysign
from operator import is_not
from types import NoneType
from typing import Any

from vad.strokes.sentences import Text, Voice
from vad.strokes.sheet import Cell, Equation, Panel, Row, Stroke, Term
from vad.strokes.vector_equations import NOTHING

#: What of a label depends on how numbers are written.
_COUNTED = ("figure", "unit")


def finished(panel: Panel, voice: Voice) -> Panel:
    """Return a panel with the numbers in its labels and equations, and all canonical.

    Parameters
    ----------
    panel
        What was drawn.
    voice
        Who says its labels, now that it is known how many digits their numbers need.
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
    """Write as zero what is zero but for rounding, against the largest of its kind."""

    def cleaned(cell: Cell) -> Cell:
        noise = abs(cell.value) < NOTHING * largest[cell.unit]
        return replace(cell, value=0.0) if noise and not cell.given else canonical(cell)

    return tuple(
        Row(
            row.key,
            row.title,
            row.letters,
            {name: tuple([cleaned(cell) for cell in cells]) for name, cells in row.cells.items()},
        )
        for row in rows
    )


#: How fields without numbers are declared; truth values and whole numbers are left alone.
_WORDS = {"str", "str | None", "bool", "int", "tuple[str, ...]"}


def canonical(value: Any) -> Any:
    """Return data in which every number is a ``float`` or ``complex`` without −0.0.

    What is so already is returned itself.

    Examples
    --------
    >>> canonical((-0.0, complex(-0.0, 2.0), "−0"))
    (0.0, 2j, '−0')
    """
    return _way(value.__class__)(value)


@cache
def _way(cls: Any) -> Callable[[Any], Any]:
    """Return how data of a type become canonical."""
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
    if type(value) is float and (value or copysign(1.0, value) > 0.0):
        return value
    return float(value) + 0.0


def _complex(value: complex) -> complex:
    x, y = value.real, value.imag
    if type(value) is complex and (x or copysign(1.0, x) > 0.0) and (y or copysign(1.0, y) > 0.0):
        return value
    return complex(x + 0.0, y + 0.0)


def _tuple(value: tuple[Any, ...]) -> tuple[Any, ...]:
    new = tuple([_way(each.__class__)(each) for each in value])
    return new if any(map(is_not, new, value)) else value


def _record(cls: Any) -> Callable[[Any], Any]:
    """Return how a dataclass becomes canonical: made anew if a number differs."""
    every = [field.name for field in fields(cls)]
    names = [field.name for field in fields(cls) if field.type not in _WORDS]

    def record(value: Any) -> Any:
        for name in names:
            held = getattr(value, name)
            if held is not None and _way(held.__class__)(held) is not held:
                return cls(*[canonical(getattr(value, name)) for name in every])
        return value

    return record
