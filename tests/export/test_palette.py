from __future__ import annotations

import numpy as np
import pytest

from vad.export.palette import Palette, film_palette
from vad.rendering.style import load_style, style_names


def rgb(colour: str) -> list[int]:
    return [int(colour[i : i + 2], 16) for i in (1, 3, 5)]


@pytest.mark.parametrize("name", style_names())
@pytest.mark.parametrize("limit", [63, 255])
def test_colours_of_a_style(name: str, limit: int) -> None:
    style, colours = load_style(name), film_palette(name, limit).colours[1:]
    assert len(colours) <= limit
    assert len(np.unique(colours, axis=0)) == len(colours)
    assert colours[0].tolist() == rgb(style.background)
    for ink in (style.text, style.grey, style.hairline, *style.inks):
        assert rgb(ink) in colours.tolist()


@pytest.mark.parametrize("name", style_names())
@pytest.mark.parametrize(("limit", "near"), [(63, 17), (255, 10)])
def test_antialiased_edges_are_near(name: str, limit: int, near: float) -> None:
    style, palette = load_style(name), film_palette(name, limit)
    share = np.linspace(0, 1, 101)[:, None]
    ground = np.array(rgb(style.background))
    for ink in (style.text, style.grey, style.hairline, *style.inks):
        edge = (ground + share * (rgb(ink) - ground)).round().astype(np.uint8)
        pixels = np.concatenate([edge, np.full((101, 1), 255, np.uint8)], 1)[None]
        seen = palette.colours[palette.indices(pixels)[0]].astype(float)
        assert np.sqrt(((seen - edge) ** 2).sum(-1)).max() <= near


def test_every_pixel_takes_the_nearest_colour() -> None:
    palette = film_palette("paper", 63)
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
    palette = film_palette("chalk")
    whole = palette.indices(pixels)
    assert (palette.indices(pixels[3:20, 7:9]) == whole[3:20, 7:9]).all()


def test_one_ink() -> None:
    assert len(Palette("#000000", ["#000000"], 5).colours) == 2
