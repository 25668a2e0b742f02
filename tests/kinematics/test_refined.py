"""In linkages of many loops places have no rounding but that of their own last digit."""

from __future__ import annotations

import numpy as np
import pytest

import vad
from tests.kinematics.chains import Chain, errors
from tests.kinematics.families import Draw, Wide
from tests.kinematics.hand_built import BUILT
from vad.kinematics.refined import is_refined

LOOPS = ["RRR", "RPR aside", "RRP on a link", "RPP", "RRP", "RRR"]


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("start", ["crank", "trammel", "strut"])
def test_places_are_rounded_once(start: str, seed: int) -> None:
    """By closed forms alone they are up to 25 εκ off where lengths differ by four decades."""
    found = dict(errors(Chain(Wide(f"places {seed}"), start, LOOPS)))
    places = {key: size for key, size in found.items() if key[2] in ("position", "angle")}
    assert len(places) > 20
    assert not {key: size for key, size in places.items() if not size <= 1.0}


def test_linkages_of_one_or_two_loops_are_solved_as_before() -> None:
    loops = {name: len(built().loops) for name, built in BUILT.items()}
    refined = {name for name, built in BUILT.items() if is_refined(built())}
    assert "watt-1" not in refined
    assert "jansen-leg" in refined
    assert all(loops[name] >= 3 for name in refined)
    for kind in vad.MECHANISMS.values():
        linkage = kind().linkage()
        assert not hasattr(linkage, "loops") or not is_refined(linkage)


@pytest.mark.parametrize("start", ["crank", "trammel", "strut"])
def test_arrays_and_poses_have_the_same_bits(start: str) -> None:
    chain = Chain(Draw(f"bits {start}"), start, LOOPS[:4])
    place = next(iter(chain.inputs))
    near = chain.inputs[place] * (1.0 + 1e-3 * np.arange(-3, 4))
    many = vad.solve(chain.mechanism(), **{**chain.inputs, place: near})
    for number, value in enumerate(near):
        if not many.assembled[number]:
            continue
        one = vad.solve(chain.mechanism(), **{**chain.inputs, place: float(value)})
        for point in one.points:
            for quantity in ("position", "velocity", "acceleration"):
                expected = getattr(one.point(point), quantity)
                assert getattr(many.point(point), quantity)[number] == expected


def six_links() -> vad.Mechanism:
    """Return a four-bar whose dead centre at 60° is exact, with two more dyads."""
    return vad.mechanism(
        fixed={"A": [0, 0], "D": [8, 0], "F": [12, 4], "H": [10, 9]},
        links={
            "crank": {"AB": 3},
            "coupler": {"BC": 4},
            "rocker": {"DC": 3},
            "rod": {"CE": 5},
            "arm": {"FE": 4},
            "strut": {"EG": 4},
            "lever": {"HG": 5},
        },
        driver={"crank": {"angle": 55, "omega": 1}},
        assembly={"C": "upper", "E": "left", "G": "left"},
    )()


def test_a_dead_centre_is_found_exactly() -> None:
    dead = vad.solve(six_links(), angle=60.0, omega=1.0)
    assert dead.assembled
    assert dead.point("C").position == pytest.approx(8 - 3 * (8 - 1.5 - 1.5j * 3**0.5) / 7)
    with pytest.raises(vad.DeadCentreError):
        print(dead.link("rocker").omega)
    assert dead.link("crank").omega == 1.0


@pytest.mark.parametrize("beside", [2.0**-10, 2.0**-20, 2.0**-30, 2.0**-38])
def test_beside_a_dead_centre_nothing_gets_worse(beside: float) -> None:
    """There Newton's step is not taken: ω grows with the root of the distance."""
    near, nearer = (
        vad.solve(six_links(), angle=60.0 - distance, omega=1.0).link("rocker").omega
        for distance in (4.0 * beside, beside)
    )
    rounding = 60.0 * 2.0**-52 / beside
    assert nearer / near == pytest.approx(2.0, rel=10.0 * beside**0.5 + rounding)
