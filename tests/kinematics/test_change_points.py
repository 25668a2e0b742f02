"""Change points are told where they are, and a parallelogram that is said to be one has none."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import vad
from tests.kinematics.hand_built import BUILT, HandBuilt, turn
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.kinematics.reach import change_points


def locomotive(parallel: bool, slope: float) -> HandBuilt:
    """Three wheels on one line: the second rod hangs on the second wheel, which is no crank."""
    wheel = Bar("DC", "wheel", 40)
    first = Loop((Bar("AB", "crank", 40), Bar("BC", "rod", 100)), (wheel,), parallel=parallel)
    second = Loop((wheel, Bar("CE", "rod_2", 130)), (Bar("O2E", "last", 40),), parallel=parallel)
    fixed = {"D": 100 * turn(slope), "O2": 230 * turn(slope)}
    return HandBuilt(Linkage(angle_of("crank"), (first, second), fixed=fixed))


def places(mechanism: vad.FourBar) -> list[float]:
    return [point.place for point in change_points(mechanism)]


def test_a_parallelogram_has_two_and_says_so() -> None:
    found = change_points(vad.FourBar(100, 40, 100, 40, ground_angle=30))
    assert [point.place for point in found] == pytest.approx([30, 210], abs=1e-9)
    assert all(point.parallel for point in found)
    assert found[1].words("°") == "change point at 210°: two motions are possible; say parallel"


def test_what_is_no_parallelogram_is_not_to_say_parallel() -> None:
    assert places(vad.FourBar(4, 1, 2, 5)) == [0]
    assert not change_points(vad.FourBar(4, 1, 2, 5))[0].parallel
    assert [p.place for p in change_points(vad.SliderCrank(60, 60))] == [90, 270]


@pytest.mark.parametrize("name", list(BUILT))
def test_other_linkages_have_none(name: str) -> None:
    assert change_points(HandBuilt(BUILT[name]())) == ()


def test_the_end_of_a_range_is_none() -> None:
    assert places(vad.FourBar(crank=130)) == []
    assert places(vad.FourBar(4, 3, 2, 3)) == [0]  # and not ±90, where it ends


@pytest.mark.parametrize("slope", [0.0, 25.0])
def test_wheels_have_them_until_their_loops_are_parallel(slope: float) -> None:
    found = change_points(locomotive(False, slope))
    assert [(p.loop, p.parallel) for p in found] == [(0, True), (0, True), (1, True), (1, True)]
    expected = [slope, slope + 180] * 2
    assert [p.place for p in found] == pytest.approx(expected, abs=1e-5)
    coupled = locomotive(True, slope)
    assert change_points(coupled) == ()
    angles = np.arange(0.0, 361.0, 5.0)
    motion = vad.solve(coupled, angle=angles, omega=3.0, alpha=-2.0)
    assert (motion.link("last").omega == 3.0).all()
    assert (motion.link("last").alpha == -2.0).all()
    assert (motion.link("rod_2").omega == 0.0).all()
    carried = motion.point("E").position - motion.point("B").position
    assert np.abs(carried - 230 * turn(slope)).max() < 1e-12
    assert vad.solve(coupled, angle=180.0 + slope, omega=3.0).link("last").omega == 3.0


def test_sides_that_differ_are_no_parallelogram() -> None:
    loop = locomotive(True, 0.0).built.loops[0]
    longer = replace(loop, second=(Bar("DC", "wheel", 40 * (1 + 1e-11)),))
    mechanism = HandBuilt(Linkage(angle_of("crank"), (longer,), fixed={"D": 100 + 0j}))
    with pytest.raises(vad.InputError, match=r"^parallel: DC and the side opposite it differ by"):
        vad.solve(mechanism, angle=10.0).link("wheel").angle  # noqa: B018


def test_a_bar_on_a_slide_is_no_parallelogram() -> None:
    """Its rod is as long as the ground, but the crank has no bar opposite."""
    chain = Bar("AB", "crank", 60), Bar("BC", "rod", 60)
    guided = Loop(chain, (Slide("DC", "slider", 0.0, origin=60 + 0j),))
    found = change_points(HandBuilt(Linkage(angle_of("crank"), (guided,), fixed={"D": 60 + 0j})))
    assert [(point.place, point.parallel) for point in found] == [(90.0, False), (270.0, False)]
