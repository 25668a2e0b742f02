"""The drawings of a page: in comes a plan, out go its panels as SVG, and how their strokes grow.

A group bears the beats between which it shows, ``data-s`` and ``data-u``.  What grows has an empty
group in its place of the painting order, which the player fills while the stroke is drawn.
"""

from __future__ import annotations

from vad.page.samples import Sampler, Segment
from vad.page.themed import Inks, Themed
from vad.painting.svg.classes import Classes
from vad.painting.svg.elements import Elements
from vad.painting.svg.font_subset import Faces
from vad.painting.svg.grid import Grid, number
from vad.painting.svg.set_text import SetText
from vad.plan.board import Plan
from vad.plan.format import Format
from vad.plan.geometry import Rect
from vad.plan.items import FOREVER
from vad.plan.marks import Mark


class Inker:
    """Draws the panels of one page.

    Attributes
    ----------
    classes
        The looks that have been met.
    style
        What names their colours.
    growths
        Of everything that grows its beat, and how it comes about.
    """

    def __init__(self, form: Format, style: Themed, faces: Faces) -> None:
        self.classes = Classes()
        self.growths: list[tuple[int, list[Segment]]] = []
        self.style = style
        self._grid, self._inks = Grid(form), Inks(style)
        self._elements = Elements(self._grid, self.classes, SetText(self.classes, faces))
        self._sampler = Sampler(self._grid, self._elements, self._inks)

    def drawing(self, plan: Plan, panel: str) -> str:
        """Return the groups of a panel, in painting order."""
        groups: list[tuple[str, str]] = []
        for item in plan.items:
            if item.region != panel:
                continue
            since, home = item.since, ""
            if item.grows:
                home = f' data-g="{len(self.growths)}"'
                self.growths.append((item.since, self._sampler.segments(item)))
                groups.append((when(since, since + 1, plan.finished) + home, ""))
                since += 1
            if since < item.until:
                beats = when(since, item.until, plan.finished)
                if groups and groups[-1][0] == beats:
                    beats, before = groups.pop()
                    groups.append((beats, before + self.marks(item.marks)))
                else:
                    groups.append((beats, self.marks(item.marks)))
        return "".join(f"<g{beats}>{marks}</g>" for beats, marks in groups)

    def marks(self, marks: tuple[Mark, ...]) -> str:
        """Return marks as elements."""
        return "".join(self._elements.of(each.shape, self._inks(each)) for each in marks)

    def view(self, area: Rect) -> str:
        """Return the view of an area of the page."""
        corner, unit = self._grid.at(complex(area.left, area.top)), self._grid.unit
        return " ".join((*corner, number(area.width * unit), number(area.height * unit)))


def when(since: int, until: int, finished: int) -> str:
    """Return the attributes of what shows between two beats, and is off where it does not last."""
    says = f' data-s="{since}"' if since else ""
    says += f' data-u="{until}"' if until != FOREVER else ""
    return says + ("" if since <= finished < until else ' class="off"')
