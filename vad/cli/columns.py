"""``vad sweep --over --columns``: chosen results over a dimension or a turn, for any file."""

from __future__ import annotations

import io
from dataclasses import fields, replace
from typing import Any

import click
import numpy as np
from numpy.typing import NDArray

import vad
from vad import units
from vad.batches.columns import columns_of
from vad.cli.options import flag, take_burden
from vad.cli.output import say_written
from vad.cli.places import sweep_places
from vad.errors import DeadCentreError, UsageError, quoted, unknown
from vad.export import table_csv
from vad.export.sweep import Column, Table, check_closes, save_table
from vad.mechanisms import Mechanism
from vad.merits.named_pins import rubbing_names
from vad.units import DIMENSIONS, scene_unit

_MOST = 1_000_000


def chosen_columns(
    mechanism: Mechanism,
    inputs: dict[str, Any],
    output: str,
    over: str | None = None,
    columns: tuple[str, ...] = (),
    look: dict[str, Any] | None = None,
    pin: dict[str, float] | None = None,
    **ends: Any,
) -> None:
    """Write chosen columns to a file, whose extension chooses the format, or as CSV for ``-``."""
    burden = take_burden(mechanism, ends)
    if over is None:
        name, places = next(iter(mechanism.inputs)), sweep_places(mechanism, **ends)
        swept, given = mechanism, inputs | {name: places}
        kind = name
    else:
        name, kind, places = _read(mechanism, over)
        if ends:
            first = next(iter(ends))
            wrong = {"start": "from", "stop": "to"}.get(first, first)
            hint = f"--{next(iter(mechanism.inputs))} chooses the pose"
            raise UsageError(f"{flag(wrong)} does not go with --over", hint)
        varied: dict[str, Any] = {name: places}
        swept, given = replace(mechanism, **varied), inputs
    pins = pin or {}
    rubs = rubbing_names(vad.solve(mechanism), pins)
    names = (*(columns or _all(mechanism)), *rubs)
    loads, masses, gravity, friction = burden or ((), None, None, None)
    bears: dict[str, Any] = {"loads": loads, "masses": masses}
    bears |= {"gravity": gravity, "friction": friction}
    try:
        found = vad.sweep(swept, names, pins=pins, **bears, **given)
    except UsageError as wrong:
        if not str(wrong).startswith(("results: ", "unknown result ")):
            raise
        raise UsageError(f"--columns: {str(wrong).removeprefix('results: ')}", wrong.hint) from None
    listed = columns_of(mechanism, found, burden)
    motion = vad.solve(swept, **given)
    if not any(np.isfinite(column.values).any() for column in listed):
        check_closes(bool(np.any(motion.assembled)))
        message = f"--columns: none of these poses has a value of {', '.join(names)}"
        raise DeadCentreError(message, "the links close; other poses may have one")
    along = Column(name, scene_unit(kind, mechanism.length_unit), places)
    table = Table(motion, along, tuple(listed))
    if output == "-":
        stream = io.BytesIO()
        table_csv.write(table, stream)
        click.echo(stream.getvalue().decode(), nl=False)
        return
    save_table(table, output, **(look or {}))
    say_written(output)


def _read(mechanism: Mechanism, over: str) -> tuple[str, str, NDArray[np.float64]]:
    """Read the dimension that varies, what it is, and its numbers."""
    words, hint = over.split(), "as in --over 'crank 20 60 41'"
    if len(words) != 4:
        raise UsageError(f"--over: {quoted(over)} is no range of a dimension", hint)
    known = {
        each.name: each.metadata["quantity"]
        for each in fields(mechanism)
        if each.metadata["quantity"] in DIMENSIONS
    }
    name = words[0].replace("-", "_")
    if name not in known:
        wrong = unknown("dimension", words[0], known)
        raise UsageError(f"--over: {wrong}", wrong.hint)
    kind = str(known[name])
    if not words[3].isdecimal() or not 2 <= int(words[3]) <= _MOST:
        raise UsageError(f"--over: steps must be from 2 to {_MOST}, got {quoted(words[3])}", hint)
    unit, what = mechanism.length_unit, f"--over: {words[0]}"
    low, high = (units.number_of(what, word, kind, unit) for word in words[1:3])
    return name, kind, np.linspace(low, high, int(words[3]))


def _all(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the results of all links and slides in the plane, and those of other mechanisms."""
    motion = vad.solve(mechanism)
    return tuple(
        name
        for name, (kind, part, quantity) in motion.results.items()
        if kind in ("link", "slide", "joint")
        and (quantity != "coriolis" or motion.solver.on_turning_link(part))
    )
