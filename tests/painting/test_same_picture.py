"""Real pictures: what resvg and PDFium make of SVG and PDF is what Agg paints, panel by panel."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import vad
from tests.painting.readers import MEDIA, Medium, Pixels
from vad.painting.posed import Posed, posed
from vad.strokes.sheet import Sheet

PARTS = {"crank-slotted-lever": {"rod": 120, "ram_height": 140}, "whitworth": {"rod": 300}}
PICTURES = [
    ("double-slider", "paper", (960, 540)),
    ("gate-actuator", "paper", (960, 540)),
    ("scotch-yoke", "paper", (960, 540)),
    ("whitworth", "paper", (960, 540)),
    ("crank-slotted-lever", "print", (960, 540)),
    ("slider-crank", "chalk", (960, 540)),
    ("four-bar", "print", (640, 480)),
]

#: Of 255 steps of a colour: an edge in black and white that is off by a third of a pixel has 85.
FARTHEST = 80
#: The share of pixels of a region that may be off by more than an eighth; antialiasing differs.
OFF = 0.003


@cache
def sheet_of(name: str) -> Sheet:
    mechanism = vad.MECHANISMS[name](**PARTS.get(name, {}))
    return vad.draw(vad.solve(mechanism))


def rendered(medium: str, shown: Posed) -> Pixels:
    page = Medium(medium, shown.board.form, shown.sheet)
    shown.play(page.painter)
    return page.pixels()


@pytest.mark.exhaustive
@pytest.mark.parametrize(("name", "style", "size"), PICTURES)
def test_every_painter_paints_the_same(name: str, style: str, size: tuple[int, int]) -> None:
    shown = posed(sheet_of(name), size, style)
    unit, expected = shown.board.form.unit, rendered("agg", shown)
    for medium in MEDIA[1:]:
        found = rendered(medium, shown)
        assert found.shape == expected.shape
        for region, area in shown.board.regions.items():
            rows = slice(
                max(0, round(size[1] - area.top * unit)), round(size[1] - area.bottom * unit)
            )
            columns = slice(max(0, round(area.left * unit)), round(area.right * unit))
            off = np.abs(found - expected)[rows, columns].max(axis=2)
            if not off.size:
                continue
            # A corner of a stroke may be smoothed otherwise; what stands elsewhere has an edge.
            far = off > FARTHEST
            assert not (far[1:] & far[:-1]).any(), (medium, region)
            assert not (far[:, 1:] & far[:, :-1]).any(), (medium, region)
            assert (off > 255 / 8).mean() <= OFF, (medium, region)
