"""The verb `design`: all mechanisms that do what is asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from types import MappingProxyType
from typing import Any, overload

from vad.designs.file import file_of
from vad.designs.task import Answer, Task
from vad.designs.tasks import task_named
from vad.kinematics.motion import Motion, solve
from vad.kinematics.reach import closing_range
from vad.mechanisms import Mechanism
from vad.merits.merit import Merit, merit
from vad.units import check_length_unit
from vad.written import DIGITS, typed

_TURN = 360.0
#: A place is in a range that it leaves by no more than this, in degrees.
_ROUNDED = 1e-9
#: Without another one, the driver's speed in rad/s.
_SPEED = 10.0


def design(task: str, *, length_unit: str = "mm", **demands: Any) -> Design:
    """Find the mechanisms that do what is asked for.

    Parameters
    ----------
    task
        ``"slider-crank"``, ``"quick-return"``, ``"crank-rocker"``, ``"three-positions"`` or
        ``"function"``.
    length_unit
        The unit of lengths.
    **demands
        What the task asks for, and what it leaves free; ``vad design TASK --help`` names them, with
        dashes.  Lengths and angles may be texts with a unit.

    Returns
    -------
    Design
        A sequence of solutions: those without a fault come first, and among them the one with the
        best transmission angle.

    Raises
    ------
    vad.errors.UsageError
        For a task or a demand that there is not; if something is missing.
    vad.errors.InputError
        For what cannot be: the message says the limit.

    Examples
    --------
    >>> import vad
    >>> found = vad.design("slider-crank", stroke=120, time_ratio=1.2)
    >>> found[0].mechanism.parameters()["crank"], len(found)
    (56.456914386825105, 2)
    >>> round(found[0].merit["stroke"], 9), round(found[0].merit["time_ratio"], 9)
    (120.0, 1.2)
    """
    chosen = task_named(task)
    unit = check_length_unit(length_unit)
    given = chosen.read(demands, unit)
    answers = chosen.solve(**given, length_unit=unit)
    found = [Solution(answer) for answer in answers]
    if len(found) > 1:
        found.sort(key=lambda solution: len(solution.faults))
    return Design(chosen, MappingProxyType(given), unit, tuple(found))


@dataclass(frozen=True, repr=False)
class Solution:
    """One mechanism that does what was asked for; made by `design`.

    Attributes
    ----------
    answer
        The mechanism with its positions, as its task has found it.
    """

    answer: Answer

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism, assembled as in the first of its positions."""
        return self.answer.mechanism

    @property
    def places(self) -> tuple[float, ...]:
        """Where its driver stands in the positions that were asked for, in degrees.

        These are the two dead centres, the one first where the crank pushes the output to its far
        end, or the positions in their order.
        """
        return self.answer.places

    @property
    def origin(self) -> complex:
        """Where the point A of the mechanism lies, of the positions that were given."""
        return self.answer.origin

    @property
    def notes(self) -> tuple[str, ...]:
        """What is said of it: which stroke is slow, or where it is driven."""
        return self.answer.notes

    @cached_property
    def motions(self) -> tuple[Motion, ...]:
        """It in each of the positions, assembled as there."""
        ways = self.answer.assemblies or ((self.mechanism.assembly,) * len(self.places))
        return tuple(
            solve(replace(self.mechanism, assembly=way), angle=each, omega=self.speed)
            for way, each in zip(ways, self.places, strict=True)
        )

    @property
    def positions(self) -> list[dict[str, Any]]:
        """What it does in each of the positions, as JSON holds it.

        Each has the ``angle`` of the driver, the ``output``, an angle or a position, the angle of
        ``transmission`` and the ``assembly``.
        """
        kind, name, quantity = self.merit.output or ("", "", "")
        return [
            {
                "angle": float(motion.inputs["angle"]),
                "output": float(getattr(getattr(motion, kind)(name), quantity)),
                "transmission": float(motion.read(motion.results["transmission"])),
                "assembly": motion.assembly,
            }
            for motion in self.motions
        ]

    @cached_property
    def merit(self) -> Merit:
        """Its figures of merit: stroke, time ratio, Grashof's class, transmission angle."""
        return merit(self.mechanism, angle=self.places[0], omega=self.speed)

    @cached_property
    def faults(self) -> tuple[str, ...]:
        """What is wrong between the positions; nothing where it runs through them.

        ``"assembly"``
            It would have to be taken apart: C is on the other side of the line from B to D.
        ``"range"``
            Between two positions lie places of the driver where it does not close.
        ``"order"``
            The driver meets the positions in another order.
        """
        found = ["assembly"] if len(set(self.answer.assemblies)) > 1 else []
        rows = self._in_ranges
        if rows is None:
            found.append("range")
        elif self._turns_fully:
            found += ["order"] if abs(self._turned) > _TURN else []  # of more than three alone
        elif not (_rises(rows) or _rises([-each for each in rows])):
            found.append("order")
        return tuple(found)

    @property
    def speed(self) -> float:
        """The angular velocity of the driver, which meets the positions in their order."""
        rows = self._in_ranges
        if self._turns_fully:
            backwards = len(self.places) > 2 and self._turned < 0.0
        else:
            backwards = rows is not None and not _rises(rows)
        return -_SPEED if backwards else _SPEED

    @cached_property
    def _ranges(self) -> list[tuple[float, float]]:
        return closing_range(self.mechanism)

    @property
    def _turns_fully(self) -> bool:
        return self._ranges == [(0.0, _TURN)]

    @cached_property
    def _in_ranges(self) -> list[float] | None:
        """The places, all within one range that closes; None if they are in several."""
        for low, high in self._ranges:
            start = low - _ROUNDED
            raised = [start + (each - start) % _TURN for each in self.places]
            if all(each <= high + _ROUNDED for each in raised):
                return raised
        return None

    @property
    def _turned(self) -> float:
        """How far a full-turning driver goes from the first position to the last: the shorter way.

        It is beyond a turn where the positions come in their order in neither sense.
        """
        ways = [(after - before) % _TURN for before, after in pairwise(self.places)]
        forward, backward = sum(ways), sum(_TURN - way for way in ways if way)
        return forward if forward <= backward else -backward

    def toml(self) -> str:
        """Return it as a mechanism's file, which every verb reads.

        What is wrong with it stands in its title, and so on each of its drawings.

        Examples
        --------
        >>> import vad
        >>> vad.design("slider-crank", stroke=120, time_ratio=1)[0].toml().splitlines()[7:9]
        ['crank = { AB = 60.0 }', 'rod   = { BC = 240.0 }']
        """
        return file_of(self.answer, self.speed, self.faults)

    def to_dict(self) -> dict[str, Any]:
        """Return it as JSON holds it; the names are those of ``vad solve --json``."""
        found, motion = self.merit, self.motions[0]
        transmission = found["transmission"]
        return {
            "mechanism": self.mechanism.name,
            "parameters": self.mechanism.parameters(),
            "assembly": motion.assembly,
            "points": {name: list(place) for name, place in self.mechanism.points.items()},
            "origin": [self.origin.real + 0.0, self.origin.imag + 0.0],
            "output": found["output"],
            "positions": self.positions,
            "omega": self.speed,
            "faults": list(self.faults),
            "notes": list(self.notes),
            **{name: found[name] for name in ("grashof", "stroke", "time_ratio")},
            "transmission": {key: transmission[key] for key in _EXTREMES},
        }

    def __repr__(self) -> str:
        """Return a line: the mechanism with its dimensions, and what is wrong with it."""
        said = ", ".join(f"{name} {typed(x)}" for name, x in self.mechanism.parameters().items())
        wrong = f" (faults: {', '.join(self.faults)})" if self.faults else ""
        return f"<{self.mechanism.name}: {said}, {self.mechanism.assembly}{wrong}>"


_EXTREMES = ("least", "least_at", "largest", "largest_at")


def _rises(numbers: Sequence[float]) -> bool:
    return all(before < after for before, after in pairwise(numbers))


@dataclass(frozen=True, repr=False)
class Design(Sequence[Solution]):
    """All solutions of a task; made by `design`.

    Attributes
    ----------
    task
        The task.
    demands
        What was asked for, by name.
    length_unit
        The unit of lengths.
    solutions
        The solutions, the best one first.
    """

    task: Task
    demands: Mapping[str, Any]
    length_unit: str
    solutions: tuple[Solution, ...]

    @overload
    def __getitem__(self, number: int) -> Solution: ...

    @overload
    def __getitem__(self, number: slice) -> Sequence[Solution]: ...

    def __getitem__(self, number: int | slice) -> Solution | Sequence[Solution]:
        return self.solutions[number]

    def __iter__(self) -> Iterator[Solution]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

    def table(self, digits: int = DIGITS, language: str = "en") -> str:
        """Return all solutions as plain text, with units; digits as in `Motion.table`."""
        from vad.designs.listing import table

        return table(self, digits, language)

    def to_dict(self, choice: int = 0) -> dict[str, Any]:
        """Return the design as JSON holds it, and at its top the solution of a number."""
        every = [solution.to_dict() for solution in self]
        return {
            "task": self.task.name,
            "demands": {name: _as_data(value) for name, value in self.demands.items()},
            "choice": choice + 1,
            "mechanism": every[choice]["mechanism"],
            "parameters": every[choice]["parameters"],
            "solutions": every,
            "units": {"length": self.length_unit, "angle": "deg", "omega": "rad/s"},
        }

    def __repr__(self) -> str:
        """Return a line for the task, and one for each solution."""
        said = ", ".join(f"{name} {_short(value)}" for name, value in self.demands.items())
        head = f"<Design {self.task.name}: {said}>"
        return "\n".join([head, *(f"  [{n}] {each!r}" for n, each in enumerate(self))])


def _as_data(value: Any) -> Any:
    """Return a demand as JSON holds it: of a function its name."""
    return getattr(value, "__name__", "function") if callable(value) else value


def _short(value: Any) -> str:
    """Write a demand as it is typed."""
    if isinstance(value, tuple):
        return ", ".join(" ".join(map(typed, row)) for row in value)
    return typed(value) if isinstance(value, float) else str(_as_data(value))
