"""Forces as data for JSON, and as a table in plain text."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import TYPE_CHECKING, Any

from vad.kinematics.results import block, plain
from vad.written import DIGITS

if TYPE_CHECKING:
    from vad.statics.forces import Forces, JointForce


def listed(found: Forces[Any, Any, Any]) -> dict[str, Any]:
    """Return forces as JSON holds them."""
    rubbing = {"friction": _joints(found.friction)} if found.solver.rough else {}
    return {
        "drive": plain(found.drive),
        "joints": _joints(found.joints),
        **rubbing,
        "shaking": {"force": plain(found.shaking_force), "moment": plain(found.shaking_moment)},
        "loads": [_acting(found, number) for number in range(len(found.acting))],
        "units": {"force": "N", "moment": found.moment_unit, "drive": found.drive_unit},
    }


def _joints(joints: Iterable[JointForce]) -> list[dict[str, Any]]:
    return [
        {"of": one, "on": other, "at": point, "force": plain(force)}
        for one, other, point, force in joints
    ]


def _acting(found: Forces[Any, Any, Any], number: int) -> dict[str, Any]:
    kind, body, point, _, name = found.acting[number]
    value = plain(found.acts(number))
    named: dict[str, Any] = {"name": name} if name else {}
    named |= {"kind": kind, "on": body}
    return named | ({"at": point, "force": value} if point else {"couple": value})


def table(data: dict[str, Any], driver: str, digits: int = DIGITS) -> str:
    """Return forces, as `listed` has them, in aligned columns of text."""
    newton, moment = data["units"]["force"], data["units"]["moment"]
    axes = [f"{axis}, {newton}" for axis in ("x", "y", "size")]
    rows = partial(block, digits=digits)
    blocks = [
        rows(["drive", data["units"]["drive"]], {driver: {"drive": data["drive"]}}),
        rows(["force in a joint", *axes], _rows(data["joints"])),
        rows(["friction", *axes], _rows(data.get("friction", []))),
        rows(
            ["shaking", *axes[:2], f"moment, {moment}"],
            {"frame": {"force": data["shaking"]["force"], "moment": data["shaking"]["moment"]}},
        ),
    ]
    return "\n\n".join(filter(None, blocks))


def _rows(joints: list[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    return {
        f"{each['of']} on {each['on']} at {each['at']}": {
            "force": each["force"],
            "size": abs(complex(*each["force"])),
        }
        for each in joints
    }
