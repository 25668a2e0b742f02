"""PDF as other programs read it: pages, words, text, and what pages share."""

from __future__ import annotations

import io
import unicodedata

import numpy as np
import pypdf
import pytest

import vad
from tests.painting.readers import centres, operations, pdf_bytes, pdf_pixels, pdf_text
from tests.painting.test_same_picture import sheet_of
from vad.export import lesson_pdf, picture_pdf
from vad.lecture.lesson import still
from vad.painting.agg_painter import AggPainter
from vad.painting.painter import play
from vad.painting.pdf_painter import PdfPainter
from vad.painting.posed import board_of
from vad.plan.format import Format
from vad.plan.items import Item, Level
from vad.plan.marks import Disc, Mark
from vad.strokes.description import describe
from vad.strokes.sheet import Sheet
from vad.style import Look, load_style
from vad.written import with_unit

pytestmark = pytest.mark.exhaustive


def written(sheet: Sheet, **options: object) -> bytes:
    target = io.BytesIO()
    picture_pdf.write(sheet, target, **options)
    return target.getvalue()


def plain(text: str) -> str:
    """Return text without blanks, its small digits and letters as large ones."""
    return "".join(unicodedata.normalize("NFKC", text).split())


def test_the_same_sheet_gives_the_same_bytes() -> None:
    data = written(sheet_of("four-bar"), style="print")
    assert data == written(sheet_of("four-bar"), style="print")
    assert b"Date" not in data and b"/ID" not in data


def test_a_strict_reader_has_nothing_to_repair() -> None:
    data = written(sheet_of("crank-slotted-lever"))
    reader = pypdf.PdfReader(io.BytesIO(data), strict=True)
    assert all(reader.get_object(number) is not None for number in range(1, len(reader.xref[0])))
    assert len(data) < 80_000


def figures(data: bytes) -> list[str]:
    """Return the words of each page, found from the page and from the document alike."""
    reader = pypdf.PdfReader(io.BytesIO(data))
    root = reader.trailer["/Root"]["/StructTreeRoot"]
    listed = [kid.get_object() for kid in root["/K"]["/K"]]
    numbers = root["/ParentTree"]["/Nums"]
    for page, figure in zip(reader.pages, listed, strict=True):
        place = numbers.index(page["/StructParents"])
        assert numbers[place + 1][figure["/K"]].get_object() == figure
        assert figure["/Pg"] == page and figure["/S"] == "/Figure" and figure["/P"] == root["/K"]
        operators = pypdf.generic.ContentStream(page.get_contents(), reader).operations
        assert operators[0] == (["/Figure", {"/MCID": 0}], b"BDC")
        assert operators[-1][1] == b"EMC"
    return [figure["/Alt"] for figure in listed]


def test_a_screen_reader_meets_a_figure_in_words() -> None:
    sheet = sheet_of("four-bar")
    data = written(sheet)
    assert pypdf.PdfReader(io.BytesIO(data)).trailer["/Root"]["/MarkInfo"]["/Marked"]
    assert figures(data) == [describe(sheet)]


def test_a_page_of_a_lesson_says_its_step() -> None:
    lesson, target = vad.animate(sheet_of("slider-crank")), io.BytesIO()
    lesson_pdf.write(lesson, target)
    captions = [step.stroke.caption for step in lesson.steps]
    assert figures(target.getvalue()) == [*captions, str(lesson.answer)]


@pytest.mark.parametrize("code", ["en", "de"])
def test_it_says_what_it_shows(code: str) -> None:
    sheet = vad.draw(vad.solve(vad.SliderCrank()), language=code)
    reader = pypdf.PdfReader(io.BytesIO(written(sheet)))
    assert reader.metadata.title.startswith(sheet.title)
    assert reader.trailer["/Root"]["/Lang"] == code
    assert reader.trailer["/Root"]["/ViewerPreferences"]["/DisplayDocTitle"]


@pytest.mark.parametrize("name", vad.MECHANISMS)
def test_text_can_be_searched(name: str) -> None:
    sheet = sheet_of(name)
    text = plain(pdf_text(written(sheet)))
    assert plain(sheet.title) in text
    for row in sheet.rows:
        for cells, cell in ((own, each) for own in row.cells.values() for each in own):
            value, unit = sheet.notation.cell(cell.value, cell.unit, cell.given)
            if len(cells) == 1:  # where it is tight, their column has said the unit
                value = with_unit(value, unit)
            assert plain(f"{cell.symbol.replace('_', '')} = {value}") in text


def test_every_page_of_a_lesson_is_that_of_the_film_with_its_caption() -> None:
    lesson = vad.animate(sheet_of("slider-crank"), style="chalk")
    target = io.BytesIO()
    lesson_pdf.write(lesson, target)
    data = target.getvalue()
    assert len(data) < 156_000
    board, agg = board_of(lesson), AggPainter(board_of(lesson).form)
    for number, step in enumerate(lesson.steps):
        assert plain(step.stroke.caption).rstrip(".") in plain(pdf_text(data, number))
        if number % 4 == 3:
            play(board, still(lesson, number + 1).moment, load_style(lesson.style), agg)
            off = np.abs(pdf_pixels(data, number) - agg.pixels[..., :3])
            assert off.max() <= 80
            assert (off > 32).mean() <= 0.0005


def painted(*pages: tuple[complex, ...]) -> bytes:
    """Return pages with a group for each disc."""
    painter = PdfPainter("title", "en")
    for page in pages:
        painter.begin(Format(1.0, 1.0, 100.0), "#FFFFFF")
        for spot in page:
            painter.group(Item("", "page", Level.DOT, ()))
            painter.paint(Mark(Disc(spot, 0.05), "dot"), Look("#000000"))
        painter.end()
    return pdf_bytes(painter, [str(page) for page in pages])


def test_what_pages_share_is_written_once() -> None:
    a, b, c, d = 0.2 + 0.2j, 0.4 + 0.4j, 0.6 + 0.6j, 0.8 + 0.8j
    pages = (a, b, c), (a, b, d, c), (d, c)
    data = painted(*pages)
    for page, spots in enumerate(pages):
        expected = [100 * spot for spot in spots]
        assert centres(data, page) == pytest.approx(expected, abs=0.01)
    reader = pypdf.PdfReader(io.BytesIO(data))
    streams = [reader.get_object(number) for number in reader.xref[0]]
    circles = sum(each.get_data().count(b" c\n") for each in streams if hasattr(each, "get_data"))
    assert circles == 4 * 8


def test_pens_are_set_anew_in_every_group() -> None:
    data = painted((0.2 + 0.2j, 0.4 + 0.4j))
    names = [operator for _, operator in operations(data)]
    assert names.count("q") == names.count("Q") == 3
    assert names.count("rg") == 3
