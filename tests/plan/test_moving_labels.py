"""Labels of turns: none lies on a stroke or upon another, and each glides about its own dot."""

from __future__ import annotations

from functools import cache

import pytest

import vad
from vad.plan.labels.placing import Placed
from vad.plan.turning.turn_board import TurnBoard

FRAMES = 240  # of the 8 s that a turn takes
EVERY = 15
MOST = 6.0 / 720.0  # on the page, from one frame to the next

#: A lever with its ram shows all that one without it does.
CASES = {
    **{name: vad.MECHANISMS[name]() for name in vad.MECHANISMS},
    "crank-slotted-lever": vad.CrankSlottedLever(rod=100, ram_height=180),
    "whitworth": vad.Whitworth(rod=300),
    "swing": vad.FourBar(crank=130),
}


@cache
def board(name: str) -> TurnBoard:
    return TurnBoard(vad.turn(CASES[name]))


def _meet(one: Placed, other: Placed) -> bool:
    away = one.centre - other.centre
    aside, above = (one.wide + other.wide) / 2, (one.high + other.high) / 2
    return abs(away.real) < aside and abs(away.imag) < above


@pytest.mark.parametrize("name", CASES)
def test_labels_lie_on_no_stroke_and_glide(name: str):
    here = board(name)
    met, frames, inked, labels = 0, 0, 0.0, 0
    for frame in range(0, FRAMES, EVERY):
        phases = frame / FRAMES, (frame + 1) / FRAMES
        sheet = here.turn.at(phases[0])
        for index, panel in enumerate(here.panels.values()):
            pose = sheet.panels[index]
            strokes = panel.picture.pose(pose).obstacles
            found = panel.labels(pose, phases[0])
            frames += 1
            labels += len(panel.names)
            inked += sum(alpha for _, _, alpha in found)
            boxes = [placed for _, placed, _ in found]
            on_stroke = any(
                not strokes.free([b.centre], b.wide, b.high, 0.0)[0]
                for b in boxes
                if panel.room.inside(b.high).holds(b.centre)
            )
            upon = any(_meet(b, other) for n, b in enumerate(boxes) for other in boxes[:n])
            met += on_stroke or upon
            for label in panel.names:
                offsets = [label.spring.at(phase)[0] for phase in phases]
                assert abs(offsets[1] - offsets[0]) <= MOST, (label.text, frame)
    assert met <= 0.01 * frames
    assert inked >= 0.7 * labels  # what fades comes back


def test_a_label_belongs_to_the_dot_of_its_letters():
    """The dots stand where the sheet of each pose has its points."""
    here = board("whitworth")
    panel, phase = here.panels["velocity"], 0.3
    pose = here.turn.at(phase).panels[1]
    for label in panel.names:
        ends = [
            spot
            for stroke in pose.strokes
            if hasattr(stroke.shape, "head")
            for letter, spot in (
                (stroke.shape.head, stroke.shape.end),
                (stroke.shape.tail, stroke.shape.start),
            )
            if letter == label.letters[-1]
        ]
        dot = panel.dot(label, pose, phase)
        assert ends
        assert all(abs(panel.scale(spot) - dot) < 1e-4 for spot in ends)
    assert {label.text for label in panel.names} == {"a, d", "b", "q", "c", "e"}
