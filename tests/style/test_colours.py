"""Inks that any eye can tell apart, and words that can be read; the figures are today's least."""

from __future__ import annotations

from itertools import combinations, pairwise

import numpy as np
import pytest

from tests.style.colours import SIGHT, ciede2000, contrast, distance
from vad.style import load_style, style_names

# The least CIEDE2000 distance of two inks: (neighbouring rows, all rows).  A distance of 2 is just
# seen side by side; inks of one drawing that are 15 apart are not taken for one another.
LEAST = {
    ("paper", "normal"): (38.0, 21.5),
    ("paper", "protanopia"): (17.2, 15.4),
    ("paper", "deuteranopia"): (16.9, 15.7),
    ("paper", "tritanopia"): (32.8, 15.3),
    ("chalk", "normal"): (24.6, 22.6),
    ("chalk", "protanopia"): (17.3, 15.4),
    ("chalk", "deuteranopia"): (15.4, 15.4),
    ("chalk", "tritanopia"): (17.5, 15.3),
}
LEAST_TEXT, LEAST_INK = 4.5, 3.0  # contrast with the background, as WCAG 2 asks of text and lines

every_style = pytest.mark.parametrize("name", style_names())


def test_every_style_in_colour_has_its_figures():
    coloured = {name for name in style_names() if len(load_style(name).inks) > 1}
    assert {name for name, _ in LEAST} == coloured
    assert {sight for _, sight in LEAST} == set(SIGHT)


@pytest.mark.parametrize(("name", "sight"), LEAST)
def test_inks_stay_apart(name: str, sight: str):
    inks = load_style(name).inks
    neighbours = min(distance(a, b, sight) for a, b in pairwise(inks))
    others = min(distance(a, b, sight) for a, b in combinations(inks, 2))
    assert neighbours >= LEAST[name, sight][0]
    assert others >= LEAST[name, sight][1]


@every_style
def test_words_can_be_read(name: str):
    style = load_style(name)
    for colour in (style.text, style.grey):
        assert contrast(colour, style.background) >= LEAST_TEXT


@every_style
def test_inks_stand_out_as_lines(name: str):
    style = load_style(name)
    assert min(contrast(ink, style.background) for ink in style.inks) >= LEAST_INK


@every_style
def test_rows_of_one_colour_differ_in_dash_or_weight(name: str):
    """Eight rows have an ink or a line of their own, and those beyond them a thinner one."""
    pens = [load_style(name).look("vector", row).pen for row in range(16)]
    assert None not in pens and len(set(pens)) == len(pens)
    for pen, other in pairwise(filter(None, pens)):
        if pen.colour == other.colour:
            dashes = [tuple(part / each.width for part in each.dash) for each in (pen, other)]
            wider = max(pen.width, other.width) / min(pen.width, other.width)
            assert dashes[0] != pytest.approx(dashes[1]) or wider >= 1.2


@every_style
def test_rows_take_their_inks_in_order_and_the_frame_is_grey(name: str):
    style = load_style(name)
    assert tuple(style.colour("row", row) for row in range(len(style.inks))) == style.inks
    assert style.colour("row", None) == style.grey


@pytest.mark.parametrize(
    ("one", "other", "known"),
    [
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, -1.0, 2.0), (50.0, 0.0, 0.0), 2.3669),
        ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0011), 7.2195),
        ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
        ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
        ((6.7747, -0.2908, -2.4247), (5.8714, -0.0985, -2.2286), 0.6377),
    ],
)
def test_the_distance_is_that_of_the_published_pairs(one, other, known):
    """Of Sharma, Wu and Dalal (2005), table 1."""
    assert ciede2000(np.array(one), np.array(other)) == pytest.approx(known, abs=5e-5)
