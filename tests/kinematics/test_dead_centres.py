"""Where the numbers are exact a dead centre is found, and it is answered alike by one and many."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest

import vad

pytestmark = pytest.mark.exhaustive

HALVES = {0: 2, 60: 1, 90: 0, 120: -1, 180: -2, 240: -1, 270: 0, 300: 1}
"""Twice the cosine of every multiple of 30° where it is rational."""

LENGTHS = range(1, 8)


def dead_four_bars(angle: int) -> list[tuple[int, ...]]:
    """Return all whole lengths up to 7 whose coupler and rocker are in line, exactly."""
    cosine = Fraction(HALVES[angle], 2)
    found = []
    for ground, crank, coupler, rocker in product(LENGTHS, repeat=4):
        square = ground**2 + crank**2 - 2 * ground * crank * cosine
        if square and square in ((coupler + rocker) ** 2, (coupler - rocker) ** 2):
            found.append((ground, crank, coupler, rocker))
    return found


@pytest.mark.parametrize("angle", HALVES)
def test_every_whole_dead_centre_of_a_four_bar_is_found(angle: int) -> None:
    linkages = dead_four_bars(angle)
    assert linkages
    for lengths in linkages:
        motion = vad.solve(vad.FourBar(*lengths), angle=angle, omega=1.0)
        assert motion.assembled
        with pytest.raises(vad.DeadCentreError):
            motion.link("rocker").omega  # noqa: B018


@pytest.mark.parametrize("complement", HALVES)
def test_every_whole_dead_centre_of_a_slider_crank_is_found(complement: int) -> None:
    angle, sine = 90 - complement, Fraction(HALVES[complement], 2)
    offsets = range(-8, 9)
    dead = [
        (crank, rod, offset)
        for crank, rod, offset in product(LENGTHS, LENGTHS, offsets)
        if abs(offset - crank * sine) == rod
    ]
    assert dead
    for lengths in dead:
        motion = vad.solve(vad.SliderCrank(*lengths), angle=angle, omega=1.0)
        with pytest.raises(vad.DeadCentreError):
            motion.slide("slider").velocity  # noqa: B018


#: Twice the sine of every multiple of 30°, as a + b·√3.
SINES = [(0, 0), (1, 0), (0, 1), (2, 0), (0, 1), (1, 0)]
SINES += [(-a, -b) for a, b in SINES]


def dead_rams(ground_angle: int, sign: int) -> Iterator[tuple[tuple[int, ...], float, int]]:
    """Yield whole lengths, the ram's height and the crank's angle of rods that stand upright.

    The lengths are ground, crank, tip and rod.  The pin's distance from the lever's pivot is whole
    too, so that the height of the lever's tip is exact: sign · tip · rise / distance above D.
    """
    turned = ground_angle // 30
    for step, ground, crank in product(range(12), (1, 2, 3, 8), (1, 2, 3, 8)):
        cosine, irrational = SINES[(3 - step + turned) % 12]
        square = ground**2 + crank**2 - ground * crank * cosine
        distance = math.isqrt(square)
        if irrational or not square or distance**2 != square:
            continue
        pin, pivot = SINES[step], SINES[turned % 12]
        for tip, rod, side in product((1, 3), (1, 2), (1, -1)):
            height, irrational = (
                Fraction(ground * d, 2)
                + Fraction(sign * tip * (crank * b - ground * d), 2 * distance)
                for b, d in zip(pin, pivot, strict=True)
            )
            if irrational == 0 and float(height) == height:
                yield (ground, crank, tip, rod), float(height + side * rod), 30 * step


@pytest.mark.parametrize("ground_angle", [-90, 0, 30])
@pytest.mark.parametrize(("kind", "sign"), [(vad.CrankSlottedLever, 1), (vad.Whitworth, -1)])
def test_whole_dead_centres_of_a_ram_are_found(kind: Any, sign: int, ground_angle: int) -> None:
    rams = list(dead_rams(ground_angle, sign))
    assert len(rams) > 100
    for (*lengths, rod), height, angle in rams[::7]:  # of every eight, each comes first in turn
        lever = kind(*lengths, rod=rod, ram_height=height, ground_angle=ground_angle)
        motion = vad.solve(lever, angle=angle, omega=1.0)
        assert motion.assembled
        with pytest.raises(vad.DeadCentreError):
            motion.slide("ram").velocity  # noqa: B018
        assert np.isnan(vad.solve(lever, angle=[angle], omega=1.0).slide("ram").velocity[0])


def test_a_pose_next_to_a_dead_centre_is_none() -> None:
    lever = vad.Whitworth(2, 2, 6, ground_angle=-180)
    motion = vad.solve(lever, angle=179.99999999999997, omega=10.0)
    assert motion.link("lever").omega == pytest.approx(5.0, rel=1e-15)


# --- what is known there ----------------------------------------------------------------------


def test_one_pose_answers_what_is_known_at_a_dead_centre() -> None:
    motion = vad.solve(vad.FourBar(8, 3, 4, 3), angle=60, omega=2.0, alpha=1.0)
    assert (motion.link("crank").omega, motion.link("crank").alpha) == (2.0, 1.0)
    assert motion.point("D").velocity == 0
    assert abs(motion.point("B").velocity) == pytest.approx(6.0, rel=1e-15)
    with pytest.raises(vad.DeadCentreError, match="coupler and rocker"):
        motion.point("C").velocity  # noqa: B018
    with pytest.raises(vad.DeadCentreError):
        motion.to_dict()


@pytest.mark.parametrize(
    ("mechanism", "place"),
    [
        (vad.DoubleSlider(1000), {"position": 1000}),
        (vad.DoubleSlider(1000), {"position": -1000}),
        (vad.FourBar(8, 3, 4, 3), {"angle": 60}),
        (vad.CrankSlottedLever(crank=120), {"angle": 270}),
    ],
)
def test_a_dead_centre_names_a_pose_near_by_that_has_rates(mechanism: Any, place: Any) -> None:
    with pytest.raises(vad.DeadCentreError) as raised:
        vad.solve(mechanism, **place).to_dict()
    name, text = str(raised.value.hint).removeprefix("try ").split()
    assert set(place) == {name}
    assert 0 < abs(float(text) - place[name]) < 0.03 * 1000
    assert vad.solve(mechanism, **{name: float(text)}).to_dict()


def test_a_driven_slide_moves_as_it_is_pushed() -> None:
    motion = vad.solve(vad.DoubleSlider(1), position=1, velocity=3.0, acceleration=4.0)
    slide = motion.slide("slider_a")
    assert (slide.velocity, slide.acceleration) == (3.0, 4.0)
    with pytest.raises(vad.DeadCentreError):
        motion.slide("slider_b").velocity  # noqa: B018


@pytest.mark.parametrize("given", [-90.0, np.array([-90.0])])
def test_a_pin_on_the_pivot_counts_as_assembled_with_a_ram(given: Any) -> None:
    motion = vad.solve(vad.Whitworth(1, 1, 1, rod=3, ram_height=0), angle=given)
    assert np.all(motion.assembled)
    assert np.all(motion.point("B").position == -1j)


# --- links of equal length --------------------------------------------------------------------


@pytest.mark.parametrize("angle", [7.3, 33.3, 89.9, -12.0])
@pytest.mark.parametrize("many", [False, True])
def test_what_stands_has_no_rates_at_all(angle: float, many: bool) -> None:
    place = np.array([angle, angle]) if many else angle
    rates = {"omega": 10.0, "alpha": 3.0}
    slider = vad.solve(vad.SliderCrank(100, 100, assembly="crossed"), angle=place, **rates)
    side = "crossed" if angle > 0 else "open"
    kite = vad.solve(vad.FourBar(100, 40, 40, 100, assembly=side), angle=place, **rates)
    for motion, link in ((slider, "rod"), (kite, "coupler")):
        point = motion.point("C")
        for value in (point.position, point.velocity, point.acceleration):
            assert np.all(value == 0)
        assert np.all(motion.link(link).omega == 10.0)
        assert np.all(motion.link(link).alpha == 3.0)
    side = "open" if angle > 0 else "crossed"
    equal = vad.solve(vad.FourBar(100, 40, 100, 40, assembly=side), angle=place, **rates)
    assert np.all(equal.link("coupler").omega == 0)
    assert np.all(equal.link("coupler").alpha == 0)
    assert np.all(equal.link("rocker").omega == 10.0)
