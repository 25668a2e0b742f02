"""What a page knows of its mechanism's results: for its readers, and for programs that ask it.

A page answers as ``vad solve --json`` does.  It has that object once, with the number of an output
of its program wherever a result stands.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from vad.kinematics.traced import Traced

#: The parts of that object whose numbers follow from the pose.
RESULTS = ("links", "joints", "points", "slides", "forces")
_SECOND = ("alpha", "acceleration")


def template(found: Mapping[str, Any], parameters: Mapping[str, Any], place: Any) -> dict[str, Any]:
    """Return the results of a traced motion, with the number of its output for each of them.

    Parameters
    ----------
    found
        `vad.Motion.to_dict` of the traced motion.
    parameters
        Those of the mechanism itself.
    place
        The function from a traced number to the number of its output.
    """
    whole = {"parameters": dict(parameters), "input": list(found["input"])}
    results = {part: _placed(found[part], place) for part in RESULTS if part in found}
    return {**found, **whole, **results}


def _placed(found: Any, place: Callable[[float], int]) -> Any:
    if isinstance(found, dict):
        return {name: _placed(each, place) for name, each in found.items()}
    if isinstance(found, list):
        return [_placed(each, place) for each in found]
    return found if isinstance(found, str) else place(found)


def proofs(found: Mapping[str, Any]) -> tuple[list[float], list[float]]:
    """Return numbers that exist where the links close, and numbers that exist where rates do."""
    places = [each for point in found["points"].values() for each in point["position"]]
    rates = [
        each
        for part in ("links", "slides")
        for result in found[part].values()
        for name in _SECOND
        for each in _numbers(result.get(name, []))
    ]
    return _traced(places), _traced(rates)


def _numbers(value: Any) -> list[float]:
    return value if isinstance(value, list) else [value]


def _traced(numbers: list[float]) -> list[float]:
    return [each for each in numbers if isinstance(each, Traced)]
