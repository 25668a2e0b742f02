"""SVG: shapes become elements that other programs open, search and restyle.

Marks come group by group and become one ``<svg>`` element.  Every stroke is a ``<g>`` with its
name, and its caption as a title.
"""

from __future__ import annotations

from html import escape
from typing import Literal

from vad.errors import one_of
from vad.painting.svg_elements import Classes, Elements, Grid, number
from vad.painting.svg_text import DrawnText, SetText
from vad.plan.format import Format
from vad.plan.items import Item
from vad.plan.marks import Mark
from vad.strokes.description import describe, title
from vad.strokes.sheet import Sheet
from vad.style import Look

#: How text is written: as the shapes of its glyphs, or as letters in an embedded font.
TextForm = Literal["glyphs", "letters"]
#: How many times its width a corner may stick out: as in Agg and in PDF.
_MITRE = 10
_TEXTS: dict[str, type[DrawnText | SetText]] = {"glyphs": DrawnText, "letters": SetText}


class SvgPainter:
    """A painter of one picture.

    Parameters
    ----------
    sheet
        What the picture shows, for its words.
    text
        ``"glyphs"`` for a file that looks alike in every program, ``"letters"`` for one whose text
        other programs restyle.  Either way it can be selected and searched.
    description
        What the picture shows, where it is more than the sheet.
    scope
        The id of the picture where it stands among others on a page, none of which it disturbs.

    Attributes
    ----------
    svg
        The picture, once it is ended.

    Raises
    ------
    vad.errors.UsageError
        For an unknown kind of text.
    """

    def __init__(
        self,
        sheet: Sheet,
        text: TextForm = "glyphs",
        description: str | None = None,
        scope: str = "",
    ) -> None:
        self._sheet = sheet
        self._description = describe(sheet) if description is None else description
        self._captions = {
            panel.full(stroke.name): stroke.caption
            for panel in sheet.halves
            for stroke in panel.strokes
        }
        #: The region of each stroke's panel.
        self._homes = {
            panel.full(stroke.name): panel.column
            for panel in sheet.halves
            for stroke in (*panel.strokes, *panel.zeros)
        }
        self._classes = Classes(scope)
        self._text = _TEXTS[one_of("text", text, _TEXTS)](self._classes)
        self._elements: list[str] = []
        self._begun: set[str] = set()
        self._others: dict[str, int] = {}
        self._open = False
        self.svg = ""

    def begin(self, form: Format, background: str) -> None:
        """Begin the picture with its ground."""
        self._grid = Grid(form)
        self._shapes = Elements(self._grid, self._classes, self._text)
        self._elements.append(f'<rect width="100%" height="100%" fill="{background}"/>\n')

    def group(self, item: Item) -> None:
        """Begin a ``<g>`` for an item of a stroke; the page's own stand between them."""
        self._close()
        if not item.stroke:
            return
        self._open = True
        home = self._homes.get(item.stroke)
        first = item.region == home and item.stroke not in self._begun
        if first:
            self._begun.add(item.stroke)
        name = escape(item.stroke)
        self._elements.append(f'<g id="{self._unique(name, first)}" data-stroke="{name}">\n')
        if first and item.stroke in self._captions:
            self._elements.append(f"<title>{escape(self._captions[item.stroke])}</title>\n")

    def paint(self, mark: Mark, look: Look) -> None:
        """Paint one mark."""
        self._elements.append(self._shapes.of(mark.shape, look))

    def end(self) -> None:
        """End the picture."""
        self._close()
        width, height = number(self._grid.width), number(self._grid.height)
        size = f'width="{width}" height="{height}"'
        if self._classes.scope:  # it must fit in the cell of a notebook, even as an image
            fits = f'style="width:100%;max-width:{width}px;height:auto"'
            size = f'id="{self._classes.scope}" {fits}'
        self.svg = (
            f'<svg xmlns="http://www.w3.org/2000/svg" {size} '
            f'viewBox="0 0 {width} {height}" role="img" lang="{self._sheet.language}" '
            f'fill="none" stroke-miterlimit="{_MITRE}" xml:space="preserve">\n'
            f"<title>{escape(title(self._sheet))}</title>\n"
            f"<desc>{escape(self._description)}</desc>\n"
            f"<style>\n{self._text.rules()}{self._classes.sheet()}</style>\n"
            f"{self._text.definitions()}{''.join(self._elements)}</svg>\n"
        )

    def _unique(self, name: str, first: bool) -> str:
        """Return an id: the name for the first group in the stroke's panel, numbers for others."""
        name = self._classes.shared(name.replace(":", "-"))  # a colon is for namespaces
        if first:
            return name
        self._others[name] = self._others.get(name, 1) + 1
        return f"{name}-{self._others[name]}"

    def _close(self) -> None:
        if self._open:
            self._elements.append("</g>\n")
        self._open = False
