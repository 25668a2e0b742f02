"""Where the links close, against many places that are tried one after the other."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import vad
from tests.kinematics.chains import KINDS, STARTS, Chain
from tests.kinematics.families import Draw
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.kinematics.reach import closing_range
from vad.kinematics.solver import Solver, solver_of

PLACES = 20_001


class Wide(Draw):
    """Lengths over three decades."""

    def length(self, decades: float = 3.0) -> float:
        return super().length(decades)


def chain(seed: int) -> Any:
    """Return a random chain of one to four dyads; one in three with lengths over three decades."""
    draw = Draw(f"reach {seed}") if seed % 3 else Wide(f"reach {seed}")
    kinds = [draw.choice(KINDS) for _ in range(draw.randint(1, 4))]
    return Chain(draw, draw.choice(STARTS), kinds).mechanism()


def dense(solver: Solver) -> np.ndarray[Any, Any]:
    """Return many places between the limits in closed form, even more of them near the limits."""
    turns = solver.driver.kind == "angle"
    limits = np.union1d(solver.limits(), [0.0, 360.0] if turns else [])
    share = (np.arange(PLACES) + 0.5) / PLACES
    rounded = np.sin(0.5 * np.pi * share) ** 2
    shares = np.concatenate([share, rounded, np.sin(0.5 * np.pi * rounded) ** 2])
    return np.concatenate([low + (high - low) * shares for low, high in pairwise(limits)])


# Chains that a grid of even steps over the farthest place of a slide once answered wrongly, and
# some others.
@pytest.mark.exhaustive(8)
@pytest.mark.parametrize("seed", [21, 51, 159, 178, 190, 222, 238, 243, 286, 376, *range(14)])
def test_random_chains_close_in_their_ranges_and_nowhere_else(seed: int) -> None:
    mechanism = chain(seed)
    solver = solver_of(mechanism).plane
    places = dense(solver)
    closes, inside, at_end = solver.closes(places), np.zeros(places.shape, bool), []
    for low, high in closing_range(mechanism):
        for whole in (0.0, 360.0) if solver.driver.kind == "angle" else (0.0,):
            inside |= (low + whole <= places) & (places <= high + whole)
            at_end += [low + whole, high + whole]
    wrong = places[closes != inside]
    size = np.abs(places).max()
    assert all(np.abs(np.subtract(at_end, place)).min() < 1e-11 * size for place in wrong[:9])


@pytest.mark.parametrize("slope", [3.0, 0.3, 0.1, 0.01, 1e-9])
def test_a_cylinder_between_guides_that_are_nearly_parallel(slope: float) -> None:
    """The arm lifts B by up to 80, and the rod reaches from the guide up to 72 only."""
    press = vad.mechanism(
        fixed={"A": [0, 0], "D": [100, 0]},
        links={
            "cylinder": {"DB": "variable"},
            "arm": {"AB": 80},
            "rod": {"BE": 100},
            "bar": {"BF": 120},
        },
        guides={"E": {"y": 28}, "F": {"through": "A", "angle": slope}},
        driver={"cylinder": {"position": 60, "velocity": 5}},
    )()
    along = np.sqrt(80**2 - 72**2)
    ends = [20, np.hypot(100 - along, 72), np.hypot(100 + along, 72), 180]
    assert np.ravel(closing_range(press)) == pytest.approx(ends, rel=1e-12)
    assert not vad.solve(press, position=125).assembled
    with pytest.raises(vad.AssemblyError, match=r"20 mm … 97\.0864 mm and 152\.886 mm … 180 mm"):
        vad.solve(press, position=125).point("E").position  # noqa: B018


def test_a_slide_that_pushes_two_bars_has_the_limits_of_a_circle() -> None:
    """C is 30 and 50 from the pivot D and from the slide, which passes D at a distance of 40."""
    lift = vad.mechanism(
        fixed={"D": [5, 0]},
        links={"arm": {"DC": 30}, "rod": {"SC": 50}},
        guides={"S": {"y": 40}},
        driver={"slider": {"position": 20, "velocity": 5}},
    )()
    reach = np.sqrt(80**2 - 40**2)
    assert np.ravel(closing_range(lift)) == pytest.approx([5 - reach, 5 + reach], rel=1e-15)


@pytest.mark.parametrize("short", [1e-4, 1e-8, 1e-11])
def test_no_gap_between_balls_is_too_narrow_to_be_found(short: float) -> None:
    """The coupler is a little too short where B is farthest from the circle of C."""
    sizes: dict[str, Any] = {
        "ground": 30,
        "crank_offset": 40,
        "rocker_offset": 85,
        "crank": 20,
        "rocker": 60,
    }

    def distance(degrees: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        """Return how far B is from the circle: the axes cross at right angles, 30 apart."""
        angle = np.radians(degrees)
        x, along, across = 20 * np.cos(angle) - 30, 20 * np.sin(angle) + 85, 40.0
        found: np.ndarray[Any, Any] = np.hypot(along, np.hypot(x, across) - 60)
        return found

    low, high = 0.0, 360.0
    for _ in range(9):
        places = np.linspace(low, high, 1001)
        best = places[distance(places).argmax()]
        low, high = best - (high - low) / 500, best + (high - low) / 500
    coupler = float(distance(places).max()) - short
    ((start, end),) = closing_range(vad.RSSR(coupler=coupler, **sizes))
    gap = (start - end) % 360.0
    assert 0.0 < gap < 100 * np.sqrt(short)
    assert end % 360.0 < best < end % 360.0 + gap


# --- guides that never cross ------------------------------------------------------------------


@pytest.mark.parametrize("other", [0.0, 360.0, 180.0, -360.0, -180.0, 1e-31])
def test_a_double_slider_with_both_guides_on_one_line_is_refused(other: float) -> None:
    with pytest.raises(vad.InputError, match=r"^guide_b: must differ from guide_a, got .* line$"):
        vad.DoubleSlider(1000, 0, other)


@pytest.mark.parametrize("other", [1e-29, 1e-9, -180.00000000000003, 359.99999999999994])
def test_a_double_slider_with_nearly_parallel_guides_closes_in_its_range(other: float) -> None:
    slider = vad.DoubleSlider(1000, 0, other)
    ((low, high),) = closing_range(slider)
    assert low == -high
    assert high > 5e13
    assert vad.solve(slider, position=[0.999 * high, 1.001 * high]).assembled.tolist() == [
        True,
        False,
    ]


@pytest.mark.parametrize("line", [{"y": 28}, {"y": 0}, {"through": "A", "angle": 180}])
def test_a_driven_slide_along_the_other_guide_of_its_rod_is_refused(line: dict[str, Any]) -> None:
    with pytest.raises(vad.InputError, match="slides along without a limit"):
        vad.mechanism(
            fixed={"A": [0, 0]},
            links={"rod": {"BE": 100}},
            guides={"B": {"y": 0}, "E": line},
            driver={"slider_b": {"position": 60, "velocity": 5}},
        )


def test_two_unknown_slides_on_parallel_lines_are_refused() -> None:
    loop = Loop((Slide("AB", "a", 30.0), Bar("BC", "bar", 5)), (Slide("DC", "c", 210.0, 3 + 4j),))
    with pytest.raises(vad.InputError, match="the lines of a and c are parallel and never cross"):
        Linkage(angle_of("bar"), (loop,), fixed={"D": 3 + 4j})
