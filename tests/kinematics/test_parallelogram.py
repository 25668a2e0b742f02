"""A coupling rod runs through its change points: the parallelogram stays one."""

from __future__ import annotations

import numpy as np
import pytest

import vad


@pytest.mark.parametrize("lengths", [(100, 40, 100, 40), (40, 100, 40, 100), (50, 50, 50, 50)])
@pytest.mark.parametrize("ground_angle", [0.0, 30.0])
def test_a_parallelogram_stays_one_all_the_way_round(
    lengths: tuple[float, ...], ground_angle: float
) -> None:
    mechanism = vad.FourBar(*lengths, ground_angle=ground_angle, assembly="parallel")
    turn = vad.solve(mechanism, angle=np.linspace(-360, 360, 145), omega=10.0, alpha=3.0)
    assert turn.assembled.all()
    assert (turn.link("coupler").omega == 0).all()
    assert (turn.link("coupler").alpha == 0).all()
    assert (turn.link("rocker").omega == 10.0).all()
    assert (turn.link("rocker").alpha == 3.0).all()
    carried = turn.point("C").position - turn.point("B").position
    assert np.abs(carried - turn.point("D").position).max() < 1e-13 * max(lengths)


@pytest.mark.parametrize("angle", [0.0, 180.0, 360.0])
def test_it_has_rates_and_a_sheet_at_its_change_points(angle: float) -> None:
    mechanism = vad.FourBar(100, 40, 100, 40, assembly="parallel")
    motion = vad.solve(mechanism, angle=angle, omega=10.0)
    assert motion.point("C").velocity == motion.point("B").velocity
    assert motion.to_dict()["assembly"] == "parallel"
    assert vad.draw(motion).panels


def test_only_a_parallelogram_can_be_parallel() -> None:
    with pytest.raises(vad.InputError, match=r"^assembly: parallel needs") as caught:
        vad.FourBar(100, 40, 100, 41, assembly="parallel")
    assert caught.value.hint == "try coupler 100 and rocker 40"
