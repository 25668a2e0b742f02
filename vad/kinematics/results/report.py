"""The results of a motion as text and as plain data for JSON."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from vad.kinematics.numbers import Number
from vad.units import scene_unit
from vad.written import typed

if TYPE_CHECKING:
    from vad.mechanisms.mechanism import Mechanism

_DIGITS = 12  # of the text table, from which numbers are copied


def units(length_unit: str) -> dict[str, str]:
    """Return the unit of every quantity."""
    quantities = ("length", "angle", "omega", "alpha", "velocity", "acceleration")
    return {quantity: scene_unit(quantity, length_unit) for quantity in quantities}


def place_unit(mechanism: Mechanism) -> str:
    """Return the unit of the driver's place, with the space before it."""
    return "°" if "angle" in mechanism.inputs else f" {mechanism.length_unit}"


def plain(value: Number) -> Any:
    """Return a result as JSON holds it: numbers, [x, y] pairs, nested lists for arrays."""
    if isinstance(value, np.ndarray):
        if np.iscomplexobj(value):
            value = np.stack([value.real, value.imag], axis=-1)
        return (value + 0.0).tolist()
    if isinstance(value, complex):
        return [value.real + 0.0, value.imag + 0.0]
    return value + 0.0


def table(data: dict[str, Any], mechanism: Mechanism) -> str:
    """Return the results of `Motion.to_dict` as aligned columns of text."""
    unit = data["units"]
    blocks = [f"{mechanism.title}  ({_inputs(data)})"]
    if data["links"]:
        head = [
            "link",
            f"angle, {unit['angle']}",
            f"omega, {unit['omega']}",
            f"alpha, {unit['alpha']}",
        ]
        rows = [
            [
                f"{name} {mechanism.links[name]}",
                *(_number(x, unit[kind]) for kind, x in link.items()),
            ]
            for name, link in data["links"].items()
        ]
        blocks.append(_columns([head, *rows]))
    lengths = [unit["length"], unit["velocity"], unit["acceleration"]]
    names = ["position", "velocity", "acceleration"]
    heads = [f"{name}, {of}" for name, of in zip(names, lengths, strict=True)]
    if data["slides"]:
        head = ["slide", *heads]
        if any("coriolis" in slide for slide in data["slides"].values()):
            head.append(f"coriolis, {unit['acceleration']}")
        rows = [
            [f"{name} {mechanism.slides[name]}", *(_number(x) for x in slide.values())]
            for name, slide in data["slides"].items()
        ]
        blocks.append(_columns([head, *rows]))
    rows = [
        [letter, *(_number(part) for pair in point.values() for part in pair)]
        for letter, point in data["points"].items()
    ]
    axes = (("x", "y"), ("v_x", "v_y"), ("a_x", "a_y"))
    of_points = [f"{axis}, {of}" for pair, of in zip(axes, lengths, strict=True) for axis in pair]
    blocks.append(_columns([["point", *of_points], *rows]))
    return "\n\n".join(blocks)


def _inputs(data: dict[str, Any]) -> str:
    unit = data["units"] | {"position": data["units"]["length"]}
    given = [
        f"{name} {_number(value, unit[name])} {unit[name]}" for name, value in data["input"].items()
    ]
    assembly = data["assembly"]
    if isinstance(assembly, str):
        given.append(assembly)
    elif assembly:
        given += [f"{point} {place}" for point, place in assembly.items()]
    return ", ".join(given)


def _number(value: Any, unit: str = "") -> str:
    return typed(value, unit, _DIGITS) if isinstance(value, float) else str(value)


def _columns(rows: list[list[str]]) -> str:
    count = max(len(row) for row in rows)
    padded = [row + [""] * (count - len(row)) for row in rows]
    widths = [max(len(row[i]) for row in padded) for i in range(count)]
    lines = [
        "  ".join(
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in padded
    ]
    return "\n".join(lines)
