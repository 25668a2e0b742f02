"""The ends of a loop's known chains are joined by the way that rounds least."""

from __future__ import annotations

import pytest

from benchmarks.errors.chains import chain_of
from vad.kinematics.carrying import Way, carrying
from vad.kinematics.frame import ReferenceFrame
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of, scalar_of


def found(linkage: Linkage, number: int) -> tuple[Way, str] | None:
    """Return the way for a loop of a linkage."""
    fixed = ReferenceFrame(linkage).fixed
    return carrying(linkage, linkage.loops[number], linkage.unknowns[number], fixed)


@pytest.mark.parametrize(
    ("seed", "number", "ways", "view"),
    [
        ("p1.41366", 1, ["s2"], "ground"),  # over the guide of the point, not over crank and rod
        ("p1.32064", 2, ["k"], "k"),  # from pin to pin of the crank, not over both their guides
        ("p3.7003", 4, ["k", "k", "s6"], "k"),  # a slide in a slot of the crank is all
    ],
)
def test_the_way_that_rounds_least(seed: str, number: int, ways: list[str], view: str) -> None:
    way = found(chain_of("one decade", seed)[1].mechanism().linkage(), number)
    assert way
    assert sorted(scalar_of(step).name for _, step in way[0].steps) == ways
    assert way[1] == view
    assert bool(way[0].ground) is (view == "ground")


def test_the_steps_lead_from_end_to_end() -> None:
    linkage = chain_of("one decade", "p3.7003")[1].mechanism().linkage()
    way = found(linkage, 4)
    assert way
    place = "X6"
    for sign, step in way[0].steps:
        tail, head = (step.tail, step.head)[::sign]
        assert place == tail
        place = head
    assert place == "Y"


def six_bar(second: Loop) -> Linkage:
    """Return a slider-crank whose rod carries a second loop."""
    first = Loop((Bar("AB", "crank", 40.0), Bar("BC", "rod", 120.0)), (Slide("OC", "slide", 0.0),))
    return Linkage(angle_of("crank"), (first, second), fixed={"G": 90 + 80j})


def test_chains_that_are_as_good_are_kept() -> None:
    at_rod = (Bar("AB", "crank", 40.0), Bar("BE", "rod", 60.0, turn=1j), Bar("EF", "arm", 70.0))
    assert found(six_bar(Loop(at_rod, (Bar("GF", "lever", 60.0),))), 1) is None


def test_a_point_on_a_guide_is_reached_over_the_guide() -> None:
    at_slide = (Bar("AB", "crank", 40.0), Bar("BC", "rod", 120.0), Bar("CF", "arm", 70.0))
    way = found(six_bar(Loop(at_slide, (Bar("GF", "lever", 60.0),))), 1)
    assert way
    assert [scalar_of(step).name for _, step in way[0].steps] == ["slide"]
    assert way[0].ground == ("O", "G")
