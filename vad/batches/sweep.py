"""The verb `sweep`: poses by the million, solved block by block where each block is stored.

The inputs are numpy or Dask arrays; the result is one array of the same kind, with a field for each
result.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Mapping
from dataclasses import fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vad import gate
from vad.errors import InputError, UsageError, quoted, unknown
from vad.kinematics.any_solver import Result
from vad.kinematics.motion import Motion, MotionInSpace, solve
from vad.kinematics.varied import inputs_at, representative, single_ones
from vad.mechanisms import Mechanism
from vad.merits.advantage import advantage
from vad.merits.figures import ALONE as FIGURES
from vad.merits.figures import figure, is_figure, merit_of
from vad.merits.named_pins import is_of_pins, type_of, values_of
from vad.statics.forces import DRIVE, FORCE, Forces, forces
from vad.statics.solver import KINDS

Solved = Motion[Any, Any, Any]
Loaded = Forces[Any, Any, Any]
#: The results whose names have no full stop.
_ADVANTAGE = "advantage"
_ALONE = (DRIVE, "transmission", _ADVANTAGE, *FIGURES)
_HINT = 'as in ("rocker.omega", "C.acceleration")'


def sweep(
    mechanism: Mechanism,
    results: Iterable[str] | str,
    *,
    pins: Mapping[str, Any] | None = None,
    loads: Iterable[Any] = (),
    masses: Mapping[str, Any] | None = None,
    gravity: Any = None,
    friction: Mapping[str, Any] | None = None,
    **inputs: Any,
) -> Any:
    """Solve chosen results over arrays of inputs; Dask arrays are solved when they are computed.

    Parameters
    ----------
    mechanism
        The mechanism with its dimensions, which may be arrays, too, numpy's or Dask's.
    results
        Their names: that of a link, point or slide, a full stop, and one of what `Motion` has of
        it; ``"rocker.omega"``, ``"C.acceleration"``.  Of forces: ``"drive"``, and that of a body on
        another one, ``"coupler.rocker.force"``, and ``"advantage"``, the mechanical advantage of
        one load.  ``"transmission"`` is the transmission angle.  Figures of merit are the same in
        all poses of a mechanism: ``"stroke"``, ``"time_ratio"``, ``"forward_angle"``,
        ``"return_angle"``, and of any result or ``"transmission"`` the ends of its range and the
        places where they occur, as in ``"transmission.least"``, ``"C.velocity.largest_at"``.
        ``"B.rubbing"`` is the velocity of rubbing at a pin, ``"C.coupler.rod.rubbing"`` where it
        joins more than two bodies; ``"coupler.slowest.velocity"``, ``.position`` and ``.distance``
        are those of the slowest point of a link, as `merit` has them.
    pins
        The diameters of the pins whose rubbing is asked for, by their points: ``{"B": 50}``.
    loads, masses, gravity, friction
        As for `forces`: numbers that are the same in all poses.
    **inputs
        As for `solve`; any of them may be a Dask array.

    Returns
    -------
    structured array
        One field for each result, by its name: real, of points complex x + iy, of vectors in space
        three numbers; NaN where the links do not close.  With the broadcast shape of the inputs; a
        Dask array, with their chunks, if one of them is one.  Nothing of that is computed yet, and
        each block is solved by itself, for all results at once, so that more may be asked for than
        memory holds.

    Raises
    ------
    vad.errors.UsageError
        For an unknown result or input.
    vad.errors.InputError
        For inputs that are no numbers, or do not broadcast; and as for `forces`.

    Examples
    --------
    >>> import numpy as np, vad
    >>> swept = vad.sweep(vad.ScotchYoke(), "yoke.velocity", angle=np.array([0.0, 90.0]))
    >>> swept["yoke.velocity"]
    array([   0., -500.])
    """
    names, pins = _names(results), {} if pins is None else pins
    burden = {"loads": loads, "masses": masses, "gravity": gravity, "friction": friction}
    varied = mechanism.varied if isinstance(mechanism, Mechanism) else {}
    lazy = {name: value for name, value in (inputs | varied).items() if gate.is_lazy(value)}
    one = _one(mechanism) if varied else mechanism
    known = {name: 0.0 if name in lazy else value for name, value in inputs.items()}
    motion = _loaded(solve(one, **known), names, burden)  # checks what is known by now
    dtype = np.dtype([_field(motion, name, pins) for name in names])
    if not lazy:
        return (
            _swept(mechanism, inputs, dtype, burden, pins)
            if varied
            else _solved(motion, dtype, pins)
        )
    da: Any = sys.modules["dask.array"]

    for name, value in lazy.items():
        if value.dtype.kind not in "iuf":
            raise InputError(f"{name}: must be an array of numbers, got one of {value.dtype}")
    given = inputs | varied
    many = {name: da.asarray(value) for name, value in given.items() if np.ndim(value)}
    single = {name: value for name, value in given.items() if name not in many}
    try:
        arrays = da.broadcast_arrays(*many.values())
    except ValueError:
        shapes = ", ".join(f"{name} {value.shape}" for name, value in many.items())
        raise InputError(f"shapes of the inputs do not broadcast: {shapes}") from None
    return da.map_blocks(
        _block,
        *arrays,
        mechanism=one,
        names=tuple(many),
        single=single,
        results=dtype,
        burden=burden,
        pins=pins,
        dtype=dtype,
        meta=np.empty((0,) * arrays[0].ndim, dtype),
    )


def _block(
    *arrays: NDArray[Any],
    mechanism: Mechanism,
    names: tuple[str, ...],
    single: dict[str, Any],
    results: np.dtype[Any],
    burden: dict[str, Any],
    pins: Mapping[str, Any],
) -> NDArray[Any]:
    """Solve one block of inputs, which are in ``arrays`` under their ``names``."""
    given = single | dict(zip(names, arrays, strict=True))
    varied = {name: given.pop(name) for name in list(given) if name not in mechanism.inputs}
    return _swept(replace(mechanism, **varied), given, results, burden, pins)


def _swept(
    mechanism: Mechanism,
    inputs: dict[str, Any],
    results: np.dtype[Any],
    burden: dict[str, Any],
    pins: Mapping[str, Any],
) -> NDArray[Any]:
    """Solve arrays of inputs.

    Where dimensions vary, forces, figures of merit, rubbing and slowest points are found for one
    mechanism after another.
    """
    motion, names = solve(mechanism, **inputs), results.names or ()
    alone = _has_forces(names) or any(is_figure(name) or is_of_pins(name) for name in names)
    if not mechanism.varied or not alone:
        return _solved(_loaded(motion, names, burden), results, pins)
    found = np.full(math.prod(motion.shape), np.nan, results)
    for single, at in single_ones(mechanism, motion.shape):
        one = solve(single, **inputs_at(motion.inputs, motion.shape, at))
        found[at] = _solved(_loaded(one, names, burden), results, pins)
    return found.reshape(motion.shape)


def _one(mechanism: Mechanism) -> Mechanism:
    """Return one mechanism with the names of all for which one with arrays stands."""
    lazy = {name: value for name, value in mechanism.varied.items() if gate.is_lazy(value)}
    defaults: dict[str, Any] = {
        each.name: each.default for each in fields(mechanism) if each.name in lazy
    }
    return representative(replace(mechanism, **defaults))


def _loaded(motion: Solved, names: Iterable[str], burden: dict[str, Any]) -> Solved | Loaded:
    """Return the forces of a motion if one of the results is a force, or else the motion."""
    return forces(motion, **burden) if _has_forces(names) else motion


def _has_forces(names: Iterable[str]) -> bool:
    return any(name in (DRIVE, _ADVANTAGE) or name.endswith(FORCE) for name in names)


def _solved(motion: Solved | Loaded, dtype: np.dtype[Any], pins: Mapping[str, Any]) -> NDArray[Any]:
    """Return the results and the figures of merit by which the fields are named."""
    names = dtype.names or ()
    figures = [name for name in names if is_figure(name) or name == _ADVANTAGE]
    of_pins = [name for name in names if is_of_pins(name)]
    others = [name for name in names if name not in (*figures, *of_pins)]
    results = np.dtype([(name, dtype[name]) for name in others])
    if len(others) == len(names):
        return _poses(motion, dtype)
    moving = motion.motion if isinstance(motion, Forces) else motion
    found = np.full(moving.shape if motion.many else (), np.nan, dtype)
    if results.names:
        solved = _poses(motion, results)
        for name in results.names:
            found[name] = solved[name]
    for name, values in values_of(moving, of_pins, pins).items():
        found[name] = values
    merit = merit_of(moving) if any(map(is_figure, figures)) else None
    for name in figures:
        found[name] = (
            _advantage(motion) if merit is None or name == _ADVANTAGE else figure(merit, name)
        )
    return found


def _advantage(found: Any) -> Any:
    """Return the mechanical advantage of the one load; NaN where there is none."""
    if len(found.acting) != 1:
        hint = 'as in loads=["80 N @ 150 at C"]'
        raise InputError(f"{_ADVANTAGE}: needs one load, got {len(found.acting)}", hint)
    value = advantage(found)
    return np.nan if value is None else value


def _poses(motion: Solved | Loaded, dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return results of each pose: of many poses in one calculation."""
    names = dtype.names or ()
    results = [_result(motion, name) for name in names]
    if motion.many:
        table = motion.read_all(results)
        return table.view(dtype).reshape(motion.shape)
    found = np.empty((), dtype)
    for name, (kind, part, quantity) in zip(names, results, strict=True):
        if kind in KINDS or kind == "dyad":
            found[name] = motion.read((kind, part, quantity))
        else:
            moving = motion.motion if isinstance(motion, Forces) else motion
            found[name] = getattr(getattr(moving, kind)(part), quantity)
    return found


def _names(results: Iterable[str] | str) -> list[str]:
    listed = gate.several("results", results, "names of results", _HINT)
    if not listed:
        raise UsageError("results: none given", _HINT)
    for name in listed:
        if not isinstance(name, str) or ("." not in name and name not in _ALONE):
            message = f"results: {quoted(name)} is no result"
            raise UsageError(message, "as in rocker.omega or C.acceleration")
    return list(dict.fromkeys(listed))


def _field(
    solution: Solved | Loaded, name: str, pins: Mapping[str, Any]
) -> tuple[str, type, tuple[int, ...]]:
    """Return a result's name, type and shape: of a vector in space, three numbers."""
    if is_figure(name) or name == _ADVANTAGE:
        return name, float, ()
    if is_of_pins(name):
        moving = solution.motion if isinstance(solution, Forces) else solution
        return name, type_of(moving, name, pins), ()
    kind, part, _ = _result(solution, name)
    if kind in KINDS:
        return name, float if kind == DRIVE else complex, ()
    vector = kind == "point" or part in solution.solver.bodies
    if vector and isinstance(solution, MotionInSpace):
        return name, float, (3,)
    return name, complex if vector else float, ()


def _result(solution: Solved | Loaded, name: str) -> Result:
    """Return the link, joint, point or slide that has a result, and which of its quantities."""
    motion = solution.motion if isinstance(solution, Forces) else solution
    known = motion.results
    if isinstance(solution, Forces):
        known |= solution.results
    if name not in known:
        raise unknown("result", name, known)
    return known[name]
