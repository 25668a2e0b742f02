"""Which of two places a dyad takes: said once, and kept whatever the numbers become."""

from __future__ import annotations

import pytest

import vad
from tests.files.verified import BY_NAME, verified, written
from vad.errors import VadError

PRESS = BY_NAME["toggle-press"]["toml"]
LEVER = """
[fixed]
A = [0, 0]
D = [0, -150]
[links]
crank = { AB = 50 }
lever = { DC = 260 }
[guides]
B = { along = "DC", offset = 25 }
[driver]
crank = { angle = 30, omega = 10 }
"""


@pytest.mark.parametrize(
    ("word", "axis"), [("upper", 1j), ("lower", -1j), ("left", -1), ("right", 1)]
)
def test_a_word_is_kept(word, axis):
    """Of B's two places the one that lies farther where the word points."""
    press = verified("toggle-press")
    there = vad.solve(press(assembly={"B": word})).point("B").position
    places = [
        vad.solve(press(assembly={"B": each})).point("B").position for each in ("left", "right")
    ]
    assert there == max(places, key=lambda place: (place * axis.conjugate()).real)
    assert abs(places[0] - places[1]) > 100


def test_coordinates_name_the_place_that_is_nearer():
    text = PRESS.replace('B = "right"', "B = [-100, -100]").replace('D = "right"', "")
    motion = vad.solve(written(text)())
    assert motion.point("B").position.real < 0
    assert motion.to_dict()["assembly"]["B"] == "left"


def test_what_is_not_said_is_told():
    """The positive side, in the word that tells it best from the other."""
    bare = written(PRESS.replace('B = "right"', "").replace('D = "right"', ""))
    told = bare().assembly
    assert set(told) == {"B", "D"}
    again = bare(assembly=told)
    assert vad.solve(again).to_dict() == vad.solve(bare()).to_dict()


def test_a_place_is_found_with_the_file_s_own_numbers():
    """At 225° and another crank the same sign has B on the left; it does not jump."""
    motion = vad.solve(verified("toggle-press")(crank=100), angle=[45.0, 135.0, 225.0, 315.0])
    sides = []
    for a, b, c in zip(*(motion.point(name).position for name in "ABC"), strict=True):
        sides.append(((b - a).conjugate() * (c - a)).imag > 0)
    assert len(set(sides)) == 1


def test_another_place_in_python_and_in_json():
    press = verified("toggle-press")
    assert press().assembly == {"B": "right", "D": "right"}
    other = press(assembly={"D": "left"})
    assert other.assembly == {"B": "right", "D": "left"}
    assert vad.solve(other).to_dict()["assembly"] == {"B": "right", "D": "left"}
    assert (
        vad.solve(other).point("D").position.real < 0 < vad.solve(press()).slide("slider").position
    )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"B": "above"}, "B: 'above' is no place"),
        ({"A": "left"}, "unknown point with two places 'A'"),
        ("left", "must be places by point"),
        ({"B": None}, "B: None is no place"),
    ],
)
def test_a_place_that_is_none(given, message):
    with pytest.raises(VadError, match=message):
        verified("toggle-press")(assembly=given)


def test_a_pose_tells_the_places():
    """Without a word: each link lies as in the drawing."""
    motion = vad.solve(verified("jansen-pose")(), angle=50.0)
    for name, place in {"D": -35.2 + 33.6j, "F": -20.1 - 42.8j, "G": -56.0 - 35.4j}.items():
        assert motion.point(name).position == pytest.approx(place, abs=0.5)


def test_a_pose_tells_the_places_wherever_the_driver_begins():
    text = BY_NAME["jansen-pose"]["toml"].replace("angle = 50", "angle = 200")
    other = vad.solve(written(text)(), angle=50.0)
    assert other.point("H").position == vad.solve(verified("jansen-pose")()).point("H").position


@pytest.mark.parametrize(("word", "upper"), [("upper", True), ("lower", False)])
def test_a_slot_beside_its_pivot_has_two_places(word, upper):
    motion = vad.solve(written(f'{LEVER}[assembly]\nC = "{word}"')())
    b, c, d = (motion.point(name).position for name in "BCD")
    seen = (b - d) / ((c - d) / 260)
    assert seen.imag == pytest.approx(25)
    assert (c.imag > d.imag) is upper
    assert seen.real == pytest.approx(motion.slide("block").position)


def test_a_slot_through_its_pivot_can_be_seen_from_either_side():
    """As in Whitworth's quick return, whose tip lies against its block."""
    plain = LEVER.replace(", offset = 25", "")
    assert vad.solve(written(plain)()).to_dict()["assembly"] is None
    usual = vad.solve(written(plain)())
    against = vad.solve(written(f'{plain}[assembly]\nC = "lower"')())
    assert against.slide("block").position == -usual.slide("block").position
    centre = usual.point("D").position
    assert usual.point("C").position + against.point("C").position == pytest.approx(2 * centre)


def test_a_parallelogram_stays_one():
    text = """
[fixed]
A = [0, 0]
D = [150, 20]
[links]
crank = { AB = 40 }
rod = { BC = "hypot(150, 20)" }
wheel = { DC = 40 }
[driver]
crank = { angle = 60, omega = 10 }
[assembly]
C = "parallel"
"""
    motion = vad.solve(written(text)(), angle=[0.0, 60.0, 180.0, 190.0, 359.0])
    b, c = motion.point("B").position, motion.point("C").position
    assert c - b == pytest.approx([150 + 20j] * 5)
    assert motion.link("wheel").omega == pytest.approx([10.0] * 5)


def test_a_slot_through_the_pivot_has_one_place_and_a_slot_beside_it_two():
    """The place is told where there are two; a slot through the pivot may be counted backward."""
    beside, through = written(LEVER), written(LEVER.replace(", offset = 25", ""))
    assert beside().assembly == {"C": "upper"}
    assert through().assembly == {}
    for kind in (beside, through):
        upper, lower = (
            vad.solve(kind(assembly={"C": word})).point("C").position for word in ("upper", "lower")
        )
        assert upper.imag > 0 > lower.imag
        assert abs(upper + 150j) == pytest.approx(260) == abs(lower + 150j)
