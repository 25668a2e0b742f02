"""What a page answers is what `vad.solve` answers, with any dimensions that it takes."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser

import vad
from tests.browser import opened
from tests.page.lessons import show
from vad.errors import VadError
from vad.mechanisms import Mechanism
from vad.page.dimensions import FARTHEST
from vad.page.document import document

EXAMPLES = {
    path.stem: vad.load(str(path))
    for path in (Path(vad.__file__).parent / "examples").glob("*.toml")
}
KINDS: dict[str, Any] = {**vad.MECHANISMS, **dict(sorted(EXAMPLES.items()))}
SETS = 30
#: Of the largest number of its kind.
CLOSE = 1e-12


def numbers(found: dict[str, Any]) -> Iterator[tuple[str, str, float]]:
    """Yield the kind, the name and the value of every result."""
    for kind in ("links", "joints", "points", "slides"):
        for name, results in found.get(kind, {}).items():
            for what, value in results.items():
                several = value if isinstance(value, list) else [value]
                for number, each in enumerate(several):
                    if each is not None:
                        yield f"{kind} {what}", f"{name} {number}", each


def error(found: dict[str, Any], wanted: dict[str, Any]) -> float:
    """Return the largest difference, as a share of the largest of its kind."""
    own = {(kind, name): value for kind, name, value in numbers(found)}
    largest: dict[str, float] = {}
    for kind, _, value in numbers(wanted):
        largest[kind] = max(largest.get(kind, 1e-300), abs(value))
    worst = 0.0
    for kind, name, value in numbers(wanted):
        off = own[kind, name] - value
        if kind.endswith("angle"):
            off = math.remainder(off, 360.0)
        worst = max(worst, abs(off) / largest[kind])
    return worst


@pytest.mark.exhaustive(192)
@pytest.mark.parametrize("name", KINDS)
def test_a_page_answers_as_solve_does(name: str, browser: Browser, tmp_path: Path) -> None:
    mechanism: Mechanism = KINDS[name]()
    rng = random.Random(name)
    own = mechanism.parameters()
    with opened(browser) as page:
        show(page, tmp_path, document(vad.animate(vad.draw(vad.solve(mechanism)))))
        sliders = set(page.evaluate("() => Object.keys(vad.state)")) & own.keys()
        compared, errors = 0, []
        for number in range(SETS):
            sizes = {key: own[key] * rng.uniform(0.8, 1.25) for key in sorted(sliders)}
            if number % 3 == 2 and sizes:  # one of them as far as its box takes it
                sizes[rng.choice(sorted(sizes))] *= FARTHEST ** rng.uniform(-0.9, 0.9)
            place, *rates = mechanism.inputs
            inputs = {key: rng.uniform(-20.0, 20.0) for key in rates}
            usual = mechanism.inputs[place]
            turns = place == "angle"
            inputs[place] = rng.uniform(0, 360) if turns else usual * rng.uniform(0.8, 1.2)
            answer = page.evaluate("asked => vad.solve(asked)", {**sizes, **inputs})
            try:
                wanted = vad.solve(replace(mechanism, **sizes), **inputs).to_dict()
            except VadError:
                assert "error" in answer, (sizes, inputs)
                continue
            if "error" in answer:  # beyond a guard
                continue
            compared += 1
            errors.append(error(answer, wanted))
    assert compared > 2
    assert max(errors) <= CLOSE
