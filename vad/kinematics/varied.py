"""Motions of mechanisms whose dimensions vary: one for each number of an array.

Every set of dimensions is a mechanism of its own, with all its checks, and is solved as it is
alone.  So each pose has the bits that it has by itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vad.errors import InputError
from vad.kinematics.any_solver import OFTEN, AnySolver, Result, parts_of
from vad.kinematics.closed_forms import OpenLoopError
from vad.kinematics.motion import Motion, MotionInSpace, solve
from vad.kinematics.numbers import Number
from vad.kinematics.solution import broadcast
from vad.kinematics.solver import Solver, solver_of

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

Indices = NDArray[np.intp]


def representative(mechanism: Mechanism) -> Mechanism:
    """Return one of the mechanisms for which one with arrays stands: that of the first numbers.

    Raises
    ------
    vad.errors.InputError
        For dimensions that are Dask arrays, which `vad.sweep` takes alone.
    """
    defaults = {parameter.name: parameter.default for parameter in fields(mechanism)}
    chosen: dict[str, Any] = {}
    for name, values in mechanism.varied.items():
        if not isinstance(values, np.ndarray):
            raise InputError(f"{name}: is a Dask array, which vad.sweep takes", "vad.sweep(…)")
        known = values[np.isfinite(values)]
        chosen[name] = float(known[0]) if known.size else defaults[name]
    return replace(mechanism, **chosen)


def single_ones(
    mechanism: Mechanism, shape: tuple[int, ...]
) -> Iterator[tuple[Mechanism, Indices]]:
    """Yield each mechanism for which one with arrays stands, and its poses in the flat shape.

    Where a dimension is NaN there is none.

    Raises
    ------
    vad.errors.InputError
        For dimensions that make no mechanism together.
    """
    names = list(mechanism.varied)
    spread = [np.broadcast_to(mechanism.varied[name], shape).ravel() for name in names]
    table = np.column_stack(spread)
    (known,) = np.nonzero(~np.isnan(table).any(axis=1))
    if not known.size:
        return
    sets, which = np.unique(table[known], axis=0, return_inverse=True)
    order = np.argsort(which.ravel(), kind="stable")
    ends = np.cumsum(np.bincount(which.ravel()))[:-1]
    for values, at in zip(sets.tolist(), np.split(known[order], ends), strict=True):
        yield replace(mechanism, **dict(zip(names, values, strict=True))), at


def inputs_at(
    inputs: Mapping[str, Number], shape: tuple[int, ...], at: Indices
) -> dict[str, NDArray[np.float64]]:
    """Return the inputs of some poses, which are counted in the flat shape."""
    return {name: np.broadcast_to(value, shape).ravel()[at] for name, value in inputs.items()}


class _Varied:
    """What is different in a motion if dimensions vary: where its results are from."""

    mechanism: Mechanism
    solver: AnySolver
    shape: tuple[int, ...]
    inputs: Mapping[str, Number]

    def __init__(self, mechanism: Mechanism, solver: AnySolver, inputs: dict[str, Number]) -> None:
        super().__init__(mechanism, solver, inputs)  # type: ignore[call-arg]
        self.many = True
        self.shape = broadcast({**inputs, **mechanism.varied})

    @property
    def assembled(self) -> NDArray[np.bool_]:
        """Whether the links close, for each pose."""
        table = self.read_all([], 0)
        return table[:, 0].reshape(self.shape) == 1.0

    def check_one(self) -> None:
        """Refuse it by the name of a dimension that varies."""
        self.mechanism.check_one()

    @property
    def travels(self) -> Mapping[str, tuple[float, float]]:
        """The travel of slides is that of one mechanism."""
        self.check_one()
        return {}

    def read_all(self, results: Sequence[Result], kept: int = -1) -> NDArray[np.float64]:
        """Return a new table of results, with a row for each pose.

        Without results its one column has 1 where the links close.
        """
        widths = [len(self.solver.recorded.parts(result)) for result in results]
        table = np.full((math.prod(self.shape), sum(widths) or 1), math.nan)
        for mechanism, at in single_ones(self.mechanism, self.shape):
            inputs = inputs_at(self.inputs, self.shape, at)
            if at.size <= OFTEN:
                rows = zip(*(values.tolist() for values in inputs.values()), strict=True)
                solver = solver_of(mechanism)
                table[at] = [_row(solver, results, widths, row) for row in rows]
            else:
                motion = solve(mechanism, **inputs)
                table[at] = motion.read_all(results) if results else motion.assembled[:, None]
        return table


def _row(
    solver: AnySolver, results: Sequence[Result], widths: Sequence[int], inputs: tuple[float, ...]
) -> list[float]:
    """Return the results of one pose, each with its parts; NaN where there is none."""
    evaluation = solver.evaluation(inputs)
    try:
        closes = not any(math.isnan(x) for x in inputs) and bool(evaluation.pose)
    except OpenLoopError:
        closes = False
    if not results:
        return [float(closes)]
    row: list[float] = []
    for result, width in zip(results, widths, strict=True):
        if closes and not (result[2] == "coriolis" and not solver.on_turning_link(result[1])):
            parts = [x + 0.0 for x in parts_of([solver.evaluate(result, evaluation)])]
        else:
            parts = [math.nan]
        row += parts if all(map(math.isfinite, parts)) else [math.nan] * width
    return row


class VariedMotion(_Varied, Motion[Any, Any, Any]):
    """The motions of mechanisms in the plane."""


class VariedMotionInSpace(_Varied, MotionInSpace[Any, Any]):
    """The motions of mechanisms in space."""


def kind_of(solver: AnySolver) -> type[Motion[Any, Any, Any]]:
    """Return the class of the motions of such mechanisms."""
    return VariedMotion if isinstance(solver, Solver) else VariedMotionInSpace
