"""Labels: they touch no stroke, no other label and no edge, by two independent counts."""

from __future__ import annotations

import math

import numpy as np
import pytest

import vad
from tests.plan.overlaps import overlaps, planned
from tests.plan.sheets import slider_crank
from vad.errors import VadError
from vad.painting.agg_painter import AggPainter
from vad.painting.painter import Looks
from vad.plan.items import Level
from vad.strokes.sheet import Sheet
from vad.style import load_style, style_names


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
    look = load_style(style)
    looks = Looks(look)
    for degrees in (20.0, 75.0, 160.0, 250.0):
        board = planned(slider_crank(degrees))
        painter = AggPainter(board.form)
        painter.begin(board.form, look.background)
        for item in board.shown(board.finished):
            if item.region in board.sketches and item.level < Level.LABEL:
                for mark in item.marks:
                    painter.paint(mark.shape, looks(mark))
        for sketch in board.sketches.values():
            for tag in sketch.tags:
                if tag.span[1] <= board.finished:
                    continue
                box = [720 * side for side in (tag.box.bottom, tag.box.top, tag.box.left)]
                rows = slice(720 - math.ceil(box[1]), 720 - math.floor(box[0]))
                columns = slice(math.floor(box[2]), math.ceil(720 * tag.box.right))
                area = painter.words[rows, columns]
                assert np.all(area == painter.word(look.background)), (degrees, tag.text)
