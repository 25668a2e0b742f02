"""What acts is read from words and numbers; what cannot be is one line that says what works."""

from __future__ import annotations

import math
import re
from decimal import Decimal

import numpy as np
import pytest

import vad
from vad.errors import InputError

LEVER = vad.CrankSlottedLever(rod=100, ram_height=180, points={"G": ("lever", 120)})
REFUSED = [
    ({"loads": {"at": "E", "force": 1}}, "loads: must be a list of loads"),
    ({"loads": [3]}, "load 1: must be named numbers, got 3"),
    ({"loads": [{"at": "E"}]}, "load 1: must have a force or a couple"),
    ({"loads": [{"at": "E", "force": 1, "couple": 2}]}, "load 1: must have a force or a couple"),
    ({"loads": [{"at": "X", "force": 1}]}, "load 1: unknown point 'X'"),
    ({"loads": [{"force": 1}]}, "load 1: has no point at which it acts"),
    ({"loads": [{"at": "C", "force": 1}]}, "load 1: C is a point of lever and of rod"),
    ({"loads": [{"at": "E", "on": "lever", "force": 1}]}, "load 1: E is no point of lever"),
    ({"loads": [{"at": "E", "on": "arm", "force": 1}]}, "load 1: unknown body 'arm'"),
    ({"loads": [{"at": "E", "force": math.nan}]}, "load 1: force: must be a finite number"),
    ({"loads": [{"at": "E", "force": "80 mm"}]}, "load 1: force: 'mm' is not a unit of force"),
    ({"loads": [{"at": "E", "force": 1, "way": 3}]}, "load 1: unknown word 'way'"),
    ({"loads": [{"at": "E", "force": 1, "name": "P", "angle": "x"}]}, "P: angle: 'x' is not"),
    ({"loads": [{"couple": 1}]}, "load 1: a couple needs a body"),
    ({"loads": [{"couple": 1, "at": "E"}]}, "load 1: a couple has no 'at'"),
    ({"loads": [{"couple": 1, "on": "ram"}]}, "load 1: ram does not turn: its guide takes"),
    ({"masses": [2]}, "masses: must be numbers by name"),
    ({"masses": {"arm": 2}}, "masses: unknown body 'arm'"),
    ({"masses": {"lever": -2}}, "mass of lever: must not be negative, got -2"),
    ({"masses": {"lever": {"mass": 1, "at": "E"}}}, "mass of lever: E is no point of lever"),
    ({"masses": {"lever": {"mass": 1, "at": "Q"}}}, "mass of lever: Q moves along lever"),
    ({"masses": {"lever": {"inertia": -1}}}, "mass of lever: inertia: must not be negative"),
    ({"masses": {"ram": {"mass": 1, "inertia": 1}}}, "mass of ram: ram does not turn"),
    (
        {"masses": {"lever": {"mass": 1, "inertia": 1, "radius": 1}}},
        "mass of lever: has an inertia",
    ),
    ({"gravity": "down"}, "gravity: 'down' is not a number"),
    ({"gravity": [1, 2, 3]}, "gravity: must be"),
    ({"friction": 0.1}, "friction: must be numbers by name"),
    ({"friction": {"lever": 0.1}}, "friction: unknown slide 'lever'"),
    ({"friction": {"ram": -0.1}}, "friction of ram: must not be negative"),
]


@pytest.mark.parametrize(("given", "message"), REFUSED, ids=lambda each: str(each)[:60])
def test_refused(given, message):
    with pytest.raises(InputError, match="^" + re.escape(message)) as caught:
        vad.forces(vad.solve(LEVER), **given)
    if "unknown" in message or "must be" in message or "point" in message:
        assert caught.value.hint or "finite" in message


def test_what_is_no_motion():
    with pytest.raises(InputError, match="motion: must be a motion"):
        vad.forces(LEVER)  # type: ignore[arg-type]


def test_in_space():
    with pytest.raises(InputError, match="hooke-joint moves in space") as caught:
        vad.forces(vad.solve(vad.HookeJoint()))
    assert "slider-crank" in caught.value.hint


def test_unknown_pairs_of_bodies():
    forces = vad.forces(vad.solve(LEVER))
    with pytest.raises(InputError, match="force: crank and ram have no joint") as caught:
        forces.force("crank", "ram")
    assert caught.value.hint == "crank has one with block and with frame"
    with pytest.raises(InputError, match="unknown body 'arm'"):
        forces.force("crank", "arm")


def test_units():
    """What is written with a unit is the same number in newtons, newton metres, kilograms."""
    motion = vad.solve(LEVER)
    pairs = [
        ({"at": "E", "force": "2 kN"}, {"at": "E", "force": 2000.0}),
        ({"at": "E", "force": "10 lbf"}, {"at": "E", "force": 44.482216152605}),
        ({"on": "rod", "couple": "12 lbf in"}, {"on": "rod", "couple": 1.3558179483314}),
        ({"on": "rod", "couple": "3 N m"}, {"on": "rod", "couple": 3.0}),
        ({"on": "rod", "couple": "-2 kN*m"}, {"on": "rod", "couple": -2000.0}),
    ]
    for written, plain in pairs:
        drives = [vad.forces(motion, [load]).drive for load in (written, plain)]
        assert drives[0] == pytest.approx(drives[1], rel=1e-15)
    masses = [{"lever": {"mass": m, "at": "G", **i}} for m, i in (
        ("5 lb", {"inertia": "100 kg cm^2"}), (2.26796185, {"inertia": 0.01}),
        ("2267.96185 g", {"radius": math.sqrt(0.01 / 2.26796185) * 1000.0}),
    )]  # fmt: skip
    drives = [vad.forces(motion, masses=each, gravity="9.81 m/s^2").drive for each in masses]
    assert drives == pytest.approx([drives[0]] * 3, rel=1e-13)


def test_gravity_has_a_direction():
    motion = vad.solve(LEVER, omega=0.0)
    down, same = (
        vad.forces(motion, masses={"ram": 2, "lever": 3}, gravity=g) for g in (9.81, (0, -9.81))
    )
    assert down.drive == same.drive
    assert vad.forces(motion, masses={"ram": 2.0}, gravity=(1.0, 0.0)).shaking_force == 2.0


def test_a_length_without_metres():
    """A drive is in newtons times the unit, and there is no inertia."""
    machine = vad.FourBar(length_unit="squares")
    load = [{"at": "C", "on": "rocker", "force": 10, "angle": 0}]
    metres = vad.forces(vad.solve(vad.FourBar(length_unit="m")), load).drive
    assert vad.forces(vad.solve(machine), load).drive == metres
    with pytest.raises(InputError, match="squares is no unit of length"):
        vad.forces(vad.solve(machine), masses={"coupler": 1})


def test_names_and_places():
    """A slide's point is that of the slide; a load keeps its name."""
    forces = vad.forces(
        vad.solve(LEVER), [{"name": "P", "at": "E", "force": 5}], {"block": 1, "lever": 2}, 9.81
    )
    assert [(each.name, each.kind, each.body, each.point) for each in forces.acting] == [
        ("P", "force", "ram", "E"),
        ("block", "weight", "block", "B"),
        ("block", "inertia", "block", "B"),
        ("lever", "weight", "lever", "D"),
        ("lever", "inertia", "lever", "D"),
    ]


def test_the_rod_of_a_cylinder():
    """It is a body of its own, and the file may name it."""
    tables = {
        "fixed": {"A": (0, 0), "D": (0, 250)},
        "links": {"crank": {"AB": 60}, "cylinder": {"DB": "variable", "rod": "piston"}},
        "driver": {"crank": {"angle": 60, "omega": 20}},
    }
    kind = vad.mechanism(**tables)
    motion = vad.solve(kind(points={"G": ("piston", 50)}))
    b, d, g = (motion.point(each).position for each in "BDG")
    assert abs(g - (b + 50 * (d - b) / abs(d - b))) < 1e-12
    forces = vad.forces(motion, masses={"piston": {"mass": 1, "at": "G"}, "cylinder": 2})
    assert forces.force("cylinder", "piston") == -forces.force("piston", "cylinder")
    total, sizes = forces.power
    assert abs(total) < 1e-14 * sizes
    tables["links"]["crank"] = {"AB": 60, "rod": "r"}
    with pytest.raises(InputError, match="crank: rod: only a cylinder has one"):
        vad.mechanism(**tables)
    tables["links"] = {"crank": {"AB": 60}, "cylinder": {"DB": "variable", "rod": "crank"}}
    with pytest.raises(InputError, match="a link is called crank already"):
        vad.mechanism(**tables)


def test_a_turn_is_asked_for_with_a_turn():
    machine = vad.SliderCrank()
    masses = {"slider": 1}

    def forces(angle):
        return vad.forces(vad.solve(machine, angle=angle), masses=masses)

    for angle in (60.0, np.linspace(0, 180, 37), np.geomspace(1, 361, 40), np.array([0.0, 360.0])):
        with pytest.raises(InputError, match="turn"):
            forces(angle).fluctuation  # noqa: B018
    turn = forces(np.linspace(0, 360, 361))
    assert turn.flywheel(0.02, "600 rpm") == pytest.approx(turn.flywheel(0.02, 20 * math.pi))
    for number in (np.int8(3), Decimal(3)):
        assert turn.flywheel(number, number * 10) == turn.flywheel(3, 30)
    for ratio, speed in ((0.0, 1.0), (-0.1, 1.0), (0.1, 0.0), (0.1, 5e-200), (0.1, 1e200)):
        with pytest.raises(InputError, match=r"ratio|speed"):
            turn.flywheel(ratio, speed)
    several = vad.forces(
        vad.solve(machine, angle=np.linspace(0, 360, 361)),
        masses={"slider": np.array([[1.0], [2.0]])},
    )
    assert several.fluctuation == pytest.approx([turn.fluctuation, 2.0 * turn.fluctuation])


@pytest.mark.parametrize("ask", ["mean_drive", "fluctuation"])
def test_a_driver_that_swings_has_no_mean_and_no_flywheel(ask: str):
    motion = vad.solve(vad.GateActuator(), position=np.linspace(3.5, 4.0, 9))
    found = vad.forces(motion, ["100 N @ 270 at B on arm"])
    with pytest.raises(InputError, match="actuator_rod swings to and fro"):
        getattr(found, ask)
    with pytest.raises(InputError, match="goes round"):
        found.flywheel(0.02, 10)


def test_the_slide_of_a_cylinder_has_two_names():
    """That of the slide, and that of the rod; friction makes the drive larger as it grows."""
    motion = vad.solve(vad.GateActuator(length_unit="m"))
    given = {
        "loads": ["900 N @ -90 at B on arm"],
        "masses": {"actuator_rod": 40.0},
        "gravity": 9.81,
    }
    drives = [
        vad.forces(motion, **given, friction={name: 0.2}).drive
        for name in ("actuator", "actuator_rod")
    ]
    assert drives[0] == drives[1]
    with pytest.raises(InputError, match="friction: actuator_rod is given twice"):
        vad.forces(motion, **given, friction={"actuator": 0.1, "actuator_rod": 0.1})
