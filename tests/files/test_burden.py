"""Loads, masses, gravity and friction in a file: numbers are parameters, errors have a line."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import vad
from vad.errors import InputError
from vad.files.loading import class_of
from vad.files.tables import read_text

PRESS = """\
title = "Toggle press"
gravity = 9.81
[dimensions]
side = 240
[fixed]
O = [0, 0]
C = [-105, -360]
[links]
crank  = { OA = 180 }
link   = { AB = 360 }
rocker = { CB = "side", CG = "side/2" }
rod    = { BD = 540 }
[guides]
D = { y = -360, name = "ram" }
[driver]
crank = { angle = 45, omega = "180 rpm", alpha = 50 }
[assembly]
B = "right"
D = "right"
[loads]
P = { at = "D", force = "1 kN", angle = 180 }
M = { on = "rod", couple = "-12 N m" }
Q = { at = "D", table = "card.csv", unit = "kN", angle = "180 deg" }
[masses]
rocker = { mass = "2 kg", at = "G", inertia = 0.01 }
ram = 25
[friction]
ram = 0.1
"""
CARD = "angle;force\n# of one turn\n0; 0\n90; 1.5\n180; 0.2\n"


def press(folder: Path, text: str = PRESS, card: str = CARD):
    (folder / "card.csv").write_text(card)
    (folder / "press.toml").write_text(text)
    return vad.load(folder / "press.toml")


def test_the_numbers_are_those_of_a_call(tmp_path):
    kind = press(tmp_path)
    motion = vad.solve(kind())
    loads = [
        {"at": "D", "force": 1000.0, "angle": 180},
        "-12 N m on rod",
        {"at": "D", "force": 750.0, "angle": 180},
    ]
    masses = {"rocker": {"mass": 2, "at": "G", "inertia": 0.01}, "ram": 25}
    bare = press(tmp_path, PRESS[: PRESS.index("[loads]")].replace("gravity = 9.81\n", ""))
    wanted = vad.forces(vad.solve(bare()), loads, masses, 9.81, {"ram": 0.1})
    found = vad.forces(motion)
    assert found.drive == wanted.drive
    assert found.friction == wanted.friction


def test_each_number_is_a_parameter(tmp_path):
    kind = press(tmp_path)
    numbers = {
        "P": 1000.0,
        "P_angle": 180.0,
        "M": -12.0,
        "Q_angle": 180.0,
        "rocker_mass": 2.0,
        "rocker_inertia": 0.01,
        "ram_mass": 25.0,
        "ram_friction": 0.1,
    }
    found = kind().parameters()
    assert {name: found[name] for name in numbers} == numbers
    changed = kind(P=800, P_angle=175, rocker_mass=0, ram_friction=0.2)
    burden = changed.burden
    assert burden.loads[0] == {"name": "P", "at": "D", "force": 800.0, "angle": 175.0}
    assert burden.masses["rocker"]["mass"] == 0.0
    assert burden.friction == {"ram": 0.2}


def test_what_is_given_comes_to_what_the_file_has(tmp_path):
    motion = vad.solve(press(tmp_path)())
    more = vad.forces(motion, ["100 N @ 90 at D"], {"ram": 30}, friction={"ram": 0.0})
    names = [each.name for each in more.acting]
    assert names[:4] == ["P", "M", "Q", ""]
    assert more.friction[0].force == 0
    by_name = {(each.name, each.kind): n for n, each in enumerate(more.acting)}
    assert more.acts(by_name["ram", "weight"]) == -30 * 9.81j


def test_a_table_over_a_turn(tmp_path):
    """Straight lines between the rows, and from the last one on to the first of the next turn."""
    kind = press(tmp_path)
    angles = np.array([0.0, 45.0, 90.0, 135.0, 180.0, 270.0, 360.0, 405.0, -315.0])
    found = vad.forces(vad.solve(kind(), angle=angles))
    assert found.acts(2).real == pytest.approx([0, -750, -1500, -850, -200, -100, 0, -750, -750])
    for place, value in zip(angles, found.drive, strict=True):
        assert vad.forces(vad.solve(kind(), angle=place)).drive == value


def test_a_table_over_two_turns():
    """A four-stroke engine: its card has 720 degrees."""
    table = [0, 180, 360, 540, 720], [0, 0, 500, 0, 0]
    machine = vad.SliderCrank()

    def load(angle):
        forces = vad.forces(vad.solve(machine, angle=angle), [{"at": "C", "table": table}])
        return forces.acts(0).real

    assert [load(each) for each in (360.0, 0.0, 1080.0, 720.0, 450.0)] == [500, 0, 500, 0, 250]


def test_a_table_over_a_length():
    """Beyond its ends a table over the position of a slide says nothing."""
    machine = vad.DoubleSlider()
    load = [{"at": "B", "on": "slider_b", "table": ([400, 600], [10, 30]), "unit": "kN"}]
    forces = vad.forces(vad.solve(machine, position=np.array([500.0, 700.0])), load)
    assert forces.acts(0)[0] == 20000.0
    assert np.isnan(forces.drive[1])
    with pytest.raises(InputError, match="reaches from 400 to 600, and the driver is at 700"):
        vad.forces(vad.solve(machine, position=700.0), load)


def test_it_is_pickled_with_its_table(tmp_path):
    mechanism = press(tmp_path)()
    (tmp_path / "card.csv").unlink()
    again = pickle.loads(pickle.dumps(mechanism))
    assert vad.forces(vad.solve(again)).drive == vad.forces(vad.solve(mechanism)).drive


def test_from_tables_in_python():
    kind = vad.mechanism(
        fixed={"A": (0, 0), "D": (100, 0)},
        links={"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
        driver={"crank": {"angle": 60, "omega": 10}},
        assembly={"C": "upper"},
        loads={"M": {"on": "rocker", "couple": -6}},
        masses={"coupler": 2},
        gravity=(0, -9.81),
    )
    found = vad.forces(vad.solve(kind(M=-3)))
    assert [each.kind for each in found.acting] == ["couple", "weight", "inertia"]
    assert found.acts(0) == -3.0


WRONG = [
    ('at = "D", force = "1 kN"', 'at = "X", force = 1', 21, "P: unknown point 'X'", "known"),
    ('at = "D", force = "1 kN"', 'at = "B", force = 1', 21, "P: B is a point of", "say on which"),
    (
        'at = "D", force = "1 kN"',
        'at = "D", on = "rad", force = 1',
        21,
        "unknown body 'rad'",
        "rod",
    ),
    ('force = "1 kN"', 'force = "1 mm"', 21, "P: 'mm' is not a unit of force", "try N"),
    ('force = "1 kN"', "force = nan", 21, "P: must be a finite number", None),
    ('force = "1 kN"', "farce = 1", 21, "P: unknown word 'farce'", "force"),
    ('P = { at = "D", force = "1 kN", angle = 180 }', "P = 3", 21, "P: must be words", "as in P"),
    ('force = "1 kN", angle', "angle", 21, "P: must have a force, a couple or a table", "as in"),
    ('on = "rod", couple', 'on = "ram", couple', 22, "M: ram does not turn", "rod"),
    ('on = "rod", couple', "couple", 22, "M: a couple needs a body", "rod"),
    ("card.csv", "none.csv", 23, "none.csv", None),
    ('"kN"', '"mm"', 23, "Q: unit: 'mm' is not a unit of force", "try N"),
    ('table = "card.csv"', "table = 5", 23, "Q: table: must be places and loads", None),
    ('mass = "2 kg"', "mass = -2", 25, "rocker_mass: must not be negative, got -2", "try 2"),
    ('at = "G"', 'at = "A"', 25, "A is no point of rocker", "A is on crank and link"),
    ("ram = 25", "rim = 25", 26, "unknown body 'rim'", "ram"),
    ("ram = 0.1", "rod = 0.1", 28, "unknown slide 'rod'", "ram"),
    ("ram = 0.1", 'ram = "0.1 mm"', 28, "ram_friction: 'mm' is not a unit of friction", "0.1"),
    ("inertia = 0.01", "inertia = -0.01", 25, "rocker_inertia: must not be negative", "try 0.01"),
    ("ram = 25", "ram = { mass = 25, inertia = 1 }", 26, "ram does not turn", None),
    ("ram = 0.1", "ram = -0.1", 28, "ram_friction: must not be negative, got -0.1", "try 0.1"),
    ('force = "1 kN"', "force = -inf", 21, "P: must be a finite number", None),
    ('force = "1 kN"', "force = 1e100", 21, "force: must be within", None),
    ('force = "1 kN"', "force = [1, 2]", 21, "P: must be", None),
    ("gravity = 9.81", 'gravity = "down"', 2, "gravity: 'down' is not a number", "write"),
    ("gravity = 9.81", "gravity = [1, 2, 3]", 2, "gravity: must be one number or two", "as in"),
    ("[loads]", "P = 3\n[loads]", 20, "P", None),
]


@pytest.mark.parametrize(("old", "new", "line", "message", "hint"), WRONG)
def test_what_is_wrong_has_a_line(tmp_path, old, new, line, message, hint):
    assert old in PRESS
    with pytest.raises(InputError) as caught:
        press(tmp_path, PRESS.replace(old, new))
    assert str(caught.value).startswith(f"press.toml, line {line}: ")
    assert message in str(caught.value)
    assert hint is None or hint in str(caught.value.hint)


@pytest.mark.parametrize(
    ("card", "message"),
    [
        ("angle,force\n0,1,2\n", "card.csv, line 2: has 3 columns, not two"),
        ("0,1\n90,x\n", "card.csv, line 2: '90,x' is no pair of numbers"),
        ("0,1\n", "card.csv: a table needs two rows or more"),
        ("", "card.csv: a table needs two rows or more"),
        ("0,1\n90,2\n90,3\n", "card.csv: its places must ascend, but 90 follows 90"),
        ("0,1\n90,inf\n", "card.csv: must be a finite number, got inf"),
    ],
)
def test_what_is_wrong_in_a_table(tmp_path, card, message):
    with pytest.raises(InputError) as caught:
        press(tmp_path, card=card)
    assert str(caught.value) == f"press.toml, line 23: {message}"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, "other.csv': Is a directory"),
        (b"0,1\n" * 300_000, "other.csv: is longer than 1000000 bytes"),
        (b"".join(b"%d,1\n" % place for place in range(20_001)), "has more than 20000 rows"),
        (bytes(range(256)), "other.csv: is no text in UTF-8"),
        (b"0,1\n0\x00,2\n", "other.csv, line 2: '0?,2' is no pair of numbers"),
    ],
    ids=["a folder", "huge", "many rows", "no text", "a zero"],
)
def test_what_is_no_table(tmp_path, content, message):
    path = tmp_path / "other.csv"
    if content is None:
        path.mkdir()
    else:
        path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        press(tmp_path, PRESS.replace("card.csv", "other.csv"))
    assert str(caught.value).startswith("press.toml, line 23: ")
    assert message in str(caught.value)


def test_a_text_from_elsewhere_names_no_file(tmp_path):
    """A window and a batch on another machine get the text alone, and read no file for it."""
    with pytest.raises(InputError, match="line 23: Q: table: must be places and loads"):
        class_of(read_text(PRESS.replace("card.csv", "/etc/passwd"), "press.toml"))


def test_a_link_may_be_called_frame_where_nothing_loads_it(tmp_path):
    text = (
        PRESS[: PRESS.index("[loads]")].replace("rocker =", "frame =").replace("gravity = 9.81", "")
    )
    machine = press(tmp_path, text)()
    assert not machine.burden
    with pytest.raises(InputError, match="two bodies are called frame") as caught:
        vad.forces(vad.solve(machine), ["1 N at D"])
    assert caught.value.hint == "call the link or the slide otherwise"
