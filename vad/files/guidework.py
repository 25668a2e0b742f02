"""The guides of a file: each binds a point to a line.

In comes ``{ y = 330, name = "ram" }`` or ``{ along = "DC" }``, out goes a `Guide`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from vad.errors import InputError, shown, unknown
from vad.files.description import Cartesian, FrameLine, Guide, Link, LinkLine, SliderLine
from vad.files.expressions import Expression
from vad.files.linkwork import letters
from vad.files.parameters import Numbers

_WORDS = ("y", "x", "through", "angle", "along", "offset", "name", "under")
_KINDS = ({"y"}, {"x"}, {"through", "angle"}, {"along"}, {"along", "offset"})
_HINT = "a line is { y = 20 }, { x = 0 }, { through = 'O', angle = 30 } or { along = 'DC' }"
_ZERO = Expression.of("0", [])
_UPRIGHT = Expression.of("90", [])


def guides(
    numbers: Numbers, fixed: Mapping[str, object], links: Mapping[str, Link]
) -> dict[str, Guide]:
    """Read all guides, and name the slides that have no name.

    Raises
    ------
    vad.errors.InputError
        With its place, for one that is no line.
    """
    table = numbers.source.table("guides")
    lines, names = {}, {}
    under: dict[str, str] = {}
    for point, value in table.items():
        reader = _GuideReader(numbers, point, fixed, links, table)
        lines[point] = reader.line(value)
        name = value.get("name")
        if name is not None:
            reader.check_name(name)
            names[point] = name
        if "under" in value:
            under[point] = reader.under(value["under"], lines[point], under.values())
    usual = {
        point: "slider" if isinstance(line, FrameLine) else "block"
        for point, line in lines.items()
        if point not in names
    }
    for point, name in usual.items():
        others = [*usual.values(), *names.values(), *links]
        names[point] = f"{name}_{point.lower()}" if others.count(name) > 1 else name
    taken = dict.fromkeys(links, "a link")
    for point, name in names.items():
        if name in taken:
            message = f"{point}: {taken[name]} is called {name} already"
            raise numbers.source.error("guides", point, message, "give it a name")
        taken[name] = "a slide"
    return {
        point: Guide(point, line, names[point], under.get(point, ""))
        for point, line in lines.items()
    }


class _GuideReader:
    """The words of one guide."""

    def __init__(
        self,
        numbers: Numbers,
        point: str,
        fixed: Mapping[str, object],
        links: Mapping[str, Link],
        guided: Mapping[str, object],
    ) -> None:
        self.numbers = numbers
        self.point = point
        self.fixed = fixed
        self.links = links
        self.guided = guided
        if len(letters(point)) != 1:
            raise self.error("must be one point", "as in E = { y = 20 }")

    def error(self, message: str, hint: str | None = None) -> InputError:
        return self.numbers.source.error("guides", self.point, f"{self.point}: {message}", hint)

    def check_name(self, name: object) -> None:
        """Refuse a name of a slide that could be no option."""
        if not isinstance(name, str) or not (name.isidentifier() and name.isascii()):
            raise self.error(f"name: must be one word, got {shown(name)}", "as in name = 'ram'")

    def under(self, name: object, line: object, others: Iterable[str]) -> str:
        """Return the name of the point of a link that lies under the block."""
        if not isinstance(line, LinkLine):
            raise self.error("under: only a link has a point under the block")
        if not isinstance(name, str) or letters(name) != (name,):
            raise self.error(f"under: must be one point, got {shown(name)}", "as in under = 'Q'")
        linked = (point for link in self.links.values() for point in link.points)
        if name in {*self.fixed, *self.guided, *linked, *others}:
            raise self.error(f"under: there is a point {name} already")
        return name

    def line(self, value: Any) -> FrameLine | LinkLine | SliderLine:
        """Return the line that a guide is."""
        if not isinstance(value, Mapping):
            raise self.error(f"must be a line, got {shown(value)}", _HINT)
        for word in value:
            if word not in _WORDS:
                wrong = unknown("word", word, _WORDS)
                raise self.error(str(wrong), wrong.hint)
        words = set(value) - {"name", "under"}
        if words not in _KINDS:
            raise self.error("is no line" if words else "has no line", _HINT)
        if "y" in value:
            return FrameLine(Cartesian(_ZERO, self._coordinate("y", value["y"])), _ZERO)
        if "x" in value:
            return FrameLine(Cartesian(self._coordinate("x", value["x"]), _ZERO), _UPRIGHT)
        if "along" in value:
            return self._along(value["along"], value.get("offset"))
        angle = self._number("angle", value["angle"], "angle")
        through = value["through"]
        if isinstance(through, list | tuple):
            return FrameLine(self.numbers.place("guides", self.point, through), angle)
        if through in self.fixed:
            return FrameLine(str(through), angle)
        if through in self.guided and through != self.point:
            return SliderLine(str(through), angle)
        hint = "along = 'DC' is the slot of a link that turns"
        message = f"through: {shown(through)} is neither a fixed point nor one that slides"
        raise self.error(message, hint)

    def _along(self, value: object, offset: Any) -> FrameLine | LinkLine:
        pair = letters(value) if isinstance(value, str) else ()
        if len(pair) != 2 or pair[0] == pair[1]:
            message = f"along: must be two points of a link, got {shown(value)}"
            raise self.error(message, "as in { along = 'DC' }")
        aside = None if offset is None else self._number("offset", offset, "length")
        if all(point in self.fixed for point in pair):
            return FrameLine(pair[0], pair[1], aside)
        carriers = [each for each in self.links.values() if set(pair) <= set(each.points)]
        if not carriers:
            raise self.error(f"along: no link has both {pair[0]} and {pair[1]}")
        if len(carriers) > 1:
            raise self.error(f"along: {' and '.join(each.name for each in carriers)} have both")
        if carriers[0].cylinder:
            raise self.error(f"along: {carriers[0].name} is a cylinder, which has no slot")
        if self.point in carriers[0].points:
            raise self.error(f"along: {self.point} is a point of {carriers[0].name} itself")
        return LinkLine(carriers[0].name, (pair[0], pair[1]), aside)

    def _coordinate(self, axis: str, value: Any) -> Expression:
        help = f"{axis} of the line on which {self.point} slides"
        if not isinstance(value, bool) and isinstance(value, int | float) and value == 0:
            return _ZERO
        return self._take(f"{self.point}{axis}", value, "length", help)

    def _number(self, word: str, value: Any, quantity: str) -> Expression:
        if word == "offset" and value == 0:
            return _ZERO
        help = f"{word} of the line on which {self.point} slides"
        return self._take(f"{self.point}_{word}", value, quantity, help)

    def _take(self, name: str, value: Any, quantity: str, help: str) -> Expression:
        return self.numbers.take(
            "guides", self.point, name, value, quantity, signed=True, help=help
        )
