"""A motion whose dimensions and assembly are traced, too, and how far its record holds.

A record holds for all dimensions with which the solver decides alike.  With an offset of exactly
zero, or with equal links, it decides as with no others.  So each dimension is moved by less than
anybody sees.  Then the record is tried with other dimensions, near and far: of the decisions that
come out differently, those stay as guards beyond which a number is wrong.

In which of its two places a loop is, is a factor of its closed form, +1 or -1.  Being traced, it is
an input like a dimension: the record is that of all assemblies.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.errors import InputError, VadError
from vad.kinematics.any_solver import AnySolver, Evaluation, Result
from vad.kinematics.assemblies import assemblies
from vad.kinematics.elementary import sine
from vad.kinematics.linkage import Linkage, crossing
from vad.kinematics.program import Program
from vad.kinematics.solver import other_solver, solver_of
from vad.kinematics.space.solver import SpaceSolver
from vad.kinematics.traced import Guard, Traced, TracedTape, made_of

if TYPE_CHECKING:
    from vad.kinematics.space.linkages import SpaceLinkage
    from vad.mechanisms.mechanism import Mechanism

Values = Mapping[str, float]
Array = NDArray[Any]

#: How far a dimension reaches under a slider, as a share of itself; one of zero reaches as far to
#: both sides as this share of the largest.
RANGE = (0.6, 1.5)
AROUND_ZERO = 0.1
#: The sets that are tried: with the mechanism's own dimensions, with others within the reach of
#: sliders, with others that are changed by a larger factor, and with one of its own reversed.
_OWN, _NEAR, _FAR, _REVERSED = 6, 60, 15, 20
_FACTOR = 5.0
_SEED = 21
#: By what share of itself a dimension is moved.  What is drawn of it stays the same: a point counts
#: as in line with two others within a hundred times as much.
_MOVED = 1e-11
#: A number is wrong that differs by more, as a share of the largest of its kind.  Even near a dead
#: centre, what is rounded is less.
_WRONG = 1e-7

_QUANTITIES = {
    "link": ("angle", "omega", "alpha"),
    "joint": ("angle", "omega", "alpha"),
    "point": ("position", "velocity", "acceleration"),
    "slide": ("position", "velocity", "acceleration"),
}


@dataclass(frozen=True)
class TracedMotion:
    """A motion with traced numbers.

    Attributes
    ----------
    mechanism
        The mechanism with traced dimensions, which is not checked.
    solver
        Its solver.
    inputs
        The motion of the driver by name, traced.
    sizes
        Those of the dimensions that are traced, by name, and the factors of `sides_of`.
    tape
        The record.
    guards
        The decisions with which its record holds.
    lasting
        How many of them, the first, are kept whatever the trials show: that axes and guides are
        apart.
    """

    mechanism: Mechanism
    solver: AnySolver
    inputs: Mapping[str, Traced]
    sizes: Mapping[str, Traced]
    tape: TracedTape
    guards: tuple[Guard, ...] = ()
    lasting: int = 0


def traced_motion(mechanism: Mechanism, inputs: Values) -> TracedMotion:
    """Return a motion with traced inputs, of a mechanism with dimensions that stay."""
    tape, given, _ = _inputs(inputs, {})
    # A solver of its own: the usual one answers from what it has calculated before.
    return TracedMotion(mechanism, solver_of.__wrapped__(mechanism), given, {}, tape)


def traced_dimensions(mechanism: Mechanism, inputs: Values, names: Sequence[str]) -> TracedMotion:
    """Return a motion with traced inputs and dimensions.

    If no other dimensions are right together, those stay as they are that cannot change alone: the
    mechanism's code makes a constant of one, or two have to be equal.

    Raises
    ------
    vad.errors.VadError
        For a pose that cannot be solved.
    """
    trials = _Trials(mechanism, inputs)
    best = trials.best(names)
    if best is None:
        alone = [name for name in names if trials.best([name])]
        best = trials.best(alone) if alone else None
    return best or traced_motion(mechanism, inputs)


def sides_of(mechanism: Mechanism) -> Mapping[str, tuple[float, ...]]:
    """Return the factors with which loops change their assembly, by name.

    Of each it is told for all `vad.kinematics.assemblies` what it is.

    Examples
    --------
    >>> import vad
    >>> sides_of(vad.FourBar()), sides_of(vad.ScotchYoke())
    ({'side 0': (1.0, -1.0)}, {})
    """
    found = dict.fromkeys(factors for factors in _factors(mechanism) if min(factors) < 0.0)
    return {f"side {number}": factors for number, factors in enumerate(found)}


@lru_cache(maxsize=64)
def _factors(mechanism: Mechanism) -> tuple[tuple[float, ...], ...]:
    """Return of each loop its factors in all assemblies."""
    return tuple(zip(*(way.sides for way in assemblies(mechanism)), strict=True))


def _solver(mechanism: Mechanism, values: Values, own: Mechanism) -> AnySolver:
    """Return the solver of a mechanism, with the factors that some values have for its sides.

    It is its ``own`` kind with other dimensions.
    """
    names = {factors: name for name, factors in sides_of(own).items()}
    sides = [values.get(names.get(factors, ""), 1.0) for factors in _factors(own)]
    return other_solver(mechanism, sides)


def _traced(mechanism: Mechanism, inputs: Values, sizes: Values) -> TracedMotion:
    """Return a motion with traced inputs and dimensions, with every decision as a guard."""
    tape, given, traced = _inputs(inputs, {**sizes, **dict.fromkeys(sides_of(mechanism), 1.0)})
    changed = mechanism.with_dimensions(traced)
    linkage = changed.marked()
    with tape.watched():
        if not (changed.axes_apart() and _guides_apart(linkage)):
            raise InputError("its axes or guides are not apart")
        lasting = len(tape.guards)
        solver = _solver(changed, traced, mechanism)
        _numbers(solver, tuple(given.values()), _results(solver))
    return TracedMotion(changed, solver, given, traced, tape, tape.guards, lasting)


def _guides_apart(linkage: Linkage | SpaceLinkage) -> bool:
    """Tell whether guides that must cross have two directions, which may be traced."""
    apart = True
    if isinstance(linkage, Linkage):
        for loop, unknowns in zip(linkage.loops, linkage.unknowns, strict=True):
            for (_, along), (_, across) in crossing(loop, unknowns, linkage.driver):
                apart = apart & (abs(sine(across - along)) > 0.0)
    return apart


def _inputs(
    inputs: Values, sizes: Values
) -> tuple[TracedTape, dict[str, Traced], dict[str, Traced]]:
    """Return a new record with its inputs: the motion of the driver, and dimensions."""
    tape = TracedTape()
    traced = {
        name: Traced.input(tape, f"i{number}", value)
        for number, (name, value) in enumerate((*inputs.items(), *sizes.items()))
    }
    given = {name: traced.pop(name) for name in inputs}
    return tape, given, traced


def _results(solver: AnySolver) -> list[Result]:
    """Return all that a solver can find: of a body that turns about no fixed line no angle."""
    names = {"link": solver.links, "point": solver.letters, "slide": solver.slides}
    free: Set[str] = frozenset()
    if isinstance(solver, SpaceSolver):
        names["joint"], free = solver.joints, solver.bodies
    return [
        (kind, name, quantity)
        for kind, found in names.items()
        for name in sorted(found)
        for quantity in _QUANTITIES[kind]
        if not (name in free and quantity == "angle")
    ]


def _numbers(
    solver: AnySolver, inputs: tuple[float, ...], results: Sequence[Result]
) -> list[float]:
    """Return results in numbers, of vectors in two or three coordinates each."""
    evaluation, found = Evaluation(solver, inputs), list[Any]()
    for result in results:
        value = solver.evaluate(result, evaluation)
        if isinstance(value, tuple):
            found += value
        else:
            found += [value.real, value.imag] if result[0] == "point" else [value]
    return found


class _Trials:
    """A mechanism with other dimensions, whose numbers are compared with those of a record."""

    def __init__(self, mechanism: Mechanism, inputs: Values) -> None:
        self._mechanism = mechanism
        self._inputs = inputs
        self._own = mechanism.dimensions()
        self._largest = max(map(abs, self._own.values()), default=0.0) or 1.0
        self._results = _results(solver_of(mechanism))

    def best(self, names: Sequence[str]) -> TracedMotion | None:
        """Return the record that holds for most sets of dimensions, with the guards that it needs.

        None if there is none that holds for others than those of the mechanism.
        """
        sets = list(self._sets(names))
        right = [self._right(values) for values in sets]
        exist = np.array([each is not None for each in right])
        own = [all(values[name] == self._own[name] for name in names) for values in sets]
        best, most = None, int((exist & own).sum())
        for sizes in self._candidates(names):
            try:
                traced = _traced(self._mechanism, self._inputs, sizes)
            except VadError:  # equal links that are moved apart are no parallelogram
                continue
            found, holds = self._played(traced, sets)
            wrong = [not self._agree(*both) for both in zip(found, right, strict=True)]
            guards = _needed(holds, np.array(wrong), traced.lasting)
            if guards is None:
                continue
            held = int(holds[exist][:, guards].all(axis=1).sum())
            if held > most:
                kept = tuple(traced.guards[number] for number in guards)
                best, most = replace(traced, guards=kept), held
            if most == exist.sum():
                break
        return best

    def _candidates(self, names: Sequence[str]) -> Iterator[Values]:
        """Yield dimensions to trace: all moved apart, equal ones moved alike, and unmoved."""
        own = {name: self._own[name] for name in names}
        alike = list(dict.fromkeys(own.values()))
        ways: tuple[Callable[[str], int], ...] = names.index, lambda name: alike.index(own[name])
        for place in ways:
            yield {
                name: value + _MOVED * (1.0 + place(name) / len(own)) * (value or self._largest)
                for name, value in own.items()
            }
        yield own

    def _sets(self, names: Sequence[str]) -> Iterator[dict[str, float]]:
        """Yield sets of dimensions and inputs, those of the mechanism first."""
        rng = np.random.default_rng(_SEED)
        own = {name: self._own[name] for name in names}
        (driven, place), *_ = self._inputs.items()
        kinds = np.repeat(["own", "near", "far", "reversed"], (_OWN, _NEAR, _FAR, _REVERSED))
        for number, kind in enumerate(kinds):
            values = {**self._inputs, **own}
            if kind in ("near", "far"):
                aside = (AROUND_ZERO if kind == "near" else 1.0) * self._largest
                for name, value in own.items():
                    far = _FACTOR ** rng.uniform(-1.0, 1.0)
                    factor = rng.uniform(*RANGE) if kind == "near" else far
                    values[name] = factor * value or rng.uniform(-aside, aside)
            name = names[number // 2 % len(names)]
            if kind == "reversed" and self._signed(name):
                values[name] = -values[name]
            for side in sides_of(self._mechanism):
                values[side] = rng.choice((1.0, -1.0))
            if number % 2:
                turned = rng.uniform(0.0, 360.0) if driven == "angle" else 0.0
                values[driven] = turned or place * rng.uniform(0.7, 1.3)
            yield values

    def _signed(self, name: str) -> bool:
        """Tell whether a dimension may be negative, as those of a point on a link may."""
        field = type(self._mechanism).__dataclass_fields__.get(name)
        return field is None or bool(field.metadata["signed"])

    def _right(self, values: Values) -> Array | None:
        """Return the right numbers; None where the mechanism is refused, or does not close."""
        inputs = tuple(values[name] for name in self._inputs)
        other = self._mechanism.with_dimensions(values)
        if not other.axes_apart():
            return None
        try:
            solver = _solver(other, values, self._mechanism)
            return np.array(_numbers(solver, inputs, self._results))
        except VadError:
            return None

    def _played(self, traced: TracedMotion, sets: Sequence[Values]) -> tuple[Array, Array]:
        """Return for each set, as rows, the numbers of a record and which of its guards hold."""
        given = {**traced.inputs, **traced.sizes}
        numbers = _numbers(traced.solver, tuple(traced.inputs.values()), self._results)
        made: list[Any] = [number.made for number in given.values()]
        outputs = [*(guard.made for guard in traced.guards), *map(made_of, numbers)]
        program = Program(made, outputs, len(numbers))
        columns = [np.array([values[name] for values in sets]) for name in given]
        played = program.many(columns, len(sets))
        count = len(traced.guards)
        holds = np.ones((len(sets), count), bool)
        for number, guard in enumerate(traced.guards):
            holds[:, number] = played[number] == guard.value
        return np.array(played[count:]).T, holds

    def _agree(self, found: Array, right: Array | None) -> bool:
        """Tell whether numbers are right; where there are none, one at least must be NaN."""
        if right is None:
            return bool(np.isnan(found).any())
        if np.isnan(right).any():  # a dead centre
            return True
        error = np.abs(found - right)
        angles = self._kinds == "angle"
        error[angles] = np.abs((error[angles] + 180.0) % 360.0 - 180.0)
        for kind in set(self._kinds):
            here = self._kinds == kind
            if not error[here].max() <= _WRONG * np.abs(right[here]).max():
                return False
        return True

    @cached_property
    def _kinds(self) -> NDArray[np.str_]:
        """The quantity of each number."""
        solver, inputs = solver_of(self._mechanism), tuple(self._inputs.values())
        counts = [len(_numbers(solver, inputs, [result])) for result in self._results]
        return np.repeat([quantity for _, _, quantity in self._results], counts)


def _needed(holds: Array, wrong: Array, lasting: int) -> list[int] | None:
    """Return the numbers of guards of which one at least fails wherever numbers are wrong.

    None if there are no such guards.  Each of them is needed, but the first ones, which are
    ``lasting``; an early decision, which a later one repeats, is kept.
    """
    if holds[wrong].all(axis=1).any():
        return None
    rest = range(lasting, holds.shape[1])
    needed = [*range(lasting), *(each for each in rest if not holds[wrong, each].all())]
    for number in reversed(needed[lasting:]):
        others = [each for each in needed if each != number]
        if not holds[wrong][:, others].all(axis=1).any():
            needed = others
    return needed
