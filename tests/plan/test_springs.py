"""Labels of turns: each glides about its dot, and lies on a stroke for no more than a moment."""

from __future__ import annotations

import numpy as np
import pytest

import vad
from tests.plan.turns import LEVER, numbered
from vad.files.examples import example_path
from vad.plan.labels.obstacles import Obstacles
from vad.plan.labels.placing import Placed, distance
from vad.plan.labels.springs import _ACROSS, _MET, FASTEST, POSES, _calm, _shown, _smooth
from vad.plan.lettering.glyphs import typeset
from vad.plan.marks import Lettering, Mark, Polyline
from vad.plan.turn_board import NumberedTurn, TurnBoard
from vad.plan.turn_labels import Name, TurnLabels
from vad.strokes.sheet import Panel

pytestmark = pytest.mark.exhaustive

FRAMES = 240  # of the 8 s that a turn takes
EVERY = 24

#: A lever with its ram shows all that one without it does.
CASES = {
    **{name: vad.MECHANISMS[name]() for name in vad.MECHANISMS},
    "crank-slotted-lever": LEVER,
    "whitworth": vad.Whitworth(rod=300, ram_height=0),
    "swing": vad.FourBar(crank=130),
}


def board(name: str) -> NumberedTurn:
    """Return the still of a turn: its panels are those of the film."""
    return numbered(CASES[name])


def _meet(one: Placed, other: Placed) -> bool:
    away = one.centre - other.centre
    aside, above = (one.wide + other.wide) / 2, (one.high + other.high) / 2
    return abs(away.real) < aside and abs(away.imag) < above


@pytest.mark.parametrize("case", CASES)
def test_labels_glide_and_cross_strokes_seldom(case: str):
    here = board(case)
    on_stroke, upon, inked, labels = 0, 0, 0, 0
    for frame in range(0, FRAMES, EVERY):
        phases = frame / FRAMES, (frame + 1) / FRAMES
        sheet = here.turn.at(phases[0])
        for name, panel in here.panels.items():
            pose = sheet.panel(name)
            strokes = panel.picture.pose(pose).obstacles
            found = panel.labels.at(pose, phases[0])
            labels += len(panel.labels.names)
            inked += len(found)
            boxes = [placed for _, placed in found]
            met = [
                not strokes.free([b.centre], b.wide, b.high, 0.0)[0]
                for b in boxes
                if panel.room.inside(b.high).holds(b.centre)
            ]
            on_stroke += sum(met)
            assert frame or not any(met)  # that pose is a still, too
            upon += sum(_meet(b, other) for n, b in enumerate(boxes) for other in boxes[:n])
            for label in panel.labels.names:
                before, after = (label.spring.at(phase) for phase in phases)
                if before is not None and after is not None:
                    most = FASTEST * POSES / FRAMES
                    assert abs(after - before) <= most + 1e-9, (label.text, frame)
    assert on_stroke <= 0.03 * inked
    assert upon <= 0.01 * inked
    assert inked >= 0.9 * labels  # what goes comes back


@pytest.mark.parametrize("case", CASES)
def test_a_label_is_absent_for_no_more_than_what_hides_it(case: str):
    """It shows in all poses, or else a stroke meets it for longer than a crossing takes.

    Or it would hide another dot, or stand on what is written once for all poses.
    """
    here = board(case)
    for name, panel in here.panels.items():
        for label in panel.labels.names:
            gone = ~label.spring.shown
            if gone.all():
                continue
            for first in np.flatnonzero(gone & ~np.roll(gone, 1)).tolist():
                length = int((~np.roll(gone, -first)).argmax())
                if length <= _ACROSS:
                    numbers = [(first + step) % POSES for step in range(length)]
                    assert any(hides(here, name, label, number) for number in numbers), label.text


def hides(here: TurnBoard, panel: str, name: Name, number: int) -> bool:
    """Tell whether a label would be on another dot or a standing text, were it not absent."""
    labels, phase = here.panels[panel].labels, number / POSES
    pose = here.turn.at(phase).panel(panel)
    own = labels.dot(name, pose, phase)
    box = Placed(own + name.spring.offsets[number], *labels._size(name.text, name.vector)).box
    near = labels._radius + _MET + 1e-9
    texts = (tag.box for tag in here.panels[panel].picture.still.tags)
    on_text = any(
        abs(text.centre.real - box.centre.real) < (text.width + box.width) / 2
        and abs(text.centre.imag - box.centre.imag) < (text.height + box.height) / 2
        for text in texts
    )
    return on_text or any(distance(box, at) < near for at in other_dots(labels, name, pose, phase))


def other_dots(labels: TurnLabels, name: Name, pose: Panel, phase: float) -> list[complex]:
    """Return the dots with letters that are not that of a label, and do not lie over it."""
    own = labels.dot(name, pose, phase)
    places = [
        labels._spot(each.letters, "", pose, phase)
        for each in labels.names
        if each.letters and each is not name
    ]
    return [at for at, alpha in places if alpha > 0.0 and abs(at - own) > labels._radius]


#: Many dots that come near to one another; of a lens, too.
CROWDED = {
    "coupling-rod": [80, 10],
    "stephenson-3": [190, 110],
    "trunnion": [230, 0],
    "landing-gear": [20, 0],
    "pantograph": [10, 50],
    "toggle-press": [210, 50],
    "peaucellier": [70, 190],
    "watt-1": [120, 130],
}


@pytest.mark.parametrize("case", CROWDED)
def test_a_label_hides_no_other_dot_and_is_nearer_to_its_own(case: str):
    """Where dots crowd together it may be nearer to another one, but a line leads to its own."""
    here = TurnBoard(vad.turn(vad.load(example_path(case))()))
    labelled = nearer = lost = 0
    for frame in sorted({*range(0, FRAMES, EVERY), *CROWDED[case]}):
        phase = frame / FRAMES
        sheet = here.turn.at(phase)
        for half in sheet.halves:
            panel = here.panels[half.name]
            for labels in (panel.labels, *([panel.lens.labels] if panel.lens else [])):
                for name, placed in labels.at(half, phase):
                    others = other_dots(labels, name, half, phase)
                    away = min((distance(placed.box, at) for at in others), default=np.inf)
                    if not name.vector:
                        assert away > labels._radius, (name.text, half.name, frame)
                        own = labels.dot(name, half, phase)
                        labelled += 1
                        nearer += away < distance(placed.box, own)
                        led = list(labels._leader(name, own, placed))
                        lost += away < distance(placed.box, own) and not led
    assert nearer <= 0.06 * labelled
    assert lost <= 0.02 * labelled


def test_a_smoothed_way_is_no_faster_than_a_label_may_be():
    """Where smoothing ends at a stroke, the label does not jump back to its way."""
    step = FASTEST * np.exp(0.4j * np.pi * np.arange(60))
    way = np.cumsum(np.concatenate([step, -step]))
    for number in range(0, 120, 7):
        met = np.arange(120) == number
        calm = _calm(way, lambda offsets, met=met: met & (np.abs(offsets - way) > 1e-9))
        assert np.abs(np.roll(calm, -1) - calm).max() <= FASTEST * (1 + 1e-6)


@pytest.mark.parametrize("name", CASES)
def test_no_number_meets_a_stroke_a_letter_or_another_number(name: str):
    here = board(name)
    shown, sheet, numbered = here.shown(0), here.turn.at(0.0), 0
    for column in sheet.panels:
        marks = [m for item in shown if item.region == column.name for m in item.marks]
        halves = [(here.panels[half.name], half) for half in column.halves]
        drawn = [panel.picture.pose(half).obstacles for panel, half in halves]
        room = here.page.panels[column.name].drawing
        strokes = Obstacles(room, [line for each in drawn for line in each.lines])
        for way in (mark.shape for mark in marks if mark.role == "hodograph"):
            assert isinstance(way, Polyline)
            for piece in way.pieces:
                strokes.line(piece, 0.0)
        taken = [placed for panel, half in halves for _, placed in panel.labels.at(half, 0.0)]
        for numeral in (_ink_box(mark) for mark in marks if mark.role == "numeral"):
            assert strokes.free([numeral.centre], numeral.wide, numeral.high, 0.0)[0]
            assert not any(_meet(numeral, other) for other in taken)
            taken.append(numeral)
            numbered += 1
    assert numbered >= 30


def _ink_box(mark: Mark) -> Placed:
    text = mark.shape
    assert isinstance(text, Lettering)
    ink = typeset(text.runs)
    middle = complex(ink.left + ink.right, ink.bottom + ink.top) / 2
    wide, high = ink.right - ink.left, ink.top - ink.bottom
    return Placed(text.at + text.size * middle, text.size * wide, text.size * high)


def test_a_label_belongs_to_the_dot_of_its_letters():
    """The dots stand where the sheet of each pose has its points."""
    here = board("whitworth")
    panel, phase = here.panels["velocity"], 0.3
    pose = here.turn.at(phase).panels[1]
    for label in panel.labels.names:
        ends = [
            spot
            for stroke in pose.strokes
            if hasattr(stroke.shape, "head")
            for letter, spot in (
                (stroke.shape.head, stroke.shape.end),
                (stroke.shape.tail, stroke.shape.start),
            )
            if letter == label.letters[-1].letter
        ]
        dot = panel.labels.dot(label, pose, phase)
        assert ends
        assert all(abs(panel.scale(spot) - dot) < 1e-4 for spot in ends)
    assert {label.text for label in panel.labels.names} == {"a, d", "b", "q", "c", "e"}


def test_a_way_is_not_smoothed_where_the_label_would_meet_a_stroke():
    way = np.where(np.arange(120) < 60, 0.0, 0.010) + 0j

    def meets(offsets: np.ndarray) -> np.ndarray:
        return (offsets.real > 0.002) & (offsets.real < 0.008)

    assert meets(_smooth(way)).any()
    calm = _calm(way, meets)
    assert not meets(calm).any()
    beside = np.abs((np.arange(120) + 30) % 60 - 30)  # poses from the nearest step
    assert calm[beside > 4] == pytest.approx(_smooth(way)[beside > 4])


def test_a_label_shows_while_it_crosses_a_stroke_and_is_absent_where_that_lasts():
    met = np.zeros(120, dtype=np.bool_)
    met[[0, 1, 118, 119]] = True  # about the first pose
    none = np.zeros(120, dtype=np.bool_)
    assert _shown(met, none).all()
    met[2] = True
    assert np.flatnonzero(~_shown(met, none)).tolist() == [0, 1, 2, 3, 117, 118, 119]
    assert not _shown(np.ones(120, dtype=np.bool_), none).any()


def test_a_label_is_absent_at_once_where_it_would_hide_another_dot():
    met = np.zeros(120, dtype=np.bool_)
    met[[40, 41, 80]] = True
    hides = np.arange(120) == 41
    assert np.flatnonzero(~_shown(met, hides)).tolist() == [39, 40, 41, 42]
