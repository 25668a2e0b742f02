"""The public cases: complete, right, and a checker that sees a fault."""

from __future__ import annotations

import csv
import itertools
import subprocess
import sys
from decimal import Decimal
from pathlib import Path
from typing import Any

import gmpy2
import pytest

import vad
from benchmarks.errors import plane, space

pytest.importorskip("cases", reason="the cases are in the repository alone")

from cases import make
from cases.answer import answers
from cases.check import HERE, MECHANISMS, cases, check, results


def few(mechanism: str, step: int = 70) -> list[dict[str, str]]:
    """Return every so manieth case of a mechanism."""
    return [dict(row) for row in itertools.islice(cases(mechanism), 0, None, step)]


def test_every_mechanism_has_its_cases_and_they_are_small() -> None:
    assert set(MECHANISMS) == set(vad.MECHANISMS)
    assert sum(path.stat().st_size for path in HERE.glob("*.xz")) < 20e6


@pytest.mark.exhaustive
@pytest.mark.parametrize("mechanism", MECHANISMS)
def test_there_are_enough_and_hard_ones_are_marked(mechanism: str) -> None:
    rows = list(cases(mechanism))
    assert len(rows) >= 1700
    assert [row["case"] for row in rows] == [str(n) for n in range(1, len(rows) + 1)]
    kinds = [row["kind"] for row in rows]
    assert 0.3 < kinds.count("ordinary") / len(rows) < 0.6
    assert len(set(kinds)) >= 3


@pytest.mark.exhaustive
@pytest.mark.parametrize("mechanism", MECHANISMS)
def test_the_program_passes(mechanism: str) -> None:
    rows = few(mechanism)
    found = check(rows, answers(mechanism, rows))
    assert found
    assert {name: each.worst for name, each in found.items() if each.beyond} == {}
    assert max(each.answers for each in found.values()) == len(rows)


@pytest.mark.exhaustive
@pytest.mark.parametrize("mechanism", MECHANISMS)
def test_thirty_digits_are_those_of_a_thousand_bits(mechanism: str) -> None:
    """They were rounded from fewer bits."""
    module: Any = space if mechanism in space.KINDS else plane
    truth = space.SpaceTruth if module is space else plane.PlaneTruth
    names = [*vad.MECHANISMS[mechanism]().parameters(), *vad.MECHANISMS[mechanism].inputs]
    with gmpy2.context(gmpy2.get_context(), trap_divzero=True, precision=1000):
        for row in few(mechanism, 350):
            optional = {"rod", "ram_height", "ground_angle"}
            numbers = {x: float(row[x]) for x in {*names, *optional} if row.get(x)}
            _, pose = module.again(mechanism, numbers | {"assembly": row["assembly"]})
            found = dict(make.columns(truth(pose), make.driven(mechanism)))
            assert {x: row[x] for x in found} == found


@pytest.mark.parametrize("fault", ["", "nan", "text"])
def test_the_checker_sees_a_planted_fault(fault: str) -> None:
    """One answer of 25 is wrong in its tenth digit, or is no number."""
    rows = few("four-bar")
    given = list(answers("four-bar", rows))
    wrong = Decimal(given[3]["rocker.omega"]) * (1 + Decimal("1e-9"))
    given[3]["rocker.omega"] = fault or str(wrong)
    found = check(rows, given)
    assert found["rocker.omega"].beyond == 1
    assert found["rocker.omega"].case == rows[3]["case"]
    assert sum(each.beyond for each in found.values()) == 1


def test_an_angle_is_measured_the_short_way_round() -> None:
    rows = few("four-bar")
    given = list(answers("four-bar", rows))
    for answer in given:
        answer["rocker.angle"] = repr(float(answer["rocker.angle"]) - 360.0)
    assert check(rows, given)["rocker.angle"].ulps < 1e12


def test_the_checker_is_a_program_without_any_package(tmp_path: Path) -> None:
    rows = list(itertools.islice(cases("scotch-yoke"), 40))
    path = tmp_path / "answers.csv"
    with path.open("w", newline="") as file:
        columns = ["case", "yoke.position", "C.velocity.x", "C.velocity.y"]
        writer = csv.DictWriter(file, columns, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(answers("scotch-yoke", rows))
    command = [sys.executable, "-I", "-S", str(HERE / "check.py"), "scotch-yoke", str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    assert "yoke.position" in done.stdout
    path.write_text("case,yoke.position\n1,0.5\n")
    assert subprocess.run(command, capture_output=True, check=False, timeout=60).returncode == 1
    path.write_text("number,yoke\n1,0.5\n")
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 1
    assert "columns" in done.stderr


def test_the_description_names_every_kind_of_column() -> None:
    text = (HERE / "README.md").read_text("utf-8")
    for mechanism in MECHANISMS:
        assert f"| `{mechanism}` |" in text
        for name in results(next(cases(mechanism))):
            quantity = name.split(".")[1]
            assert f".{quantity}" in text
    assert "CC0 1.0" in text
