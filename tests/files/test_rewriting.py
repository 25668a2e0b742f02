"""A mechanism's file with other numbers is read as that mechanism, and keeps its own words."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import pytest

import vad
from vad.errors import InputError, VadError
from vad.files.examples import example_names, example_path
from vad.files.loading import load_text
from vad.files.rewriting import rewritten


def larger(kind: Any, factor: float) -> dict[str, float]:
    """Return the lengths of a mechanism that is larger."""
    quantities = {field.name: field.metadata["quantity"] for field in fields(kind)}
    own = kind().parameters()
    return {name: own[name] * factor for name in own if quantities[name] == "length"}


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", example_names())
def test_an_example_with_other_lengths_is_read_as_it_was_set(name: str) -> None:
    kind: Any = vad.load(example_path(name))
    for factor in (1.25, 1.01):
        mechanism = kind(**larger(kind, factor))
        if not vad.solve(mechanism, **kind.inputs).assembled:
            assert factor > 1.1, "an example closes with nearly its own lengths"
            continue
        text = rewritten(mechanism, kind.inputs)
        again = load_text(text.encode(), f"{name}.toml")()
        assert again.parameters() == mechanism.parameters()
        own, other = (
            vad.solve(each, **kind.inputs).to_dict()["points"] for each in (mechanism, again)
        )
        for letter, point in own.items():
            assert other[letter]["position"] == pytest.approx(point["position"], abs=1e-9)
    assert text.count("#") == example_path(name).read_text("utf-8").count("#")


def test_the_other_place_of_a_point_is_written_too() -> None:
    kind: Any = vad.load(example_path("four-bar"))
    text = rewritten(kind(crank=45.5, assembly={"C": "lower"}), kind.inputs)
    assert 'C = "lower"' in text and "{ AB = 45.5 }" in text
    assert "# angle CBP: from BC to BP, counter-clockwise" in text
    assert rewritten(kind(), kind.inputs) == example_path("four-bar").read_text("utf-8")


def test_two_equal_numbers_are_told_apart_and_units_give_way() -> None:
    text = """
[fixed]
A = [0, 0]
D = [100, 0]
[links]
crank   = { AB = 40, AP = 40 }  # both 40
coupler = { BC = "120 mm" }
rocker  = { DC = 80 }
[driver]
crank = { angle = 60, omega = 10 }
[assembly]
C = "upper"
"""
    kind: Any = load_text(text.encode(), "two.toml")
    written = rewritten(kind(AP=41.0, coupler=121.0), {"angle": 60.0})
    assert "{ AB = 40, AP = 41.0 }  # both 40" in written and "{ BC = 121.0 }" in written


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", example_names())
def test_the_pose_is_written_too(name: str) -> None:
    """What the file leaves out, as the acceleration of most examples, is added."""
    kind: Any = vad.load(example_path(name))
    place, rate, further = kind.inputs
    inputs = {place: kind.inputs[place] + 1.0, rate: 20.5, further: 3.5}
    text = rewritten(kind(), inputs)
    again = load_text(text.encode(), f"{name}.toml")
    assert again.inputs == inputs
    motions = [vad.solve(each(), **inputs).to_dict()["points"] for each in (kind, again)]
    for letter, point in motions[0].items():
        assert motions[1][letter]["position"] == pytest.approx(point["position"], abs=1e-9)


def test_an_input_is_added_in_a_table_of_its_own() -> None:
    text = example_path("four-bar").read_text("utf-8")
    line = 'crank = { angle = 60, omega = "100 rpm" }'
    apart = text.replace(f"[driver]\n{line}", "[driver.crank]\nangle = 60\nomega = 10")
    assert apart != text
    kind: Any = load_text(apart.encode(), "apart.toml")
    written = rewritten(kind(), {"angle": 100.0, "alpha": 2.0})
    assert load_text(written.encode(), "apart.toml").inputs == {
        "angle": 100.0,
        "omega": 10.0,
        "alpha": 2.0,
    }


def test_what_comes_from_no_file_has_none() -> None:
    kind: Any = vad.mechanism(
        fixed={"A": (0, 0), "D": (100, 0)},
        links={"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
        driver={"crank": {"angle": 60, "omega": 10}},
        assembly={"C": "upper"},
    )
    with pytest.raises(InputError, match="from no file"):
        rewritten(kind(), {"angle": 60.0})


def test_an_error_of_the_pose_is_one() -> None:
    kind: Any = vad.load(example_path("four-bar"))
    with pytest.raises(VadError):
        rewritten(kind(crank=400.0), {"angle": 60.0})
