"""Labels of turns: each is read as the name of its own dot, in all poses of every mechanism."""

from __future__ import annotations

import math

import pytest

import vad
from vad.plan.geometry import Rect
from vad.plan.pictures.vectors import DOT
from vad.plan.turning.spots import CORIOLIS, Spots, spots
from vad.plan.turning.turn_board import TurnBoard

KEY = 0.058
SHARE = 0.8  # of the distance to any other dot, at which its own has to be
PHASES = [step / 41 for step in range(41)]  # beside those that are planned

CASES = [(name, {}) for name in vad.MECHANISMS] + [("whitworth", {"rod": 300})]


@pytest.fixture(scope="module", params=CASES, ids=lambda case: "-".join([case[0], *case[1]]))
def mechanism(request):
    name, lengths = request.param
    return vad.MECHANISMS[name](**lengths)


def _distance(box: Rect, point: complex) -> float:
    aside = max(box.left - point.real, point.real - box.right, 0.0)
    above = max(box.bottom - point.imag, point.imag - box.top, 0.0)
    return math.hypot(aside, above)


def _misread(text: str, box: Rect, here: Spots, drawing: Rect) -> bool:
    """Tell whether a dot that is not the label's own is covered, or about as near to it."""
    letters = text.split(", ")
    own = min(_distance(box, here[letter].at) for letter in letters if letter in here)
    least = 0.0 if text == CORIOLIS else own / SHARE
    return any(
        _distance(box, spot.at) < max(least, DOT)
        for letter, spot in here.items()
        if letter not in (*letters, CORIOLIS) and drawing.holds(spot.at)
    )


def _meet(one: Rect, other: Rect) -> bool:
    return (
        one.left < other.right
        and other.left < one.right
        and one.bottom < other.top
        and other.bottom < one.top
    )


@pytest.mark.parametrize("size", [(1280, 720), (1024, 768)], ids=["wide", "narrow"])
def test_no_label_names_the_wrong_dot_or_covers_one(mechanism, size: tuple[int, int]):
    turn = vad.turn(mechanism, size=size)
    board = TurnBoard(turn, KEY)
    wrong, left_out, letters = [], 0, 0
    for phase in PHASES:
        sheet = turn.at(phase)
        for panel in sheet.panels:
            moving, drawing = board.panels[panel.name], board.page.panels[panel.name].drawing
            here, labels = spots(panel, moving.scale), moving.labels(panel, phase)
            named = {letter for name, _ in labels for letter in name.text.split(", ")}
            visible = {letter for letter, spot in here.items() if drawing.holds(spot.at)}
            letters += len(visible)
            left_out += len(visible - named)
            for number, (name, box) in enumerate(labels):
                if _misread(name.text, box, here, drawing):
                    wrong.append((phase, panel.name, name.text))
                wrong += [
                    (phase, panel.name, f"{name.text} upon {other.text}")
                    for other, taken in labels[:number]
                    if _meet(box, taken)
                ]
    assert wrong == []
    assert left_out <= 0.15 * letters


def test_points_that_coincide_share_a_label():
    turn = vad.turn(vad.DoubleSlider(), size=(1024, 768))
    board, shared = TurnBoard(turn, KEY), set()
    for phase in PHASES:
        panel = turn.at(phase).panels[-1]
        shared |= {name.text for name, _ in board.panels[panel.name].labels(panel, phase)}
    assert {"bₙ, b′", "bₙ", "b′"} <= shared
