"""Options made from a mechanism's own fields: in comes its class, out come click's parameters.

A value that is not given is not passed on, so that every default stands in one place only: the
mechanism's file.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Mapping
from typing import Any, cast

import click
from click.shell_completion import CompletionItem

from vad.cli import completion, values
from vad.export import OwnOption
from vad.files.places import WORDS
from vad.found import all_names
from vad.mechanisms import Mechanism
from vad.mechanisms.mechanism import NUMBERS
from vad.units import LENGTH_UNITS, scene_unit
from vad.written import typed

#: What no parameter may be called as an option; every verb adds its own options.
OWN = {"help", "from", "to", "start", "stop", "point"}
_INPUT_HELP = {
    "angle": "angle of the driven link",
    "omega": "its angular velocity",
    "alpha": "its angular acceleration",
    "position": "position of the driven slide",
    "velocity": "its velocity",
    "acceleration": "its acceleration",
}


def mechanism_options(kind: type[Mechanism], ranged: bool = False) -> list[click.Parameter]:
    """Return the options that set a mechanism's parameters and its input.

    Parameters
    ----------
    kind
        The mechanism's class.
    ranged
        Whether the driven link or slide runs ``--from`` one place ``--to`` another instead of
        standing at one.
    """
    fields = dataclasses.fields(kind)
    numbers = [field for field in fields if field.metadata["quantity"] in NUMBERS]
    others = [field for field in fields if field not in numbers]
    unit = length_unit_of(kind)
    place, *rates = kind.inputs
    if ranged:
        ends = ("0 deg", "360 deg") if place == "angle" else ("where it closes",) * 2
        names = (["--from", "start"], ["--to", "stop"])
        driven = [
            _quantity_option(name, place, f"{which} {place} of the driver  [{end}]", unit)
            for name, which, end in zip(names, ("first", "last"), ends, strict=True)
        ]
    else:
        driven = [_input_option(kind, place, unit)]
    return [
        *(_field_option(field, unit) for field in numbers),
        *driven,
        *(_input_option(kind, name, unit) for name in rates),
        *(_field_option(field, unit) for field in others),
    ]


def build(
    kind: type[Mechanism], given: Mapping[str, Any]
) -> tuple[Mechanism, dict[str, float], dict[str, Any]]:
    """Return the mechanism and the inputs that ``given`` describes, and what else was given."""
    names = {option_name(field.name): field.name for field in dataclasses.fields(kind)}
    rest = {name: value for name, value in given.items() if value not in (None, ())}
    parameters = {names[name]: rest.pop(name) for name in list(rest) if name in names}
    inputs = {name: rest.pop(name) for name in list(rest) if name in kind.inputs}
    return kind(**parameters), inputs, rest


def length_unit_of(kind: type[Mechanism]) -> str:
    """Return the unit in which a mechanism's default lengths are."""
    fields = {field.name: field for field in dataclasses.fields(kind)}
    return str(fields["length_unit"].default)


def option_name(name: str) -> str:
    """Return the name under which a parameter is an option: never that of one of the verbs' own.

    Examples
    --------
    >>> option_name("crank"), option_name("speed")
    ('crank', 'speed_1')
    """
    return f"{name}_1" if name in OWN else name


def flag(name: str) -> str:
    """Return the option's name for a parameter's.

    Examples
    --------
    >>> flag("ground_angle")
    '--ground-angle'
    """
    return "--" + name.replace("_", "-")


class NamedOption(click.Option):
    """An option that takes one of a few names; its help lists them.

    With a ``group`` of entry points, other packages may bring further names.
    """

    def __init__(
        self, name: str, what: str, names: Collection[str], text: str, group: str = ""
    ) -> None:
        super().__init__([flag(name), name], callback=values.one_of(what, names, group), help=text)
        self._own, self._group = names, group

    @property
    def names(self) -> Collection[str]:
        """Return all names that there are."""
        return all_names(self._own, self._group) if self._group else self._own

    def make_metavar(self, ctx: click.Context | None = None) -> str:
        """Return the names as the help shows them."""
        return "|".join(self.names)

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Return the names that begin so."""
        return completion.one_of(self.names)(ctx, self, incomplete)


def own_option(option: OwnOption) -> click.Option:
    """Return the option that a format has of its own."""
    if option.type is bool:
        return click.Option([flag(option.name), option.name], is_flag=True, help=option.help)
    text = option.help if option.default is None else f"{option.help}  [{option.default}]"
    return click.Option([flag(option.name), option.name], type=option.type, help=text)


def _field_option(field: dataclasses.Field[Any], unit: str) -> click.Option:
    """Return the option that sets one field of a mechanism."""
    name, default = option_name(field.name), cast(Any, field.default)
    quantity, text = field.metadata["quantity"], field.metadata["help"]
    if quantity == "places":
        own = cast(Any, field.default_factory)()
        shown = ", ".join(f"{point}={place}" for point, place in own.items())
        return click.Option(
            [flag(name), name],
            callback=values.places_of_points(),
            multiple=True,
            metavar="POINT=PLACE",
            help=f"{text}: {', '.join(WORDS)}  [{shown or 'one place'}]",
        )
    if quantity == "choice":
        return NamedOption(name, name, field.metadata["choices"], f"{text}  [{default}]")
    if quantity == "unit":
        # Read before all others, because lengths are converted to it.
        return click.Option(
            [flag(name), name],
            callback=values.length_unit(),
            shell_complete=completion.one_of(LENGTH_UNITS),
            is_eager=True,
            metavar="UNIT",
            help=f"{text}  [{default}]",
        )
    if quantity == "points":
        return click.Option(
            ["--point", name],
            callback=values.points(unit),
            multiple=True,
            metavar="'NAME on LINK DISTANCE at ANGLE'",
            help=f"{text}; may be given again  [none]",
        )
    shown = "none"
    if default is not None:
        shown = f"{typed(default)} {scene_unit(quantity, unit)}".strip()
    return _quantity_option([flag(name), name], quantity, f"{text}  [{shown}]", unit)


def _input_option(kind: type[Mechanism], name: str, unit: str) -> click.Option:
    shown = f"{typed(kind.inputs[name])} {scene_unit(name, unit)}"
    return _quantity_option([flag(name)], name, f"{_INPUT_HELP[name]}  [{shown}]", unit)


def _quantity_option(names: list[str], quantity: str, text: str, unit: str) -> click.Option:
    read = values.quantity(quantity, unit)
    return click.Option(names, callback=read, metavar=quantity.upper(), help=text)
