"""Another order of the file, other letters, or the whole turned and moved: the same mechanism."""

from __future__ import annotations

import cmath
import re
import string
import tomllib

import numpy as np
import pytest

import vad
from tests.files.verified import BY_NAME, verified
from vad.files.linkage import fixed_points, posed_points

each = pytest.mark.parametrize("name", list(BY_NAME))
ANGLE, SHIFT = 37.0, 250 - 125j


def tables(name: str) -> dict:
    """Return the tables of a case."""
    words = ("title", "unit", "about", "source")
    return {k: v for k, v in tomllib.loads(BY_NAME[name]["toml"]).items() if k not in words}


def motion(kind, case) -> vad.Motions:
    places = np.array([pose["input"] for pose in case["poses"]])
    return vad.solve(kind(), **dict(zip(kind.inputs, [places, *case["rates"]], strict=True)))


@pytest.mark.exhaustive(4)
@each
def test_relabelled_and_in_another_order(name):
    """Points take other letters, tables run backward; the first pair of a link stays first."""
    given, case = tables(name), BY_NAME[name]
    letters = [each for each in string.ascii_uppercase if each != "Q"]
    new = dict(zip(letters, reversed(letters), strict=True))

    def other(text: str) -> str:
        named = re.fullmatch("(?:[A-Z][0-9]*)+", text)
        return "".join(new.get(each, each) for each in text) if named else text

    def renamed(thing):
        if isinstance(thing, dict):
            return {other(key): renamed(value) for key, value in thing.items()}
        return other(thing) if isinstance(thing, str) else thing

    turned = {
        table: dict(reversed(renamed(words).items())) if table != "dimensions" else words
        for table, words in given.items()
    }
    # What is not said is the positive side of the first chain: say it.
    said = {**verified(name)().assembly, **given.get("assembly", {})}
    turned["assembly"] = {other(point): place for point, place in said.items()}
    mine, own = motion(vad.mechanism(**turned), case), motion(verified(name), case)
    size = max(abs(own.point(point).acceleration).max() for point in own.points)
    for point in case["poses"][0]["points"]:
        difference = mine.point(other(point)).acceleration - own.point(point).acceleration
        assert abs(difference).max() < 1e-12 * size
    for link in own.links:
        assert mine.link(link).omega == pytest.approx(own.link(link).omega, rel=1e-11, abs=1e-11)


@pytest.mark.exhaustive(4)
@each
def test_turned_and_moved_as_a_whole(name):
    given, case = tables(name), BY_NAME[name]
    own = verified(name)
    turn = cmath.exp(1j * np.radians(ANGLE))
    described, values = own.written.description, own.written.values

    def placed(place: complex) -> complex:
        return SHIFT + turn * place

    moved = {**given}
    moved["fixed"] = {k: placed(v) for k, v in fixed_points(described, values).items()}
    if "pose" in given:
        moved["pose"] = {
            k: placed(v) for k, v in posed_points(described, values).items() if k in given["pose"]
        }
    moved["guides"] = {k: line_moved(v, placed) for k, v in given.get("guides", {}).items()}
    places = own.written.assembly({}).places
    moved["assembly"] = {point: placed(place) for point, (place, _) in places.items()}
    if "angle" in own.inputs:
        (driver, inputs), *_ = given["driver"].items()
        moved["driver"] = {driver: {**inputs, "angle": inputs["angle"] + ANGLE}}
    mine, theirs = vad.mechanism(**moved), motion(own, case)
    at = theirs.inputs[next(iter(own.inputs))] + (ANGLE if "angle" in own.inputs else 0.0)
    other = vad.solve(mine(), **dict(zip(mine.inputs, [at, *case["rates"]], strict=True)))
    for point in case["poses"][0]["points"]:
        here, there = theirs.point(point), other.point(point)
        for wanted, found in [
            (placed(here.position), there.position),
            (turn * here.velocity, there.velocity),
            (turn * here.acceleration, there.acceleration),
        ]:
            assert found == pytest.approx(wanted, rel=1e-11, abs=1e-11 * abs(wanted).max() + 1e-9)


def line_moved(line: dict, placed) -> dict:
    """Return a line of the frame elsewhere; one on a link goes with its link."""
    name = {"name": line["name"]} if "name" in line else {}
    if "y" in line:
        return {"through": placed(1j * line["y"]), "angle": ANGLE, **name}
    if "x" in line:
        return {"through": placed(complex(line["x"])), "angle": 90 + ANGLE, **name}
    return {**line, "angle": line["angle"] + ANGLE} if "angle" in line else line


@pytest.mark.parametrize("links", [("coupler", "rocker"), ("rocker", "coupler")])
def test_the_order_of_the_links_in_a_file_does_not_matter(links):
    """The loop begins with the link that hangs on the crank, and has the same bits."""
    lengths = {"coupler": {"BC": 120}, "rocker": {"DC": 80}}
    kind = vad.mechanism(
        fixed={"A": [0, 0], "D": {"from": "A", "length": 100, "angle": 0}},
        links={"crank": {"AB": 40}, **{name: lengths[name] for name in links}},
        driver={"crank": {"angle": 60, "omega": 10}},
        assembly={"C": "upper"},
    )
    (loop,) = kind().linkage().loops
    assert [[bar.ends for bar in chain] for chain in (loop.first, loop.second)] == [
        ["AB", "BC"],
        ["DC"],
    ]
    mine, own = vad.solve(kind(), alpha=3.0), vad.solve(vad.FourBar(), alpha=3.0)
    assert mine.to_dict()["links"] == own.to_dict()["links"]
    assert mine.to_dict()["points"] == {
        letter: own.to_dict()["points"][letter] for letter in mine.points
    }
