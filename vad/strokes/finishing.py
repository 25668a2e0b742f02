"""From what was drawn to what stands on a sheet: numbers are written, and what is noise is zero."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from vad.strokes.canonical import canonical
from vad.strokes.sentences import Text, Voice
from vad.strokes.sheet import Cell, Equation, Panel, Row, Stroke, Term
from vad.strokes.vector_equations import NOTHING


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
        return Text.of(label.said, voice) if isinstance(label, Text) else label

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
