"""Files that cannot be: one line with the file and the line, and a hint where something helps."""

from __future__ import annotations

import pytest

import vad
from tests.files.verified import BY_NAME, written
from vad.errors import InputError, UsageError
from vad.files.examination import examine
from vad.files.examples import example_path

LESSON = """\
title = "Lesson"
[fixed]
A = [0, 0]
D = [100, 0]
[links]
crank = { AB = 40 }
coupler = { BC = 120, BP = 60, CP = 80 }
rocker = { DC = 80 }
[driver]
crank = { angle = 60, omega = 10 }
[assembly]
C = "upper"
"""
TITLE, FIXED, CRANK, DRIVER = '"Lesson"', "A = [0, 0]", "{ AB = 40 }", "angle = 60, omega = 10"
COUPLER, ROCKER, DC, PLACE = "BP = 60, CP = 80", "rocker = { DC = 80 }", "DC = 80", 'C = "upper"'
GUIDE = "[guides]\nC = "


def refused(old: str, new: str) -> InputError:
    """Return the error of the lesson with something else in it."""
    assert old in LESSON
    with pytest.raises(InputError) as caught:
        written(LESSON.replace(old, new, 1))
    assert not isinstance(caught.value, UsageError)  # which would be a wrong command
    return caught.value


def test_the_lesson_itself_is_right():
    assert written(LESSON)().assembly == {"C": "upper"}


#: What stands in the place of what, the line that is named, what is said, and the hint.
WRONG = [
    ("[links]", "[link]", 5, "unknown table 'link'", "did you mean 'links'?"),
    (TITLE, '"x"\ncrank = { AB = 3 }', 2, "unknown table 'crank'", "known"),
    ("title", "titel", 1, "unknown word 'titel'", "did you mean 'title'?"),
    (TITLE, "3", 1, "title: must be a line of text", None),
    (TITLE, '"x"\nunit = "kg"', 2, "unit: 'kg' is not a unit of length", "mm, cm"),
    (TITLE, '"Lesson', 1, "illegal character", None),
    ("[fixed]", "[fixed", 2, "expected ']'", None),
    ("[fixed]", "[fixed]\n[fixed]", 3, "twice", None),
    (DC, "DC = 80, DC = 70", 8, "duplicate", None),
    # points
    (FIXED, "A = [0]", 3, "A: must be two coordinates, got [0]", "A = [0, 0]"),
    (FIXED, "a = [0, 0]", 3, "'a' is no point", "a capital letter"),
    (FIXED, 'A = { from = "D", length = 3, angle = 0 }', 3, "no fixed point above it", None),
    ("D = [100, 0]", 'D = { from = "A", length = 3 }', 4, "D: is no place", "angle = 0"),
    ("D = [100, 0]", 'D = ["1/0", 0]', 4, "D: '1/0' has no value", None),
    # numbers
    (DC, "DC = -80", 8, "rocker: must be positive, got -80", "try 80"),
    (DC, "DC = nan", 8, "rocker: must be a finite number", None),
    (DC, "DC = true", 8, "rocker: must be a number, got True", None),
    (DC, 'DC = "8 kg"', 8, "rocker: 'kg' is not a unit of length", "mm, cm"),
    (DC, 'DC = "arm/2"', 8, "rocker: unknown dimension 'arm'", "under [dimensions]"),
    (DC, 'DC = "1/0"', 8, "rocker: '1/0' has no value", None),
    (DC, 'DC = "sqrt(-1)"', 8, "rocker: 'sqrt(-1)' has no value", None),
    (DC, 'DC = "1 - 3"', 8, "rocker: 1 - 3 must be positive, got -2", None),
    (DC, 'DC = "__import__(1)"', 8, "is no number and no expression", "a/2"),
    (DC, 'DC = "().__class__"', 8, "is no number and no expression", "a/2"),
    (DC, 'DC = "9**9**9**9"', 8, "has no value", None),
    # names
    (ROCKER, "angle = { DC = 80 }", 8, "angle: is a word of the program's own", "angle_1"),
    (ROCKER, "letters = { DC = 80 }", 8, "letters: is a word of the program's own", "_1"),
    (ROCKER, "length_unit = { DC = 80 }", 8, "length_unit: is a word of the", "_1"),
    (ROCKER, "lambda = { DC = 80 }", 8, "lambda: is a word of the program's own", "lambda_1"),
    (TITLE, '"x"\n[dimensions]\ncrank = 3', 8, "two numbers of this name", None),
    (ROCKER, '"a b" = { DC = 80 }', 8, "a b: must be one word", "feed_rod"),
    ("coupler = ", f"c{40 * 'x'} = ", 7, "has 41 letters, and may have 40", None),
    (DC, f"DC{40 * '1'} = 80", 8, "has 42 letters, and may have 40", None),
    (TITLE, f'"x"\n[dimensions]\n{41 * "a"} = 3', 3, "has 41 letters, and may have 40", None),
    (ROCKER, GUIDE + f'{{ y = 0, name = "{41 * "a"}" }}', 9, "has 41 letters", None),
    (CRANK, f'{{ AB = "variable", rod = "{41 * "a"}" }}', 6, "has 41 letters", None),
    # links
    (CRANK, "{ ab = 40 }", 6, "crank: cannot read 'ab'", "two letters are a distance"),
    (CRANK, "{ BAD = 40 }", 6, "crank: needs a distance", "{ AB = 60 }"),
    (CRANK, "40", 6, "crank: must be distances", "{ AB = 60 }"),
    (CRANK, "{ AB = 4 cm }", 6, "unclosed inline table", 'in quotes: "4 cm"'),
    (f"crank = {CRANK}", "AB = 40", 6, "AB: must be distances", "where crank is its name"),
    (DC, "DC = 80 mm", 8, "unclosed inline table", 'in quotes: "80 mm"'),
    (PLACE, "C = upper", 12, "invalid value", 'in quotes: "upper"'),
    (PLACE, 'C = "upper" }', 12, "newline", None),
    (CRANK, '"AB"', 6, "crank: the pose does not say where B is", "[pose]"),
    (CRANK, "{ AA = 40 }", 6, "crank: cannot read 'AA'", None),
    (DC, "DC = 80, CD = 70", 8, "rocker: CD is DC, which is given already", None),
    (COUPLER, "BP = 60, CP = 50", 7, "the triangle BCP with sides 120, 60 and 50", "than 110"),
    (COUPLER, "BP = 60, CBP = 20, CP = 80", 7, "coupler: P is fixed twice", None),
    (COUPLER, "CBP = 20", 7, "CBP: no distance leads to P", "add BP = 100"),
    (COUPLER, "EP = 20", 7, "EP does not lead to another point of the link", None),
    (COUPLER, f'{COUPLER}, sense = "left"', 7, "sense: cannot read 'left'", "clockwise"),
    ("BC = 120,", 'BC = "variable",', 7, "a cylinder has two points", None),
    # guides
    (ROCKER, GUIDE + "{ y = 0, z = 3 }", 9, "C: unknown word 'z'", "known: y, x"),
    (ROCKER, GUIDE + '{ y = 0, under = "Q" }', 9, "C: under: only a link has a point", None),
    (ROCKER, GUIDE + '{ along = "BP", under = 4 }', 9, "C is a point of coupler itself", None),
    (ROCKER, GUIDE + "{ angle = 3 }", 9, "C: is no line", "{ y = 20 }"),
    (ROCKER, GUIDE + '{ along = "XY" }', 9, "along: no link has both X and Y", None),
    (ROCKER, GUIDE + '{ along = "BP" }', 9, "C is a point of coupler itself", None),
    (ROCKER, GUIDE + '{ through = "Q", angle = 3 }', 9, "neither a fixed point", "along"),
    (ROCKER, GUIDE + '{ y = 0, name = "crank" }', 9, "a link is called crank", "a name"),
    (ROCKER, GUIDE + '{ y = "1/0" }', 9, "C: '1/0' has no value", None),
    (PLACE, f"{PLACE}\n[friction]\nfoo = 1", 14, "friction: unknown slide 'foo'", None),
    # the driver
    ("crank = { angle", "crnk = { angle", 10, "unknown driver 'crnk'", "'crank'"),
    (
        "crank = { angle = 60, omega = 10 }",
        "angle = 60",
        10,
        "unknown driver 'angle'",
        "as in crank = { angle = 60, omega = 10 }",
    ),
    (DRIVER, "angle = 60, omga = 10", 10, "unknown input of crank 'omga'", "'omega'"),
    (DRIVER, "angle = 60", 10, "crank: has no omega", "omega = 10"),
    (DRIVER, 'angle = 60, omega = "10 mm"', 10, "'mm' is not a unit of turning", "rpm"),
    ("[driver]\n", "[driver]\nrocker = { angle = 3, omega = 1 }\n", 9, "not 2", None),
    # places
    (PLACE, 'C = "above"', 12, "C: 'above' is no place", "upper, lower"),
    (PLACE, "C = upper", 12, "invalid value", 'in quotes: "upper"'),
    (PLACE, 'E = "upper"', 12, "unknown point 'E'", "A, B, C, D, P"),
    (PLACE, 'B = "upper"', 12, "B: has one place only", "two places have C, P"),
    (PLACE, f'{PLACE}\nP = "lower"', 12, "C: cannot be so while P is lower", "enough"),
    (PLACE, 'C = "parallel"', 12, "BC and the side opposite it differ by 20", "equal"),
    (DC, "DC = 20", 12, "C cannot be reached at the driver's place: it misses by 12.82", None),
    (ROCKER, GUIDE + "{ y = 0 }", 13, "neither of its two places is the upper", "right"),
    (PLACE, f"{PLACE}\n[pose]\nA = [3, 4]", 14, "A: is a fixed point already", None),
    # mobility
    (DC, "DC = 80, DA = 100", 8, "pinned to the frame at D and A, so it cannot move", None),
    (ROCKER, f"{ROCKER}\narm = {{ PE = 40 }}", 9, "3·4 − 2·5 = 2", "arm: is held at one"),
    (ROCKER, f"{ROCKER}\n[guides]\nE = {{ y = 3 }}", 10, "E: slides, but no link has", None),
    (ROCKER, f"{ROCKER}\narm = {{ DP = 40 }}", 5, "3·4 − 2·6 = 0", "can be left out"),
    (ROCKER, f"{ROCKER}\narm = {{ DC = 70 }}", 9, "= 0 degrees", "both have D and C"),
    (ROCKER, "rear rocker = { DC = 80 }", 8, "expected '='", "as in rear_rocker"),
    (ROCKER, f"{ROCKER}\narm = {{ EF = 40 }}", 9, "arm: shares no point with the rest", None),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "line", "message", "hint"), WRONG)
def test_what_is_wrong_is_said_with_its_line(old, new, line, message, hint):
    error = refused(old, new)
    assert str(error).startswith(f"lesson.toml, line {line}: ")
    assert message in str(error)
    if hint is None:
        assert error.hint is None or "known" not in error.hint
    else:
        assert hint in str(error.hint)


def test_a_file_without_a_driver_has_no_line_to_name():
    error = refused("[driver]\ncrank = { angle = 60, omega = 10 }\n", "")
    assert str(error) == "lesson.toml: one link or slide drives, and none does"


def test_the_other_place_of_an_earlier_dyad_may_help():
    press = BY_NAME["toggle-press"]["toml"].replace('B = "right"', 'B = "left"')
    with pytest.raises(InputError, match=r"line 22: .* D cannot be reached .* misses by") as caught:
        written(press.replace("BD = 540", "BD = 200"))
    way = "B = 'right' under [assembly]"
    assert caught.value.hint == f"with B at its other place it would close: {way}"


def test_a_triad_is_refused_with_the_drivers_that_would_do():
    text = BY_NAME["stephenson-3"]["toml"].replace("crank = { angle", "output = { angle")
    with pytest.raises(InputError) as caught:
        written(text)
    assert "line 9: crank, coupler, rocker, arm can only be found together" in str(caught.value)
    assert caught.value.hint == "driven at the crank or the rocker it is dyads alone"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, "No such file"),
        (b"", "is empty"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "is no text in UTF-8"),
        (b"a = 1\n" * 20_000, "is longer than 100000 bytes"),
        (b"[" * 5_000, "lesson.toml"),
    ],
)
def test_what_is_no_file_of_a_mechanism(tmp_path, content, message):
    path = tmp_path / "lesson.toml"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError, match=message):
        vad.load(path)


def test_a_folder_is_no_file(tmp_path):
    with pytest.raises(InputError, match="directory"):
        vad.load(tmp_path)


def test_tables_are_named_where_there_are_no_lines():
    tables = {
        "fixed": {"A": (0, 0), "D": (100, 0)},
        "links": {"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
        "driver": {"crank": {"angle": 60, "omega": 10}},
    }
    for wrong, message in [
        ({"links": {**tables["links"], "rocker": {"DC": -8}}}, "links: rocker: must be positive"),
        ({"fixed": {"A": (0, 0), "D": "there"}}, "fixed: D: must be two coordinates"),
        ({"assembly": {"C": "above"}}, "assembly: C: 'above' is no place"),
        ({"driver": {"crank": {"angle": object(), "omega": 1}}}, "tables: "),
        ({"links": 3}, "links: must be a table"),
    ]:
        with pytest.raises(InputError) as caught:
            vad.mechanism(**{**tables, **wrong})
        assert str(caught.value).startswith(message)


def test_a_stephenson_chain_of_the_second_kind_is_no_dyads_wherever_it_is_driven():
    links = {
        "crank": {"AB": 30},
        "coupler": {"BC": 90, "BE": 50, "CBE": 30},
        "rocker": {"DF": 80, "DG": 60, "FDG": 40},
        "front": {"CF": 50},
        "back": {"EG": 60},
    }
    with pytest.raises(InputError, match="coupler, rocker, front, back can only be") as caught:
        vad.mechanism(
            fixed={"A": (0, 0), "D": (100, 0)},
            links=links,
            driver={"crank": {"angle": 60, "omega": 10}},
        )
    assert caught.value.hint == "no other driver makes it dyads"


def example_with(name: str, *changes: tuple[str, str]) -> InputError:
    """Return the error of an example of the program with something else in it."""
    text = example_path(name).read_text("utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    with pytest.raises(InputError) as caught:
        examine(written(text))
    return caught.value


def test_a_pivot_within_the_circle_of_the_crank():
    """The lever's tip can be at its other place, which is told though the block stands at one."""
    error = example_with("shaper", ("D = [0, -300]", "D = [0, 99.9]"))
    assert "line 25: with these lengths E cannot be reached" in str(error)
    assert error.hint == "with C at its other place it would close: C = 'right' under [assembly]"


def test_a_driver_that_drives_nothing():
    text = "[fixed]\nA = [0, 0]\n[links]\ncrank = { AB = 40 }\n[driver]\ncrank = "
    with pytest.raises(InputError) as caught:
        written(text + "{ angle = 60, omega = 10 }\n")
    assert str(caught.value) == "lesson.toml, line 6: crank: drives nothing else"
    assert "coupler = { BC = 120 }" in str(caught.value.hint)


def test_two_links_that_are_one():
    """The count of freedoms is 1, but it is the pivot D that is free."""
    error = example_with("roberts", ('DC = "side"', 'BP = "side"'))
    assert "line 16: rocker: has B and P in common with coupler, so both are one" in str(error)


@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        ("whitworth-ram", "A = { along", "O2 = { along", "line 12: arm: hangs on points that"),
        (
            "four-bar",
            "[driver]",
            "prop = { AX = 80 }\nstay = { DX = 60 }\n\n[driver]",
            "prop: hangs",
        ),
    ],
)
def test_a_link_that_the_driver_does_not_move(name, old, new, message):
    assert message in str(example_with(name, (old, new)))


@pytest.mark.parametrize("word", ["{}", "[]", "[[]]", "{ x = 1 }", "true", "1979-05-27"])
@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("v-engine", 'B = { through = "O"', "B = { through = ?"),
        ("shaper", "D = [0, -300]", "D = { from = ?, length = 300, angle = -90 }"),
        ("shaper", 'along = "DC"', "along = ?"),
        ("shaper", 'along = "DC"', 'along = "DC", under = ?'),
        ("shaper", 'name = "ram"', "name = ?"),
        ("shaper", "BAF = 90", "BAF = 90, sense = ?"),
        ("shaper", 'E = "right"', "E = ?"),
        ("shaper", "angle = 120", "angle = ?"),
        ("shaper", "DC = 620", "DC = ?"),
        ("shaper", "{ DC = 620 }", "?"),
        ("shaper", 'title  = "Shaper with its feed"', "title = ?"),
        ("roberts", "side = 120", "side = ?"),
    ],
)
def test_a_value_of_another_kind_is_refused_with_its_line(name, old, new, word):
    error = example_with(name, (old, new.replace("?", word)))
    assert str(error).startswith("lesson.toml, line ")
