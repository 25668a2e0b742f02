"""What all mechanisms have in common: parameters, inputs, names and one linkage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import KW_ONLY, dataclass, field, fields
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Self

from vad import gate
from vad.errors import InputError, one_of, quoted
from vad.kinematics.linkage import Linkage
from vad.mechanisms.link_points import LinkPoint, LinkPoints, link_points, marked
from vad.units import DIMENSIONS, number_of

if TYPE_CHECKING:
    from vad.kinematics.space.linkages import SpaceLinkage
    from vad.statics.burden import Burden


CRANK = {"angle": 60.0, "omega": 10.0, "alpha": 0.0}
# The smallest angle that axes may have: its sixth power stays in the range of double precision.
NEAREST = 1e-30
#: The most characters of a unit, which stands behind every number.
LONGEST_UNIT = 60

#: The quantities of parameters that are numbers: dimensions, and those of loads and masses.
NUMBERS = (*DIMENSIONS, "force", "couple", "direction", "mass", "inertia", "friction")

#: The dimensions of a point on a link.
_OF_POINTS = ("distance", "angle")

#: The mechanism classes that are loaded, by the name that the command line knows.
LOADED: dict[str, type[Mechanism]] = {}

if TYPE_CHECKING:

    class Dimension:
        """A field that is given as a number, or as a text with a unit, and is a number then."""

        def __get__(self, instance: object, owner: Any) -> float: ...
        def __set__(self, instance: object, value: float | str) -> None: ...

    class OptionalDimension:
        """The same, for one that may be missing."""

        def __get__(self, instance: object, owner: Any) -> float | None: ...
        def __set__(self, instance: object, value: float | str | None) -> None: ...
else:
    Dimension, OptionalDimension = float, float | None


def length(default: float | None, help: str, *, signed: bool = False) -> Any:
    """Declare a parameter that is a length; positive unless ``signed``, optional if None."""
    metadata = {
        "quantity": "length",
        "help": help,
        "signed": signed,
        "optional": default is None,
    }
    return field(default=default, metadata=metadata)


def angle(default: float, help: str) -> Any:
    """Declare a parameter that is an angle in degrees."""
    metadata = {"quantity": "angle", "help": help, "signed": True, "optional": False}
    return field(default=default, metadata=metadata)


def arc(default: float, help: str, hint: str, low: float = 0.0, high: float = 180.0) -> Any:
    """Declare an angle in degrees between axes, within ``low`` and ``high`` but neither of them.

    The ``hint`` says what it would be there.
    """
    metadata = {
        "quantity": "angle",
        "help": help,
        "signed": True,
        "optional": False,
        "between": (low, high, hint),
    }
    return field(default=default, metadata=metadata)


def unit(default: str) -> str:
    """Declare the unit that labels lengths."""
    metadata = {"quantity": "unit", "help": "the unit that labels lengths"}
    return field(default=default, metadata=metadata)


def way(*choices: str) -> str:
    """Declare in which ways it can be assembled; the first is the default."""
    metadata = {"quantity": "choice", "choices": choices, "help": "which way it is assembled"}
    return field(default=choices[0], metadata=metadata)


PlaceOnLink = tuple[str, float] | tuple[str, float, float]


def on_links() -> Mapping[str, PlaceOnLink]:
    """Declare further points on the links, by name; none are the default."""
    metadata = {"quantity": "points", "help": "a point D of a link, as in 'D on rod 100 at 30'"}
    return field(default=LinkPoints(), metadata=metadata)


@dataclass(frozen=True)
class Mechanism:
    """A linkage with its parameters; each kind is a subclass in a file of its own.

    A subclass states its parameters as dataclass fields, those that are given by name alone after
    ``_: KW_ONLY``, and as class variables its `name` on the command line, its `title`, the
    `letters` of its points, the `links` and `slides` that it reports (links with the letters of
    their ends, slides with the letter that slides), in space the `joints` by letter, and its
    `inputs` with their defaults.
    `linkage` returns its loops.  Its user may mark further `points`, each by the name of a link,
    a distance from that link's first end, and perhaps an angle from its line in degrees.

    A number may be given as a text with its unit, which is converted to the unit of the scene.

    Raises
    ------
    vad.errors.InputError
        For a parameter that is not finite, or not positive where it must be, or missing; for a text
        that says no number, or has a unit of another quantity.

    Examples
    --------
    >>> import vad
    >>> vad.FourBar(crank="4 cm").crank
    40.0
    """

    name: ClassVar[str]
    title: ClassVar[str]
    letters: ClassVar[Sequence[str]]
    links: ClassVar[dict[str, str]]
    slides: ClassVar[dict[str, str]] = {}
    joints: ClassVar[dict[str, str]] = {}
    inputs: ClassVar[Mapping[str, float]] = CRANK
    #: The title and names in other languages, by the codes of these, where a file has them.
    own_names: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    #: The point that a turn follows, where a file names one.
    output_point: ClassVar[str] = ""
    #: Whether it is a shaft or an engine, which is balanced; the diagrams of such a one, those that
    #: are usual, and those that change over a turn.
    is_rotor: ClassVar[bool] = False
    diagrams: ClassVar[tuple[str, ...]] = ()
    usual_diagrams: ClassVar[tuple[str, ...]] = ()
    turning_diagrams: ClassVar[tuple[str, ...]] = ()

    if TYPE_CHECKING:
        driven: ClassVar[Literal["link"]]  # tells type checkers which inputs there are

    _: KW_ONLY
    assembly: str = way("open", "crossed")
    length_unit: str = unit("mm")
    points: Mapping[str, PlaceOnLink] = on_links()

    def __init_subclass__(cls, listed: bool = True) -> None:
        # Read-only: mechanisms share their defaults.
        cls.inputs = MappingProxyType(dict(cls.inputs))
        if listed:
            LOADED[cls.name] = cls

    def __post_init__(self) -> None:
        # The unit comes first, since texts are converted to it.
        for parameter in sorted(fields(self), key=lambda each: each.name != "length_unit"):
            self._check(parameter.name, parameter.metadata)
        if not self.varied:  # each of the mechanisms that it stands for is checked by itself
            self._check_names(self.marked())

    def _check(self, name: str, metadata: Any) -> None:
        value = getattr(self, name)
        if metadata["quantity"] == "choice":
            one_of(name, value, metadata["choices"])
        elif metadata["quantity"] == "unit":
            if not isinstance(value, str) or not value.strip():
                raise InputError(f"{name}: must be the name of a unit, got {quoted(value)}")
            gate.line(name, value, LONGEST_UNIT)
        elif metadata["quantity"] == "points":
            object.__setattr__(self, name, link_points(value))
        elif gate.is_many(value):
            varied = gate.dimensions(name, value, signed=metadata["signed"])
            object.__setattr__(self, name, varied)
        elif value is not None or not metadata["optional"]:
            if isinstance(value, str):
                value = number_of(name, value, metadata["quantity"], self.length_unit)
            number = gate.dimension(name, value, signed=metadata["signed"])
            if "between" in metadata:
                _check_arc(name, number, *metadata["between"])
            object.__setattr__(self, name, number)

    def _check_names(self, linkage: Linkage | SpaceLinkage) -> None:
        """Check that everything that turns or slides in the plane is listed in the results."""
        if not isinstance(linkage, Linkage):
            return
        scalars = {linkage.driver, *(scalar for pair in linkage.unknowns for scalar in pair)}
        listed = {"angle": ("link", self.links), "length": ("slide", self.slides)}
        for scalar in sorted(scalars):
            what, names = listed[scalar.kind]
            one_of(what, scalar.name, names)

    def linkage(self) -> Linkage | SpaceLinkage:
        """Return the loops of this mechanism."""
        raise TypeError(f"{type(self).__name__} declares no linkage")

    def marked(self) -> Linkage | SpaceLinkage:
        """Return its loops, with the points that are marked on its links."""
        linkage = self.linkage()
        if isinstance(linkage, Linkage):
            points: Any = self.points  # as `link_points` returns them
            return marked(linkage, points, self.links, {*self.letters})
        if self.points:
            name = next(iter(self.points))
            raise InputError(f"point {name}: points are marked on links in the plane alone")
        return linkage

    @property
    def burden(self) -> Burden | None:
        """What it has to bear of its own: None, but for one from a file."""
        return None

    def balancing(self, motion: Any) -> Any:
        """Return what is balanced in a motion: None, but for a shaft or an engine from a file."""
        return None

    @property
    def varied(self) -> dict[str, Any]:
        """The parameters that are arrays, by name: it stands for a mechanism of each number."""
        values = {parameter.name: getattr(self, parameter.name) for parameter in fields(self)}
        return {name: value for name, value in values.items() if getattr(value, "shape", ()) != ()}

    def check_one(self) -> None:
        """Check that it is one mechanism.

        Raises
        ------
        vad.errors.InputError
            For a parameter that is an array, by its name.
        """
        for name in self.varied:
            raise InputError(
                f"{name}: must be one number here, got an array",
                "vad.solve and vad.sweep take arrays",
            )

    def parameters(self) -> dict[str, float]:
        """Return the numeric parameters that are set, by name."""
        return {
            parameter.name: getattr(self, parameter.name)
            for parameter in fields(self)
            if parameter.metadata["quantity"] in NUMBERS
            and getattr(self, parameter.name) is not None
        }

    def dimensions(self) -> dict[str, float]:
        """Return all numbers that can be changed: its parameters, and ``D.distance``, ``D.angle``.

        The latter are those of the points on its links.
        """
        found = self.parameters()
        for name, (_, *numbers) in self.points.items():
            found |= {f"{name}.{what}": x for what, x in zip(_OF_POINTS, numbers, strict=False)}
        return found

    def placements(self) -> list[tuple[dict[str, str], tuple[float, ...]]]:
        """Return the places that its points can take together, each with factors of its loops.

        There are none where all of it is assembled in one of two ways.
        """
        return []

    def axes_apart(self) -> bool:
        """Tell whether all angles between its axes leave them apart."""
        apart = True
        for parameter in fields(self):
            if "between" in parameter.metadata:
                low, high, _ = parameter.metadata["between"]
                value = getattr(self, parameter.name)
                apart = apart & (value > low) & (value < high)
        return apart

    def with_dimensions(self, values: Mapping[str, float]) -> Self:
        """Return it with other dimensions, by name, which are not checked and may be traced."""
        other = copy(self)
        for parameter in fields(self):
            if parameter.name in values:
                object.__setattr__(other, parameter.name, values[parameter.name])
        points = []
        for name, (link, *numbers) in self.points.items():
            named = zip(_OF_POINTS, numbers, strict=False)
            new = (values.get(f"{name}.{what}", number) for what, number in named)
            points.append((name, LinkPoint(link, *new)))
        object.__setattr__(other, "points", LinkPoints(tuple(points)))
        return other


@dataclass(frozen=True)
class DrivenBySlide(Mechanism, listed=False):
    """A mechanism whose driver is a slide: for type checkers its position is an input."""

    if TYPE_CHECKING:
        driven: ClassVar[Literal["slide"]]  # type: ignore[assignment]


@dataclass(frozen=True)
class MechanismInSpace(Mechanism, listed=False):
    """A mechanism that leaves the plane; its points are vectors x, y, z.

    The frame has its origin at A, z along A's axis and x along the common normal from A to D.
    A subclass states its `script`, the name of the module that draws it.
    """

    script: ClassVar[str]

    def linkage(self) -> SpaceLinkage:
        """Return what its axes or balls keep."""
        raise TypeError(f"{type(self).__name__} declares no linkage")


def _check_arc(name: str, number: float, low: float, high: float, hint: str) -> None:
    """Check that an angle between axes leaves them apart."""
    if not low < number < high:
        raise InputError(f"{name}: must be between {low:g}° and {high:g}°, got {number:g}°", hint)
    if low == 0.0 and number < NEAREST:
        raise InputError(f"{name}: must be at least {NEAREST:g}°, got {number:g}°", hint)
