"""A PDF file, written page by page: marks become paths, and what repeats is written once.

In come marks whose pixels are points, out go objects on a stream.  There are no dates and no
random identifiers: the same marks give the same bytes.

matplotlib can write PDF too, but not share what pages have in common: here a lesson of 24 pages
takes 134 kB, where a single sheet took 100 kB there, and its text can be searched.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Iterator, Sequence
from typing import BinaryIO

from vad.export import pdf_syntax as pdf
from vad.export.pdf_syntax import Area
from vad.export.pdf_type import Letters
from vad.plan.marks import Mark, Pen

_CATALOG, _PAGES, _RESOURCES, _INFO = 1, 2, 3, 4
#: A path with more points than this is written once, however often it is shown.
_SHORT = 40


class Document:
    """A PDF file in the making.

    Parameters
    ----------
    target
        A binary stream, which need not be sought.
    title, language
        What a reader's window and a screen reader say; the language is two letters.
    """

    def __init__(self, target: BinaryIO, title: str, language: str) -> None:
        self._target = target
        self._title, self._language = title, language
        self._length = 0
        self._offsets: dict[int, int] = {}
        self._next = _INFO + 1
        self._forms: list[int] = []
        self._pages: list[int] = []
        self._long: dict[Mark, int] = {}
        self._alphas: set[float] = set()
        self._letters = Letters(self._stream)
        self._put(b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n")

    def form(self, marks: Iterable[Mark], area: Area) -> int:
        """Write marks that pages show, and return their number."""
        return self._form("\n".join(self._operators(marks, area)), area)

    def _form(self, content: str, area: Area) -> int:
        head = f"/Type /XObject /Subtype /Form /BBox {pdf.box(area)} /Resources {_RESOURCES} 0 R"
        number = self._stream(content, head)
        self._forms.append(number)
        return number

    def page(self, forms: Sequence[int], area: Area) -> None:
        """Write a page that shows the marks of ``forms`` in their order."""
        content = self._stream(" ".join(f"/F{form} Do" for form in forms))
        page = (
            f"<< /Type /Page /Parent {_PAGES} 0 R /MediaBox {pdf.box(area)} "
            f"/Resources {_RESOURCES} 0 R /Contents {content} 0 R >>"
        )
        self._pages.append(self._object(page.encode()))

    def close(self) -> None:
        """Write what holds the pages together."""
        kids = " ".join(f"{page} 0 R" for page in self._pages)
        forms = " ".join(f"/F{form} {form} 0 R" for form in self._forms)
        alphas = " ".join(
            f"/{_alpha_name(alpha)} << /ca {pdf.number(alpha)} /CA {pdf.number(alpha)} >>"
            for alpha in sorted(self._alphas)
        )
        fonts = " ".join(
            f"/{name} {number} 0 R"
            for name, number in self._letters.write_fonts(lambda text: self._object(text.encode()))
        )
        shared = {
            # Printed in true size, unless somebody wants it otherwise.
            _CATALOG: f"<< /Type /Catalog /Pages {_PAGES} 0 R /Lang ({self._language}) "
            "/ViewerPreferences << /DisplayDocTitle true /PrintScaling /None >> >>",
            _PAGES: f"<< /Type /Pages /Kids [{kids}] /Count {len(self._pages)} >>",
            _RESOURCES: f"<< /XObject << {forms} >> /Font << {fonts} >> "
            f"/ExtGState << {alphas} >> >>",
            _INFO: f"<< /Title {pdf.string(self._title)} /Creator (vad) /Producer (vad) >>",
        }
        for number, content in shared.items():
            self._object(content.encode(), number)
        start, count = self._length, self._next
        rows = "".join(f"{self._offsets[number]:010d} 00000 n \n" for number in range(1, count))
        self._put(f"xref\n0 {count}\n0000000000 65535 f \n{rows}".encode())
        trailer = f"<< /Size {count} /Root {_CATALOG} 0 R /Info {_INFO} 0 R >>"
        self._put(f"trailer\n{trailer}\nstartxref\n{start}\n%%EOF\n".encode())

    def _put(self, data: bytes) -> None:
        self._target.write(data)
        self._length += len(data)

    def _object(self, content: bytes, number: int = 0) -> int:
        if not number:
            number, self._next = self._next, self._next + 1
        self._offsets[number] = self._length
        self._put(b"%d 0 obj\n%b\nendobj\n" % (number, content))
        return number

    def _stream(self, content: str, head: str = "") -> int:
        data = zlib.compress(content.encode(), 9)
        head = f"<< {head} /Filter /FlateDecode /Length {len(data)} >>"
        return self._object(b"%b\nstream\n%b\nendstream" % (head.encode(), data))

    def _operators(self, marks: Iterable[Mark], area: Area) -> Iterator[str]:
        """Yield the operators that paint ``marks``, those of the pen only where it changes."""
        pen: Pen | None = None
        fill, alpha = "", 1.0
        for mark in marks:
            if mark.alpha != alpha:
                alpha = mark.alpha
                self._alphas.add(alpha)
                yield f"/{_alpha_name(alpha)} gs"
            if mark.fill and mark.fill != fill:
                fill = mark.fill
                yield f"{pdf.colour(fill)} rg"
            if mark.pen and mark.pen != pen:
                pen = mark.pen
                yield pdf.pen(pen)
            if mark.text and mark.fill and not mark.pen:
                yield self._letters.show(mark.text)
                continue
            path = pdf.path(mark.vertices, mark.codes)
            paint = "B" if mark.fill and mark.pen else "f" if mark.fill else "S"
            if len(mark.codes) <= _SHORT:
                yield from (*path, paint)
                continue
            if mark not in self._long:  # it takes pen, fill and alpha from where it is shown
                self._long[mark] = self._form("\n".join((*path, paint)), area)
            yield f"/F{self._long[mark]} Do"


def _alpha_name(alpha: float) -> str:
    return f"A{round(alpha * 1000)}"
