"""The letters of a PDF file: each outline is written once, as a character of a Type 3 font.

In come lines of text, out go operators that show them; the text can be searched and copied.
"""

from __future__ import annotations

from vad.painting.pdf.objects import Objects
from vad.painting.pdf.operators import number, path
from vad.painting.stretches import stretches
from vad.plan.lettering.glyphs import Letter
from vad.plan.marks import Lettering

_EM = 1000  # units of a character's own space
_FULL = 256  # characters of one font


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
