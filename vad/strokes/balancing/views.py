"""A shaft from its end and, below, from the side: where its masses or cranks are."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from vad.balancing.shaft import Mass
from vad.strokes.arithmetic import Figure
from vad.strokes.balancing.scene import Pen
from vad.strokes.sentences import SentencePart, Unit
from vad.strokes.sheet import Arrow, Curve, Dot, Kind, Note

#: Of the end view's radius: the length of the side view, its depth below, half the height of a
#: plane, and the line of reference.
LENGTH, BELOW, HALF, REFERENCE = 2.3, 1.75, 0.17, 1.15


class Arm(NamedTuple):
    """What turns with a shaft: a name, its place in the end view, its plane.

    ``found`` tells whether it was found, ``moved`` whether its plane was.
    """

    name: str
    at: complex
    plane: float | None
    found: bool
    moved: bool = False


def end_view(pen: Pen, axis: str, radius: float) -> None:
    """Draw the axis of the shaft and the line from which angles are measured."""
    pen.draw("fixed", f"{axis}.fixed", Dot(0j), "balance axis", label=axis, axis=axis)
    line = Curve((0j, REFERENCE * radius + 0j))
    pen.draw("guide", "reference", line, "balance reference")


def arm(pen: Pen, each: Arm, phrase: str, **parts: object) -> None:
    """Draw the arm of a mass or a crank in the end view."""
    pen.draw(
        "result" if each.found else "known",
        f"{each.name}.arm",
        Arrow(0j, each.at, "", each.name),
        phrase,
        link=each.name,
        component="link",
        reveals=(each.name,) if each.found else (),
        letter=each.name,
        **parts,  # type: ignore[arg-type]
    )


def side_view(pen: Pen, arms: Sequence[Arm], radius: float, unit: str) -> tuple[Note, ...]:
    """Draw the planes of masses along the shaft; nothing where all are in one plane."""
    planes = [each.plane for each in arms if each.plane is not None]
    low, high = min(planes, default=0.0), max(planes, default=0.0)
    if low == high:
        return ()
    down, scale = -1j * BELOW * radius, LENGTH * radius / (high - low)

    def at(plane: float) -> complex:
        return down + scale * (plane - 0.5 * (low + high))

    ends = at(low) - 0.1 * radius, at(high) + 0.1 * radius
    pen.draw("fixed", "side.shaft", Curve(ends), "balance side", component="link")
    for plane in sorted(set(planes)):
        own = [each for each in arms if each.plane == plane]
        names = ", ".join(each.name for each in own)
        half = 1j * HALF * radius
        tick = Curve((at(plane) - half, at(plane) + half), far=all(each.found for each in own))
        name, link = f"{own[0].name}.plane", own[0].name
        kind: Kind = "result" if own[0].moved else "known"
        pen.draw(
            kind, name, tick, "balance plane", link=link, label=names, component="link",
            letter=names,
        )  # fmt: skip
    return (Note(at(0.5 * (low + high)) - 0.4j * radius, _written(planes, unit)),)


def _written(planes: Sequence[float], unit: str) -> str:
    return f"{max(planes) - min(planes):g} {unit}"


def place_of(mass: Mass) -> complex:
    """Return where a mass is in the end view, with the shaft at 0°."""
    return (mass.radius or 0.0) * (mass.way or 1 + 0j)


def numbers_of(mass: Mass, unit: str, clockwise: bool = False) -> dict[str, SentencePart]:
    """Return the numbers of a mass for a sentence."""
    angle = mass.angle or 0.0
    return {
        "mass": Figure(mass.mass or 0.0, "kg", given=True),
        "radius": Figure(mass.radius or 0.0, unit, given=True),
        "angle": Figure((-angle if clockwise else angle) % 360.0, "°", given=True),
        "unit": Unit(unit),
    }
