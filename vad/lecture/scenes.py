"""The scenes of a lesson: in each one panel is large, because its strokes are drawn.

A panel whose strokes are told in two parts has two scenes.  A lesson with one panel has none.
"""

from __future__ import annotations

from vad.strokes.sheet import Sheet
from vad.strokes.telling import telling


def is_staged(sheet: Sheet) -> bool:
    """Tell whether a lesson has scenes: it has several panels, and strokes to draw in them."""
    return len(sheet.panels) > 1 and any(half.strokes for half in sheet.halves)


def scenes(sheet: Sheet) -> tuple[str, ...]:
    """Return the name of the panel that is large in each scene; none where there are no scenes.

    Examples
    --------
    >>> import vad
    >>> scenes(vad.draw(vad.solve(vad.FourBar())))
    ('position', 'velocity', 'acceleration')
    """
    numbers, columns = scene_numbers(sheet), [each.half.column for each in telling(sheet)]
    firsts = (numbers.index(number) for number in range(max(numbers, default=0) + 1))
    return tuple(columns[first] for first in firsts) if is_staged(sheet) else ()


def scene_numbers(sheet: Sheet) -> list[int]:
    """Return the scene of each stroke, in the order in which strokes are told."""
    staged = is_staged(sheet)
    found: list[int] = []
    before = ""
    for each in telling(sheet):
        column = each.half.column
        found.append(found[-1] + (staged and column != before) if found else 0)
        before = column
    return found
