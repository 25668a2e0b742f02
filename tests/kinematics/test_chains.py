"""Any chain of dyads is as accurate as its numbers allow: 2 εκ for places, 4, 8, 64 for rates.

``VAD_SAMPLES=1000 pytest tests/kinematics/test_chains.py`` looks longer; ``python -m
benchmarks.errors`` says how large the errors are.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vad
from benchmarks.errors.chains import chain_of
from tests.kinematics.chains import KINDS, STARTS, Chain, errors
from tests.kinematics.families import Draw, Wide
from tests.kinematics.hand_built import BUILT, HandBuilt
from tests.kinematics.worst_cases import BOUNDS
from tests.oracle import Key

SAMPLES = int(os.environ.get("VAD_SAMPLES", "12"))


@settings(max_examples=2 * SAMPLES, deadline=None)
@given(
    start=st.sampled_from(STARTS),
    kinds=st.lists(st.sampled_from(KINDS), min_size=3, max_size=5),
    seed=st.integers(0, 2**64 - 1),
)
def test_errors_of_chains_stay_within_their_bounds(start: str, kinds: list[str], seed: int) -> None:
    found = dict(errors(Chain(Draw(seed), start, kinds)))
    assert not {key: size for key, size in found.items() if not size <= BOUNDS[key[2]]}


@pytest.mark.parametrize("kind", KINDS)
def test_each_kind_of_dyad_by_itself(kind: str) -> None:
    for seed, start in enumerate(STARTS * (SAMPLES // 12)):
        found = dict(errors(Chain(Draw(f"{kind} {seed}"), start, [kind])))
        assert not {key: size for key, size in found.items() if not size <= BOUNDS[key[2]]}


def test_a_bar_that_goes_round_with_the_slot_in_which_it_ends() -> None:
    """Its pivot is close to that of the slotted link, so that nearly all of its motion cancels."""
    kind = "RRP on a link"
    for seed in range(15):
        found = dict(errors(Chain(Wide(f"crank {kind} {seed}"), "crank", [kind])))
        assert not {key: size for key, size in found.items() if not size <= BOUNDS[key[2]]}


@pytest.mark.parametrize("seed", [2607, 2176, 1780, 1699, 286])
def test_a_slide_between_links_that_turn_almost_as_one(seed: int) -> None:
    """Its velocity is a small difference of large ones, but for one who turns with these links."""
    assert not beyond(seed)


@pytest.mark.parametrize("seed", [99, 545, 1278, 1342, 1645])
def test_the_end_of_a_cylinder_that_is_shorter_than_its_arm(seed: int) -> None:
    """It is near to the cylinder's own pivot, and far from that of the arm."""
    assert not beyond(seed)


@pytest.mark.parametrize(
    ("family", "seed"),
    [
        ("one decade", "p1.2427"),  # the roundings of five loops add up
        ("one decade", "p1.8473"),  # a point near the origin, on a guide with a far zero
        ("one decade", "p1.15993"),  # a slot in which the pin stands near the pivot
        ("one decade", "p1.32064"),  # both ends on the crank, whose pins are on guides
        ("one decade", "p1.41366"),  # the way to a point leads over its guide
        ("one decade", "p2.18138"),  # one end on a link, the other in its slot
        ("one decade", "p3.7003"),
        ("four decades", "9001.1304"),
        ("four decades", "9001.1790"),
        ("four decades", "9001.3953"),
        ("four decades", "9001.8054"),
        ("four decades", "f2.1303"),  # a long cylinder and a short arm, over coordinates
        ("four decades", "f2.1659"),  # a short link turns fast beside the way
    ],
)
def test_chains_that_were_beyond_their_bounds(family: str, seed: str) -> None:
    found = dict(errors(chain_of(family, seed)[1]))
    assert not {key: size for key, size in found.items() if not size <= BOUNDS[key[2]]}


def test_a_link_whose_pin_is_on_a_guide_that_hardly_moves() -> None:
    """The bars that lead there turn fast, and their rates cancel; that of the slide is small."""
    draw = Draw("one 20419")
    kinds = [draw.choice(KINDS) for _ in range(draw.randint(3, 5))]
    found = dict(errors(Chain(draw, draw.choice(STARTS), kinds)))
    assert found["link", "w6", "omega"] < 1.0
    assert found["point", "X6", "velocity"] < 1.0


def beyond(seed: int) -> dict[Key, float]:
    """Return the errors beyond their bounds of a random chain with lengths over four decades."""
    draw = Wide(f"four {seed}")
    kinds = [draw.choice(KINDS) for _ in range(draw.randint(3, 5))]
    found = dict(errors(Chain(draw, draw.choice(STARTS), kinds)))
    return {key: size for key, size in found.items() if not size <= BOUNDS[key[2]]}


@pytest.mark.parametrize("name", list(BUILT))
def test_many_poses_have_the_bits_of_one(name: str) -> None:
    mechanism = HandBuilt(BUILT[name]())
    inputs = {key: np.array([value, value, value]) for key, value in INPUTS[name].items()}
    many, one = vad.solve(mechanism, **inputs), vad.solve(mechanism, **INPUTS[name])
    for link in one.links:
        for quantity in ("angle", "omega", "alpha"):
            assert (getattr(many.link(link), quantity) == getattr(one.link(link), quantity)).all()
    for point in one.points:
        for quantity in ("position", "velocity", "acceleration"):
            expected = getattr(one.point(point), quantity)
            assert (getattr(many.point(point), quantity) == expected).all()


INPUTS: dict[str, dict[str, Any]] = {
    name: {"angle": 71.3, "omega": 3.0, "alpha": -2.0} for name in BUILT
} | {"landing-gear": {"position": 420.0, "velocity": -60.0, "acceleration": 10.0}}
