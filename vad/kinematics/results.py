"""The results of a motion: of one link, joint, point or slide, as text, and as data for JSON.

Values are in the units of the user; they are numbers or new arrays, never views of the solution.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any, Generic

import numpy as np

from vad.kinematics.numbers import Number, Real, Vector
from vad.units import scene_unit
from vad.written import DIGITS, typed

if TYPE_CHECKING:
    from vad.kinematics.solution import Solution
    from vad.mechanisms.mechanism import Mechanism


class Link(Generic[Real]):
    """The motion of one link: ``angle`` in degrees within [0, 360), ``omega``, ``alpha``.

    A body that turns about no fixed line has no angle, and its rates are vectors x, y, z.
    """

    def __init__(self, motion: Solution[Any], name: str) -> None:
        self._motion = motion
        self._name = name

    @property
    def angle(self) -> Real:
        """Its direction in degrees, counter-clockwise from +x."""
        return self._motion.read(("link", self._name, "angle"))

    @property
    def omega(self) -> Real:
        """Its angular velocity in rad/s."""
        return self._motion.read(("link", self._name, "omega"))

    @property
    def alpha(self) -> Real:
        """Its angular acceleration in rad/s²."""
        return self._motion.read(("link", self._name, "alpha"))


class Joint(Generic[Real]):
    """The motion of one joint in space: ``angle`` in degrees within [0, 360), and its rates."""

    def __init__(self, motion: Solution[Any], letter: str) -> None:
        self._motion = motion
        self._letter = letter

    @property
    def angle(self) -> Real:
        """The angle between the bodies that it joins, in degrees."""
        return self._motion.read(("joint", self._letter, "angle"))

    @property
    def omega(self) -> Real:
        """Their relative angular velocity in rad/s."""
        return self._motion.read(("joint", self._letter, "omega"))

    @property
    def alpha(self) -> Real:
        """The second derivative of the angle in rad/s²."""
        return self._motion.read(("joint", self._letter, "alpha"))


class Point(Generic[Vector]):
    """The motion of one point in the user's length unit: x + iy, or in space x, y, z."""

    def __init__(self, motion: Solution[Any], letter: str) -> None:
        self._motion = motion
        self._letter = letter

    @property
    def position(self) -> Vector:
        """Where it is."""
        return self._motion.read(("point", self._letter, "position"))

    @property
    def velocity(self) -> Vector:
        """Its velocity."""
        return self._motion.read(("point", self._letter, "velocity"))

    @property
    def acceleration(self) -> Vector:
        """Its acceleration."""
        return self._motion.read(("point", self._letter, "acceleration"))


class Slider(Generic[Real]):
    """The motion of one slide along its line, in the user's length unit."""

    def __init__(self, motion: Solution[Any], name: str) -> None:
        self._motion = motion
        self._name = name

    @property
    def position(self) -> Real:
        """Its signed distance from the zero of its line."""
        return self._motion.read(("slide", self._name, "position"))

    @property
    def velocity(self) -> Real:
        """Its velocity along the line."""
        return self._motion.read(("slide", self._name, "velocity"))

    @property
    def acceleration(self) -> Real:
        """Its acceleration along the line."""
        return self._motion.read(("slide", self._name, "acceleration"))

    @property
    def travel(self) -> tuple[float, float]:
        """The least and the greatest position over all poses of the mechanism that close."""
        return self._motion.travels[self._name]

    @property
    def coriolis(self) -> Real | None:
        """The magnitude of its Coriolis component 2·ω·v, or None on a line that does not turn."""
        if not self._motion.solver.on_turning_link(self._name):
            return None
        return self._motion.read(("slide", self._name, "coriolis"))


def units(length_unit: str) -> dict[str, str]:
    """Return the unit of every quantity."""
    quantities = ("length", "angle", "omega", "alpha", "velocity", "acceleration")
    return {quantity: scene_unit(quantity, length_unit) for quantity in quantities}


def place_unit(mechanism: Mechanism) -> str:
    """Return the unit of the driver's place, with the space before it."""
    return "°" if "angle" in mechanism.inputs else f" {mechanism.length_unit}"


def plain(value: Number) -> Any:
    """Return a result as JSON holds it: numbers, [x, y] or [x, y, z], nested lists for arrays."""
    if isinstance(value, np.ndarray):
        if np.iscomplexobj(value):
            value = np.stack([value.real, value.imag], axis=-1)
        return (value + 0.0).tolist()
    if isinstance(value, complex):
        return [value.real + 0.0, value.imag + 0.0]
    return value + 0.0


def table(data: dict[str, Any], mechanism: Mechanism, digits: int = DIGITS) -> str:
    """Return the results of `Motion.to_dict` as aligned columns of text."""
    unit = data["units"]
    titled = f"{mechanism.title}  ({_inputs(data)})"
    rows = partial(block, digits=digits)
    turning = [f"{name}, {unit[name]}" for name in ("angle", "omega", "alpha")]
    names = ("position", "velocity", "acceleration")
    sliding = [f"{name}, {unit.get(name, unit['length'])}" for name in names]
    if any("coriolis" in slide for slide in data["slides"].values()):
        sliding.append(f"coriolis, {unit['acceleration']}")
    links = {f"{name} {mechanism.links[name]}": link for name, link in data["links"].items()}
    joints = {f"{name} {mechanism.joints[name]}": of for name, of in data.get("joints", {}).items()}
    slides = {f"{name} {mechanism.slides[name]}": each for name, each in data["slides"].items()}
    bodies = {name: link for name, link in links.items() if "angle" not in link}
    lines = {name: link for name, link in links.items() if name not in bodies}
    axes = "xyz"[: max(len(point["position"]) for point in data["points"].values())]
    moving = [("", unit["length"]), ("v_", unit["velocity"]), ("a_", unit["acceleration"])]
    spinning = [(f"{name}_", unit[name]) for name in ("omega", "alpha")]
    blocks = [
        rows(["link", *turning], lines),
        rows(["body", *_by_axis(spinning, axes)], bodies),
        rows(["joint", *turning], joints),
        rows(["slide", *sliding], slides),
        rows(["point", *_by_axis(moving, axes)], data["points"]),
    ]
    return "\n\n".join([titled, *filter(None, blocks)])


def _by_axis(quantities: list[tuple[str, str]], axes: str) -> list[str]:
    return [f"{name}{axis}, {unit}" for name, unit in quantities for axis in axes]


def block(head: list[str], rows: dict[str, dict[str, Any]], digits: int = DIGITS) -> str:
    """Return rows under a head, a vector's parts in columns of their own; nothing without rows."""
    cells = [
        [
            name,
            *(
                _number(part, "°" if quantity == "angle" else "", digits)
                for quantity, value in row.items()
                for part in _parts(value)
            ),
        ]
        for name, row in rows.items()
    ]
    return _columns([head, *cells]) if cells else ""


def _parts(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]


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


def _number(value: Any, unit: str = "", digits: int = DIGITS) -> str:
    return typed(value, unit, digits) if isinstance(value, float) else str(value)


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
