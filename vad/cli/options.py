"""Options: the kinds of value that one takes, and those made from a mechanism's own fields.

A mechanism's class gives click's parameters, and these read the words of a command line.  A value
that is not given is not passed on, so that every default stands in one place only: the mechanism's
file.
"""

from __future__ import annotations

import dataclasses
import os
import re
from collections.abc import Callable, Collection, Mapping
from typing import TYPE_CHECKING, Any, cast

import click
from click.shell_completion import CompletionItem

from vad import errors, units
from vad.cli import completion
from vad.discovery import all_names, one_of_all
from vad.errors import UsageError, quoted
from vad.files.examples import EXTENSION, exercise_names
from vad.files.examples import all_names as example_names
from vad.files.places import WORDS
from vad.mechanisms import Mechanism, mechanism_named
from vad.mechanisms.mechanism import NUMBERS
from vad.units import LENGTH_UNITS, scene_unit
from vad.written import typed

if TYPE_CHECKING:
    from vad.export import OwnOption
    from vad.statics.burden import Burden

#: A function that reads the word after an option.
Callback = Callable[[click.Context, click.Parameter, Any], Any]
#: The options of the verbs: no parameter may have such a name as an option.
OWN = {
    *("help", "from", "to", "start", "stop", "point", "json", "as_json", "o", "output"),
    "digits",
    *("panels", "style", "language", "size", "paper", "blank", "task", "at", "turn"),
    *("fps", "speed", "still", "loop", "plain", "subtitles", "steps", "port", "no_browser"),
    *("script", "pause", "title", "subtitle"),
    *("load", "mass", "inertia", "gravity", "friction", "superpose", "centrode", "follow"),
    *("merit", "extremes", "pin", "over", "columns"),
}
#: The options that say what a mechanism has to bear: how each is written, and what it is.
_BURDEN = {
    "load": ("'FORCE @ ANGLE at POINT'", "a force; or a couple, as in '-6 N m on rocker'"),
    "mass": ("'BODY MASS at POINT'", "mass of a body, as in 'coupler 2 kg at G'"),
    "inertia": ("'BODY INERTIA'", "inertia about the centre of mass, as in 'coupler 0.01 kg m^2'"),
    "gravity": ("ACCELERATION", "gravity along -y, as in 9.81 m/s^2; or its components x,y"),
    "friction": ("'SLIDE NUMBER'", "coefficient of friction in a slide, as in 'ram 0.1'"),
}
_INPUT_HELP = {
    "angle": "angle of the driven link",
    "omega": "its angular velocity",
    "alpha": "its angular acceleration",
    "position": "position of the driven slide",
    "velocity": "its velocity",
    "acceleration": "its acceleration",
}


def kind_of(name: str) -> type[Mechanism]:
    """Return the class of the mechanism that is called ``name`` or stands in a file of that name.

    Raises
    ------
    vad.errors.UsageError
        For a name that no mechanism has.
    vad.errors.InputError
        For a file that describes none.
    """
    if name.endswith(EXTENSION) or name in exercise_names():
        from vad.files.loading import load

        return load(name)
    try:
        return mechanism_named(name)
    except UsageError as wrong:
        if os.path.isfile(name + EXTENSION):
            wrong.hint = f"{name}{EXTENSION} is a file"
        elif name in example_names():
            wrong.hint = f"vad example {name} > {name}{EXTENSION}"
        raise


def quantity_of(name: str, length_unit: str) -> Callback:
    """Read a number in the scene's unit, or with a unit of its own.

    ``length_unit`` is that of the scene unless the command line gives another one.
    """

    def value_of(word: str, ctx: click.Context) -> float:
        return units.read(word, name, ctx.params.get("length_unit") or length_unit)

    return _callback(value_of)


def places() -> Callback:
    """Read places of the driver with commas between them, in the units of the mechanism."""

    def places_of(words: str, ctx: click.Context) -> list[float]:
        mechanism = kind_of(str(ctx.info_name))()
        unit = ctx.params.get("length_unit") or mechanism.length_unit
        driven = next(iter(mechanism.inputs))
        return [units.read(word.strip(), driven, unit) for word in words.split(",")]

    return _callback(places_of)


def points(length_unit: str) -> Callback:
    """Read points on links, each with a distance and perhaps an angle."""

    def points_of(
        words: tuple[str, ...], ctx: click.Context
    ) -> dict[str, tuple[str, float, float]]:
        unit, found = ctx.params.get("length_unit") or length_unit, {}
        for word in words:
            name, place = _point(word, unit)
            if name in found:
                raise UsageError(f"point {name}: is given twice")
            found[name] = place
        return found

    return _callback(points_of)


def _point(word: str, unit: str) -> tuple[str, tuple[str, float, float]]:
    """Read ``D on rod 100``, ``D on rod 100 30`` or ``D on rod 10 cm at 30 deg``."""
    read = re.fullmatch(r"\s*(\S+)\s+on\s+(\S+)\s+(\S.*?)(?:\s+at\s+(\S.*?))?\s*", word)
    if read is None:
        raise UsageError(f"{quoted(word)} is no point of a link", hint="as in 'D on rod 100 at 30'")
    name, link, distance, angle = read.groups()
    if angle is None and (pair := re.fullmatch(r"(\S+)\s+([-+\N{MINUS SIGN}.\d]\S*)", distance)):
        distance, angle = pair.groups()
    size = units.read(distance, "length", unit)
    return name, (link.replace("-", "_"), size, units.read(angle or "0", "angle", unit))


def places_of_points() -> Callback:
    """Read the places of points, as in ``B=left``, with commas between them."""

    def places_in(words: tuple[str, ...], _: click.Context) -> dict[str, str]:
        given = {}
        for part in (part for word in words for part in word.split(",")):
            point, equals, place = (each.strip() for each in part.partition("="))
            if not (point and equals and place):
                raise UsageError(f"{quoted(part)} is no place of a point", hint="as in B=left")
            given[point] = place
        return given

    return _callback(places_in)


def length_unit() -> Callback:
    """Read the name of a unit of length."""
    return _callback(lambda word, _: units.check_length_unit(word))


def one_of(what: str, names: Collection[str], group: str = "") -> Callback:
    """Read one of a few names; a misspelt one is answered with the nearest.

    With a ``group`` of entry points, other packages may bring further names.
    """
    if group:
        return _callback(lambda word, _: one_of_all(what, word, names, group))
    return _callback(lambda word, _: errors.one_of(what, word, names))


def results() -> Callback:
    """Read names of results with commas between them, each once."""

    def results_in(words: tuple[str, ...], _: click.Context) -> tuple[str, ...]:
        parts = [part.strip() for word in words for part in word.split(",")]
        if "" in parts:
            raise UsageError("'' is no result", hint="as in rocker.omega,C.acceleration")
        return tuple(dict.fromkeys(parts))

    return _callback(results_in)


def several(what: str, names: Collection[str]) -> Callback:
    """Read some of a few names, from words with commas between them, each name once."""

    def names_of(words: tuple[str, ...], _: click.Context) -> tuple[str, ...]:
        parts = [part.strip() for word in words for part in word.split(",")]
        return tuple(dict.fromkeys(errors.one_of(what, part, names) for part in parts))

    return _callback(names_of)


def size() -> Callback:
    """Read the width and the height of a picture in pixels."""

    def size_of(word: str, _: click.Context) -> tuple[int, int]:
        numbers = re.fullmatch(r"\s*(\d{1,9})\s*[x×X*]\s*(\d{1,9})\s*", word)
        if numbers is None:
            raise UsageError(f"{quoted(word)} is not a size", hint="as in 1280x720")
        return int(numbers[1]), int(numbers[2])

    return _callback(size_of)


def path() -> Callback:
    """Read the name of a file or folder."""

    def path_of(word: str, _: click.Context) -> str:
        name = word.removeprefix("=")  # click lets it stand in -o=FILE
        if not name:
            raise UsageError("the name is empty", hint="as in -o lecture.mp4")
        return name

    return _callback(path_of)


def _callback(read: Callable[[Any, click.Context], Any]) -> Callback:
    """Leave out a value that is not given, and begin every error with the option's name."""

    def called(ctx: click.Context, param: click.Parameter, value: Any) -> Any:
        if value is None:
            return None
        try:
            return read(value, ctx)
        except UsageError as error:
            raise UsageError(f"{param.opts[0]}: {error}", error.hint) from None

    return called


def pin_option() -> click.Option:
    """Return the option of pins with their diameters."""
    return click.Option(
        ["--pin"],
        callback=pins(),
        multiple=True,
        metavar="'POINT DIAMETER'",
        help="diameter of a pin, as in 'B 50': how fast it rubs; may be given again  [none]",
    )


def pins() -> Callback:
    """Read pins, each with its diameter in the unit of lengths or in one of its own."""

    def pins_of(words: tuple[str, ...], ctx: click.Context) -> dict[str, float]:
        unit, found = ctx.params.get("length_unit") or _unit_of(ctx), {}
        for word in words:
            point, _, diameter = word.strip().partition(" ")
            if not diameter.strip():
                raise UsageError(f"{quoted(word)} is no pin", hint="as in 'B 50'")
            if point in found:
                raise UsageError(f"pin {point}: is given twice")
            found[point] = units.read(diameter.strip(), "length", unit)
        return found

    return _callback(pins_of)


def _unit_of(ctx: click.Context) -> str:
    return length_unit_of(kind_of(str(ctx.info_name)))


def burden_options() -> list[click.Option]:
    """Return the options of loads, masses, gravity and friction."""
    return [
        click.Option(
            [flag(name), name],
            multiple=name != "gravity",
            metavar=metavar,
            help=f"{text}  [none]" if name == "gravity" else f"{text}; may be given again  [none]",
        )
        for name, (metavar, text) in _BURDEN.items()
    ]


def take_burden(mechanism: Mechanism, given: dict[str, Any]) -> Burden | None:
    """Take from ``given`` what a mechanism has to bear beside its own; None if nothing loads it.

    Raises
    ------
    vad.errors.UsageError
        For what cannot be read; for gravity without a mass, and friction without a load.
    """
    if not given.keys() & _BURDEN and mechanism.burden is None:
        return None
    from vad.statics.burden import beside_own, check_burden  # most commands need no forces

    found = given_burden(given)
    check_burden(mechanism.burden, found)
    return beside_own(mechanism.burden, found)


def given_burden(given: dict[str, Any]) -> Burden:
    """Take from ``given`` what the options say that there is to bear.

    Raises
    ------
    vad.errors.UsageError
        For what cannot be read.
    """
    from vad.statics.burden import burden_of

    words = {name: given.pop(name) for name in _BURDEN if name in given}
    return burden_of(**{name: value for name, value in words.items() if value is not None})


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
        driven.append(_input_option(kind, place, unit))  # of the pose in which a dimension varies
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
    note_new_unit(kind, parameters)
    return kind(**parameters), inputs, rest


def note_new_unit(kind: type[Mechanism], given: Mapping[str, Any]) -> None:
    """Write on standard error which default lengths keep their numbers in another unit."""
    unit = given.get("length_unit")
    if unit in (None, length_unit_of(kind)):
        return
    kept = [
        f"{field.name} {typed(cast(float, field.default))}"
        for field in dataclasses.fields(kind)
        if field.metadata["quantity"] == "length"
        and field.name not in given
        and field.default  # no unit changes a length of zero
    ]
    if kept:
        numbers = ", ".join(kept)
        click.echo(
            f"note: with the unit {unit} these numbers stay as they are: {numbers}", err=True
        )


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
        super().__init__([flag(name), name], callback=one_of(what, names, group), help=text)
        self._own, self._group = names, group

    @property
    def names(self) -> Collection[str]:
        """Return all names that there are."""
        return all_names(self._own, self._group) if self._group else self._own

    def make_metavar(self, ctx: click.Context | None = None) -> str:
        """Return the names as the help shows them."""
        return "|".join(self.names)

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Return the names that begin with ``incomplete``."""
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
            callback=places_of_points(),
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
            callback=length_unit(),
            shell_complete=completion.one_of(LENGTH_UNITS),
            is_eager=True,
            metavar="UNIT",
            help=f"{text}  [{default}]",
        )
    if quantity == "points":
        return click.Option(
            ["--point", name],
            callback=points(unit),
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
    read = quantity_of(quantity, unit)
    return click.Option(names, callback=read, metavar=quantity.upper(), help=text)
