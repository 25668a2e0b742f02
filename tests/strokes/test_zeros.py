"""What is not drawn in a pose is kept beside it, so that every pose has the same names."""

from __future__ import annotations

import pytest

import vad
from tests.strokes.poses import MECHANISMS, sheets
from vad.files.examples import example_path
from vad.strokes.sheet import Arrow, Panel, Sheet, Stroke
from vad.strokes.vector_equations import NOTHING


def names(sheet: Sheet) -> list[frozenset[str]]:
    found = []
    for panel in sheet.halves:
        drawn, zero = ([s.name for s in strokes] for strokes in (panel.strokes, panel.zeros))
        assert len({*drawn, *zero}) == len(drawn) + len(zero)
        found.append(frozenset((*drawn, *zero)))
    return found


def zeros(panel: Panel) -> dict[str, Stroke]:
    return {stroke.name: stroke for stroke in panel.zeros}


def places(panel: Panel) -> dict[str, complex]:
    """Return where the letters of the drawn vectors are."""
    ends = {}
    for stroke in panel.strokes:
        if isinstance(stroke.shape, Arrow):
            ends[stroke.shape.tail], ends[stroke.shape.head] = stroke.shape.start, stroke.shape.end
    return ends


@pytest.mark.parametrize("mechanism", MECHANISMS.values(), ids=list(MECHANISMS))
def test_every_pose_has_the_same_names(mechanism) -> None:
    """All round, at rest, and where only one of the driver's rates is zero."""
    assert len({tuple(names(sheet)) for sheet in sheets(mechanism)}) == 1


@pytest.mark.parametrize(
    "mechanism",
    [
        vad.FourBar(ground=100, crank=40, coupler=100, rocker=40),  # its coupler does not turn
        vad.FourBar(crank=150),
        vad.SliderCrank(crank=60, rod=60),
        vad.SliderCrank(offset=80),
        vad.EllipticalTrammel(tracer=0),
        vad.EllipticalTrammel(tracer=-300),
        vad.CrankSlottedLever(ground=50, crank=50),
        vad.DoubleSlider(guide_a=10, guide_b=70),
    ],
    ids=repr,
)
def test_so_it_is_with_other_lengths(mechanism) -> None:
    plain = names(vad.draw(vad.solve(type(mechanism)())))
    for sheet in sheets(mechanism):
        assert names(sheet) == plain


@pytest.mark.parametrize(
    ("mechanism", "inputs"),
    [
        (vad.SliderCrank(), {"angle": 90.0}),  # the rod moves, but does not turn
        (vad.SliderCrank(), {"angle": 0.0}),  # the slider stands at its end
        (vad.FourBar(ground=100, crank=40, coupler=100, rocker=40), {"angle": 30.0}),
        (vad.CrankSlottedLever(), {"angle": 90.0}),  # crank and lever in one line: no sliding
        (vad.ScotchYoke(), {"angle": 90.0}),
        (vad.DoubleSlider(), {"acceleration": 0.0}),
        (vad.EllipticalTrammel(), {"angle": 0.0, "alpha": 3.0}),
    ],
)
def test_only_vectors_without_length_are_left_out(mechanism, inputs) -> None:
    left_out = 0
    for panel in vad.draw(vad.solve(mechanism, **inputs)).panels:
        arrows = [s.shape for s in panel.strokes if isinstance(s.shape, Arrow)]
        longest = max((abs(arrow.end - arrow.start) for arrow in arrows), default=0.0)
        for stroke in panel.zeros:
            assert stroke.caption == "" and stroke.reveals == ()
            if stroke.kind == "construction":  # to an image between two points that are known
                continue
            assert isinstance(stroke.shape, Arrow)
            assert stroke.label == stroke.shape.tail + stroke.shape.head
            length = abs(stroke.shape.end - stroke.shape.start)
            if not stroke.name.endswith(".whole"):
                assert length <= NOTHING * longest
                left_out += 1
        for arrow in arrows:
            assert panel.name == "position" or abs(arrow.end - arrow.start) > NOTHING * longest
    assert left_out


def test_a_zero_vector_has_the_letters_that_it_would_have() -> None:
    panel = vad.draw(vad.solve(vad.FourBar(), alpha=0.0)).panel("acceleration")
    kept, seen = zeros(panel), places(panel)
    assert set(kept) == {"AB.tangential", "AB.whole"}
    assert kept["AB.tangential"].label == "b′ₙb′"
    assert kept["AB.tangential"].shape == Arrow(seen["b′"], seen["b′"], "b′ₙ", "b′")
    assert kept["AB.whole"].shape == Arrow(0j, seen["b′"], "a′", "b′")
    assert kept["AB.tangential"].link == "crank"
    assert "b′ₙ" not in seen  # and so nothing of that name is written


def test_letters_stay_where_a_vector_vanishes_for_an_instant() -> None:
    """At 90° the rod of an in-line slider-crank does not turn: b′cₙ shrinks into b′."""
    panels = [
        vad.draw(vad.solve(vad.SliderCrank(), angle=angle)).panel("acceleration")
        for angle in (90.0, 90.01)
    ]
    instant, before = zeros(panels[0])["BC.normal"], panels[1].strokes
    normal = next(stroke for stroke in before if stroke.name == "BC.normal")
    assert (instant.label, instant.component) == (normal.label, normal.component)
    assert instant.shape.end == places(panels[0])["b′"]


def test_coriolis_vanishes_with_the_sliding() -> None:
    """Crank and lever in one line, pivots apart: the block does not slide for an instant."""
    panel = vad.draw(vad.solve(vad.CrankSlottedLever(), angle=90.0)).panel("acceleration")
    kept = zeros(panel)["QB.coriolis"]
    assert (kept.label, kept.component) == ("zb′", "coriolis")
    assert kept.shape.start == kept.shape.end == places(panel)["b′"]
    assert panel.inset is None


def test_at_rest_all_vectors_are_zero_at_the_pole() -> None:
    for cls in vad.MECHANISMS.values():
        still = dict.fromkeys(list(cls.inputs)[1:], 0.0)
        for panel in vad.draw(vad.solve(cls(), **still)).halves[1:]:
            arrows = [s.shape for s in panel.zeros if isinstance(s.shape, Arrow)]
            assert [stroke.name for stroke in panel.strokes] == ["pole"]
            assert arrows and all(arrow.start == arrow.end == 0 for arrow in arrows)


def test_driven_slide_without_acceleration_keeps_its_point_at_the_pole() -> None:
    panel = vad.draw(vad.solve(vad.DoubleSlider(), acceleration=0.0)).panel("acceleration")
    assert zeros(panel)["OA.sliding"].shape == Arrow(0j, 0j, "o′", "a′")


def test_a_point_in_line_of_a_link_that_does_not_turn_is_found_without_a_proportion() -> None:
    """The platform of a scissor lift only rises: dq, and with it de = dq·DE/DQ, is noise."""
    sheet = vad.draw(vad.solve(vad.load(example_path("scissor-lift"))()))
    for panel, letter in (("velocity", "e falls on d"), ("acceleration", "e′ falls on d′")):
        (said,) = (s.caption for s in sheet.panel(panel).strokes if s.name == "E.image")
        assert said.startswith(letter)
        assert not any(sign.isdigit() for sign in said)


def test_a_caption_says_that_a_vector_is_too_short_to_be_seen() -> None:
    """At 0.012 rad/s a link has a normal acceleration that no lens shows."""
    motion = vad.solve(vad.load(example_path("jansen-leg"))(), angle=60.0)
    (panel,) = vad.draw(motion, panels=("acceleration",)).panels
    sizes = {
        stroke.label: abs(stroke.shape.end - stroke.shape.start)
        for stroke in panel.strokes
        if isinstance(stroke.shape, Arrow)
    }
    told = {stroke.label for stroke in panel.strokes if "too short" in stroke.caption}
    assert told == {label for label, size in sizes.items() if size < 1e-3 * max(sizes.values())}
    assert told == {"e′gₙ"}


@pytest.mark.parametrize(
    ("motion", "end"),
    [
        (vad.solve(vad.GateActuator()), "Along the actuator, a is zero."),
        (
            vad.solve(vad.DoubleSlider(), acceleration=0),
            "a_A is zero, so a′ lies here, too.",
        ),
        (vad.solve(vad.DoubleSlider()), "so o′ lies here."),
        (vad.solve(vad.SliderCrank(), alpha=0), "so a′ and d′ (D on the guide) lie here."),
    ],
)
def test_the_caption_of_the_pole_says_that_a_driven_slide_has_no_acceleration(motion, end) -> None:
    (panel,) = vad.draw(motion, panels=("acceleration",)).panels
    assert panel.strokes[0].caption.endswith(end)


@pytest.mark.parametrize(
    ("name", "inputs", "said"),
    [
        (
            "scissor-lift",
            {},
            {"QC": "ω₆ is zero, there is no Coriolis", "DQ": "ω₆ is zero, there is no norm"},
        ),
        ("slider-crank", {"angle": 90.0}, {"BC": "ω₃ is zero, there is no normal"}),
        ("crank-slotted-lever", {"angle": 90.0}, {"QB": "v is zero, there is no Coriolis"}),
        ("four-bar", {}, {}),
    ],
)
def test_a_line_says_why_no_normal_or_coriolis_component_comes_before_it(
    name: str, inputs: dict[str, float], said: dict[str, str]
) -> None:
    kind = vad.MECHANISMS[name] if name in vad.MECHANISMS else vad.load(example_path(name))
    panel = vad.draw(vad.solve(kind(), **inputs)).panel("acceleration")
    lines = {s.part.of: s.caption for s in panel.strokes if s.part.which == "line"}
    assert said.keys() == {of for of, caption in lines.items() if caption.startswith("As ")}
    for of, why in said.items():
        assert lines[of].startswith(f"As {why}")
        assert f"{of}.{'coriolis' if 'Coriolis' in why else 'normal'}" in zeros(panel)
