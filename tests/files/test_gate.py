"""Numbers, names and texts of a file pass one gate: beyond their limits they have a line."""

from __future__ import annotations

import time

import pytest

import vad
from tests.files.test_wrong_files import DC, DRIVER, LESSON, PLACE, refused
from tests.files.verified import written
from vad.errors import InputError
from vad.files.examples import example_path


def caught(text: str) -> InputError:
    """Return the error of a text."""
    with pytest.raises(InputError) as raised:
        written(text)
    return raised.value


@pytest.mark.parametrize("number", ["9" * 4301, "-" + "9" * 60_000, "9_" * 3000 + "9", "9" * 601])
def test_a_number_of_more_digits_than_python_reads(number):
    error = refused("D = [100, 0]", f"D = [{number}, 0]")
    assert str(error) == "lesson.toml, line 4: has a number of more than 600 digits"


@pytest.mark.parametrize("sign", ["\x85", "\u2028", "\u2029", "\x0b", "\x1c"])
def test_only_toml_s_own_line_breaks_count(sign):
    """Python breaks lines at more characters, of which a remark or a text may have some."""
    name = "\\u000b" if sign < " " else sign
    text = LESSON.replace('"Lesson"', f'"Lesson"\nabout = "{name}"', 1).replace(
        "DC = 80", "DC = -8"
    )
    if sign >= "\x7f":
        text = text.replace(name, "plain").replace('"plain"', f'"plain"  # {sign * 3}')
        assert "line 9: rocker: must be positive" in str(caught(text))
    else:
        assert "line 2: about: must be a line of text, without U+000B" in str(caught(text))


@pytest.mark.parametrize(
    "rocker",
    [
        "[links.rocker]\nDC = -8\n",
        "[ links . rocker ]\nDC = -8\n",
        '[links."rocker"]\nDC = -8\n',
        "[links]\nrocker.DC = -8\n",
        '[links]\n"rocker" = { DC = -8 }\n',
        "[links]\n'rocker'.'DC' = -8\n",
    ],
)
def test_a_table_within_a_table_has_a_line(rocker):
    text = rocker + "[fixed]\nA = [0, 0]\nD = [100, 0]\n[driver.crank]\nangle = 60\nomega = 10\n"
    if rocker.startswith("[links]"):
        text = text.replace("[links]\n", "[links]\ncrank = { AB = 40 }\ncoupler.BC = 120\n")
    else:
        text = "[links.crank]\nAB = 40\n[links.coupler]\nBC = 120\n" + text
    at = next(n for n, line in enumerate(text.split("\n"), 1) if "rocker" in line)
    assert str(caught(text)) == f"lesson.toml, line {at}: rocker: must be positive, got -8"
    rest = text.replace("-8", "80")
    assert "line" in str(caught(rest.replace("omega = 10", "")))
    assert written(rest)().parameters()["rocker"] == 80.0


def test_a_table_in_one_line_has_a_line():
    text = "fixed = { A = [0, 0] }\nlinks = { crank = { AB = -4 } }\n"
    assert str(caught(text)).startswith("lesson.toml, line 2: crank: must be positive")


@pytest.mark.parametrize(
    ("name", "plain", "said"),
    [
        ("µ", "\u03bc (U+03BC)", "U+00B5 MICRO SIGN"),
        ("ﬁx", "fix (U+0066 U+0069 U+0078)", "U+FB01 LATIN SMALL LIGATURE FI"),
        ("e\u0301", "\u00e9 (U+00E9)", "U+0301 COMBINING ACUTE ACCENT"),
    ],
)
def test_a_name_that_python_reads_as_another_is_refused_with_its_line(name, plain, said):
    error = refused("[links]", f'[dimensions]\n"{name}" = 40\n[links]')
    assert str(error) == f"lesson.toml, line 6: {name}: has {said}, as no name may have"
    assert error.hint == f"write {plain}"


def test_a_name_of_any_script_is_a_dimension():
    text = LESSON.replace("[links]", "[dimensions]\n'größe' = 40\n'λ' = 2\n[links]")
    kind = written(text.replace("{ AB = 40 }", '{ AB = "größe * λ / 2" }'))
    assert kind().parameters()["größe"] == 40.0


@pytest.mark.parametrize(
    ("title", "said"),
    [
        ("👩\u200d🔧 at work", "U+200D ZERO WIDTH JOINER"),
        ("left\u2028right", "U+2028 LINE SEPARATOR"),
        ("\u202egnp.exe", "U+202E RIGHT-TO-LEFT OVERRIDE"),
    ],
)
def test_a_character_that_is_not_printed_is_named(title, said):
    error = refused("Lesson", title)
    assert str(error) == f"lesson.toml, line 1: title: must be a line of text, without {said}"


HUGE, TINY = "must be between 1e-200 and 1e+200, got", "are at the same place"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("D = [100, 0]", "D = [1e308, 0]", f"line 4: Dx: {HUGE} 1e+308"),
        ("D = [100, 0]", 'D = { from = "A", length = 1e-201, angle = 0 }', f"AD: {HUGE} 1e-201"),
        ("D = [100, 0]", 'D = { from = "A", length = 5e-324, angle = 0 }', "line 4: AD: must be"),
        (DC, "DC = 1e201", f"line 8: rocker: {HUGE} 1e+201"),
        (DC, "DC = 5e-324", f"line 8: rocker: {HUGE} 4.94066e-324"),
        (DC, 'DC = "1e150 * 1e60"', f"'1e150 * 1e60' {HUGE} 1e+210"),
        (DC, 'DC = "1e-150 / 1e60"', f"rocker: 1e-150 / 1e60 {HUGE} 1e-210"),
        (DC, 'DC = "1e300 km"', f"line 8: rocker: {HUGE} 1e+306"),
        (DC, 'DC = "1e999 km"', "line 8: rocker: must be a finite number, got inf"),
        (PLACE, "C = [1e300, 0]", "line 12: C: [1e+300, 0] is no place"),
        (DRIVER, "angle = 60, omega = 1e61", "line 10: omega: must be within ±1e+60"),
        (DRIVER, "angle = 60, omega = nan", "line 10: omega: must be a finite number"),
        (DRIVER, 'angle = 60, omega = "60 nan"', "omega: 'nan' is not a unit of turning speed"),
        (DRIVER, f"angle = 60, omega = {'9' * 400}", "line 10: omega: must be a finite number"),
    ],
)
def test_the_limits_of_lengths_hold_when_a_file_is_loaded(old, new, said):
    assert said in str(refused(old, new))


@pytest.mark.parametrize("size", ["1e-201", "5e-324", "0"])
def test_points_that_nearly_coincide_are_one_place(size):
    text = example_path("leg-from-coordinates").read_text("utf-8")
    text = text.replace("C = [-38, -7.8]", "C = [0, 5]").replace("[-19.7, -42.6]", f"[{size}, 5]")
    assert str(caught(text)) == "lesson.toml, line 15: link_c: C and F are at the same place"


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"A": (10**5000, 0)}, "fixed: Ax: must be a finite number"),
        ({"A": (-(10**400), 0)}, "fixed: Ax: must be a finite number"),
        ({3: (0, 0)}, "tables: a name must be text, got 3"),
        ({"A": object}, "tables: <class 'object'> is neither a number nor text"),
        ({"A": (0, None)}, "fixed: Ay: must be a number, got None"),
        ({"A": (0, float("nan"))}, "fixed: Ay: must be a finite number, got nan"),
    ],
)
def test_tables_of_python_pass_the_same_gate(table, said):
    with pytest.raises(InputError) as raised:
        vad.mechanism(fixed=table, links={"crank": {"AB": 40}}, driver={"crank": {"angle": 60}})
    assert str(raised.value).startswith(said)


def test_tables_without_an_end_are_refused():
    table: dict[str, object] = {}
    table["A"] = table
    with pytest.raises(InputError, match="nested too deep"):
        vad.mechanism(fixed=table, links={}, driver={})


def test_a_file_with_hundreds_of_links_is_refused_at_once():
    links = "".join(
        f"c{n} = {{ B{n}B{n + 1} = 9 }}\nr{n} = {{ D{n}B{n + 1} = 8 }}\n" for n in range(900)
    )
    text = f"[fixed]\nA = [0, 0]\n[links]\ncrank = {{ AB0 = 4 }}\n{links}[driver]\n"
    start = time.process_time()
    error = caught(text)
    assert time.process_time() - start < 2.0
    assert str(error) == "lesson.toml, line 104: [links] has more than 100 entries"


@pytest.mark.parametrize("number", [101, 3000])
def test_a_link_with_hundreds_of_points_is_refused_at_once(number):
    pairs = ", ".join(f"AB{n} = {n + 1}" for n in range(number))
    error = refused("{ AB = 40 }", f"{{ {pairs} }}")
    assert str(error) == "lesson.toml, line 6: crank: has more than 100 entries"
