from __future__ import annotations

import av
import numpy as np
import pytest

from vad.export.planes import convert, even


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
    samples = planes(2, 2)
    convert(pixels, (0, 0, 2, 2), *samples)
    assert tuple(int(plane[0, 0]) for plane in samples) == ycc


def test_all_colours_survive() -> None:
    random = np.random.default_rng(2)
    pixels = random.integers(0, 256, (64, 64, 4), np.uint8).repeat(2, 0).repeat(2, 1)
    frame = av.VideoFrame(128, 128, "yuv420p")
    samples = planes(128, 128)
    convert(pixels, (0, 0, 128, 128), *samples)
    y, cb, cr = (plane.astype(float) for plane in samples)
    y, cb, cr = 255 / 219 * (y - 16), 255 / 224 * (cb - 128), 255 / 224 * (cr - 128)
    cb, cr = (plane.repeat(2, 0).repeat(2, 1) for plane in (cb, cr))
    red, blue = y + 1.5748 * cr, y + 1.8556 * cb
    green = (y - 0.2126 * red - 0.0722 * blue) / 0.7152
    assert np.abs(np.stack([red, green, blue], -1) - pixels[..., :3]).max() < 2.5
    assert frame.format.name == "yuv420p"


@pytest.mark.parametrize("box", [(3, 5, 4, 6), (0, 0, 1, 1), (7, 2, 12, 9), (0, 0, 16, 12)])
def test_only_the_box_is_written(box: tuple[int, int, int, int]) -> None:
    random = np.random.default_rng(3)
    pixels = random.integers(0, 256, (12, 16, 4), np.uint8)
    whole, part = planes(16, 12), planes(16, 12)
    convert(pixels, (0, 0, 16, 12), *whole)
    convert(pixels, box, *part)
    left, top, right, bottom = even(box)
    for scale, full, window in zip((1, 2, 2), whole, part, strict=True):
        inside = (
            slice(top // scale, bottom // scale),
            slice(left // scale, right // scale),
        )
        assert (window[inside] == full[inside]).all()
        window[inside] = 7
        assert (window == 7).all()
