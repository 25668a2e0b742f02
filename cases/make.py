"""Make the cases: ``python -m cases.make [MECHANISM ...]`` writes a file for each mechanism.

The poses are those of ``benchmarks.errors``, and so is the truth.  It is found with 333 and with
600 bits, and a case is kept if all thirty digits of all its results are the same.
"""

from __future__ import annotations

import csv
import io
import lzma
import sys
from collections import Counter
from collections.abc import Iterator
from operator import itemgetter
from pathlib import Path
from typing import Any, NamedTuple

import gmpy2
import numpy as np

import vad
from benchmarks.errors import plane, space
from benchmarks.errors.tally import EPSILON, LEAST_RATE
from benchmarks.errors.truth import BITS, LAST_DIGIT, Truth, parts_of
from tests.oracle import Key, UnassemblableError
from vad.kinematics.closed_forms import OpenLoopError

HERE = Path(__file__).parent
COUNT, ORDINARY = 1750, 0.4
SEED = 2024
MORE = 600
#: Digits of results and of κ.
DIGITS, FEW = 30, 4
#: Beyond that, in ε·κ against itself, the rounding of the inputs alone may part the links.
DOUBTFUL = 0.01
#: What is below that part of the largest of its kind, and whose κ is so, too, is nothing.
NOTHING = 1e-25
KINDS = {
    "random": "ordinary",
    "toggle": "near toggle",
    "deep": "very near",
    "unequal": "long and short links",
    "scale 1e-170": "tiny",
    "scale 1e170": "huge",
    "rates": "slow or fast",
    "axes nearly parallel": "near parallel axes",
}
Row = dict[str, str]


def rows(name: str) -> Iterator[Row]:
    """Yield the cases of a mechanism."""
    ordinary = hard = 0
    most = round(COUNT * ORDINARY)
    for family, pose in (space if name in space.KINDS else plane).poses(SEED):
        if pose.name != name or (ordinary >= most if family == "random" else hard >= COUNT - most):
            if ordinary + hard >= COUNT:
                return
            continue
        results = _results(pose)
        if results is None:
            continue
        ordinary, hard = ordinary + (family == "random"), hard + (family != "random")
        kind = KINDS.get(family, family)
        yield {"case": str(ordinary + hard), "kind": kind, **_given(pose), **results}


def _given(pose: Any) -> Row:
    numbers = pose.given if isinstance(pose, space.Drawn) else plane.given(pose)
    return {name: str(x) for name, x in numbers.items()}


def _results(pose: Any) -> Row | None:
    """Return all results with thirty digits, or nothing if it does not close or is in doubt."""
    kind = space.SpaceTruth if isinstance(pose, space.Drawn) else plane.PlaneTruth
    try:
        vad.MECHANISMS[pose.name](**_options(pose))
        gmpy2.get_context().precision = BITS
        truth = kind(pose)
        if 0 < abs(truth.drive.rate) < LEAST_RATE or _is_doubtful(truth):
            return None
        given = driven(pose.name)
        kappas = dict(_kappas(truth, given))
        found = dict(columns(truth, given))
        gmpy2.get_context().precision = MORE
        if dict(columns(kind(pose), given)) != found:
            return None
    except (UnassemblableError, OpenLoopError, ArithmeticError, vad.VadError):
        return None
    except plane.ExactDeadCentreError:
        return None
    return found | kappas


def _options(pose: Any) -> dict[str, Any]:
    sizes = pose.sizes if isinstance(pose, space.Drawn) else pose.parameters
    return {**sizes, "assembly": pose.assembly}


def _is_doubtful(truth: Truth) -> bool:
    rates = [key for key in truth.values if key[2] in ("omega", "velocity")]
    return any(
        EPSILON * truth.kappa(key, part) > DOUBTFUL * truth.largest[key[2]]
        for key in rates
        for part in parts_of(key, truth.values[key])
    )


class Result(NamedTuple):
    """What has one condition number: a number, a coordinate, or a vector with its coordinates."""

    name: str
    kappa: Any
    least: Any
    numbers: dict[str, Any]


def _reported(truth: Truth, given: set[tuple[str, str]]) -> Iterator[Result]:
    """Yield the results that are not given, and not zero whatever moves a little."""
    for key, value in truth.values.items():
        if (key[1], key[2]) in given:
            continue
        name, largest = f"{key[1]}.{key[2]}", truth.largest[key[2]]
        unit = 180 / gmpy2.const_pi() if key[2] == "angle" else 1
        axes = _coordinates(key, value)
        numbers = {name + axis: x * unit for axis, x in axes.items()}
        parts = parts_of(key, value)
        groups = [numbers] if len(parts) == 1 else [{name: x} for name, x in numbers.items()]
        for part, group in zip(parts, groups, strict=True):
            kappa = truth.kappa(key, part)
            if max(abs(part(value)), kappa) > NOTHING * largest:
                whole = name if len(parts) == 1 else next(iter(group))
                yield Result(whole, kappa * unit, LAST_DIGIT * largest, group)


def _coordinates(key: Key, value: Any) -> dict[str, Any]:
    if isinstance(value, np.ndarray):
        return dict(zip((".x", ".y", ".z"), value, strict=True))
    return {".x": value.real, ".y": value.imag} if key[0] == "point" else {"": value}


def columns(truth: Truth, given: set[tuple[str, str]]) -> Iterator[tuple[str, str]]:
    """Yield the columns of all results with thirty digits; what is ``given`` has none."""
    for result in _reported(truth, given):
        for name, x in result.numbers.items():
            yield name, _text(x, result.least, DIGITS)


def _kappas(truth: Truth, given: set[tuple[str, str]]) -> Iterator[tuple[str, str]]:
    for result in _reported(truth, given):
        yield f"kappa {result.name}", _text(result.kappa, 0, FEW)


def driven(name: str) -> set[tuple[str, str]]:
    """Return the results that are inputs: a crank's angle is folded, and so it is none."""
    driver: Any = vad.MECHANISMS[name]().linkage().driver
    if driver.kind == "angle":
        return {(driver.name, "omega"), (driver.name, "alpha")}
    return {(driver.name, each) for each in ("position", "velocity", "acceleration")}


def _text(number: Any, least: float, digits: int) -> str:
    """Return a number with so many digits, without zeros at its end."""
    if not abs(number) > least:
        return "0"
    mantissa, _, power = f"{number:.{digits - 1}e}".partition("e")
    return f"{mantissa.rstrip('0').rstrip('.')}e{int(power)}"


def write(name: str) -> int:
    """Write the file of a mechanism and return its size in bytes."""
    found = list(rows(name))
    names = dict.fromkeys(column for row in found for column in row)
    given = ("case", "kind", *vad.MECHANISMS[name]().parameters(), "ram_height", "rod", "assembly")
    order = sorted(names, key=lambda x: (x.startswith("kappa "), "." in x, x not in given))
    text = io.StringIO()
    writer = csv.DictWriter(text, order, restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(found)
    packed = lzma.compress(text.getvalue().encode(), preset=9 | lzma.PRESET_EXTREME)
    (HERE / f"{name}.csv.xz").write_bytes(packed)
    kinds = Counter(map(itemgetter("kind"), found))
    print(f"{name}: {len(found)} cases, {len(packed) / 1e6:.2f} MB, {dict(kinds)}")
    return len(packed)


def main() -> None:
    """Write the files of the mechanisms that are named, or of all."""
    with gmpy2.context(gmpy2.get_context(), trap_divzero=True):
        for name in sys.argv[1:] or vad.MECHANISMS:
            write(name)


if __name__ == "__main__":
    main()
