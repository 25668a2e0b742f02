"""Other people's readers of what the painters write: resvg, PDFium, pypdf and fontTools."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pypdf
import pypdfium2
import resvg_py
from fontTools.ttLib import TTFont
from numpy.typing import NDArray
from PIL import Image

from vad.painting.agg_painter import AggPainter
from vad.painting.painter import Painter
from vad.painting.pdf_painter import PdfPainter
from vad.painting.svg_painter import SvgPainter
from vad.plan.format import Format
from vad.strokes.sheet import Sheet

Pixels = NDArray[np.float64]  # RGB, 0 to 255, shape (height, width, 3)
MEDIA = ("agg", "svg glyphs", "svg letters", "pdf")


class Medium:
    """One of `MEDIA`: its painter, and the pixels that a reader makes of what it has painted."""

    def __init__(self, name: str, form: Format, sheet: Sheet | None = None) -> None:
        self.name = name
        self.painter: Painter = self._painter(form, sheet or Sheet("", "title", (), (), ()))

    def _painter(self, form: Format, sheet: Sheet) -> Painter:
        if self.name == "agg":
            return AggPainter(form)
        if self.name == "pdf":
            return PdfPainter(sheet.title, sheet.language)
        return SvgPainter(sheet, "glyphs" if self.name == "svg glyphs" else "letters")

    def pixels(self) -> Pixels:
        """Return what stands on the page."""
        painter = self.painter
        if isinstance(painter, AggPainter):
            return painter.pixels[..., :3].astype(float)
        if isinstance(painter, PdfPainter):
            return pdf_pixels(pdf_bytes(painter))
        assert isinstance(painter, SvgPainter)
        return svg_pixels(painter.svg)


def svg_pixels(svg: str) -> Pixels:
    """Return an SVG as resvg renders it, with the fonts that it brings and no others."""
    with fonts_of(svg) as files:
        png = resvg_py.svg_to_bytes(svg_string=svg, font_files=files, skip_system_fonts=True)
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(float)


@contextmanager
def fonts_of(svg: str) -> Iterator[list[str]]:
    """Give the fonts that an SVG holds as files, which resvg does not take from the SVG."""
    with TemporaryDirectory() as folder:
        files = []
        for index, font in enumerate(fonts(svg)):
            font.flavor = None
            files.append(str(Path(folder, f"{index}.ttf")))
            font.save(files[-1])
        yield files


def fonts(svg: str) -> list[TTFont]:
    """Return the fonts that an SVG holds."""
    return [
        TTFont(io.BytesIO(base64.b64decode(data)))
        for data in re.findall(r"url\(data:font/woff;base64,([^)]*)\)", svg)
    ]


def pdf_bytes(painter: PdfPainter, words: Sequence[str] = ("a picture",)) -> bytes:
    """Return the file of all that a painter has painted."""
    target = io.BytesIO()
    painter.write(target, words)
    return target.getvalue()


def pdf_pixels(data: bytes, page: int = 0) -> Pixels:
    """Return a page as PDFium renders it, a point a pixel."""
    with pypdfium2.PdfDocument(data) as document:
        return np.asarray(document[page].render(scale=1).to_pil().convert("RGB")).astype(float)


def operations(data: bytes, page: int = 0) -> list[tuple[Sequence[Any], str]]:
    """Return operands and operators of a page, with those of its forms in their places."""
    reader = pypdf.PdfReader(io.BytesIO(data))
    forms = reader.pages[page]["/Resources"]["/XObject"]

    def inlined(content: Any) -> Iterator[tuple[Sequence[Any], str]]:
        for operands, operator in pypdf.generic.ContentStream(content, reader).operations:
            if operator == b"Do":
                yield from inlined(forms[operands[0]].get_object())
            else:
                yield operands, operator.decode()

    return list(inlined(reader.pages[page].get_contents()))


def page_count(data: bytes) -> int:
    """Return the number of pages."""
    return len(pypdf.PdfReader(io.BytesIO(data)).pages)


def media_box(data: bytes) -> tuple[float, ...]:
    """Return the box of the first page: left, bottom, right and top."""
    return tuple(map(float, pypdf.PdfReader(io.BytesIO(data)).pages[0].mediabox))


def pdf_catalog(data: bytes) -> Any:
    """Return what the file says of itself as a whole."""
    return pypdf.PdfReader(io.BytesIO(data)).trailer["/Root"]


def pdf_text(data: bytes, page: int = 0) -> str:
    """Return the text of a page."""
    return pypdf.PdfReader(io.BytesIO(data)).pages[page].extract_text()


def centres(data: bytes, page: int = 0) -> list[complex]:
    """Return the middles of all circles on a page: rings of eight curves."""
    found = []
    steps = operations(data, page)
    for start, (operands, operator) in enumerate(steps):
        ring = steps[start + 1 : start + 9]
        if operator == "m" and [each for _, each in ring] == ["c"] * 8:
            ends = [complex(float(values[4]), float(values[5])) for values, _ in ring]
            if abs(ends[-1] - complex(*map(float, operands))) < 0.01:
                found.append(sum(ends) / 8)
    return found
