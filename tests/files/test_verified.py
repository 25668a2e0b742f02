"""Mechanisms from files against figures of 15 digits that were found without the program."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import numpy as np
import pytest

import vad
from tests.files.verified import BY_NAME, CASES, verified

each = pytest.mark.parametrize("name", list(BY_NAME))
POSITION_AND_RATES = ("position", "velocity", "acceleration")


def solved(name: str) -> vad.Motions:
    """Solve a mechanism in all poses of its case."""
    mechanism, case = verified(name)(), BY_NAME[name]
    places = np.array([pose["input"] for pose in case["poses"]])
    return vad.solve(
        mechanism, **dict(zip(mechanism.inputs, [places, *case["rates"]], strict=True))
    )


def misses(motion: vad.Motions, poses: list[dict[str, Any]]) -> dict[str, float]:
    """Return the worst deviation of each kind of result, relative to the largest of its kind."""
    found: dict[str, list[tuple[Any, Any]]] = defaultdict(list)
    for name in poses[0]["points"]:
        wanted = np.array([pose["points"][name] for pose in poses]) @ [1.0, 1j]
        for order, what in enumerate(POSITION_AND_RATES):
            found[what].append((getattr(motion.point(name), what), wanted[:, order]))
    for name in poses[0]["links"]:
        angle, *rates = np.array([pose["links"][name] for pose in poses]).T
        turn = np.exp(1j * np.radians(motion.link(name).angle))
        found["direction"].append((turn, np.exp(1j * np.radians(angle))))
        for what, wanted in zip(("omega", "alpha"), rates, strict=True):
            found[what].append((getattr(motion.link(name), what), wanted))
    for name in poses[0]["slides"]:
        columns = np.array([pose["slides"][name] for pose in poses]).T
        for what, wanted in zip((*POSITION_AND_RATES, "coriolis"), columns, strict=False):
            found[f"{what} of slides"].append((getattr(motion.slide(name), what), wanted))
    return {
        what: max(np.abs(got - wanted).max() for got, wanted in pairs)
        / (max(np.abs(wanted).max() for _, wanted in pairs) or 1.0)
        for what, pairs in found.items()
    }


@each
def test_every_result(name):
    worst = misses(solved(name), BY_NAME[name]["poses"])
    assert max(worst.values()) < 1e-12, worst


@each
def test_the_points_links_and_slides_are_those_of_the_file(name):
    motion, pose = solved(name), BY_NAME[name]["poses"][0]
    assert set(motion.links) == set(pose["links"])
    assert set(motion.slides) == set(pose["slides"])
    assert set(pose["points"]) <= set(motion.points)


@each
def test_the_dyads_and_the_order_in_which_they_are_found(name):
    found = [(d.kind, [link.name for link in d.links]) for d in verified(name).written.dyads]
    assert found == [(dyad["kind"], dyad["links"]) for dyad in BY_NAME[name]["dyads"]]


@each
def test_the_range_that_closes(name):
    from vad.kinematics.reach import closing_range

    ranges = closing_range(verified(name)())
    (wanted,) = BY_NAME[name]["closes"]
    assert any(ends == pytest.approx(wanted, abs=1e-6) for ends in ranges), ranges


def test_all_kinds_of_dyads_are_among_them():
    kinds = {dyad["kind"] for case in CASES for dyad in case["dyads"]}
    assert kinds == {"RRR", "RRP", "RPR", "PRP", "RPP"}


def test_jansens_foot_as_another_program_prints_it():
    """Pyslvs' own test of the leg: joint 7 at input 0."""
    foot = vad.solve(verified("jansen-pose")(), angle=0.0).point("H").position
    assert foot == pytest.approx(-43.170055 - 91.753226j, abs=1e-6)


def test_the_inversor_draws_a_straight_line():
    """Where OB · OP = arm² − side²: P has x = (200² − 90²) / (2 · 60)."""
    path = vad.solve(verified("peaucellier")(), angle=np.linspace(-47, 47, 95)).point("P").position
    assert path.real == pytest.approx(31900 / 120, rel=1e-13)


def test_the_pantograph_enlarges_in_its_ratio():
    motion = vad.solve(verified("pantograph")(), angle=np.linspace(0, 360, 73))
    assert motion.point("P").position == pytest.approx(2 * motion.point("T").position, rel=1e-13)


@pytest.mark.parametrize(
    ("what", "printed"),
    [
        ("speed of D", 2.05),
        ("speed of B", 2.8),
        ("speed of B relative to A", 0.9),
        ("speed of D relative to B", 2.4),
        ("omega of BD", 4.5),
        ("acceleration of D", 13.3),
        ("alpha of BD", 71.3),
    ],
)
def test_the_toggle_press_of_the_book(what, printed):
    """Khurmi and Gupta, example 8.7, drawn by hand: five per cent."""
    motion = vad.solve(verified("toggle-press")())
    a, b, d = (motion.point(name).velocity for name in "ABD")
    measured = {
        "speed of D": d / 1000,
        "speed of B": b / 1000,
        "speed of B relative to A": (b - a) / 1000,
        "speed of D relative to B": (d - b) / 1000,
        "omega of BD": motion.link("rod").omega,
        "acceleration of D": motion.point("D").acceleration / 1000,
        "alpha of BD": motion.link("rod").alpha,
    }
    assert abs(measured[what]) == pytest.approx(printed, rel=0.05)
