"""The polygons of Hooke's joint, in the plane of the shafts: bodies 1 to 4 as they turn.

They are those of a spherical four-bar whose axes are the shafts and the arms of the cross.  Its
plane, that of 2 3 4, is laid over; in the acceleration it is left out.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from vad.kinematics.numbers import fold
from vad.kinematics.space.crossed_shafts import Universal, UniversalSolver
from vad.kinematics.space.instant_axis import Z
from vad.kinematics.space.numbers import unit
from vad.strokes.arithmetic import Figure
from vad.strokes.diagram import Drawing, Spot
from vad.strokes.sentences import SentencePart
from vad.strokes.sheet import PolarInset
from vad.strokes.space.body_polygon import Bodies, polygon_of_bodies
from vad.strokes.space.body_rates import BodyRates
from vad.strokes.space.body_words import BodyWords
from vad.strokes.space.hooke_views import PLAN, pierced, pins
from vad.written import PRIME

if TYPE_CHECKING:
    from vad.kinematics.motion import MotionInSpace
    from vad.strokes.space.scene_in_space import SceneInSpace

#: Points of the curve of speeds.
SPEEDS = 72
#: By the bodies that turn against each other, in which row; by order, which stand in the table.
_ROWS = {"12": "driving", "24": "cross", "14": "driven", "23": "cross", "43": "cross"}
_MEASURED = {1: {"12", "14", "23"}, 2: {"12", "14", "24"}}


def joint_rates(motion: MotionInSpace[Any, Any]) -> BodyRates:
    """Return how the shafts turn, and the cross about its arms."""
    p, q = pins(motion)
    t = pierced(p, q)
    axes = Z, p, q, _closure(motion).d, unit(t)
    parts = motion.link("driving"), motion.joint("P"), motion.joint("Q"), motion.link("driven")
    return BodyRates(axes, 1.0, parts, -90.0)


def tracks(rates: BodyRates, order: int) -> Mapping[Spot, Any]:
    """Return where the vertices of a polygon are: of accelerations, those of its whole vectors."""
    found = rates.vertices(order)
    whole = ("1", "2", "3", "4") if order == 1 else ("1" + PRIME, "2" + PRIME, "4" + PRIME)
    return {Spot(letter): found[letter] for letter in whole}


def polygon(scene: SceneInSpace, rates: BodyRates, order: int) -> Drawing:
    """Return the polygon of ω (1) or α (2) of a pose."""
    shafts = {f"1{shaft}": scene.say("hooke shaft", shaft=str(shaft)) for shaft in (2, 4)}
    axes: dict[str, SentencePart] = {**shafts, "24": "OT", "23": "OP", "43": "OQ"}
    words = JointWords(scene, order, rates)
    drawing = polygon_of_bodies(
        Bodies(rates, words, axes, _ROWS, _MEASURED[order], twice=False, centre=PLAN)
    )
    moves = len(drawing.strokes) > 1
    return replace(drawing, inset=speeds(scene)) if order == 1 and moves else drawing


class JointWords(BodyWords):
    """What is said of the polygons of Hooke's joint."""

    topic = "hooke"
    sines = False


def speeds(scene: SceneInSpace) -> PolarInset:
    """Return the speeds over a turn: ω₄ about a circle of ω₂."""
    motion, closure = scene.motion, _closure(scene.motion)
    cosine, omega = closure.cosine, abs(motion.link("driving").omega)
    alike = math.atan(math.sqrt(cosine))
    alike_at = [alike, math.pi - alike, math.pi + alike, -alike] if closure.sine else []
    low, high = (Figure(float(f"{ratio:.4g}"), given=True) for ratio in (cosine, 1.0 / cosine))
    return PolarInset(
        "driving",
        "driven",
        omega,
        _over_a_turn(closure, omega),
        _speed(closure, omega, motion.link("driving").angle),
        tuple(cmath.rect(omega, theta) for theta in alike_at),
        scene.write("hooke speeds"),
        scene.write("hooke speed range", low=low, high=high),
        "14.absolute",
    )


@lru_cache(maxsize=16)
def _over_a_turn(closure: Universal, omega: float) -> tuple[complex, ...]:
    """Return the curve of speeds, the same in all poses."""
    return tuple(_speed(closure, omega, 360.0 * k / SPEEDS) for k in range(SPEEDS + 1))


def _speed(closure: Universal, omega: float, degrees: float) -> complex:
    """Return ω₄ at an angle of the driving shaft, laid off along it."""
    driven = closure.velocity(closure.pose(fold(degrees)), omega).at_d
    return cmath.rect(driven, math.radians(degrees))


def _closure(motion: MotionInSpace[Any, Any]) -> Universal:
    """Return what solves the joint."""
    assert isinstance(motion.solver, UniversalSolver)
    return motion.solver.closure
