"""The velocity polygon."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vad.kinematics.linkage import angle_of, length_of
from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.polygon import polygon
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sheet import Cell


def unit(scene: Scene) -> str:
    """Return the unit of velocities."""
    return scene.rate_unit(1)


def pose(scene: Scene) -> Drawing:
    """Return the velocity polygon of a pose."""
    return polygon(scene, order=1)


def link(scene: Scene, name: str) -> tuple[Cell, ...]:
    """Return the angular velocity of a link."""
    return (
        Cell(
            scene.members.symbol("ω", name),
            scene.motion.link(name).omega,
            "rad/s",
            angle_of(name) == scene.driver,
        ),
    )


def slide(scene: Scene, name: str) -> tuple[Cell, ...]:
    """Return the velocity of a slide along its line."""
    velocity, given = scene.motion.slide(name).velocity, length_of(name) == scene.driver
    return (Cell("v", velocity, unit(scene), given),)


def tracks(scene: Scene) -> Mapping[str, Any]:
    """Return where the images of the points are in the polygon."""
    motion = scene.motion
    return {image_letter(letter, 1): motion.point(letter).velocity for letter in motion.points}


DIAGRAM = Diagram("velocity", "Velocity", 1, "vectors", unit, pose, link, slide, tracks)
