"""The search for large errors: its truth is that of the tests' oracles, and it sees a fault."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import gmpy2
import pytest
from mpmath import mp, mpf

import vad
from benchmarks.errors import chains, plane, space
from benchmarks.errors.__main__ import broken, look
from benchmarks.errors.tally import Tally, error
from benchmarks.errors.truth import BITS, Truth, parts_of
from tests.kinematics.families import SAMPLERS, samples
from tests.kinematics.space.conditions import known
from tests.oracle import DIGITS


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    wanted = {"precision": BITS, "trap_divzero": True}
    with gmpy2.context(gmpy2.get_context(), **wanted):
        yield


def near(a: Any, b: Any, digits: float, least: float = 1e-70) -> bool:
    """Say whether numbers of gmpy2 and of mpmath agree."""
    with mp.workdps(DIGITS):
        x, y = (mp.mpmathify(str(part)) for part in (a, b))
        return bool(abs(x - y) <= abs(y) * mpf(10) ** -digits + least)


@pytest.mark.parametrize("variant", SAMPLERS)
def test_the_truth_in_the_plane_is_that_of_the_oracle(variant: str) -> None:
    for case, quantities in samples(variant, "random", 2, seed=5):
        truth = plane.PlaneTruth(case)
        for key, quantity in quantities.items():
            for part in parts_of(key, truth.values[key]):
                with mp.workdps(DIGITS):
                    value, wanted = part(mp.mpmathify(quantity.value)), quantity.kappa(part)
                assert near(part(truth.values[key]), value, 60), key
                assert near(truth.kappa(key, part), wanted, 20, least=1e-40), key


def test_the_truth_in_space_is_that_of_sixty_digits(exhaustive: bool) -> None:
    for _, pose in itertools.islice(space.poses(1), 12 if exhaustive else 6):
        try:
            vad.solve(pose.mechanism, **pose.inputs).to_dict()
        except vad.VadError:
            continue
        truth = space.SpaceTruth(pose)
        for scalar, orders in known(pose.mechanism, pose.inputs).items():
            kind = "slide" if scalar.kind == "length" else scalar.kind.replace("angle", "link")
            for name, (value, condition) in zip(space.names(kind), orders, strict=True):
                key = kind, scalar.name, name
                assert near(truth.values[key], value, 30, least=1e-50), key
                (part,) = parts_of(key, truth.values[key])
                # There the crank's angle counts as one rad and as much as itself, too.
                kappa = float(truth.kappa(key, part))
                assert condition / 9 - 1e-30 <= kappa <= condition * 1.01, key


def every_kind() -> Iterator[Truth]:
    for _, case in itertools.islice(plane.poses(2), 40):
        try:
            yield plane.PlaneTruth(case)
        except (plane.UnassemblableError, ArithmeticError, plane.ExactDeadCentreError):
            continue
    for family, seed in itertools.islice(chains.poses(2), 6):
        yield chains.ChainTruth(chains.chain_of(family, seed)[1].recipe(), BITS)
    for _, pose in itertools.islice(space.poses(2), 12):
        try:
            yield space.SpaceTruth(pose)
        except (vad.VadError, space.OpenLoopError, ArithmeticError):
            continue


def test_no_condition_number_is_below_its_least() -> None:
    """So an error that is small in units of the least κ need not be looked at again."""
    for truth in every_kind():
        for key, value in truth.values.items():
            for part in parts_of(key, value):
                least, kappa = truth.least_kappa(key, part), truth.kappa(key, part)
                assert least <= kappa * (1 + 1e-3) + truth.largest[key[2]] * 1e-12, key


@pytest.mark.parametrize("module", [plane, chains, space])
def test_it_sees_a_planted_fault(
    module: Any, monkeypatch: pytest.MonkeyPatch, exhaustive: bool
) -> None:
    """The last digits of every velocity are wrong: a few thousand ε."""
    read_all = module.read_all

    def faulty(motion: Any, keys: Any) -> Any:
        found = read_all(motion, keys)
        return {k: x * (1 + (1e-12 if k[2] == "velocity" else 0.0)) for k, x in found.items()}

    tally = Tally()
    for family, pose in itertools.islice(module.poses(3), 6 if exhaustive else 2):
        module.compare(tally, family, pose)
    assert not tally.findings
    monkeypatch.setattr(module, "read_all", faulty)
    for family, pose in itertools.islice(module.poses(3), 9 if exhaustive else 5):
        module.compare(tally, family, pose)
    assert sum(finding.key[2] == "velocity" for finding in tally.findings) > 5


def test_what_is_not_a_number_is_beyond_every_bound() -> None:
    truth = plane.PlaneTruth(next(samples("four-bar", "random", 1))[0])
    assert error(truth, ("link", "rocker", "omega"), float("nan")) == float("inf")


@pytest.mark.parametrize("kind", ["planar", "space"])
def test_a_short_search_finds_nothing(kind: str) -> None:
    tally = look(kind, 4, seconds=20.0, results=2000)
    assert tally.results >= 2000
    assert not broken(tally)
