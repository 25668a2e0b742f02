"""Closing a polygon of vectors: its known sum, and sides of which two numbers are unknown.

A side has a size and a direction.  What is unknown of all sides together is a size and the
direction of one side, two sizes, two directions, or a size and a direction.  These are the four
closures of a loop of a linkage, and the closed forms of the loops find them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from vad.errors import InputError
from vad.kinematics.closed_forms import AngleAndLength, TwoAngles
from vad.kinematics.numbers import EPSILON, bearing, cross, dot, over, times

#: Lines at a smaller sine than this count as parallel.
PARALLEL = 1e-12
#: A vector shorter than this share of the longest one is zero.
NOTHING = 1e-12


class Side(NamedTuple):
    """A side of a polygon of which something is unknown.

    Attributes
    ----------
    name
        What errors call it.
    size
        Its length, None where it is unknown; that of a couple is negative beyond its plane.
    way
        Its direction as a unit vector, None where it is unknown.
    """

    name: str
    size: float | None
    way: complex | None

    @property
    def unknowns(self) -> int:
        """How many of its two numbers are unknown."""
        return (self.size is None) + (self.way is None)


#: An answer: the vector of each side, in the order of the sides.
Answer = tuple[complex, ...]


def closed(known: complex, sides: Sequence[Side], unit: str) -> list[Answer]:
    """Return the answers that close a polygon: sides that add up to the opposite of a sum.

    Parameters
    ----------
    known
        The sum of all known vectors.
    sides
        One side without size and direction, or two sides with one unknown each.
    unit
        The unit of sizes, for errors.

    Returns
    -------
    list
        One answer or two.  In the first one the first side lies farther to the left of the closing
        line, which leads from the tip of the known vectors back to their tail.

    Raises
    ------
    vad.errors.InputError
        For lines that are parallel, and for sides that do not reach.

    Examples
    --------
    >>> closed(3 + 4j, [Side("X", None, None)], "kg·mm")
    [((-3-4j),)]
    >>> closed(6j, [Side("B", None, 1 + 0j), Side("C", None, -1j)], "kg·mm")
    [((-0+0j), -6j)]
    """
    gap = -known
    if len(sides) == 1:
        return [(gap,)]
    one, other = sides
    if one.way is not None and other.way is not None:
        return [_two_sizes(gap, one, other)]
    if one.way is None and other.way is None:
        answers = _two_ways(gap, one, other, unit)
    elif one.way is None:
        answers = [(first, second) for second, first in _size_and_way(gap, other, one, unit)]
    else:
        answers = _size_and_way(gap, one, other, unit)
    answers.sort(key=lambda answer: -cross(gap, answer[0]))
    return answers


def _two_sizes(gap: complex, one: Side, other: Side) -> Answer:
    """Return sides along two lines, which cross."""
    assert one.way is not None and other.way is not None
    sine = cross(one.way, other.way)
    if abs(sine) < PARALLEL:
        raise InputError(
            f"{one.name} and {other.name} lie along parallel lines, at {_degrees(one.way)}: "
            "they do not cross",
            "give one of them another angle",
        )
    return (
        cross(gap, other.way) / sine * one.way,
        cross(one.way, gap) / sine * other.way,
    )


def _two_ways(gap: complex, one: Side, other: Side, unit: str) -> list[Answer]:
    """Return sides of two sizes over the gap: a triangle on either side of it."""
    r, q = one.size, other.size
    assert r is not None and q is not None
    length = abs(gap)
    if length <= EPSILON * max(abs(r), abs(q)):
        raise InputError(
            f"{one.name} and {other.name}: all that is known adds up to zero, so that their angles "
            "are not determined",
            "give one of the angles",
        )
    slack = 8.0 * EPSILON * (abs(r) + abs(q) + length)
    if abs(abs(r) - abs(q)) - slack > length or length > abs(r) + abs(q) + slack:
        raise _open(one, other, f"a gap of {length:.6g} {unit}", unit)
    answers: list[Answer] = []
    for side in (1.0, -1.0):
        triangle = TwoAngles(side, None, None)
        first, second, _ = triangle.close(triangle.over_gap(gap, abs(r), abs(q)))
        answers.append((abs(r) * first, -abs(q) * second))
    return _different(answers)


def _size_and_way(gap: complex, line: Side, bar: Side, unit: str) -> list[Answer]:
    """Return a side along a line and one of a known size, which meet."""
    way, size = line.way, bar.size
    assert way is not None and size is not None
    far = abs(cross(way, gap))
    if far > abs(size) * (1.0 + 8.0 * EPSILON):
        raise _open(line, bar, f"the line of {line.name}, {far:.6g} {unit} away", unit)
    answers: list[Answer] = []
    for side in (1.0, -1.0):
        # The bar leads from a point of the line to the end of the gap.
        seen, along, _ = AngleAndLength(side, None, abs(size)).close(gap, way, None)
        answers.append((-along * way, abs(size) * times(seen, way)))
    return _different(answers)


def _different(answers: list[Answer]) -> list[Answer]:
    """Return two answers, or one where they are the same but for rounding."""
    one, other = answers
    longest = max(map(abs, one))
    apart = max(abs(a - b) for a, b in zip(one, other, strict=True))
    return answers if apart > PARALLEL * longest else answers[:1]


def _open(one: Side, other: Side, what: str, unit: str) -> InputError:
    sizes = " and ".join(
        f"{each.name} ({abs(each.size):.6g} {unit})" for each in (one, other) if each.size
    )
    reach = "do not reach over" if one.size and other.size else "does not reach"
    return InputError(
        f"the triangle does not close: {sizes} {reach} {what}", "make the smaller one larger"
    )


def _degrees(way: complex) -> str:
    return f"{bearing(way) % 360.0:.6g}°"


def along(vector: complex, way: complex) -> float:
    """Return the size of a vector along a unit vector, negative against it."""
    size: float = dot(vector, way)
    return size


def unit(vector: complex) -> complex:
    """Return the unit vector in the direction of a vector that is not zero."""
    way: complex = over(vector, abs(vector))
    return way
