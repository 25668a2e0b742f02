"""Panels in motion: all of the velocity polygon is seen, and each letter is near its dot or led."""

from __future__ import annotations

import math

import pytest

import vad
from tests.plan.turns import LEG, LEVER, WHITWORTH, board_of
from vad.files.examples import example_path
from vad.plan.labels.obstacles import PIXEL, Obstacles
from vad.plan.labels.springs import POSES
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Bow, Lettering, Polyline
from vad.plan.reach import corners
from vad.plan.turn_board import TurnBoard
from vad.plan.turn_labels import FAR
from vad.strokes.sheet import Arrow

pytestmark = pytest.mark.exhaustive

CASES = {
    **{name: vad.MECHANISMS[name]() for name in vad.MECHANISMS},
    "shaper": LEVER,
    "whitworth-ram": WHITWORTH,
    "swing": vad.FourBar(crank=130),
    "leg": LEG,
}
PHASES = [number / 24 for number in range(24)]


def board(name: str, size: tuple[int, int] = (1280, 720)) -> TurnBoard:
    return board_of(CASES[name], size)


@pytest.mark.parametrize("size", [(1280, 720), (960, 720)])
@pytest.mark.parametrize("name", CASES)
def test_the_velocity_polygon_never_leaves_its_panel(name: str, size: tuple[int, int]):
    here = board(name, size)
    panel = here.panels["velocity"]
    for phase in PHASES:
        pose = here.turn.at(phase).panel("velocity")
        assert all(panel.room.holds(panel.scale(z), PIXEL) for z in corners(pose)), phase


@pytest.mark.parametrize("name", CASES)
def test_a_letter_that_is_far_from_its_dot_is_led_to_it_and_none_is_pale(name: str):
    here = board(name)
    for panel in here.panels.values():
        for phase in PHASES[::4]:
            pose = here.turn.at(phase).panel(panel.picture.still.setting.panel.name)
            shown = [m for item in panel.pose(pose, phase).items for m in item.marks]
            assert all(mark.alpha == 1.0 for mark in shown if mark.role in ("letter", "tag"))
            ends = [m.shape.pieces[0] for m in shown if m.role == "leader" and m.alpha == 1.0]
            for label, placed in panel.labels.at(pose, phase):
                away = panel.labels.dot(label, pose, phase) - placed.centre
                aside = max(abs(away.real) - placed.wide / 2, 0.0)
                above = max(abs(away.imag) - placed.high / 2, 0.0)
                gap = math.hypot(aside, above) - panel.picture.radius
                if label.vector or gap < FAR:
                    continue
                dot = panel.labels.dot(label, pose, phase)
                assert any(abs(end - dot) < panel.picture.radius + 5 * PIXEL for _, end in ends)


@pytest.mark.parametrize("size", [(1280, 720), (960, 720), (720, 1280)])
@pytest.mark.parametrize("name", ["slider-crank", "shaper", "hooke-joint"])
def test_headings_have_one_size_on_a_page_and_values_too(name: str, size: tuple[int, int]):
    shown = board(name, size).shown(0)
    for ending in (" head", " curve"):
        sizes = {
            round(mark.shape.size, 9)
            for item in shown
            if item.region.endswith(ending)
            for mark in item.marks
            if mark.role in ("words", "term") and isinstance(mark.shape, Lettering)
        }
        assert len(sizes) == 1, (ending, sizes)


@pytest.mark.parametrize(
    "name", ["slider-crank", "four-bar", "whitworth", "rssr", "leg", "swing", "gate-actuator"]
)
def test_the_arrow_of_a_constant_omega_stands_where_no_link_meets_its_name(name: str):
    here = board(name)
    marks = [mark for item in here.unmoved for mark in item.marks]
    arrows = [mark.shape for mark in marks if mark.role == "sense"]
    texts = [mark.shape.runs for mark in marks if isinstance(mark.shape, Lettering)]
    given = [text for text in ("".join(run.text for run in runs) for runs in texts) if "ω2" in text]
    if name in ("swing", "gate-actuator"):  # whose driver has no constant ω
        assert not arrows and not given
        return
    (arrow,), omega = arrows, "−6" if name == "leg" else "10"
    assert any(f"ω2 {omega} rad/s" in text for text in given)
    assert isinstance(arrow, Bow)
    still = here.panels["position"].picture.still
    assert arrow.sweep * still.setting.sheet.driver.omega > 0.0
    (box,) = (tag.box for tag in still.tags if tag.text == "ω₂")
    assert abs(arrow.centre - box.centre) < arrow.radius + 0.06
    for phase in PHASES:
        pose = here.panels["position"].picture.pose(here.turn.at(phase).panel("position"))
        moving = [line for line in pose.obstacles.lines if line not in still.obstacles.lines]
        free = Obstacles(still.setting.room, moving).free([box.centre], box.width, box.height, 0.0)
        assert free.all(), phase


def test_a_given_alpha_stands_beside_omega_as_both_were_typed():
    here = board_of(vad.load(example_path("toggle-press"))())
    shapes = [mark.shape for item in here.unmoved for mark in item.marks]
    texts = ["".join(r.text for r in each.runs) for each in shapes if isinstance(each, Lettering)]
    assert any("ω2 180 rpm" in text and "α2 50 rad/s2" in text for text in texts)


@pytest.mark.parametrize("name", CASES)
def test_no_letter_passes_over_what_is_written_once_for_all_poses(name: str):
    for panel in board(name).panels.values():
        written = [tag.box for tag in panel.picture.still.tags]
        for number in range(0, POSES, 3):
            pose = board(name).turn.at(number / POSES)
            pose = pose.panel(panel.picture.still.setting.panel.name)
            for label, placed in panel.labels.at(pose, number / POSES):
                for text in written:
                    away = text.centre - placed.centre
                    aside = abs(away.real) - (text.width + placed.wide) / 2
                    above = abs(away.imag) - (text.height + placed.high) / 2
                    assert max(aside, above) > -PIXEL, (number, label.text)


def test_no_letter_stands_on_the_ground_on_which_a_foot_walks():
    here = board("leg")
    panel = here.panels["position"]
    ground = Obstacles(panel.room)
    for item in here.unmoved:
        for mark in item.marks if not item.stroke else ():  # no pivot's
            if mark.role == "hatching" and isinstance(mark.shape, Polyline):
                for piece in mark.shape.pieces:
                    ground.line(piece, 0.0)
    assert len(ground.lines) > 10
    for phase in PHASES:
        for label, placed in panel.labels.at(here.turn.at(phase).panel("position"), phase):
            assert ground.free([placed.centre], placed.wide, placed.high, 0.0).all(), label.text


def test_a_leader_begins_beside_its_letters():
    here = board("scotch-yoke")
    led = 0
    for panel in here.panels.values():
        for phase in PHASES:
            pose = here.turn.at(phase).panel(panel.picture.still.setting.panel.name)
            shown = [m for item in panel.pose(pose, phase).items for m in item.marks]
            texts = [m.shape for m in shown if isinstance(m.shape, Lettering)]
            for mark in shown:
                if mark.role == "leader":
                    assert isinstance(mark.shape, Polyline)
                    led += 1
                    start = mark.shape.pieces[0][0]
                    assert min(_apart(start, text) for text in texts) < 8 * PIXEL
    assert led


def _apart(point: complex, text: Lettering) -> float:
    ink = typeset(text.runs)
    low = text.at + text.size * complex(ink.left, ink.bottom)
    high = text.at + text.size * complex(ink.right, ink.top)
    aside = max(low.real - point.real, point.real - high.real, 0.0)
    return math.hypot(aside, max(low.imag - point.imag, point.imag - high.imag, 0.0))


@pytest.mark.parametrize(
    ("name", "letters"),
    [
        ("gate-actuator", {"velocity": {"s"}, "acceleration": {"s′", "sₙ", "z"}}),
        ("shaper", {"acceleration": {"z"}}),
    ],
)
def test_ends_of_vectors_that_are_no_images_have_letters(name: str, letters: dict[str, set[str]]):
    kind = vad.MECHANISMS.get(name) or vad.load(example_path(name))
    here = board_of(kind())
    for half, wanted in letters.items():
        panel = here.panels[half]
        found = {label.text: label for label in panel.labels.names}
        assert wanted <= found.keys()
        for phase in (0.0, 0.213, 0.611):
            pose = here.turn.at(phase).panel(half)
            arrows = [s.shape for s in pose.strokes if isinstance(s.shape, Arrow)]
            ends = {arrow.head: panel.scale(arrow.end) for arrow in arrows}
            for letter in wanted:
                at = panel.labels.dot(found[letter], pose, phase)
                assert abs(at - ends[letter]) < PIXEL, (letter, phase)
