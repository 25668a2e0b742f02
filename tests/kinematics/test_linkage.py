"""Linkages written by hand: what would be solved wrongly is refused by name, in one line."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import vad
from vad.errors import quoted
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of, length_of

CRANK = Bar("AB", "crank", 40.0)
GROUND = ("D", 100.0, 0.0)


def four_bar(first: tuple[Bar, ...], second: tuple[Bar, ...]) -> Linkage:
    return Linkage(angle_of("crank"), (Loop(first, second),), ground=GROUND)


def slotted(*steps: Bar | Slide, second: tuple[Bar, ...]) -> Linkage:
    return Linkage(angle_of("crank"), (Loop((CRANK, *steps), second),), ground=GROUND)


WRONG: dict[str, tuple[Callable[[], Linkage], str]] = {
    "slide without the bar that carries it": (
        lambda: slotted(-Slide("CB", "block", "lever"), second=(Bar("DC", "lever", 80.0),)),
        "loop 1: no bar of lever carries block",
    ),
    "slide against its bar": (
        lambda: slotted(Slide("BQ", "block", "lever"), second=(Bar("DQ", "lever", "block"),)),
        "loop 1: block slides against the bar of lever that carries it",
    ),
    "both unknowns in one chain": (
        lambda: four_bar((CRANK,), (Bar("DC", "rocker", 80.0), -Bar("BC", "coupler", 120.0))),
        "loop 1: both unknowns are in one chain, the first has none",
    ),
    "chains that end apart": (
        lambda: four_bar((CRANK, Bar("BC", "coupler", 120.0)), (Bar("DE", "rocker", 80.0),)),
        "loop 1: its chains end at different points, C and E",
    ),
    "broken chain": (
        lambda: four_bar((CRANK, Bar("EC", "coupler", 120.0)), (Bar("DC", "rocker", 80.0),)),
        "loop 1, first chain: is broken, EC does not begin at B",
    ),
    "chain from nowhere": (
        lambda: four_bar((CRANK, Bar("BC", "coupler", 120.0)), (Bar("XC", "rocker", 80.0),)),
        "loop 1: X, where a chain begins, is no fixed point",
    ),
    "one bar with two lengths": (
        lambda: Linkage(
            angle_of("crank"),
            (Loop((CRANK, Bar("BC", "coupler", 120.0)), (Bar("DC", "rocker", 80.0),)),),
            images=(Bar("DC", "rocker", 81.0),),
            ground=GROUND,
        ),
        "rocker: DC has two lengths, 80.0 and 81.0",
    ),
    "no number for a length": (
        lambda: four_bar((Bar("AB", "crank", None),), ()),  # type: ignore[arg-type]
        "length of AB: must be a finite number or a name, got None",
    ),
    "strut from a moving point": (
        lambda: Linkage(
            length_of("stroke"),
            (
                Loop(
                    (Slide("AS", "stroke", "strut"), Bar("SB", "strut", "stroke")),
                    (Bar("AB", "arm", 5.0),),
                ),
            ),
        ),
        "loop 1: strut must lead between two fixed points",
    ),
    "no two points": (
        lambda: four_bar((Bar("2B", "crank", 40.0),), ()),
        "ends: must be two points, got '2B'",
    ),
    "a turn that is no direction": (
        lambda: four_bar((Bar("AB", "crank", 40.0, turn=2j),), ()),
        "turn of AB: must be a unit vector, got 2j",
    ),
    "an offset without a slide": (
        lambda: four_bar((Bar("AB", "crank", 40.0, offset=2j),), ()),
        "offset of AB: goes with the length of a slide",
    ),
    "one bar with two directions": (
        lambda: Linkage(
            angle_of("crank"),
            (Loop((CRANK, Bar("BC", "coupler", 120.0)), (Bar("DC", "rocker", 80.0),)),),
            images=(Bar("DC", "rocker", 80.0, turn=1j),),
            ground=GROUND,
        ),
        "rocker: DC has two directions",
    ),
    "a slide that leaves the line of its bar": (
        lambda: slotted(
            -Slide("QB", "block", "lever", turn=1j), second=(Bar("DQ", "lever", "block"),)
        ),
        "loop 1: no bar of lever carries block",
    ),
    "a fixed point nowhere": (
        lambda: Linkage(angle_of("crank"), (), fixed={"D": complex(float("nan"), 0)}),
        "fixed point D: must be at a finite place, got (nan+0j)",
    ),
    "no loop": (lambda: Linkage(angle_of("crank"), ()), "there is no loop"),
    "a loop that the driver does not move": (
        lambda: Linkage(
            angle_of("crank"),
            (
                Loop((CRANK, Bar("BC", "coupler", 120.0)), (Bar("DC", "rocker", 80.0),)),
                Loop((Bar("AE", "prop", 80.0),), (Bar("DE", "stay", 60.0),)),
            ),
            ground=GROUND,
        ),
        "loop 2: stands still, for the angle of crank does not move it",
    ),
    "a driver in no loop": (
        lambda: Linkage(
            angle_of("motor"),
            (Loop((Bar("AE", "prop", 80.0),), (Bar("DE", "stay", 60.0),)),),
            ground=GROUND,
        ),
        "loop 1: stands still, for the angle of motor does not move it",
    ),
    "an image of a link that nothing finds": (
        lambda: Linkage(
            angle_of("crank"),
            (Loop((CRANK, Bar("BC", "coupler", 120.0)), (Bar("DC", "rocker", 80.0),)),),
            images=(Bar("DE", "lever", 30.0),),
            ground=GROUND,
        ),
        "images: no loop finds the angle of lever so far",
    ),
    "a slide on a link that nothing finds": (
        lambda: Linkage(
            angle_of("crank"),
            (
                Loop(
                    (CRANK,),
                    (Bar("DQ", "lever", 30.0), Slide("QB", "block", "arm"), Bar("BB", "arm", 1.0)),
                ),
            ),
            ground=GROUND,
        ),
        "loop 1 has 3 unknowns (the angle of lever, the length of block, the angle of arm), not "
        "two",
    ),
    "a slide along two lines": (
        lambda: Linkage(
            angle_of("crank"),
            (
                Loop((CRANK, Bar("BC", "rod", 120.0)), (Slide("AC", "slider", 0.0),)),
                Loop(
                    (Slide("AC", "slider", 30.0), Bar("CE", "arm", 50.0)),
                    (Bar("DE", "rocker", 80.0),),
                ),
            ),
            ground=GROUND,
        ),
        "slider: slides along two lines",
    ),
    "a slide with the name of a link": (
        lambda: Linkage(
            angle_of("crank"),
            (Loop((CRANK, Bar("BC", "rod", 120.0)), (Slide("AC", "rod", 0.0),)),),
        ),
        "rod: is a link, and a slide that is not on it",
    ),
    "a bar with the length of a slide elsewhere": (
        lambda: Linkage(
            angle_of("link"),
            (Loop((-Slide("OA", "a", 0.0),), (Bar("AB", "link", "b"), -Slide("OB", "b", 75.0))),),
            pivot="O",
        ),
        "link: AB has the length of b, which does not slide on it",
    ),
    "points that are no text": (
        lambda: four_bar((Bar(["A", "B"], "crank", 40.0),), ()),  # type: ignore[arg-type]
        "ends: must be two points, got ['A', 'B']",
    ),
    "a link that is no text": (
        lambda: four_bar((Bar("AB", [], 40.0),), ()),  # type: ignore[arg-type]
        "link of AB: must be a line of text, got []",
    ),
    "a slide that is no text": (
        lambda: slotted(Slide("AC", None, 0.0), second=()),  # type: ignore[arg-type]
        "name of AC: must be a line of text, got None",
    ),
    "a whole number larger than every length": (
        lambda: four_bar((Bar("AB", "crank", 10**400),), ()),
        f"length of AB: must be a finite number or a name, got {quoted(10**400)}",
    ),
    "a turn that is a number too large": (
        lambda: four_bar((Bar("AB", "crank", 40.0, turn=10**400),), ()),
        f"turn of AB: must be a unit vector, got {quoted(10**400)}",
    ),
    "a turn that leaves the range": (
        lambda: four_bar((Bar("AB", "crank", 40.0, turn=complex(1e308, 1.7e308)),), ()),
        "turn of AB: must be a unit vector, got (1e+308+1.7e+308j)",
    ),
    "a bar without a length": (
        lambda: four_bar(
            (Bar("AB", "crank", 0.0), Bar("BC", "coupler", 120.0)), (Bar("DC", "rocker", 80.0),)
        ),
        "crank: AB has no length",
    ),
    "a length beyond every length": (
        lambda: four_bar((Bar("AB", "crank", 1e201),), ()),
        "length of AB: must be between 1e-200 and 1e+200, got 1e+201",
    ),
    "a length that is next to nothing": (
        lambda: four_bar((Bar("AB", "crank", -5e-324),), ()),
        "length of AB: must be between 1e-200 and 1e+200, got 4.94066e-324",
    ),
    "an offset without an end": (
        lambda: four_bar((Bar("AB", "crank", "block", offset=complex(0, float("inf"))),), ()),
        "offset of AB: must be at a finite place, got infj",
    ),
    "an origin far away": (
        lambda: slotted(Slide("AC", "slider", 0.0, origin=1e308j), second=()),
        "origin of AC: must be within ±1e+200, got 1e+308",
    ),
    "a ground link without an end": (
        lambda: Linkage(angle_of("crank"), (), ground=("D", 1e308, 0.0)),
        "distance of D from A: must be between 1e-200 and 1e+200, got 1e+308",
    ),
    "a ground link without a direction": (
        lambda: Linkage(angle_of("crank"), (), ground=("D", 100.0, float("nan"))),
        "direction of D from A: must be a finite number, got nan",
    ),
    "a point with a digit of another script": (
        lambda: four_bar((Bar("AB\u0663", "crank", 40.0),), ()),
        "ends: must be two points, got 'AB\u0663'",
    ),
    "a point fixed twice": (
        lambda: Linkage(angle_of("crank"), (), ground=GROUND, fixed={"D": 1j}),
        "fixed point D: is given twice",
    ),
}


@pytest.mark.parametrize(("write", "message"), WRONG.values(), ids=list(WRONG))
def test_what_would_be_solved_wrongly_is_refused(
    write: Callable[[], Linkage], message: str
) -> None:
    with pytest.raises(vad.InputError) as caught:
        write()
    assert str(caught.value) == message


def test_whole_numbers_are_numbers() -> None:
    assert Slide("DC", "slider", 0).along == 0.0
    assert type(Bar("AB", "crank", 40).length) is float


def test_points_are_letters_or_letters_and_numbers() -> None:
    bar = -Bar("O2A10", "crank", 40.0)
    assert (bar.tail, bar.head, bar.start, bar.end) == ("O2", "A10", "A10", "O2")


def test_a_misspelt_link_is_refused_when_the_mechanism_is_made(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(vad.FourBar, "links", {"crank": "AB", "cuopler": "BC", "rocker": "DC"})
    with pytest.raises(vad.InputError, match="unknown link 'coupler'") as caught:
        vad.FourBar()
    assert caught.value.hint == "did you mean 'cuopler'?"
