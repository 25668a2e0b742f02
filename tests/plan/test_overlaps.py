"""Labels: they touch no stroke, no other label and no edge, by two independent counts."""

from __future__ import annotations

import math

import numpy as np
import pytest

import vad
from tests.plan.sheets import slider_crank
from vad.errors import VadError
from vad.painting.canvas import AggCanvas
from vad.plan.art import Level
from vad.plan.board import Board
from vad.plan.overlaps import overlaps
from vad.strokes.sheet import Sheet
from vad.style import style_names


@pytest.mark.parametrize("degrees", range(0, 360, 30))
def test_a_full_turn_of_a_slider_crank(degrees: int):
    sheet = slider_crank(degrees + 0.01)
    assert overlaps(sheet) == []
    assert overlaps(sheet, lesson=True) == []
    assert overlaps(sheet, (1024, 768)) == []


def turn(name: str) -> list[Sheet]:
    mechanism = vad.MECHANISMS[name]
    sheets = []
    for step in range(12):
        inputs = dict(mechanism.inputs)
        if "angle" in inputs:
            inputs.update(angle=30 * step + 5, alpha=20 * (step % 2))
        else:
            inputs["position"] *= 0.9 + step / 60
        try:
            sheets.append(vad.draw(vad.solve(mechanism(), **inputs)))
        except VadError:
            continue  # beyond the reach of a driven slide
    return sheets


@pytest.mark.parametrize("name", sorted(vad.MECHANISMS))
def test_a_full_turn_of_every_mechanism(name: str):
    sheets = turn(name)
    assert len(sheets) > 3
    for sheet in sheets:
        assert overlaps(sheet) == []


@pytest.mark.parametrize("style", style_names())
def test_finished_labels_cover_only_background(style: str):
    """Paint the panels without their letters: where these would stand, all is background."""
    for degrees in (20.0, 75.0, 160.0, 250.0):
        board = Board(slider_crank(degrees), (1280, 720), style)
        done = board.finished().done
        canvas = AggCanvas((1280, 720), board.style.background)
        for count, art in zip(done, board.arts.values(), strict=True):
            canvas.paint(
                mark
                for item in sorted(art.items, key=lambda item: item.level)
                if item.since <= count < item.until and item.level < Level.LABEL
                for mark in item.marks
            )
        for count, art in zip(done, board.arts.values(), strict=True):
            for tag in art.tags:
                if tag.span[1] <= count:
                    continue
                rows = slice(720 - math.ceil(tag.box.top), 720 - math.floor(tag.box.bottom))
                columns = slice(math.floor(tag.box.left), math.ceil(tag.box.right))
                area = canvas.words[rows, columns]
                assert np.all(area == canvas.background), (degrees, tag.text)
