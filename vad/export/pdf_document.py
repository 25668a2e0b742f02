"""A PDF file, written page by page: marks become paths, and what repeats is written once.

In come marks whose pixels are points, out go objects on a stream.  There are no dates and no
random identifiers: the same marks give the same bytes.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Iterator, Sequence
from typing import BinaryIO

from vad.rendering.marks import CLOSE, CURVE, LINE, MOVE, Mark, Pen

POINTS_PER_INCH = 72.0
#: A thousandth of a point is 0.35 µm; fewer digits save little.
_DIGITS = 3
_CATALOG, _PAGES, _RESOURCES, _INFO = 1, 2, 3, 4
_QUADRATIC = 3  # a curve with one control point, as TrueType has it
_OPERATORS = {MOVE: "m", LINE: "l", CURVE: "c"}

Size = tuple[float, float]


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
        self._alphas: set[float] = set()
        self._put(b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n")

    def form(self, marks: Iterable[Mark], size: Size) -> int:
        """Write marks that pages show, and return their number."""
        content = "\n".join(self._operators(marks))
        head = f"/Type /XObject /Subtype /Form /BBox {_box(size)} /Resources {_RESOURCES} 0 R"
        number = self._stream(content, head)
        self._forms.append(number)
        return number

    def page(self, forms: Sequence[int], size: Size) -> None:
        """Write a page of ``size`` points that shows the marks of ``forms`` in their order."""
        content = self._stream(" ".join(f"/F{form} Do" for form in forms))
        page = (
            f"<< /Type /Page /Parent {_PAGES} 0 R /MediaBox {_box(size)} "
            f"/Resources {_RESOURCES} 0 R /Contents {content} 0 R >>"
        )
        self._pages.append(self._object(page.encode()))

    def close(self) -> None:
        """Write what holds the pages together."""
        kids = " ".join(f"{page} 0 R" for page in self._pages)
        forms = " ".join(f"/F{form} {form} 0 R" for form in self._forms)
        alphas = " ".join(
            f"/{_alpha_name(alpha)} << /ca {_number(alpha)} /CA {_number(alpha)} >>"
            for alpha in sorted(self._alphas)
        )
        shared = {
            # Printed in true size, unless somebody wants it otherwise.
            _CATALOG: f"<< /Type /Catalog /Pages {_PAGES} 0 R /Lang ({self._language}) "
            "/ViewerPreferences << /DisplayDocTitle true /PrintScaling /None >> >>",
            _PAGES: f"<< /Type /Pages /Kids [{kids}] /Count {len(self._pages)} >>",
            _RESOURCES: f"<< /XObject << {forms} >> /ExtGState << {alphas} >> >>",
            _INFO: f"<< /Title {_text(self._title)} /Creator (vad) /Producer (vad) >>",
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

    def _operators(self, marks: Iterable[Mark]) -> Iterator[str]:
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
                yield f"{_colour(fill)} rg"
            if mark.pen and mark.pen != pen:
                pen = mark.pen
                yield _pen(pen)
            yield from _path(mark)
            yield "B" if mark.fill and mark.pen else "f" if mark.fill else "S"


def _path(mark: Mark) -> Iterator[str]:
    """Yield the operators of a path; a quadratic curve becomes the cubic one that it is."""
    points = mark.vertices.tolist()
    codes = mark.codes.tolist()
    place = 0
    while place < len(codes):
        code = codes[place]
        if code == CLOSE:
            yield "h"
            place += 1
            continue
        if code == _QUADRATIC:
            (x0, y0), (x1, y1), (x2, y2) = points[place - 1 : place + 2]
            curve = ((x0 + 2 * x1) / 3, (y0 + 2 * y1) / 3, (x2 + 2 * x1) / 3, (y2 + 2 * y1) / 3)
            yield f"{' '.join(map(_number, (*curve, x2, y2)))} c"
            place += 2
            continue
        count = 3 if code == CURVE else 1
        values = [value for point in points[place : place + count] for value in point]
        yield f"{' '.join(map(_number, values))} {_OPERATORS[code]}"
        place += count


def _pen(pen: Pen) -> str:
    dash = " ".join(map(_number, pen.dash))
    cap, join = int(pen.cap == "round"), int(pen.join == "round")
    return f"{_colour(pen.ink)} RG {_number(pen.width)} w {cap} J {join} j [{dash}] 0 d"


def _colour(name: str) -> str:
    return " ".join(_number(int(name[i : i + 2], 16) / 255) for i in (1, 3, 5))


def _alpha_name(alpha: float) -> str:
    return f"A{round(alpha * 1000)}"


def _box(size: Size) -> str:
    return f"[0 0 {_number(size[0])} {_number(size[1])}]"


def _number(value: float) -> str:
    """Return a number as PDF reads it, which knows no exponents.

    Examples
    --------
    >>> _number(2.5), _number(-0.0001), _number(100.0)
    ('2.5', '0', '100')
    """
    text = f"{value:.{_DIGITS}f}".rstrip("0").removesuffix(".")
    return "0" if text == "-0" else text


def _text(text: str) -> str:
    return f"<FEFF{text.encode('utf-16-be').hex().upper()}>"
