"""What a file may say: several ways to the same mechanism, and numbers that become parameters."""

from __future__ import annotations

import math

import pytest

import vad
from tests.files.verified import written

FOUR_BAR = """\
[fixed]
A = [0, 0]
D = {d}
[links]
crank = {{ AB = 40 }}
coupler = {{ BC = 120{point} }}
rocker = {{ DC = {rocker} }}
[driver]
crank = {{ angle = {angle}, omega = {omega} }}
[assembly]
C = "upper"
"""
PLAIN = {"d": "[100, 0]", "point": "", "rocker": "80", "angle": "60", "omega": "10"}


def four_bar(**words: str) -> str:
    return FOUR_BAR.format(**{**PLAIN, **words})


def pose(text: str, point: str = "C") -> complex:
    return vad.solve(written(text)()).point(point).position


def test_the_point_under_a_block_has_the_name_that_is_given():
    lever = """\
[fixed]
A = [0, 0]
D = [0, -100]
[links]
crank = { AB = 40 }
lever = { DC = 200 }
[guides]
B = { along = "DC" }
[driver]
crank = { angle = 60, omega = 10 }
"""
    named = written(lever.replace('"DC" }', '"DC", under = "B4" }'))
    (own,), (given,) = written(lever)().linkage().loops, named().linkage().loops
    assert "DQ" in str(own)
    assert "DB4" in str(given)
    for wrong in ("C", "", "B4C"):
        with pytest.raises(vad.VadError, match="line 8: B: under: "):
            written(lever.replace('"DC" }', f'"DC", under = "{wrong}" }}'))


def test_a_file_s_four_bar_is_the_built_in_one():
    """And to the bit: both are one linkage."""
    mine, own = vad.solve(written(four_bar())()), vad.solve(vad.FourBar())
    for name in own.links:
        link, other = mine.link(name), own.link(name)
        assert (link.angle, link.omega, link.alpha) == (other.angle, other.omega, other.alpha)
    assert mine.point("C").acceleration == own.point("C").acceleration


@pytest.mark.parametrize(
    "words",
    [
        {"d": '{ from = "A", length = 100, angle = 0 }'},
        {"d": '["10 cm", 0]'},
        {"rocker": '"8 cm"'},
        {"rocker": '"160 / 2"'},
        {"rocker": '"100 * sin(53.13010235415598)"'},
        {"angle": '"1.0471975511965976 rad"'},
    ],
)
def test_other_words_for_the_same_four_bar(words):
    assert pose(four_bar(**words)) == pytest.approx(pose(four_bar()), rel=1e-14)


def test_speeds_with_units():
    turning = written(four_bar(omega='"120 rpm"')).inputs["omega"]
    assert turning == pytest.approx(4 * math.pi, rel=1e-15)


@pytest.mark.parametrize(
    ("point", "along", "aside"),
    [
        (", BP = 60", 60, 0),  # behind B's letter: towards C
        (", PB = 60", -60, 0),  # before it: beyond B
        (", CP = 60", 180, 0),
        (", BP = 60, CBP = 30", 60 * math.cos(math.pi / 6), 30),
        (", BP = 60, CBP = -90", 0, -60),
        (", BP = 60, PBC = 90", 0, -60),
        (", BP = 72, CP = 96", 43.2, 57.6),  # 3 : 4 : 5
        (', BP = 72, CP = 96, sense = "clockwise"', 43.2, -57.6),
        (", CP = 60, BCP = 90", 120, -60),
        (", BE = 60, CBE = 90, EP = 30, BEP = 90", 30, 60),  # by way of another point
    ],
)
def test_a_further_point_of_a_link(point, along, aside):
    motion = vad.solve(written(four_bar(point=point))())
    b, c, p = (motion.point(name).position for name in "BCP")
    assert (p - b) / ((c - b) / 120) == pytest.approx(complex(along, aside), abs=1e-12)


def test_every_number_is_a_parameter_named_by_its_place():
    text = """
[dimensions]
arm = 80
[fixed]
A = [0, 0]
D = [100, -10]
G = { from = "D", length = 90, angle = 10 }
[links]
crank = { AB = 40 }
coupler = { BC = 120, BE = 50, CBE = 30 }
rocker = { DC = "arm" }
rod = { EF = 150 }
[guides]
F = { through = "G", angle = 20, offset_ = 3 }
[driver]
crank = { angle = 60, omega = 10 }
""".replace(", offset_ = 3", "")
    kind = written(text)
    assert kind().parameters() == {
        "arm": 80, "Dx": 100, "Dy": -10, "DG": 90, "G_angle": 10, "crank": 40, "BC": 120,
        "BE": 50, "CBE": 30, "rod": 150, "F_angle": 20,
    }  # fmt: skip
    other = vad.solve(kind(arm=85, BE=60))
    b, c, d, e = (other.point(name).position for name in "BCDE")
    assert abs(c - d) == pytest.approx(85)
    assert abs(e - b) == pytest.approx(60)


def test_points_with_numbers():
    text = four_bar()
    for old, new in {"A =": "O2 =", "D =": "O4 =", "AB": "O2A", "BC": "AB", "DC": "O4B"}.items():
        text = text.replace(old, new)
    text = text.replace('C = "upper"', 'B = "upper"')
    motion = vad.solve(written(text)())
    assert motion.points == ("O2", "O4", "A", "B")
    assert motion.point("B").position == pose(four_bar())
    assert motion.to_dict()["points"]["O4"]["position"] == [100.0, 0.0]


def test_slides_have_names_of_their_own_or_usual_ones():
    text = """
[fixed]
A = [0, 0]
[links]
crank = { AB = 40 }
rod = { BC = 120 }
other = { BE = 130 }
third = { BF = 140 }
[guides]
C = { y = 0 }
E = { y = 20 }
F = { x = 0, name = "ram" }
[driver]
crank = { angle = 60, omega = 10 }
"""
    assert vad.solve(written(text)()).slides == ("slider_c", "slider_e", "ram")


@pytest.mark.parametrize(
    ("line", "zero", "way"),
    [
        ("{ y = 20 }", 20j, 1),
        ("{ x = 90 }", 90, 1j),
        ('{ through = "D", angle = 30 }', 100, complex(math.sqrt(0.75), 0.5)),
        ("{ through = [70, 5], angle = 90 }", 70 + 5j, 1j),
        ('{ along = "AD" }', 0, 1),
        ('{ along = "DA", offset = 15 }', 100 - 15j, -1),
    ],
)
def test_lines_of_the_frame_and_where_slides_count_from(line, zero, way):
    text = four_bar().replace("rocker = { DC = 80 }", f"[guides]\nC = {line}")
    motion = vad.solve(written(text.replace('C = "upper"', ""))())
    (name,) = motion.slides
    c = motion.point("C").position
    assert c == pytest.approx(zero + way * motion.slide(name).position, abs=1e-12)
    assert abs(c - motion.point("B").position) == pytest.approx(120)


@pytest.mark.parametrize(
    ("line", "zero", "along", "aside"),
    [
        ('{ along = "DC" }', "D", "C", 0),
        ('{ along = "DC", offset = 10 }', "D", "C", 10),
        ('{ along = "CD" }', "C", "D", 0),
        ('{ along = "EC", offset = -5 }', "E", "C", -5),
    ],
)
def test_slots_of_links_and_where_slides_count_from(line, zero, along, aside):
    """Along the line from the point that is named first, or from its foot."""
    text = f"""
[fixed]
A = [0, 0]
D = [0, -120]
[links]
crank = {{ AB = 50 }}
lever = {{ DC = 250, DE = 30, CDE = 70 }}
[guides]
B = {line}
[driver]
crank = {{ angle = 60, omega = 10 }}
"""
    motion = vad.solve(written(text)())
    b, start, end = (motion.point(name).position for name in ("B", zero, along))
    seen = (b - start) / ((end - start) / abs(end - start))
    assert seen == pytest.approx(complex(motion.slide("block").position, aside), abs=1e-12)


@pytest.mark.parametrize("pair", ["DB", "BD"])
def test_a_cylinder_s_slide_bears_its_name(pair):
    text = f"""
[fixed]
A = [0, 0]
D = [0, 250]
[links]
crank = {{ AB = 60 }}
cylinder = {{ {pair} = "variable" }}
[driver]
cylinder = {{ position = 230, velocity = 5 }}
[assembly]
B = "left"
"""
    motion = vad.solve(written(text)())
    b, d = motion.point("B").position, motion.point("D").position
    assert (abs(b), abs(b - d)) == (pytest.approx(60), pytest.approx(230))
    assert motion.slide("cylinder").position == 230
    assert b.real < 0
    way = b - d if pair == "DB" else d - b
    angle = math.degrees(math.atan2(way.imag, way.real)) % 360
    assert motion.link("cylinder").angle == pytest.approx(angle)


def test_tables_in_python_are_those_of_a_file():
    tables = vad.mechanism(
        fixed={"A": (0, 0), "D": 100 + 0j},
        links={"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
        driver={"crank": {"angle": 60, "omega": 10}},
        assembly={"C": "upper"},
        title="My four-bar",
    )
    assert tables.name == "my-four-bar"
    assert vad.solve(tables()).point("C").position == pose(four_bar())
