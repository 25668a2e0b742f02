"""What a sheet says beyond its captions' facts: units, numbers of links, parameters, grammar."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import pytest

import vad
from tests.strokes.calculations import THIN
from tests.strokes.motions import everything, in_every_language
from vad.files.examples import example_names, example_path
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of
from vad.mechanisms import Mechanism
from vad.strokes.description import describe, title
from vad.strokes.sentences import Noun, Sentence, Voice
from vad.strokes.sheet import Sheet


def said(sheet: Sheet) -> dict[str, str]:
    """Return the captions of a sheet by the full names of their strokes."""
    return {p.full(s.name): s.caption for p in sheet.panels for s in p.strokes}


def test_large_rates_are_written_in_metres_and_the_data_stay() -> None:
    sheet = vad.draw(vad.solve(vad.SliderCrank(), omega=100.0))
    captions, panel = said(sheet), sheet.panel("acceleration")
    assert captions["velocity:AB.tangential"].startswith(
        "ab = ω₂·AB = 100 rad/s × 0.06 m = 6.000 m/s, "
    )
    assert captions["acceleration:AB.normal"].startswith(
        "a′b′ = ω₂²·AB = (100 rad/s)² × 0.06 m = 600.0 m/s²"
    )
    assert captions["position:AB.bar"] == "The crank AB = 60 mm stands at 60°."
    assert captions["acceleration:DC.sliding"].endswith("a = −172.6 m/s².")
    assert "v = −6.395 m/s, a = −172.6 m/s²" in describe(sheet)
    assert (panel.unit, abs(panel.strokes[1].shape.end)) == ("mm/s²", pytest.approx(600000.0))


@pytest.mark.parametrize("unit", ["m", "ft"])
def test_other_units_stay(unit: str) -> None:
    sheet = vad.draw(vad.solve(vad.SliderCrank(length_unit=unit), omega=100.0))
    thousands = f"600{THIN}000 {unit}/s²"
    assert said(sheet)["acceleration:AB.normal"].startswith(
        f"a′b′ = ω₂²·AB = 100² × 60 = {thousands}"
    )


def test_velocities_take_metres_with_the_accelerations() -> None:
    """2ωv would else multiply mm/s and give m/s²."""
    sheet = vad.draw(vad.solve(vad.CrankSlottedLever(), omega=60.0))
    assert max(abs(row.cells["velocity"][0].value) for row in sheet.rows) < 1e5
    assert " m/s²" in said(sheet)["acceleration:QB.coriolis"]
    assert " m/s" in said(sheet)["velocity:QB.sliding"]
    (value,) = {cell.unit for cell in sheet.rows[-1].cells["velocity"]}
    assert value == "mm/s"


@everything
def test_a_row_bears_the_number_that_captions_give_its_link(name: str) -> None:
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name]()))
    turning = [row for row in sheet.rows if row.cells["velocity"][0].symbol[0] == "ω"]
    numbers = [[cells[0].symbol[1:] for cells in row.cells.values()] for row in turning]
    assert all(len(set(each)) == 1 for each in numbers)
    words = " ".join(said(sheet).values())
    assert all(f"ω{each[0]}" in words for each in numbers)


def test_a_link_that_grows_has_the_row_of_its_stroke() -> None:
    sheet = vad.draw(vad.solve(vad.GateActuator()))
    row = sheet.rows[-1]
    assert (row.title, row.letters, row.cells["position"][0].symbol) == ("length", "DB", "l")
    vertices = {letter for panel in sheet.panels for s in panel.strokes for letter in s.label}
    assert "s" in vertices and "l" not in vertices


def test_a_sheet_says_what_it_takes_to_draw_it_again() -> None:
    gate, lever = (vad.draw(vad.solve(kind())) for kind in (vad.GateActuator, vad.Whitworth))
    assert title(gate) == (
        "Gate actuator: ground 0.68642 ft, arm 3.8866 ft, ground angle from x 127.304°"
    )
    assert "angle" not in title(lever)  # straight down, as it is always drawn
    turned = vad.draw(vad.solve(vad.Whitworth(ground_angle=90.0)))
    assert "ground angle from x 90°" in title(turned)


def test_a_given_value_has_the_digits_that_a_calculation_needs_wherever_it_stands() -> None:
    for crank in (60.0 + 1e-7 * step for step in range(0, 300000, 3001)):
        sheet = vad.draw(vad.solve(vad.SliderCrank(crank=crank), omega=10.123456789))
        written = said(sheet)["velocity:AB.tangential"].split(" × ")[1].split(" = ")[0]
        assert f"crank {written} mm" in title(sheet)
        assert f"AB = {written} mm" in said(sheet)["position:AB.bar"]


@pytest.mark.parametrize(
    ("code", "name", "sentence"),
    [
        ("de", "AB.bar", "Die Kurbel AB = 60 mm steht bei 60,5°."),
        ("de", "AB.angle", "Winkel zählen von x aus gegen den Uhrzeigersinn."),
        ("de", "BC.bar", "Die Stange BC steht bei θ₃ = 338,1°."),
        ("de", "DC.block", "Der Schieber C steht bei x = 159,4 mm."),
        ("fr", "AB.bar", "La manivelle AB = 60 mm fait un angle de 60,5° avec l’axe x."),
        ("fr", "AB.angle", "L’angle se mesure depuis x, dans le sens trigonométrique."),
        ("fr", "DC.block", "Le coulisseau C se trouve en x = 159,4 mm."),
    ],
)
def test_nouns_have_their_articles_and_numbers_their_comma(
    code: str, name: str, sentence: str
) -> None:
    sheet = vad.draw(vad.solve(vad.SliderCrank(), angle=60.5), language=code)
    assert said(sheet)[f"position:{name}"].startswith(sentence)
    (angle,) = (s.label for s in sheet.panel("position").strokes if s.kind == "angle")
    assert angle == "60,5°"


@in_every_language
def test_a_name_that_nobody_has_translated_stands_in_a_whole_sentence(code: str) -> None:
    sentence = Voice(code).text(Sentence("slot", {"head": "B", "link": Noun("geneva_wheel")}))
    start = {"en": "of the geneva", "de": "des Glieds geneva", "fr": "de la barre geneva"}
    assert f"{start[code]} wheel" in sentence


def test_fixed_points_are_where_guides_cross_only_if_they_do() -> None:
    trammel = said(vad.draw(vad.solve(vad.EllipticalTrammel())))
    assert trammel["position:O.fixed"] == "O, where the guides cross, is fixed."

    @dataclass(frozen=True)
    class OneGuide(Mechanism, listed=False):
        """A rod that is pushed along a guide."""

        name, title, letters = "one-guide", "One guide", "OABD"
        links, slides = {"rod": "AB", "rocker": "DB"}, {"slider": "A"}
        inputs: ClassVar = {"position": 50.0, "velocity": 1.0, "acceleration": 0.0}

        def linkage(self) -> Linkage:
            first = (Slide("OA", "slider", 0.0), Bar("AB", "rod", 80.0))
            loop = Loop(first=first, second=(Bar("DB", "rocker", 70.0),))
            return Linkage(
                angle_of("slider")._replace(kind="length"), (loop,), "", "O", ("D", 90.0, 0.0)
            )

    captions = said(vad.draw(vad.solve(OneGuide())))
    assert captions["position:O.fixed"] == "O is a fixed point."
    assert captions["position:D.fixed"] == "D is a fixed pivot."
    assert captions["velocity:OA.sliding"].endswith("given along the guide.")


def test_letters_are_the_same_where_a_coupler_does_not_turn() -> None:
    """A parallelogram's coupler never turns: its rocker's normal part keeps its name."""
    parallel = vad.FourBar(ground=100, crank=40, coupler=100, rocker=40, assembly="parallel")
    panel = vad.draw(vad.solve(parallel, alpha=5.0)).panel("acceleration")
    assert {s.name: s.label for s in panel.strokes}["DC.normal"] == "d′c″ₙ"


@pytest.mark.parametrize(
    ("mechanism", "angle", "stroke", "sentence"),
    [
        (vad.SliderCrank(), 90.0, "C", "c is where both lines cross: at b, so ω₃ is zero."),
        (vad.SliderCrank(), 0.0, "C", "c is where both lines cross: at d, so v is zero."),
        (vad.ScotchYoke(), 90.0, "C", "c is where both lines cross: at b, so v is zero."),
        (vad.FourBar(), 60.0, "C", "c is where both lines cross."),
    ],
)
def test_what_vanishes_is_said_where_the_lines_cross(
    mechanism: Mechanism, angle: float, stroke: str, sentence: str
) -> None:
    captions = said(vad.draw(vad.solve(mechanism, angle=angle), panels="velocity"))
    assert captions[f"velocity:{stroke}.crossing"] == sentence


@pytest.mark.exhaustive(16)
@pytest.mark.parametrize("name", [*vad.MECHANISMS, *example_names()])
def test_no_two_results_of_a_panel_have_one_symbol(name: str) -> None:
    mechanism = (vad.MECHANISMS.get(name) or vad.load(example_path(name)))()
    sheet = vad.draw(vad.solve(mechanism))
    for panel in sheet.panels:
        symbols = [cell.symbol for row in sheet.rows for cell in row.cells.get(panel.name, ())]
        assert len(symbols) == len(set(symbols)) > 0


@pytest.mark.parametrize(
    ("name", "ending"),
    [
        ("offset-lever", "measured along the slot from its point nearest to D."),
        ("pin-on-rocker", "measured along the slot from its point nearest to D."),
        ("whitworth-ram", "measured from O4 towards B."),
    ],
)
def test_a_place_on_a_slot_beside_its_pivot_is_not_the_distance_from_it(
    name: str, ending: str
) -> None:
    captions = said(vad.draw(vad.solve(vad.load(example_path(name))())))
    [caption] = [text for text in captions.values() if " stands at s = " in text]
    assert caption.endswith(ending)
