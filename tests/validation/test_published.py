"""The published examples: the program agrees with their exact recomputation, and with the books."""

from __future__ import annotations

from typing import Any

import pytest

import vad
from tests.validation.published import CASES, Scene, ladder_driven_by_its_link, misses, scene

EXACT = {"rel": 1e-12, "absolute": 1e-9}


def each(cases: list[dict[str, Any]]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("case", cases, ids=[case["id"] for case in cases])


def scene_or_skip(case: dict[str, Any]) -> Scene:
    found = scene(case)
    if found is None:
        pytest.skip(f"{case['id']}: no such mechanism in the program ({case['mechanism']})")
    return found


def solve(found: Scene) -> vad.Motion:
    cls = vad.MECHANISMS[found.name]
    return vad.solve(cls(**found.parameters, assembly=found.assembly), **found.inputs)


@each(CASES)
def test_exact_answers(case: dict[str, Any]) -> None:
    found = scene_or_skip(case)
    wanted = {**case["exact"], **found.given_back}
    assert not misses(found.results(solve(found)), wanted, **EXACT)


@each(CASES)
def test_printed_answers(case: dict[str, Any]) -> None:
    found = scene_or_skip(case)
    if case["from_memory"]:
        pytest.skip(f"{case['id']}: the statement is quoted from memory, only `exact` counts")
    if case["layout_fitted"]:
        pytest.skip(f"{case['id']}: the layout is not published ({case['layout_fitted']})")
    measured = found.results(solve(found))
    assert not misses(measured, case["expected"], rel=case["rel_tol"], absolute=0.0)


@each([case for case in CASES if ladder_driven_by_its_link(case)])
def test_ladders_driven_by_their_link(case: dict[str, Any]) -> None:
    found = ladder_driven_by_its_link(case)
    assert found is not None
    measured = found.results(solve(found))
    wanted = {k: v for k, v in case["exact"].items() if k in measured}
    assert not misses(measured, {**wanted, **found.given_back}, **EXACT)
