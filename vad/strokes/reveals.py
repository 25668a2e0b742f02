"""Which results a stroke measures: those of its own panel, and what it finds of another one."""

from __future__ import annotations

from vad.strokes.sheet import Panel, Row, Sheet, Stroke

_OF = ":"


def elsewhere(panel: str, row: str) -> str:
    """Return how a stroke of another panel names a row whose cells it measures in ``panel``."""
    return f"{panel}{_OF}{row}"


def revealed(panel: Panel, stroke: Stroke) -> list[tuple[str, str]]:
    """Return what a stroke of a panel measures: names of panels, and of rows in them."""
    found = []
    for key in stroke.reveals:
        other, sign, row = key.partition(_OF)
        found.append((other, row) if sign else (panel.name, key))
    return found


def finder(sheet: Sheet, panel: Panel, row: str | None) -> tuple[Panel, Stroke] | None:
    """Return the stroke of another panel that finds a row in ``panel``, and its panel, if any."""
    for half in sheet.halves:
        for stroke in half.strokes:
            if half.name != panel.name and (panel.name, row) in revealed(half, stroke):
                return half, stroke
    return None


def measurer(sheet: Sheet, panel: Panel, row: Row) -> tuple[Panel, Stroke] | None:
    """Return the stroke that measures the cells of a row in a panel, and its panel.

    It is that of another panel where one finds the row, else the first one of the panel itself.  A
    cylinder that swings has two rows, one of its turning and one of its sliding: the second one is
    measured by the second stroke.
    """
    found = finder(sheet, panel, row.key)
    own = [(panel, stroke) for stroke in panel.strokes if row.key in stroke.reveals]
    if found or not own:
        return found
    alike = [each for each in sheet.rows if each.key == row.key]
    place = next((number for number, each in enumerate(alike) if each is row), 0)
    return own[min(place, len(own) - 1)]
