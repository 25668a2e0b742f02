"""Figures of merit as a table in plain text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from vad.kinematics.results import block, place_unit
from vad.written import DIGITS, typed

if TYPE_CHECKING:
    from vad.merits.merit import Merit


def table(merit: Merit, digits: int = DIGITS) -> str:
    """Return the figures of merit in aligned columns of text, with units."""
    lines, unit = _lines(merit, digits), merit.motion.mechanism.length_unit
    width = max(len(name) for name, _ in lines) + 2
    blocks = [
        "\n".join(f"{name:{width}}{said}" for name, said in lines),
        rubbing_table(merit["rubbing"], unit, digits),
        _slowest(merit["slowest"] or {}, unit, digits),
    ]
    return "\n\n".join(filter(None, blocks))


def extremes_table(merit: Merit, results: Iterable[str], digits: int = DIGITS) -> str:
    """Return the extremes of the output and of other results, with the places where they occur."""
    place = place_unit(merit.motion.mechanism).strip()
    rows = {
        name: {key: "none" if value is None else value for key, value in each.items()}
        for name, each in merit.extremes(results).items()
        if each
    }
    head = ["extremes", "least", f"at, {place}", "largest", f"at, {place}"]
    return block(head, rows, digits)


def rubbing_table(found: list[dict[str, Any]], unit: str, digits: int = DIGITS) -> str:
    """Return velocities of rubbing, as JSON has them, as a table."""
    rows = {
        f"{each['pin']}: {each['of']} on {each['against']}": {
            "diameter": each["diameter"],
            "velocity": each["velocity"],
        }
        for each in found
    }
    return block(["rubbing at a pin", f"diameter, {unit}", f"velocity, {unit}/s"], rows, digits)


def _lines(merit: Merit, digits: int) -> list[tuple[str, str]]:
    """Return the name of each figure, and what is said of it."""
    found, mechanism = dict(merit), merit.motion.mechanism
    place, transmission = place_unit(mechanism), found["transmission"]
    slides = merit.output is not None and merit.output[0] == "slide"

    def number(value: float | None, unit: str = "") -> str:
        return "" if value is None else f"{typed(value, '', digits)}{unit}"

    def ranges(ends: Sequence[Sequence[float]]) -> str:
        if merit.turns and ends == [[0.0, 360.0]]:
            return "every angle"
        return " and ".join(f"{number(low, place)} … {number(high, place)}" for low, high in ends)

    def extreme(which: str) -> str:
        if transmission is None:
            return ""
        return f"{number(transmission[which], '°')} at {number(transmission[f'{which}_at'], place)}"

    said = {
        "output": found["output"],
        "Grashof": found["grashof"],
        "closes for": ranges(found["ranges"]),
        "dead centres": ", ".join(number(each, place) for each in found["dead_centres"]),
        "stroke": number(found["stroke"], f" {mechanism.length_unit}" if slides else "°"),
        "time ratio": number(found["time_ratio"]),
        "forward angle": number(found["forward_angle"], "°"),
        "return angle": number(found["return_angle"], "°"),
        "least transmission angle": extreme("least"),
        "largest transmission angle": extreme("largest"),
    }
    if found["advantage"] is not None:
        said["mechanical advantage"] = number(found["advantage"])
    return [(name, value or "none") for name, value in said.items()]


def _slowest(found: dict[str, Any], unit: str, digits: int) -> str:
    rows = {
        name: {
            "distance": each["distance"],
            "position": each["position"],
            "speed": abs(complex(*each["velocity"])),
            "on": "yes" if each["on_link"] else "no",
        }
        for name, each in found.items()
        if each
    }
    head = [f"from its first end, {unit}", f"x, {unit}", f"y, {unit}", f"speed, {unit}/s"]
    return block(["slowest point", *head, "on the link"], rows, digits)
