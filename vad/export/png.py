"""A picture as PNG: in comes a sheet or a step of a lesson, out go its pixels, and it in words."""

from __future__ import annotations

from typing import BinaryIO

from vad.lecture.still import Still
from vad.painting.posed import sheet_of, still
from vad.strokes.sheet import Sheet
from vad.strokes.words import describe, title


def write(
    thing: Sheet | Still,
    target: BinaryIO,
    size: tuple[int, int] | None = None,
    style: str | None = None,
) -> None:
    """Write the picture, ``size`` in pixels."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    pixels = still(thing, size, style)
    words = PngInfo()
    words.add_itxt("Title", title(sheet_of(thing)))
    words.add_itxt("Description", describe(sheet_of(thing)))
    picture = Image.fromarray(pixels[..., :3])
    picture.save(target, format="PNG", pnginfo=words, compress_level=4)
