"""The verb `solve`: from a mechanism with the motion of its driver to the motion of every part.

The inputs may be numbers or arrays; type checkers know which results follow from them.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import (
    TYPE_CHECKING,
    Any,
    ClassVar,
    Generic,
    Literal,
    NamedTuple,
    Protocol,
    TypedDict,
    Unpack,
    overload,
)

import numpy as np
from numpy.typing import NDArray

from vad import gate
from vad.errors import InputError, quoted, unknown
from vad.kinematics.any_solver import Result
from vad.kinematics.numbers import Number, Real, Truth, Vector
from vad.kinematics.results import Joint, Link, Point, Slider, plain, table, units
from vad.kinematics.solution import Solution
from vad.kinematics.solver import Solver, solver_of
from vad.units import number_of, scene_unit
from vad.written import DIGITS, MOST_DIGITS

if TYPE_CHECKING:
    from vad.files.loading import WrittenMechanism
    from vad.mechanisms.mechanism import DrivenBySlide, Mechanism, MechanismInSpace

    class DrivenByLink(Protocol):
        """A mechanism of which no type says that a slide drives it."""

        driven: ClassVar[Literal["link"]]


@overload
def solve(mechanism: MechanismInSpace, **inputs: Unpack[Crank]) -> MotionInSpace: ...
@overload  # of two signatures that fit, the first is taken
def solve(  # type: ignore[overload-overlap]
    mechanism: WrittenMechanism, **inputs: Unpack[CrankOrSlide]
) -> Motion: ...
@overload
def solve(mechanism: DrivenBySlide, **inputs: Unpack[Slide]) -> Motion: ...
@overload
def solve(mechanism: DrivenByLink, **inputs: Unpack[Crank]) -> Motion: ...
@overload
def solve(mechanism: MechanismInSpace, **inputs: Unpack[Cranks]) -> MotionsInSpace: ...
@overload
def solve(mechanism: WrittenMechanism, **inputs: Unpack[CranksOrSlides]) -> Motions: ...
@overload
def solve(mechanism: DrivenBySlide, **inputs: Unpack[Slides]) -> Motions: ...
@overload
def solve(mechanism: DrivenByLink, **inputs: Unpack[Cranks]) -> Motions: ...
def solve(mechanism: Any, **inputs: Any) -> Motion[Any, Any, Any]:
    """Solve one pose, or one for each element of the inputs' broadcast shape.

    Nothing is computed yet: positions, velocities and accelerations are found when they are
    asked for, each from the order below.

    Parameters
    ----------
    mechanism
        The mechanism with its dimensions; these may be arrays, too, which broadcast with the
        inputs.
    **inputs
        The motion of the driver: ``angle`` (degrees), ``omega`` (rad/s) and ``alpha`` (rad/s²)
        of a crank, or ``position``, ``velocity`` and ``acceleration`` of a slide, as numbers or
        arrays, or as texts with a unit.  What is left out has the mechanism's default.

    Raises
    ------
    vad.errors.InputError
        For an input that is unknown, or not a finite number.

    Examples
    --------
    >>> import vad
    >>> motion = vad.solve(vad.SliderCrank(crank=60, rod=140), angle=116.9, omega=11.59)
    >>> round(motion.slide("slider").velocity, 6)
    -490.028085
    >>> vad.solve(vad.FourBar(), omega="120 rpm").link("crank").omega
    12.566370614359172
    """
    global _latest  # noqa: PLW0603  # only what can be made again
    latest = _latest  # another thread may put its own there
    if mechanism is not latest.mechanism:
        latest = _latest = _prepared(mechanism)
    _, solver, defaults, largest, kind = latest
    # An input that is left out has the mechanism's own default, which is never refused.
    given = defaults.copy()
    for name, value in inputs.items():
        if name not in given:
            raise unknown("input", name, mechanism.inputs)
        most = largest[name]
        if type(value) is float and -most <= value <= most:
            given[name] = value  # the usual case
        elif isinstance(value, str):
            given[name] = _one(name, number_of(name, value, name, mechanism.length_unit), most)
        else:
            given[name] = checked(name, value, most)
    return kind(mechanism, solver, given)


#: The quantities of what turns, and of what moves or slides.
_TURNING = ("angle", "omega", "alpha")
_MOVING = ("position", "velocity", "acceleration")


class _Prepared(NamedTuple):
    """A mechanism made ready for `solve`: its solver, its inputs and how large they may be."""

    mechanism: Mechanism | None
    solver: Any
    defaults: dict[str, Number]
    largest: dict[str, float]
    kind: type[Motion[Any, Any, Any]]


def _prepared(mechanism: Mechanism) -> _Prepared:
    if not callable(getattr(type(mechanism), "marked", None)):  # every mechanism has this method
        raise InputError(
            f"mechanism: must be a mechanism with its dimensions, got {quoted(mechanism)}",
            hint="for example vad.FourBar()",
        )
    if getattr(mechanism, "varied", None):  # a class of somebody else may have none
        from vad.kinematics.varied import kind_of, representative  # most mechanisms do not vary

        solver = solver_of(representative(mechanism))
        kind = kind_of(solver)
    else:
        solver = solver_of(mechanism)
        kind = Motion if isinstance(solver, Solver) else MotionInSpace
    turns = solver.driver.kind == "angle"
    fastest = gate.FASTEST * (1.0 if turns else solver.scale)
    largest = dict.fromkeys(mechanism.inputs, fastest)
    if turns:
        largest["angle"] = sys.float_info.max
    return _Prepared(mechanism, solver, dict(mechanism.inputs), largest, kind)


class Motion(Solution[Truth], Generic[Real, Vector, Truth]):
    """A mechanism in motion, in the user's units; made by `solve`.

    To type checkers, `Motion` alone is one pose, and its results are numbers; those of `Motions`,
    which is many poses, are arrays.

    Examples
    --------
    >>> import numpy as np
    >>> import vad
    >>> vad.solve(vad.FourBar(), angle=40)
    <Motion of four-bar: angle 40 deg, omega 10 rad/s, alpha 0 rad/s^2>
    >>> vad.solve(vad.FourBar(), angle=np.linspace(0, 90, 7))
    <Motion of four-bar: angle of 7 poses, omega 10 rad/s, alpha 0 rad/s^2>
    """

    def __repr__(self) -> str:
        """Return a line: the mechanism, and how it is driven."""
        said = []
        for name, value in self.inputs.items():
            unit = scene_unit(name, self.mechanism.length_unit)
            many = " x ".join(map(str, np.shape(value)))
            said.append(f"{name} of {many} poses" if many else f"{name} {float(value):g} {unit}")
        return f"<{type(self).__name__} of {self.mechanism.name}: {', '.join(said)}>"

    def link(self, name: str) -> Link[Real]:
        """Return the motion of a link.

        Raises
        ------
        vad.errors.UsageError
            For a name that the mechanism does not have.
        """
        if not isinstance(name, str) or name not in self.solver.links:
            raise unknown("link", name, self.links)
        return Link(self, name)

    def point(self, letter: str) -> Point[Vector]:
        """Return the motion of a point."""
        own = self.mechanism
        known = isinstance(letter, str) and letter in self.solver.letters
        if not known or (letter not in own.letters and letter not in own.points):
            raise unknown("point", letter, self.points)
        return Point(self, letter)

    def slide(self, name: str) -> Slider[Real]:
        """Return the motion of a slide."""
        if not isinstance(name, str) or name not in self.solver.slides:
            raise unknown("slide", name, self.slides)
        return Slider(self, name)

    @property
    def links(self) -> tuple[str, ...]:
        """The names of the links."""
        names = self.mechanism.links
        return tuple(name for name in names if name in self.solver.links)

    @property
    def slides(self) -> tuple[str, ...]:
        """The names of the slides."""
        names = self.mechanism.slides
        return tuple(name for name in names if name in self.solver.slides)

    @property
    def points(self) -> tuple[str, ...]:
        """The letters of the points: the mechanism's own, then those marked on its links."""
        names = (*self.mechanism.letters, *self.mechanism.points)
        return tuple(letter for letter in names if letter in self.solver.letters)

    @property
    def results(self) -> dict[str, Result]:
        """All results by name: ``"rocker.omega"``, ``"C.acceleration"``, ``"slider.position"``.

        ``"transmission"`` is the transmission angle of the last dyad, in degrees.
        """
        bodies = [part for part in self.links if part in self.solver.bodies]
        lines = [part for part in self.links if part not in bodies]
        loops = len(self.solver.dyads) if isinstance(self.solver, Solver) else 0
        last: dict[str, Result] = {"transmission": ("dyad", str(loops - 1), "transmission")}
        found: dict[str, Result] = {
            f"{part}.{quantity}": (kind, part, quantity)
            for kind, parts, quantities in (
                ("link", lines, _TURNING),
                ("link", bodies, _TURNING[1:]),
                ("point", self.points, _MOVING),
                ("slide", self.slides, (*_MOVING, "coriolis")),
                ("joint", self.solver.joints, _TURNING),
            )
            for part in parts
            for quantity in quantities
        }
        return found | last if loops else found

    def table(self, digits: int = DIGITS) -> str:
        """Return the results as a table in plain text, with units and so many significant digits.

        Raises
        ------
        vad.errors.InputError
            If ``digits`` is no whole number from 1 to 17.
        """
        return table(self.to_dict(), self.mechanism, gate.whole("digits", digits, 1, MOST_DIGITS))

    def to_dict(self) -> dict[str, Any]:
        """Return the results as the JSON object of ``vad solve --json``.

        Links, points and slides are listed by name with all that is known of them; vectors are
        [x, y] or [x, y, z].  An array of poses gives nested lists.
        """
        mechanism = self.mechanism
        return {
            "mechanism": mechanism.name,
            "parameters": {name: plain(x) for name, x in mechanism.parameters().items()},
            "input": {name: plain(value) for name, value in self.inputs.items()},
            "assembly": self.assembly,
            "units": units(mechanism.length_unit),
            "links": {
                name: _listed(self.link(name), _TURNING[name in self.solver.bodies :])
                for name in self.links
            },
            "points": {letter: _listed(self.point(letter), _MOVING) for letter in self.points},
            "slides": {
                name: _listed(self.slide(name), (*_MOVING, "coriolis")) for name in self.slides
            },
        }


class MotionInSpace(Motion[Any, Any, Any], Generic[Real, Truth]):
    """A mechanism in space in motion: its points are vectors x, y, z, and it has joints."""

    @property
    def assembled(self) -> Truth:
        """Whether it closes: a bool, or an array of them; a dead centre counts as closed."""
        closed: Truth = super().assembled
        return closed

    def slide(self, name: str) -> Slider[Real]:
        """Return the motion of a slide."""
        return super().slide(name)

    def point(self, letter: str) -> Point[NDArray[np.float64]]:
        """Return the motion of a point, in arrays whose last axis is x, y, z."""
        return super().point(letter)

    def link(self, name: str) -> Link[Any]:
        """Return the motion of a link; the rates of one about no fixed line are x, y, z."""
        return super().link(name)

    def joint(self, letter: str) -> Joint[Real]:
        """Return the motion of a joint."""
        if not isinstance(letter, str) or letter not in self.solver.joints:
            raise unknown("joint", letter, self.joints)
        return Joint(self, letter)

    @property
    def joints(self) -> tuple[str, ...]:
        """The letters of the joints that have an angle of their own."""
        return tuple(self.mechanism.joints)

    def to_dict(self) -> dict[str, Any]:
        """Return the results as the JSON object of ``vad solve --json``, with its joints."""
        found = super().to_dict()
        joints = {letter: _listed(self.joint(letter), _TURNING) for letter in self.joints}
        points, slides = found.pop("points"), found.pop("slides")
        return found | {"joints": joints, "points": points, "slides": slides}


def _listed(
    part: Link[Any] | Joint[Any] | Point[Any] | Slider[Any], names: tuple[str, ...]
) -> dict[str, Any]:
    values = ((name, getattr(part, name)) for name in names)
    return {name: plain(value) for name, value in values if value is not None}


# Who solves pose after pose asks again and again for one mechanism: it is compared once.
_latest = _Prepared(None, None, {}, {}, Motion)

#: Many poses at once, for annotations.
Motions = Motion[NDArray[np.float64], NDArray[np.complex128], NDArray[np.bool_]]
MotionsInSpace = MotionInSpace[NDArray[np.float64], NDArray[np.bool_]]


One = float | np.floating[Any] | np.integer[Any]
Many = Sequence[One] | Sequence[Sequence[One]] | NDArray[np.floating[Any] | np.integer[Any]]


class Crank(TypedDict, total=False):
    """The inputs of one pose that a crank drives: degrees, rad/s, rad/s²."""

    angle: One | str
    omega: One | str
    alpha: One | str


class Slide(TypedDict, total=False):
    """The inputs of one pose that a slide drives."""

    position: One | str
    velocity: One | str
    acceleration: One | str


class CrankOrSlide(Crank, Slide, total=False):
    """The inputs of one pose of a mechanism from a file, whose driver a type does not know."""


class Cranks(TypedDict, total=False):
    """The inputs of many poses that a crank drives: arrays that broadcast."""

    angle: One | str | Many
    omega: One | str | Many
    alpha: One | str | Many


class Slides(TypedDict, total=False):
    """The inputs of many poses that a slide drives: arrays that broadcast."""

    position: One | str | Many
    velocity: One | str | Many
    acceleration: One | str | Many


class CranksOrSlides(Cranks, Slides, total=False):
    """The inputs of many poses of a mechanism from a file."""


def checked(name: str, value: object, largest: float) -> Number:
    """Return an input as a float, or as a new array in which what is not finite is NaN.

    Raises
    ------
    vad.errors.InputError
        If it is neither a number nor an array of them, or a number that is not finite or greater
        than ``largest``.
    """
    if gate.is_number(value):
        return _one(name, value, largest)
    array = gate.array(name, value)
    if array.size and not (array.min() >= -largest and array.max() <= largest):
        array[~(np.abs(array) <= largest)] = np.nan
    array.flags.writeable = False  # a later change would not be solved
    return array


def _one(name: str, value: object, largest: float) -> float:
    number = gate.number(name, value)
    if abs(number) > largest:
        raise InputError(f"{name}: must be within ±{largest:g}, got {number:g}")
    return number
