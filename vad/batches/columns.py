"""Columns of a table: results and figures of merit by name, each with its unit."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import vad
from vad.export.sweep import Column
from vad.mechanisms import Mechanism
from vad.merits.figures import ENDS
from vad.statics.burden import Burden
from vad.units import scene_unit


def columns_of(mechanism: Mechanism, found: NDArray[Any], burden: Burden | None) -> list[Column]:
    """Return what `vad.sweep` has found as columns with units, a vector as one for each axis.

    Parameters
    ----------
    mechanism
        The mechanism; its dimensions do not matter.
    found
        A structured array with a field for each result.
    burden
        What the mechanism has to bear, by which its forces were found.
    """
    return [
        Column(f"{name}{axis}", _unit(mechanism, name, burden), values)
        for name in found.dtype.names or ()
        for axis, values in _by_axis(found[name])
    ]


def _by_axis(values: NDArray[Any]) -> list[tuple[str, NDArray[np.float64]]]:
    """Return the parts of vectors, each with the end of its name; numbers as they are."""
    if np.iscomplexobj(values):
        return [(" x", values.real), (" y", values.imag)]
    if values.ndim > 1:
        return [(f" {axis}", values[:, place]) for place, axis in enumerate("xyz")]
    return [("", values)]


def _unit(mechanism: Mechanism, name: str, burden: Burden | None) -> str:
    """Return the unit of a result or of a figure of merit; empty for a bare number."""
    result, _, end = name.rpartition(".")
    if end in ENDS:
        driven = next(iter(mechanism.inputs))
        return (
            scene_unit(driven, mechanism.length_unit)
            if "_at" in end
            else _unit(mechanism, result.partition(" ")[0], burden)
        )
    if name in ("time_ratio", "advantage"):
        return ""
    if name == "stroke":
        output = vad.merit(mechanism).output
        name = "slide.position" if output and output[0] == "slide" else "link.angle"
    quantity = name.rpartition(".")[2]
    if quantity == "force":
        return "N"
    if quantity == "drive":
        loads, masses, gravity, friction = burden or ((), None, None, None)
        return vad.forces(
            vad.solve(mechanism), loads=loads, masses=masses, gravity=gravity, friction=friction
        ).drive_unit
    of = {"position": "length", "distance": "length"}
    of |= {"coriolis": "acceleration", "rubbing": "velocity"}
    of |= dict.fromkeys(("transmission", "forward_angle", "return_angle"), "angle")
    return scene_unit(of.get(quantity, quantity), mechanism.length_unit)
