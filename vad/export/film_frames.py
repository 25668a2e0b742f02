"""A lesson as a folder of PNG pictures, one for every frame of the constant rate.

The pictures are ``frame_0001.png`` …; a frame that repeats the one before is a hard link to it, if
the disk has hard links.
"""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterable
from itertools import count, islice
from pathlib import Path

import numpy as np

from vad.export.frames import Film, Progress, painted
from vad.export.palette import Palette, fine
from vad.painting.film import EMPTY, Frame

_NAME = re.compile(r"frame_\d{4,}\.png")
#: The entry by which a picture is known as made here; see `is_frame`.
_MAKER = ("Software", "vad")


def write(lesson: Film, folder: Path, *, progress: Progress | None = None) -> None:
    """Write the frames of ``lesson`` into ``folder``."""
    encode(
        painted(lesson, progress),
        folder,
        size=lesson.size,
        total=lesson.frames,
        palette=fine(lesson.style, len(lesson.sheet.rows)),
    )


def encode(
    frames: Iterable[Frame],
    folder: Path,
    *,
    size: tuple[int, int],
    total: int,
    palette: Palette,
) -> None:
    """Write ``total`` frames of ``size`` (width, height) into ``folder``."""
    from PIL import Image, PngImagePlugin

    maker = PngImagePlugin.PngInfo()
    maker.add_text(*_MAKER)
    canvas = np.zeros(size[::-1], np.uint8)
    digits = max(4, len(str(total)))
    paths = (folder / f"frame_{number:0{digits}d}.png" for number in count(1))
    last = folder
    for frame in frames:
        repeats = frame.repeats
        if frame.changed != EMPTY:
            left, top, right, bottom = frame.changed
            window = slice(top, bottom), slice(left, right)
            canvas[window] = palette.indices(frame.pixels[window])
            picture = Image.fromarray(canvas)
            picture.putpalette(palette.colours.tobytes())
            last, repeats = next(paths), repeats - 1
            picture.save(last, "PNG", compress_level=1, pnginfo=maker)
        for path in islice(paths, repeats):
            last = _again(last, path)


def is_frame(path: Path) -> bool:
    """Say whether ``path`` is a picture that `write` has made, by its name and its first bytes."""
    if not _NAME.fullmatch(path.name) or path.is_symlink() or not path.is_file():
        return False
    with open(path, "rb") as stream:
        return "\0".join(_MAKER).encode() in stream.read(1024)


def _again(path: Path, copy: Path) -> Path:
    """Make ``copy`` the same picture as ``path``; return the one to link the next one to."""
    try:
        os.link(path, copy)
    except OSError:  # no hard links here, or as many as a file can have
        shutil.copyfile(path, copy)
        return copy
    return path
