"""How SVG writes text: as text in embedded fonts, or as the shapes of its letters.

`SetText` is for pages and notebooks: text that can be selected, copied and searched, each stretch
at its place on the board, without the kerning of a browser.  `DrawnText` looks alike in every
program, with or without fonts: the outline of a letter is written once and used wherever it stands,
and over the shapes lie the same words as text that is not seen.  The fonts are STIX, which
matplotlib ships.  Their licence, the OFL, allows a part to be embedded under another name; what
tells of the licence stays in the first font of a file.
"""

from __future__ import annotations

import io
from base64 import b64encode
from collections.abc import Iterable, Sequence
from functools import lru_cache
from html import escape

from vad.painting.shapes import LetterStretch, stretches
from vad.painting.svg_elements import Classes, Grid, drawn, filled, named, number
from vad.plan.lettering.glyphs import CLOSE, LINE, MOVE, QUADRATIC, Letter, font_file, typeset
from vad.plan.lettering.runs import Face, plain
from vad.plan.marks import Lettering
from vad.style import Look

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
#: For programs that ignore the fonts of a file; STIX itself has the same widths.
_OTHERS = "STIXGeneral,serif"
#: Units of a glyph's own space, as in the font.
_EM = 1000
_UNSEEN = f"font:{_EM}px STIXGeneral,serif;fill-opacity:0;stroke:none"
_PREFIXES: dict[Face, str] = {"roman": "r", "italic": "i", "bold": "b", "bolditalic": "s"}
_COMMANDS = {MOVE: ("M", 1), LINE: ("l", 1), QUADRATIC: ("q", 2)}


class Faces:
    """The letters of one file, by their faces; a style sheet calls its fonts ``family``."""

    def __init__(self, family: str = FAMILY) -> None:
        self.family = family
        self._letters: dict[Face, set[str]] = {}

    def add(self, face: Face, letters: Iterable[str]) -> None:
        """Note down what is written in a face."""
        self._letters.setdefault(face, set()).update(letters)

    def rules(self) -> str:
        """Return the rules that bring the fonts; the first one tells of the licence of all."""
        return "".join(
            f"@font-face{{font-family:{self.family};{FACES[face] or 'font-style:normal'};"
            f"src:url({data_uri(face, letters, licensed=number == 0)})}}\n"
            for number, (face, letters) in enumerate(sorted(self._letters.items()))
        )


def data_uri(face: Face, letters: Iterable[str], *, licensed: bool = True) -> str:
    """Return a font of ``letters`` as an address that holds it whole, with its licence or not."""
    font = b64encode(_woff(face, "".join(sorted(letters)), licensed)).decode()
    return f"data:font/woff;base64,{font}"


@lru_cache(maxsize=16)
def _woff(face: Face, letters: str, licensed: bool) -> bytes:
    from fontTools.subset import Options, Subsetter
    from fontTools.ttLib import TTFont

    options = Options(
        name_IDs=[*(_LEGAL if licensed else ()), *_NAMES, _STYLE],
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


class SetText:
    """The text of one picture.

    ``faces`` collects the letters that its fonts need.  ``setting`` holds the attributes that all
    text needs and that no style sheet around the picture has.  It is empty in a page, which has
    such a style sheet: there a browser can paint the halo, the outline of a line in one face,
    before its letters.
    """

    def __init__(
        self, classes: Classes, faces: Faces | None = None, setting: str | None = None
    ) -> None:
        self._classes = classes
        self._faces = faces or Faces(classes.shared(FAMILY))
        family = f"font-family:{self._faces.family},{_OTHERS}"
        own = f"{family};font-kerning:none;white-space:pre"
        self._setting = own if setting is None else setting
        self._beneath: set[str] = set()

    def element(self, text: Lettering, look: Look, grid: Grid) -> str:
        """Return the element of a line of text."""
        line = stretches(text.runs)
        if not line:
            return ""
        whole = len(line) == 1 and line[0][0].size == 1.0
        halo = drawn(look.under, grid.unit)
        outlined = bool(halo) and whole and not self._setting
        name = self._classes.name(
            self._setting,
            f"font-size:{number(text.size * grid.unit)}px",
            *(_differences(line[0]) if whole else ()),
            filled(look),
            drawn(look.pen, grid.unit, look.alpha),
            f"{halo};paint-order:stroke" if outlined else "",
        )
        x, y = grid.at(text.at + text.size * line[0][0].at)
        words = self._words(line[0]) if whole else self._spans(line, text, grid)
        element = f'<text class="{name}" x="{x}" y="{y}">{words}</text>\n'
        return self._haloed(element, halo) if halo and not outlined else element

    def definitions(self) -> str:
        """Return nothing: letters are in the fonts."""
        return ""

    def rules(self) -> str:
        """Return the rules that bring the fonts."""
        return self._faces.rules()

    def _spans(self, line: Sequence[LetterStretch], text: Lettering, grid: Grid) -> str:
        """Return the stretches of a line, each where the board has it."""
        spans: list[str] = []
        level = grid.at(text.at + text.size * line[0][0].at)[1]
        for stretch in line:
            says = _differences(stretch)
            x, y = grid.at(text.at + text.size * stretch[0].at)
            name = f' class="{self._classes.name(*says)}"' if any(says) else ""
            # The first one stands where its line does.
            place = (f' x="{x}"' if spans else "") + (f' y="{y}"' if y != level else "")
            words = self._words(stretch)
            spans.append(f"<tspan{name}{place}>{words}</tspan>" if name or place else words)
            level = y
        return "".join(spans)

    def _words(self, stretch: LetterStretch) -> str:
        words = "".join(letter.text for letter in stretch)
        self._faces.add(stretch[0].face, words)
        return escape(words)

    def _haloed(self, element: str, halo: str) -> str:
        """Return a line of text on its halo.

        The halo lies beneath the whole line: painted with each stretch, it would cover the end of
        the one before.
        """
        home = self._classes.shared(named("t", element))
        use = f'<use href="#{home}" class="{self._classes.name(halo)}"/>\n'
        if home in self._beneath:
            return use + element
        self._beneath.add(home)
        return use + element.replace("<text", f'<text id="{home}"', 1)


def _differences(stretch: LetterStretch) -> tuple[str, str]:
    """Return how a stretch differs from its line."""
    small = f"font-size:{number(stretch[0].size)}em" if stretch[0].size != 1.0 else ""
    return FACES[stretch[0].face], small


class DrawnText:
    """The glyphs of one picture, which grow as letters are met."""

    def __init__(self, classes: Classes) -> None:
        self._classes = classes
        self._glyphs: dict[str, str] = {}

    def element(self, text: Lettering, look: Look, grid: Grid) -> str:
        """Return the element of a line of text."""
        letters = [each for each in typeset(text.runs).letters if len(each.vertices)]
        if not letters:
            return ""
        uses = "".join(map(self._use, letters))
        x, y = grid.at(text.at)
        em = text.size * grid.unit / _EM
        place = f'transform="translate({x} {y}) scale({number(em, 6)})"'
        words = self._words(text)
        name = self._classes.name(filled(look), drawn(look.pen, _EM / text.size, look.alpha))
        element = f'<g class="{name}" {place}>{uses}{words}</g>\n'
        if not look.under:
            return element
        halo = self._classes.name(drawn(look.under, _EM / text.size))
        return f'<g class="{halo}" {place}>{uses}</g>\n{element}'

    def definitions(self) -> str:
        """Return the glyphs."""
        glyphs = (f'<path id="{name}" d="{data}"/>\n' for name, data in self._glyphs.items())
        return f"<defs>\n{''.join(glyphs)}</defs>\n" if self._glyphs else ""

    def rules(self) -> str:
        """Return nothing: shapes need no fonts."""
        return ""

    def _words(self, text: Lettering) -> str:
        """Return the text that is selected, as wide as what is seen."""
        name = self._classes.name(_UNSEEN)
        words = plain(text.runs)
        wide = number(_EM * typeset(text.runs).advance, 0)
        length = f' textLength="{wide}"' if len(words) > 1 else ""
        return f'<text class="{name}"{length}>{escape(words)}</text>'

    def _use(self, letter: Letter) -> str:
        name = self._classes.shared(f"{_PREFIXES[letter.face]}{ord(letter.text):x}")
        if name not in self._glyphs:
            self._glyphs[name] = _data(letter)
        x, y = number(_EM * letter.at.real, 0), number(-_EM * letter.at.imag, 0)
        if letter.size != 1.0:
            small = f"translate({x} {y}) scale({number(letter.size)})"
            return f'<use href="#{name}" transform="{small}"/>'
        return f'<use href="#{name}"' + (f' x="{x}"' if x != "0" else "") + "/>"


def _data(letter: Letter) -> str:
    """Return the outline of a letter as the data of a path, as short as SVG allows."""
    points = [(round(_EM * x), -round(_EM * y)) for x, y in letter.vertices.tolist()]
    kinds = letter.codes.tolist()
    data, before, place, start = "", "", 0, (0, 0)
    # Each round goes on by a point or more.
    while place < len(kinds):
        if kinds[place] == MOVE:
            start = points[place]
        if kinds[place] == LINE and kinds[place + 1] == CLOSE and points[place] == start:
            place += 1  # the line that closes a ring is in the command that does
        if kinds[place] == CLOSE:
            data, before, place = data + "z", "z", place + 1
            continue
        command, count = _COMMANDS[kinds[place]]
        u, v = (0, 0) if command == "M" else points[place - 1]
        ways = [way for x, y in points[place : place + count] for way in (x - u, y - v)]
        if command == "l" and 0 in ways:  # a level or an upright line
            command, ways = ("v", ways[1:]) if not ways[0] else ("h", ways[:1])
        data += (" " if command == before else command) + " ".join(map(str, ways))
        before, place = command, place + count
    return data.replace(" -", "-")
