"""Stills: the same bytes each time, with words in them."""

from __future__ import annotations

import io
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from tests.plan.sheets import slider_crank
from vad.errors import UsageError
from vad.export import picture_png
from vad.painting.posed import picture
from vad.style import load_style, style_names


def written(**options) -> bytes:
    target = io.BytesIO()
    picture_png.write(slider_crank(), target, **options)
    return target.getvalue()


def test_the_same_sheet_gives_the_same_bytes():
    assert written(style="print") == written(style="print")


def test_png_holds_the_pixels_and_a_description():
    image = Image.open(io.BytesIO(written(size=(800, 450), style="chalk")))
    assert image.size == (800, 450)
    assert np.array_equal(np.asarray(image), picture(slider_crank(), (800, 450), "chalk")[..., :3])
    assert "crank 60 mm" in image.info["Title"]
    assert "ω = −2.308 rad/s" in image.info["Description"]


@pytest.mark.parametrize("panels", [("position",), ("velocity",), ("velocity", "acceleration")])
@pytest.mark.parametrize("size", [(1280, 720), (1024, 768), (400, 600)])
def test_a_sheet_may_hold_some_panels_only(panels: tuple[str, ...], size: tuple[int, int]):
    sheet = slider_crank()
    part = replace(sheet, panels=tuple(p for p in sheet.panels if p.name in panels))
    assert picture(part, size).shape == (size[1], size[0], 4)


def test_margins_stay_empty():
    for size in ((1280, 720), (1024, 768)):
        pixels = picture(slider_crank(), size)
        edge = int(0.02 * size[1])
        assert (pixels[:edge] == 255).all()
        assert (pixels[-edge:] == 255).all()
        assert (pixels[:, :edge] == 255).all()
        assert (pixels[:, -edge:] == 255).all()


def test_styles_are_read_from_their_files_and_have_contrast():
    assert style_names() == ("chalk", "paper", "print")
    for name in style_names():
        style = load_style(name)
        assert contrast(style.text, style.background) > 4.5
        assert contrast(style.grey, style.background) > 4.5
    with pytest.raises(UsageError, match="unknown style 'papr'"):
        load_style("papr")


def contrast(one: str, other: str) -> float:
    def luminance(colour: str) -> float:
        parts = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_laying_out_needs_no_pyplot():
    code = (
        "import sys; import vad.painting.film, vad.lecture.lesson;"
        "assert 'matplotlib' not in sys.modules;"
        "from tests.plan.sheets import slider_crank;"
        "from vad.painting.posed import picture; picture(slider_crank());"
        "assert 'matplotlib.pyplot' not in sys.modules;"
        "assert 'matplotlib.axes' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
