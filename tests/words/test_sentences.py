"""Sentences as data: what they calculate, and the same sheet in another language."""

from __future__ import annotations

import json
import math
import pickle
from collections.abc import Iterator
from typing import Any

import pytest

import vad
from tests.strokes.calculations import FIGURE, Side, chains
from tests.strokes.poses import MECHANISMS, sheets
from vad.errors import UsageError
from vad.export.sheet_json import sheet_from_json, to_dict, to_text
from vad.files.examples import example_names, example_path
from vad.strokes.sheet import Sheet
from vad.words import gaps, languages

FLOATS = 1e-9
EXAMPLES = example_names()


def poses_of(name: str) -> Iterator[Sheet]:
    """Yield sheets of a mechanism or an example."""
    if name in MECHANISMS:
        yield from sheets(MECHANISMS[name], steps=2)
    else:
        yield vad.draw(vad.solve(vad.load(example_path(name))()))


def strokes(data: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield the strokes in the JSON of a sheet."""
    for panel in data["panels"].values():
        yield from panel["strokes"]
        yield from panel.get("below", {"strokes": []})["strokes"]


def numbers(
    said: dict[str, Any], names: list[str | float], sines: bool = False
) -> list[tuple[float, int]]:
    """Return the numbers of the parts of a sentence in JSON, or their sines, and their powers."""
    found = []
    for name in names:
        part = said["parts"][name] if isinstance(name, str) else {"figure": name}
        for each in part.get("terms", [part]):
            angle = sines and each.get("unit") == "°"
            value = math.sin(math.radians(each["figure"])) if angle else each["figure"]
            found.append((value, each.get("power", 1)))
    return found


def calculated(said: dict[str, Any]) -> Iterator[tuple[float, float]]:
    """Yield the results of a sentence in JSON, with those within it, and what its numbers make."""
    for part in said.get("parts", {}).values():
        if "phrase" in part:
            yield from calculated(part)
    for each in said.get("calculations", []):
        ((result, _),) = numbers(said, [each["result"]])
        operands = numbers(said, each["operands"], each["operation"] == "sines")
        values = [value for value, _ in operands]
        match each["operation"]:
            case "product" | "sines":
                yield result, math.prod(value**power for value, power in operands)
            case "sum":
                yield result, sum(values)
            case "inclined":
                factor, first, second, degrees = values
                angle = math.radians(degrees)
                yield result, factor * (first + second * math.cos(angle)) / math.sin(angle)
            case "hypotenuse":
                yield result, math.hypot(*values)
            case "leg":
                yield result, math.sqrt(values[0] ** 2 - values[1] ** 2)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [*MECHANISMS, *EXAMPLES])
def test_the_json_alone_tells_what_every_caption_calculates(name: str) -> None:
    for sheet in poses_of(name):
        for stroke in strokes(json.loads(to_text(sheet))):
            results = list(calculated(stroke["caption_said"]))
            for result, made in results:
                assert result == pytest.approx(made, rel=FLOATS, abs=1e-9), stroke["caption"]
            assert bool(results) >= any(in_figures(stroke["caption"])), stroke["caption"]


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [*MECHANISMS, *EXAMPLES])
def test_units_are_multiplied_like_numbers(name: str) -> None:
    """Length times rate is a rate: mm · rad/s = mm/s, by counting lengths and seconds."""
    for sheet in poses_of(name):
        for stroke in strokes(to_dict(sheet)):
            said = stroke["caption_said"]
            for each in said.get("calculations", []):
                if each["operation"] == "product":
                    (result,) = dimensions(said, [each["result"]])
                    found = dimensions(said, each["operands"])
                    assert result == tuple(map(sum, zip(*found, strict=True))), stroke["caption"]


def dimensions(said: dict[str, Any], names: list[str | float]) -> list[tuple[int, int]]:
    """Return the powers of length and of time in the numbers of a sentence.

    The 2π/60 by which turns a minute become rad/s is a number.
    """
    found = []
    for name in names:
        part = said["parts"][name] if isinstance(name, str) else {}
        unit, power = part.get("unit", ""), part.get("power", 1)
        length, _, second = unit.partition("/")
        times = -1 if unit == "rpm" else {"": 0, "s": -1, "s^2": -2}[second]
        found.append((power * (length in ("mm", "cm", "m", "ft", "in")), power * times))
    return found


def in_figures(caption: str) -> Iterator[bool]:
    """Tell of the equations of a caption whether one has numbers on both sides."""
    for chain in chains(caption):
        sides = [side for side in chain.sides if isinstance(side, Side) and side.in_figures]
        yield chain.result is not None and any(len(side.factors) > 1 for side in sides)


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [*MECHANISMS, *EXAMPLES])
def test_every_number_of_a_caption_is_in_its_data(name: str) -> None:
    """What is written in figures is a figure, but for 90°, 2π·n/60 and the 2 of Coriolis."""
    for sheet in poses_of(name):
        for half in sheet.halves:
            for stroke in half.strokes:
                kinds = [piece.text for piece in stroke.said.pieces if piece.kind == "words"]
                fixed = {found for text in kinds for found in FIGURE.findall(text)}
                assert fixed <= {"1", "2", "3", "4", "24", "60", "90"}, stroke.caption


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [*MECHANISMS, *EXAMPLES])
def test_a_sentence_has_the_parts_that_it_says_and_no_others(name: str) -> None:
    for sheet in poses_of(name):
        for half in sheet.halves:
            for stroke in half.strokes:
                said = stroke.said
                assert set(said.parts) == gaps(said.phrase), said
                named = {each.result for each in said.calculations} | {
                    name for each in said.calculations for name in each.operands
                }
                assert {each for each in named if isinstance(each, str)} <= set(said.parts)


@pytest.mark.exhaustive
@pytest.mark.parametrize("code", languages())
@pytest.mark.parametrize("name", [*MECHANISMS, *EXAMPLES])
def test_a_sheet_is_read_in_another_language(name: str, code: str) -> None:
    for sheet in poses_of(name):
        read = sheet_from_json(to_text(sheet), language=code)
        motion_drawn = to_dict(read)
        assert motion_drawn["language"] == code
        again = sheet_from_json(to_text(read), language="en")
        assert to_dict(again) == to_dict(sheet)


@pytest.mark.exhaustive(4)
@pytest.mark.parametrize("code", languages())
@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_what_is_read_in_a_language_is_what_is_drawn_in_it(name: str, code: str) -> None:
    motion = vad.solve(vad.MECHANISMS[name](), **RATES.get(name, {"alpha": 7.0}))
    english, drawn = vad.draw(motion), vad.draw(motion, language=code)
    read = vad.sheet_from_json(to_text(english), language=code)
    assert read == drawn
    assert to_text(read) == to_text(drawn)


RATES = {
    "double-slider": {"acceleration": 3.0},
    "gate-actuator": {"acceleration": 0.1},
}


def test_an_unknown_language_is_refused() -> None:
    text = to_text(vad.draw(vad.solve(vad.FourBar())))
    with pytest.raises(UsageError, match="unknown language 'xx'"):
        vad.sheet_from_json(text, language="xx")


def test_an_edited_caption_stays_as_it_is_and_no_sentence_is_left_of_it() -> None:
    data = to_dict(vad.draw(vad.solve(vad.FourBar())))
    first, second = data["panels"]["velocity"]["strokes"][:2]
    first["caption"] = "Here we begin."
    second["caption_said"]["phrase"] = "a phrase of the next program"
    sheet = vad.sheet_from_json(data)
    said = [stroke.said for stroke in sheet.panel("velocity").strokes[:2]]
    assert said == ["Here we begin.", second["caption"]]
    assert vad.sheet_from_json(data, language="de").panels[1].strokes[0].caption == said[0]


def test_what_is_no_part_of_a_sentence_is_refused_with_its_place() -> None:
    data = to_dict(vad.draw(vad.solve(vad.FourBar())))
    data["panels"]["velocity"]["strokes"][1]["caption_said"]["parts"]["value"] = {"figures": 3}
    with pytest.raises(vad.InputError, match=r"strokes\[1\].caption_said.parts.value: must be a"):
        vad.sheet_from_json(data)


ODD: list[Any] = [
    None,
    -3.5,
    "{",
    [],
    {},
    {"terms": []},
    {"list": [], "between": "*"},
    {"word": "", "generic": "?"},
    {"phrase": "crossing"},
    {"phrase": "{"},
    {"figure": 1e308, "power": 2},
    {"word": "crank", "of": {"phrase": "still"}},
]


@pytest.mark.parametrize("odd", ODD, ids=str)
def test_odd_data_of_a_sentence_are_refused_or_its_text_stays(odd: Any) -> None:
    for place in ("caption_said", "value", "label", "unit", "omega"):
        data = json.loads(to_text(vad.draw(vad.solve(vad.FourBar()))))
        stroke = data["panels"]["velocity"]["strokes"][1]
        (stroke if place in stroke else stroke["caption_said"]["parts"])[place] = odd
        try:
            read = vad.sheet_from_json(data, language="de").panel("velocity").strokes[1]
        except vad.VadError:
            continue
        assert read.said == stroke["caption"] or place == "label"


def test_sheets_go_to_other_processes() -> None:
    sheet = vad.draw(vad.solve(vad.FourBar()), language="de")
    again = pickle.loads(pickle.dumps(sheet))
    assert again == sheet and to_text(again) == to_text(sheet)
