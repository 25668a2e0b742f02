"""The figures of the project's sources: the VAD paper, the three-method paper and Lecture 21."""

from __future__ import annotations

import math

import pytest

import vad

DIGITS_12 = 6e-12
"""Half a unit of the twelfth digit, and a little more for figures that begin with a 1."""


@pytest.fixture(scope="module")
def paper() -> vad.Motion:
    """Table 1 of the VAD paper: a slider-crank of 60 and 140 mm."""
    return vad.solve(vad.SliderCrank(crank=60, rod=140), angle=116.9, omega=11.59, alpha=21.15)


def test_vad_paper_to_the_last_digit(paper: vad.Motion) -> None:
    slider, rod = paper.slide("slider"), paper.link("rod")
    assert slider.position == pytest.approx(102.225126751, rel=DIGITS_12)
    assert slider.velocity == pytest.approx(-490.028084742, rel=DIGITS_12)
    assert slider.acceleration == pytest.approx(4829.01092161, rel=DIGITS_12)
    assert rod.angle == pytest.approx(337.530043184, rel=DIGITS_12)
    assert rod.omega == pytest.approx(2.43194060358, rel=DIGITS_12)
    assert rod.alpha == pytest.approx(57.5497777610, rel=DIGITS_12)


@pytest.mark.parametrize("acceleration", [4827.11, 4827.12])
def test_vad_paper_table_2(paper: vad.Motion, acceleration: float) -> None:
    """The table was made from unrounded inputs: three digits agree."""
    slider, rod = paper.slide("slider"), paper.link("rod")
    assert abs(slider.velocity) == pytest.approx(489.96, rel=1e-3)
    assert slider.acceleration == pytest.approx(acceleration, rel=1e-3)
    assert rod.angle == pytest.approx(337.53, rel=1e-3)
    assert rod.omega == pytest.approx(2.43, rel=1e-3)
    assert rod.alpha == pytest.approx(57.54, rel=1e-3)


@pytest.fixture(scope="module")
def ladder() -> vad.Motion:
    """The three-method paper: a link of 1 m on two perpendicular guides."""
    inputs = {"position": 0.5, "velocity": 2, "acceleration": 1}
    return vad.solve(vad.DoubleSlider(link=1), **inputs)


def test_three_method_paper_to_the_last_digit(ladder: vad.Motion) -> None:
    link, slider = ladder.link("link"), ladder.slide("slider_b")
    assert link.angle == pytest.approx(120, rel=1e-15)
    assert link.omega == pytest.approx(2.30940107676, rel=DIGITS_12)
    assert link.alpha == pytest.approx(4.23390197406, rel=DIGITS_12)
    assert slider.position == pytest.approx(0.866025403784, rel=DIGITS_12)
    assert slider.velocity == pytest.approx(-1.15470053838, rel=DIGITS_12)
    assert slider.acceleration == pytest.approx(-6.73575314055, rel=DIGITS_12)


METHODS = {
    "vector polygon": (2.31, 1.15, 4.24, 6.74),
    "unit vectors": (2.3, 1.15, 4.22, 6.73),
    "loop closure": (2.3, 1.15, 4.2, 6.68),
}


@pytest.mark.parametrize("method", METHODS)
def test_three_method_paper_table_1(ladder: vad.Motion, method: str) -> None:
    """Each method was worked by hand with three digits: one per cent."""
    link, slider = ladder.link("link"), ladder.slide("slider_b")
    found = (link.omega, -slider.velocity, link.alpha, -slider.acceleration)
    assert found == pytest.approx(METHODS[method], rel=0.01)


def test_lecture_21_gate() -> None:
    """The lecture measures both angles clockwise from the vertical."""
    gate = vad.GateActuator(ground=math.hypot(0.416, 0.546), arm=math.hypot(3.875, 0.3))
    motion = vad.solve(gate, position=3.8, velocity=1 / 17, acceleration=0)
    arm, actuator = motion.link("arm"), motion.link("actuator")
    assert -actuator.omega == pytest.approx(0.0863331558200, rel=DIGITS_12)
    assert -arm.omega == pytest.approx(0.0857557505926, rel=DIGITS_12)
    assert -actuator.alpha == pytest.approx(-0.00162337987173, rel=DIGITS_12)
    assert -arm.alpha == pytest.approx(-0.000276155755070, rel=DIGITS_12)


@pytest.mark.parametrize("stroke", [3.3, 3.8, 4.3])
def test_lecture_21_equations(stroke: float) -> None:
    """S sin θ = 0.416 + 3.886 sin φ and S cos θ = 3.886 cos φ − 0.546 hold over the stroke."""
    motion = vad.solve(vad.GateActuator(), position=stroke)
    phi, theta = (math.radians(90 - motion.link(name).angle) for name in ("arm", "actuator"))
    arm = math.hypot(3.875, 0.3)
    assert stroke * math.sin(theta) == pytest.approx(0.416 + arm * math.sin(phi), abs=1e-14)
    assert stroke * math.cos(theta) == pytest.approx(arm * math.cos(phi) - 0.546, abs=1e-14)
