"""A load as a table over the driver's place: an indicator card, or a cutting force."""

from __future__ import annotations

import csv
import math
from itertools import pairwise
from typing import Any

import numpy as np

from vad.errors import InputError, UsageError, quoted
from vad.kinematics.numbers import Number, fold, minimum, not_below, positive, select, traced
from vad.units import number_of

#: The most rows of a table, and the most characters of its text.
MOST_ROWS, LONGEST_TABLE = 20_000, 1_000_000
_HINT = "two columns: the driver's place, and the load there"

Table = tuple[tuple[float, ...], tuple[float, ...]]


def table_of(text: str, name: str) -> Table:
    r"""Return the places and the loads of a table in CSV.

    Its columns are parted by commas, semicolons or tabs.  A first line of names is passed over, and
    so is what begins with #.

    Raises
    ------
    vad.errors.InputError
        With the line, for what is no table of two columns of numbers.

    Examples
    --------
    >>> table_of("angle,force\n0,10\n180,20\n", "card.csv")
    ((0.0, 180.0), (10.0, 20.0))
    """
    rows: list[tuple[float, float]] = []
    begun = False
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        sign = next((each for each in (";", "\t") if each in line), ",")
        cells = [cell.strip() for cell in next(csv.reader([line], delimiter=sign))]
        where = f"{name}, line {number}"
        if len(cells) != 2:
            raise InputError(f"{where}: has {len(cells)} columns, not two", _HINT)
        try:
            row = tuple(float(cell) for cell in cells)
        except ValueError:
            if begun:
                raise InputError(f"{where}: {quoted(line)} is no pair of numbers", _HINT) from None
            begun = True
            continue
        begun = True
        rows.append((row[0], row[1]))
        if len(rows) > MOST_ROWS:
            raise InputError(f"{name}: has more than {MOST_ROWS} rows")
    return checked_table(name, tuple(x for x, _ in rows), tuple(y for _, y in rows))


def checked_table(name: str, places: Any, values: Any) -> Table:
    """Return a table whose numbers are finite, and whose places ascend."""
    columns = [
        each if isinstance(each, list | tuple | np.ndarray) else () for each in (places, values)
    ]
    if len(columns[0]) != len(columns[1]) or len(columns[0]) < 2:
        raise InputError(f"{name}: a table needs two rows or more", _HINT)
    pairs = [[number_of(name, each, "number") for each in column] for column in columns]
    for before, after in zip(pairs[0], pairs[0][1:], strict=False):
        if not before < after:
            raise InputError(f"{name}: its places must ascend, but {after:g} follows {before:g}")
    return tuple(pairs[0]), tuple(pairs[1])


def at_table(table: Table, place: Number, period: float | None) -> Number:
    """Return the load at places of the driver, on straight lines between the rows.

    Parameters
    ----------
    table
        Places and loads.
    place
        The place of the driver, or an array of them.
    period
        The turn after which a table over an angle begins again; None for a length.

    Raises
    ------
    vad.errors.InputError
        For one place beyond a table over a length; in an array it is NaN.
    """
    if traced([place]):
        return _traced(table, place, period)
    places, values = (np.array(column) for column in table)
    asked = np.asarray(place, dtype=float)
    if period is not None:
        # Two turns of a four-stroke engine are one period.
        period *= max(1, math.ceil((places[-1] - places[0]) / period - 1e-9))
        if places[-1] - places[0] < period:
            places = np.append(places, places[0] + period)
            values = np.append(values, values[0])
        asked = places[0] + np.mod(asked - places[0], period)
    # Beyond an end, and for NaN, there is no load.
    known = (asked >= places[0]) & (asked <= places[-1])
    if not asked.ndim and not known and np.isfinite(asked):
        reach = f"{places[0]:g} to {places[-1]:g}"
        raise InputError(f"table: reaches from {reach}, and the driver is at {float(asked):g}")
    row = np.clip(np.searchsorted(places, asked, side="right") - 1, 0, places.size - 2)
    share = (asked - places[row]) / (places[row + 1] - places[row])
    found = np.where(known, values[row] + share * (values[row + 1] - values[row]), np.nan)
    return found if asked.ndim else float(found)


def _traced(table: Table, place: Number, period: float | None) -> Number:
    """Return the load at a traced place: the first load, and what each row adds up to there."""
    places, values = (list(column) for column in table)
    gone = place - places[0] if period is None else positive(fold(place - places[0]))
    if period is not None and places[-1] - places[0] < period:
        places.append(places[0] + period)
        values.append(values[0])
    found: Number = values[0]
    for (low, before), (high, after) in pairwise(zip(places, values, strict=True)):
        within = minimum(not_below(0.0, gone - (low - places[0])), high - low)
        found = found + within * ((after - before) / (high - low))
    if period is None:  # beyond its ends there is no load
        reach = places[-1] - places[0]
        found = select((gone < 0.0) | (gone > reach), math.nan, found)
    return found


def unit_of(name: str, unit: object, quantity: str) -> float:
    """Return how many of the program's own unit one ``unit`` of a table has."""
    if not isinstance(unit, str) or not unit.strip():
        raise UsageError(f"{name}: must be the name of a unit, got {quoted(unit)}", "as in 'kN'")
    return number_of(name, f"1 {unit}", quantity)
