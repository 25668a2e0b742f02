"""Text as shapes: the outline of a letter is written once, and used wherever it stands.

Every program shows it alike, with or without fonts.  Over the shapes lie the same words as text
that is not seen: it can be selected, copied and searched.
"""

from __future__ import annotations

from html import escape

from vad.painting.svg.classes import Classes, drawn, filled
from vad.painting.svg.grid import Grid, number
from vad.plan.lettering.glyphs import CLOSE, LINE, MOVE, QUADRATIC, Letter, typeset
from vad.plan.lettering.runs import Face, plain
from vad.plan.marks import Lettering
from vad.style import Look

#: Units of a glyph's own space, as in the font.
_EM = 1000
_UNSEEN = f"font:{_EM}px STIXGeneral,serif;fill-opacity:0;stroke:none"
_PREFIXES: dict[Face, str] = {"roman": "r", "italic": "i", "bold": "b", "bolditalic": "s"}
_COMMANDS = {MOVE: ("M", 1), LINE: ("l", 1), QUADRATIC: ("q", 2)}


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
    """Return the outline of a letter as the data of a path, without what goes without saying."""
    points = [(round(_EM * x), -round(_EM * y)) for x, y in letter.vertices.tolist()]
    kinds = letter.codes.tolist()
    data, before, place, start = "", "", 0, (0, 0)
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
        data += (" " if command == before else command) + " ".join(map(str, ways))
        before, place = command, place + count
    return data.replace(" -", "-")
