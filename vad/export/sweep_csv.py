"""A sweep as a table: a line for each pose, with every digit.

Poses are solved and written block by block, so that a long sweep takes no more memory than a short
one.  orjson writes an array ten times as fast as `repr` writes its numbers, with the same digits.
Where their notations differ, and where a cell is empty, a gap is left in the array and filled in.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, zip_longest
from typing import Any, BinaryIO

import numpy as np
import orjson
from numpy.typing import NDArray

from vad.export.sweep import Results, check_closes, results_of
from vad.kinematics.motion import Motions, solve
from vad.statics.burden import Burden

#: How many poses are a block: its arrays fit into a processor's cache.
_BLOCK = 10_000
#: From the first of these sizes to below the second, and for zero, both write the same.
_ALIKE = 1e-4, 1e16
_GAP = b"null"


def write(motion: Motions, target: BinaryIO, burden: Burden | None = None) -> None:
    """Write the results of a motion, and its forces; a cell is empty where there is none.

    Raises
    ------
    vad.errors.AssemblyError
        If none of the poses can be assembled.
    """
    assembled = False
    for place, block in enumerate(_blocks(motion)):
        results = results_of(block, burden)
        if place == 0:
            target.write(_head(results).encode())
        columns = [column.values for row in results.rows for column in row.columns]
        target.write(written([results.place.values, *columns]))
        assembled = assembled or bool(np.any(block.assembled))
    check_closes(assembled)


def _blocks(motion: Motions) -> Iterator[Motions]:
    """Yield the motion of one block of poses after the other."""
    (name, places), *rates = motion.inputs.items()
    for start in range(0, len(places), _BLOCK):
        inputs: dict[str, Any] = {name: places[start : start + _BLOCK], **dict(rates)}
        yield solve(motion.mechanism, **inputs)


def _head(results: Results) -> str:
    """Return the line of the names."""
    place = results.place
    heads = [f"{place.quantity} [{place.unit}]"]
    for row in results.rows:
        heads += [
            f"{row.name} {column.quantity}".rstrip() + f" [{column.unit}]" for column in row.columns
        ]
    return ",".join(heads) + "\n"


def written(columns: Sequence[NDArray[np.float64]]) -> bytes:
    r"""Return the lines of columns, every number as `repr` writes it, and nothing for NaN.

    Examples
    --------
    >>> written([np.array([0.5, -0.0, np.nan]), np.array([1e-5, 1e16, 3.0])])
    b'0.5,1e-05\n0.0,1e+16\n,3.0\n'
    """
    table = np.column_stack(columns) + 0.0  # minus zero becomes zero
    size = np.abs(table)
    differs = ~(size < _ALIKE[1]) | ((size < _ALIKE[0]) & (size > 0.0))
    gaps = table[differs].tolist()
    table[differs] = np.nan
    text = bytearray(orjson.dumps(table.ravel(), option=orjson.OPT_SERIALIZE_NUMPY))
    letters = np.frombuffer(text, np.uint8)
    commas = np.flatnonzero(letters == ord(","))
    letters[commas[len(columns) - 1 :: len(columns)]] = letters[-1] = ord("\n")
    lines = bytes(memoryview(text)[1:])
    if not gaps:
        return lines
    cells = [b"" if value != value else repr(value).encode() for value in gaps]
    return b"".join(chain.from_iterable(zip_longest(lines.split(_GAP), cells, fillvalue=b"")))
