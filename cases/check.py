"""How far a program's answers are from the truth: ``python cases/check.py four-bar answers.csv``.

One plain file: it needs Python 3.10 or newer, and the data that lie beside it; no package.  The
answers are a CSV file with a column ``case`` and any columns of the results, by the same names;
cells may be empty.  Printed is, for each result, how many answers there are, the largest error in
units of ε·κ with its case, and the largest in units in the last place.  README.md says what all
that is.

It ends with 0 if every answer is within the bounds, and with 1 if one is not.
"""

from __future__ import annotations

import argparse
import csv
import lzma
import math
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation, localcontext
from pathlib import Path

HERE = Path(__file__).parent
MECHANISMS = sorted(path.name[: -len(".csv.xz")] for path in HERE.glob("*.csv.xz"))
EPSILON = Decimal(2) ** -52
#: In ε·κ, by the quantity.
BOUNDS = {
    "angle": 2,
    "position": 2,
    "omega": 4,
    "velocity": 4,
    "coriolis": 8,
    "acceleration": 8,
    "alpha": 64,
}
KAPPA = "kappa "
Row = Mapping[str, str]


@dataclass
class Found:
    """What is found of one result."""

    answers: int = 0
    beyond: int = 0
    worst: float = 0.0
    case: str = ""
    ulps: float = 0.0


def cases(mechanism: str) -> Iterator[Row]:
    """Yield the cases of a mechanism as rows by column."""
    with lzma.open(HERE / f"{mechanism}.csv.xz", "rt", encoding="utf-8", newline="") as file:
        yield from csv.DictReader(file)


def results(row: Row) -> dict[str, list[str]]:
    """Return the results that a case has, each with its columns: one, or those of a vector."""
    found: dict[str, list[str]] = {}
    for column, text in row.items():
        if column.startswith(KAPPA) and text:
            name = column[len(KAPPA) :]
            parts = [f"{name}.{axis}" for axis in "xyz" if f"{name}.{axis}" in row]
            found[name] = parts or [name]
    return found


def number(text: str) -> Decimal:
    """Return the number of a cell; what is none counts as not a number."""
    try:
        return Decimal(text or "nan")
    except InvalidOperation:
        return Decimal("nan")


def quantity(result: str) -> str:
    """Return which quantity a result is: the second word of its name."""
    return result.split(".")[1]


def miss(result: str, true: Decimal, answer: Decimal) -> Decimal:
    """Return how far an answer is off; an angle the short way round."""
    off = answer - true
    return off - 360 * (off / 360).to_integral_value() if quantity(result) == "angle" else off


def ulp(true: Decimal) -> Decimal:
    """Return the distance of doubles next to a true number."""
    return Decimal(math.ulp(float(true)))


def check(truths: Iterable[Row], answers: Iterable[Row]) -> dict[str, Found]:
    """Compare answers with the cases of the same number, result by result."""
    given = {row.get("case"): row for row in answers}
    found: dict[str, Found] = {}
    with localcontext() as context:
        context.prec = 60
        for row in truths:
            for result, columns in results(row).items():
                texts = [
                    (given.get(row["case"], {}).get(column) or "").strip() for column in columns
                ]
                if any(texts):
                    _compare(found.setdefault(result, Found()), result, row, columns, texts)
    return found


def _compare(found: Found, result: str, row: Row, columns: list[str], texts: list[str]) -> None:
    found.answers += 1
    size, ulps = math.inf, math.inf
    numbers = [number(text) for text in texts]
    if all(x.is_finite() for x in numbers):
        true = [Decimal(row[column]) for column in columns]
        off = [miss(result, *pair) for pair in zip(true, numbers, strict=True)]
        whole = sum(x * x for x in off).sqrt()
        scale = EPSILON * Decimal(row[KAPPA + result])
        size = float(whole / scale) if scale else 0.0 if not whole else math.inf
        ulps = max(float(abs(x) / ulp(t)) for x, t in zip(off, true, strict=True))
    found.ulps = max(found.ulps, ulps)
    found.beyond += size > BOUNDS[quantity(result)]
    if size > found.worst:
        found.worst, found.case = size, row["case"]


def report(found: Mapping[str, Found]) -> str:
    """Return a table of what is found."""
    head = f"{'result':28}{'answers':>8}{'beyond':>8}{'ε·κ':>10}{'bound':>7}{'case':>7}{'ulps':>10}"
    lines = [
        f"{name:28}{each.answers:8}{each.beyond:8}{each.worst:10.3g}{BOUNDS[quantity(name)]:7}"
        f"{each.case:>7}{each.ulps:10.3g}"
        for name, each in found.items()
    ]
    return "\n".join([head, *lines])


def main() -> int:
    """Check a file of answers."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mechanism", choices=MECHANISMS)
    parser.add_argument("answers", help="a CSV file; - is standard input")
    parser.add_argument("--kind", help="only cases of one kind, such as ordinary")
    given = parser.parse_args()
    truths = [row for row in cases(given.mechanism) if given.kind in (None, row["kind"])]
    with open(0 if given.answers == "-" else given.answers, encoding="utf-8", newline="") as file:
        found = check(truths, csv.DictReader(file))
    if not found:
        print(
            "no answer to any of the cases: are the columns named as in README.md?", file=sys.stderr
        )
        return 1
    print(report(found))
    return int(any(each.beyond for each in found.values()))


if __name__ == "__main__":
    sys.exit(main())
