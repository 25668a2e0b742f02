"""Where several polygons of one panel stand: in lines, as they fill the panel best."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise

#: The lower left corner of what a polygon takes, and the upper right one.
Box = tuple[complex, complex]

#: The distance of two polygons, as a share of the larger side of all of them.
APART = 0.25
#: A small polygon takes at least so much of the longest side of all, for its labels.
LEAST = 0.2
#: The width of the room of polygons to its height, about that of one of three panels.
ROOM = 1.25
#: Of so many boxes all ways are tried.
MANY = 8
#: Further lines have to make polygons larger by this factor.
WORTH = 1.1


def in_lines(boxes: Sequence[Box]) -> list[list[Box]]:
    """Return boxes in lines, in their order, so that they can be drawn as large as possible.

    Examples
    --------
    Two flat boxes stand one below the other, two high ones side by side.

    >>> [len(line) for line in in_lines([(0j, 4 + 1j), (0j, 4 + 1j)])]
    [1, 1]
    >>> [len(line) for line in in_lines([(0j, 1 + 3j), (0j, 1 + 3j)])]
    [2]
    """
    if not boxes:
        return []
    least = LEAST * max(max(_width(box), _height(box)) for box in boxes)
    boxes = [_grown(box, least) for box in boxes]
    found = [boxes]
    least = _size(found)
    for lines in _splits(boxes):
        size = _size(lines)
        if size * WORTH < least:
            found, least = lines, size * (1.0 - 1e-9)
    return found


def in_groups(groups: Sequence[Sequence[Box]]) -> list[complex]:
    """Return by how much each box has to be moved where some belong together.

    The boxes of a group stand in lines of their own, and the groups as `in_lines` has them.

    Examples
    --------
    >>> in_groups([[(0j, 2 + 2j), (0j, 2 + 2j)], [(0j, 4 + 2j)]])
    [-1j, (3-1j), (0.5-4.25j)]
    """
    inner, outer = [], []
    for group in groups:
        lines = in_lines(group)
        moved = shifts(lines)
        boxes = [box for line in lines for box in line]
        ends = [end + shift for box, shift in zip(boxes, moved, strict=True) for end in box]
        across, up = [z.real for z in ends], [z.imag for z in ends]
        inner.append(moved)
        outer.append((complex(min(across), min(up)), complex(max(across), max(up))))
    places = zip(inner, shifts(in_lines(outer)), strict=True)
    return [shift + whole for moved, whole in places for shift in moved]


def _grown(box: Box, least: float) -> Box:
    """Return a box about the same middle whose sides have at least a length."""
    more = complex(max(least - _width(box), 0.0), max(least - _height(box), 0.0)) / 2
    return box[0] - more, box[1] + more


def _splits(boxes: Sequence[Box]) -> Iterator[list[list[Box]]]:
    """Yield boxes in lines: those with few lines first.

    Of many boxes each line has as many as the others: there are too many other ways.
    """
    if len(boxes) > MANY:
        for count in range(2, len(boxes) + 1):
            most = -(-len(boxes) // count)
            yield [list(boxes[a : a + most]) for a in range(0, len(boxes), most)]
        return
    for count in range(1, len(boxes)):
        for cuts in combinations(range(1, len(boxes)), count):
            ends = [0, *cuts, len(boxes)]
            yield [list(boxes[a:b]) for a, b in pairwise(ends)]


def _size(lines: Sequence[Sequence[Box]]) -> float:
    """Return how large a room lines of boxes need."""
    gap = _gap(lines)
    wide = max(sum(map(_width, line)) + gap * (len(line) - 1) for line in lines)
    high = sum(max(map(_height, line)) for line in lines) + gap * (len(lines) - 1)
    return max(wide / ROOM, high)


def _gap(lines: Sequence[Sequence[Box]]) -> float:
    """Return the distance of two boxes."""
    wide = max((sum(map(_width, line)) for line in lines), default=0.0)
    high = sum(max(map(_height, line), default=0.0) for line in lines)
    return APART * max(wide, high)


def shifts(lines: Sequence[Sequence[Box]]) -> list[complex]:
    """Return by how much each box has to be moved: line below line, from left to right.

    Every line stands in the middle.  The first one begins at the left of the y axis, and its middle
    lies on the x axis.

    Examples
    --------
    >>> shifts([[(0j, 2 + 2j), (0j, 2 + 2j)]])
    [-1j, (3-1j)]
    """
    gap, found = _gap(lines), []
    widths = [sum(map(_width, line)) + gap * (len(line) - 1) for line in lines]
    middle = 0.0
    for number, (line, width) in enumerate(zip(lines, widths, strict=True)):
        high = max(map(_height, line), default=0.0)
        if number:
            middle -= high / 2
        left = (max(widths) - width) / 2
        for box in line:
            low, up = box
            found.append(complex(left - low.real, middle - (low + up).imag / 2))
            left += _width(box) + gap
        middle -= high / 2 + gap
    return found


def _width(box: Box) -> float:
    return (box[1] - box[0]).real


def _height(box: Box) -> float:
    return (box[1] - box[0]).imag
