"""A mechanism that was designed as a file in TOML, which every verb reads."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from vad.designs.task import Answer
from vad.files.places import words_for
from vad.kinematics.motion import solve
from vad.kinematics.numbers import ray
from vad.mechanisms import Mechanism
from vad.words import Language

Table = Mapping[str, Any]


def file_of(answer: Answer, omega: float, faults: Sequence[str] = ()) -> str:
    """Return the text of the file of an answer; its driver stands in the first position.

    Its ``faults`` between the positions are in the title.
    """
    mechanism, words = answer.mechanism, Language("en").page("DESIGN")
    title = ", ".join([mechanism.title, *(words[f"fault {fault}"] for fault in faults)])
    tables = {
        "": {"title": title, "unit": mechanism.length_unit},
        **_TABLES[mechanism.name](mechanism, answer.origin),
        "driver": {"crank": {"angle": answer.places[0], "omega": omega}},
        "assembly": _assembly(answer),
    }
    return "\n\n".join(_written(name, table) for name, table in tables.items()) + "\n"


def _slider_crank(mechanism: Any, _: complex) -> dict[str, Table]:
    return {
        "fixed": {"A": [0.0, 0.0]},
        "links": {"crank": {"AB": mechanism.crank}, "rod": {"BC": mechanism.rod}},
        "guides": {"C": {"y": mechanism.offset, "name": "slider"}},
    }


def _four_bar(mechanism: Any, origin: complex) -> dict[str, Table]:
    coupler = {"BC": mechanism.coupler}
    for name, (_, distance, angle) in mechanism.points.items():
        coupler |= {f"B{name}": distance, f"CB{name}": angle}
    return {
        "fixed": _pivots(mechanism, origin),
        "links": {
            "crank": {"AB": mechanism.crank},
            "coupler": coupler,
            "rocker": {"DC": mechanism.rocker},
        },
    }


def _quick_return(mechanism: Any, origin: complex) -> dict[str, Table]:
    """Return the tables of a slotted lever or of Whitworth's quick return."""
    fixed = _pivots(mechanism, origin)
    height, arm = mechanism.ram_height, getattr(mechanism, "lever", None)
    line = height if height is not None else fixed["D"][1]
    return {
        "fixed": fixed,
        "links": {
            "crank": {"AB": mechanism.crank},
            "lever": {"DC": mechanism.arm if arm is None else arm},
            "rod": {"CE": mechanism.rod},
        },
        "guides": {"B": {"along": "DC", "name": "block"}, "E": {"y": line, "name": "ram"}},
    }


def _pivots(mechanism: Mechanism, origin: complex) -> dict[str, list[float]]:
    """Return the places of A and D."""
    numbers = mechanism.parameters()
    return {
        "A": _pair(origin),
        "D": _pair(origin + numbers["ground"] * ray(numbers["ground_angle"])),
    }


def _assembly(answer: Answer) -> dict[str, str]:
    """Return the words for the places of the points that have two, in the first position."""
    mechanism, angle = answer.mechanism, answer.places[0]
    other = replace(mechanism, assembly={"open": "crossed", "crossed": "open"}[mechanism.assembly])
    motion, turned = (solve(each, angle=angle) for each in (mechanism, other))
    last = _LAST[mechanism.name]
    pairs = {last: [each.point(last).position for each in (motion, turned)]}
    if "lever" in mechanism.links:  # its tip could be on the other side of D
        tip = motion.point("C").position
        pairs = {"C": [tip, 2.0 * motion.point("D").position - tip], **pairs}
    return {name: words_for(*places)[0] for name, places in pairs.items()}


def _pair(vector: complex) -> list[float]:
    return [vector.real + 0.0, vector.imag + 0.0]


def _written(name: str, table: Table) -> str:
    """Return a table of the file: a row for each key, numbers in full."""
    width = max(map(len, table))
    rows = [f"{key:{width}} = {_value(value)}" for key, value in table.items()]
    return "\n".join([*([f"[{name}]"] if name else []), *rows])


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {_value(each)}" for key, each in value.items()) + " }"
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


#: The tables of each mechanism.
_TABLES = {
    "slider-crank": _slider_crank,
    "four-bar": _four_bar,
    "crank-slotted-lever": _quick_return,
    "whitworth": _quick_return,
}
#: Its point on a guide or on two links, which has two places.
_LAST = {"slider-crank": "C", "four-bar": "C", "crank-slotted-lever": "E", "whitworth": "E"}
