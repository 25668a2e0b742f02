"""Which mechanisms can be assembled in two ways is read off their loops."""

from __future__ import annotations

import pytest

import vad

TWO = {"four-bar", "slider-crank", "double-slider", "gate-actuator"}
TWO |= {"spherical-four-bar", "spatial-four-bar", "rssr"}


@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_assembly_is_named_where_there_are_two(name: str) -> None:
    for assembly in ("open", "crossed"):
        motion = vad.solve(vad.MECHANISMS[name](assembly=assembly))
        assert motion.to_dict()["assembly"] == (assembly if name in TWO else None)


@pytest.mark.parametrize("name", ["crank-slotted-lever", "whitworth"])
def test_a_ram_brings_a_second_assembly(name: str) -> None:
    places = []
    for assembly in ("open", "crossed"):
        mechanism = vad.MECHANISMS[name](rod=300, ram_height=-80, assembly=assembly)
        motion = vad.solve(mechanism)
        assert motion.to_dict()["assembly"] == assembly
        places.append(motion.point("E").position.real - motion.point("C").position.real)
    assert places[0] > 0 > places[1]
