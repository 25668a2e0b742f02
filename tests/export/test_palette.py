from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from vad.export.palette import Palette, coarse, fine
from vad.style import load_style, style_names


def rgb(colour: str) -> list[int]:
    return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]


MAKERS = pytest.mark.parametrize("make", [coarse, fine])
STYLES = pytest.mark.parametrize("name", style_names())


@STYLES
@MAKERS
def test_colours_of_a_style(name: str, make: Callable[[str], Palette]) -> None:
    style, colours = load_style(name), make(name).colours[1:]
    assert len(colours) <= 255
    assert len(np.unique(colours, axis=0)) == len(colours)
    assert colours[0].tolist() == rgb(style.background)
    for ink in (style.text, style.grey, style.hairline, *style.inks):
        assert rgb(ink) in colours.tolist()


@STYLES
def test_few_colours_need_few_bits(name: str) -> None:
    assert len(coarse(name).colours) <= 32


@STYLES
@pytest.mark.parametrize(("make", "near"), [(coarse, 90), (fine, 7)])
def test_antialiased_edges_are_near(name: str, make: Callable[[str], Palette], near: float) -> None:
    style, palette = load_style(name), make(name)
    share = np.linspace(0, 1, 101)[:, None]
    ground = np.array(rgb(style.background))
    for ink in (style.text, style.grey, style.hairline, *style.inks):
        edge = (ground + share * (rgb(ink) - ground)).round().astype(np.uint8)
        pixels = np.concatenate([edge, np.full((101, 1), 255, np.uint8)], 1)[None]
        seen = palette.colours[palette.indices(pixels)[0]].astype(float)
        assert np.sqrt(((seen - edge) ** 2).sum(-1)).max() <= near


def test_every_pixel_takes_the_nearest_colour() -> None:
    palette = coarse("paper")
    pixels = np.random.default_rng(4).integers(0, 256, (40, 50, 4), np.uint8)
    table = palette.colours.astype(int)
    distance = ((pixels[..., None, :3].astype(int) - table[1:]) ** 2).sum(-1)
    for _ in range(2):
        found = palette.indices(pixels)
        assert found.min() > 0
        chosen = ((pixels[..., :3].astype(int) - table[found]) ** 2).sum(-1)
        assert (chosen == distance.min(-1)).all()


def test_windows_of_a_larger_picture() -> None:
    pixels = np.random.default_rng(5).integers(0, 256, (40, 50, 4), np.uint8)
    palette = fine("chalk")
    whole = palette.indices(pixels)
    assert (palette.indices(pixels[3:20, 7:9]) == whole[3:20, 7:9]).all()
