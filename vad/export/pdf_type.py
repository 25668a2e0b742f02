"""The letters of a PDF file: each outline is written once, as a character of a Type 3 font.

In come settings of text, out go operators that show it; the text can be searched and copied.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from vad.export import pdf_syntax as pdf
from vad.plan.marks import Letter, Setting

_EM = 1000  # units of a character's own space
_FULL = 256  # characters of one font

#: Writes a stream and returns its number: its content, and what its dictionary says besides.
WriteStream = Callable[[str, str], int]
#: Writes an object and returns its number.
WriteObject = Callable[[str], int]


@dataclass
class _Font:
    """Up to 256 letters: the numbers of their outlines, their widths, and what they are."""

    outlines: list[int] = field(default_factory=list)
    widths: list[float] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)


class Letters:
    """The fonts of one file, which grow as letters are met."""

    def __init__(self, write_stream: WriteStream) -> None:
        self._write_stream = write_stream
        self._fonts: list[_Font] = []
        self._codes: dict[tuple[str, str], tuple[int, int]] = {}

    def show(self, setting: Setting) -> str:
        """Return the operators that show a line of text in the colour that is set."""
        words = ["BT"]
        font, size, codes = -1, 0.0, ""
        pen: complex | None = None
        for letter in setting.letters:
            home, code = self._code(letter)
            if home != font or letter.size != size or pen is None or abs(letter.at - pen) > 1e-6:
                if codes:
                    words.append(f"<{codes}> Tj")
                    codes = ""
                if home != font or letter.size != size:
                    font, size = home, letter.size
                    words.append(f"/T{font} {pdf.number(setting.size * size)} Tf")
                at = setting.at + setting.size * letter.at
                words.append(f"1 0 0 1 {pdf.number(at.real)} {pdf.number(at.imag)} Tm")
            codes += f"{code:02X}"
            pen = letter.at + letter.advance * letter.size
        return " ".join([*words, f"<{codes}> Tj", "ET"])

    def write_fonts(self, write: WriteObject) -> Iterator[tuple[str, int]]:
        """Write the fonts, and yield the name and the number of each."""
        for index, font in enumerate(self._fonts):
            last = len(font.outlines) - 1
            names = " ".join(f"/g{code}" for code in range(last + 1))
            outlines = " ".join(f"/g{code} {each} 0 R" for code, each in enumerate(font.outlines))
            widths = " ".join(map(pdf.number, font.widths))
            meaning = self._write_stream(_meaning(font.texts), "")
            number = write(
                "<< /Type /Font /Subtype /Type3 /FontBBox [0 0 0 0] "
                f"/FontMatrix [{1 / _EM} 0 0 {1 / _EM} 0 0] /Resources << >> "
                f"/FirstChar 0 /LastChar {last} /Widths [{widths}] "
                f"/Encoding << /Type /Encoding /Differences [0 {names}] >> "
                f"/CharProcs << {outlines} >> /ToUnicode {meaning} 0 R >>"
            )
            yield f"T{index}", number

    def _code(self, letter: Letter) -> tuple[int, int]:
        """Return a letter's font and its code there; a new one is written."""
        key = letter.face, letter.text
        if key not in self._codes:
            if not self._fonts or len(self._fonts[-1].outlines) == _FULL:
                self._fonts.append(_Font())
            font = self._fonts[-1]
            self._codes[key] = len(self._fonts) - 1, len(font.outlines)
            font.outlines.append(self._write_stream(_outline(letter), ""))
            font.widths.append(letter.advance * _EM)
            font.texts.append(letter.text)
        return self._codes[key]


def _outline(letter: Letter) -> str:
    head = f"{pdf.number(letter.advance * _EM)} 0"
    if not len(letter.vertices):
        return f"{head} d0"
    vertices = letter.vertices * _EM
    bounds = " ".join(pdf.number(each) for each in (*vertices.min(axis=0), *vertices.max(axis=0)))
    return "\n".join([f"{head} {bounds} d1", *pdf.path(vertices, letter.codes), "f"])


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
