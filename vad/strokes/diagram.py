"""What a kind of diagram declares: how it is drawn, where it stands, and what it measures.

In comes the scene of a pose, out goes a `Panel`; a kind is one file of `vad.strokes.diagrams`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from vad.strokes.sheet import (
    BELOW,
    Body,
    Cell,
    Coincidence,
    Equation,
    ImageTriangle,
    Inset,
    Note,
    Panel,
    Picture,
    Stroke,
)

if TYPE_CHECKING:
    from vad.strokes.scene import Scene
    from vad.strokes.scenes import AnyScene


@dataclass(frozen=True, slots=True)
class Drawing:
    """What is drawn of one pose: see `Panel`, which adds what its diagram says of itself.

    ``picture`` and ``unit`` are those of its diagram where they are not given.
    """

    strokes: tuple[Stroke, ...]
    zeros: tuple[Stroke, ...] = ()
    equations: tuple[Equation, ...] = ()
    inset: Inset | None = None
    triangles: tuple[ImageTriangle, ...] = ()
    loops: tuple[int, ...] = ()
    notes: tuple[Note, ...] = ()
    remark: str = ""
    unit: str = ""
    below: Drawing | None = None
    picture: Picture | None = None
    bodies: tuple[Body, ...] = ()
    coincident: tuple[Coincidence, ...] = ()


def no_cells(scene: Scene, name: str) -> tuple[Cell, ...]:
    """Add nothing to a row of the results table."""
    return ()


def no_tracks(scene: Scene) -> Mapping[str, Any]:
    """Follow no point."""
    return {}


@dataclass(frozen=True, slots=True)
class Diagram:
    """A kind of diagram.

    Attributes
    ----------
    name
        What it is called in ``panels=…``, in JSON and on the command line.
    title
        Its heading in English; another language may have its own.
    rank
        Diagrams stand on the page, and are drawn, in ascending order of it.
    picture
        How its panel is painted: as a mechanism or as vectors from a pole.
    unit
        From a scene to the unit of its coordinates.
    pose
        From a scene to its strokes.
    link, slide
        From a scene and the name of a link or slide to the cells that it adds to that row.
    tracks
        From a scene to where its lettered points are: complex arrays where it has many poses.
        Those of the polygon below the first one, too, by ``z.below``.
    usual
        Whether it is drawn where nobody asks for it by name.
    """

    name: str
    title: str
    rank: float
    picture: Picture
    unit: Callable[[Scene], str]
    pose: Callable[[Scene], Drawing]
    link: Callable[[Scene, str], tuple[Cell, ...]] = no_cells
    slide: Callable[[Scene, str], tuple[Cell, ...]] = no_cells
    tracks: Callable[[Scene], Mapping[str, Any]] = no_tracks
    usual: bool = True

    def panel(self, scene: AnyScene) -> Panel:
        """Return the panel of a pose, its title in the language of the scene."""
        return self._panel(scene, self.name, scene.drawing(self))

    def _panel(self, scene: AnyScene, name: str, drawing: Drawing) -> Panel:
        return Panel(
            name,
            drawing.unit or scene.unit_of(self),
            drawing.strokes,
            drawing.equations,
            drawing.inset,
            drawing.zeros,
            scene.language.name(self.title),
            drawing.picture or self.picture,
            drawing.triangles,
            drawing.loops,
            drawing.notes,
            drawing.remark,
            self._panel(scene, name + BELOW, drawing.below) if drawing.below else None,
            drawing.bodies,
            drawing.coincident,
        )
