"""The oracle by itself: it knows the traps, the published answers and its own differences."""

from __future__ import annotations

from typing import Any

import pytest
from mpmath import mp, mpf

from tests.oracle import UnassemblableError, reference
from tests.validation.published import CASES, ladder_driven_by_its_link, misses, scene, truth

SOLVED = [case for case in CASES if scene(case)]
LADDERS = [case for case in CASES if ladder_driven_by_its_link(case)]


@pytest.mark.parametrize("case", SOLVED, ids=[case["id"] for case in SOLVED])
def test_published_answers(case: dict[str, Any]) -> None:
    found = scene(case)
    assert found is not None
    wanted = {**case["exact"], **found.given_back}
    assert not misses(found.results(truth(found)), wanted, rel=1e-12, absolute=1e-9)


@pytest.mark.parametrize("case", LADDERS, ids=[case["id"] for case in LADDERS])
def test_ladders_driven_by_their_link(case: dict[str, Any]) -> None:
    found = ladder_driven_by_its_link(case)
    assert found is not None
    measured = found.results(truth(found))
    wanted = {k: v for k, v in case["exact"].items() if k in measured}
    assert not misses(measured, {**wanted, **found.given_back}, rel=1e-12, absolute=1e-9)


TRAPS = [
    ("four-bar", (4, 3, 5, 8), "90", "crossed", ("rocker", "angle"), "3.14159265358979"),
    ("four-bar", (4, 3, 5, 8), "90", "crossed", ("rocker", "omega"), "0.5"),
    ("four-bar", (4, 3, 5, 8), "90", "open", ("rocker", "angle"), "1.854590436003"),
    ("four-bar", (4, 3, 5, 8), "90", "open", ("rocker", "omega"), "0.22"),
    ("four-bar", (2, 1, 2, 1), "5.72957795130823e-8", "open", ("rocker", "omega"), "1"),
    ("four-bar", (2, 1, 2, 1), "5.72957795130823e-8", "crossed", ("rocker", "omega"), "-3"),
    ("four-bar", (2, 1, 2, 1), "5.72957795130823e-8", "crossed", ("coupler", "omega"), "-2"),
    ("slider-crank", (60, 140), "360000000030", "open", ("slider", "position"), "188.70946753884"),
    ("slider-crank", (1, 1), "89.999999999", "open", ("slider", "velocity"), "-2"),
    ("slider-crank", (1, 1), "89.999999999", "open", ("rod", "omega"), "-1"),
    ("crank-slotted-lever", (1, 1, 2), "-89.99999999", "open", ("lever", "omega"), "0.5"),
    ("crank-slotted-lever", (1, 1, 2), "-89.99999999", "open", ("block", "position"), "1.7453e-10"),
]
LENGTHS = {
    "four-bar": ("ground", "crank", "coupler", "rocker"),
    "slider-crank": ("crank", "rod"),
    "crank-slotted-lever": ("ground", "crank", "lever"),
}


@pytest.mark.parametrize(("name", "lengths", "angle", "assembly", "what", "wanted"), TRAPS)
def test_traps(
    name: str,
    lengths: tuple[int, ...],
    angle: str,
    assembly: str,
    what: tuple[str, str],
    wanted: str,
) -> None:
    parameters = dict(zip(LENGTHS[name], lengths, strict=True))
    solved = reference(name, parameters, {"angle": angle, "omega": 1, "alpha": 0}, assembly)
    kind = "slide" if what[0] in ("slider", "block") else "link"
    digits = len(wanted.partition("e")[0].replace("0.", "").replace(".", ""))
    close = mpf(10) ** -min(12, digits - 1 if digits > 3 else 12)
    assert abs(solved[(kind, *what)].value / mpf(wanted) - 1) < close


def test_trap_of_the_double_slider() -> None:
    inputs = {"position": 1 - 1e-15, "velocity": 2, "acceleration": 1}
    solved = reference("double-slider", {"link": 1}, inputs)
    assert float(solved["slide", "slider_b", "acceleration"].value) == pytest.approx(
        -4.47750303561e22, rel=1e-11
    )


def test_what_cannot_close_is_refused() -> None:
    links = {"ground": 100, "crank": 40, "coupler": 30, "rocker": 20}
    with pytest.raises(UnassemblableError):
        reference("four-bar", links, {"angle": 180, "omega": 1, "alpha": 0})


@pytest.mark.parametrize("case", SOLVED, ids=[case["id"] for case in SOLVED])
def test_series_agree_with_differences_of_the_position(case: dict[str, Any]) -> None:
    """Step the input along its own motion: the position's differences are the rates."""
    found = scene(case)
    assert found is not None
    inputs = {key: mpf(value) for key, value in found.inputs.items()}
    driven = "angle" if "angle" in inputs else "position"
    first, second = ("omega", "alpha") if driven == "angle" else ("velocity", "acceleration")
    step, unit = mpf(10) ** -12, 180 / mp.pi if driven == "angle" else 1

    def at(time: Any) -> Any:
        moved = inputs[driven] + unit * (inputs[first] * time + inputs[second] * time**2 / 2)
        here = {**inputs, driven: moved}
        return reference(found.name, found.parameters, here, found.assembly, conditions=False)

    with mp.workdps(60):
        before, now, after = at(-step), at(0), at(step)
        for key in now:
            if key[2] == "position" and key[1] != "Q":  # Q is another point a moment later
                places = [solved[key].value for solved in (before, now, after)]
                velocity = (places[2] - places[0]) / (2 * step)
                acceleration = (places[2] - 2 * places[1] + places[0]) / step**2
                for rate, value in (("velocity", velocity), ("acceleration", acceleration)):
                    true = now[(*key[:2], rate)].value
                    assert abs(value - true) <= mpf(10) ** -9 * (1 + abs(true))
