"""The verb `design`: its sequence, its forms, its files and what it refuses."""

from __future__ import annotations

import json
import math

import pytest

import vad
from vad.designs.task import above, below
from vad.designs.tasks import TASKS
from vad.files.loading import load_text
from vad.words import languages

CASES = {
    "slider-crank": {"stroke": 120, "time_ratio": 1.2},
    "quick-return": {"stroke": 300, "time_ratio": 2},
    "crank-rocker": {"swing": 60, "time_ratio": 1.2},
    "three-positions": {"positions": "0 0 0, 60 30 20, 90 80 55", "fixed": "-20 110, 20 100"},
    "function": {"pairs": "40 70, 60 82, 80 97"},
}
by_task = pytest.mark.parametrize("task", CASES)


def test_every_task_has_a_case() -> None:
    assert set(TASKS) == set(CASES)
    assert all(task.name == name for name, task in TASKS.items())


@by_task
def test_it_is_a_sequence(task: str) -> None:
    found = vad.design(task, **CASES[task])
    assert len(found) == len(list(found)) == len(found[:])
    assert found[-1] is found[len(found) - 1]
    assert isinstance(found[0], vad.Solution)
    lines = repr(found).splitlines()
    assert len(lines) == 1 + len(found)
    assert all(len(line) < 200 for line in lines)


@by_task
def test_json_has_all_and_what_was_picked(task: str) -> None:
    found = vad.design(task, **CASES[task])
    choice = len(found) - 1
    data = json.loads(json.dumps(found.to_dict(choice)))
    assert data["task"] == task
    assert data["choice"] == len(data["solutions"])
    assert data["mechanism"] == found[choice].mechanism.name
    assert data["parameters"] == data["solutions"][choice]["parameters"]
    for solution, each in zip(found, data["solutions"], strict=True):
        kind = vad.MECHANISMS[each["mechanism"]]
        points = {name: tuple(place) for name, place in each["points"].items()}
        again = kind(**each["parameters"], assembly=each["assembly"] or "open", points=points)
        assert again == solution.mechanism
        assert each["transmission"]["least"] == solution.merit["transmission"]["least"]
        assert each["grashof"] == solution.merit["grashof"]


@by_task
def test_the_file_moves_as_the_mechanism(task: str) -> None:
    for solution in vad.design(task, **CASES[task]):
        mechanism = load_text(solution.toml().encode(), "designed.toml")()
        size = max(map(abs, solution.mechanism.parameters().values()))
        for motion in (vad.solve(solution.mechanism, angle=each) for each in near(solution)):
            other = vad.solve(mechanism, angle=motion.inputs["angle"])
            for letter in set(motion.points) & set(other.points):
                place = solution.origin + motion.point(letter).position
                assert abs(other.point(letter).position - place) < 1e-13 * size
        assert mechanism.inputs["omega"] == solution.speed
        assert mechanism.inputs["angle"] == solution.places[0]


def near(solution: vad.Solution) -> list[float]:
    """Return the places of the positions, and some beside the first one."""
    first = solution.places[0]
    return [*(() if solution.faults else solution.places), first, first + 0.5, first - 0.5]


@pytest.mark.exhaustive
@by_task
@pytest.mark.parametrize("language", languages())
def test_the_text_is_in_every_language(task: str, language: str) -> None:
    found = vad.design(task, **CASES[task])
    text = found.table(5, language)
    head = {"en": "solution", "de": "Lösung", "fr": "solution"}[language]
    assert text.splitlines()[2].split() == [head, *map(str, range(1, len(found) + 1))]
    rows = {line[: text.splitlines()[2].rindex("1") - 4].strip() for line in text.splitlines()[3:]}
    assert len(rows) > 8


@by_task
def test_positions_agree_with_the_solver(task: str) -> None:
    for solution in vad.design(task, **CASES[task]):
        assert [each["angle"] for each in solution.positions] == list(solution.places)
        for each in solution.positions:
            assert math.isfinite(each["output"])
            assert 0.0 <= each["transmission"] <= 180.0


def test_lengths_have_units() -> None:
    found = vad.design("slider-crank", stroke="12 cm", time_ratio=1.2, crank="0.056 m")
    assert found.demands == {"stroke": 120.0, "time_ratio": 1.2, "crank": 56.0}
    found = vad.design("slider-crank", stroke="1 ft", time_ratio=1.2, length_unit="in")
    assert found.demands["stroke"] == pytest.approx(12.0, rel=1e-15)
    assert found[0].mechanism.length_unit == "in"
    assert 'unit  = "in"' in found[0].toml()


@pytest.mark.parametrize(
    ("task", "given", "message", "hint"),
    [
        ("cam", {}, "unknown task of design 'cam'", "known: crank-rocker, function,"),
        (5, {}, "unknown task of design 5", "known:"),
        ("slider-crank", {"stroke": 120}, "time_ratio: is missing", "as in --time-ratio 1.2"),
        ("slider-crank", {"strok": 1}, "unknown demand of slider-crank 'strok'", "did you mean"),
        ("slider-crank", {"stroke": -1, "time_ratio": 1.2}, "stroke: must be positive", "try 1"),
        ("slider-crank", {"stroke": "x", "time_ratio": 1}, "stroke: 'x' is not a number", "write"),
        ("slider-crank", {"stroke": math.inf, "time_ratio": 1}, "stroke: must be a finite", None),
        (
            "slider-crank",
            {"stroke": 1, "time_ratio": 0.5},
            "time_ratio: must be from 1 to 100",
            "t",
        ),
        (
            "slider-crank",
            {"stroke": 1, "time_ratio": 101},
            "time_ratio: must be from 1 to 100",
            None,
        ),
        ("crank-rocker", {"swing": 0, "time_ratio": 1}, "swing: must be between 0° and 180°", None),
        ("crank-rocker", {"swing": 180, "time_ratio": 1}, "swing: must be between", None),
        ("slider-crank", {"stroke": [1], "time_ratio": 1}, "stroke: must be one number", None),
    ],
)
def test_what_is_wrong_is_said(task, given, message, hint) -> None:
    with pytest.raises(vad.InputError) as wrong:
        vad.design(task, **given)
    assert str(wrong.value).startswith(message)
    if hint is not None:
        assert wrong.value.hint.startswith(hint)


@pytest.mark.parametrize("number", [4.142857142857, 60.0, 1e-7 / 3.0, 2e9 / 3.0, 0.0])
def test_limits_are_rounded_to_their_side(number: float) -> None:
    assert float(below(number)) <= number <= float(above(number))
    assert float(above(number)) - float(below(number)) <= 2e-5 * number


def test_the_title_of_a_file_says_what_is_wrong_with_a_solution():
    positions, moving = [(0, 0, 0), (40, 50, 60), (100, 40, -10)], [(0, 0), (60, 0)]
    branch, order = vad.design("three-positions", positions=positions, moving=moving)
    assert branch.toml().startswith('title = "Four-bar, changes its assembly"\n')
    assert order.toml().startswith('title = "Four-bar, another order of positions"\n')
    kind = load_text(branch.toml().encode(), "branch.toml")
    assert vad.draw(vad.solve(kind()), "position").title == "Four-bar, changes its assembly"
    assert (
        vad.design("slider-crank", stroke=120, time_ratio=1.2)[0]
        .toml()
        .startswith('title = "Slider–crank"\n')
    )
