from __future__ import annotations

import numpy as np
import pytest

from vad.export.mp4.planes import convert, even


def planes(width: int, height: int) -> list[np.ndarray]:
    return [np.full((height // scale, width // scale), 7, np.uint8) for scale in (1, 2, 2)]


@pytest.mark.parametrize(
    ("rgb", "ycc"),
    [
        ((0, 0, 0), (16, 128, 128)),
        ((255, 255, 255), (235, 128, 128)),
        ((255, 0, 0), (63, 102, 240)),
        ((0, 255, 0), (173, 42, 26)),
        ((0, 0, 255), (32, 240, 118)),
    ],
)
def test_published_values(rgb: tuple[int, ...], ycc: tuple[int, ...]) -> None:
    pixels = np.full((2, 2, 4), (*rgb, 255), np.uint8)
    samples = convert(pixels, (0, 0, 2, 2))
    assert (samples.y[0, 0], samples.cb[0, 0], samples.cr[0, 0]) == ycc


def test_all_colours_survive() -> None:
    random = np.random.default_rng(2)
    pixels = random.integers(0, 256, (64, 64, 4), np.uint8).repeat(2, 0).repeat(2, 1)
    samples = convert(pixels, (0, 0, 128, 128))
    y = 255 / 219 * (samples.y - 16.0)
    cb, cr = (
        255 / 224 * (plane.repeat(2, 0).repeat(2, 1) - 128.0) for plane in (samples.cb, samples.cr)
    )
    red, blue = y + 1.5748 * cr, y + 1.8556 * cb
    green = (y - 0.2126 * red - 0.0722 * blue) / 0.7152
    assert np.abs(np.stack([red, green, blue], -1) - pixels[..., :3]).max() < 2.5


@pytest.mark.parametrize("box", [(3, 5, 4, 6), (0, 0, 1, 1), (7, 2, 12, 9), (0, 0, 16, 12)])
def test_only_the_box_is_written(box: tuple[int, int, int, int]) -> None:
    random = np.random.default_rng(3)
    pixels = random.integers(0, 256, (12, 16, 4), np.uint8)
    whole, part = planes(16, 12), planes(16, 12)
    convert(pixels, (0, 0, 16, 12)).store(whole)
    convert(pixels, box).store(part)
    left, top, right, bottom = even(box)
    for scale, full, window in zip((1, 2, 2), whole, part, strict=True):
        inside = (
            slice(top // scale, bottom // scale),
            slice(left // scale, right // scale),
        )
        assert (window[inside] == full[inside]).all()
        window[inside] = 7
        assert (window == 7).all()
