"""The data of a page's hand."""

from __future__ import annotations

import re
from typing import Any

import pytest

import vad
from tests.page.hands import EXAMPLES, NAMES, made
from vad.kinematics.reach import closing_range
from vad.lecture.followed import Followed
from vad.page.dimensions import dimensions
from vad.page.hand import fast
from vad.page.parts import parts, turned_board


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", NAMES)
def test_every_number_of_the_table_that_changes_follows(name: str) -> None:
    mechanism: Any = vad.MECHANISMS.get(name) or vad.load(str(EXAMPLES[name]))
    mechanism = mechanism()
    low, high = closing_range(mechanism)[0]
    driver = next(iter(mechanism.inputs))
    sheets = [
        vad.draw(vad.solve(mechanism, **{driver: low + share * (high - low)}))
        for share in (0.37, 0.59)
    ]
    follows = {tuple(cell[:3]) for cell in made(name)[-1]["cells"]}
    for number, rows in enumerate(zip(*(sheet.rows for sheet in sheets), strict=True)):
        for column, panel in enumerate(sheets[0].panels):
            cells = zip(*(row.cells.get(panel.name, ()) for row in rows), strict=True)
            for place, (one, other) in enumerate(cells):
                if abs(one.value - other.value) > 1e-6 * abs(one.value):
                    assert (number, column, place) in follows, (one.symbol, panel.name)


@pytest.mark.exhaustive(3)
@pytest.mark.parametrize(
    ("name", "dimension", "unit", "ends"),
    [
        ("double-slider", "guide_b", "°", (45.0, 135.0)),
        ("excavator-bucket", "CAT", "°", (-155.0, -65.0)),
        ("shaper", "BAF", "°", None),
        ("gate-actuator", "arm", "ft", None),
        ("pantograph", "ratio", "", None),
        ("hoeken", "a", "mm", (18.0, 45.0)),  # a number of a file that is a length everywhere
    ],
)
def test_a_dimension_has_the_unit_of_its_quantity(
    name: str, dimension: str, unit: str, ends: tuple[float, float] | None
) -> None:
    mechanism: Any = vad.MECHANISMS.get(name) or vad.load(str(EXAMPLES[name]))
    board = turned_board(vad.animate(vad.draw(vad.solve(mechanism()))))
    assert board
    found = {each[0]: each for each in dimensions(board, list(board.mechanism.inputs))}
    _, _, low, high, shown = found[dimension][:5]
    assert shown == unit
    assert ends in (None, (low, high))


def test_an_equation_holds_in_every_position() -> None:
    panels = made("hooke-joint")[0]
    foot = re.search(r'<div class="foot.*?</div>', panels, re.DOTALL)
    assert foot and "60" not in re.sub("<[^>]*>", "", foot[0])


def test_of_a_followed_point_a_page_has_the_path_and_the_hodographs_alone() -> None:
    turn = vad.turn(vad.load(str(EXAMPLES["roberts"]))())
    lesson = vad.animate(turn.given)

    def curves(follow: Followed | None) -> Any:
        hand = parts(lesson, follow=follow).hand
        assert hand is not None
        return hand.data["curves"]

    point, every = curves(turn.followed), curves(None)
    assert [len(tracks) for tracks in every["tracks"]] == [3, 3, 3]
    row = [each.key for each in turn.given.rows].index("coupler")
    assert [[track[0] for track in tracks] for tracks in point["tracks"]] == [[row]] * 3
    assert (point["on"], every["on"]) == (["paths"], [])
    assert point["columns"] == every["columns"]


@pytest.mark.parametrize(
    ("mechanism", "units"),
    [
        (vad.ScotchYoke(), ["mm", "mm/s", "mm/s²"]),  # its crank alone turns
        (vad.FourBar(), ["°", "rad/s", "rad/s²"]),
    ],
)
def test_the_first_curve_of_a_page_is_not_that_of_what_is_given(
    mechanism: vad.Mechanism, units: list[str]
) -> None:
    hand = parts(vad.animate(vad.draw(vad.solve(mechanism)))).hand
    assert hand is not None
    columns = hand.data["curves"]["columns"]
    assert [column[0][3] for column in columns] == units
    assert {value[3] for value in columns[1]} == {"rad/s", units[1]}


def test_the_velocities_of_what_goes_round_are_never_cut() -> None:
    panels = ["position", "velocity", "acceleration"]
    assert fast(vad.CrankSlottedLever(), panels) == 1
    assert fast(vad.FourBar(crank=130), panels) == -1  # it swings: at its ends rates have no end
    assert fast(vad.DoubleSlider(), panels) == -1
    assert fast(vad.CrankSlottedLever(), ["position", "centres"]) == -1


@pytest.mark.parametrize("mechanism", [vad.SliderCrank(), vad.GateActuator(), vad.HookeJoint()])
def test_what_drives_has_the_symbols_of_the_full_sheet_on_any_page(
    mechanism: vad.Mechanism,
) -> None:
    def symbols(panels: tuple[str, ...] | None) -> Any:
        hand = parts(vad.animate(vad.draw(vad.solve(mechanism), panels))).hand
        assert hand is not None
        return hand.data["symbols"]

    every = symbols(None)
    assert symbols(("position",)) == every
    assert not {*mechanism.inputs} & {*every}


def test_the_head_of_a_narrow_panel_is_smaller_so_that_its_bar_stands_apart() -> None:
    loads, masses = [{"name": "P", "at": "C", "force": 800.0, "angle": 180.0}], {"slider": 0.5}
    forces = vad.forces(vad.solve(vad.SliderCrank(), omega=100.0), loads, masses)
    panels = parts(vad.animate(vad.draw(forces, language="fr"))).panels
    *others, drive = panels.split("<section")[1:]
    assert "--head:." in drive
    assert not any("--head" in other for other in others)
