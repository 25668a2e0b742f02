"""What stands back in a film while a vector flies: the links that it does not come from.

They are pale in the panel that it leaves, from the beginning of the flight to its end.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from vad.plan.items import FLIGHT, Item
from vad.plan.sketch import Sketch
from vad.strokes.travel import Travel

#: How much ink links have that are not concerned; the same on a page (``.pale`` in its styles).
PALE = 0.33


@dataclass(frozen=True, slots=True)
class Dimming:
    """What is pale while something flies.

    Attributes
    ----------
    region
        That of the panel that it leaves.
    row
        That of its own link, which keeps its ink; marks without a row are those of the frame, and
        keep it, too.
    """

    region: str
    row: int | None
    _known: dict[Item, Item] = field(default_factory=dict, repr=False, compare=False)

    def __call__(self, items: Iterable[Item]) -> list[Item]:
        """Return items as they look meanwhile: the same ones each time they are asked for."""
        found = [*items]
        for number, item in enumerate(found):
            if item.region == self.region:
                if item not in self._known:
                    self._known[item] = self._pale(item)
                found[number] = self._known[item]
        return found

    def _pale(self, item: Item) -> Item:
        marks = tuple(
            mark if mark.row in (None, self.row) else replace(mark, alpha=PALE * mark.alpha)
            for mark in item.marks
        )
        return item if marks == item.marks else replace(item, marks=marks)


def dimmings(
    items: Sequence[Item], sketches: Mapping[str, Sketch], travels: Mapping[str, Travel] | None
) -> dict[int, Dimming]:
    """Return what is pale, by the beats in which something flies to another panel.

    Parameters
    ----------
    items
        Those of all panels, with the flights.
    sketches
        The panels.
    travels
        What flies from where, by the full names of the strokes that draw it; None where nothing
        does.
    """
    found: dict[int, Dimming] = {}
    for item in items:
        travel = travels.get(item.stroke) if travels and item.region == FLIGHT else None
        if travel:
            goal = sketches[item.stroke.partition(":")[0]].setting.panel.column
            home = sketches[travel.source].setting.panel.column
            if home != goal:
                found[item.since] = Dimming(home, item.marks[-1].row)
    return found
