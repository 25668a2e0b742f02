"""Text as text: set in the board's own faces, of which the file holds the letters that it needs.

It can be selected, copied and searched: for pages and notebooks.  Every stretch stands where the
board has it, whatever a browser thinks of kerning.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from vad.painting.stretches import Stretch, stretches
from vad.painting.svg.classes import Classes, drawn, filled, named
from vad.painting.svg.font_subset import FACES, FAMILY, Faces
from vad.painting.svg.grid import Grid, number
from vad.plan.marks import Lettering
from vad.style import Look

#: For programs that ignore the fonts of a file; STIX itself has the same widths.
_OTHERS = "STIXGeneral,serif"


class SetText:
    """The text of one picture.

    ``faces`` collects the letters that its fonts need; ``setting`` is what no style sheet around it
    says of all text.  Where there is nothing to say it stands in a page: every browser can paint
    the outline of a line of one face before its letters, which is their halo.
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
            *(_says(line[0]) if whole else ()),
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

    def _spans(self, line: Sequence[Stretch], text: Lettering, grid: Grid) -> str:
        """Return the stretches of a line, each where the board has it."""
        spans: list[str] = []
        level = grid.at(text.at + text.size * line[0][0].at)[1]
        for stretch in line:
            says = _says(stretch)
            x, y = grid.at(text.at + text.size * stretch[0].at)
            name = f' class="{self._classes.name(*says)}"' if any(says) else ""
            # The first one stands where its line does.
            place = (f' x="{x}"' if spans else "") + (f' y="{y}"' if y != level else "")
            spans.append(f"<tspan{name}{place}>{self._words(stretch)}</tspan>")
            level = y
        return "".join(spans)

    def _words(self, stretch: Stretch) -> str:
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


def _says(stretch: Stretch) -> tuple[str, str]:
    """Return how a stretch differs from its line."""
    small = f"font-size:{number(stretch[0].size)}em" if stretch[0].size != 1.0 else ""
    return FACES[stretch[0].face], small
