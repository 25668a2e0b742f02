"""Kinds of diagrams: what is drawn, where it stands, what it measures; and orders of derivatives.

In comes the scene of a pose, out goes a `Panel`; a kind is one file of `vad.strokes.diagrams`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

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
from vad.written import per_second

if TYPE_CHECKING:
    from vad.kinematics.motion import Motion
    from vad.strokes.draw import AnyScene


@dataclass(frozen=True, slots=True)
class Order:
    """An order of derivative.

    Attributes
    ----------
    number
        0, 1 or 2: so many times a position is differentiated.
    panel
        The name of its diagram; points and slides call their quantity so, too.
    rate
        What a link calls its quantity: "angle", "omega" or "alpha".
    symbol, sliding
        The letters of what turns and of what slides.
    unit
        The unit of what turns.
    """

    number: int
    panel: str
    rate: str
    symbol: str
    sliding: str
    unit: str

    def unit_of(self, length: str) -> str:
        """Return the unit of what slides.

        Examples
        --------
        >>> [order.unit_of("mm") for order in ORDERS]
        ['mm', 'mm/s', 'mm/s²']
        """
        return per_second(length, self.number)


POSITION = Order(0, "position", "angle", "θ", "s", "°")
VELOCITY = Order(1, "velocity", "omega", "ω", "v", "rad/s")
ACCELERATION = Order(2, "acceleration", "alpha", "α", "a", "rad/s²")
#: All orders, by their numbers.
ORDERS = POSITION, VELOCITY, ACCELERATION


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


class Spot(NamedTuple):
    """Where a lettered point of a diagram is seen.

    ``view`` is the name of the view, empty for the first; ``below`` tells the polygon below.
    """

    letter: str
    view: str = ""
    below: bool = False


def in_plane(motion: Motion[Any, Any, Any]) -> bool:
    """Apply to every mechanism in the plane."""
    from vad.kinematics.motion import MotionInSpace  # which a list of diagrams need not load

    return not isinstance(motion, MotionInSpace)


def everywhere(motion: Motion[Any, Any, Any]) -> bool:
    """Apply to every mechanism."""
    return True


def no_cells(scene: AnyScene, key: str, slides: bool) -> tuple[Cell, ...]:
    """Add nothing to a row of the results table."""
    return ()


def no_tracks(scene: AnyScene) -> Mapping[Spot, Any]:
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
    cells
        From a scene, the key of a row and whether that row is of what slides, to the cells that it
        adds to the row.
    tracks
        From a scene to where its lettered points are: complex arrays where it has many poses.
    usual
        Whether it is drawn where nobody asks for it by name.
    applies
        Tells from a motion whether it can be drawn of its mechanism.
    """

    name: str
    title: str
    rank: float
    picture: Picture
    unit: Callable[[AnyScene], str]
    pose: Callable[[AnyScene], Drawing]
    cells: Callable[[AnyScene, str, bool], tuple[Cell, ...]] = no_cells
    tracks: Callable[[AnyScene], Mapping[Spot, Any]] = no_tracks
    usual: bool = True
    applies: Callable[[Motion[Any, Any, Any]], bool] = everywhere

    @classmethod
    def of_order(cls, order: Order, rank: float, picture: Picture) -> Diagram:
        """Return the diagram of positions, velocities or accelerations, which every scene has."""
        return cls(
            order.panel,
            order.panel.capitalize(),
            rank,
            picture,
            lambda scene: scene.unit_of(order),
            lambda scene: scene.drawing(order),
            lambda scene, key, slides: scene.cells(order, key, slides),
            lambda scene: scene.tracks(order),
        )

    def panel(self, scene: AnyScene) -> Panel:
        """Return the panel of a pose, its title in the language of the scene."""
        return self._panel(scene, self.name, self.pose(scene))

    def _panel(self, scene: AnyScene, name: str, drawing: Drawing) -> Panel:
        return Panel(
            name,
            drawing.unit or self.unit(scene),
            drawing.strokes,
            drawing.equations,
            drawing.inset,
            drawing.zeros,
            scene.name(self.title),
            drawing.picture or self.picture,
            drawing.triangles,
            drawing.loops,
            drawing.notes,
            drawing.remark,
            self._panel(scene, name + BELOW, drawing.below) if drawing.below else None,
            drawing.bodies,
            drawing.coincident,
        )
