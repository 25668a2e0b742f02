"""A picture as PNG: in comes a sheet, out go its pixels with a description in the metadata."""

from __future__ import annotations

from typing import BinaryIO

from vad.diagrams.strokes import Sheet
from vad.rendering.alt import describe, title
from vad.rendering.still import still


def write(
    sheet: Sheet, target: BinaryIO, size: tuple[int, int] = (1280, 720), style: str = "paper"
) -> None:
    """Write the finished sheet, ``size`` in pixels."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    pixels = still(sheet, size, style)
    words = PngInfo()
    words.add_itxt("Title", title(sheet))
    words.add_itxt("Description", describe(sheet))
    picture = Image.fromarray(pixels[..., :3])
    picture.save(target, format="PNG", pnginfo=words, compress_level=4)
