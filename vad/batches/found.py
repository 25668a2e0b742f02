"""Further answers of a sheet: what its motion alone does not say.

These are the numbers that balance a shaft, what figures upon the mechanism find, and the columns
for which a file of sheets asks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from vad.balancing.results import results
from vad.batches.columns import columns_of
from vad.batches.sweep import sweep
from vad.kinematics.centres import Centres
from vad.kinematics.motion import Motion
from vad.statics.forces import Forces
from vad.strokes.body_names import BodyNames
from vad.strokes.draw import scene_of
from vad.strokes.sheet import Sheet
from vad.units import scene_unit
from vad.words import Language

Answer = tuple[str, float, str]


def further_answers(
    pose: Motion | Forces[Any, Any, Any], sheet: Sheet, columns: Sequence[str]
) -> list[dict[str, Any]]:
    """Return further answers of a sheet: the ``name``, ``value`` and ``unit`` of each.

    A value is None where there is none, such as the stroke of a lever that goes round.

    Parameters
    ----------
    pose
        What is drawn.
    sheet
        The drawing.
    columns
        The names of results and figures of merit, as for `vad.sweep`.

    Raises
    ------
    vad.errors.UsageError, vad.errors.InputError
        For a column that there is not.
    """
    motion = pose.motion if isinstance(pose, Forces) else pose
    balancing = motion.mechanism.balancing(motion)
    answers: list[Answer] = []
    if balancing is not None:
        answers += [(each.name, each.value, each.unit) for each in results(balancing).values()]
    if any(panel.name == "klein" for panel in sheet.panels):
        answers += _of_klein(sheet)
    if any(panel.name == "centres" for panel in sheet.panels):
        answers += _of_centres(motion, sheet)
    answers += _of_columns(pose, columns)
    return [
        {"name": name, "value": value if math.isfinite(value) else None, "unit": unit}
        for name, value, unit in dict.fromkeys(answers)
    ]


def _of_klein(sheet: Sheet) -> Iterator[Answer]:
    """Yield the lengths of the sides that Klein's construction finds."""
    for row in sheet.rows:
        for cell in row.cells.get("klein", ()):
            if not cell.given:
                yield cell.symbol, cell.value, cell.unit


def _of_centres(motion: Motion, sheet: Sheet) -> Iterator[Answer]:
    """Yield the places of the centres that are drawn; of one far away, its direction."""
    scene: Any = scene_of(motion, Language(sheet.language, sheet.names))
    centres = Centres(motion)
    names = BodyNames(scene, centres.kennedy.bodies.bodies)
    drawn = {stroke.part.of for stroke in sheet.panel("centres").strokes}
    for pair in centres.kennedy.found:
        name = names.plain_centre(pair)
        if name not in drawn:
            continue
        at = centres.at(*pair)
        if at is None:
            yield f"{name} direction", centres.far(*pair), scene_unit("angle")
        else:
            yield f"{name} x", at.real, motion.mechanism.length_unit
            yield f"{name} y", at.imag, motion.mechanism.length_unit


def _of_columns(pose: Motion | Forces[Any, Any, Any], columns: Sequence[str]) -> Iterator[Answer]:
    """Yield the columns for which a file of sheets asks."""
    if not columns:
        return
    motion = pose.motion if isinstance(pose, Forces) else pose
    burden = pose.burden if isinstance(pose, Forces) else None
    inputs: dict[str, Any] = {name: float(value) for name, value in motion.inputs.items()}
    found = sweep(motion.mechanism, columns, **(vars(burden) if burden else {}), **inputs)
    for column in columns_of(motion.mechanism, np.atleast_1d(found), burden):
        yield column.quantity, float(column.values[0]), column.unit
