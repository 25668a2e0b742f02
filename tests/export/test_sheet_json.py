from __future__ import annotations

import dataclasses
import json
import math
import random
import re
from collections.abc import Iterator
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import vad
from tests.export.synthetic import SHEET
from tests.limits import within
from tests.strokes.poses import MECHANISMS, sheets
from vad.errors import InputError, UsageError
from vad.export import save, sheet_json
from vad.painting.film import filmed
from vad.painting.posed import picture
from vad.strokes.sheet import Dot, Panel, Sheet, Stroke
from vad.words import languages

pytestmark = pytest.mark.exhaustive


@pytest.fixture
def saved(folder: Path) -> Any:
    save(SHEET, "sheet.json")
    return json.loads(Path("sheet.json").read_text(encoding="utf-8"))


def public(panel: Any) -> list[dict[str, Any]]:
    """Return the strokes of a panel with the keys of the contract alone."""
    own = {"name", "shape", "tail", "head", "until", "square_to", "image", "reveals"}
    return [
        {key: value for key, value in each.items() if key not in own} for each in panel["strokes"]
    ]


def test_strokes_of_the_contract(saved: Any) -> None:
    assert saved["mechanism"] == "slider-crank"
    assert list(saved["panels"]) == ["position", "velocity"]
    velocity = saved["panels"]["velocity"]
    assert {"unit": velocity["unit"], "strokes": public(velocity)} == {
        "unit": "mm/s",
        "strokes": [
            {"kind": "pole", "label": "a,d", "at": [0, 0], "caption": "Choose a pole."},
            {
                "kind": "known",
                "label": "ab",
                "component": "tangential",
                "link": "crank",
                "from": [0, 0],
                "to": [-519.6152422706632, 300],
                "caption": "ab = ω₂·AB = 10 × 60 = 600 mm/s, ⟂ AB",
            },
            {
                "kind": "construction",
                "label": "⟂ BC",
                "link": "rod",
                "through": [-519.6152422706632, 300],
                "direction": [0.6, 0.8],
                "caption": "Perpendicular to BC: a < b & c.",
            },
            {"kind": "intersection", "label": "c", "at": [-600, 0], "caption": "They meet in c."},
        ],
    }


def test_keys_stand_in_the_order_of_the_contract(saved: Any) -> None:
    known = public(saved["panels"]["velocity"])[1]
    assert list(known) == ["kind", "label", "component", "link", "from", "to", "caption"]


def test_arcs_guides_and_blocks(saved: Any) -> None:
    strokes = saved["panels"]["position"]["strokes"]
    guide, slot, angle, compass, _, block = strokes[1:]
    assert guide["side"] == [0, -1] and "side" not in slot
    assert "through" not in angle and compass["through"] == [160, 0]
    assert (angle["centre"], angle["radius"], angle["sweep"]) == ([0, 0], 60, 60)
    assert block["at"] == [160, 0] and block["direction"] == [1, 0]


def test_same_data_as_the_dictionary(saved: Any) -> None:
    assert saved == sheet_json.to_dict(SHEET)


def test_a_stroke_a_line(saved: Any) -> None:
    lines = Path("sheet.json").read_text(encoding="utf-8").splitlines()
    assert sum('"kind"' in line for line in lines) == 11
    assert all(line.count('"kind"') <= 1 for line in lines)
    assert any("ω₂·AB" in line for line in lines)


def test_numbers_are_printed_in_full() -> None:
    point = complex(math.pi * 1e-7, -0.0)
    stroke = Stroke("pole", "o", Dot(np.complex128(point)), "")
    sheet = dataclasses.replace(SHEET, panels=(Panel("velocity", "mm/s", (stroke,)),))
    text = sheet_json.to_text(sheet)
    assert f'"at": [{math.pi * 1e-7!r}, 0.0]' in text


def test_styles_make_no_difference(saved: Any) -> None:
    save(SHEET, "chalk.json", style="chalk")
    assert Path("chalk.json").read_bytes() == Path("sheet.json").read_bytes()


# --- and back ------------------------------------------------------------------------------------


def lever() -> Sheet:
    """Return a sheet that has one of everything: Coriolis, an image, zeros, a guide, a ram."""
    return vad.draw(vad.solve(vad.CrankSlottedLever(rod=100, ram_height=180)))


def all_of(sheet: vad.Sheet) -> str:
    """Return everything that a sheet holds, but for what was drawn, as text."""
    return repr([getattr(sheet, each.name) for each in dataclasses.fields(sheet) if each.compare])


@pytest.mark.parametrize(
    ("mechanism", "code"),
    list(zip(MECHANISMS.values(), cycle(languages()), strict=False)),
    ids=list(MECHANISMS),
)
def test_a_sheet_comes_back_equal_and_bit_for_bit(mechanism: Any, code: str) -> None:
    for sheet in sheets(mechanism, steps=2, language=code):
        back = vad.sheet_from_json(sheet_json.to_text(sheet))
        assert back == sheet
        assert all_of(back) == all_of(sheet)  # where -0.0 differs from 0.0


def test_some_panels_and_other_units_come_back() -> None:
    motion = vad.solve(vad.FourBar(length_unit="in", ground_angle=30), angle=200, alpha=-4e-5)
    for panels in ("position", ("velocity", "acceleration")):
        sheet = vad.draw(motion, panels=panels)
        assert vad.sheet_from_json(sheet_json.to_dict(sheet)) == sheet


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("name", MECHANISMS)
def test_nothing_in_a_sheet_is_minus_zero_or_a_number_of_numpy(name: str) -> None:
    for sheet in sheets(MECHANISMS[name]):
        assert not re.search(r"-0j|\(-0[+-]|[=(, ]-0\.0[,)]", all_of(sheet))
        assert "np." not in all_of(sheet)


def test_a_path_a_text_and_a_dictionary(folder: Path) -> None:
    sheet = lever()
    vad.save(sheet, "sheet.json")
    text = Path("sheet.json").read_text(encoding="utf-8")
    for source in ("sheet.json", Path("sheet.json"), text, json.loads(text)):
        assert vad.sheet_from_json(source) == sheet


@pytest.mark.parametrize("name", ["four-bar", "crank-slotted-lever", "elliptical-trammel"])
def test_pictures_of_the_sheet_that_came_back_are_the_same(folder: Path, name: str) -> None:
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name]()))
    back = vad.sheet_from_json(sheet_json.to_text(sheet))
    for kind in ("png", "svg", "pdf", "json"):
        vad.save(sheet, f"one.{kind}")
        vad.save(back, f"other.{kind}")
        assert Path(f"one.{kind}").read_bytes() == Path(f"other.{kind}").read_bytes()


def test_the_lesson_of_the_sheet_that_came_back_is_the_same() -> None:
    sheet = vad.draw(vad.solve(vad.ScotchYoke(), alpha=20.0))
    films = [
        vad.animate(each, fps=4, size=(320, 240), speed=4)
        for each in (sheet, vad.sheet_from_json(sheet_json.to_text(sheet)))
    ]
    pairs = zip(*map(filmed, films), strict=True)
    assert all(np.array_equal(one.pixels, other.pixels) for one, other in pairs)


# --- files that cannot be ------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("keys", "value", "said"),
    [
        (("mechanism",), None, "mechanism: must be text, got None"),
        (("title",), "\ud800", "title: must be text, got '\\ud800'"),
        (("language",), "xx", "language: must be one of de, en, fr, got 'xx'"),
        (("parameters", 0), ["crank", 60.0], "parameters[0]: must be a list of 3, got ['crank'"),
        (("notation", "point"), ";", "notation.point: must be one of ., ,, got ';'"),
        (("rows", 1, "cells"), [], "rows[1].cells: must be an object, got []"),
        (("rows", 1, "cells", "velocity", 0, "value"), math.inf, "[0].value: must be a finite"),
        (("rows", 1, "cells", "velocity", 0, "value"), True, "[0].value: must be a finite"),
        (("panels",), {}, "panels: there is none"),
        (("panels", "velocity"), 7, "panels.velocity: must be an object, got 7"),
        (("panels", "velocity", "picture"), "film", "must be one of skeleton, vectors"),
        (("panels", "velocity", "strokes"), {}, "panels.velocity.strokes: must be a list"),
        (("panels", "velocity", "strokes", 1, "from"), [0], "strokes[1].from: must be a list of 2"),
        (("panels", "velocity", "strokes", 1, "to", 0), math.nan, "strokes[1].to[0]: must be a"),
        (("panels", "velocity", "strokes", 1, "to", 1), 10**400, "strokes[1].to[1]: must be a"),
        (("panels", "velocity", "strokes", 1, "shape"), "cube", "strokes[1].shape: must be one of"),
        (("panels", "velocity", "strokes", 1, "kind"), ["pole"], "kind: must be one of fixed"),
        (("panels", "velocity", "strokes", 1, "name"), "pole", "two strokes are called 'pole'"),
        (("panels", "velocity", "strokes", 1, "name"), "x", "no stroke is called 'AB.tangential'"),
        (
            ("panels", "position", "strokes", 4, "sweep"),
            1e7,
            "sweep: must be an angle, at most 720",
        ),
        (
            ("panels", "position", "strokes", 4, "radius"),
            1e300,
            "radius: must be a finite number, at",
        ),
        (("panels", "velocity", "zeros"), [{}] * 501, "zeros: has at most 500 entries, got 501"),
        (("rows", 0, "letters"), "x" * 10_001, "letters: must be a text of at most 10000"),
        (("rows", 0, "title"), "x" * 10_001, "title: must be a text of at most 10000"),
        (("panels", "acceleration", "inset", "stroke"), "y", "no stroke is called 'y'"),
        (("panels", "acceleration", "inset", "sense"), 1.0, "inset.sense: must be one of 1, -1"),
    ],
)
def test_what_is_wrong_is_said_with_its_place(keys: Any, value: Any, said: str) -> None:
    data = sheet_json.to_dict(lever())
    *way, last = keys
    held = data
    for key in way:
        held = held[key]
    held[last] = value
    with pytest.raises(vad.InputError) as caught:
        vad.sheet_from_json(data)
    assert said in str(caught.value)
    assert str(caught.value).startswith("sheet: ") and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "not JSON"),
        ("{", "not JSON"),
        ("[1, 2]", "must be an object"),
        ('{"mechanism": "four-bar"}', "title: missing"),
        ('{"a": ' * 100_000, "not JSON"),
        ("\x00\xff", "not JSON"),
    ],
)
def test_foreign_files_are_answered_in_one_line(folder: Path, text: str, said: str) -> None:
    Path("foreign.json").write_bytes(text.encode("latin-1"))
    with pytest.raises(vad.InputError, match=said) as caught:
        vad.sheet_from_json("foreign.json")
    assert str(caught.value).startswith("foreign.json: ") and "\n" not in str(caught.value)


@pytest.mark.parametrize("source", ["/dev/zero", " " * 30_000_000 + "{}"])
def test_a_file_without_an_end_is_not_read_whole(source: str) -> None:
    with within(20.0), pytest.raises(vad.InputError, match="too long for a sheet"):
        vad.sheet_from_json(source)


def test_an_equation_of_a_stroke_without_a_name_is_refused() -> None:
    data = sheet_json.to_dict(lever())
    data["panels"]["velocity"]["equations"][0]["left"][0]["stroke"] = ""
    with pytest.raises(vad.InputError, match=r"panels\.velocity: no stroke is called ''"):
        vad.sheet_from_json(data)


def test_a_point_far_off_the_page_is_drawn_in_little_time() -> None:
    data = sheet_json.to_dict(lever())
    data["panels"]["position"]["strokes"][4]["centre"][0] = 1e7
    with within(20.0):
        assert picture(vad.sheet_from_json(data)).shape == (720, 1280, 4)


@pytest.mark.parametrize("name", ["nowhere.json", "", ".", "a\x00b"])
def test_no_file_of_that_name(folder: Path, name: str) -> None:
    with pytest.raises(vad.InputError):
        vad.sheet_from_json(name)


def places(data: Any, way: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the way to every value."""
    entries = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in entries:
        yield (*way, key)
        if isinstance(value, dict | list):
            yield from places(value, (*way, key))


@pytest.mark.parametrize("seed", range(100))
def test_damaged_sheets_are_read_or_refused(seed: int) -> None:
    """A value lost, or of another type, or a text cut short: never anything but a VadError."""
    draw, data = random.Random(seed), json.loads(TEXT)
    source: Any = data
    for _ in range(draw.randint(1, 3)):
        way = draw.choice(list(places(data)))
        held = data
        for key in way[:-1]:
            held = held[key]
        if draw.random() < 0.4:
            del held[way[-1]]
        else:
            others = [None, True, -1, 2.5, math.nan, 10**400, "", "ₙ", [], [[]], {}, {"": {}}]
            held[way[-1]] = draw.choice(others)
    if seed % 5 == 0:
        source = TEXT[: draw.randrange(1, len(TEXT))]
    try:
        sheet = vad.sheet_from_json(source)
    except vad.VadError as error:
        assert "\n" not in str(error)
    else:
        assert vad.sheet_from_json(sheet_json.to_text(sheet)) == sheet


TEXT = sheet_json.to_text(lever())


def plain() -> dict[str, Any]:
    return json.loads(sheet_json.to_text(vad.draw(vad.solve(vad.SliderCrank()))))


@pytest.mark.parametrize("panel", ["position", "velocity", "acceleration"])
@pytest.mark.parametrize("kind", ["known", "construction", "result", "pole", "fixed", "angle"])
def test_a_sheet_that_lacks_strokes_is_painted_or_refused_in_a_line(panel: str, kind: str):
    held = plain()
    for only in (True, False):
        strokes = plain()["panels"][panel]["strokes"]
        held["panels"][panel]["strokes"] = [s for s in strokes if (s["kind"] == kind) == only]
        held["panels"][panel]["equations"] = []
        held["panels"][panel].pop("inset", None)
        assert picture(vad.sheet_from_json(held)).shape == (720, 1280, 4)


def test_a_direction_has_length_one():
    held = plain()
    line = next(s for s in held["panels"]["velocity"]["strokes"] if s["kind"] == "construction")
    line["direction"] = [0, 0]
    with pytest.raises(InputError, match=r"direction: must be a direction of length 1, got \[0"):
        vad.sheet_from_json(held)


def test_a_page_without_room_is_refused():
    held = plain()
    velocity = held["panels"]["velocity"]
    held["panels"] |= {f"velocity {number}": velocity for number in range(40)}
    with pytest.raises(UsageError, match="no room for 43 panels"):
        picture(vad.sheet_from_json(held))


def test_units_of_results_are_spelt_as_by_solve() -> None:
    motion = vad.solve(vad.SliderCrank())
    units = set(motion.to_dict()["units"].values())
    rows = sheet_json.to_dict(vad.draw(motion))["rows"]
    cells = [cell for row in rows for cells in row["cells"].values() for cell in cells]
    assert {cell["unit"] for cell in cells} - {"deg", "°"} <= units
    assert {"rad/s^2", "mm/s^2"} <= {cell["unit"] for cell in cells}
