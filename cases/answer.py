"""The program's own answers, as any program may give them.

``python -m cases.answer four-bar > answers.csv`` writes what ``python cases/check.py four-bar
answers.csv`` reads.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterable, Iterator
from dataclasses import fields
from typing import Any

import numpy as np

import vad
from cases.check import MECHANISMS, Row, cases, results


def answers(mechanism: str, rows: Iterable[Row]) -> Iterator[dict[str, str]]:
    """Yield the answer to each case; what the program refuses stays empty."""
    kind = vad.MECHANISMS[mechanism]
    for row in rows:
        given = {name: float(row[name]) for name in kind.inputs}
        sizes = {name: float(row[name]) for name in _sizes(kind) if row.get(name)}
        found = {"case": row["case"]}
        try:
            motion: Any = vad.solve(kind(**sizes, assembly=row["assembly"]), **given)
            for result, columns in results(row).items():
                found |= dict(zip(columns, map(repr, _numbers(motion, result)), strict=True))
        except vad.VadError as error:
            print(f"case {row['case']}: {error}", file=sys.stderr)
        yield found


def _sizes(kind: type[vad.Mechanism]) -> list[str]:
    quantities = {each.name: each.metadata["quantity"] for each in fields(kind)}
    return [name for name, quantity in quantities.items() if quantity in ("length", "angle")]


def _numbers(motion: Any, result: str) -> list[float]:
    name, quantity, *axis = result.split(".")
    part = _part(motion, name, quantity)
    value = getattr(part, quantity)
    if isinstance(value, complex):
        value = [value.real, value.imag]
    numbers = [float(x) for x in np.ravel(value)]
    return [numbers["xyz".index(*axis)]] if axis else numbers


def _part(motion: Any, name: str, quantity: str) -> Any:
    """Return a link, a joint, a slide or a point: which it is, its name and quantity tell."""
    if name in motion.links:
        slides = quantity in ("position", "velocity", "acceleration", "coriolis")
        return motion.slide(name) if slides else motion.link(name)
    if name in motion.slides:
        return motion.slide(name)
    return motion.joint(name) if quantity in ("angle", "omega", "alpha") else motion.point(name)


def main() -> None:
    """Write the answers to all cases of a mechanism."""
    if sys.argv[1:2] not in [[name] for name in MECHANISMS]:
        sys.exit(f"usage: python -m cases.answer {'|'.join(MECHANISMS)}")
    (mechanism,) = sys.argv[1:]
    found = list(answers(mechanism, cases(mechanism)))
    columns = dict.fromkeys(column for row in found for column in row)
    writer = csv.DictWriter(sys.stdout, list(columns), restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(found)


if __name__ == "__main__":
    main()
