"""What a file says, before any number is known: points, links, guides and a driver.

Every number is an `Expression` of the parameters, so that one description serves all dimensions.
An expression has four operators, powers, brackets and a few functions, with angles in degrees.
It is evaluated here and never executed as Python.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from vad import gate
from vad.errors import InputError, quoted, unknown
from vad.files.places import Place
from vad.kinematics.elementary import arccosine, arcsine, arctangent, bearing, hypot, power, sqrt
from vad.kinematics.numbers import direction, fold
from vad.kinematics.symbol import as_float

if TYPE_CHECKING:
    from vad.files.burden import BurdenEntry

#: No length needs a longer text, which would only cost time.
LONGEST = 200

_OPERATORS: dict[type[ast.AST], Callable[..., float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: power,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}
_FUNCTIONS: dict[str, Callable[..., float]] = {
    "sqrt": sqrt,
    "hypot": hypot,
    "abs": abs,
    "sin": lambda angle: as_float(direction(fold(angle)).imag),
    "cos": lambda angle: as_float(direction(fold(angle)).real),
    "tan": lambda angle: as_float(direction(fold(angle)).imag / direction(fold(angle)).real),
    "asin": arcsine,
    "acos": arccosine,
    "atan": arctangent,
    "atan2": bearing,
}
_CONSTANTS = {"pi": math.pi}


@dataclass(frozen=True)
class Expression:
    """A number that may depend on dimensions.

    Attributes
    ----------
    text
        As it is written.
    names
        The dimensions in it.
    tree
        Its syntax.

    Examples
    --------
    >>> half = Expression.of("arm/2 + 10*sin(30)", ["arm"])
    >>> half({"arm": 400.0})
    205.0
    """

    text: str
    names: frozenset[str]
    tree: ast.expr

    @classmethod
    def of(cls, text: str, dimensions: Mapping[str, object] | list[str]) -> Expression:
        """Read an expression.

        Raises
        ------
        vad.errors.InputError
            If it is no expression, or has a name that is no dimension.
        """
        wrong = InputError(
            f"{quoted(text)} is no number and no expression",
            hint="write 60, '6 cm', or 'a/2' with a in [dimensions]",
        )
        if len(text) > LONGEST:
            raise wrong
        try:
            tree = ast.parse(text.strip().replace("^", "**"), mode="eval").body
            names = frozenset(_names(tree))
        except (SyntaxError, ValueError, OverflowError, RecursionError, MemoryError):
            raise wrong from None
        for name in sorted(names):
            if name not in dimensions:
                wrong = unknown("dimension", name, dimensions)
                hint = wrong.hint if dimensions else f"write {name} = 100 under [dimensions]"
                raise InputError(str(wrong), hint)
        return cls(text, names, tree)

    def __call__(self, values: Mapping[str, float]) -> float:
        """Return its value for these dimensions.

        Raises
        ------
        vad.errors.InputError
            If it has no value, as after a division by zero, or one beyond every length.
        """
        try:
            value = _value(self.tree, values)
        except (ArithmeticError, ValueError):
            value = math.nan
        if not math.isfinite(value):
            raise InputError(f"{quoted(self.text)} has no value")
        wrong = gate.wrong_dimension(value, signed=True)
        if wrong:
            raise InputError(f"{quoted(self.text)} {wrong}")
        return value


def _names(node: ast.expr) -> set[str]:
    """Return the dimensions in an expression; refuse everything that is not arithmetic."""
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            float(value)  # a whole number of a thousand digits is refused
            return set()
        case ast.Name(id=name):
            return set() if name in _CONSTANTS else {name}
        case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
            return _names(operand)
        case ast.BinOp(op=op, left=left, right=right) if type(op) in _OPERATORS:
            return _names(left) | _names(right)
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if name in _FUNCTIONS:
            if len(args) != (2 if name in ("hypot", "atan2") else 1):
                raise ValueError(name)
            return set().union(*map(_names, args))
    raise ValueError


def _value(node: ast.expr, values: Mapping[str, float]) -> float:
    match node:
        case ast.Constant(value=value):
            return float(str(value))
        case ast.Name(id=name):
            return _CONSTANTS[name] if name in _CONSTANTS else values[name]
        case ast.UnaryOp(op=op, operand=operand):
            return _OPERATORS[type(op)](_value(operand, values))
        case ast.BinOp(op=op, left=left, right=right):
            return _OPERATORS[type(op)](_value(left, values), _value(right, values))
        case ast.Call(func=ast.Name(id=name), args=args):
            return _FUNCTIONS[name](*(_value(each, values) for each in args))
    raise ValueError


Values = Mapping[str, float]
Pair = tuple[str, str]


@dataclass(frozen=True)
class Parameter:
    """A number of the file that can be changed.

    Attributes
    ----------
    name
        Its option and field: ``crank``, ``BE``, ``CBE``, ``Dx``.
    quantity
        ``length``, ``angle`` or ``number`` (a dimension, which may be either).
    default
        As it is written, in the scene's unit.
    signed
        Whether it may be negative or zero.
    help
        One phrase.
    measures
        "length" for a dimension that can be nothing else, as its uses tell.
    """

    name: str
    quantity: str
    default: float
    signed: bool
    help: str
    measures: str = ""


@dataclass(frozen=True)
class Cartesian:
    """A place by its coordinates."""

    x: Expression
    y: Expression


@dataclass(frozen=True)
class Polar:
    """A place at a distance from another fixed point, in a direction in degrees."""

    start: str
    length: Expression
    angle: Expression


@dataclass(frozen=True)
class Beyond:
    """A point on the line of its link's base, at ``sense`` · length from ``start``."""

    start: str
    length: Expression
    sense: int


@dataclass(frozen=True)
class Aside:
    """A point at a distance from ``start``, at an angle from the direction to ``other``.

    The angle is counted counter-clockwise; ``sense`` is -1 where the file writes it from the point
    to ``other``.
    """

    start: str
    other: str
    length: Expression
    angle: Expression
    sense: int


@dataclass(frozen=True)
class Apex:
    """The third corner of a triangle by its distances from two others, to the left if side is 1."""

    first: str
    second: str
    from_first: Expression
    from_second: Expression
    side: int


@dataclass(frozen=True)
class FromPose:
    """A point whose place on its link follows from the pose that the file gives."""

    letter: str


Rule = Beyond | Aside | Apex | FromPose


@dataclass(frozen=True)
class LinkEntry:
    """A rigid link, or a cylinder.

    Attributes
    ----------
    name
        Its name.
    base
        The first pair of points, whose direction is the link's angle.
    length
        The distance of the pair; None for a cylinder, and where it follows from the pose.
    rules
        Where the further points are; each follows from those before it.
    cylinder
        Whether the length varies.
    rod
        The name of a cylinder's rod; if it is empty, the program chooses one.
    """

    name: str
    base: Pair
    length: Expression | None
    rules: Mapping[str, Rule]
    cylinder: bool = False
    rod: str = ""

    @property
    def points(self) -> tuple[str, ...]:
        """All its points, the base's first."""
        return (*self.base, *self.rules)


@dataclass(frozen=True)
class FrameLine:
    """A line of the frame.

    Attributes
    ----------
    through
        A fixed point, from which the slide counts, or a place.
    way
        Its direction in degrees, or a second fixed point on it.
    offset
        By how much it lies to the left of them.
    """

    through: str | Cartesian
    way: Expression | str
    offset: Expression | None = None


@dataclass(frozen=True)
class LinkLine:
    """The slot of a link, parallel to two of its points at an offset to the left."""

    link: str
    pair: Pair
    offset: Expression | None


@dataclass(frozen=True)
class SliderLine:
    """The slot of a slider, which does not turn: through its point, in a direction in degrees."""

    through: str
    angle: Expression


@dataclass(frozen=True)
class GuideEntry:
    """A line to which a point is bound, and the name of the slide along it.

    ``under`` names the point of the slotted link under the block.  Where it is empty, the program
    chooses a free name, such as Q.
    """

    point: str
    line: FrameLine | LinkLine | SliderLine
    slide: str
    under: str = ""


@dataclass(frozen=True)
class DriverEntry:
    """What drives: the angle of a link or the length of a slide, with its usual motion."""

    kind: str
    name: str
    inputs: Mapping[str, float]


@dataclass(frozen=True)
class Description:
    """All that a file says.

    Attributes
    ----------
    title, unit, about
        Its words.
    parameters
        Its numbers by name, in the order of the file.
    fixed
        The fixed points.
    links, guides
        By name, and by point.
    driver
        What drives.
    assembly
        Which of two places a point takes, at the usual place of the driver.
    pose
        Places of points in one position, from which links that are written as letters get their
        shape.
    burden
        Loads, masses, gravity and friction.
    names
        The title and names in other languages, by the codes of these.
    output
        The point that a turn follows; empty where the file names none.
    """

    title: str
    unit: str
    about: str
    parameters: Mapping[str, Parameter]
    fixed: Mapping[str, Cartesian | Polar]
    links: Mapping[str, LinkEntry]
    guides: Mapping[str, GuideEntry]
    driver: DriverEntry
    assembly: Mapping[str, Place]
    pose: Mapping[str, Cartesian]
    burden: BurdenEntry
    names: Mapping[str, Mapping[str, str]]
    output: str = ""

    @property
    def points(self) -> tuple[str, ...]:
        """All points, fixed ones first, in the order of the file."""
        letters = dict.fromkeys(self.fixed)
        for link in self.links.values():
            letters.update(dict.fromkeys(link.points))
        letters.update(dict.fromkeys(self.guides))
        return tuple(letters)

    def links_at(self, point: str) -> list[LinkEntry]:
        """Return the links that have a point."""
        return [link for link in self.links.values() if point in link.points]
