"""The table of the largest errors: its poses give its figures, and the page shows them."""

from __future__ import annotations

import json

import gmpy2
import pytest

from benchmarks.errors import table
from benchmarks.errors.__main__ import KINDS, MECHANISMS
from benchmarks.errors.tally import Tally
from docs.made import made_pages
from tests.kinematics.worst_cases import BOUNDS

LINES = [line for line in table.read() if line.where]


def measured(line: table.Line) -> float:
    """Return the error of a line's pose in ε·κ."""
    (kind,) = (kind for kind, names in MECHANISMS.items() if line.mechanism in names)
    module, tally = KINDS[kind], Tally(exactly=True)
    with gmpy2.context(gmpy2.get_context(), trap_divzero=True):
        module.compare(tally, *module.again(line.mechanism, json.loads(line.where)))
    return tally.records[line.mechanism, line.part, line.quantity].worst


def test_it_has_every_mechanism_and_every_bound() -> None:
    assert {line.mechanism for line in LINES} == set.union(*MECHANISMS.values())
    assert {line.quantity: int(line.bound) for line in LINES} == BOUNDS


@pytest.mark.exhaustive(80)
@pytest.mark.parametrize("line", LINES, ids=lambda line: " ".join(line[:3]))
def test_a_pose_gives_the_error_of_the_table(line: table.Line) -> None:
    """On another processor sine and cosine may differ in their last bit."""
    assert measured(line) == pytest.approx(float(line.error), rel=0.01, abs=0.5)


def test_the_page_shows_every_line() -> None:
    page = made_pages()["reference/errors.md"]
    for line in table.read():
        assert f"| {line.part} {line.quantity} | {line.error} | {line.bound} |" in page
