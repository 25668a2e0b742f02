"""Velocity and acceleration polygons, drawn stroke by stroke as at the board.

Four verbs: `solve` a mechanism, `draw` its sheet, `animate` it as a lesson, `save` either one;
`turn` is a film of a whole turn, `multiples` a few poses side by side, `still` one step of a
lesson, `sheet_from_json` a sheet that was saved; `batch` makes sheets by the hundred, and `sweep`
solves arrays that are larger than memory.  `show` shows any of them in a browser; a notebook does
so by itself.  `widget` is a mechanism that is turned by hand in a notebook.
Each part is loaded when it is first used.

>>> import vad
>>> motion = vad.solve(vad.SliderCrank(crank=60, rod=140), angle=60, omega=10)
>>> round(motion.link("rod").omega, 4)
-2.3077
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from vad.balancing.balance import Balance
    from vad.balancing.engine import Engine
    from vad.batches.batch import batch
    from vad.batches.quiz import quiz
    from vad.batches.sweep import sweep
    from vad.designs.design import Design, Solution, design
    from vad.errors import (
        AssemblyError,
        DeadCentreError,
        ExportError,
        InputError,
        UsageError,
        VadError,
    )
    from vad.export import save
    from vad.export.sheet_json import sheet_from_json
    from vad.files.balancing import balance, engine
    from vad.files.loading import load, mechanism
    from vad.kinematics.centres import Centres, centres
    from vad.kinematics.klein import klein
    from vad.kinematics.motion import Motion, Motions, solve
    from vad.lecture.lesson import Lesson, Still, animate, still
    from vad.lecture.turn import Turn, turn
    from vad.mechanisms import MECHANISMS, Mechanism
    from vad.mechanisms.crank_slotted_lever import CrankSlottedLever
    from vad.mechanisms.double_slider import DoubleSlider
    from vad.mechanisms.elliptical_trammel import EllipticalTrammel
    from vad.mechanisms.four_bar import FourBar
    from vad.mechanisms.gate_actuator import GateActuator
    from vad.mechanisms.hooke_joint import HookeJoint
    from vad.mechanisms.rssr import RSSR
    from vad.mechanisms.scotch_yoke import ScotchYoke
    from vad.mechanisms.slider_crank import SliderCrank
    from vad.mechanisms.spatial_four_bar import SpatialFourBar
    from vad.mechanisms.spherical_four_bar import SphericalFourBar
    from vad.mechanisms.whitworth import Whitworth
    from vad.merits.merit import Merit, merit
    from vad.showing import show, widget
    from vad.statics.forces import Forces, forces
    from vad.strokes.draw import draw
    from vad.strokes.multiples import Multiples, multiples
    from vad.strokes.sheet import Sheet

__version__ = "0.1.0"

__all__ = [
    "MECHANISMS",
    "RSSR",
    "AssemblyError",
    "Balance",
    "Centres",
    "CrankSlottedLever",
    "DeadCentreError",
    "Design",
    "DoubleSlider",
    "EllipticalTrammel",
    "Engine",
    "ExportError",
    "Forces",
    "FourBar",
    "GateActuator",
    "HookeJoint",
    "InputError",
    "Lesson",
    "Mechanism",
    "Merit",
    "Motion",
    "Motions",
    "Multiples",
    "ScotchYoke",
    "Sheet",
    "SliderCrank",
    "Solution",
    "SpatialFourBar",
    "SphericalFourBar",
    "Still",
    "Turn",
    "UsageError",
    "VadError",
    "Whitworth",
    "animate",
    "balance",
    "batch",
    "centres",
    "design",
    "draw",
    "engine",
    "forces",
    "klein",
    "load",
    "mechanism",
    "merit",
    "multiples",
    "quiz",
    "save",
    "sheet_from_json",
    "show",
    "solve",
    "still",
    "sweep",
    "turn",
    "widget",
]

# Where a name is when it is first used; mechanism classes are found by themselves.
_HOMES = {
    "solve": "vad.kinematics.motion",
    "Motion": "vad.kinematics.motion",
    "Motions": "vad.kinematics.motion",
    "centres": "vad.kinematics.centres",
    "Centres": "vad.kinematics.centres",
    "klein": "vad.kinematics.klein",
    "forces": "vad.statics.forces",
    "Forces": "vad.statics.forces",
    "balance": "vad.files.balancing",
    "Balance": "vad.balancing.balance",
    "engine": "vad.files.balancing",
    "Engine": "vad.balancing.engine",
    "merit": "vad.merits.merit",
    "Merit": "vad.merits.merit",
    "design": "vad.designs.design",
    "Design": "vad.designs.design",
    "Solution": "vad.designs.design",
    "draw": "vad.strokes.draw",
    "Sheet": "vad.strokes.sheet",
    "multiples": "vad.strokes.multiples",
    "Multiples": "vad.strokes.multiples",
    "animate": "vad.lecture.lesson",
    "Lesson": "vad.lecture.lesson",
    "turn": "vad.lecture.turn",
    "Turn": "vad.lecture.turn",
    "still": "vad.lecture.lesson",
    "Still": "vad.lecture.lesson",
    "save": "vad.export",
    "batch": "vad.batches.batch",
    "quiz": "vad.batches.quiz",
    "sweep": "vad.batches.sweep",
    "show": "vad.showing",
    "widget": "vad.showing",
    "sheet_from_json": "vad.export.sheet_json",
    "load": "vad.files.loading",
    "mechanism": "vad.files.loading",
    "MECHANISMS": "vad.mechanisms",
    "Mechanism": "vad.mechanisms",
    "VadError": "vad.errors",
    "InputError": "vad.errors",
    "UsageError": "vad.errors",
    "AssemblyError": "vad.errors",
    "DeadCentreError": "vad.errors",
    "ExportError": "vad.errors",
}

if not TYPE_CHECKING:  # for a type checker, a name that is not imported above is a mistake

    def __getattr__(name: str) -> object:
        """Load a verb, a class or an error when it is first asked for."""
        from importlib import import_module

        if name in _HOMES:
            value = globals()[name] = getattr(import_module(_HOMES[name]), name)
            return value
        message = f"module 'vad' has no attribute {name!r}"
        from vad.discovery import names_in

        if name.startswith("_") or name in names_in():  # Python asks so for a module to be imported
            raise AttributeError(message, name=name)
        from vad.mechanisms import class_named

        kind = class_named(name)
        if kind is not None:
            if kind.__module__.startswith("vad."):  # that of a user may be declared anew
                globals()[name] = kind
            return kind
        from vad.errors import unknown

        hint = unknown("name", name, __dir__()).hint
        raise AttributeError(f"{message}; {hint}", name=name)


def __dir__() -> list[str]:
    from vad.mechanisms import MECHANISMS

    mechanisms = {kind.__name__ for kind in MECHANISMS.values()}
    return sorted({*__all__, *mechanisms, "__version__"})
