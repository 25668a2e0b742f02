"""Every mechanism is drawn in the order in which a teacher draws it."""

from __future__ import annotations

from typing import Any

import pytest

import vad

P, K, C, X, R = "pole", "known", "construction", "intersection", "result"


def order(mechanism: Any, panel: str, **inputs: float) -> list[tuple[str, str]]:
    """Return kind and label of every stroke, whole vectors beside their parts left out."""
    sheet = vad.draw(vad.solve(mechanism, **inputs), panels=panel)
    return [(stroke.kind, stroke.label) for stroke in sheet.panel(panel).strokes]


VELOCITY = {
    "four-bar": [(P, "a,d"), (K, "ab"), (C, "⟂ BC"), (C, "⟂ DC"), (X, "c"), (R, "bc"), (R, "dc")],
    "slider-crank": [
        (P, "a,d"), (K, "ab"), (C, "⟂ BC"), (C, "∥ guide"), (X, "c"), (R, "bc"), (R, "dc"),
    ],
    "crank-slotted-lever": [
        (P, "a,d"), (K, "ab"), (C, "∥ lever"), (C, "⟂ DQ"), (X, "q"), (R, "dq"), (R, "qb"),
        (R, "dc"),
    ],
    "elliptical-trammel": [
        (K, "ab"), (C, "∥ guide of A"), (C, "∥ guide of B"), (X, "o"), (R, "oa"), (R, "ob"),
        (R, "op"),
    ],
    "scotch-yoke": [
        (P, "a"), (K, "ab"), (C, "∥ slot"), (C, "∥ guide"), (X, "c"), (R, "ac"), (R, "cb"),
    ],
    "double-slider": [
        (P, "o"), (K, "oa"), (C, "⟂ AB"), (C, "∥ guide of B"), (X, "b"), (R, "ab"), (R, "ob"),
    ],
    "gate-actuator": [
        (P, "a,d"), (K, "ds"), (C, "⟂ DB"), (C, "⟂ AB"), (X, "b"), (R, "sb"), (R, "ab"),
    ],
}  # fmt: skip
VELOCITY["whitworth"] = VELOCITY["crank-slotted-lever"]

ACCELERATION = {
    "four-bar": [
        (P, "a′,d′"), (K, "a′b′ₙ"), (K, "b′ₙb′"), (R, "a′b′"), (K, "b′cₙ"), (C, "⟂ BC"),
        (K, "d′c″ₙ"), (C, "⟂ DC"), (X, "c′"), (R, "cₙc′"), (R, "c″ₙc′"), (R, "b′c′"), (R, "d′c′"),
    ],
    "slider-crank": [
        (P, "a′,d′"), (K, "a′b′ₙ"), (K, "b′ₙb′"), (R, "a′b′"), (K, "b′cₙ"), (C, "⟂ BC"),
        (C, "∥ guide"), (X, "c′"), (R, "cₙc′"), (R, "b′c′"), (R, "d′c′"),
    ],
    "crank-slotted-lever": [
        (P, "a′,d′"), (K, "a′b′ₙ"), (K, "b′ₙb′"), (R, "a′b′"), (K, "zb′"), (C, "∥ lever"),
        (K, "d′qₙ"), (C, "⟂ DQ"), (X, "q′"), (R, "qₙq′"), (R, "q′z"), (R, "d′q′"), (R, "d′c′"),
    ],
    "elliptical-trammel": [
        (K, "a′b′ₙ"), (K, "b′ₙb′"), (R, "a′b′"), (C, "∥ guide of A"), (C, "∥ guide of B"),
        (X, "o′"), (R, "o′a′"), (R, "o′b′"), (R, "o′p′"),
    ],
    "scotch-yoke": [
        (P, "a′"), (K, "a′b′ₙ"), (K, "b′ₙb′"), (R, "a′b′"), (C, "∥ slot"), (C, "∥ guide"),
        (X, "c′"), (R, "a′c′"), (R, "c′b′"),
    ],
    "double-slider": [
        (P, "o′"), (K, "o′a′"), (K, "a′bₙ"), (C, "⟂ AB"), (C, "∥ guide of B"), (X, "b′"),
        (R, "bₙb′"), (R, "a′b′"), (R, "o′b′"),
    ],
    "gate-actuator": [
        (P, "a′,d′"), (K, "d′s′"), (K, "s′sₙ"), (K, "sₙz"), (C, "⟂ DB"), (K, "a′bₙ"),
        (C, "⟂ AB"), (X, "b′"), (R, "zb′"), (R, "bₙb′"), (R, "a′b′"),
    ],
}  # fmt: skip
ACCELERATION["whitworth"] = ACCELERATION["crank-slotted-lever"]


@pytest.mark.parametrize("name", VELOCITY)
def test_velocity(name: str) -> None:
    assert order(vad.MECHANISMS[name](), "velocity") == VELOCITY[name]


@pytest.mark.parametrize("name", ACCELERATION)
def test_acceleration(name: str) -> None:
    cls = vad.MECHANISMS[name]
    last = list(cls.inputs)[-1]
    given = {last: 20.0} if last == "alpha" else {last: 0.05 if name == "gate-actuator" else 1000.0}
    assert order(cls(), "acceleration", **given) == ACCELERATION[name]


@pytest.mark.parametrize("name", ["crank-slotted-lever", "whitworth"])
def test_the_ram_comes_after_the_lever(name: str) -> None:
    mechanism = vad.MECHANISMS[name](rod=300, ram_height=-80)
    velocity = order(mechanism, "velocity")
    assert velocity[:8] == VELOCITY[name]
    assert velocity[8:] == [(C, "⟂ CE"), (C, "∥ guide"), (X, "e"), (R, "ce"), (R, "de")]
    acceleration = order(mechanism, "acceleration", alpha=20.0)
    assert acceleration[:13] == ACCELERATION[name]
    assert acceleration[13:] == [
        (K, "c′eₙ"), (C, "⟂ CE"), (C, "∥ guide"), (X, "e′"), (R, "eₙe′"), (R, "c′e′"), (R, "d′e′"),
    ]  # fmt: skip


def test_zero_vectors_are_left_out() -> None:
    assert order(vad.GateActuator(), "acceleration")[1:3] == [(K, "d′sₙ"), (K, "sₙz")]
    assert order(vad.FourBar(), "acceleration")[1:3] == [(K, "a′b′"), (K, "b′cₙ")]
    assert order(vad.DoubleSlider(), "acceleration", acceleration=0.0)[:2] == [
        (P, "o′,a′"), (K, "a′bₙ"),
    ]  # fmt: skip


def test_a_mechanism_at_rest_is_its_pole() -> None:
    for cls in vad.MECHANISMS.values():
        still = dict.fromkeys(list(cls.inputs)[1:], 0.0)
        assert [kind for kind, _ in order(cls(), "velocity", **still)] == [P]
        assert [kind for kind, _ in order(cls(), "acceleration", **still)] == [P]


@pytest.mark.parametrize(
    ("panel", "equation"),
    [
        ("position", "AD + DQ = AB; DC + CE = DE"),
        ("velocity", "dq + qb = ab; dc + ce = de"),
        ("acceleration", "d′qₙ + qₙq′ + q′z + zb′ = a′b′; d′c′ + c′eₙ + eₙe′ = d′e′"),
    ],
)
def test_equations_read_as_in_the_textbook(panel: str, equation: str) -> None:
    motion = vad.solve(vad.CrankSlottedLever(rod=100, ram_height=180), angle=155)
    written = [
        " = ".join(" + ".join(term.label for term in side) for side in (found.left, found.right))
        for found in vad.draw(motion).panel(panel).equations
    ]
    assert "; ".join(written) == equation


def test_the_slider_of_an_in_line_slider_crank_starts_at_a() -> None:
    for offset, right in ((0.0, ["AC"]), (20.0, ["AD", "DC"])):
        sheet = vad.draw(vad.solve(vad.SliderCrank(offset=offset)), panels="position")
        (equation,) = sheet.panel("position").equations
        assert [term.label for term in equation.right] == right
