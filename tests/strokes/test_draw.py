"""A sheet holds what was asked for, and nothing more is computed for it."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest

import vad
from tests.kinematics.hand_built import HandBuilt
from vad.files.examples import example_path
from vad.kinematics.any_solver import AnySolver
from vad.kinematics.linkage import Bar, Linkage, Loop, Slide, angle_of, length_of
from vad.kinematics.solver import Solver, solver_of
from vad.kinematics.space.solver import SpaceSolver
from vad.strokes.sentences import Voice
from vad.strokes.shapes import Line

PANELS = ("position", "velocity", "acceleration")


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """Count what the solver is asked for: positions, velocities, accelerations."""
    solver_of.cache_clear()  # else what other tests have recorded is not computed again
    counted: Counter[str] = Counter()

    def counting(kind: type[AnySolver], step: str) -> Any:
        asked = getattr(kind, step)

        def counting_step(self: AnySolver, *given: Any) -> Any:
            counted[PANELS[0 if step == "positions" else len(given[1]) + 1]] += 1
            return asked(self, *given)

        return counting_step

    for kind in (Solver, SpaceSolver):
        monkeypatch.setattr(kind, "positions", counting(kind, "positions"))
    for kind in (Solver, *SpaceSolver.__subclasses__()):
        monkeypatch.setattr(kind, "rates", counting(kind, "rates"))
    return counted


@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_a_panel_costs_its_own_order_and_those_below(
    name: str, count: int, calls: Counter[str]
) -> None:
    """Of the pose; how far it gets in all poses is found once for each mechanism."""
    mechanism = vad.MECHANISMS[name]()
    vad.draw(vad.solve(mechanism), panels=PANELS[count - 1])
    calls.clear()
    vad.draw(vad.solve(mechanism), panels=PANELS[count - 1])
    assert calls == dict.fromkeys(PANELS[:count], 1)


def test_nothing_is_computed_before_it_is_asked_for(calls: Counter[str]) -> None:
    motion = vad.solve(vad.FourBar(), angle=np.linspace(0, 360, 100))
    assert not calls
    assert motion.point("C").position.shape == (100,)
    assert calls == {"position": 1}
    assert motion.link("rocker").omega.shape == (100,)
    assert calls == {"position": 1, "velocity": 1}
    assert motion.point("C").acceleration.shape == (100,)
    assert calls == {"position": 1, "velocity": 1, "acceleration": 1}


@pytest.mark.parametrize("name", list(vad.MECHANISMS))
def test_no_caption_becomes_text_before_it_is_read(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    said: list[Any] = []

    def pieces(self: Voice, part: Any) -> Any:
        said.append(part)
        return spoken(self, part)

    spoken = Voice.pieces
    monkeypatch.setattr(Voice, "pieces", pieces)
    sheet = vad.draw(vad.solve(vad.MECHANISMS[name]()), language="de")
    strokes = [stroke for half in sheet.halves for stroke in half.strokes]
    captions = [stroke.said for stroke in strokes]
    assert not any(each is part for each in captions for part in said)
    assert all(stroke.caption for stroke in strokes)
    assert all(any(each is part for part in said) for each in captions)


def test_panels_come_in_their_own_order() -> None:
    sheet = vad.draw(vad.solve(vad.FourBar()), panels=("acceleration", "position"))
    assert [panel.name for panel in sheet.panels] == ["position", "acceleration"]
    assert all(set(row.cells) == {"position", "acceleration"} for row in sheet.rows)


@pytest.mark.parametrize(
    ("options", "message", "hint"),
    [
        ({"panels": "velocty"}, "unknown panel 'velocty'", "did you mean 'velocity'?"),
        (
            {"panels": ()},
            "panels: none given",
            "known: position, centres, turned, velocity, acceleration, force, drive",
        ),
        ({"language": "xx"}, "unknown language 'xx'", "known: de, en, fr"),
    ],
)
def test_wrong_options_name_what_would_work(
    options: dict[str, Any], message: str, hint: str
) -> None:
    with pytest.raises(vad.UsageError) as caught:
        vad.draw(vad.solve(vad.FourBar()), **options)
    assert (str(caught.value), caught.value.hint) == (message, hint)


def test_many_poses_make_no_sheet() -> None:
    with pytest.raises(vad.InputError, match="one pose"):
        vad.draw(vad.solve(vad.FourBar(), angle=[10.0, 20.0]))


def test_captions_give_symbol_numbers_result_and_unit() -> None:
    motion = vad.solve(vad.SliderCrank(), angle=116.9, omega=11.59, alpha=21.15)
    sheet = vad.draw(motion)
    captions = {s.label: s.caption for panel in sheet.panels for s in panel.strokes}
    assert captions["ab"] == (
        "ab = ω₂·AB = 11.59 × 60 = 695.4 mm/s, ⟂ AB in the sense of ω₂: the velocity of B."
    )
    assert captions["b′cₙ"] == ("b′cₙ = ω₃²·BC = 2.432² × 140 = 828.0 mm/s², from C towards B.")
    assert captions["bc"].startswith("ω₃ = bc/BC = 340.5/140 = 2.432 rad/s, counter-clockwise")
    assert captions["dc"].endswith("v = −490.0 mm/s.")


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("angle", [20.0, 200.0])
def test_coriolis_is_the_sliding_velocity_turned_with_omega(sense: int, angle: float) -> None:
    motion = vad.solve(vad.CrankSlottedLever(), angle=angle, omega=10.0 * sense)
    inset = vad.draw(motion).panel("acceleration").inset
    assert inset is not None
    assert inset.sense == (1 if motion.link("lever").omega > 0 else -1)
    assert inset.coriolis == pytest.approx(inset.sense * 1j * inset.sliding)
    way = 1 if motion.slide("block").velocity > 0 else -1
    assert inset.sliding == pytest.approx(way * inset.slot)


GROUND = ("D", 100.0, 0.0)
AB, DC = Bar("AB", "crank", 70.0), Bar("DC", "rocker", 60.0)
#: Loops in which a known vector hangs on one that is not, and the names of both.
BEYOND: dict[str, tuple[Linkage, str, str]] = {
    "driven coupler": (
        Linkage(
            angle_of("coupler"), (Loop((AB, Bar("BC", "coupler", 120.0)), (DC,)),), ground=GROUND
        ),
        "coupler",
        "crank",
    ),
    "driven coupler on the other side": (
        Linkage(
            angle_of("coupler"), (Loop((AB,), (DC, -Bar("BC", "coupler", 120.0))),), ground=GROUND
        ),
        "coupler",
        "rocker",
    ),
    "driven slide between two rockers": (
        Linkage(length_of("slot"), (Loop((AB,), (DC, Slide("CB", "slot", 90.0))),), ground=GROUND),
        "slot",
        "rocker",
    ),
    "driven angle of a cylinder": (
        Linkage(
            angle_of("cylinder"),
            (
                Loop(
                    (Slide("DS", "cylinder", "cylinder"), Bar("SB", "cylinder", "cylinder")), (AB,)
                ),
            ),
            ground=GROUND,
        ),
        "cylinder",
        "cylinder",
    ),
    "driven rod beyond its slider": (
        Linkage(
            angle_of("rod"),
            (Loop((AB,), (Slide("AC", "slider", 0.0), -Bar("BC", "rod", 140.0))),),
        ),
        "rod",
        "slider",
    ),
}


@pytest.mark.parametrize("panel", PANELS)
@pytest.mark.parametrize("case", BEYOND)
def test_a_known_vector_beyond_an_unknown_one_is_refused_by_name(case: str, panel: str) -> None:
    """It is solved, but the polygons begin with what is known."""
    linkage, known, unknown = BEYOND[case]
    built: Any = HandBuilt(linkage)
    driven = {"angle": 20.0} if linkage.driver.kind == "angle" else {"position": 30.0}
    motion = vad.solve(built, **driven)
    motion.to_dict()
    with pytest.raises(vad.InputError) as caught:
        vad.draw(motion, panel)
    said = f"loop 1: {known} is known, but hangs on {unknown}, which is not: such a loop is solved"
    assert str(caught.value) == f"{said}, but cannot be drawn yet"
    assert caught.value.hint == "drive a link or a slide of the frame"


def test_a_line_that_hangs_on_a_turning_point_is_refused_by_name() -> None:
    loop = Loop((AB, -Slide("CB", "block", 70.0)), (Bar("AC", "yoke", 50.0),))
    built: Any = HandBuilt(Linkage(angle_of("crank"), (loop,)))
    motion = vad.solve(built, angle=60.0)
    motion.to_dict()
    with pytest.raises(vad.InputError) as caught:
        vad.draw(motion)
    assert str(caught.value).startswith("block: its line hangs on C, which does not slide")


@pytest.mark.parametrize(
    ("inputs", "said"),
    [
        ({"omega": 1e-157}, "acceleration: cannot be drawn, for its longest vector has "),
        ({"omega": 1e-300}, "velocity: cannot be drawn, for its longest vector has "),
        ({"omega": 0.0, "alpha": 1e-320}, "acceleration: cannot be drawn, for its longest vector"),
    ],
)
def test_vectors_that_no_scale_brings_to_a_page_are_refused(
    inputs: dict[str, float], said: str
) -> None:
    motion = vad.solve(vad.FourBar(), **inputs)
    with pytest.raises(vad.InputError) as caught:
        vad.draw(motion)
    assert str(caught.value).startswith(said)
    vad.draw(motion, "position")


def test_an_equation_begins_with_the_part_that_is_drawn() -> None:
    """The crank and the rocker turn about one point as one body, so that the rocker has no α."""
    kind = vad.load(example_path("four-bar-with-slider"))
    panel = vad.draw(vad.solve(kind(Cy=0.0))).panel("acceleration")
    first, *_ = panel.equations[1].left
    assert (first.stroke, first.label) == ("CB.normal", "c\u2032b\u2033ₙ")
    drawn = {stroke.name for stroke in panel.strokes}
    assert {t.stroke for each in panel.equations for t in (*each.left, *each.right)} <= drawn


def test_a_plate_that_is_a_point_beside_another_length_is_drawn() -> None:
    kind = vad.load(example_path("v-engine"))
    panel = vad.draw(vad.solve(kind(AB=1.5e102))).panel("velocity")
    lines = [stroke.shape for stroke in panel.strokes if isinstance(stroke.shape, Line)]
    assert lines
    assert all(abs(line.direction) == pytest.approx(1.0) for line in lines)


def test_a_point_next_to_a_line_has_an_angle() -> None:
    """The arc tangent of so small a slope is no error, though it underflows."""
    kind = vad.mechanism(
        fixed={"A": (0, 5e-324), "C": (-1800, 0)},
        links={"crank": {"AB": 330}, "rod": {"BD": 1800}, "beam": {"CD": 1800}},
        driver={"crank": {"angle": 0, "omega": 18}},
    )
    vad.draw(vad.solve(kind(), angle=60.0), "position")
    vad.draw(vad.solve(kind(crank=3.3e102, rod=3.3e102), angle=60.0), "position")
