"""Mechanisms from files and from tables: a path or tables become a class like `vad.FourBar`.

The class has fields with defaults and help, named results, and a linkage.  It is made once for
each text.
"""

from __future__ import annotations

import copyreg
import keyword
import math
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, make_dataclass
from functools import lru_cache
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, cast

from vad import gate
from vad.errors import InputError, VadError, quoted, unknown
from vad.files.assembling import Assembly, UnplacedError, assemble
from vad.files.description import Description, Parameter, Values
from vad.files.examples import exercise_names, exercise_path
from vad.files.linkage import check_numbers, linkage_of, names_under
from vad.files.places import HINT, PARALLEL, WORDS, Place, opposite, place_of
from vad.files.reading import describe
from vad.files.structure import Dyad, Mobility, check_dyads, check_mobility
from vad.files.tables import (
    LONGEST,
    ROTORS,
    Source,
    read_file,
    read_text,
    sorted_out,
    with_tables,
)
from vad.kinematics.linkage import Linkage
from vad.kinematics.motion import solve
from vad.kinematics.solver import solver_of
from vad.mechanisms.mechanism import Mechanism
from vad.mechanisms.mechanism import unit as length_unit
from vad.statics.burden import Burden

FileTable = Mapping[str, Any]
#: How many ways of assembly are listed, if each point may be at either of its places.
MOST_WAYS = 16


def load(path: str | os.PathLike[str]) -> type[WrittenMechanism]:
    """Return the mechanism that a file describes: a class like `vad.FourBar`.

    Parameters
    ----------
    path
        A file in TOML, such as those that ``vad example`` prints, or the name of an exercise.

    Raises
    ------
    vad.errors.InputError
        With the file's name and the line, for what cannot be read or cannot move.

    Examples
    --------
    >>> from vad.files.examples import example_path
    >>> Press = load(example_path("toggle-press"))
    >>> Press(crank=170).parameters()["rod"]
    540.0
    """
    name = gate.path("path", path)
    return class_of(read_file(exercise_path(name) if name in exercise_names() else name))


def load_text(data: bytes, name: str) -> type[WrittenMechanism]:
    """Return the mechanism that the bytes of a file describe; errors call the file ``name``.

    Tables of loads that it names are looked for in the working folder.

    Raises
    ------
    vad.errors.InputError
        As for `load`.
    """
    return class_of(with_tables(read_text(gate.decoded(data, name, LONGEST), name), Path()))


def mechanism(
    *,
    fixed: FileTable,
    links: FileTable,
    driver: FileTable,
    guides: FileTable | None = None,
    assembly: FileTable | None = None,
    dimensions: FileTable | None = None,
    pose: FileTable | None = None,
    loads: FileTable | None = None,
    masses: FileTable | None = None,
    friction: FileTable | None = None,
    gravity: float | Sequence[float] | str | None = None,
    names: FileTable | None = None,
    title: str = "Mechanism",
    unit: str = "mm",
    about: str = "",
    source: str = "",
    output: str = "",
) -> type[WrittenMechanism]:
    """Return the mechanism that tables describe, which are those of a file.

    Parameters
    ----------
    fixed, links, guides, driver, assembly, dimensions, pose, loads, masses, friction
        The tables of a file, as dictionaries.
    gravity
        As in a file: a number along -y, or two.
    names
        The title and the names of links and slides in other languages, by their codes.
    title, unit, about, source
        The words of a file.
    output
        The point that a turn follows, as in a file.

    Raises
    ------
    vad.errors.InputError
        With the name of the table, for what cannot be or cannot move.

    Examples
    --------
    >>> Rocker = mechanism(
    ...     fixed={"A": (0, 0), "D": (100, 0)},
    ...     links={"crank": {"AB": 40}, "coupler": {"BC": 120}, "rocker": {"DC": 80}},
    ...     driver={"crank": {"angle": 60, "omega": 10}},
    ...     assembly={"C": "upper"},
    ... )
    >>> Rocker().assembly
    {'C': 'upper'}
    """
    given = {
        "dimensions": dimensions,
        "fixed": fixed,
        "links": links,
        "guides": guides,
        "driver": driver,
        "assembly": assembly,
        "pose": pose,
        "loads": loads,
        "masses": masses,
        "friction": friction,
        "names": names,
    }
    words: dict[str, Any] = {"title": title, "unit": unit, "about": about, "source": source}
    if gravity is not None:
        words["gravity"] = gravity
    if output:
        words["output"] = output
    tables = {name: table for name, table in given.items() if table is not None}
    return class_of(sorted_out(Source("", {"": words | tables})))


@dataclass(frozen=True)
class Written:
    """What a file says, and what follows from it for all values of its numbers.

    Attributes
    ----------
    source
        The text.
    description
        What it says.
    mobility
        Its bodies and joints.
    dyads
        In the order of drawing.
    """

    source: Source
    description: Description
    mobility: Mobility
    dyads: tuple[Dyad, ...]

    @property
    def values(self) -> Values:
        """The numbers of the file."""
        return {name: each.default for name, each in self.description.parameters.items()}

    @property
    def choices(self) -> list[str]:
        """The points that can be at two places."""
        return [point for dyad in self.dyads if dyad.reversible for point in dyad.points]

    @property
    def words(self) -> dict[str, list[str]]:
        """The words for the places of each point that has two, its own first."""
        found = {}
        for point, word in self.assembly({}).words.items():
            one = self._word(point) if word == PARALLEL else word
            found[point] = list(dict.fromkeys([word, one, opposite(one)]))
        return found

    def _word(self, point: str) -> str:
        """Return a word that tells the two places of a point apart where it is no parallelogram."""
        for word in WORDS:
            with suppress(UnplacedError):
                self.assembly({point: word})
                return word
        raise UnplacedError(point, f"{point}: has no two places")

    def assembly(self, given: Mapping[str, Place]) -> Assembly:
        """Return the sides of the dyads; places that are given replace those of the file."""
        wanted = {**self.description.assembly, **given}
        return assemble(self.description, self.dyads, self.values, wanted)

    def checked_assembly(self) -> Assembly:
        """Return the sides of the file's own places.

        Raises
        ------
        vad.errors.InputError
            With its line, for a point that cannot take its place.
        """
        for point in self.description.assembly:
            if point not in self.choices:
                message = f"{point}: has one place only"
                hint = f"two places have {', '.join(self.choices)}" if self.choices else None
                raise self.source.error("assembly", point, message, hint)
        try:
            return self.assembly({})
        except UnplacedError as error:
            raise self._error_at(error.point, error) from None

    def _error_at(self, point: str, error: VadError) -> InputError:
        if point in self.source.table("assembly"):
            return self.source.error("assembly", point, str(error), error.hint)
        dyad = next(dyad for dyad in self.dyads if point in (dyad.point, *dyad.points))
        table, key = ("links", dyad.links[0].name) if dyad.links else ("guides", point)
        return self.source.error(table, key, str(error), error.hint)


class _WrittenType(type):
    """The type of these classes, which are pickled as the text of their file."""


class WrittenMechanism(Mechanism, listed=False, metaclass=_WrittenType):
    """A mechanism that a file describes; `vad.load` and `vad.mechanism` make its subclasses."""

    written: ClassVar[Written]

    if TYPE_CHECKING:  # a checker does not know the numbers of a file

        def __init__(self, **values: Any) -> None: ...

    def __init_subclass__(cls) -> None:
        super().__init_subclass__(listed=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        solver_of(self)  # numbers that cannot be solved are refused now, not later

    def _check(self, name: str, metadata: Any) -> None:
        if metadata["quantity"] != "places":
            super()._check(name, metadata)
            return
        given = getattr(self, name)
        if not isinstance(given, Mapping):
            raise InputError(f"{name}: must be places by point, got {quoted(given)}", _AS_IN)
        words = self._assembly(tuple(_places(self.written, given).items())).words
        object.__setattr__(self, name, dict(words))

    @classmethod
    @lru_cache(maxsize=64)
    def _assembly(cls, given: tuple[tuple[str, Place], ...]) -> Assembly:
        return cls.written.assembly(dict(given))

    def placements(self) -> list[tuple[dict[str, str], tuple[float, ...]]]:
        """Return the places that its points can take together, its own first.

        They are found with the numbers of its file.  What stays a parallelogram stays one.  Where
        there are more than `MOST_WAYS`, they are those in which one point has left its place.
        """
        own: dict[str, str] = dict(cast("Any", self.assembly))
        places = {
            p: [word] if word == PARALLEL else [word, opposite(word)] for p, word in own.items()
        }
        if math.prod(map(len, places.values())) <= MOST_WAYS:
            ways = [dict(zip(places, words, strict=True)) for words in product(*places.values())]
        else:
            ways = [own, *(own | {p: word} for p in own for word in places[p][1:])]
        found, here = [], self._sides(own)
        for way in ways:
            with suppress(UnplacedError):  # a point cannot be reached from the places of others
                sides = zip(here, self._sides(way), strict=True)
                found.append((way, tuple(a * b for a, b in sides)))
        return found

    def _sides(self, places: Mapping[str, str]) -> list[float]:
        sides = self._assembly(tuple(places.items())).sides
        return [sides[dyad.point] for dyad in self.written.dyads]

    @property
    def _values(self) -> dict[str, float]:
        return {name: getattr(self, name) for name in self.written.description.parameters}

    @property
    def burden(self) -> Burden | None:
        """What the file says that it has to bear, with the numbers of this mechanism."""
        return self.written.description.burden.burden(self._values)

    def linkage(self) -> Linkage:
        """Return the loops, one for each dyad."""
        written, values = self.written, self._values
        assembly: Any = self.assembly
        chosen = self._assembly(tuple(assembly.items()))
        return linkage_of(written.description, written.dyads, values, chosen.sides, chosen.parallel)


_AS_IN = "as in assembly={'B': 'left'}"


def _places(written: Written, given: Mapping[Any, Any]) -> dict[str, Place]:
    """Return the places that a user gives, by point.

    Raises
    ------
    vad.errors.InputError
        For what is no place, or no point that has two.
    """
    places = {}
    for point, value in given.items():
        if point not in written.choices:
            raise unknown("point with two places", point, written.choices)
        place = place_of(value)
        if place is None:
            raise InputError(f"assembly: {point}: {quoted(value)} is no place", HINT)
        places[point] = place
    return places


def class_of(source: Source) -> type[WrittenMechanism]:
    """Return the class of what a source describes.

    Raises
    ------
    vad.errors.InputError
        With its line, for what cannot be, cannot move, or is not made of dyads.
    """
    return _unpacked(source.packed())


@lru_cache(maxsize=64)
def _unpacked(text: str) -> type[WrittenMechanism]:
    source = Source.unpacked(text)
    if not source.tables.keys().isdisjoint(ROTORS):
        from vad.files.balancing import rotor_class  # most files have neither shaft nor engine

        return rotor_class(text)
    description = describe(source)
    mobility = check_mobility(source, description)
    dyads = tuple(check_dyads(source, description))
    written = Written(source, description, mobility, dyads)
    check_numbers(source, description, written.values)
    assembly = written.checked_assembly()
    kind = _made(written, assembly)
    with source.at("", ""):
        usual = kind()
    with source.at("driver", description.driver.name):
        motion = solve(usual, **kind.inputs)  # checks them
    for (table, key), part in description.burden.parts(written.values).items():
        from vad.statics.forces import forces_of  # most files have no loads

        with source.at(table, key):
            forces_of(motion, part)  # checks it, too
    return kind


def _made(written: Written, assembly: Assembly) -> type[WrittenMechanism]:
    """Return the dataclass."""
    description = written.description
    cylinders = {each.name: each.base[1] for each in description.links.values() if each.cylinder}
    slides = {guide.slide: guide.point for guide in description.guides.values()}
    words = dict(assembly.words)
    places = {"quantity": "places", "help": "the place of a point", "optional": False}
    made: type[WrittenMechanism] = declared(
        WrittenMechanism,
        written,
        title=description.title,
        about=description.about,
        unit=description.unit,
        parameters=description.parameters.values(),
        assembly=("assembly", dict, field(default_factory=words.copy, hash=False, metadata=places)),
        letters=(*description.points, *names_under(description).values()),
        links={each.name: "".join(each.base) for each in description.links.values()},
        slides=slides | cylinders,
        inputs=description.driver.inputs,
        own_names=description.names,
        output_point=description.output,
    )
    return made


def declared(
    base: Any,
    written: Any,
    *,
    title: str,
    about: str,
    unit: str,
    parameters: Iterable[Parameter],
    assembly: tuple[str, Any, Any],
    **names: Any,
) -> Any:
    """Return the dataclass of what a file says.

    Parameters
    ----------
    base
        Its base class.
    written
        What the file says; its ``source`` is the text.
    title, about, unit
        The words of the file.
    parameters
        Its numbers, each of which becomes a field.
    assembly
        The field of its assembly.
    names
        What the class states: its letters, links, slides and inputs.
    """
    name = written.source.name.removesuffix(".toml") or _slug(title)
    parts = [word.capitalize() for word in re.findall("[A-Za-z0-9]+", name)]
    class_name = "".join(parts)
    if not class_name.isidentifier() or keyword.iskeyword(class_name):
        class_name = "Written"
    fields = [(each.name, float, _field(each)) for each in parameters]
    namespace = {
        "__doc__": about or f"{title}.",
        "__module__": __name__,
        "name": name,
        "title": title,
        "written": written,
        **names,
    }
    every: list[Any] = [*fields, assembly, ("length_unit", str, length_unit(unit))]
    return make_dataclass(
        class_name, every, bases=(base,), namespace=namespace, frozen=True, kw_only=True
    )


def _reduced(kind: Any) -> tuple[Any, ...]:
    return _unpacked, (kind.written.source.packed(),)


copyreg.pickle(_WrittenType, _reduced)


def _field(parameter: Parameter) -> Any:
    metadata = {
        "quantity": parameter.quantity,
        "help": parameter.help,
        "signed": parameter.signed,
        "optional": False,
        "measures": parameter.measures or parameter.quantity,
    }
    return field(default=parameter.default, metadata=metadata)


def _slug(title: str) -> str:
    """Return a title as a name.

    Examples
    --------
    >>> _slug("Toggle press (Khurmi)")
    'toggle-press-khurmi'
    """
    return "-".join(re.findall("[a-z0-9]+", title.lower())) or "mechanism"
