"""Every stroke has a name: unique in its panel, and the same whatever the numbers are."""

from __future__ import annotations

import re

import pytest

import vad
from tests.kinds import SPACE
from tests.strokes.poses import MECHANISMS, sheets
from vad.strokes.sheet import CoriolisInset
from vad.words import languages

FORM = re.compile(
    r"pole|[A-Z]\.(fixed|found|crossing|image)"
    r"|[A-Z]{2}\.(guide|slot|block|bar|angle|compass|line|normal|tangential|whole|sliding|coriolis)"
)
# Of what, and what of it: OQ.arm, shafts.angle, 24.normal; one word where there is one thing.
FORM_IN_SPACE = re.compile(r"[A-Za-z]*[0-9]*(\.[A-Za-z]+)?")


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=list(MECHANISMS))
def test_names_are_unique_and_name_a_step_or_a_point(mechanism) -> None:
    for sheet in sheets(mechanism):
        for panel in sheet.halves:
            names = [stroke.name for stroke in panel.strokes]
            assert len(set(names)) == len(names)
            form = FORM_IN_SPACE if mechanism.name in SPACE else FORM
            assert all(form.fullmatch(name) for name in names), names


@pytest.mark.parametrize(
    ("panel", "names"),
    [
        ("position", "A.fixed D.fixed AB.bar AB.angle DQ.line Q.found DQ.bar QB.block DC.bar"),
        (
            "velocity",
            "pole AB.tangential QB.line DQ.line Q.crossing DQ.tangential QB.sliding C.image",
        ),
        (
            "acceleration",
            "pole AB.normal AB.tangential AB.whole QB.coriolis QB.line DQ.normal DQ.line "
            "Q.crossing DQ.tangential QB.sliding DQ.whole C.image",
        ),
    ],
)
def test_names_of_a_slotted_lever_in_drawing_order(panel: str, names: str) -> None:
    sheet = vad.draw(vad.solve(vad.CrankSlottedLever(), alpha=20.0))
    assert [stroke.name for stroke in sheet.panel(panel).strokes] == names.split()


def test_a_name_does_not_depend_on_letters_or_on_what_else_is_drawn() -> None:
    """Without α the normal part alone is drawn, and bears the letters of the whole."""
    mechanism = vad.FourBar()
    for alpha, label in ((0.0, "a′b′"), (5.0, "a′b′ₙ")):
        strokes = vad.draw(vad.solve(mechanism, alpha=alpha)).panel("acceleration").strokes
        assert {s.name: s.label for s in strokes}["AB.normal"] == label


def test_the_pole_bears_its_name_where_it_is_found_last() -> None:
    for inputs in ({}, {"omega": 0.0}):
        panel = vad.draw(vad.solve(vad.EllipticalTrammel(), **inputs)).panel("velocity")
        assert [s.label for s in panel.strokes if s.name == "pole"] == ["o"]


def test_names_are_the_same_in_every_language() -> None:
    motion = vad.solve(vad.Whitworth(rod=300))
    english, german = (
        [[s.name for s in panel.strokes] for panel in vad.draw(motion, language=code).panels]
        for code in ("en", "de")
    )
    assert english == german


@pytest.mark.parametrize("code", languages())
def test_a_parameter_called_after_a_point_bears_its_letter(code: str) -> None:
    sheet = vad.draw(vad.solve(vad.DoubleSlider(guide_a=10, guide_b=100)), language=code)
    names = [name for name, _, _ in sheet.parameters]
    assert [name[-2:] for name in names[1:]] == [" A", " B"]


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=list(MECHANISMS))
def test_terms_and_the_inset_name_the_strokes_that_draw_them(mechanism) -> None:
    for sheet in sheets(mechanism):
        for panel in sheet.halves:
            strokes = {stroke.name: stroke for stroke in panel.strokes}
            for equation in panel.equations:
                for term in (*equation.left, *equation.right):
                    if term.stroke is None:
                        continue
                    stroke = strokes[term.stroke]
                    if panel.picture == "vectors":  # a mechanism has blocks, shafts and angles
                        assert stroke.kind in ("known", "result")
                        assert stroke.label == term.label
            if isinstance(panel.inset, CoriolisInset):
                assert strokes[panel.inset.stroke].component == "coriolis"
                assert panel.strokes[panel.number(panel.inset.stroke)].name == panel.inset.stroke


def test_a_name_that_is_not_drawn_has_no_number() -> None:
    panel = vad.draw(vad.solve(vad.FourBar())).panel("velocity")
    assert panel.number("DC.line") == 3
    with pytest.raises(KeyError):
        panel.number("AB.normal")
