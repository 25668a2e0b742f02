"""The acceleration polygon."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from vad.kinematics.linkage import angle_of, length_of
from vad.strokes.diagram import Diagram, Drawing
from vad.strokes.polygon import polygon
from vad.strokes.scene import Scene, image_letter
from vad.strokes.sheet import Cell


def unit(scene: Scene) -> str:
    """Return the unit of accelerations."""
    return scene.rate_unit(2)


def pose(scene: Scene) -> Drawing:
    """Return the acceleration polygon of a pose."""
    return polygon(scene, order=2)


def link(scene: Scene, name: str) -> tuple[Cell, ...]:
    """Return the angular acceleration of a link."""
    return (
        Cell(
            scene.members.symbol("α", name),
            scene.motion.link(name).alpha,
            "rad/s²",
            angle_of(name) == scene.driver,
        ),
    )


def slide(scene: Scene, name: str) -> tuple[Cell, ...]:
    """Return the acceleration of a slide along its line, and of its Coriolis part."""
    motion = scene.motion.slide(name)
    cell = Cell("a", motion.acceleration, unit(scene), length_of(name) == scene.driver)
    if motion.coriolis is None:
        return (cell,)
    return cell, Cell("2ωv", motion.coriolis, unit(scene))


def tracks(scene: Scene) -> Mapping[str, Any]:
    """Return where the images of the points are in the polygon."""
    motion = scene.motion
    return {image_letter(letter, 2): motion.point(letter).acceleration for letter in motion.points}


DIAGRAM = Diagram("acceleration", "Acceleration", 2, "vectors", unit, pose, link, slide, tracks)
