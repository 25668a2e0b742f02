"""The links of a file: pairs of letters and their distances become a base and rules.

The table ``{ BC = 120, BE = 180, CBE = 30 }`` becomes a `LinkEntry`.  The values of lengths are not
checked here.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from vad.errors import InputError, quoted
from vad.files.description import Apex, Aside, Beyond, Expression, FromPose, LinkEntry, Pair, Rule
from vad.files.tables import Numbers

_POINT = r"[A-Z][0-9]*"
Angle = tuple[str, str, str]
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
VARIABLE = "variable"


def letters(text: str) -> tuple[str, ...]:
    """Return the points that are named one behind the other; none if it is no such name.

    Examples
    --------
    >>> letters("O2A"), letters("CBE"), letters("sense")
    (('O2', 'A'), ('C', 'B', 'E'), ())
    """
    return tuple(re.findall(_POINT, text)) if re.fullmatch(f"(?:{_POINT})+", text) else ()


def link(numbers: Numbers, name: str, value: Any) -> LinkEntry:
    """Read one link.

    Raises
    ------
    vad.errors.InputError
        With its place, if it cannot be a link.
    """
    reader = _LinkReader(numbers, name)
    if not _NAME.fullmatch(name):
        raise reader.error("must be one word", "as in feed_rod")
    if isinstance(value, str):
        return reader.posed(value)
    if isinstance(value, Mapping) and value:
        return reader.measured(value)
    named = f"{{ {name} = 60 }}, where crank is its name" if letters(name) else "{ AB = 60 }"
    hint = f"as in {'crank' if letters(name) else name} = {named}"
    raise reader.error(f"must be distances of its points, got {quoted(value)}", hint)


class _LinkReader:
    """Reads the words of one link."""

    def __init__(self, numbers: Numbers, name: str) -> None:
        self.numbers = numbers
        self.name = name

    def error(self, message: str, hint: str | None = None) -> InputError:
        return self.numbers.source.error("links", self.name, f"{self.name}: {message}", hint)

    def posed(self, text: str) -> LinkEntry:
        """Return a link that takes its shape from the pose."""
        points = letters(text)
        if len(points) < 2 or len(set(points)) < len(points):
            raise self.error(f"must name two points or more, got {quoted(text)}", "as in 'CDE'")
        rules = {point: FromPose(point) for point in points[2:]}
        return LinkEntry(self.name, (points[0], points[1]), None, rules)

    def measured(self, value: Mapping[str, Any]) -> LinkEntry:
        """Return a link that is written with its distances."""
        pairs: dict[Pair, Any] = {}
        angles: dict[Angle, Any] = {}
        side, rod = 1, ""
        for key, number in value.items():
            self.numbers.source.check_name("links", self.name, key)
            points = letters(key)
            if key == "sense":
                side = self._side(number)
            elif key == "rod":
                rod = self._rod(number)
            elif len(points) not in (2, 3) or len(set(points)) < len(points):
                hint = "two letters are a distance, three an angle"
                raise self.error(f"cannot read {quoted(key)}", hint)
            elif len(points) == 3:
                angles[points[0], points[1], points[2]] = number
            elif (points[1], points[0]) in pairs:
                raise self.error(f"{key} is {points[1]}{points[0]}, which is given already")
            else:
                pairs[points[0], points[1]] = number
        if not pairs:
            raise self.error("needs a distance", "as in { AB = 60 }")
        base = next(iter(pairs))
        if pairs[base] == VARIABLE:
            if len(pairs) + len(angles) > 1:
                raise self.error("a cylinder has two points", "fix the others to its neighbours")
            return LinkEntry(self.name, base, None, {}, cylinder=True, rod=rod)
        if rod:
            raise self.error("rod: only a cylinder has one", f"{''.join(base)} = 'variable'")
        alone = len(pairs) == 1
        sizes = {pair: self._length(pair, number, alone) for pair, number in pairs.items()}
        return LinkEntry(self.name, base, sizes.pop(base), self._rules(base, sizes, angles, side))

    def _side(self, word: object) -> int:
        if word not in ("clockwise", "counter-clockwise"):
            hint = "write 'clockwise' or 'counter-clockwise'"
            raise self.error(f"sense: cannot read {quoted(word)}", hint)
        return -1 if word == "clockwise" else 1

    def _rod(self, name: object) -> str:
        if not isinstance(name, str) or not _NAME.fullmatch(name):
            raise self.error(f"rod: must be one word, got {quoted(name)}", "as in rod = 'piston'")
        self.numbers.source.check_name("links", self.name, name)
        others = self.numbers.source.table("links")
        if name in others:
            raise self.error(f"rod: a link is called {name} already")
        return name

    def _length(self, pair: Pair, value: Any, alone: bool) -> Expression:
        if value == VARIABLE:
            raise self.error(f"{''.join(pair)}: only a cylinder's one length varies")
        name = self.name if alone else "".join(pair)
        help = f"length of {''.join(pair)}" if alone else f"distance {''.join(pair)} on {self.name}"
        return self.numbers.take("links", self.name, name, value, "length", help=help)

    def _rules(
        self,
        base: Pair,
        sizes: dict[Pair, Expression],
        angles: dict[Angle, Any],
        side: int,
    ) -> dict[str, Rule]:
        """Return the rules of further points; each rule needs only points before it."""
        known, rules = list(base), dict[str, Rule]()
        # Each round takes a distance or more.
        while sizes:
            point = self._next(known, sizes, angles)
            own = {pair: sizes.pop(pair) for pair in _leading_to(point, known, sizes)}
            turned = _turning(point, known, angles)
            if len(own) > 2 or (turned and len(own) > 1) or len(turned) > 1:
                raise self.error(f"{point} is fixed twice")
            if turned:
                angle = turned[0]
                rules[point] = self._aside(point, next(iter(own.items())), angle, angles.pop(angle))
            elif len(own) == 2:
                (first, a), (second, b) = sorted(
                    own.items(), key=lambda each: known.index(_other(each[0], point))
                )
                rules[point] = Apex(_other(first, point), _other(second, point), a, b, side)
            else:
                ((start, end), length), *_ = own.items()
                beyond = point == end
                rules[point] = Beyond(start if beyond else end, length, 1 if beyond else -1)
            known.append(point)
        for angle in angles:
            text = "".join(angle)
            hint = f"add {angle[1]}{angle[2]} = 100"
            raise self.error(f"{text}: no distance leads to {angle[2]}", hint)
        return rules

    def _next(
        self, known: Sequence[str], sizes: Mapping[Pair, Any], angles: Mapping[Angle, Any]
    ) -> str:
        """Return a point that can be located, best one with all its distances from known points."""
        new = [p for pair in sizes for p in pair if p not in known and _other(pair, p) in known]
        if not new:
            pair = next(iter(sizes))
            if all(point in known for point in pair):
                raise self.error(f"{''.join(pair)} is fixed already by the other distances")
            raise self.error(f"{''.join(pair)} does not lead to another point of the link")
        for point in new:
            here = _leading_to(point, known, sizes)
            whole = len(here) == sum(point in pair for pair in sizes)
            if whole or len(here) > 1 or _turning(point, known, angles):
                return point
        return new[0]

    def _aside(self, point: str, own: tuple[Pair, Expression], angle: Angle, value: Any) -> Aside:
        pair, length = own
        text = "".join(angle)
        start, other = angle[1], angle[0] if point == angle[2] else angle[2]
        if _other(pair, point) != start:
            hint = f"give {start}{point}"
            raise self.error(f"{text}: the distance of {point} from {start} is missing", hint)
        turn = self.numbers.take(
            "links", self.name, text, value, "angle", signed=True, help=f"angle {text}"
        )
        return Aside(start, other, length, turn, 1 if point == angle[2] else -1)


def _leading_to(point: str, known: Sequence[str], sizes: Mapping[Pair, Any]) -> list[Pair]:
    """Return the pairs of a point with known points."""
    return [pair for pair in sizes if point in pair and _other(pair, point) in known]


def _turning(point: str, known: Sequence[str], angles: Mapping[Angle, Any]) -> list[Angle]:
    """Return the angles that locate a point from known points."""
    ends = [angle for angle in angles if point in (angle[0], angle[2])]
    return [angle for angle in ends if {*angle} - {point} <= set(known)]


def _other(pair: Pair, point: str) -> str:
    return pair[1] if pair[0] == point else pair[0]
