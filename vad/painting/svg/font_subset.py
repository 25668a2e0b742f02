"""The part of a face that a file needs: in come letters, out go small fonts in a style sheet.

The faces are STIX, which matplotlib ships.  Their licence, the OFL, allows a part to be embedded
under another name; what tells of the licence stays in it.
"""

from __future__ import annotations

import io
from base64 import b64encode
from collections.abc import Iterable
from functools import lru_cache

from vad.plan.lettering.glyphs import font_file
from vad.plan.lettering.runs import Face

FAMILY = "vad"
#: What a style sheet says of each face.
FACES: dict[Face, str] = {
    "roman": "",
    "italic": "font-style:italic",
    "bold": "font-weight:bold",
    "bolditalic": "font-style:italic;font-weight:bold",
}
# Entries of a font's table of names: copyright, licence and its address; then what it is called.
_LEGAL = (0, 13, 14)
_FAMILY, _STYLE, _UNIQUE, _FULL, _POSTSCRIPT = 1, 2, 3, 4, 6
_NAMES = (_FAMILY, _UNIQUE, _FULL, _POSTSCRIPT)


class Faces:
    """The letters of one file, by their faces; a style sheet calls its fonts ``family``."""

    def __init__(self, family: str = FAMILY) -> None:
        self.family = family
        self._letters: dict[Face, set[str]] = {}

    def add(self, face: Face, letters: Iterable[str]) -> None:
        """Note down what is written in a face."""
        self._letters.setdefault(face, set()).update(letters)

    def rules(self) -> str:
        """Return the rules that bring the fonts."""
        return "".join(
            f"@font-face{{font-family:{self.family};{FACES[face] or 'font-style:normal'};"
            f"src:url({data_uri(face, letters)})}}\n"
            for face, letters in sorted(self._letters.items())
        )


def data_uri(face: Face, letters: Iterable[str]) -> str:
    """Return a font of ``letters`` as an address that holds it whole."""
    font = b64encode(_woff(face, "".join(sorted(letters)))).decode()
    return f"data:font/woff;base64,{font}"


@lru_cache(maxsize=16)
def _woff(face: Face, letters: str) -> bytes:
    from fontTools.subset import Options, Subsetter
    from fontTools.ttLib import TTFont

    options = Options(
        name_IDs=[*_LEGAL, *_NAMES, _STYLE],
        hinting=False,
        # The board measures without kerning and ligatures; FFTM holds dates.
        layout_features=[],
        drop_tables=[*Options().drop_tables, "FFTM", "GDEF", "GPOS", "GSUB", "kern"],
    )
    font = TTFont(font_file(face), recalcTimestamp=False)
    subsetter = Subsetter(options)
    subsetter.populate(text=letters)
    subsetter.subset(font)
    for record in font["name"].names:
        if record.nameID in _NAMES:
            record.string = FAMILY
    font.flavor = "woff"
    target = io.BytesIO()
    font.save(target)
    return target.getvalue()
