"""Velocity and acceleration polygons, drawn stroke by stroke as at the board.

Four verbs: `solve` a mechanism, `draw` its sheet, `animate` it as a lesson, `save` either one;
`still` is one step of a lesson.
Each part is loaded when it is first used.

>>> import vad
>>> motion = vad.solve(vad.SliderCrank(crank=60, rod=140), angle=60, omega=10)
>>> round(motion.link("rod").omega, 4)
-2.3077
"""

from importlib import import_module
from typing import Any

__version__ = "0.1.0"

_HOMES = {
    "solve": "vad.kinematics.motion",
    "Motion": "vad.kinematics.motion",
    "draw": "vad.strokes.draw",
    "animate": "vad.lecture.timeline",
    "turn": "vad.lecture.turn",
    "still": "vad.lecture.still",
    "save": "vad.export",
    "MECHANISMS": "vad.mechanisms",
    "VadError": "vad.errors",
    "InputError": "vad.errors",
    "UsageError": "vad.errors",
    "AssemblyError": "vad.errors",
    "DeadCentreError": "vad.errors",
    "ExportError": "vad.errors",
}


def __getattr__(name: str) -> Any:
    """Load a verb, an error or a mechanism class when it is first asked for."""
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    if name.startswith("_"):
        raise AttributeError(f"module 'vad' has no attribute {name!r}")
    for mechanism in import_module("vad.mechanisms").MECHANISMS.values():
        if mechanism.__name__ == name:
            return mechanism
    raise AttributeError(f"module 'vad' has no attribute {name!r}")


def __dir__() -> list[str]:
    mechanisms = import_module("vad.mechanisms").MECHANISMS.values()
    return sorted([*_HOMES, *(mechanism.__name__ for mechanism in mechanisms), "__version__"])
