"""The verb `merit`: figures of merit of a mechanism, by name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from typing import Any

from vad.errors import InputError, unknown
from vad.kinematics.any_solver import Result
from vad.kinematics.linkage import Bar
from vad.kinematics.motion import Motion, MotionInSpace, solve
from vad.kinematics.numbers import fold, positive
from vad.kinematics.reach import change_points, closing_range
from vad.kinematics.results import plain
from vad.kinematics.solver import Solver
from vad.mechanisms import Mechanism
from vad.merits.advantage import advantage
from vad.merits.courses import Ends, Extremes, Piece, extremes, part_of, pieces
from vad.merits.grashof import grashof
from vad.merits.pins import Slowest, listed, rubbing, slowest
from vad.merits.swing import NONE, Swing, goes_round, output_of, swing
from vad.statics.forces import forces
from vad.written import DIGITS

_TURN = 360.0
#: Below it an angle of transmission is that of a dead centre, which a double meets to its root.
_FLAT = 1e-5


def merit(
    mechanism: Mechanism | Motion[Any, Any, Any],
    *,
    output: str | None = None,
    pins: Mapping[str, Any] | None = None,
    loads: Iterable[Any] = (),
    masses: Mapping[str, Any] | None = None,
    gravity: Any = None,
    friction: Mapping[str, Any] | None = None,
    **inputs: Any,
) -> Merit:
    """Return the figures of merit of a mechanism, each found when it is asked for.

    Places are those of the driver: its angle in degrees, or its position.  All that is least or
    largest is found where it is: at the roots of the exact derivative.  Lengths that differ from
    those of a mechanism with a change point by less than 1e-12 of them count as such.

    Parameters
    ----------
    mechanism
        The mechanism with its dimensions, or one pose of its motion.
    output
        The link or the slide that comes out; left out, the last one found that the frame guides.
    pins
        Diameters of pins by their points, as in ``{"B": 50}``, whose velocities of rubbing are
        asked for; in the unit of lengths, or texts with a unit.
    loads, masses, gravity, friction
        As for `forces`, for the mechanical advantage.
    **inputs
        As for `solve`.  The rates are the same over the whole range; the place is the pose in which
        rubbing, slowest points and the advantage are found.

    Returns
    -------
    mapping
        ``output``
            The name of what comes out.
        ``grashof``
            ``"crank-rocker"``, ``"double-crank"``, ``"double-rocker"``, ``"rocker-crank"``,
            ``"triple-rocker"`` or ``"change point"``; None where there is no four-bar chain.
        ``ranges``
            Pairs of places between which it closes.
        ``dead_centres``
            The places at which rates do not exist.
        ``stroke``
            How far the output goes to and fro: a length, or degrees of a link.
        ``time_ratio``, ``forward_angle``, ``return_angle``
            The longer part of the driver's turn over the shorter one, and both in degrees.
        ``transmission``
            Of the last dyad ``least`` and ``largest`` in degrees, with their places ``least_at``
            and ``largest_at``; and ``dyads``, a list with those of all.
        ``extremes``
            The same four of any result, by its name: ``["rocker.omega"]``, ``["C.position x"]``;
            of a vector, ``["C.velocity"]``, those of its size; of an angle, the two ends of its
            swing.  A value that grows beyond all bounds is None.
        ``advantage``
            The size of the load over that of the drive.
        ``rubbing``
            For each pin ``pin``, ``diameter``, the bodies ``of`` and ``against``, and (ω₁ - ω₂)·r
            as ``velocity``.
        ``slowest``
            For each link the slowest point of its line: ``distance`` from its first end,
            ``position``, ``velocity``, and whether it is ``on_link``.

        What a mechanism does not have is None.

    Raises
    ------
    vad.errors.UsageError, vad.errors.InputError
        As for `solve` and `forces`; for an output or a pin that there is not.

    Examples
    --------
    >>> import vad
    >>> found = vad.merit(vad.CrankSlottedLever(ground=400, crank=200, lever=700))
    >>> found["output"], round(found["time_ratio"], 12), round(found["return_angle"], 10)
    ('lever', 2.0, 120.0)
    >>> vad.merit(vad.FourBar())["grashof"], vad.merit(vad.SliderCrank(crank=60))["stroke"]
    ('crank-rocker', 120.0)
    """
    if isinstance(mechanism, Motion):
        mechanism, inputs = mechanism.mechanism, {**mechanism.inputs, **inputs}
    motion: Any = solve(mechanism, **inputs)
    motion.check_one()
    if motion.many:
        raise InputError(
            "merit: the pose must be one, got arrays of poses", "vad.sweep takes arrays"
        )
    burden = {"loads": loads, "masses": masses, "gravity": gravity, "friction": friction}
    return Merit(motion, output, {} if pins is None else pins, burden)


class Merit(Mapping[str, Any]):
    """Figures of merit by name; made by `merit`.

    Its values are those that JSON has: numbers, texts, lists and mappings.

    Attributes
    ----------
    motion
        The motion: its place is the pose in which rubbing and the slowest points are found.
    """

    def __init__(
        self,
        motion: Motion[Any, Any, Any],
        output: str | None,
        pins: Mapping[str, Any],
        burden: Mapping[str, Any],
    ) -> None:
        self.motion = motion
        self.output = output_of(motion, output)
        self._rubbing = rubbing(motion, pins)
        self._burden = burden
        self._found: dict[str, Any] = {}
        self._pieces: dict[tuple[Result, str], list[Piece]] = {}

    def __getitem__(self, name: str) -> Any:
        if name not in _FIGURES:
            raise unknown("figure", name, _FIGURES)
        if name not in self._found:
            self._found[name] = _FIGURES[name](self)
        return self._found[name]

    def __contains__(self, name: object) -> bool:
        return name in _FIGURES

    def __iter__(self) -> Iterator[str]:
        return iter(_FIGURES)

    def __len__(self) -> int:
        return len(_FIGURES)

    def __repr__(self) -> str:
        return f"<figures of merit of {self.motion.mechanism.name}: {', '.join(self)}>"

    def to_dict(self, results: Iterable[str] = ()) -> dict[str, Any]:
        """Return all figures as ``vad solve --merit --json`` has them under ``merit``.

        The extremes are those of the output, and of the ``results`` that are named.
        """
        figures = {name: self[name] for name in self if name != "extremes"}
        return figures | {"extremes": self.extremes(results)}

    def extremes(self, results: Iterable[str] = ()) -> dict[str, Any]:
        """Return the extremes of the output, and of the ``results`` that are named."""
        part = f"{self.output[1]}." if self.output else None
        own = [name for name in self.motion.results if part and name.startswith(part)]
        known = self["extremes"]
        return {
            name: known[name]
            for name in dict.fromkeys((*own, *results))
            if name in known or name not in own
        }

    def table(self, results: Iterable[str] = (), digits: int = DIGITS, language: str = "en") -> str:
        """Return the figures as plain text with units; with the extremes of ``results``, if any."""
        from vad.merits.listing import extremes_table, table

        named, text = tuple(results), table(self, digits, language)
        most = extremes_table(self, named, digits, language) if named else ""
        return f"{text}\n\n{most}" if most else text

    @cached_property
    def ranges(self) -> list[Ends]:
        """The ranges of the driver in which it closes."""
        return closing_range(self.motion.mechanism)

    @property
    def turns(self) -> bool:
        """Whether the driver turns."""
        return self.motion.solver.driver.kind == "angle"

    @cached_property
    def swing(self) -> Swing:
        """How the output goes to and fro."""
        return swing(self._here(self.course(self.output)), self.turns) if self.output else NONE

    def _here(self, found: list[Piece]) -> list[Piece]:
        """Return the range in which the pose is, or the first: from one to another no way leads."""
        place = next(iter(self.motion.inputs.values()))
        here = [
            number
            for number, (low, high) in enumerate(self.ranges)
            if low <= (low + (place - low) % _TURN if self.turns else place) <= high
        ]
        number = here[0] if here else 0
        return found[number : number + 1]

    def course(self, result: Result, axis: str = "") -> list[Piece]:
        """Return how a result runs over the ranges: itself, one axis of it, or its size."""
        if (result, axis) not in self._pieces:
            solver = self.motion.solver
            inputs = list(self.motion.inputs.values())
            part, turns = part_of(solver, result, axis), result[2] == "angle"
            self._pieces[result, axis] = pieces(solver, self.ranges, inputs, part, turns)
        return self._pieces[result, axis]


def _dead_centres(merit: Merit) -> list[float]:
    solver = merit.motion.solver
    places = [change.place for change in change_points(merit.motion.mechanism)]
    for low, high in merit.ranges:
        if not merit.turns or high - low < _TURN:
            places += [low, high]
    if isinstance(solver, Solver):
        places += filter(lambda place: solver.is_dead(solver.positions(place)), _pivots(solver))
    return sorted({place % _TURN if merit.turns else place + 0.0 for place in places})


def _pivots(solver: Solver) -> Iterator[float]:
    """Yield the driver's angles at which a pin can stand on the pivot of a slotted link."""
    for loop in solver.loops:
        crank, bar = loop.crank, loop.step
        slotted = isinstance(bar, Bar) and isinstance(bar.length, str)
        if crank and slotted and abs(crank.c) == abs(crank.t):
            yield from (solver.frame.angle - crank.lead + half for half in (0.0, 180.0))


def _transmission(merit: Merit) -> dict[str, Any] | None:
    solver = merit.motion.solver
    if not isinstance(solver, Solver):
        return None
    found = [
        extremes(merit.course(("dyad", str(number), "transmission")))
        for number in range(len(solver.loops))
    ]
    dyads = [_at_dead_centres(each) for each in found if each is not None]
    if not dyads or len(dyads) < len(found):
        return None
    named = [{"dyad": what, **each} for what, each in zip(solver.dyads, dyads, strict=True)]
    return {**dyads[-1], "dyads": named}


def _at_dead_centres(most: Extremes) -> dict[str, Any]:
    """Return extremes of a transmission angle: at a dead centre it is 0 or 180 exactly."""
    found = most._asdict()
    if found["least"] < _FLAT:
        found["least"] = 0.0
    if found["largest"] > 180.0 - _FLAT:
        found["largest"] = 180.0
    return found


def _advantage(merit: Merit) -> float | None:
    burden = merit.motion.mechanism.burden
    if burden is None and not any(map(bool, merit._burden.values())):
        return None
    found: float | None = advantage(forces(merit.motion, **merit._burden))
    return found


def _slowest(merit: Merit) -> dict[str, Any] | None:
    if not isinstance(merit.motion.solver, Solver):
        return None
    found = slowest(merit.motion).items()
    return {name: None if each is None else _as_data(each) for name, each in found}


def _as_data(point: Slowest) -> dict[str, Any]:
    values = {name: plain(value) for name, value in point._asdict().items()}
    return values | {"on_link": bool(point.on_link)}


def _as_angles(most: Extremes, result: Result) -> dict[str, Any]:
    """Return extremes as data; those of an angle within [0, 360)."""
    found = most._asdict()
    if result[2] == "angle":
        found |= {which: positive(fold(found[which])) for which in ("least", "largest")}
    return found


class _AllExtremes(Mapping[str, Any]):
    """The extremes of any result, by its name, each found when it is asked for."""

    def __init__(self, merit: Merit) -> None:
        self._merit = merit
        self._found: dict[str, dict[str, Any] | None] = {}
        self._parts: dict[str, tuple[Result, str]] = {}
        motion = merit.motion
        axes = "xyz" if isinstance(motion, MotionInSpace) else "xy"
        for name, result in motion.results.items():
            if result[0] == "point" and result[2] == "position":
                self._parts |= {f"{name} {axis}": (result, axis) for axis in axes}
            elif result[2] != "coriolis" or motion.solver.on_turning_link(result[1]):
                self._parts[name] = result, ""

    def __getitem__(self, name: str) -> Any:
        if name not in self._parts:
            raise unknown("result", name, self._parts)
        if name not in self._found:
            found = self._merit.course(*self._parts[name])
            most = None if any(map(goes_round, found)) else extremes(found)
            self._found[name] = None if most is None else _as_angles(most, self._parts[name][0])
        return self._found[name]

    def __contains__(self, name: object) -> bool:
        return name in self._parts

    def __iter__(self) -> Iterator[str]:
        return iter(self._parts)

    def __len__(self) -> int:
        return len(self._parts)


#: The function of each figure, in the order in which they are said.
_FIGURES: dict[str, Callable[[Merit], Any]] = {
    "output": lambda merit: merit.output[1] if merit.output else None,
    "grashof": lambda merit: (
        grashof(merit.motion.solver) if isinstance(merit.motion.solver, Solver) else None
    ),
    "ranges": lambda merit: [list(ends) for ends in merit.ranges],
    "dead_centres": _dead_centres,
    "stroke": lambda merit: merit.swing.stroke,
    "time_ratio": lambda merit: merit.swing.time_ratio,
    "forward_angle": lambda merit: merit.swing.forward_angle,
    "return_angle": lambda merit: merit.swing.return_angle,
    "transmission": _transmission,
    "extremes": _AllExtremes,
    "advantage": _advantage,
    "rubbing": lambda merit: listed(merit._rubbing),
    "slowest": _slowest,
}
