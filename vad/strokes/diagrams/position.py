"""The position diagram: the mechanism itself, constructed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vad.kinematics.linkage import angle_of, length_of
from vad.strokes.construct import construct
from vad.strokes.diagram import Diagram
from vad.strokes.scene import Scene
from vad.strokes.sheet import Cell


def unit(scene: Scene) -> str:
    """Return the unit of lengths."""
    return scene.unit


def link(scene: Scene, name: str) -> tuple[Cell, ...]:
    """Return the angle of a link."""
    return (
        Cell(
            scene.members.symbol("θ", name),
            scene.motion.link(name).angle,
            "°",
            angle_of(name) == scene.driver,
        ),
    )


def slide(scene: Scene, name: str) -> tuple[Cell, ...]:
    """Return the position of a slide."""
    place, given = scene.motion.slide(name).position, length_of(name) == scene.driver
    return (Cell(scene.members.slide_symbol(name), place, unit(scene), given),)


def tracks(scene: Scene) -> Mapping[str, Any]:
    """Return where the points of the mechanism are."""
    motion = scene.motion
    return {letter: motion.point(letter).position for letter in motion.points}


DIAGRAM = Diagram("position", "Position", 0, "skeleton", unit, construct, link, slide, tracks)
