"""How PDF writes a file: numbered objects, numbers, paths, and letters as Type 3 fonts.

There are no dates and no random identifiers: the same pages give the same bytes.  The outline of
each letter is written once, as a character of a font, and the text can be searched and copied.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from typing import BinaryIO

from vad.painting.shapes import stretches
from vad.plan.lettering.glyphs import CLOSE, CURVE, LINE, MOVE, QUADRATIC, Codes, Letter, Points
from vad.plan.marks import Lettering
from vad.style import Pen

#: A thousandth of a point is 0.35 µm; fewer digits save little.
_DIGITS = 3
_OPERATORS = {MOVE: "m", LINE: "l", CURVE: "c"}

_ESCAPED = str.maketrans({letter: f"\\{letter}" for letter in "()\\"} | {"\r": "\\r"})

#: Left, bottom, right and top, in points.
PageArea = tuple[float, float, float, float]
_EM = 1000  # units of a character's own space
_FULL = 256  # characters of one font


def number(value: float) -> str:
    """Return a number as PDF reads it, which knows no exponents.

    Examples
    --------
    >>> number(2.5), number(-0.0001), number(100.0)
    ('2.5', '0', '100')
    """
    text = f"{value:.{_DIGITS}f}".rstrip("0").removesuffix(".")
    return "0" if text == "-0" else text


def colour(name: str) -> str:
    """Return ``#RRGGBB`` as three numbers from 0 to 1."""
    return " ".join(number(int(name[i : i + 2], 16) / 255) for i in (1, 3, 5))


def box(area: PageArea) -> str:
    """Return a rectangle."""
    return f"[{' '.join(map(number, area))}]"


def string(text: str) -> str:
    r"""Return any text as a string of a document's properties: two bytes a letter.

    Examples
    --------
    >>> string("ω (")
    '(þÿ\x03É\x00 \x00\\()'
    """
    data = f"\N{BYTE ORDER MARK}{text}".encode("utf-16-be").decode("latin-1")
    return f"({data.translate(_ESCAPED)})"


def take(pen: Pen, unit: float) -> str:
    """Return the operators that take up a pen, whose page unit is ``unit`` points."""
    dash = " ".join(number(part * unit) for part in pen.dash)
    cap, join = int(pen.cap == "round"), int(pen.join == "round")
    return f"{colour(pen.colour)} RG {number(pen.width * unit)} w {cap} J {join} j [{dash}] 0 d"


def path(vertices: Points, codes: Codes) -> Iterator[str]:
    """Yield the operators of a path; a quadratic curve is written as the same cubic curve."""
    points, kinds = vertices.tolist(), codes.tolist()
    place = 0
    # Each round goes on by a point or more.
    while place < len(kinds):
        kind = kinds[place]
        if kind == CLOSE:
            yield "h"
            place += 1
            continue
        if kind == QUADRATIC:
            (x0, y0), (x1, y1), (x2, y2) = points[place - 1 : place + 2]
            curve = ((x0 + 2 * x1) / 3, (y0 + 2 * y1) / 3, (x2 + 2 * x1) / 3, (y2 + 2 * y1) / 3)
            yield f"{' '.join(map(number, (*curve, x2, y2)))} c"
            place += 2
            continue
        count = 3 if kind == CURVE else 1
        values = [value for point in points[place : place + count] for value in point]
        yield f"{' '.join(map(number, values))} {_OPERATORS[kind]}"
        place += count


class Objects:
    """The objects of a file that is being written, on a stream that need not be seekable."""

    def __init__(self, target: BinaryIO) -> None:
        self._target = target
        self._length = 0
        self._offsets: dict[int, int] = {}
        self._count = 0
        self._put(b"%PDF-1.4\n%\xe2\xe3\xcf\xd3\n")

    def reserve(self) -> int:
        """Return the number of an object that is written later."""
        self._count += 1
        return self._count

    def write(self, content: str, number: int = 0) -> int:
        """Write an object and return its number, a new one unless it was reserved."""
        return self._write(content.encode("latin-1"), number)

    def stream(self, content: str, head: str = "") -> int:
        """Write a compressed stream as a new object; ``head`` is what else its dictionary has."""
        data = zlib.compress(content.encode(), 9)
        head = f"<< {head} /Filter /FlateDecode /Length {len(data)} >>"
        return self._write(b"%b\nstream\n%b\nendstream" % (head.encode(), data))

    def close(self, catalog: int, info: int) -> None:
        """Write where every object begins."""
        start, count = self._length, self._count + 1
        rows = [b"%010d 00000 n \n" % self._offsets[number] for number in range(1, count)]
        self._put(b"xref\n0 %d\n0000000000 65535 f \n%b" % (count, b"".join(rows)))
        trailer = f"<< /Size {count} /Root {catalog} 0 R /Info {info} 0 R >>"
        self._put(f"trailer\n{trailer}\nstartxref\n{start}\n%%EOF\n".encode())

    def _write(self, content: bytes, number: int = 0) -> int:
        number = number or self.reserve()
        self._offsets[number] = self._length
        self._put(b"%d 0 obj\n%b\nendobj\n" % (number, content))
        return number

    def _put(self, data: bytes) -> None:
        self._target.write(data)
        self._length += len(data)


class Letters:
    """The fonts of one file, of 256 letters each, which grow as letters are met."""

    def __init__(self) -> None:
        self._letters: dict[tuple[str, str], Letter] = {}
        self._places: dict[tuple[str, str], int] = {}

    def show(self, text: Lettering, unit: float) -> str:
        """Return the operators that show a line of text in the colour that is set.

        ``unit`` is a page unit in points.
        """
        words: list[str] = []
        for stretch in stretches(text.runs):
            at = (text.at + text.size * stretch[0].at) * unit
            size = number(text.size * stretch[0].size * unit)
            place = f"1 0 0 1 {number(at.real)} {number(at.imag)} Tm"
            for index, (font, codes) in enumerate(self._coded(stretch)):
                words += [f"/T{font} {size} Tf", *([place] if index == 0 else []), f"<{codes}> Tj"]
        return " ".join(["BT", *words, "ET"])

    def write(self, objects: Objects) -> str:
        """Write the fonts, and return the dictionary in which a page finds them."""
        letters = list(self._letters.values())
        fonts = [letters[start : start + _FULL] for start in range(0, len(letters), _FULL)]
        entries = (f"/T{index} {_font(font, objects)} 0 R" for index, font in enumerate(fonts))
        return f"<< {' '.join(entries)} >>"

    def _coded(self, stretch: tuple[Letter, ...]) -> list[tuple[int, str]]:
        """Return the letters of a stretch as numbers of fonts, and codes in them."""
        found: list[tuple[int, str]] = []
        for letter in stretch:
            key = letter.face, letter.text
            place = self._places.setdefault(key, len(self._places))
            self._letters.setdefault(key, letter)
            font, code = divmod(place, _FULL)
            if found and found[-1][0] == font:
                found[-1] = font, f"{found[-1][1]}{code:02X}"
            else:
                found.append((font, f"{code:02X}"))
        return found


def _font(letters: list[Letter], objects: Objects) -> int:
    """Write a font and return its number."""
    outlines = [objects.stream(_outline(letter)) for letter in letters]
    names = " ".join(f"/g{code}" for code in range(len(letters)))
    shapes = " ".join(f"/g{code} {each} 0 R" for code, each in enumerate(outlines))
    widths = " ".join(number(letter.advance * _EM) for letter in letters)
    meaning = objects.stream(_meaning([letter.text for letter in letters]))
    return objects.write(
        "<< /Type /Font /Subtype /Type3 /FontBBox [0 0 0 0] "
        f"/FontMatrix [{1 / _EM} 0 0 {1 / _EM} 0 0] /Resources << >> "
        f"/FirstChar 0 /LastChar {len(letters) - 1} /Widths [{widths}] "
        f"/Encoding << /Type /Encoding /Differences [0 {names}] >> "
        f"/CharProcs << {shapes} >> /ToUnicode {meaning} 0 R >>"
    )


def _outline(letter: Letter) -> str:
    head = f"{number(letter.advance * _EM)} 0"
    if not len(letter.vertices):
        return f"{head} d0"
    vertices = letter.vertices * _EM
    bounds = " ".join(number(each) for each in (*vertices.min(axis=0), *vertices.max(axis=0)))
    return "\n".join([f"{head} {bounds} d1", *path(vertices, letter.codes), "f"])


def _meaning(texts: list[str]) -> str:
    """Return the table by which a reader copies and searches."""
    rows = [
        f"<{code:02X}> <{text.encode('utf-16-be').hex().upper()}>"
        for code, text in enumerate(texts)
    ]
    blocks = [rows[start : start + 100] for start in range(0, len(rows), 100)]
    return "\n".join(
        [
            "/CIDInit /ProcSet findresource begin 12 dict begin begincmap",
            "/CMapName /vad def /CMapType 2 def",
            "1 begincodespacerange <00> <FF> endcodespacerange",
            *("\n".join([f"{len(block)} beginbfchar", *block, "endbfchar"]) for block in blocks),
            "endcmap CMapName currentdict /CMap defineresource pop end end",
        ]
    )
