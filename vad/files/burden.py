"""What a file says of loads, masses, gravity and friction; each number becomes a parameter.

A load ``P = { at = "D", force = "1 kN", angle = 180 }`` has the parameters ``P`` and ``P_angle``, a
mass ``rocker = { mass = 2, inertia = 0.01 }`` has ``rocker_mass`` and ``rocker_inertia``, friction
``ram = 0.1`` has ``ram_friction``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from vad.errors import InputError, quoted, unknown
from vad.files.description import Expression, Values
from vad.files.tables import Numbers
from vad.statics.burden import Burden
from vad.statics.tables import checked_table, unit_of

_LOAD = ("at", "on", "force", "angle", "couple", "table", "unit")
_MASS = ("mass", "at", "inertia", "radius")
_AS_LOAD = 'as in P = { at = "D", force = 80, angle = 180 }, or M = { on = "crank", couple = 5 }'
_AS_MASS = 'as in rocker = { mass = 2, at = "G", inertia = 0.01 }'
#: What each number of a mass measures.
_QUANTITIES = {"mass": "mass", "inertia": "inertia", "radius": "length"}


@dataclass(frozen=True)
class BurdenEntry:
    """What a file says that the mechanism has to bear, before any number is known.

    Attributes
    ----------
    loads, masses, friction
        By name: words as they are, and numbers as expressions.
    gravity
        As it is written.
    """

    loads: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    masses: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    friction: Mapping[str, Expression] = field(default_factory=dict)
    gravity: Any = None

    def burden(self, values: Values) -> Burden:
        """Return it with the numbers of the parameters."""
        return Burden(
            tuple({"name": name, **_known(load, values)} for name, load in self.loads.items()),
            {body: _known(mass, values) for body, mass in self.masses.items()},
            self.gravity,
            {slide: number(values) for slide, number in self.friction.items()},
        )

    def parts(self, values: Values) -> dict[tuple[str, str], Burden]:
        """Return each entry alone, by its table and key."""
        whole = self.burden(values)
        return {
            **{("loads", load["name"]): Burden((load,)) for load in whole.loads},
            **{("masses", body): Burden((), {body: mass}) for body, mass in whole.masses.items()},
            **{
                ("friction", slide): Burden(friction={slide: number})
                for slide, number in whole.friction.items()
            },
            **({} if self.gravity is None else {("", "gravity"): Burden(gravity=self.gravity)}),
        }


def _known(given: Mapping[str, Any], values: Values) -> dict[str, Any]:
    return {
        word: value(values) if isinstance(value, Expression) else value
        for word, value in given.items()
    }


def read_burden(numbers: Numbers) -> BurdenEntry:
    """Read the tables of loads, masses and friction, and gravity.

    Raises
    ------
    vad.errors.InputError
        With its place, for what is no load, mass or coefficient.
    """
    source = numbers.source
    return BurdenEntry(
        {name: _load(numbers, name, each) for name, each in source.table("loads").items()},
        {body: _mass(numbers, body, each) for body, each in source.table("masses").items()},
        {
            slide: _positive(numbers, "friction", slide, f"{slide}_friction", each, "friction")
            for slide, each in source.table("friction").items()
        },
        source.table("").get("gravity"),
    )


def _load(numbers: Numbers, name: str, given: Any) -> dict[str, Any]:
    """Read one load."""
    _check(numbers, "loads", name, given, _LOAD, _AS_LOAD)
    sizes = [word for word in ("force", "couple", "table") if word in given]
    if len(sizes) != 1:
        message = f"{name}: must have a force, a couple or a table"
        raise numbers.source.error("loads", name, message, _AS_LOAD)
    found = {word: given[word] for word in ("at", "on") if word in given}
    kind = sizes[0]
    if kind == "table":
        with numbers.source.at("loads", name):
            quantity = "force" if "at" in given else "couple"
            factor = unit_of(f"{name}: unit", given["unit"], quantity) if "unit" in given else 1.0
            columns = given["table"]
            if not isinstance(columns, list | tuple) or len(columns) != 2:
                raise InputError(f"{name}: table: must be places and loads, or a file beside this")
            places, values = checked_table(f"{name}: table", *columns)
        found["table"] = places, tuple(factor * value for value in values)
    else:
        help = f"the {kind} {name}"
        found[kind] = numbers.take("loads", name, name, given[kind], kind, signed=True, help=help)
    if "angle" in given:
        help = f"direction of the force {name}"
        found["angle"] = numbers.take(
            "loads", name, f"{name}_angle", given["angle"], "direction", signed=True, help=help
        )
    return found


def _mass(numbers: Numbers, body: str, given: Any) -> dict[str, Any]:
    """Read one mass: a number, or a number with its point and moment of inertia."""
    if not isinstance(given, Mapping):
        given = {"mass": given}
    _check(numbers, "masses", body, given, _MASS, _AS_MASS)
    found = {"at": given["at"]} if "at" in given else {}
    for word, quantity in _QUANTITIES.items():
        if word in given:
            name = f"{body}_{word}"
            found[word] = _positive(numbers, "masses", body, name, given[word], quantity)
    return found


def _positive(
    numbers: Numbers, table: str, key: str, name: str, value: Any, quantity: str
) -> Expression:
    """Read a number that may be zero, but not negative."""
    help = f"{name.rpartition('_')[2]} of {key}"
    taken = numbers.take(table, key, name, value, quantity, signed=True, help=help)
    default = numbers.found[name].default if name in numbers.found else 0.0
    if default < 0.0:
        message = f"{name}: must not be negative, got {default:g}"
        raise numbers.source.error(table, key, message, f"try {-default:g}")
    return taken


def _check(
    numbers: Numbers, table: str, key: str, given: Any, words: tuple[str, ...], hint: str
) -> None:
    """Check that an entry has a name that can be one of parameters, and known words."""

    def error(message: str, hint: str | None) -> InputError:
        return numbers.source.error(table, key, f"{key}: {message}", hint)

    if not key.isidentifier():
        raise error("must be one word", hint)
    if not isinstance(given, Mapping):
        raise error(f"must be words and numbers, got {quoted(given)}", hint)
    for word in given:
        if word not in words:
            wrong = unknown("word", word, words)
            raise error(str(wrong), wrong.hint)
