"""What a file says of a shaft, an engine or a locomotive.

Each number that is written becomes a parameter: ``A_mass``, ``B_crank``, ``radius``.  What is left
out of a mass is to be found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from vad import gate
from vad.balancing.inertia import Cylinder, InertiaForces
from vad.balancing.locomotive import Coupling, Locomotive
from vad.balancing.shaft import NUMBERS, Mass
from vad.errors import InputError, VadError, quoted, unknown
from vad.files.description import Expression, Parameter, Values
from vad.files.links import letters
from vad.files.tables import ROTORS, Numbers, Source
from vad.units import check_length_unit, metres_of, number_of

#: The tables of such files; the masses of ``[shaft]`` stand in ``[shaft.masses]``.
SHAFT, ENGINE, CYLINDERS, LOCOMOTIVE = ROTORS
MASSES = f"{SHAFT}.masses"
#: A coupling pin stands opposite to the crank beside it unless another angle is given.
OPPOSITE = 180.0
#: The diagrams of what changes over a turn of a locomotive.
LOCOMOTIVES = ("traction", "hammer")
_OF_SHAFT = ("clockwise", "speed", "bearings", "choice", "masses")
_OF_ENGINE = ("radius", "rod", "ratio", "speed", "reference")
_OF_CYLINDER = ("mass", "crank", "plane", "line")
_OF_LOCOMOTIVE = (
    *("balanced", "rotating", "wheels", "balance_radius"),
    *("wheel_diameter", "wheel_load", "road_speed"),
    *("coupled", "coupling", "coupling_radius", "coupling_angle", "coupling_planes"),
)
AS_MASS = "as in A = { mass = 200, radius = 80, angle = 0, plane = 0 }"
AS_CYLINDER = "as in A = { mass = 11.5, crank = 0, plane = 0, line = 45 }"
_QUANTITIES = {
    "mass": "mass",
    "radius": "length",
    "angle": "angle",
    "plane": "length",
    "crank": "angle",
    "line": "angle",
}
_SIGNED = ("angle", "plane", "crank", "line")
#: The letters of the axis, which is the first that is free.
_AXES = ("O", "S", "Z")

#: A number as it is written: one that may depend on parameters.
Entry = Mapping[str, Expression]


@dataclass(frozen=True)
class Rotor:
    """What a file says of a shaft or an engine, before any number is known.

    Attributes
    ----------
    source
        The text.
    parameters
        Its numbers by name.
    masses
        Of the shaft, by name; those of ``[shaft]`` beside an engine, too.
    cylinders
        Of the engine, by name; none for a shaft.
    numbers
        The other numbers of the engine and of the locomotive, by name.
    settings
        What is no number: ``clockwise``, ``choice``, ``bearings`` and ``wheels``.
    speed
        In rad/s.
    """

    source: Source
    parameters: Mapping[str, Parameter]
    masses: Mapping[str, Entry]
    cylinders: Mapping[str, Entry]
    numbers: Entry
    settings: Mapping[str, Any]
    speed: float

    #: The points that can be at two places: none.
    choices: ClassVar[list[str]] = []
    #: The words for them.
    words: ClassVar[dict[str, list[str]]] = {}

    @property
    def is_engine(self) -> bool:
        """Whether it is an engine."""
        return bool(self.cylinders)

    @property
    def is_locomotive(self) -> bool:
        """Whether its wheels balance a part of what goes to and fro."""
        return "wheels" in self.settings

    @property
    def diagrams(self) -> tuple[str, ...]:
        """The names of the diagrams that can be drawn of it."""
        if self.is_engine and not self.is_locomotive:
            second = "rod" in self.numbers or "ratio" in self.numbers
            return ("engine", "primary", *(("secondary",) if second else ()))
        values = {name: each.default for name, each in self.parameters.items()}
        planes = {mass.plane for mass in self.given_masses(values)}
        if len(planes) == 1 and not self.is_locomotive:
            return ("shaft", "force")
        return ("shaft", "couple", "force", *(LOCOMOTIVES if self.is_locomotive else ()))

    @property
    def usual(self) -> tuple[str, ...]:
        """Those that are drawn where nobody asks for others."""
        return tuple(name for name in self.diagrams if name not in LOCOMOTIVES)

    @property
    def turning(self) -> tuple[str, ...]:
        """Those that change over a turn; none of a shaft, which turns as a whole."""
        if self.is_locomotive:
            return ("shaft", *LOCOMOTIVES)
        return self.diagrams if self.is_engine else ()

    @property
    def title(self) -> str:
        """Its title."""
        usual = self.source.name.removesuffix(".toml") or ("Engine" if self.cylinders else "Shaft")
        return str(self.source.table("").get("title", usual))

    @property
    def unit(self) -> str:
        """The unit of lengths."""
        return str(self.source.table("").get("unit", "mm"))

    @property
    def axis(self) -> str:
        """The letter of the axis."""
        names = {*self.masses, *self.cylinders}
        return next(letter for letter in _AXES if letter not in names)

    def given_masses(self, values: Values) -> tuple[Mass, ...]:
        """Return the masses of the shaft, with angles counted counter-clockwise."""
        found = []
        for name, entry in self.masses.items():
            numbers = {what: each(values) for what, each in entry.items()}
            if self.settings["clockwise"] and "angle" in numbers:
                numbers["angle"] = -numbers["angle"]
            found.append(Mass(name, **numbers))
        return tuple(found)

    def inertia(self, values: Values, omega: float, rotating: tuple[Mass, ...]) -> InertiaForces:
        """Return the inertia forces of the engine."""
        cylinders = tuple(
            Cylinder(name, **{what: each(values) for what, each in entry.items()})
            for name, entry in self.cylinders.items()
        )
        numbers = {name: each(values) for name, each in self.numbers.items()}
        radius = numbers["radius"]
        ratio = numbers["rod"] / radius if "rod" in numbers else numbers.get("ratio")
        metres, level = metres_of(self.unit) or 1.0, numbers.get("reference", 0.0)
        return InertiaForces(cylinders, radius, ratio, omega, metres, level, rotating)

    def locomotive(self, values: Values, inertia: InertiaForces) -> Locomotive | None:
        """Return what the wheels balance; None for any other engine."""
        if not self.is_locomotive:
            return None
        numbers = {name: each(values) for name, each in self.numbers.items()}
        names = [name for name in ("X", "Y", "V", "W") if name not in self.cylinders]
        coupling = None
        if "rods" in self.settings:
            mass, radius = numbers["coupling"], numbers["coupling_radius"]
            angle = numbers.get("coupling_angle", OPPOSITE)
            coupling = Coupling(mass, radius, angle, self.settings["rods"])
        return Locomotive(
            inertia,
            numbers["balanced"],
            numbers.get("rotating", 0.0),
            self.settings["wheels"],
            numbers["balance_radius"],
            self.unit,
            (names[0], names[1]),
            numbers.get("wheel_load"),
            numbers.get("wheel_diameter"),
            numbers.get("coupled", 1.0),
            coupling,
        )


def read_rotor(source: Source) -> Rotor:
    """Return what a file says of a shaft or an engine.

    Raises
    ------
    vad.errors.InputError
        With its line, for what cannot be.
    """
    unit = str(source.table("").get("unit", "mm"))
    try:
        check_length_unit(unit)
    except VadError as error:
        raise source.error("", "unit", f"unit: {error}", error.hint) from None
    reader = _Reader(source, unit)
    for table in source.tables:
        if table and table not in (*ROTORS, MASSES, "dimensions", "names"):
            message = f"[{table}] does not go with [{reader.kind}]"
            raise source.error(table, "", message, f"leave out [{table}]")
    return reader.rotor()


class _Reader:
    """Reads the tables of a shaft or an engine."""

    def __init__(self, source: Source, unit: str) -> None:
        self.source, self.unit = source, unit
        self.kind = ENGINE if ENGINE in source.tables or CYLINDERS in source.tables else SHAFT
        self.numbers = Numbers(source, unit)
        self.numbers.dimensions()

    def rotor(self) -> Rotor:
        masses = {name: self.mass(name, each) for name, each in self.table(MASSES)}
        words = self.of_shaft()
        numbers: dict[str, Expression] = {}
        cylinders: dict[str, Entry] = {}
        speed = self.speed(SHAFT)
        if self.kind == ENGINE:
            numbers = self.of_engine()
            cylinders = {name: self.cylinder(name, each) for name, each in self.table(CYLINDERS)}
            if not cylinders:
                raise self.error(CYLINDERS, "", "there is no cylinder", AS_CYLINDER)
            speed = self.speed(ENGINE) or speed
            if LOCOMOTIVE in self.source.tables:
                found, wheels = self.of_locomotive()
                numbers |= found
                words["wheels"] = wheels
                rods = self.source.table(LOCOMOTIVE).get("coupling_planes")
                if rods is not None:
                    words["rods"] = self.pair(LOCOMOTIVE, "coupling_planes", rods)
                speed = speed or self.road_speed(numbers)
            if not speed:
                raise self.error(ENGINE, "", "the engine has no speed", 'as in speed = "500 rpm"')
        elif not masses:
            raise self.error(MASSES, "", "there is no mass", AS_MASS)
        self.check_names([*masses, *cylinders])
        found_parameters = self.numbers.found
        return Rotor(self.source, found_parameters, masses, cylinders, numbers, words, speed)

    def table(self, name: str) -> Iterator[tuple[str, Any]]:
        """Yield the entries of a table with names of points."""
        for key, value in self.source.table(name).items():
            if len(letters(key)) != 1:
                hint = "a capital letter, or a letter with a number: B2"
                raise self.error(name, key, f"{quoted(key)} cannot be its name", hint)
            yield key, value

    def check_names(self, names: list[str]) -> None:
        """Refuse a mass and a cylinder of one name, and names that leave none for the axis."""
        double = next((name for name in names if names.count(name) > 1), "")
        if double:
            message = f"{double}: there is a cylinder of that name, too"
            raise self.error(MASSES, double, message, "give the mass another letter")
        if set(_AXES) <= {*names}:
            table = CYLINDERS if self.kind == ENGINE else MASSES
            raise self.error(table, "O", "one of O, S and Z is the axis", "use another letter")

    def mass(self, name: str, value: Any) -> Entry:
        """Read a mass; what is left out is to be found."""
        self.check_words(MASSES, name, value, NUMBERS, AS_MASS)
        return {
            what: self.take(MASSES, name, what, value[what]) for what in NUMBERS if what in value
        }

    def cylinder(self, name: str, value: Any) -> Entry:
        """Read a cylinder; its mass is needed."""
        self.check_words(CYLINDERS, name, value, _OF_CYLINDER, AS_CYLINDER)
        if "mass" not in value:
            raise self.error(CYLINDERS, name, f"{name}: has no mass", AS_CYLINDER)
        named = [what for what in _OF_CYLINDER if what in value]
        return {what: self.take(CYLINDERS, name, what, value[what]) for what in named}

    def take(self, table: str, key: str, what: str, value: Any) -> Expression:
        """Return a number of a mass or a cylinder, which is a parameter where it is a literal."""
        signed, help = what in _SIGNED, f"{what} of {key}"
        quantity = _QUANTITIES[what]
        return self.numbers.take(
            table, key, f"{key}_{what}", value, quantity, signed=signed, help=help
        )

    def of_shaft(self) -> dict[str, Any]:
        """Read the words of the shaft."""
        given = self.source.table(SHAFT)
        self.check_words(SHAFT, "", given, _OF_SHAFT, "as in clockwise = true")
        found: dict[str, Any] = {}
        with self.source.at(SHAFT, "clockwise"):
            found["clockwise"] = gate.flag("clockwise", given.get("clockwise", False))
        with self.source.at(SHAFT, "choice"):
            found["choice"] = gate.whole("choice", given.get("choice", 0), 0, 1)
        found["bearings"] = ()
        if "bearings" in given:
            found["bearings"] = self.pair(SHAFT, "bearings", given["bearings"])
        return found

    def pair(self, table: str, key: str, value: Any) -> tuple[float, float]:
        """Read two planes that differ."""
        if not isinstance(value, list | tuple) or len(value) != 2:
            message = f"{key}: must be two planes, got {quoted(value)}"
            raise self.error(table, key, message, f"as in {key} = [0, 900]")
        with self.source.at(table, key):
            one, other = (number_of(key, each, "length", self.unit) for each in value)
            if one == other:
                raise InputError(f"{key}: must be two different planes, got {one:g} twice")
        return one, other

    def of_engine(self) -> dict[str, Expression]:
        """Read the numbers of the engine."""
        given = self.source.table(ENGINE)
        self.check_words(ENGINE, "", given, _OF_ENGINE, "as in radius = 75")
        if "radius" not in given:
            raise self.error(ENGINE, "", "the engine has no radius of its cranks", "radius = 75")
        if "rod" in given and "ratio" in given:
            raise self.error(ENGINE, "ratio", "rod and ratio say the same", "leave out one of them")
        if "rod" not in given and "ratio" not in given and LOCOMOTIVE not in self.source.tables:
            hint = "rod = 300, or ratio = 4 of rod and crank"
            raise self.error(ENGINE, "", "the engine has neither rod nor ratio", hint)
        kinds = {"radius": "length", "rod": "length", "ratio": "number", "reference": "length"}
        helps = {
            "radius": "radius of the cranks",
            "rod": "length of the rods",
            "ratio": "length of a rod over the radius of the cranks",
            "reference": "plane about which couples are",
        }
        return {
            name: self.numbers.take(
                ENGINE,
                name,
                name,
                given[name],
                kind,
                signed=name == "reference",
                help=helps[name],
            )
            for name, kind in kinds.items()
            if name in given
        }

    def of_locomotive(self) -> tuple[dict[str, Expression], tuple[float, float]]:
        """Read the numbers of a locomotive, and the planes of its wheels."""
        given = self.source.table(LOCOMOTIVE)
        hint = 'as in balanced = "2/3", wheels = [-750, 750], balance_radius = 600'
        self.check_words(LOCOMOTIVE, "", given, _OF_LOCOMOTIVE, hint)
        for word in ("balanced", "wheels", "balance_radius"):
            if word not in given:
                raise self.error(LOCOMOTIVE, "", f"the locomotive has no {word}", hint)
        kinds = {
            "balanced": ("number", "share of what goes to and fro that is balanced"),
            "rotating": ("mass", "mass that turns at each crank pin"),
            "balance_radius": ("length", "radius of the balance masses"),
            "wheel_diameter": ("length", "diameter of the driving wheels"),
            "wheel_load": ("force", "load on each wheel at rest"),
            "coupled": ("number", "pairs of wheels that share the balance"),
            "coupling": ("mass", "mass that turns at each pin of a coupling rod"),
            "coupling_radius": ("length", "radius of the pins of coupling rods"),
            "coupling_angle": ("angle", "angle of such a pin from the crank beside it"),
        }
        found = {
            name: self.numbers.take(
                LOCOMOTIVE,
                name,
                name,
                given[name],
                kind,
                signed=name in ("balanced", "coupling_angle"),
                help=help,
            )
            for name, (kind, help) in kinds.items()
            if name in given
        }
        self.check_coupling(given)
        return found, self.pair(LOCOMOTIVE, "wheels", given["wheels"])

    def check_coupling(self, given: Mapping[str, Any]) -> None:
        """Refuse coupling rods of which not all is said."""
        rods = ("coupling", "coupling_radius", "coupling_planes")
        named = [word for word in (*rods, "coupling_angle") if word in given]
        missing = [word for word in rods if word not in given]
        hint = "as in coupling = 120, coupling_radius = 250, coupling_planes = [-800, 800]"
        if named and missing:
            message = f"{named[0]}: the coupling rods have no {missing[0]}"
            raise self.error(LOCOMOTIVE, named[0], message, hint)

    def road_speed(self, numbers: Entry) -> float:
        """Return the speed of the wheels from that along the track."""
        given = self.source.table(LOCOMOTIVE)
        if "road_speed" not in given:
            return 0.0
        if "wheel_diameter" not in numbers:
            hint = "wheel_diameter = 1800"
            raise self.error(LOCOMOTIVE, "road_speed", "the wheels have no diameter", hint)
        with self.source.at(LOCOMOTIVE, "road_speed"):
            speed = number_of("road_speed", given["road_speed"], "velocity", "m")
        values = {name: each.default for name, each in self.numbers.found.items()}
        metres = metres_of(self.unit) or 1.0
        return 2.0 * speed / (numbers["wheel_diameter"](values) * metres)

    def speed(self, table: str) -> float:
        """Return the speed that a table gives, in rad/s; 0 without one."""
        value = self.source.table(table).get("speed", 0.0)
        with self.source.at(table, "speed"):
            return number_of("speed", value, "omega", self.unit)

    def check_words(
        self, table: str, key: str, value: Any, words: Iterable[str], hint: str
    ) -> None:
        """Refuse an entry that is no table, and words that it cannot have."""
        start = f"{key}: " if key else ""
        if not isinstance(value, Mapping):
            message = f"{start}must be words and numbers, got {quoted(value)}"
            raise self.error(table, key, message, hint)
        for word in value:
            if word not in words:
                wrong = unknown("word", word, words)
                raise self.error(table, key or word, f"{start}{wrong}", wrong.hint)

    def error(self, table: str, key: str, message: str, hint: str | None = None) -> InputError:
        return self.source.error(table, key, message, hint)
