"""PDF: shapes become paths and letters on pages; what some pages share is written once.

Marks come page by page and become a file, in which a pixel of the same picture is a point.  The
file is tagged: every page is a figure, which a screen reader meets in words.

matplotlib can write PDF too, but not share what pages have in common, and its text cannot be
searched.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from itertools import pairwise
from typing import BinaryIO

from vad.painting.pdf_file import (
    Letters,
    Objects,
    PageArea,
    box,
    colour,
    number,
    path,
    string,
    take,
)
from vad.painting.shapes import outline
from vad.plan.format import Format
from vad.plan.items import Item
from vad.plan.marks import Lettering, Mark, Outline, Polygon
from vad.style import Look, Pen


class PdfPainter:
    """A painter of pages, which are written when all are painted.

    Parameters
    ----------
    title, language
        What a reader's window and a screen reader say; the language is two letters.
    """

    def __init__(self, title: str, language: str) -> None:
        self._title, self._language = title, language
        self._letters = Letters()
        self._alphas: set[int] = set()  # in thousandths
        self._areas: list[PageArea] = []
        self._pages: list[list[str]] = []
        self._operators: list[str] = []
        self._fill: str | None = None
        self._pen: Pen | None = None
        self._alpha = 1000

    def begin(self, form: Format, background: str) -> None:
        """Begin a page with its ground, edge included."""
        self._unit = form.unit
        left, right = -form.edge, form.width + form.edge
        bottom, top = -form.edge, form.height + form.edge
        self._areas.append(
            (left * form.unit, bottom * form.unit, right * form.unit, top * form.unit)
        )
        self._pages.append([])
        self._fresh()
        ring = (
            complex(left, bottom),
            complex(right, bottom),
            complex(right, top),
            complex(left, top),
        )
        self._paint(Polygon((ring,)), Look(background))

    def group(self, item: Item) -> None:
        """Begin what may be shared with other pages."""
        self._finish()

    def paint(self, mark: Mark, look: Look) -> None:
        """Paint one mark."""
        self._paint(mark.shape, look)

    def _paint(self, shape: Outline, look: Look) -> None:
        if look.under:
            self._set(None, look.under, 1.0)
            self._path(shape, "S")
        self._set(look.fill, look.pen, look.alpha)
        if isinstance(shape, Lettering) and look.fill and not look.pen:
            self._operators.append(self._letters.show(shape, self._unit))
            return
        self._path(shape, "B" if look.fill and look.pen else "f" if look.fill else "S")

    def end(self) -> None:
        """End the page."""
        self._finish()

    def write(self, target: BinaryIO, words: Sequence[str]) -> None:
        """Write all pages, each with what it shows in words."""
        objects = Objects(target)
        catalog, tree, resources, info = (objects.reserve() for _ in range(4))
        pages, forms = self._write_pages(objects, tree, resources)
        shapes = " ".join(f"/F{form} {form} 0 R" for form in forms)
        alphas = " ".join(
            f"/A{each} << /ca {number(each / 1000)} /CA {number(each / 1000)} >>"
            for each in sorted(self._alphas)
        )
        fonts = self._letters.write(objects)
        objects.write(
            f"<< /XObject << {shapes} >> /Font {fonts} /ExtGState << {alphas} >> >>", resources
        )
        kids = " ".join(f"{page} 0 R" for page in pages)
        objects.write(f"<< /Type /Pages /Kids [{kids}] /Count {len(pages)} >>", tree)
        tagged = write_structure(objects, pages, self._areas, words)
        # Printed in true size, unless somebody wants it otherwise.
        objects.write(
            f"<< /Type /Catalog /Pages {tree} 0 R /Lang ({self._language}) {tagged} "
            "/ViewerPreferences << /DisplayDocTitle true /PrintScaling /None >> >>",
            catalog,
        )
        objects.write(f"<< /Title {string(self._title)} /Creator (vad) /Producer (vad) >>", info)
        objects.close(catalog, info)

    def _write_pages(
        self, objects: Objects, tree: int, resources: int
    ) -> tuple[list[int], list[int]]:
        """Write pages, and forms with what they share; return the numbers of both."""
        split = pieces(self._pages)
        shows = Counter(piece for page in split for piece in page)
        forms: dict[str, int] = {}
        pages: list[int] = []
        for index, (page, area) in enumerate(zip(split, self._areas, strict=True)):
            frame = f"{box(area)} /Resources {resources} 0 R"
            content: list[str] = []
            for piece in page:
                if shows[piece] > 1 and piece not in forms:
                    head = f"/Type /XObject /Subtype /Form /BBox {frame}"
                    forms[piece] = objects.stream(piece, head)
                content.append(f"/F{forms[piece]} Do" if piece in forms else piece)
            stream = objects.stream(marked("\n".join(content)))
            pages.append(
                objects.write(
                    f"<< /Type /Page /Parent {tree} 0 R /MediaBox {frame} "
                    f"/Contents {stream} 0 R {entry(index)} >>"
                )
            )
        return pages, list(forms.values())

    def _path(self, shape: Outline, paint: str) -> None:
        vertices, codes = outline(shape)
        if len(codes):
            self._operators += [*path(vertices * self._unit, codes), paint]

    def _set(self, fill: str | None, pen: Pen | None, alpha: float) -> None:
        """Set colours, pen and alpha, as far as they change within a group."""
        thousandths = round(1000 * alpha)
        if thousandths != self._alpha:
            self._alpha = thousandths
            self._alphas.add(thousandths)
            self._operators.append(f"/A{thousandths} gs")
        if fill and fill != self._fill:
            self._fill = fill
            self._operators.append(f"{colour(fill)} rg")
        if pen and pen != self._pen:
            self._pen = pen
            self._operators.append(take(pen, self._unit))

    def _finish(self) -> None:
        """Put what was painted since the last group on the page."""
        if self._operators:
            self._pages[-1].append("\n".join(["q", *self._operators, "Q"]))
        self._fresh()

    def _fresh(self) -> None:
        self._operators = []
        self._fill, self._pen, self._alpha = None, None, 1000


def pieces(pages: Sequence[Sequence[str]]) -> list[list[str]]:
    """Return each page in as few pieces as can be, none of which is part of another.

    Two groups are in one piece where they follow each other on every page that has either.

    Examples
    --------
    >>> for page in pieces([["a", "b", "c"], ["a", "b", "x", "c"]]):
    ...     print([piece.splitlines() for piece in page])
    [['a', 'b'], ['c']]
    [['a', 'b'], ['x'], ['c']]
    """
    after: dict[str, set[str]] = defaultdict(set)
    before: dict[str, set[str]] = defaultdict(set)
    for page in pages:
        for one, other in pairwise(["", *page, ""]):
            after[one].add(other)
            before[other].add(one)
    found: list[list[str]] = []
    for page in pages:
        runs: list[list[str]] = []
        for one, other in pairwise(["", *page]):
            if after[one] == {other} and before[other] == {one} and runs:
                runs[-1].append(other)
            else:
                runs.append([other])
        found.append(["\n".join(run) for run in runs])
    return found


def entry(number: int) -> str:
    """Return what the dictionary of page ``number`` says of its place in the structure."""
    return f"/StructParents {number} /Tabs /S"


def marked(content: str) -> str:
    """Return the content of a page as one piece that the structure can point at."""
    return f"/Figure << /MCID 0 >> BDC\n{content}\nEMC"


def write_structure(
    objects: Objects, pages: Sequence[int], areas: Sequence[PageArea], words: Sequence[str]
) -> str:
    """Write the structure of a document and return what its catalog says of it.

    Parameters
    ----------
    objects
        The file that is being written.
    pages, areas, words
        The number of each page's object, its rectangle in points, and what it shows.
    """
    root, document = objects.reserve(), objects.reserve()
    figures = [
        objects.write(
            f"<< /Type /StructElem /S /Figure /P {document} 0 R /Pg {page} 0 R /K 0 "
            f"/Alt {string(text)} /A << /O /Layout /Placement /Block /BBox {box(area)} >> >>"
        )
        for page, area, text in zip(pages, areas, words, strict=True)
    ]
    kids = " ".join(f"{figure} 0 R" for figure in figures)
    objects.write(f"<< /Type /StructElem /S /Document /P {root} 0 R /K [{kids}] >>", document)
    parents = " ".join(f"{number} [{figure} 0 R]" for number, figure in enumerate(figures))
    objects.write(
        f"<< /Type /StructTreeRoot /K {document} 0 R /ParentTreeNextKey {len(figures)} "
        f"/ParentTree << /Nums [{parents}] >> >>",
        root,
    )
    return f"/MarkInfo << /Marked true >> /StructTreeRoot {root} 0 R"
